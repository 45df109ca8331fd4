// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/table/generic_delimited.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

using enum Direction;

/// A made-up test whose every reading is known: deviation of target i, direction d, run j in units of 0.1 µm.
constexpr int readings_per_unit = 10;
int tenths(std::size_t i, std::size_t d, std::size_t j) {
  return static_cast<int>((i * 37 + d * 11 + j * 7 + i * j * 3) % 97) - 40;
}

struct Sheet {
  std::size_t targets = 6;
  std::size_t runs = 3;
  double step = 125.5;
  char mark = '.';
  std::string delimiter = ";";

  std::string number(double x, int decimals) const {
    std::string s = fmt::format("{:.{}f}", x, decimals);
    std::ranges::replace(s, '.', mark);
    return s;
  }
  double target(std::size_t i) const { return static_cast<double>(i) * step; }
  std::string target_text(std::size_t i) const { return number(target(i), 3); }
  std::string deviation_text(std::size_t i, std::size_t d, std::size_t j) const {
    return number(tenths(i, d, j) / static_cast<double>(readings_per_unit), 1);
  }
  std::string position_text(std::size_t i, std::size_t d, std::size_t j) const {
    return number(target(i) + tenths(i, d, j) / (1000.0 * readings_per_unit), 4);
  }
  std::string row(std::initializer_list<std::string> cells) const {
    return fmt::format("{}\n", fmt::join(cells, delimiter));
  }

  /// Every approach in the order of the measurement: up, back down, up, …
  template <typename Row>
  std::string rows(Row make) const {
    std::string text;
    for (std::size_t j = 0; j < runs; ++j)
      for (std::size_t d = 0; d < 2; ++d)
        for (std::size_t k = 0; k < targets; ++k) text += make(d == 0 ? k : targets - 1 - k, d, j);
    return text;
  }
};

axiometry::Test read_whole(const std::string& bytes) {
  auto test = read_guessed(bytes);
  EXPECT_TRUE(test) << test.error().to_string() << "\n" << bytes;
  return *std::move(test);
}

void expect_sheet(const Sheet& sheet, const axiometry::Test& test, const std::string& bytes) {
  ASSERT_EQ(test.series.target_count(), sheet.targets) << bytes;
  ASSERT_EQ(test.series.run_count(), sheet.runs) << bytes;
  for (std::size_t i = 0; i < sheet.targets; ++i)
    for (std::size_t j = 0; j < sheet.runs; ++j)
      for (std::size_t d = 0; d < 2; ++d) {
        const auto x = test.series.reading(i, static_cast<Direction>(d), j);
        ASSERT_TRUE(x) << bytes;
        ASSERT_NEAR(x->in_native(), tenths(i, d, j) / 10.0, 1e-6) << i << " " << d << " " << j << "\n" << bytes;
      }
}

void expect_read(const Sheet& sheet, const std::string& bytes) {
  const auto test = read_guessed(bytes);
  ASSERT_TRUE(test) << test.error().to_string() << "\n" << bytes;
  expect_sheet(sheet, *test, bytes);
}

bool has_remark(const axiometry::Test& test, std::string_view part) {
  return std::ranges::any_of(test.provenance.remarks, [&](const SourceRemark& r) { return r.message.contains(part); });
}

std::string question_in(const std::string& bytes) {
  const auto found = guess(bytes);
  if (!found) return "error: " + found.error().to_string();
  return found->questions.empty() ? "no question"
                                  : found->questions.front().key + ": " + found->questions.front().reason;
}

struct Language {
  std::string run, direction, target, deviation, position, up, down;
};

const Language languages[] = {
    {"Cycle", "Dir", "Nominal (mm)", "Error (um)", "Actual (mm)", "Fwd", "Rev"},
    {"Lauf", "Richtung", "Soll [mm]", "Abweichung [µm]", "Ist [mm]", "vorwärts", "rückwärts"},
    {"Passage", "Sens", "Consigne (mm)", "Écart (µm)", "Position mesurée (mm)", "aller", "retour"},
    {"Ciclo", "Direzione", "Posizione nominale [mm]", "Scostamento [µm]", "Posizione misurata [mm]", "andata",
     "ritorno"},
    {"Ciclo", "Sentido", "Posición teórica (mm)", "Desviación (µm)", "Posición medida (mm)", "ida", "vuelta"},
    {"次数", "方向", "目标位置(mm)", "偏差(µm)", "实际位置(mm)", "正向", "反向"},
    {"回数", "方向", "目標位置（mm）", "誤差（µm）", "実測位置（mm）", "往路", "復路"},
};

