// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "axiometry/report/figures/figure_rules_test_support.h"
#include "axiometry/report/tracking.h"

namespace axiometry::report {
namespace {

using testing::all_words;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

std::vector<LocationPoint> measured(Vector3 station) {
  std::vector<LocationPoint> points;
  for (const Vector3 p : {Vector3{100, 100, 300}, Vector3{900, 150, 100}, Vector3{850, 550, 400}, Vector3{120, 500, 50},
                          Vector3{500, 350, 450}, Vector3{300, 50, 20}, Vector3{700, 400, 200}})
    points.push_back({p, distance(p, station)});
  return points;
}

std::vector<std::string> figure_words(const Document& document) {
  std::vector<std::string> words;
  for (const Section& section : document.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block)) std::ranges::copy(all_words(*figure), back_inserter(words));
  return words;
}

std::size_t index_of(const Document& document, std::string_view id) {
  return static_cast<std::size_t>(std::ranges::find(document.sections, id, &Section::id) - document.sections.begin());
}

TEST(StationDocument, TellsFindingsBeforeThePictureAndCallsBeamsBeams) {
  const auto points = measured({480, 310, -250});
  const tracking::StationOptions options;
  const auto location = tracking::locate_station(points, options);
  ASSERT_TRUE(location) << location.error().to_string();
  const Document document = compose(StationSubject{points, *location, options, "points.csv", ""}, {});
  EXPECT_LT(index_of(document, "findings"), index_of(document, "figures"));
  EXPECT_LT(index_of(document, "figures"), document.sections.size());
  EXPECT_THAT(figure_words(document), Contains(HasSubstr("beam")));
  EXPECT_THAT(figure_words(document), Not(Contains(HasSubstr("diagonal"))));
}

TEST(StationDocument, ShowsPointsOfTheWholeMeasurement) {
  const Vector3 station{480, 310, -250};
  std::vector<LocationPoint> points;
  for (int k = 0; k < 900; ++k) {
    const Vector3 p{k * 1.0, k * 331 % 600 * 1.0, k * 173 % 500 * 1.0};
    points.push_back({p, distance(p, station)});
  }
  const tracking::StationOptions options;
  const auto location = tracking::locate_station(points, options);
  ASSERT_TRUE(location) << location.error().to_string();
  std::ptrdiff_t discs = 0;
  const Document document = compose(StationSubject{points, *location, options, "points.csv", ""}, {});
  for (const Section& section : document.sections)
    for (const Block& block : section.blocks)
      if (const auto* figure = std::get_if<Figure>(&block))
        discs +=
            std::ranges::count_if(figure->operations, [](const Operation& o) { return holds_alternative<Disc>(o); });
  EXPECT_GE(discs, 4 * 900);  // in each of four views
}

TEST(StationDocument, OfAPlanSaysForWhichSetUpThePointsWereChosen) {
  TrackingSetup setup;
  setup.travel = {{0, 0, 0}, {1000, 600, 500}};
  setup.tool_offset_mm = {0, 0, -150};
  setup.station.position_mm = {480, 310, -250};
  const auto plan = tracking::plan_location(setup, 6);
  ASSERT_TRUE(plan) << plan.error().to_string();
  const Document document = compose(LocationPlanSubject{setup, *plan}, {});
  std::string facts;
  for (const Block& block : document.sections.front().blocks)
    if (const auto* list = std::get_if<Facts>(&block))
      for (const Fact& fact : list->facts) facts += plain_text(fact.name) + ": " + plain_text(fact.value.text) + "\n";
  EXPECT_THAT(facts, HasSubstr("Station, about: X 480.000, Y 310.000, Z −250.000 mm"));
  EXPECT_THAT(facts, HasSubstr("The reflector looks along: (0, 0, −1), up to 60° aside"));
}

}  // namespace
}  // namespace axiometry::report
