// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "axiometry/nc/dialect.h"
#include "tests/support/nc_controls.h"

/// Programs of tours, read back by what knows each control.
namespace axiometry::nc {
namespace {

using testing_support::run_program;
using testing_support::Trace;

PointTour three_points() {
  return {{"VOLUMETRIC CALIBRATION, RUN 1 OF 12"},
          {{{100.0, 50.0, 0.0}, false},
           {{100.0, 50.0, -123.457}},
           {{-400.001, 20.25, -10.0}, false},
           {{-0.0004, 599.999, -450.5}, true, true},
           {{1.5, 2.5, -3.5}}},
          2500.0,
          Duration::s(3.0)};
}

TEST(PointTour, IsDrivenInOrderAndRestsAtItsReadingsAlone) {
  const PointTour tour = three_points();
  for (const Dialect* dialect : dialect_table())
    for (const LengthUnit unit : {LengthUnit::mm, LengthUnit::inch}) {
      SCOPED_TRACE(dialect->id);
      const auto program = dialect->write_tour(tour, {.unit = unit, .stop_at_start = true});
      ASSERT_TRUE(program) << program.error().message;
      const Trace trace = run_program(dialect->id, *program);
      EXPECT_TRUE(trace.ended);
      ASSERT_EQ(trace.visits.size(), tour.stops.size());
      for (std::size_t k = 0; k < tour.stops.size(); ++k) {
        const auto& visit = trace.visits[k];
        EXPECT_EQ(visit.named, "XYZ");
        EXPECT_NEAR(visit.at.at("X"), tour.stops[k].at_mm.x, 0.6e-4);
        EXPECT_NEAR(visit.at.at("Y"), tour.stops[k].at_mm.y, 0.6e-4);
        EXPECT_NEAR(visit.at.at("Z"), tour.stops[k].at_mm.z, 0.6e-4);
        EXPECT_NEAR(visit.feed, tour.feed_mm_per_min, 1.0);
        EXPECT_NEAR(visit.dwell_s, tour.stops[k].is_reading ? 3.0 : 0.0, 0.01);
        EXPECT_EQ(visit.stops, k == 1 || k == 3 ? 1u : 0u) << "the first reading, and where the beam was lost";
      }
    }
}

TEST(PointTour, PutsTheTriggerInTheMiddleOfTheDwell) {
  const auto program = find_dialect("fanuc")->write_tour(three_points(), {.trigger_m_code = 27});
  ASSERT_TRUE(program);
  const Trace trace = run_program("fanuc", *program);
  EXPECT_EQ(trace.visits[1].m_codes, std::vector<unsigned>{27});
  EXPECT_NEAR(trace.visits[1].dwell_before_m_code_s.at(0), 1.5, 1e-9);
  EXPECT_TRUE(trace.visits[2].m_codes.empty());
}

TEST(PointTour, IsRefusedWithoutReadingsAndBeyondTheControl) {
  for (const Dialect* dialect : dialect_table()) {
    PointTour tour = three_points();
    tour.stops[1].at_mm.x = 1e7;
    EXPECT_FALSE(dialect->write_tour(tour, {})) << dialect->id;
    tour = three_points();
    for (TourStop& stop : tour.stops) stop.is_reading = false;
    EXPECT_FALSE(dialect->write_tour(tour, {})) << dialect->id;
    EXPECT_FALSE(dialect->write_tour(three_points(), {.trigger_m_code = 30})) << dialect->id;
    tour = three_points();
    tour.feed_mm_per_min = 1e8;
    EXPECT_FALSE(dialect->write_tour(tour, {})) << dialect->id;
  }
}

}  // namespace
}  // namespace axiometry::nc