TEST(GenericDelimited, TakesNoDirectionInTheNameOfARunForAUnit) {
  std::vector<std::pair<std::string, std::string>> words{{"auf", "ab"}, {"vor", "rück"}, {"hin", "zurück"}};
  for (const Language& l : languages) words.emplace_back(l.up, l.down);
  for (const auto& [up, down] : words)
    for (const std::string_view run : {"Lauf", "Run"}) {
      const std::string bytes = fmt::format(
          "Soll [mm];{0} 1 {1};{0} 1 {2};{0} 2 {1};{0} 2 {2}\n0;0,1;1,2;0,2;1,1\n100;0,5;1,9;0,6;1,8\n"
          "200;0,9;2,2;1,0;2,1\n",
          run, up, down);
      EXPECT_EQ(question_in(bytes).substr(0, 13), "reading_unit:") << bytes;
      const auto format = recognise(bytes);
      const auto test = format ? (*format)->read(bytes) : std::unexpected(format.error());
      ASSERT_FALSE(test) << bytes;
      EXPECT_EQ(test.error().message.find("unknown unit"), std::string::npos) << test.error().message;
      auto profile = guess(bytes)->profile;
      profile.reading_unit = find_unit("um");
      const auto read = read_with(profile, bytes);
      ASSERT_TRUE(read) << read.error().to_string() << "\n" << bytes;
      EXPECT_EQ(read->series.reading(1, Direction::up, 1)->in_native(), 0.6);
      EXPECT_EQ(read->series.reading(2, Direction::down, 0)->in_native(), 2.2);
    }
}

TEST(GenericDelimited, ReadsNamesInManyLanguagesWithAnyDelimiterAndDecimalMark) {
  for (const Language& l : languages)
    for (const std::string delimiter : {";", "\t", ","})
      for (const char mark : {'.', ','}) {
        if (delimiter == "," && mark == ',') continue;
        Sheet sheet;
        sheet.mark = mark;
        sheet.delimiter = delimiter;
        const std::string deviations = "Title of the file\n\n" +
                                       sheet.row({l.run, l.direction, l.target, l.deviation}) +
                                       sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
                                         return sheet.row({std::to_string(j + 1), d == 0 ? l.up : l.down,
                                                           sheet.target_text(i), sheet.deviation_text(i, d, j)});
                                       });
        expect_read(sheet, deviations);
        const std::string positions =
            sheet.row({l.position, l.run, l.target}) + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
              return sheet.row({sheet.position_text(i, d, j), std::to_string(j), sheet.target_text(i)});
            });
        expect_read(sheet, positions);
      }
}

TEST(GenericDelimited, ReadsColumnsBetweenBlanksUnderLabels) {
  Sheet sheet;
  sheet.delimiter = "   ";
  const std::string bytes =
      "Laser interferometer\r\nMachine: Mill 5\r\nAxis: Y\r\n\r\n  Run  Target (mm)  Error (um)\r\n" +
      sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
        return "   " + sheet.row({std::to_string(j + 1), sheet.target_text(i), sheet.deviation_text(i, d, j)});
      }) +
      "\nEnd of data\n";
  expect_read(sheet, bytes);
  const axiometry::Test test = read_whole(bytes);
  EXPECT_EQ(test.metadata.machine.name, "Mill 5");
  EXPECT_EQ(test.metadata.axis.name, "Y");
  EXPECT_TRUE(has_remark(test, "column 2 \"Target (mm)\": target"));
  EXPECT_TRUE(has_remark(test, "direction motion"));
  EXPECT_TRUE(has_remark(test, "1 line above the table told nothing"));
  EXPECT_TRUE(std::ranges::none_of(test.provenance.remarks, &SourceRemark::departs));
}

