// SPDX-License-Identifier: Apache-2.0
//
// What the names of columns and rows say, and what they only seem to say.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "axiometry/formats/format.h"
#include "axiometry/formats/table/generic_delimited.h"

namespace axiometry::formats {
namespace {

using enum Direction;

/// Three targets, two runs to and fro; the deviation of row k is (k + 1) / 10 µm.
struct HeadedRow {
  double target;
  Direction direction;
  std::size_t run;
  double deviation;
};

std::vector<HeadedRow> headed_rows() {
  std::vector<HeadedRow> rows;
  for (std::size_t j = 0; j < 2; ++j)
    for (const Direction d : {up, down})
      for (std::size_t k = 0; k < 3; ++k)
        rows.push_back(
            {100.0 * static_cast<double>(d == up ? k : 2 - k), d, j, static_cast<double>(rows.size() + 1) / 10.0});
  return rows;
}

template <typename Format>
std::string headed(const std::string& header, Format line) {
  std::string text = header;
  for (const HeadedRow& row : headed_rows()) text += line(row);
  return text;
}

void expect_headed(const std::string& bytes) {
  const auto test = read_guessed(bytes);
  ASSERT_TRUE(test) << test.error().to_string() << "\n" << bytes;
  ASSERT_EQ(test->series.run_count(), 2u) << bytes;
  for (const HeadedRow& row : headed_rows())
    ASSERT_NEAR(test->series.reading(static_cast<std::size_t>(row.target / 100.0), row.direction, row.run)->in_native(),
                row.deviation, 1e-6)
        << bytes;
}

std::string answer_under(const std::string& bytes) {
  const auto test = read_guessed(bytes);
  return test ? "read" : test.error().to_string();
}

TEST(GenericHeadings, TheSignOfADifferenceIsThatOfItsName) {
  for (const std::string name :
       {"target minus actual [um]", "deviation (target - actual) [um]", "Soll-Ist [um]", "Error = set - actual [um]"})
    expect_headed(headed("Target [mm];" + name + "\n",
                         [](const HeadedRow& r) { return fmt::format("{};{}\n", r.target, -r.deviation); }));
  for (const std::string name : {"actual minus target [um]", "Ist-Soll [um]", "deviation (actual - target) [um]"})
    expect_headed(headed("Target [mm];" + name + "\n",
                         [](const HeadedRow& r) { return fmt::format("{};{}\n", r.target, r.deviation); }));
}

TEST(GenericHeadings, ASignThatTheNameLeavesOpenIsAsked) {
  for (const std::string name : {"Korrektur [µm]", "Compensation [um]", "-Error [um]", "Soll-Ist-Abweichung [µm]"}) {
    const std::string bytes = headed("Soll [mm];Richtung;" + name + "\n", [](const HeadedRow& r) {
      return fmt::format("{};{};{}\n", r.target, r.direction == up ? "hin" : "zurück", r.deviation);
    });
    EXPECT_TRUE(answer_under(bytes).contains("\"sign\" of an import profile")) << answer_under(bytes);
  }
  for (const char* added : {"Added", "Addiert", "Ajouté"}) {  // as in a report of a table of compensation
    const std::string answer =
        answer_under(fmt::format("Position / mm,{0} ↑ / µm,{0} ↓ / µm\n0,1,2\n100,2,1\n200,2,3\n", added));
    EXPECT_TRUE(answer.contains("\"sign\" of an import profile")) << answer;
  }
}

TEST(GenericHeadings, AWordOfANameIsNoDirectionWhereTheTargetsGoBothWays) {
  const auto row = [](const HeadedRow& r) { return fmt::format("{};{}\n", r.target, r.deviation); };
  expect_headed(headed("Soll [mm];Abweichung vor Kompensation [µm]\n", row));
  expect_headed(headed("Soll [mm];Écart avant correction [µm]\n", row));
  for (const std::string name : {"Back-to-back error [um]", "Dist. error X- [um]", "Écart X+ [µm]"}) {
    const std::string answer = answer_under(headed("Soll [mm];" + name + "\n", row));
    EXPECT_TRUE(answer.contains("named for one direction and targets that rise and fall")) << answer;
  }
}

TEST(GenericHeadings, LimitsAndMeansBesideRunsAreNoRuns) {
  const auto table = [](const std::string& more) {
    return "Consigne [mm];Passage 1 aller [µm];Passage 1 retour [µm];Passage 2 aller [µm];Passage 2 retour [µm];" +
           more +
           "\n0;0.1;0.6;0.7;1.2;20\n100;0.2;0.5;0.8;1.1;20\n200;0.3;0.4;0.9;1.0;20\n300;0.1;0.2;0.3;0.4;20\n"
           "400;0.5;0.6;0.7;0.8;20\n";
  };
  const std::string unnumbered = answer_under(table("X aller [µm]"));
  EXPECT_TRUE(unnumbered.contains("beside numbered runs")) << unnumbered;
  EXPECT_EQ(answer_under(table("Limite sup. aller [µm]")), "read");
  const std::string across =
      "Soll [mm];0;100;200\nLauf 1 auf [µm];0.1;0.2;0.3\nLauf 1 ab [µm];0.6;0.5;0.4\n"
      "Lauf 2 auf [µm];0.7;0.8;0.9\nLauf 2 ab [µm];1.2;1.1;1.0\n";
  expect_headed(across);
  for (const std::string label : {"Mittelwert auf", "Obere Toleranz auf", "X auf"}) {
    const std::string answer = answer_under(across + label + " [µm];0.4;0.5;0.6\n");
    EXPECT_TRUE(answer.contains("among rows of runs")) << answer;
  }
}

TEST(GenericHeadings, WordsThatMayPartTheRowsAreAskedFor) {
  const auto with = [](const std::string& name, const std::string& first, const std::string& other) {
    return headed(name + ";Soll [mm];Abweichung [µm]\n", [&](const HeadedRow& r) {
      return fmt::format("{};{};{}\n", r.run == 0 ? first : other, r.target, r.deviation);
    });
  };
  for (const auto& bytes : {with("Axe", "X", "Y"), with("Exclu", "", "x"), with("État", "ok", "FAISCEAU PERDU")})
    EXPECT_TRUE(answer_under(bytes).contains("do they part axes, or tell readings left out")) << answer_under(bytes);
  expect_headed(with("Axe", "X", "X"));
}

TEST(GenericHeadings, NumbersThatMayTellReadingsLeftOutAreAskedFor) {
  const auto with = [](const std::string& name, const std::string& usual, const std::string& once) {
    std::size_t row = 0;
    return headed("Lauf;Soll [mm];Abweichung [µm];" + name + "\n", [&](const HeadedRow& r) {
      return fmt::format("{};{};{};{}\n", r.run + 1, r.target, r.deviation, ++row == 4 ? once : usual);
    });
  };
  for (const auto& bytes :
       {with("Status", "OK", "Fehler"), with("Valide", "1", "0"), with("Signal %", "96", "0"), with("Gut", "1", "")}) {
    const std::string answer = answer_under(bytes);
    EXPECT_TRUE(answer.contains("do they part axes, or tell readings left out")) << answer << "\n" << bytes;
  }
  expect_headed(with("Valide", "1", "1"));
}

/// Two axes of one file, one run each, are not two runs of one axis.
TEST(GenericHeadings, NumbersOfAxesAreAskedForAndAreNoRuns) {
  const auto with = [](const std::string& head, const std::string& first, const std::string& other) {
    return headed(head + ";Soll [mm];Abweichung [µm]\n", [&](const HeadedRow& r) {
      return fmt::format("{};{};{}\n", r.run == 0 ? first : other, r.target, r.deviation);
    });
  };
  for (const std::string head : {"Achse", "Axe", "Axis no", "Asse"})
    for (const auto& [first, other] : {std::pair("1", "2"), std::pair("3", "5"), std::pair("0", "1")}) {
      const std::string answer = answer_under(with(head, first, other));
      EXPECT_TRUE(answer.contains(fmt::format("found the numbers {}, {} in column 1", first, other))) << answer;
    }
  expect_headed(with("Achse", "2", "2"));
  expect_headed(with("Lauf", "1", "2"));
  const std::string wide = answer_under(
      "Axe;Consigne [mm];Passage 1 aller [µm];Passage 1 retour [µm]\n1;0;0.1;0.6\n1;100;0.2;0.5\n1;200;0.3;0.4\n"
      "2;0;0.1;0.6\n2;100;0.2;0.5\n2;200;0.3;0.4\n");
  EXPECT_TRUE(wide.contains("found the numbers 1, 2 in column 1")) << wide;
  const auto across = [](const std::string& name, const std::string& first, const std::string& other) {
    return name + ";Soll [mm];0;100;200\n" + first + ";Lauf 1 auf [µm];0.1;0.2;0.3\n" + first +
           ";Lauf 1 ab [µm];0.6;0.5;0.4\n" + other + ";Lauf 2 auf [µm];0.7;0.8;0.9\n" + other +
           ";Lauf 2 ab [µm];1.2;1.1;1.0\n";
  };
  const std::string numbers = answer_under(across("Achse", "1", "2")), words = answer_under(across("Achse", "X", "Y"));
  EXPECT_TRUE(numbers.contains("found the numbers 1, 2")) << numbers;
  EXPECT_TRUE(words.contains("found the words \"X\", \"Y\"")) << words;
}

/// Where nothing else is a target, numbers below "Axis" are its positions.
TEST(GenericHeadings, TargetsBelowAnAxisAreTargets) {
  const std::string answer = answer_under(headed("Axe;Abweichung [µm]\n", [](const HeadedRow& r) {
    return fmt::format("{};{}\n", r.target / 10.0, r.deviation);
  }));
  EXPECT_TRUE(answer.contains("in which unit are the targets (column 1 \"Axe\")")) << answer;
}

}  // namespace
}  // namespace axiometry::formats
