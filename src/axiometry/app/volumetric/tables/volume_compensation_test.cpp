// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/tables/volume_compensation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/language/language.h"
#include "axiometry/volumetric/known_machine_test_support.h"

namespace axiometry::app {
namespace {

using ::testing::HasSubstr;
using volumetric::testing::known_errors;
using volumetric::testing::known_identification;
using volumetric::testing::known_machine;

const volumetric::ErrorModel& identified_model() {
  static const auto model = known_identification(known_machine(), 100).model;
  return model;
}

VolumeCompensationRequest asked_table(std::string control, std::size_t along, std::size_t component) {
  VolumeCompensationRequest request;
  request.tool = "T1";
  request.along = along;
  request.component = component;
  request.how.control = std::move(control);
  return request;
}

/// The true machine's displacement along the line, with what the control adds: the slope of its best straight line,
/// µm/mm, and the range of what is beside that.
struct TrueLine {
  double slope = 0.0;
  double range_beside = 0.0;
  double range = 0.0;
};

TrueLine true_line(std::size_t along, std::size_t component, const AxisCorrection* added) {
  constexpr int places = 61;
  const Vector3 first{0, 0, -500}, last{1000, 600, 0}, tool{0, 0, -150};
  std::vector<double> positions, values;
  double mean_position = 0.0, mean = 0.0;
  for (int k = 0; k < places; ++k) {
    Vector3 q = 0.5 * (first + last);
    q[along] = first[along] + (last[along] - first[along]) * (0.02 + 0.96 * k / (places - 1.0));
    positions.push_back(q[along]);
    values.push_back(volumetric::displacement_um(known_machine(), known_errors(q), q, tool)[component] +
                     (added ? added->at(q[along], Direction::up) : 0.0));
    mean_position += q[along] / places;
    mean += values.back() / places;
  }
  double xx = 0.0, xy = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    xx += (positions[k] - mean_position) * (positions[k] - mean_position);
    xy += (positions[k] - mean_position) * (values[k] - mean);
  }
  TrueLine line{.slope = xy / xx};
  const auto [least, most] = std::ranges::minmax(values);
  line.range = most - least;
  for (std::size_t k = 0; k < values.size(); ++k) values[k] -= line.slope * positions[k];
  const auto [low, high] = std::ranges::minmax(values);
  line.range_beside = high - low;
  return line;
}

/// The slope of straightness is a rotation of the whole machine, which no lengths tell.
TEST(VolumeCompensation, CorrectsTheTrueMachineAlongEachAxisInEachDirection) {
  for (std::size_t along = 0; along < 3; ++along)
    for (std::size_t component = 0; component < 3; ++component) {
      SCOPED_TRACE(::testing::Message() << "XYZ"[along] << " moves, "
                                        << "XYZ"[component] << " is corrected");
      const auto made = compensate_volume(identified_model(), asked_table("siemens-cec", along, component));
      ASSERT_TRUE(made) << made.error().to_string();
      const TrueLine before = true_line(along, component, nullptr), after = true_line(along, component, &made->applied);
      if (along == component)
        EXPECT_LT(after.range, 0.25 * before.range);
      else
        EXPECT_LT(after.range_beside, 0.35 * before.range_beside);
      EXPECT_LT(made->line_after_um, 0.2 * made->line_before_um);
      EXPECT_EQ(made->options.output_axis.empty(), along == component);
    }
}

/// The sum of both slopes is the squareness of two axes, whatever rotation of the whole is chosen.
TEST(VolumeCompensation, TakesTheTrueSquarenessAway) {
  for (const auto& [a, b] : {std::pair(0u, 1u), std::pair(0u, 2u), std::pair(1u, 2u)}) {
    SCOPED_TRACE(::testing::Message() << "XYZ"[a] << " and "
                                      << "XYZ"[b]);
    const auto one = compensate_volume(identified_model(), asked_table("siemens-cec", a, b));
    const auto other = compensate_volume(identified_model(), asked_table("siemens-cec", b, a));
    ASSERT_TRUE(one && other);
    const double before = true_line(a, b, nullptr).slope + true_line(b, a, nullptr).slope;
    const double after = true_line(a, b, &one->applied).slope + true_line(b, a, &other->applied).slope;
    EXPECT_GT(std::abs(before), 3e-3) << "µm/mm";
    EXPECT_LT(std::abs(after), 1e-3);
  }
}

TEST(VolumeCompensation, NamesTheErrorsOfATable) {
  const auto of = [](std::size_t along, std::size_t component) {
    return compensate_volume(identified_model(), asked_table("siemens-cec", along, component))->errors;
  };
  EXPECT_EQ(of(0, 0), "EXX");
  EXPECT_EQ(of(0, 1), "EYX");
  EXPECT_EQ(of(1, 0), "EXY, C0Y");
  EXPECT_EQ(of(2, 0), "EXZ, B0Z");
  EXPECT_EQ(of(2, 1), "EYZ, A0Z");
}

TEST(VolumeCompensation, TellsWhatOneTableLeavesOfTheVolume) {
  const auto made = compensate_volume(identified_model(), asked_table("siemens-cec", 1, 0));
  ASSERT_TRUE(made) << made.error().to_string();
  EXPECT_GT(made->effect.after.percent_95, 0.3 * made->effect.before.percent_95) << "the other errors stay";
  const auto value = to_json(*made);
  EXPECT_EQ(value.find("output_axis")->text(), "X");
  EXPECT_EQ(value.find("volume")->find("before")->find("percent_95")->number(), made->effect.before.percent_95);
}

TEST(VolumeCompensation, WritesTheTableOfOneAxisForEveryControlThatHoldsOne) {
  for (const nc::AxisTable* control : nc::axis_table_table()) {
    if (!control->limits.linear || control->limits.points == 1 || control->limits.cross_only) continue;
    SCOPED_TRACE(control->id);
    auto request = asked_table(std::string(control->id), 0, 0);
    if (control->uses.magnification) request.how.table.magnification = 4;
    if (control->uses.steps_per_unit) request.how.table.steps_per_unit = 800;
    if (control->limits.origin == nc::TableOrigin::last) request.how.table.reference = 990.0;
    const auto made = compensate_volume(identified_model(), request);
    ASSERT_TRUE(made) << made.error().to_string();
    EXPECT_LT(made->line_after_um, made->line_before_um);
  }
}

/// What goes to the control is all that its reader sees.
TEST(VolumeCompensation, WarnsInTheFileWhereTheResultShouldNotBeUsed) {
  const KeptModel kept{identified_model(),
                       {{"volumetric-tool-offset", true, "wrong"}, {"volumetric-copies", false, "x"}}};
  std::size_t warned = 0, silent = 0;
  for (const nc::AxisTable* control : nc::axis_table_table()) {
    if (!control->limits.linear || control->limits.points == 1 || control->limits.cross_only) continue;
    SCOPED_TRACE(control->id);
    auto request = asked_table(std::string(control->id), 0, 0);
    if (control->uses.magnification) request.how.table.magnification = 4;
    if (control->uses.steps_per_unit) request.how.table.steps_per_unit = 800;
    if (control->limits.origin == nc::TableOrigin::last) request.how.table.reference = 990.0;
    const auto made = compensate_volume(kept, request);
    ASSERT_TRUE(made) << made.error().to_string();
    const bool says = made->text.contains("DO NOT USE AS IT IS") && made->text.contains("volumetric-tool-offset");
    const bool told = std::ranges::any_of(made->findings,
                                          [](const NamedFinding& f) { return f.id == "volume-table-without-warning"; });
    EXPECT_NE(says, told);
    ++(says ? warned : silent);
    EXPECT_FALSE(made->text.contains("volumetric-copies"));
    EXPECT_TRUE(control->recognises == nullptr || control->recognises(made->text));
    const auto unwarned = compensate_volume(identified_model(), request);
    ASSERT_TRUE(unwarned);
    EXPECT_FALSE(unwarned->text.contains("DO NOT USE"));
    EXPECT_EQ(unwarned->line_after_um, made->line_after_um);
  }
  EXPECT_GT(warned, 5u);
  EXPECT_GT(silent, 0u);
}

TEST(VolumeCompensation, RefusesACrossTableWhereTheFormatHasNone) {
  const auto refused = compensate_volume(identified_model(), asked_table("linuxcnc", 1, 0));
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("moves X by the position of Y for LinuxCNC"));
  auto request = asked_table("linuxcnc", 0, 0);
  request.how.table.output_axis = "AX2";
  EXPECT_THAT(compensate_volume(identified_model(), request).error().message, HasSubstr("output_axis"));
  auto crossed = asked_table("siemens-cec", 1, 0);
  crossed.how.axis = "AX2";
  crossed.how.table.output_axis = "AX2";
  EXPECT_THAT(compensate_volume(identified_model(), crossed).error().message, HasSubstr("expected two axes"));
  auto own = asked_table("siemens-cec", 0, 0);
  own.how.axis = "AX1";
  own.how.table.output_axis = "AX7";
  EXPECT_THAT(compensate_volume(identified_model(), own).error().message, HasSubstr("expected one axis"));
}

