// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/csv/csv_columns.h"

#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

Column only(std::string_view name) { return columns_from({{std::string(name), 1}}).front(); }

std::string described(const Column& c) {
  constexpr std::string_view roles[] = {"test", "target", "direction", "run", "reading", "ignored", "unknown"};
  std::string text(roles[static_cast<std::size_t>(c.role)]);
  if (c.role == ColumnRole::reading && c.measured == Measured::position) text += " position";
  if (c.direction) text += *c.direction == Direction::up ? " up" : " down";
  if (c.run) text += " " + std::to_string(*c.run);
  if (c.unit) text += " " + std::string(c.unit->name);
  if (!c.unit && !c.unit_text.empty() && c.role != ColumnRole::ignored) text += " ?" + c.unit_text;
  return text;
}

struct Name {
  std::string_view name;
  std::string_view meaning;
};

class ColumnNames : public testing::TestWithParam<Name> {};

TEST_P(ColumnNames, AreUnderstood) {
  EXPECT_EQ(described(only(GetParam().name)), GetParam().meaning) << GetParam().name;
}

INSTANTIATE_TEST_SUITE_P(
    Long, ColumnNames,
    testing::Values(Name{"target_mm", "target mm"}, Name{"Target (mm)", "target mm"}, Name{"TARGET [MM]", "target mm"},
                    Name{"target/mm", "target mm"}, Name{"Target position in mm", "target mm"},
                    Name{"nominal_deg", "target deg"}, Name{"Nominal position [°]", "target deg"},
                    Name{"position_mm", "target mm"}, Name{"setpoint mm", "target mm"}, Name{"direction", "direction"},
                    Name{"Approach direction", "direction"}, Name{"dir", "direction"}, Name{"run", "run"},
                    Name{"Run number", "run"}, Name{"cycle", "run"}, Name{"run no", "run"},
                    Name{"deviation_um", "reading um"}, Name{"Deviation (µm)", "reading um"},
                    Name{"error [\u03BCm]", "reading um"}, Name{"positioning error_nm", "reading nm"},
                    Name{"deviation_arcsec", "reading arcsec"}, Name{"position error mm", "reading mm"},
                    Name{"deviation_furlong", "reading ?furlong"}, Name{"deviation [furlong]", "reading ?furlong"},
                    Name{"deviation", "reading"}, Name{"measured_mm", "reading position mm"},
                    Name{"actual position (mm)", "reading position mm"}, Name{"test", "test"}, Name{"test_id", "test"},
                    Name{"timestamp", "ignored"}, Name{"time_s", "ignored"}, Name{"temperature (°C)", "ignored"},
                    Name{"comment", "ignored"}, Name{"target number", "ignored"}, Name{"", "ignored"},
                    Name{"deviation +/- [um]", "reading um"}, Name{"Ist-Soll [µm]", "unknown um"},
                    Name{"actual-target", "unknown"}, Name{"deviation (target - actual) [um]", "unknown um"},
                    Name{"colour", "unknown"}, Name{"selected_reference_slot", "unknown"}));

INSTANTIATE_TEST_SUITE_P(
    Wide, ColumnNames,
    testing::Values(Name{"up1_um", "reading up 1 um"}, Name{"down12_um", "reading down 12 um"},
                    Name{"up_1_um", "reading up 1 um"}, Name{"↑1 (µm)", "reading up 1 um"},
                    Name{"3↓ [µm]", "reading down 3 um"}, Name{"run 1 up [um]", "reading up 1 um"},
                    Name{"Run 2 Down (µm)", "reading down 2 um"}, Name{"1+", "reading up 1"},
                    Name{"1-", "reading down 1"}, Name{"1+_um", "reading up 1 um"},
                    Name{"2- [um]", "reading down 2 um"}, Name{"+1 [um]", "reading up 1 um"},
                    Name{"run-1_um", "reading 1 um"}, Name{"run1_um", "reading 1 um"},
                    Name{"cycle 4 (arcsec)", "reading 4 arcsec"}, Name{"Forward 1 (µm)", "reading up 1 um"},
                    Name{"reverse_2_um", "reading down 2 um"}, Name{"deviation up 1 [um]", "reading up 1 um"},
                    Name{"measured up 1 [mm]", "reading position up 1 mm"}, Name{"up_um", "reading up um"},
                    Name{"5", "reading 5"}, Name{"Run +1 (um)", "reading up 1 um"}, Name{"Run -2", "reading down 2"},
                    Name{"Run 1 (+)", "reading up 1"}, Name{"Run 1 (-) [um]", "reading down 1 um"}));

