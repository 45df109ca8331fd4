// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/text/says_nothing.h"

#include <gtest/gtest.h>

namespace axiometry::text {
namespace {

TEST(SaysNothing, OfPlaceholdersInEveryLanguage) {
  for (const char* nothing : {"",
                              " ",
                              "-",
                              "--",
                              "–",
                              "—",
                              "−",
                              "?",
                              "...",
                              "…",
                              "/",
                              "n/a",
                              "N/A",
                              "#N/A",
                              "n. a.",
                              "na",
                              "unknown",
                              "Unknown.",
                              "(unknown)",
                              "tbd",
                              "T.B.D.",
                              "not stated",
                              "Not stated",
                              "not-stated",
                              "not_stated",
                              "not given",
                              "not applicable",
                              "unspecified",
                              "null",
                              "unbekannt",
                              "nicht angegeben",
                              "nicht anwendbar",
                              "keine Angabe",
                              "k. A.",
                              "k.A.",
                              "K. A.",
                              "entfällt",
                              "inconnu",
                              "INCONNUE",
                              "non indiqué",
                              "NON INDIQUÉ",
                              "non\u00a0indiqué",
                              "non applicable",
                              "n. c.",
                              "sans objet",
                              "<unknown>"}) {
    EXPECT_TRUE(says_nothing(nothing)) << nothing;
    EXPECT_FALSE(says_no_warm_up(nothing)) << nothing;
  }
}

TEST(SaysNothing, NotOfStatements) {
  for (const char* statement :
       {"none", "no", "0", "X", "5", "Parallel to X, 300 mm above the table", "unknown maker, type LI-1", "KA", "N",
        "日本", "Müller", "É", "Ω", "not stated by the customer", "-1", "½ travel", "ball screw", "NIL 5"})
    EXPECT_FALSE(says_nothing(statement)) << statement;
}

TEST(SaysNone, WhereTheAnswerIsThatThereIsNone) {
  for (const char* none : {"none", "None.", "nil", "keine", "kein", "ohne", "aucun", "Aucune", "néant", "not used",
                           "not made", "omitted", "nicht gemacht", "non effectué"}) {
    EXPECT_TRUE(says_none(none)) << none;
    EXPECT_TRUE(says_no(none)) << none;
    EXPECT_FALSE(says_nothing(none)) << none;
  }
  for (const char* no : {"no", "off", "nein", "aus", "non", "0", "switched off", "désactivée"}) {
    EXPECT_FALSE(says_none(no)) << no << " may be a name";
    EXPECT_TRUE(says_no(no)) << no;
  }
  for (const char* something : {"reversal", "none but reversal", "leadscrew", "on", "yes", ""})
    EXPECT_FALSE(says_no(something)) << something;
}

TEST(SaysNoWarmUp, HoweverItIsSaid) {
  for (const char* none : {"none",
                           "no",
                           "not made",
                           "not done",
                           "omitted",
                           "no warm-up",
                           "No warm-up was made",
                           "not warmed up",
                           "without warming up",
                           "nein",
                           "ohne",
                           "kein",
                           "kein Warmlauf",
                           "nicht aufgewärmt",
                           "kalt",
                           "aucun",
                           "aucune",
                           "non",
                           "sans préchauffage",
                           "pas de mise en température",
                           "à froid",
                           "0",
                           "0 min",
                           "0.0 h",
                           "cold",
                           "cold start, no warm-up",
                           "Kaltstart (kein Warmlauf)",
                           "0,0 h"})
    EXPECT_TRUE(says_no_warm_up(none)) << none;
  for (const char* made :
       {"five cycles at 1000 mm/min", "30 min", "0.5 h", "no load, 30 min at 1000 mm/min", "warm from production",
        "Three runs over the whole travel", "nach Produktion, 2 h warm", "0:30 h", "10 runs", "normal warm-up",
        "non-stop warm-up", "0,5 h", "cold, then 30 min at 1000 mm/min", "ohne Last warmgefahren",
        "not less than 30 min warm-up"})
    EXPECT_FALSE(says_no_warm_up(made)) << made;
}

}  // namespace
}  // namespace axiometry::text
