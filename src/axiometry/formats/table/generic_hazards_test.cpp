// SPDX-License-Identifier: Apache-2.0
//
// What files of unknown make are known to do to a reader: each is read rightly, asked about or refused.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "axiometry/formats/format.h"
#include "axiometry/formats/table/generic_delimited.h"
#include "tests/support/statistics_of_trials.h"

namespace axiometry::formats {
namespace {

using enum Direction;

/// Three targets, two runs to and fro; the deviation of row k is (k + 1) / 10 µm.
struct Row {
  double target;
  Direction direction;
  std::size_t run;
  double deviation;
};

std::vector<Row> rows_of_a_test() {
  std::vector<Row> rows;
  for (std::size_t j = 0; j < 2; ++j)
    for (const Direction d : {up, down})
      for (std::size_t k = 0; k < 3; ++k)
        rows.push_back(
            {100.0 * static_cast<double>(d == up ? k : 2 - k), d, j, static_cast<double>(rows.size() + 1) / 10.0});
  return rows;
}

template <typename Format>
std::string filed(const std::string& header, Format line) {
  std::string text = header;
  for (const Row& row : rows_of_a_test()) text += line(row);
  return text;
}

void expect_test(const std::string& bytes) {
  const auto test = read_guessed(bytes);
  ASSERT_TRUE(test) << test.error().to_string() << "\n" << bytes;
  ASSERT_EQ(test->series.target_count(), 3u) << bytes;
  ASSERT_EQ(test->series.run_count(), 2u) << bytes;
  for (const Row& row : rows_of_a_test())
    ASSERT_NEAR(test->series.reading(static_cast<std::size_t>(row.target / 100.0), row.direction, row.run)->in_native(),
                row.deviation, 1e-6)
        << bytes;
}

std::string answer_to(const std::string& bytes) {
  const auto test = read_guessed(bytes);
  return test ? "read" : test.error().to_string();
}

bool remarks(const std::string& bytes, std::string_view part) {
  const auto test = read_guessed(bytes);
  return test &&
         std::ranges::any_of(test->provenance.remarks, [&](const SourceRemark& r) { return r.message.contains(part); });
}

std::string comma(std::string s) {
  std::ranges::replace(s, '.', ',');
  return s;
}

TEST(GenericHazards, DecimalCommasBetweenCommasAreReadWhereTheHeaderCountsTheColumns) {
  const auto pairs = [](const Row& r) {
    return comma(fmt::format("{:.2f}|{:.4f}\n", r.target, r.target + r.deviation / 1000));
  };
  const auto with_commas = [&](const Row& r) {
    std::string s = pairs(r);
    std::ranges::replace(s, '|', ',');
    return s;
  };
  expect_test(filed("Soll [mm],Ist [mm]\n", with_commas));
  EXPECT_EQ(
      answer_to(filed("# unit: mm\n", with_commas)),
      "line 2: found an open question, expected \"delimiter\" of an import profile to answer it: found whole numbers "
      "between commas, some with leading zeros; commas may be decimal marks as well as delimiters: save the file with "
      "semicolons or tabs between the columns");
}

TEST(GenericHazards, DecimalCommasInQuotesAreNoDelimiters) {
  expect_test(filed("Soll [mm],Abweichung [µm]\n", [](const Row& r) {
    return comma(fmt::format("\"{:.2f}\"|\"{:.1f}\"\n", r.target, r.deviation))
        .replace(comma(fmt::format("\"{:.2f}\"", r.target)).size(), 1, ",");
  }));
}

TEST(GenericHazards, DecimalCommasMayHaveReachedTimeStamps) {
  int n = 0;
  const std::string bytes = filed("Uhrzeit;Soll [mm];Abweichung [µm]\n", [&](const Row& r) {
    return comma(fmt::format("10:30:{:02}.5;{:.2f};{:.1f}\n", n++, r.target, r.deviation));
  });
  expect_test(bytes);
  EXPECT_EQ(read_guessed(bytes)->times_s[2], 1.0);  // target 100, first run upwards
}

TEST(GenericHazards, TimesMayRunBackwards) {
  int n = 0;
  const std::string bytes = filed("Uhrzeit;Soll [mm];Abweichung [µm]\n", [&](const Row& r) {
    const int second = n++;
    return fmt::format("{}:30:{:02};{:.2f};{:.1f}\n", second < 8 ? 10 : 9, second, r.target, r.deviation);
  });
  expect_test(bytes);
  EXPECT_TRUE(read_guessed(bytes)->times_s.empty());
  EXPECT_TRUE(remarks(bytes, "found time running backwards"));
}

TEST(GenericHazards, TheNewestRowMayStandFirst) {
  for (const std::string_view run : {"", "run", "one way"}) {
    std::string rows;
    int n = 0;
    for (const Row& r : rows_of_a_test()) {
      const std::size_t counted = run == "run" ? r.run + 1 : 2 * r.run + (r.direction == up ? 1 : 2);
      const std::string row = fmt::format("10:30:{:02};{:.2f};{:.1f}", n++, r.target, r.deviation);
      rows = row + (run.empty() ? "" : fmt::format(";{}", counted)) + "\n" + rows;
    }
    const std::string bytes = fmt::format("Time;Target [mm];Deviation [um]{}\n", run.empty() ? "" : ";Run") + rows;
    expect_test(bytes);
    EXPECT_EQ(read_guessed(bytes)->times_s[2], 1.0) << "target 100, first run upwards";
    EXPECT_TRUE(remarks(bytes, "begin with the newest reading and were turned round"));
  }
}

TEST(GenericHazards, TheNewestRowMayStandFirstOfATestThatRestedOverNight) {
  std::string rows;
  int n = 0;
  for (const Row& r : rows_of_a_test()) {
    rows = fmt::format("2026-03-0{} {}:30:{:02};{:.2f};{:.1f}\n", n < 6 ? 2 : 3, n < 6 ? 17 : 10, n, r.target,
                       r.deviation) +
           rows;
    ++n;
  }
  const std::string bytes = "Time;Target [mm];Deviation [um]\n" + rows;
  expect_test(bytes);
  EXPECT_TRUE(remarks(bytes, "begin with the newest reading and were turned round"));
}

TEST(GenericHazards, TimesInNoUnitAreSecondsOnlyWhereTheyCanBe) {
  const auto table = [](std::string_view head, double begin, double step) {
    int n = 0;
    return filed(fmt::format("{};Target [mm];Deviation [um]\n", head), [&](const Row& r) {
      return fmt::format("{:.7f};{:.2f};{:.1f}\n", begin + step * n++, r.target, r.deviation);
    });
  };
  for (const double step : {10.0 / 60.0, 10.0 / 86400.0, 10000.0}) {  // minutes, days, milliseconds
    expect_test(table("Time", step < 0.001 ? 46083.5 : 0.0, step));
    EXPECT_TRUE(read_guessed(table("Time", 0.0, step))->times_s.empty()) << step;
  }
  EXPECT_EQ(read_guessed(table("Time", 0.0, 10.0))->times_s[2], 10.0);
  EXPECT_EQ(read_guessed(table("Time [s]", 0.0, 0.5))->times_s[2], 0.5);
}

TEST(GenericHazards, RowsThatCountBackwardsAreAskedAbout) {
  for (const std::string_view head : {"No", "Time"}) {
    double n = 12.0;
    const double step = head == "No" ? 1.0 : 0.1;
    const std::string bytes = filed(fmt::format("{};Target [mm];Deviation [um]\n", head), [&](const Row& r) {
      return fmt::format("{:.6g};{:.2f};{:.1f}\n", step * n--, r.target, r.deviation);
    });
    EXPECT_TRUE(answer_to(bytes).contains("do the rows stand from the last to the first?")) << answer_to(bytes);
  }
}

TEST(GenericHazards, TimesOfOneMinuteEachMayFallAtMidnight) {
  int n = 0;
  const std::string bytes = filed("Time;Target [mm];Deviation [um]\n", [&](const Row& r) {
    return fmt::format("{}:00;{:.2f};{:.1f}\n", n++ < 6 ? "23:59" : "00:00", r.target, r.deviation);
  });
  expect_test(bytes);
  EXPECT_FALSE(remarks(bytes, "turned round"));
}

TEST(GenericHazards, NumbersMayLackTheirZeroAndHaveExponents) {
  expect_test(filed("Target (mm)\tError (mm)\n", [](const Row& r) {
    return fmt::format("{}\t{}\n", r.target, fmt::format("{:.4f}", r.deviation / 1000.0).substr(1));
  }));
  expect_test(filed("Target (mm)\tError (mm)\n",
                    [](const Row& r) { return fmt::format("{:.3E}\t{:.4e}\n", r.target, r.deviation / 1000.0); }));
  expect_test(filed("Soll [mm];Abweichung [mm]\n", [](const Row& r) {
    return comma(fmt::format("{:.3E};{:+.4e}\n", r.target, r.deviation / 1000.0));
  }));
}

TEST(GenericHazards, RowsMayStandInAnyOrderWhereColumnsSayTheirPlace) {
  std::vector<Row> rows = rows_of_a_test();
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial) {
    std::ranges::shuffle(rows, random);
    std::string bytes = "Lauf;Richtung;Soll [mm];Abweichung [µm]\n";
    for (const Row& r : rows)
      bytes += fmt::format("{};{};{};{}\n", r.run + 1, r.direction == up ? "hin" : "zurück", r.target, r.deviation);
    expect_test(bytes);
  }
}

TEST(GenericHazards, RowsInNoOrderOfSweepsTellNoDirection) {
  std::vector<Row> rows = rows_of_a_test();
  std::string bytes = "Soll [mm];Abweichung [µm]\n";
  for (const std::size_t k : {0u, 2u, 4u, 1u, 3u, 5u, 6u, 8u, 7u, 9u, 11u, 10u})
    bytes += fmt::format("{};{}\n", rows[k].target, rows[k].deviation);
  EXPECT_EQ(
      answer_to(bytes),
      "line 2: found an open question, expected \"direction\" of an import profile to answer it: found no column of "
      "directions and no order of sweeps along the axis; from where was each target approached: up, down, motion, "
      "visits or run-parity?");
}

TEST(GenericHazards, CountsAboveTheTableAreNotTrusted) {
  expect_test(filed("Positions: 11\nCycles: 5\n\nTarget (mm);Error (um)\n",
                    [](const Row& r) { return fmt::format("{};{}\n", r.target, r.deviation); }));
}

TEST(GenericHazards, MissingAndExtraRunsStayWhatTheyAre) {
  std::string bytes = "Run;Direction;Target (mm);Error (um)\n";
  for (const int run : {1, 2, 4})
    for (const char* direction : {"+", "-"})
      for (int i = 0; i < 4; ++i)
        if (run != 4 || i < 3)
          bytes += fmt::format("{};{};{};{}\n", run, direction, 10 * i, i == 2 && run == 1 ? "" : "0.5");
  bytes += "5;+;0;0.7\n";
  const auto test = read_guessed(bytes);
  ASSERT_TRUE(test) << test.error().to_string();
  EXPECT_EQ(test->series.run_count(), 5u);
  EXPECT_FALSE(test->series.reading(0, up, 2));
  EXPECT_FALSE(test->series.reading(3, up, 3));
  EXPECT_FALSE(test->series.reading(2, down, 0));
  EXPECT_EQ(test->series.reading(0, up, 4)->in_native(), 0.7);
}

TEST(GenericHazards, PositionsAndDeviationsAreToldApartByTheirNumbers) {
  expect_test(filed("# unit: mm\n# target unit: mm\n",
                    [](const Row& r) { return fmt::format("{}\t{}\n", r.target, r.target + r.deviation / 1000.0); }));
  expect_test(filed("# unit: um\n# target unit: mm\n",
                    [](const Row& r) { return fmt::format("{}\t{}\n", r.target, r.deviation); }));
  // "Messwert" in µm that are deviations.
  expect_test(
      filed("Soll [mm];Messwert [µm]\n", [](const Row& r) { return fmt::format("{};{}\n", r.target, r.deviation); }));
}

TEST(GenericHazards, MicrometresAndMillimetresAreNeverGuessedFromTheSize) {
  const auto with_unit = [](std::string unit, double factor) {
    return filed(fmt::format("Soll [mm];Abweichung [{}]\n", unit),
                 [&](const Row& r) { return fmt::format("{};{}\n", r.target, r.deviation * factor); });
  };
  expect_test(with_unit("mm", 1e-3));
  expect_test(with_unit("µm", 1.0));
  expect_test(with_unit("nm", 1e3));
  EXPECT_TRUE(answer_to(filed("Soll [mm];Abweichung\n", [](const Row& r) {
                return fmt::format("{};{}\n", r.target, r.deviation);
              })).contains("\"reading_unit\""));
}

/// Nor are they believed where no axis is like that.
TEST(GenericHazards, AUnitThatMakesDeviationsImpossibleIsAskedAbout) {
  const auto with_unit = [](std::string unit, double factor) {
    return answer_to(filed(fmt::format("Soll [mm];Abweichung [{}]\n", unit),
                           [&](const Row& r) { return fmt::format("{};{}\n", r.target, r.deviation * factor); }));
  };
  for (const auto& answer : {with_unit("mm", 10.0), with_unit("µm", 10'000.0), with_unit("µm", 1e-3)})
    EXPECT_TRUE(answer.contains("\"reading_unit\"") && answer.contains("are they really in")) << answer;
  EXPECT_FALSE(with_unit("µm", 10.0).contains("really"));
  EXPECT_FALSE(with_unit("µm", 0.1).contains("really")) << "a tenth of a micrometre over 200 mm may be";
  EXPECT_FALSE(with_unit("µm", 0.0).contains("really")) << "nothing is no unit mistaken";
}

/// A factor of 1000 that leaves deviations as an axis may have them.
TEST(GenericHazards, AUnitThatMeasuredPositionsContradictIsAskedAbout) {
  const auto with_unit = [](std::string unit, double factor) {
    return filed(fmt::format("Soll [mm];Ist [mm];Abweichung [{}]\n", unit), [&](const Row& r) {
      return fmt::format("{};{:.6f};{}\n", r.target, r.target + r.deviation * 1e-3, r.deviation * factor);
    });
  };
  const std::string answer = answer_to(with_unit("mm", 1.0 / 8.0));
  EXPECT_FALSE(answer.contains("in which unit are they?")) << "nor in µm are they that difference";
  for (const auto& wrong : {with_unit("mm", 1.0), with_unit("nm", 1.0), with_unit("µm", 1e-3)})
    EXPECT_TRUE(answer_to(wrong).contains("\"reading_unit\"")) << answer_to(wrong);
  for (const auto& right : {with_unit("mm", 1e-3), with_unit("µm", 1.0), with_unit("nm", 1e3)})
    EXPECT_FALSE(answer_to(right).contains("\"reading_unit\"")) << answer_to(right);
}

TEST(GenericHazards, LatinOneAndUtf16AreReadAndTold) {
  const std::string latin = filed("Messger\xE4t\nSoll [mm];Abweichung [\xB5m]\n",
                                  [](const Row& r) { return fmt::format("{};{}\n", r.target, r.deviation); });
  expect_test(latin);
  EXPECT_TRUE(remarks(latin, "not UTF-8"));
  const std::string ascii =
      filed("Target (mm);Error (um)\n", [](const Row& r) { return fmt::format("{};{}\n", r.target, r.deviation); });
  std::string little = "\xFF\xFE";
  std::string big = "\xFE\xFF";
  for (const char c : ascii) {
    little += {c, '\0'};
    big += {'\0', c};
  }
  expect_test(little);
  expect_test(big);
  expect_test("\xEF\xBB\xBF" + ascii);
}

TEST(GenericHazards, ChineseCodePagesAreFoundOutOrStated) {
  // "目标位置(mm)", "偏差(um)" in GBK.
  const std::string gbk = filed("\xC4\xBF\xB1\xEA\xCE\xBB\xD6\xC3(mm);\xC6\xAB\xB2\xEE(um)\n",
                                [](const Row& r) { return fmt::format("{};{}\n", r.target, r.deviation); });
  expect_test(gbk);
  ImportProfile profile = guess(gbk)->profile;
  profile.encoding = TextEncoding::gbk;
  EXPECT_TRUE(read_with(profile, gbk));
  profile.encoding = TextEncoding::utf8;
  EXPECT_FALSE(read_with(profile, gbk));
  profile.encoding = TextEncoding::latin1;
  EXPECT_FALSE(read_with(profile, gbk));  // its columns have other names then
}

TEST(GenericHazards, LineEndsAndBlanksAtTheirEndsDoNoHarm) {
  for (const std::string end : {"\n", "\r\n", "\r", "   \r\n", "\n\n", ";\r\n"})
    expect_test(filed("Target (mm);Error (um)" + end,
                      [&](const Row& r) { return fmt::format("{};{}", r.target, r.deviation) + end; }));
}

TEST(GenericHazards, RowsOfMeansBelowAreToldAndRowsOfNumbersAreNotLost) {
  const auto row = [](const Row& r) { return fmt::format("{};{};{}\n", r.run, r.target, r.deviation); };
  const std::string bytes = filed("Lauf;Soll [mm];Abweichung [µm]\n", row);
  expect_test(bytes + "\nMittelwert;;0,65\nStreuung;;0,3\n");
  EXPECT_TRUE(remarks(bytes + "\nMittelwert;;0,65\n", "end \"Mittelwert\""));
  EXPECT_EQ(answer_to(bytes + "1;2\n"), "line 14:1: found 2 fields, expected 3 as in the rest of the table");
}

struct Bad {
  std::string what;
  std::string bytes;
  std::string answer;
};

class GenericBadInputs : public testing::TestWithParam<Bad> {};
TEST_P(GenericBadInputs, AreRefused) { EXPECT_EQ(answer_to(GetParam().bytes), GetParam().answer); }

const std::string head = "Soll [mm];Ist [mm]\n";
const std::string sweep = "0;0.001\n10;10.001\n20;20.001\n20;20.002\n10;10.002\n0;0.002\n";

std::string columns(std::size_t count) {
  std::string text;
  for (int line = 0; line < 3; ++line) {
    for (std::size_t k = 0; k < count; ++k) text += "1;";
    text += "\n";
  }
  return text;
}

INSTANTIATE_TEST_SUITE_P(
    Tables, GenericBadInputs,
    testing::Values(
        Bad{"Empty", "", "found an empty file, expected measured deviations"},
        Bad{"NothingNumeric", "Dear Sir,\nthe machine is fine.\n",
            "found no table of numbers, expected at least two columns of them"},
        Bad{"FewRows", head + "0;0.1\n10;10.1\n", "line 2:1: found a table of 2 rows, expected at least 5"},
        Bad{"ShortRow", head + "0;0.001\n10\n" + sweep,
            "line 3:1: found 1 field, expected 2 as in the rest of the table"},
        Bad{"LongRow", head + "0;0.001\n10;1;2\n" + sweep,
            "line 3:6: found 3 fields, expected 2 as in the rest of the table"},
        Bad{"NotANumber", head + "10;NaN\n" + sweep, "line 2:4: found \"NaN\", expected a finite number"},
        Bad{"Infinite", head + sweep + "10;-inf\n", "line 8:4: found \"-inf\", expected a finite number"},
        Bad{"WrongCharacter", head + sweep + "10;1O.002\n" + sweep,
            "line 8:4: found \"1O.002\", expected a finite number"},
        Bad{"TwoDecimalMarks", head + "0;0,001\n" + sweep,
            "line 2: found an open question, expected \"decimal_mark\" of an import profile to answer it: found "
            "numbers "
            "with a comma and numbers with a point; which is the decimal mark, point or comma?"},
        Bad{"PerhapsThousands",
            "Soll [mm];Abweichung [nm]\n0;1,250\n100;2,125\n200;3,500\n200;4,000\n100;5,000\n0;1,000\n",
            "line 2: found an open question, expected \"decimal_mark\" of an import profile to answer it: found commas "
            "only "
            "before three digits, as in \"1,250\"; they may be decimal marks or part thousands: remove those, or say "
            "comma"},
        Bad{"TwoColumnsOfDeviations",
            "Soll [mm];Fehler 1. Art [µm];Abweichung [µm];Fehler [µm]\n0;1;1;1\n10;1;1;2\n20;1;2;2\n"
            "20;1;1;1\n10;2;1;1\n0;1;1;1\n",
            "line 2: found an open question, expected \"columns\" of an import profile to answer it: found column 3 "
            "\"Abweichung [µm]\", column 4 \"Fehler [µm]\" that may all be the readings; which of them is it?"},
        Bad{"TwoTargets", "Soll [mm];Target [mm];Fehler [µm]\n0;0;1\n10;11;1\n20;22;2\n20;22;2\n10;11;1\n0;0;1\n",
            "line 2: found an open question, expected \"columns\" of an import profile to answer it: found column 1 "
            "\"Soll [mm]\", column 2 \"Target [mm]\" that may all be the targets; which of them is it?"},
        Bad{"UnknownDirections",
            "Richtung;Soll [mm];Fehler [µm]\nlinks;0;1\nlinks;10;1\nlinks;20;2\nrechts;20;2\nrechts;10;1\n",
            "line 2: found an open question, expected \"up_words\" of an import profile to answer it: found the words "
            "\"links\", \"rechts\" in column 1 \"Richtung\"; which of them say up, and which down (down_words)?"},
        Bad{"MixedKinds", "Soll [mm];Abweichung [arcsec]\n" + sweep,
            "line 2:3: found targets in mm and readings in arcsec, expected both as lengths or both as angles"},
        Bad{"ReadTwice", "Lauf;Richtung;Soll [mm];Fehler [µm]\n1;+;0;1\n1;+;5;1\n1;+;0;2\n1;-;5;1\n1;-;0;1\n",
            "line 4:7: found a second reading of target 0↑ run 1, expected only that on line 2"},
        Bad{"AMillionColumns", columns(1'000'000), "line 1:1: found 1000001 columns, expected at most 4096"},
        Bad{"Binary", std::string("PK\x03\x04\0\0", 6) + sweep,
            "line 1:1: found a ZIP archive or a spreadsheet, expected a text file; save a spreadsheet as CSV"}),
    [](const testing::TestParamInfo<Bad>& bad) { return bad.param.what; });

TEST(GenericHazards, AnEnormousFileIsRefusedBeforeItIsTakenApart) {
  std::string bytes(std::size_t{64} << 20, '1');
  bytes += "\n";
  EXPECT_EQ(answer_to(bytes), "found 67108865 bytes, expected at most 67108864 for a table of an unknown layout");
}

TEST(GenericHazards, DamagedFilesNeverCrash) {
  std::mt19937 random(230);
  const std::string seeds[] = {
      filed("Lauf;Richtung;Soll [mm];Abweichung [µm]\n",
            [](const Row& r) {
              return fmt::format("{};{};{};{}\n", r.run, r.direction == up ? "hin" : "rück", r.target, r.deviation);
            }),
      "Soll [mm]\t0\t100\t200\nLauf 1 ↑ [µm]\t1\t2\t3\nLauf 1 ↓ [µm]\t2\t3\t4\n",
      filed("Soll [mm],Ist [mm]\n", [](const Row& r) { return fmt::format("{},0{},5\n", r.target, r.target); }),
      "Run  Target (mm)  Error (um)\n" +
          filed("", [](const Row& r) { return fmt::format("{}  {}  {}\n", r.run, r.target, r.deviation); }),
  };
  const std::string bits = "0159;,.\t\n\r -+eE\"#↑µnaN[]()/:\xFF\xFE";
  std::size_t read = 0;
  for (const std::string& seed : seeds)
    for (std::size_t trial = 0; trial < testing_support::as_many(1500); ++trial) {
      std::string bytes = seed;
      for (std::size_t k = 1 + random() % 6; k > 0 && !bytes.empty(); --k) {
        const std::size_t at = random() % bytes.size();
        switch (random() % 4) {
          case 0: bytes[at] = bits[random() % bits.size()]; break;
          case 1: bytes.erase(at, 1 + random() % 9); break;
          case 2: bytes.insert(at, 1, bits[random() % bits.size()]); break;
          case 3: bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 30)); break;
        }
      }
      const auto test = read_guessed(bytes);
      read += test.has_value();
      if (!test) {
        EXPECT_TRUE(test.error().message.starts_with("found ")) << test.error().message;
      }
      find_format("generic")->recognise(bytes);
      static_cast<void>(check_table(bytes));
    }
  EXPECT_GT(read, testing_support::as_many(150));
}

}  // namespace
}  // namespace axiometry::formats