TEST(GenericDelimited, ReadsNumbersWithoutNamesWhenTheUnitsStandAbove) {
  Sheet sheet;
  sheet.delimiter = " ";
  expect_read(sheet, "# unit: um\n# target unit: mm\n" + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
    return sheet.row({std::to_string(j), d == 0 ? "1" : "-1", sheet.target_text(i), sheet.deviation_text(i, d, j)});
  }));
  expect_read(sheet, "# unit: mm\n" + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
    return sheet.row({sheet.target_text(i), sheet.position_text(i, d, j)});
  }));
}

TEST(GenericDelimited, ReadsALineOfUnitsBelowTheNames) {
  Sheet sheet;
  sheet.mark = ',';
  expect_read(sheet, "Nr;Soll;Ist;Lauf\n;[mm];[mm];\n" + sheet.rows([&, n = 0](std::size_t i, std::size_t d,
                                                                               std::size_t j) mutable {
    return sheet.row({std::to_string(++n), sheet.target_text(i), sheet.position_text(i, d, j), std::to_string(j + 1)});
  }));
}

TEST(GenericDelimited, ReadsRunsThatAreCountedOneWayEach) {
  Sheet sheet;
  const auto bytes = "Run;Target [mm];Deviation [um]\n" + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
    return sheet.row({std::to_string(2 * j + d + 1), sheet.target_text(i), sheet.deviation_text(i, d, j)});
  });
  expect_read(sheet, bytes);
  EXPECT_EQ(guess(bytes)->profile.direction, DirectionRule::run_parity);
}

TEST(GenericDelimited, ReadsRunsCountedOneWayEachBesideDirections) {
  Sheet sheet;
  expect_read(sheet, "Run;Direction;Target [mm];Deviation [um]\n" +
                         sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
                           return sheet.row({std::to_string(2 * j + d), d == 0 ? "+" : "-", sheet.target_text(i),
                                             sheet.deviation_text(i, d, j)});
                         }));
}

TEST(GenericDelimited, ReadsOneColumnPerRun) {
  Sheet sheet;
  sheet.mark = ',';
  std::string bytes =
      "Punkt;Sollposition [mm];Messung 1 hin [µm];Messung 1 zurück;Messung 2 hin;Messung 2 zurück;"
      "Messung 3 hin;Messung 3 zurück;Mittelwert\n";
  for (std::size_t i = 0; i < sheet.targets; ++i)
    bytes += sheet.row({std::to_string(i + 1), sheet.target_text(i), sheet.deviation_text(i, 0, 0),
                        sheet.deviation_text(i, 1, 0), sheet.deviation_text(i, 0, 1), sheet.deviation_text(i, 1, 1),
                        sheet.deviation_text(i, 0, 2), sheet.deviation_text(i, 1, 2), "0,5"});
  expect_read(sheet, bytes);
  EXPECT_EQ(guess(bytes)->profile.layout, TableLayout::wide);
}

TEST(GenericDelimited, ReadsTwoColumnsOfDirectionsWithTheTargetsComingBack) {
  Sheet sheet;
  std::string bytes = "Target (mm);Forward (um);Reverse (um)\n";
  for (std::size_t j = 0; j < sheet.runs; ++j)
    for (std::size_t i = 0; i < sheet.targets; ++i)
      bytes += sheet.row({sheet.target_text(i), sheet.deviation_text(i, 0, j), sheet.deviation_text(i, 1, j)});
  expect_read(sheet, bytes);
}

TEST(GenericDelimited, ReadsTargetsAcrossTheTable) {
  Sheet sheet;
  for (const bool positions : {false, true}) {
    std::string bytes = "# unit: " + std::string(positions ? "mm" : "um") + "\nSoll [mm]";
    for (std::size_t i = 0; i < sheet.targets; ++i) bytes += ";" + sheet.target_text(i);
    for (std::size_t j = 0; j < sheet.runs; ++j)
      for (std::size_t d = 0; d < 2; ++d) {
        bytes += fmt::format("\nLauf {} {}", j + 1, d == 0 ? "↑" : "↓");
        for (std::size_t i = 0; i < sheet.targets; ++i)
          bytes += ";" + (positions ? sheet.position_text(i, d, j) : sheet.deviation_text(i, d, j));
      }
    expect_read(sheet, bytes + "\n");
    EXPECT_EQ(guess(bytes)->profile.layout, TableLayout::transposed);
  }
}

