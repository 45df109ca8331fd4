// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/service/caught_lengths.h"

#include <gmock/gmock.h>

namespace axiometry::app {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Rests of three seconds at five places, but for one that is too short; before it the beam is broken, and told.
CaughtLengths caught_with_break_at(std::size_t short_rest) {
  capture::StopPath path({500.0, 300.0, -100.0});
  const Vector3 places[] = {
      {100.0, 50.0, 300.0}, {700.0, 500.0, 120.0}, {250.0, 80.0, 480.0}, {900.0, 20.0, 200.0}, {400.0, 590.0, 350.0}};
  for (const Vector3 p : places) path.stop(p);
  capture::StopMatcher matcher(path.stops(), {});
  for (std::size_t k = 0; k < path.stops().size(); ++k) {
    const capture::ExpectedStop& stop = path.stops()[k];
    const double dead_path_mm = k < short_rest ? 0.0 : 77.0;
    capture::Standstill rest;
    rest.begin_s = 30.0 * static_cast<double>(k);
    rest.end_s = rest.begin_s + (k == short_rest ? 0.5 : 3.0);
    rest.position = Position::native(stop.distance_mm() + dead_path_mm);
    rest.arrival = stop.arrival;
    rest.lowest = Position::native(stop.lowest_mm + dead_path_mm);
    rest.highest = Position::native(stop.highest_mm + dead_path_mm);
    rest.after_gap = k == short_rest;
    matcher.take(rest);
  }
  return caught_lengths(matcher);
}

std::vector<std::size_t> stops_of(const CaughtLengths& caught, bool beginning_a_segment) {
  std::vector<std::size_t> stops;
  for (const CaughtLength& length : caught.lengths)
    if (!beginning_a_segment || length.begins_segment) stops.push_back(length.stop);
  return stops;
}

TEST(CaughtLengths, HaveAnotherDeadPathBehindABreakAlsoWhereTheFirstRestWasTooShort) {
  const CaughtLengths caught = caught_with_break_at(2);
  EXPECT_THAT(stops_of(caught, false), ElementsAre(0u, 1u, 3u, 4u));
  EXPECT_THAT(stops_of(caught, true), ElementsAre(3u));
  EXPECT_THAT(caught.broken_before, ElementsAre(2u));
}

TEST(CaughtLengths, BeginNoSegmentWithTheFirst) {
  const CaughtLengths caught = caught_with_break_at(0);
  EXPECT_THAT(stops_of(caught, false), ElementsAre(1u, 2u, 3u, 4u));
  EXPECT_THAT(stops_of(caught, true), IsEmpty());
  EXPECT_THAT(caught.broken_before, IsEmpty());
}

}  // namespace
}  // namespace axiometry::app