INSTANTIATE_TEST_SUITE_P(
    German, ColumnNames,
    testing::Values(Name{"Sollposition [mm]", "target mm"}, Name{"Soll (mm)", "target mm"},
                    Name{"Istposition [mm]", "reading position mm"}, Name{"Abweichung [µm]", "reading um"},
                    Name{"Richtung", "direction"}, Name{"Lauf", "run"}, Name{"Zyklus Nr", "run"},
                    Name{"Datum", "ignored"}, Name{"Lauf 1 +", "reading up 1"},
                    Name{"Lauf 2 - [µm]", "reading down 2 um"}, Name{"Lauf 1 auf", "reading up 1"},
                    Name{"Lauf 2 ab [µm]", "reading down 2 um"}, Name{"Vorwärts 3 [µm]", "reading up 3 um"},
                    Name{"zurück 1 (µm)", "reading down 1 um"}, Name{"Mittelwert [µm]", "ignored um"}));

INSTANTIATE_TEST_SUITE_P(Computed, ColumnNames,
                         testing::Values(Name{"Mean (um)", "ignored um"}, Name{"mean up_um", "ignored um"},
                                         Name{"Std dev", "ignored"}, Name{"Max error (um)", "ignored um"}));

INSTANTIATE_TEST_SUITE_P(SecondReadings, ColumnNames,
                         testing::Values(Name{"Temp compensated error [um]", "unknown um"},
                                         Name{"Time corrected error [um]", "unknown um"},
                                         Name{"Note deviation [um]", "unknown um"}, Name{"Index [um]", "unknown um"},
                                         Name{"Temp in", "ignored in"}, Name{"Remark on the beam", "ignored"}));

TEST(CsvColumns, NameWhatIsPassedOver) {
  const auto told = [](std::vector<CsvCell> header) { return passed_over_text(columns_from(header)).value_or(""); };
  EXPECT_EQ(told({{"target_mm", 1}, {"measured_mm", 1}, {"deviation_um", 1}, {"", 1}}), "")
      << "a position beside a deviation is compared with it";
  EXPECT_EQ(told({{"target_mm", 1}, {"deviation_um", 1}, {"Bemerkung", 1}}),
            "nothing was read of the column \"Bemerkung\"");
  EXPECT_EQ(told({{"target_mm", 1}, {"deviation_um", 1}, {"time", 1}, {"Mean [um]", 1}}),
            "nothing was read of the columns \"time\", \"Mean [um]\"");
}

/// Each dash of such a name was once looked at as the beginning of a unit, one within the other, until the stack ended.
TEST(CsvColumns, DoNotLookForWordsInAParagraph) {
  for (const std::string& name : {"aa bb" + std::string(20'000, '-'), "target " + std::string(100'000, 'x')}) {
    const std::vector<Column> columns = columns_from({{name, 1}});
    ASSERT_EQ(columns.size(), 1u);
    EXPECT_EQ(columns[0].role, ColumnRole::unknown);
  }
}

TEST(CsvColumns, TakeAPositionAsTargetOrAsReadingByItsCompany) {
  const auto alone = columns_from({{"position_mm", 1}, {"deviation_um", 13}});
  EXPECT_EQ(alone[0].role, ColumnRole::target);
  const auto beside = columns_from({{"target_mm", 1}, {"position_mm", 11}});
  EXPECT_EQ(described(beside[1]), "reading position mm");
  const auto both = columns_from({{"target_mm", 1}, {"position_mm", 11}, {"deviation_um", 23}});
  EXPECT_EQ(both[1].role, ColumnRole::ignored);
  EXPECT_EQ(both[2].role, ColumnRole::reading);
}

}  // namespace
}  // namespace axiometry::formats
