// SPDX-License-Identifier: Apache-2.0
#include "axiometry/language/language.h"

#include <gtest/gtest.h>

#include "axiometry/language/words.h"
#include "tests/support/cpu_time.h"

namespace axiometry::language {
namespace {

constexpr NumberStyle comma{.decimal_mark = ','};

std::string german(std::string_view text) { return translated(text, Language::german, comma); }

TEST(LanguageOf, KnowsTagsWithAndWithoutARegion) {
  EXPECT_EQ(language_of("de"), Language::german);
  EXPECT_EQ(language_of("de-AT"), Language::german);
  EXPECT_EQ(language_of("DE"), Language::german);
  EXPECT_EQ(language_of("en-GB"), Language::english);
  for (const char* other : {"", "es", "deu", "d", "-de", "fra"}) EXPECT_FALSE(language_of(other)) << other;
}

TEST(LanguageOf, KnowsEveryLanguageOnce) {
  EXPECT_EQ(language_of("fr"), Language::french);
  EXPECT_EQ(language_of("fr-CH"), Language::french);
  EXPECT_EQ(tags_of_languages(), "en, de, fr");
  EXPECT_EQ(own_name(Language::french), "Français");
  EXPECT_EQ(usual_numbers(Language::french).decimal_mark, ',');
  EXPECT_EQ(usual_numbers(Language::english).decimal_mark, '.');
}

/// Whatever a database has: what is wrong with it is said with its kind in the language.
TEST(Translated, NamesEveryKindOfPartOfADatabase) {
  const auto expect_german = [](const std::string& text) {
    const std::string said = german(text);
    EXPECT_NE(said.substr(0, said.find(' ')), text.substr(0, text.find(' '))) << said;
    EXPECT_EQ(said.find("found"), std::string::npos) << said;
    EXPECT_EQ(said.find("schema"), std::string::npos) << said;
  };
  for (const std::string part :
       {"column at of audit", "constraint audit_pkey of audit", "inheritance a of audit", "policy p of audit",
        "trigger audit_unchanged of audit", "reference a_fkey (RI_FKey_check of audit)", "function unchanged(text)",
        "domain hash", "rule r of audit"})
    for (const char* found :
         {": found none, expected the one of schema 4", ": found it altered, 'a', expected 'b' of schema 4",
          ": found one that schema 4 does not have, expected none"})
      expect_german(part + found);
  for (const char* part : {"trigger audit_unchanged of audit", "reference a_fkey (RI_FKey_check of audit)"})
    expect_german(part + std::string(": found it switched off, expected it on"));
  for (const char* part : {"table own", "view own of own"})
    expect_german(part + std::string(": somebody's own, no part of schema 4"));
}

TEST(LanguageOf, ReadsWhatTagWrites) {
  for (const Language language : languages()) EXPECT_EQ(language_of(tag(language)), language);
}

TEST(BestOf, TakesTheLanguageWithTheLargestWeight) {
  EXPECT_EQ(best_of("de"), Language::german);
  EXPECT_EQ(best_of("de-DE,de;q=0.9,en-US;q=0.8,en;q=0.7"), Language::german);
  EXPECT_EQ(best_of("en-GB, de;q=0.9"), Language::english);
  EXPECT_EQ(best_of("es, de;q=0.3, en;q=0.2"), Language::german);
  EXPECT_EQ(best_of("fr-FR,fr;q=0.9,en;q=0.8"), Language::french);
  EXPECT_EQ(best_of("en;q=0.5, fr;q=0.6, de;q=0.4"), Language::french);
  EXPECT_EQ(best_of("en;q=0, de;q=0.1"), Language::german);
}

TEST(BestOf, IsEnglishWhereNothingElseIsKnown) {
  for (const char* header : {"", "es", "*", "de;q=0", "fr;q=0", ",,;;", "de;q=x", "de;q=-1", "es;q=1,*;q=0.5"})
    EXPECT_EQ(best_of(header), Language::english) << header;
}

TEST(Translated, FindsWhatIsSaidOfAnErrorOfTheMachineOrOfSeveral) {
  const std::string said = "the runs agree to the last digit: they tell nothing of how far they are from the truth";
  const std::string in_german = german(said);
  ASSERT_NE(in_german, said);
  for (const std::string names : {"EYX", "EAX, ECZ", "C0Y, EXZ, EZZ, B0Z"}) {
    EXPECT_EQ(german(names + ": " + said), names + ": " + in_german);
    EXPECT_TRUE(
        is_known(said + " (" + names + ", of the errors measured singly, from which this was made)", Language::french));
  }
  EXPECT_FALSE(is_known("EYQ: " + said, Language::german));
  EXPECT_FALSE(is_known("EYXX: " + said, Language::german));
}

TEST(Translated, LeavesEnglishAsItIs) {
  EXPECT_EQ(translated("found 1.5 of 2 targets", Language::english, comma), "found 1.5 of 2 targets");
}

TEST(Translated, FindsWholeTextsAndSentences) {
  EXPECT_EQ(german("Reversal error"), "Umkehrspanne");
  EXPECT_EQ(german("found no warm-up run, expected the warm-up that was specified or agreed before the test"),
            "kein Warmlauf; erwartet: der vor der Prüfung festgelegte oder vereinbarte");
  EXPECT_EQ(german("Found no warm-up run, expected the warm-up that was specified or agreed before the test."),
            "Kein Warmlauf; erwartet: der vor der Prüfung festgelegte oder vereinbarte.");
}

TEST(Translated, KeepsTheCaseOfASymbolThatBeginsASentence) {
  EXPECT_EQ(german("C0Y has no number: its lines hold rotation ECX at 900 mm, not measured."),
            "C0Y hat keinen Wert: Seine Linien enthalten Drehung ECX bei 900 mm, nicht gemessen.");
  EXPECT_EQ(german("X: only from 200 to 800 mm, where all its errors were read."),
            "X: nur von 200 bis 800 mm, wo alle Abweichungen abgelesen sind.");
  EXPECT_EQ(german("x: only from 200 to 800 mm, where all its errors were read."),
            "x: nur von 200 bis 800 mm, wo alle Abweichungen abgelesen sind.");
  for (const char* symbol : {"A", "E", "R", "EXX", "A_up", "X1"})
    EXPECT_EQ(german(std::string(symbol) + " is not stated."), std::string(symbol) + " ist nicht angegeben.") << symbol;
  EXPECT_EQ(german("M3.csv is not stated"), "M3.csv ist nicht angegeben");
}

TEST(Translated, BeginsASentenceWithACapitalWhereAnArticleStoodThere) {
  EXPECT_EQ(german("A place that is not finite."), "Ein Ort, der nicht endlich ist.");
  EXPECT_EQ(german("Found no warm-up run, expected the warm-up that was specified or agreed before the test."),
            "Kein Warmlauf; erwartet: der vor der Prüfung festgelegte oder vereinbarte.");
}

TEST(Translated, MovesWhatStandsAtThePlacesAndSetsItsDecimalMark) {
  EXPECT_EQ(german("found 1200.5 mm measured of an axis travel of 2000 mm; the results hold for that part only"),
            "1200,5 mm eines Verfahrwegs von 2000 mm gemessen; die Ergebnisse gelten nur für diesen Teil");
  EXPECT_EQ(german("8.0 to 12.3"), "8,0 bis 12,3");
}

TEST(Translated, KeepsClausesAndTextsWithoutWords) {
  for (const char* same : {"5.3.2", "3.16", "9.6", "A.2.6", "ISO 230-2:2014", "µm/(m·°C)", "x̄_i↑", "", "–"})
    EXPECT_EQ(german(same), same);
  EXPECT_EQ(german("with one approach from each direction s, R and A (3.18 to 3.22, 3.26, 3.27) are not applicable"),
            "bei einer Anfahrt aus jeder Richtung sind s, R und A (3.18 bis 3.22, 3.26, 3.27) nicht anwendbar");
}

TEST(Translated, LooksUpListsByTheirItems) {
  EXPECT_EQ(german("not given, but expected in the report – machine: machine name, machine type; axis: type of scale"),
            "nicht angegeben, im Bericht aber erwartet – Maschine: Bezeichnung der Maschine, Art der Maschine; Achse: "
            "Art des Maßstabs");
}

TEST(Translated, SetsNoBreakSpacesWhereTheyWere) {
  EXPECT_EQ(german("8.0\u00a0µm to 12.3\u00a0µm"), "8,0\u00a0µm bis 12,3\u00a0µm");
  EXPECT_EQ(german("Reversal\u00a0error"), "Umkehrspanne");
}

TEST(Translated, KeepsWordsOfTheUserAtVerbatimPlaces) {
  EXPECT_EQ(german("Axis Reversal error"), "Achse Reversal error");
  EXPECT_EQ(german("Report 3.5 Test report"), "Bericht 3.5 Test report");
}

TEST(Translated, KeepsEveryByteOfWhatItDoesNotRead) {
  for (const std::string bytes : {"\x1f", "\xFF", "\xFF\x80\x80", "_\x1f\x1f\xFF_", "\uE000\u00a0\x1f"}) {
    EXPECT_EQ(german("Axis " + bytes), "Achse " + bytes);
    EXPECT_EQ(german(bytes), bytes);
  }
}

TEST(Translated, PutsArgumentsWhereTheOtherLanguageHasThem) {
  const TextArgument first{0}, second{1};
  EXPECT_EQ(translated({"Uncertainty of ", first}, Language::german, comma), (TextPieces{"Unsicherheit von ", first}));
  EXPECT_EQ(translated({second, " to ", first}, Language::german, comma), (TextPieces{second, " bis ", first}));
  EXPECT_EQ(translated({"Axis ", second}, Language::german, comma), (TextPieces{"Achse ", second}));
  EXPECT_EQ(translated({"Axis ", second}, Language::english, comma), (TextPieces{"Axis ", second}));
  EXPECT_TRUE(is_known(TextPieces{"Uncertainty of ", first}, Language::german));
  EXPECT_FALSE(is_known(TextPieces{"a text that nobody wrote of ", first}, Language::german));
}

TEST(Translated, LeavesEnglishWhatNoEntryFits) {
  EXPECT_EQ(german("a text that nobody wrote"), "a text that nobody wrote");
  EXPECT_FALSE(is_known("a text that nobody wrote", Language::german));
  EXPECT_TRUE(is_known("Reversal error", Language::german));
  EXPECT_TRUE(is_known("12.5 µm", Language::german));
}

TEST(Translated, EndsSoonWhateverTheText) {
  std::string hostile = "found ";
  for (int k = 0; k < 20000; ++k) hostile += "run, target 1 (2) and 3 of 4 to 5; ";
  const double begun = testing_support::cpu_seconds();
  EXPECT_EQ(german(hostile).size() > 10, true);
  EXPECT_EQ(german(std::string(300000, ',')).size(), 300000u);
  EXPECT_EQ(german(std::string(100000, '(') + "x and y").empty(), false);
  EXPECT_LT(testing_support::cpu_seconds() - begun, 5.0);
}

TEST(Words, ChangeTheFirstLetterOfWordsAlone) {
  EXPECT_EQ(capitalised("écart"), "Écart");
  EXPECT_EQ(capitalised("l’essai"), "L’essai");
  EXPECT_EQ(capitalised("à la fin"), "À la fin");
  EXPECT_EQ(without_capital("L’axe"), "l’axe");
  EXPECT_EQ(without_capital("À la fin"), "à la fin");
  EXPECT_EQ(capitalised("œil-de-chat"), "Œil-de-chat");
  EXPECT_EQ(capitalised("u = 3"), "u = 3");
  EXPECT_EQ(without_capital("Étalon"), "étalon");
  EXPECT_EQ(without_capital("Type"), "type");
  for (const char* same : {"NDE", "U", "U_EVE", "×2", "écart", "", "3 µm", "ß"}) EXPECT_EQ(without_capital(same), same);
}

TEST(Words, TellNumbersFromClauses) {
  EXPECT_EQ(with_decimal_mark("12.5 µm, 5.3.2, A.2, v1.5, ISO 230.", ','), "12,5 µm, 5.3.2, A.2, v1.5, ISO 230.");
  EXPECT_EQ(with_decimal_mark("(−0.577, −0.577, 1) mm", ','), "(−0,577; −0,577; 1) mm");
  EXPECT_EQ(with_decimal_mark("(100, 80, −600)", ','), "(100; 80; −600)");
  EXPECT_EQ(with_decimal_mark("(0,577, 1, 2)", ','), "(0,577; 1; 2)") << "set with the mark of a report already";
  EXPECT_EQ(with_decimal_mark("(−0.577, −0.577, 1)", '.'), "(−0.577, −0.577, 1)");
  EXPECT_EQ(with_decimal_mark("12.5 µm (5.3.2, A.2), 3 (4)", ','), "12,5 µm (5.3.2, A.2), 3 (4)");
  EXPECT_TRUE(has_no_words("U_M,DEVICE = 12 µm/(m·°C)"));
  EXPECT_TRUE(has_no_words("2s_i↑"));
  EXPECT_FALSE(has_no_words("1 run"));
}

}  // namespace
}  // namespace axiometry::language
