// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/french.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "axiometry/language/language.h"
#include "axiometry/language/phrase_file.h"
#include "axiometry/language/words.h"

namespace axiometry::language {
namespace {

std::string french(std::string_view text) { return translated(text, Language::french, {.decimal_mark = ','}); }

std::string appended(std::string text, std::string_view content) {
  append_in_french(text, content);
  return text;
}

/// A pair without its places, which may be the same in both languages: words that are, and names.
constexpr auto same_words = std::to_array<std::string_view>({"(Monte Carlo)",
                                                             "--correct air=ciddor",
                                                             "--correct dead-path",
                                                             "--correct gain",
                                                             "--correct nde",
                                                             "--correct sign",
                                                             "Amplitude",
                                                             "Angle α",
                                                             "Angles",
                                                             "Axes",
                                                             "COMP_FILE_TYPE",
                                                             "Compensation",
                                                             "Direction",
                                                             "Distribution",
                                                             "Face",
                                                             "Figure",
                                                             "Figures",
                                                             "Format",
                                                             "Gain",
                                                             "Instrument",
                                                             "Lee et al.",
                                                             "Machine",
                                                             "Monte Carlo",
                                                             "Obstacle",
                                                             "Obstacles",
                                                             "Octant",
                                                             "PDF, A4",
                                                             "P_s,max",
                                                             "P_s,mean",
                                                             "Plan",
                                                             "Point",
                                                             "Points",
                                                             "Position",
                                                             "Position, mm",
                                                             "Positions",
                                                             "Programme",
                                                             "Rotation",
                                                             "Segment",
                                                             "Signature",
                                                             "Simulation",
                                                             "Source",
                                                             "Stable",
                                                             "Station",
                                                             "Station X / Y / Z",
                                                             "Stations",
                                                             "Table",
                                                             "Type",
                                                             "Verdict",
                                                             "Vibrations",
                                                             "air",
                                                             "align.",
                                                             "amplitude",
                                                             "appr.",
                                                             "compensation",
                                                             "contribution",
                                                             "direction",
                                                             "distances",
                                                             "ecmc_cfg_tool, CSV",
                                                             "exact (A.1)",
                                                             "instr.",
                                                             "instrument",
                                                             "machine",
                                                             "null",
                                                             "octant",
                                                             "plan",
                                                             "point",
                                                             "points, station",
                                                             "points, stations",
                                                             "position",
                                                             "stable",
                                                             "station",
                                                             "therm.",
                                                             "type",
                                                             "verdict"});

static_assert(std::ranges::is_sorted(same_words));

std::string without_places(std::string_view text) {
  std::string all;
  for (std::size_t k = 0; k < text.size(); ++k)
    if (text[k] == '{')
      k = text.find('}', k);
    else if (text[k] != ' ' || (!all.empty() && !all.ends_with(' ')))
      all += text[k];
  while (all.ends_with(' ') || all.ends_with(',')) all.pop_back();
  while (all.starts_with(' ') || all.starts_with(',')) all.erase(0, 1);
  return all;
}

TEST(French, GivesWhatHasANumberItsArticleBehindAPreposition) {
  EXPECT_EQ(appended("avant ", "ligne 137 de la station"), "avant la ligne 137 de la station");
  EXPECT_EQ(appended("pas de longueur pour ", "point 3"), "pas de longueur pour le point 3");
  EXPECT_EQ(appended("les lectures de ", "partie 2"), "les lectures de la partie 2");
  EXPECT_EQ(appended("loin de ", "point 3"), "loin du point 3");
  EXPECT_EQ(appended("arrêts qui correspondent à ", "point 3"), "arrêts qui correspondent au point 3");
  EXPECT_EQ(appended("aucun arrêt pour ", "cible 4, parcours 1"), "aucun arrêt pour la cible 4, parcours 1");
  EXPECT_EQ(appended("le ", "point 3"), "le point 3");
  EXPECT_EQ(appended("", "ligne 137"), "ligne 137");
  EXPECT_EQ(appended("pour ", "ligne droite"), "pour ligne droite") << "not named by a number";
}

TEST(French, IsNotLeftEnglish) {
  for (const PhrasePair& pair : pairs_of("fr")) {
    if (pair.of_page_alone) continue;
    const std::string english = without_places(pair.english);
    const bool may_be_same = has_no_words(english) || std::ranges::binary_search(same_words, english);
    const auto stem = english.substr(0, english.find(" / "));
    if (without_places(with_french_spaces(pair.other)) == english)
      EXPECT_TRUE(may_be_same || std::ranges::binary_search(same_words, stem)) << pair.english;
  }
}

TEST(French, SetsNoBreakSpacesBeforeHighMarksAndWithinGuillemets) {
  EXPECT_EQ(with_french_spaces("a : b ; c ?"), "a\u00a0: b\u00a0; c\u00a0?");
  EXPECT_EQ(with_french_spaces("95 % de « x »"), "95\u00a0% de «\u00a0x\u00a0»");
  EXPECT_EQ(with_french_spaces("A := 1, :START"), "A := 1, :START");
  EXPECT_EQ(with_french_spaces(""), "");
}

TEST(French, ElidesAndContractsAtPlaces) {
  EXPECT_EQ(appended("le coefficient de ", "écart"), "le coefficient d’écart");
  EXPECT_EQ(appended("de ", "le parcours"), "du parcours");
  EXPECT_EQ(appended("erreur de ", "les cibles"), "erreur des cibles");
  EXPECT_EQ(appended("conforme à ", "le plan"), "conforme au plan");
  EXPECT_EQ(appended("de ", "l’axe X"), "de l’axe X");
  EXPECT_EQ(appended("répétabilité de ", "axe X"), "répétabilité de l’axe X");
  EXPECT_EQ(appended("répétabilité de ", "diagonale XY"), "répétabilité de la diagonale XY");
  EXPECT_EQ(appended("De ", "axe"), "D’axe");
  EXPECT_EQ(appended("le ", "harmonique"), "l’harmonique");
  EXPECT_EQ(appended("conformément à ", "ISO 230-2:2014"), "conformément à l’ISO 230-2:2014");
  EXPECT_EQ(appended("selon ", "ISO 230-2:2014"), "selon ISO 230-2:2014");
}

TEST(French, LeavesSymbolsNamesAndOtherWordsAsTheyAre) {
  EXPECT_EQ(appended("incertitude de ", "A"), "incertitude de A");
  EXPECT_EQ(appended("incertitude de ", "u_c"), "incertitude de u_c");
  EXPECT_EQ(appended("incertitude de ", "Essai"), "incertitude de Essai");
  EXPECT_EQ(appended("de ", "hauteur"), "de hauteur");
  EXPECT_EQ(appended("code ", "actif"), "code actif");
  EXPECT_EQ(appended("", "écart"), "écart");
  EXPECT_EQ(appended("de ", ""), "de ");
}

TEST(French, SaysListsSentencesAndNumbersAsFrenchDoes) {
  EXPECT_EQ(french("Reversal error"), "Erreur d’inversion");
  EXPECT_EQ(french("8.0 to 12.3"), "8,0 à 12,3");
  EXPECT_EQ(french("machine name and machine type"), "désignation de la machine et type de machine");
  EXPECT_EQ(
      french("not given, but expected in the report – machine: machine name, machine type; axis: type of scale"),
      "non indiqué, mais attendu dans le rapport – machine\u00a0: désignation de la machine, type de machine\u00a0; "
      "axe\u00a0: type de règle de mesure");
  EXPECT_EQ(french("found the unknown unit 'x', expected one of um, mm"),
            "unité inconnue 'x'\u00a0; attendu\u00a0: l’une de um, mm");
  EXPECT_EQ(french("a text that nobody wrote"), "a text that nobody wrote");
}

}  // namespace
}  // namespace axiometry::language