TEST(VolumeCompensation, GivesSquarenessAsOneNumberWhereThatIsAll) {
  const auto made = compensate_volume(identified_model(), asked_table("marlin-skew", 1, 0));
  ASSERT_TRUE(made) << made.error().to_string();
  EXPECT_THAT(made->text, HasSubstr("\nM852 I"));
  EXPECT_LT(made->line_after_um, made->line_before_um);
  // One factor: what it adds is a straight line, and takes the slope of the line in the true machine away with it.
  const TrueLine before = true_line(1, 0, nullptr), after = true_line(1, 0, &made->applied);
  EXPECT_NEAR(after.range_beside, before.range_beside, 1e-6);
  const double factor = (made->applied.at(500.0, Direction::up) - made->applied.at(100.0, Direction::up)) / 400.0;
  EXPECT_NEAR(after.slope - before.slope, factor, 1e-9);
  EXPECT_THAT(compensate_volume(identified_model(), asked_table("marlin-skew", 0, 1)).error().message,
              HasSubstr("expected X by Y, X by Z or Y by Z"));
  EXPECT_FALSE(compensate_volume(identified_model(), asked_table("marlin-skew", 0, 0)));
}

TEST(VolumeCompensation, MovesAnotherMotorOfPmac) {
  auto request = asked_table("pmac", 1, 0);
  request.how.table.resolution = 0.1;
  request.how.table.number = 2;
  EXPECT_THAT(compensate_volume(identified_model(), request).error().message, HasSubstr("number of its motor"));
  request.how.table.output_axis = "1";
  request.how.curves = TableCurves::both_ways;
  const auto made = compensate_volume(identified_model(), request);
  ASSERT_TRUE(made) << made.error().to_string();
  EXPECT_THAT(made->text, HasSubstr("\n#1 DEFINE COMP "));
  EXPECT_THAT(made->text, HasSubstr(",#2,#1,"));
  const TrueLine before = true_line(1, 0, nullptr), after = true_line(1, 0, &made->applied);
  EXPECT_LT(after.range_beside, 0.35 * before.range_beside);
}