TEST(GenericDelimited, ReadsTargetsAcrossWithColumnsOfRunsFromZeroAndDirections) {
  Sheet sheet;
  sheet.delimiter = "\t";
  std::string bytes = "# unit: um\n# target unit: mm\nrun\tdir";
  for (std::size_t i = 0; i < sheet.targets; ++i) bytes += "\t" + sheet.target_text(i);
  for (std::size_t j = 0; j < sheet.runs; ++j)
    for (std::size_t d = 0; d < 2; ++d) {
      bytes += fmt::format("\n{}\t{}", j, d == 0 ? "up" : "down");
      for (std::size_t i = 0; i < sheet.targets; ++i) bytes += "\t" + sheet.deviation_text(i, d, j);
    }
  expect_read(sheet, bytes);
}

TEST(GenericDelimited, ReadsNamesOfRunsThatAreOnlyNumbers) {
  Sheet sheet;
  std::string bytes = "# unit: um\nSoll [mm];Richtung;1;2;3\n";
  for (std::size_t i = 0; i < sheet.targets; ++i)
    for (std::size_t d = 0; d < 2; ++d)
      bytes += sheet.row({sheet.target_text(i), d == 0 ? "up" : "down", sheet.deviation_text(i, d, 0),
                          sheet.deviation_text(i, d, 1), sheet.deviation_text(i, d, 2)});
  expect_read(sheet, bytes);
}

TEST(GenericDelimited, ReadsTimesOfClocksAndSeconds) {
  Sheet sheet;
  for (const bool clock : {false, true}) {
    int n = 0;
    const std::string bytes =
        "Time;Target (mm);Error (um)\n" + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
          const int s = 30 * n++;
          return sheet.row(
              {clock ? fmt::format("2026-05-04 23:{:02}:{:02}.5", 40 + s / 60, s % 60) : fmt::format("{}.5", s),
               sheet.target_text(i), sheet.deviation_text(i, d, j)});
        });
    const axiometry::Test test = read_whole(bytes);
    expect_sheet(sheet, test, bytes);
    ASSERT_EQ(test.times_s.size(), 2 * sheet.targets * sheet.runs);
    EXPECT_EQ(test.times_s[0], 0.0);  // ↑, first target, first run
    // ↓, last target, first run: the seventh reading.
    EXPECT_EQ(test.times_s[(sheet.targets + sheet.targets - 1) * sheet.runs], 180.0);
  }
}

TEST(GenericDelimited, SaysWhenLabelsRunTheOtherWayAndTakesThemAsTheyStand) {
  Sheet sheet;
  const auto file = [&](std::string up, std::string down) {
    return "Run;Direction;Target [mm];Deviation [um]\n" + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
      return sheet.row(
          {std::to_string(j + 1), d == 0 ? up : down, sheet.target_text(i), sheet.deviation_text(i, d, j)});
    });
  };
  const axiometry::Test swapped = read_whole(file("down", "up"));
  EXPECT_TRUE(has_remark(swapped, "run the other way"));
  EXPECT_NEAR(swapped.series.reading(2, down, 1)->in_native(), tenths(2, 0, 1) / 10.0, 1e-9);
  EXPECT_FALSE(has_remark(read_whole(file("up", "down")), "run the other way"));
}

TEST(GenericDelimited, ChecksDeviationsAgainstMeasuredPositions) {
  Sheet sheet;
  const auto file = [&](std::string head, double sign, double gain) {
    return "Soll [mm];Ist [mm];" + head + "\n" + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
      const double x = tenths(i, d, j) / 10.0;
      return sheet.row(
          {sheet.target_text(i), sheet.position_text(i, d, j), sheet.number(sign * (x - gain * sheet.target(i)), 3)});
    });
  };
  expect_read(sheet, file("Abweichung [µm]", 1, 0));
  expect_read(sheet, file("Abweichung [µm]", -1, 0));
  expect_read(sheet, file("Abweichung", 1, 0));  // the unit follows from the positions
  EXPECT_EQ(guess(file("Abweichung", 1, 0))->profile.reading_unit->name, "um");
  EXPECT_TRUE(has_remark(read_whole(file("Abweichung [µm]", 1, 0.05)), "a gain or an offset may have been taken out"));
}

