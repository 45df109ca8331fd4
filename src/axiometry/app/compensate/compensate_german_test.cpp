// SPDX-License-Identifier: Apache-2.0
//
// What is found and refused when a table is made, in German.
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/compensate/compensate.h"
#include "axiometry/app/compensate/compensate_options.h"
#include "axiometry/app/workbench/compensations/compensation_json.h"
#include "axiometry/base/json/json.h"
#include "axiometry/language/language.h"
#include "tests/support/repository_file.h"
#include "tests/support/series.h"

namespace axiometry::app {
namespace {

using language::Language;
using testing_support::make_series;
using Runs = std::vector<testing_support::RunDeviations>;

void expect_all_german(const std::string& message) {
  EXPECT_TRUE(language::is_known(message, Language::german)) << message;
  const std::string german = language::translated(message, Language::german, {.decimal_mark = ','});
  EXPECT_FALSE(std::regex_search(german, std::regex("[0-9]\\.[0-9]"))) << german;
}

/// A slope with a little scatter, which a table removes.
Runs sloping(double per_target, double shift) {
  Runs runs;
  for (int j = 0; j < 5; ++j) {
    testing_support::RunDeviations run;
    for (int i = 0; i < 5; ++i) run.push_back(shift + per_target * i + 0.1 * ((3 * i + 2 * j) % 5));
    runs.push_back(std::move(run));
  }
  return runs;
}

NamedTest measured(const std::vector<double>& targets, const Runs& up, const Runs& down, AxisKind kind) {
  axiometry::Test test{{}, make_series(targets, up, down), {}};
  test.metadata.axis.kind = kind;
  return {"x.csv", std::move(test)};
}

NamedTest sloping_axis(const std::vector<double>& targets, AxisKind kind = AxisKind::linear) {
  return measured(targets, sloping(7.5, 0), sloping(7.5, -4), kind);
}

const std::vector<double> quarters{0, 100, 200, 300, 400};

TEST(GermanCompensation, SaysWhatSpeaksAgainstARetest) {
  std::set<std::string> ids;
  const auto take_of = [&](MeasuredAxis axis, const CompensateRequest& request) {
    const auto made = compensate(std::move(axis), request);
    ASSERT_TRUE(made) << made.error().message;
    for (const NamedFinding& finding : made->findings) {
      expect_all_german(finding.message);
      ids.insert(finding.id);
    }
  };
  const auto take = [&](NamedTest retest, Metadata before = {}) {
    NamedTest first = sloping_axis(quarters);
    first.test.metadata = std::move(before);
    take_of({std::move(first), {}, std::move(retest)}, {.control = "linuxcnc"});
  };
  CompensateRequest turned{.control = "siemens-cec"};
  turned.table.turned_sign = true;
  take_of({measured(quarters, sloping(7.5, 0), sloping(7.5, 4), AxisKind::linear)}, turned);
  take_of({measured(quarters, sloping(7.5, 0), sloping(7.5, 4), AxisKind::linear)},
          {.control = "siemens-lec", .curves = TableCurves::with_backlash});
  take_of({sloping_axis(quarters), NamedTable{"old.comp", "-50.5 -50.5 -50.5\n450 450 450\n"}},
          {.control = "linuxcnc", .grid = {.step = 100.0}});
  EXPECT_TRUE(ids.contains("compensation-existing-cut"));
  take(sloping_axis({50, 150, 250, 350, 450}));
  take(sloping_axis(quarters));
  Metadata before;
  before.axis.name = "X";
  before.machine.name = "Mill 5";
  before.machine.serial_number = "7";
  before.conditions.date = "2026-01-02";
  NamedTest other = sloping_axis(quarters);
  other.test.metadata.axis.name = "Y";
  other.test.metadata.machine.name = "Mill 6";
  other.test.metadata.machine.serial_number = "8";
  other.test.metadata.conditions.date = "2025-12-31";
  take(std::move(other), std::move(before));
  const std::string source = testing_support::repository_file("src/axiometry/app/compensate/compensate.cpp");
  const std::regex id(R"("((?:compensation|retest)-[a-z-]+)\")");
  for (std::sregex_iterator at(source.begin(), source.end(), id), end; at != end; ++at)
    EXPECT_TRUE(ids.contains((*at)[1])) << (*at)[1];
}

TEST(GermanCompensation, SaysWhyNoTableIsMade) {
  const auto expect_refused = [](MeasuredAxis axis, CompensateRequest request, const std::string& part) {
    const auto made = compensate(std::move(axis), request);
    ASSERT_FALSE(made) << part;
    EXPECT_NE(made.error().message.find(part), std::string::npos) << made.error().message;
    expect_all_german(made.error().message);
  };
  const CompensateRequest usual{.control = "linuxcnc"};
  expect_refused({sloping_axis(quarters)}, {.control = "none"}, "no control");
  expect_refused({sloping_axis(quarters), {}, sloping_axis(quarters, AxisKind::rotary)}, usual, "another kind");
  expect_refused({measured(quarters, sloping(0, 0), sloping(0, 0), AxisKind::linear)}, usual, "no table is written");
  const Runs flat(3, {0, 0, 0, 0, 0});
  expect_refused({measured(quarters, flat, flat, AxisKind::linear)}, usual, "would not become better");
  Runs noise;
  for (int j = 0; j < 5; ++j) {
    testing_support::RunDeviations run;
    for (int i = 0; i < 5; ++i) run.push_back(9.5 * ((7 * i * i + 11 * j * (i + 3)) % 13));
    noise.push_back(std::move(run));
  }
  expect_refused({measured(quarters, noise, noise, AxisKind::linear)}, usual, "what scatter makes of them");
  const auto refused_with = [&](const std::string& old_table, CompensateRequest request, const std::string& part) {
    expect_refused({sloping_axis(quarters), NamedTable{"old.comp", old_table}}, request, part);
  };
  const std::string in_mm = "0 0 0\n400.5 400.5 400.5\n", in_inch = "0 0 0\n15.75 15.75 15.75\n";
  CompensateRequest inch = usual;
  inch.table.in_inch = true;
  refused_with(in_mm, inch, "or the unit of the existing table stated");
  refused_with(in_inch, usual, "or the unit of the existing table stated");
  refused_with("-50.5 -50.5 -50.5\n450 450 450\n", usual, "the last value held beyond the targets");
  CompensateRequest stated = usual;
  stated.existing_in_inch = true;
  expect_refused({sloping_axis(quarters)}, stated, "no such table");
  expect_refused({sloping_axis(quarters, AxisKind::rotary), NamedTable{"old.comp", in_mm}}, stated, "rotary axis");
  expect_refused({sloping_axis(quarters)}, {.control = "linuxcnc", .periodic = compensation::Periodic::leave},
                 "no period");
  expect_refused({sloping_axis(quarters)}, {.control = "linuxcnc", .curves = TableCurves::with_backlash},
                 "a curve for each direction");
  expect_refused({sloping_axis(quarters)}, {.control = "kflop", .curves = TableCurves::with_backlash},
                 "one curve alone");
  CompensateRequest turned = usual;
  turned.table.turned_sign = true;
  expect_refused({sloping_axis(quarters)}, turned, "that sign is verified");
  const auto with = [](auto&& change) {
    CompensateRequest request{.control = "fanuc"};
    change(request);
    return request;
  };
  for (const auto& [request, part] : {
           std::pair(with([](auto& r) { r.table.resolution = 0.5e5; }), "the resolution"),
           std::pair(with([](auto& r) { r.table.magnification = 5000; }), "the magnification"),
           std::pair(with([](auto& r) { r.table.largest = 100'000; }), "the largest number"),
           std::pair(with([](auto& r) { r.table.number = 100'000; }), "the number"),
           std::pair(with([](auto& r) { r.grid.step = -0.5; }), "the step"),
           std::pair(with([](auto& r) { r.period = -0.5; }), "the period"),
           std::pair(with([](auto& r) { r.control = "marlin", r.table.steps_per_unit = -0.5; }), "the steps per unit"),
       })
    expect_refused({sloping_axis(quarters)}, request, part);
}

TEST(GermanCompensation, SaysWhatIsWrongWithOptions) {
  for (const char* options : {R"({"control": 5})",
                              R"({})",
                              R"({"control": "fanuc", "axis": 5})",
                              R"({"control": "fanuc", "step": "x"})",
                              R"({"control": "fanuc", "start": "x"})",
                              R"({"control": "fanuc", "end": "x"})",
                              R"({"control": "fanuc", "points": -1})",
                              R"({"control": "fanuc", "number": -1})",
                              R"({"control": "fanuc", "reference": "x"})",
                              R"({"control": "fanuc", "resolution": "x"})",
                              R"({"control": "fanuc", "magnification": -1})",
                              R"({"control": "fanuc", "largest": -1})",
                              R"({"control": "fanuc", "steps_per_unit": "x"})",
                              R"({"control": "fanuc", "inch": 1})",
                              R"({"control": "fanuc", "smooth": 1})",
                              R"({"control": "fanuc", "hold_ends": 1})",
                              R"({"control": "fanuc", "curves": "x"})",
                              R"({"control": "fanuc", "periodic": "x"})",
                              R"({"control": "fanuc", "period": "x"})",
                              R"({"control": "fanuc", "turned_sign": 1})",
                              R"({"control": "fanuc", "existing_unit": "x"})",
                              R"({"control": "fanuc", "method": "x"})",
                              R"({"control": "fanuc", "colour": "x"})",
                              R"([])"}) {
    const auto request = compensate_request_from(json::parse(options).value());
    ASSERT_FALSE(request) << options;
    expect_all_german(request.error().message);
  }
  const auto reading = table_reading_from(json::parse(R"({"kind": "x"})").value());
  ASSERT_FALSE(reading);
  expect_all_german(reading.error().message);
}

constexpr Reader of_german{Language::german, {.decimal_mark = ','}};

TEST(GermanCompensation, ShowsWhatIsKnownOfControls) {
  const json::Value shown = controls_to_json(of_german);
  ASSERT_EQ(shown.items().size(), nc::axis_table_table().size());
  for (std::size_t k = 0; k < shown.items().size(); ++k) {
    const json::Value &german = shown.items()[k], english = control_to_json(*nc::axis_table_table()[k]);
    for (const char* key : {"title", "sign", "turned_sign", "loading", "verified", "inferred"}) {
      const std::string text(english.find(key)->text());
      EXPECT_EQ(german.find(key)->text(), language::translated(text, Language::german, of_german.numbers));
      if (text.ends_with('.')) {
        EXPECT_NE(german.find(key)->text(), text);
      }
    }
    EXPECT_EQ(german.find("id")->text(), english.find("id")->text());
  }
}

TEST(GermanCompensation, ShowsResultsAndLists) {
  const auto made = compensate({sloping_axis(quarters)}, {.control = "heidenhain", .axis = "X"});
  ASSERT_TRUE(made) << made.error().message;
  const std::string result = json::dump(to_json(MadeCompensation{present(*made, {}).json, "x", "y"}, of_german));
  for (const char* words :
       {"bewegt die Achse in negativer Richtung", "Seiten technischer Handb", "Das Vorzeichen; dass"})
    EXPECT_NE(result.find(words), std::string::npos) << words << " in " << result;
  std::vector<ListedCompensation> listed(2);
  listed[0].compensation.value.control = "fanuc";
  listed[1].compensation.value.control = "of another program";
  const std::string list = json::dump(to_json(listed, of_german));
  EXPECT_NE(list.find("Fanuc, gespeicherte Steigungsfehler, beide Richtungen gleich"), std::string::npos) << list;
  EXPECT_NE(list.find(R"("title": "of another program")"), std::string::npos) << list;
}

}  // namespace
}  // namespace axiometry::app