TEST(VolumeCompensation, ReportsWhatItPredicts) {
  const auto made = compensate_volume(identified_model(), asked_table("siemens-cec", 1, 0));
  ASSERT_TRUE(made) << made.error().to_string();
  const Experiment shown = present(*made, {});
  std::string all = report::plain_text(shown.document.status.at(0).heading);
  for (const report::Section& section : shown.document.sections)
    for (const auto& block : section.blocks)
      if (const auto* table = std::get_if<report::Table>(&block))
        for (const auto& row : table->rows) {
          EXPECT_EQ(row.size(), table->columns.size());
          for (const report::TableCell& cell : row) all += "|" + report::plain_text(cell.text);
        }
  const auto digits = [](double x) {
    const double rounded = std::round(x * 100.0) / 100.0;
    std::string text = std::to_string(rounded);
    return text.substr(0, text.find('.') + 3);
  };
  for (const double figure :
       {made->line_before_um, made->line_after_um, made->effect.before.largest.value, made->effect.after.percent_95})
    EXPECT_THAT(all, HasSubstr(digits(figure)));
  EXPECT_EQ(json::dump(shown.json), json::dump(to_json(*made)));
}

const report::Section& section_named(const report::Document& document, std::string_view id) {
  return *std::ranges::find(document.sections, id, &report::Section::id);
}

