// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/drawing/upper_case.h"

#include <gtest/gtest.h>

#include <string>

namespace axiometry::report {
namespace {

TEST(UpperCase, RaisesTheLettersOfEveryLanguageOfTheProgram) {
  EXPECT_EQ(upper_case("Test plan"), "TEST PLAN");
  EXPECT_EQ(upper_case("Perpendicularité de l’axe à gauche, façade, où, naïf, cœur"),
            "PERPENDICULARITÉ DE L’AXE À GAUCHE, FAÇADE, OÙ, NAÏF, CŒUR");
  EXPECT_EQ(upper_case("Prüfplan, Längen, Größe"), "PRÜFPLAN, LÄNGEN, GRÖSSE");
  EXPECT_EQ(upper_case("àâäæçèéêëìíîïðñòóôõöøùúûüýþÿ"), "ÀÂÄÆÇÈÉÊËÌÍÎÏÐÑÒÓÔÕÖØÙÚÛÜÝÞŸ");
}

TEST(UpperCase, LeavesWhatIsNoLetterOrHasNoCapitalHere) {
  EXPECT_EQ(upper_case("5 µm ÷ 2 × θ₁ · ″"), "5 µM ÷ 2 × θ₁ · ″");
  EXPECT_EQ(upper_case("PRÜFUNG É"), "PRÜFUNG É");
  EXPECT_EQ(upper_case(""), "");
  const std::string torn = "a\xC3";  // cut within a letter
  EXPECT_EQ(upper_case(torn), "A\xC3");
  EXPECT_EQ(upper_case("\xE9t\xE9"), "\xE9T\xE9");  // Latin-1, no UTF-8
}

}  // namespace
}  // namespace axiometry::report