TEST(GenericDelimited, ReadsDeviationsOfTheOtherSignByTheirName) {
  Sheet sheet;
  const std::string bytes = "Soll [mm];Soll-Ist [µm]\n" + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
    return sheet.row({sheet.target_text(i), sheet.number(-tenths(i, d, j) / 10.0, 1)});
  });
  expect_read(sheet, bytes);
}

TEST(GenericDelimited, AsksWhatItCannotKnowAndNamesTheMember) {
  Sheet sheet;
  const auto file = [&](std::string header, bool directions) {
    return header + "\n" + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
      return directions || d == 0 ? sheet.row({sheet.target_text(i), sheet.deviation_text(i, d, j)}) : "";
    });
  };
  EXPECT_EQ(question_in(file("Soll [mm];Abweichung", true)),
            "reading_unit: in which unit are the readings (column 2 \"Abweichung\", up to 4.9)?");
  EXPECT_EQ(question_in(file("Soll;Abweichung [µm]", true)),
            "target_unit: in which unit are the targets (column 1 \"Soll\")?");
  EXPECT_EQ(
      question_in(file("Soll [mm];Abweichung [µm]", false)),
      "direction: found no column of directions and targets that only rise; from where was each target approached: "
      "up, down, motion, visits or run-parity?");
  const auto refused = read_guessed(file("Soll;Abweichung [µm]", true));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().to_string(),
            "line 2: found an open question, expected \"target_unit\" of an import profile to answer it: in which unit "
            "are the targets (column 1 \"Soll\")?");
}

TEST(GenericDelimited, AProfileAnswersTheQuestion) {
  Sheet sheet;
  const std::string bytes = "Soll;Abweichung\n" + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
    return sheet.row({sheet.target_text(i), sheet.deviation_text(i, d, j)});
  });
  ImportProfile profile = guess(bytes)->profile;
  const auto open = read_with(profile, bytes);
  ASSERT_FALSE(open);
  EXPECT_EQ(open.error().message, "found no target_unit in the profile, expected the unit of the targets");
  profile.target_unit = find_unit("mm");
  profile.reading_unit = find_unit("um");
  const auto again = read_profile(write_profile(profile));
  ASSERT_TRUE(again) << again.error().to_string();
  const auto test = read_with(*again, bytes);
  ASSERT_TRUE(test) << test.error().to_string();
  expect_sheet(sheet, *test, bytes);
}

TEST(GenericDelimited, AProfileIsKeptToTheNamesOfItsColumns) {
  Sheet sheet;
  const auto file = [&](std::string header) {
    return header + "\n" + sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
      return sheet.row({sheet.target_text(i), sheet.deviation_text(i, d, j)});
    });
  };
  const ImportProfile profile = guess(file("Soll [mm];Abweichung [µm]"))->profile;
  EXPECT_TRUE(read_with(profile, file("one line more\nSoll [mm];Abweichung [µm]")));
  const auto other = read_with(profile, file("Soll [mm];Fehler [µm]"));
  ASSERT_FALSE(other);
  EXPECT_EQ(other.error().message,
            "found no line with the columns \"Soll [mm]\", \"Abweichung [µm]\", expected one as the profile says");
}

TEST(GenericDelimited, IsRecognisedOnlyWhereNothingIsOpen) {
  Sheet sheet;
  const auto rows = sheet.rows([&](std::size_t i, std::size_t d, std::size_t j) {
    return sheet.row({sheet.target_text(i), sheet.deviation_text(i, d, j)});
  });
  const auto found = recognise("Cible (mm);Écart (µm)\n" + rows);
  ASSERT_TRUE(found) << found.error().to_string();
  EXPECT_EQ((*found)->id, "generic");
  EXPECT_FALSE(recognise("Cible;Écart (µm)\n" + rows));
  EXPECT_EQ(find_format("generic")->recognise("1;2\n3;4\n5;6\n"), 0);
  EXPECT_EQ(find_format("generic")->recognise("Dear Sir,\nthe machine is fine.\n"), 0);
}

}  // namespace
}  // namespace axiometry::formats