template <typename Kind>
std::vector<const Kind*> blocks_of(const report::Section& section) {
  std::vector<const Kind*> found;
  for (const report::Block& block : section.blocks)
    if (const auto* one = std::get_if<Kind>(&block)) found.push_back(one);
  return found;
}

TEST(VolumeCompensation, DrawsTheLineAndTheTableAndPrintsNoPagesOfNumbers) {
  auto request = asked_table("siemens-cec", 1, 0);
  request.how.grid = {.step = 2.0};
  const auto made = compensate_volume(identified_model(), request);
  ASSERT_TRUE(made) << made.error().to_string();
  const std::size_t count = made->applied.positions().size();
  ASSERT_GT(count, 200u);
  const report::Document document = present(*made, {}).document;
  for (const std::string_view id : {"line", "table"}) {
    SCOPED_TRACE(id);
    const report::Section& section = section_named(document, id);
    EXPECT_EQ(blocks_of<report::Figure>(section).size(), 1u);
    const auto tables = blocks_of<report::Table>(section);
    ASSERT_EQ(tables.size(), 1u);
    EXPECT_LE(tables[0]->rows.size(), 41u);
    EXPECT_GE(tables[0]->rows.size(), 21u);
  }
  const report::Table& table = *blocks_of<report::Table>(section_named(document, "table"))[0];
  const auto first_cell = [](const auto& row) { return report::plain_text(row[0].text); };
  EXPECT_EQ(first_cell(table.rows.front()), format_fixed(made->applied.positions().front(), 4));
  EXPECT_EQ(first_cell(table.rows.back()), format_fixed(made->applied.positions().back(), 4));
  ASSERT_EQ(table.notes.size(), 2u);
  EXPECT_THAT(report::plain_text(table.notes[1]),
              ::testing::StartsWith(std::to_string(table.rows.size()) + " of " + std::to_string(count)));
  EXPECT_EQ(to_json(*made).find("table")->items().size(), count) << "nothing is left out there";
}

TEST(VolumeCompensation, PrintsAShortTableWhole) {
  const auto made = compensate_volume(identified_model(), asked_table("marlin-skew", 1, 0));
  ASSERT_TRUE(made) << made.error().to_string();
  const report::Document document = present(*made, {}).document;
  const report::Table& table = *blocks_of<report::Table>(section_named(document, "table"))[0];
  EXPECT_EQ(table.rows.size(), made->applied.positions().size());
  EXPECT_EQ(table.notes.size(), 1u) << "nothing is left out";
}

/// The band is ±2u of each place; the curve with the table lies in its middle.
TEST(VolumeCompensation, KnowsTheUncertaintyAtEachPlaceOfTheLine) {
  const auto made = compensate_volume(identified_model(), asked_table("siemens-cec", 1, 0));
  ASSERT_TRUE(made) << made.error().to_string();
  const LineOfVolume& line = made->line;
  ASSERT_EQ(line.up_u_um.size(), line.positions_mm.size());
  ASSERT_EQ(line.down_u_um.size(), line.positions_mm.size());
  double largest = 0.0;
  for (const auto* u : {&line.up_u_um, &line.down_u_um})
    for (const double each : *u) {
      EXPECT_GT(each, 0.0);
      largest = std::max(largest, each);
    }
  EXPECT_EQ(line.largest_u_um, largest);
}

TEST(VolumeCompensation, SaysInGermanThatATableIsMostlyUncertainty) {
  EXPECT_TRUE(language::is_known(
      "the displacements on the line differ by 1.20 µm, and each is known to ±3.40 µm (k = 2): the table is mostly "
      "what the readings do not tell",
      language::Language::german));
}

TEST(VolumeCompensation, RefusesWhatOnlyAMeasuredTestHas) {
  const auto refuses = [](auto change) {
    auto request = asked_table("linuxcnc", 0, 0);
    change(request.how);
    const auto made = compensate_volume(identified_model(), request);
    ASSERT_FALSE(made);
    EXPECT_THAT(made.error().message, HasSubstr("options of a measured test"));
    EXPECT_TRUE(language::is_known(made.error().message, language::Language::german));
  };
  refuses([](CompensateRequest& how) { how.periodic = compensation::Periodic::leave; });
  refuses([](CompensateRequest& how) { how.period = 10.0; });
  refuses([](CompensateRequest& how) { how.existing_in_inch = true; });
}

TEST(VolumeCompensation, TellsWhatMustBeDoneBesideTheTable) {
  const auto has = [](const VolumeCompensationRequest& request, std::string_view id) {
    const auto made = compensate_volume(identified_model(), request);
    return made && std::ranges::find(made->findings, id, &NamedFinding::id) != made->findings.end();
  };
  auto request = asked_table("siemens-cec", 0, 0);
  EXPECT_FALSE(has(request, "compensation-sign-turned"));
  request.how.table.turned_sign = true;
  EXPECT_TRUE(has(request, "compensation-sign-turned"));
}

TEST(VolumeCompensation, TellsWhereTheTableEndsBesideWhatWasObserved) {
  const auto finding = [](compensation::GridRequest grid, bool hold_ends, std::string_view id) {
    auto request = asked_table("linuxcnc", 0, 0);
    request.how.grid = grid;
    request.how.hold_ends = hold_ends;
    const auto made = compensate_volume(identified_model(), request);
    EXPECT_TRUE(made) << made.error().to_string();
    const auto found = std::ranges::find(made->findings, id, &NamedFinding::id);
    if (found == made->findings.end()) return std::optional<NamedFinding>();
    EXPECT_TRUE(language::is_known(found->message, language::Language::german)) << found->message;
    return std::optional(*found);
  };
  const auto short_one = finding({.start = 400.0, .end = 600.0, .step = 50.0}, false, "volume-table-short");
  ASSERT_TRUE(short_one);
  EXPECT_TRUE(short_one->serious);
  EXPECT_THAT(short_one->message, HasSubstr("from 400 to 600 mm"));
  auto over = asked_table("pmac", 0, 0);
  over.how.grid = {.start = 400.0, .end = 600.0, .step = 50.0};
  const auto rolled = compensate_volume(identified_model(), over);
  ASSERT_TRUE(rolled) << rolled.error().to_string();
  const auto beyond = std::ranges::find(rolled->findings, "volume-table-short", &NamedFinding::id);
  ASSERT_NE(beyond, rolled->findings.end());
  EXPECT_THAT(beyond->message, HasSubstr("over all of that the file holds the last value"));
  EXPECT_TRUE(language::is_known(beyond->message, language::Language::german)) << beyond->message;
  EXPECT_LE(rolled->applied.positions().front(), rolled->line.positions_mm.front());
  EXPECT_EQ(rolled->applied.at(rolled->line.positions_mm.front(), Direction::up),
            rolled->applied.at(400.0, Direction::up));
  const auto held = finding({.start = -100.0, .end = 1000.0, .step = 50.0}, true, "volume-table-ends-held");
  ASSERT_TRUE(held);
  EXPECT_TRUE(held->serious);
  EXPECT_FALSE(finding({}, false, "volume-table-ends-held"));
  const auto usual = finding({}, false, "volume-table-short");
  EXPECT_FALSE(usual && usual->serious);
}

TEST(VolumeCompensation, ExtrapolatesNothing) {
  auto request = asked_table("siemens-cec", 0, 0);
  request.how.grid = {.start = -200.0, .end = 1000.0, .step = 100.0};
  const auto refused = compensate_volume(identified_model(), request);
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, HasSubstr("measured"));
}

}  // namespace
}  // namespace axiometry::app
