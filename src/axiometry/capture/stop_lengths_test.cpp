// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/stop_lengths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "tests/support/cpu_time.h"
#include "tests/support/made_up_lengths.h"

namespace axiometry::capture {
namespace {

using testing_support::MadeUpLengths;
using Places = std::vector<MadeUpLengths::Place>;

constexpr double rest_s = 2.0;

/// Points of a volume in an order that nobody chose, as a volumetric calibration has them.
std::vector<Vector3> volume_points(std::size_t count, unsigned seed = 5) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> x(0.0, 1000.0), y(0.0, 600.0), z(100.0, 500.0);
  std::vector<Vector3> points;
  for (std::size_t k = 0; k < count; ++k) points.push_back({x(random), y(random), z(random)});
  return points;
}

Places places_of(const std::vector<Vector3>& points) {
  Places places;
  for (const Vector3 p : points) places.push_back({p, rest_s});
  return places;
}

std::vector<ExpectedStop> stops_at(const std::vector<Vector3>& points, Vector3 station) {
  StopPath path(station);
  for (const Vector3 p : points) path.stop(p);
  return path.stops();
}

StopOptions options() { return {.drive = {.feed = 3000.0, .dwell = Duration::s(rest_s)}, .matcher = {}}; }

Result<StopLengths> listen(const MadeUpLengths& run, const Places& places, const std::vector<Vector3>& points,
                           Vector3 station_error = {2.0, -1.5, 1.0}) {
  return lengths_at_stops(run.record(places), stops_at(points, run.station_mm + station_error), options());
}

/// Every length is the true distance but for the dead path of its segment, and the stops without one are these.
void expect_lengths(const StopLengths& lengths, const MadeUpLengths& run, const std::vector<Vector3>& points,
                    const std::vector<std::size_t>& lacking = {}) {
  std::map<std::size_t, double> dead_paths;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto& length = lengths.stops[k].length;
    EXPECT_EQ(!length.has_value(), std::ranges::find(lacking, k) != lacking.end())
        << "stop " << k << ", " << lack_name(lengths.stops[k].lack);
    if (!length) continue;
    const double dead_path = run.sign * distance(points[k], run.station_mm) - length->length_mm;
    const double known = dead_paths.emplace(length->segment, dead_path).first->second;
    EXPECT_NEAR(dead_path, known, 5.0 * run.noise / 10.0 + 1e-6) << "stop " << k;
    EXPECT_NEAR(length->scatter_mm, run.noise, 0.2 * run.noise);
    EXPECT_GT(length->samples, static_cast<std::size_t>(0.8 * run.rate_hz));
  }
}

TEST(StopLengths, FindsEveryStopOfAVolumeFromARoughStation) {
  const auto points = volume_points(60);
  MadeUpLengths run;
  const auto lengths = listen(run, places_of(points), points);
  ASSERT_TRUE(lengths) << lengths.error().message;
  expect_lengths(*lengths, run, points);
  EXPECT_TRUE(lengths->segments.empty());
  EXPECT_TRUE(lengths->unused.empty());
  for (std::size_t k = 1; k < points.size(); ++k)
    EXPECT_GT(lengths->stops[k].length->time_s, lengths->stops[k - 1].length->time_s + rest_s);
}

TEST(StopLengths, OneLostStopShiftsNoOther) {
  const auto points = volume_points(25);
  for (std::size_t lost = 0; lost < points.size(); ++lost) {
    SCOPED_TRACE(lost);
    MadeUpLengths run;
    Places places = places_of(points);
    places[lost].rest_s = 0.0;
    const auto lengths = listen(run, places, points);
    ASSERT_TRUE(lengths) << lengths.error().message;
    expect_lengths(*lengths, run, points, {lost});
    EXPECT_NE(lengths->stops[lost].lack, StopLack::ambiguous);
  }
}

TEST(StopLengths, TellsAStopThatWasTooShort) {
  const auto points = volume_points(20);
  MadeUpLengths run;
  Places places = places_of(points);
  places[7].rest_s = 0.8;
  const auto lengths = listen(run, places, points);
  ASSERT_TRUE(lengths) << lengths.error().message;
  expect_lengths(*lengths, run, points, {7});
  EXPECT_EQ(lengths->stops[7].lack, StopLack::too_short);
}

TEST(StopLengths, PassesOverAStopThatIsNone) {
  const auto points = volume_points(20);
  for (std::size_t before = 1; before < points.size(); ++before) {
    SCOPED_TRACE(before);
    MadeUpLengths run;
    Places places = places_of(points);
    places.insert(places.begin() + static_cast<std::ptrdiff_t>(before),
                  {0.3 * points[before - 1] + 0.7 * points[before] + Vector3{40.0, 30.0, 20.0}, 3.0});
    const auto lengths = listen(run, places, points);
    ASSERT_TRUE(lengths) << lengths.error().message;
    expect_lengths(*lengths, run, points);
    EXPECT_EQ(lengths->unused.size(), 1u);
  }
}

TEST(StopLengths, KeepsTheFirstOfTwoRestsAtOnePoint) {
  const auto points = volume_points(20);
  MadeUpLengths run;
  run.drift_per_s = 0.00001;
  Places places = places_of(points);
  places.insert(places.begin() + 9, {points[8] + Vector3{0.2, 0.1, 0.0}, 0.0});  // jogged a little and back
  places.insert(places.begin() + 10, {points[8], rest_s});
  const auto recorded = run.record(places);
  const auto lengths = lengths_at_stops(recorded, stops_at(points, run.station_mm), options());
  ASSERT_TRUE(lengths) << lengths.error().message;
  EXPECT_EQ(lengths->found(), points.size());
  ASSERT_EQ(lengths->unused.size(), 1u);
  EXPECT_GT(lengths->unused.front().begin_s, lengths->stops[8].length->time_s);
}

TEST(StopLengths, BeginsASegmentWhereTheBeamWasBrokenWithAndWithoutMissingSamples) {
  const auto points = volume_points(30);
  for (const bool silent : {true, false}) {
    SCOPED_TRACE(silent);
    MadeUpLengths run;
    run.broken = {{12, {83.0, silent}}, {21, {-0.9, true}}};
    const auto lengths = listen(run, places_of(points), points);
    ASSERT_TRUE(lengths) << lengths.error().message;
    expect_lengths(*lengths, run, points);
    ASSERT_EQ(lengths->segments.size(), 2u);
    EXPECT_EQ(lengths->segments[0].stop, 12u);
    EXPECT_EQ(lengths->segments[1].stop, 21u);
    EXPECT_EQ(lengths->stops[11].length->segment, 0u);
    EXPECT_EQ(lengths->stops[12].length->segment, 1u);
    EXPECT_EQ(lengths->stops[29].length->segment, 2u);
  }
}

/// Steps of some millimetres, as of a line.
std::vector<Vector3> near_points(std::size_t count) {
  std::vector<Vector3> points;
  for (std::size_t k = 0; k < count; ++k)
    points.push_back(Vector3{60.0, 40.0, 500.0} + static_cast<double>(k) * Vector3{7.0, 3.0, -2.0});
  return points;
}

/// When the reflector comes to rest at a stop.
double arrival_s(const MadeUpLengths& run, const std::vector<Vector3>& points, std::size_t stop) {
  double time_s = 1.5;
  for (std::size_t k = 0; k <= stop; ++k)
    time_s += (k > 0 ? rest_s : 0.0) + 1.5 * distance(k > 0 ? points[k - 1] : run.home_mm, points[k]) / run.speed;
  return time_s;
}

struct Lost {
  double from_s = 0.0;
  double to_s = 0.0;
  double jump_mm = 0.0;  ///< of all behind it
};

std::vector<Sample> with_lost(std::vector<Sample> samples, const Lost& lost) {
  std::erase_if(samples, [&](const Sample& s) { return s.time_s > lost.from_s && s.time_s < lost.to_s; });
  for (Sample& s : samples)
    if (s.time_s > lost.from_s) s.position += lost.jump_mm;
  return samples;
}

/// A quarter of a second from stop to stop: samples of 0.3 s are missing, and what was shown before tells nothing of
/// what is shown then. 0.3 mm are less than a machine may be off.
TEST(StopLengths, BeginsASegmentWhereSamplesOfAShortWayAreMissing) {
  const auto points = near_points(20);
  for (const double jump_mm : {0.3, -0.3, 3.0, 0.0})
    for (const double rate_hz : {100.0, 200.0, 1000.0}) {
      SCOPED_TRACE(fmt::format("{} mm at {} Hz", jump_mm, rate_hz));
      MadeUpLengths run;
      run.rate_hz = rate_hz;
      const double at_s = arrival_s(run, points, 8);
      const auto recorded = with_lost(run.record(places_of(points)), {at_s - 0.28, at_s + 0.02, jump_mm});
      const auto lengths = lengths_at_stops(recorded, stops_at(points, run.station_mm), options());
      ASSERT_TRUE(lengths) << lengths.error().message;
      EXPECT_EQ(lengths->found(), points.size());
      ASSERT_EQ(lengths->segments.size(), 1u);
      EXPECT_EQ(lengths->segments[0].stop, 8u);
      EXPECT_FALSE(lengths->segments[0].untold);
      std::map<std::size_t, double> dead_paths;
      for (std::size_t k = 0; k < points.size(); ++k) {
        const double dead_path = distance(points[k], run.station_mm) - lengths->stops[k].length->length_mm;
        EXPECT_NEAR(dead_path, dead_paths.emplace(lengths->stops[k].length->segment, dead_path).first->second, 0.001);
      }
    }
}

TEST(StopLengths, GoesOnWhereSamplesAreMissingWhileTheReflectorRests) {
  const auto points = near_points(20);
  MadeUpLengths run;
  const double at_s = arrival_s(run, points, 8);
  const auto recorded = run.record(places_of(points));
  const auto goes_on =
      lengths_at_stops(with_lost(recorded, {at_s + 1.2, at_s + 1.5, 0.0}), stops_at(points, run.station_mm), options());
  ASSERT_TRUE(goes_on) << goes_on.error().message;
  EXPECT_EQ(goes_on->found(), points.size());
  EXPECT_TRUE(goes_on->segments.empty());
  const auto broken =
      lengths_at_stops(with_lost(recorded, {at_s + 1.2, at_s + 1.5, 0.3}), stops_at(points, run.station_mm), options());
  ASSERT_TRUE(broken) << broken.error().message;
  ASSERT_EQ(broken->segments.size(), 1u);
  EXPECT_EQ(broken->segments[0].stop, 9u);
  EXPECT_TRUE(broken->stops[8].length.has_value());
}

TEST(StopLengths, FindsABreakThatOnlyTheLengthsTell) {
  const auto points = volume_points(30);
  MadeUpLengths run;
  run.rate_hz = 50.0;  // a sample every 20 ms: a jump of 9 mm may be a motion
  run.broken = {{12, {9.0, false}}};
  const auto lengths = listen(run, places_of(points), points, {});
  ASSERT_TRUE(lengths) << lengths.error().message;
  ASSERT_EQ(lengths->segments.size(), 1u);
  EXPECT_EQ(lengths->segments[0].stop, 12u);
  EXPECT_EQ(lengths->found(), points.size());
}

TEST(StopLengths, LearnsTheStationAndSeesSmallerJumpsThenAndTellsStopsApart) {
  auto points = volume_points(60);
  MadeUpLengths run;
  run.broken = {{25, {1.6, false}}};  // far less than what a station that is 2.7 mm off makes of changes of length
  const auto broken = listen(run, places_of(points), points);
  ASSERT_TRUE(broken) << broken.error().message;
  expect_lengths(*broken, run, points);
  ASSERT_EQ(broken->segments.size(), 1u);
  EXPECT_EQ(broken->segments[0].stop, 25u);
  EXPECT_TRUE(broken->segments[0].untold);
  // 3 mm nearer to the station than the point before, which is missed.
  run.broken = {};
  const Vector3 beam = points[9] - run.station_mm;
  points[10] = run.station_mm + (norm(beam) - 3.0) * unit(beam + 200.0 * unit(cross(beam, {0.0, 0.0, 1.0})));
  Places places = places_of(points);
  places.erase(places.begin() + 9);
  const auto lengths = listen(run, places, points);
  ASSERT_TRUE(lengths) << lengths.error().message;
  expect_lengths(*lengths, run, points, {9});
}

TEST(StopLengths, SurvivesAllOfItAtOnce) {
  const auto points = volume_points(300, 11);
  MadeUpLengths run;
  run.noise = 0.002;
  run.drift_per_s = 2e-6;
  run.broken = {{50, {20.0, true}}, {120, {-400.0, false}}, {200, {0.2, true}}};
  Places places = places_of(points);
  for (const std::size_t lost : {3u, 70u, 71u, 72u, 199u, 299u}) places[lost].rest_s = 0.0;
  const auto lengths = listen(run, places, points);
  ASSERT_TRUE(lengths) << lengths.error().message;
  for (std::size_t k = 0; k < points.size(); ++k)
    EXPECT_EQ(lengths->stops[k].length.has_value(), places[k].rest_s > 0.0) << "stop " << k;
}

TEST(StopLengths, CountsTheOtherWayWhereThatIsSaid) {
  const auto points = volume_points(20);
  MadeUpLengths run;
  run.sign = -1.0;
  StopOptions turned = options();
  turned.matcher.reversed = true;
  const auto recorded = run.record(places_of(points));
  const auto lengths = lengths_at_stops(recorded, stops_at(points, run.station_mm), turned);
  ASSERT_TRUE(lengths) << lengths.error().message;
  expect_lengths(*lengths, run, points);
  const auto wrong = lengths_at_stops(recorded, stops_at(points, run.station_mm), options());
  ASSERT_FALSE(wrong);
  EXPECT_NE(wrong.error().message.find("the instrument counts the other way"), std::string::npos);
}

TEST(StopLengths, RefusesTheRecordingOfAnotherPlan) {
  const auto lengths = listen(MadeUpLengths{}, places_of(volume_points(40, 5)), volume_points(40, 6));
  ASSERT_FALSE(lengths);
  EXPECT_NE(lengths.error().message.find("another plan"), std::string::npos);
}

TEST(StopLengths, GivesNoLengthToEitherOfTwoStopsThatItMayBelongTo) {
  auto points = volume_points(20);
  const MadeUpLengths run;
  // As far from the station as the point before, 60 mm beside it.
  const Vector3 beam = points[9] - run.station_mm;
  const Vector3 aside = beam + 60.0 * unit(cross(beam, {0.0, 0.0, 1.0}));
  points[10] = run.station_mm + norm(beam) * unit(aside);
  Places places = places_of(points);
  places.erase(places.begin() + 9);
  const auto lengths = listen(run, places, points);
  ASSERT_TRUE(lengths) << lengths.error().message;
  EXPECT_FALSE(lengths->stops[9].length);
  EXPECT_FALSE(lengths->stops[10].length);
  EXPECT_TRUE(lengths->stops[9].lack == StopLack::ambiguous || lengths->stops[10].lack == StopLack::ambiguous);
}

/// A plan of one station and then another, of a recording that lost so many of the first stops of the second.
Result<StopLengths> lengths_of_two_stations(std::size_t lost) {
  const auto points = volume_points(30);
  MadeUpLengths first, second;
  second.station_mm = {-200.0, 700.0, 50.0};
  auto samples = first.record(places_of(points));
  const double later = samples.back().time_s + 600.0;
  const Places places = places_of({points.begin() + static_cast<std::ptrdiff_t>(lost), points.end()});
  constexpr double under_way_s = 2.0;  // no rest before, which might be the stop that was lost
  for (Sample s : second.record(places))
    if (s.time_s > under_way_s) samples.push_back({s.time_s + later, s.position});
  StopPath path(first.station_mm);
  for (const Vector3 p : points) path.stop(p);
  path.begin_segment(second.station_mm + Vector3{1.0, 1.0, 1.0});
  for (const Vector3 p : points) path.stop(p);
  return lengths_at_stops(samples, path.stops(), options());
}

TEST(StopLengths, GoesOnWithAnotherStationAndTool) {
  const auto lengths = lengths_of_two_stations(0);
  ASSERT_TRUE(lengths) << lengths.error().message;
  EXPECT_EQ(lengths->found(), 60u);
  ASSERT_EQ(lengths->segments.size(), 1u);
  EXPECT_EQ(lengths->segments[0].stop, 30u);
  EXPECT_FALSE(lengths->segments[0].untold);
  EXPECT_TRUE(lengths->segments[0].planned);
}

TEST(StopLengths, ThatAreOfAnotherStationHaveNoBrokenBeamWhereItsFirstStopWasMissed) {
  const auto lengths = lengths_of_two_stations(1);
  ASSERT_TRUE(lengths) << lengths.error().message;
  EXPECT_FALSE(lengths->stops[30].length);
  ASSERT_EQ(lengths->segments.size(), 1u);
  EXPECT_EQ(lengths->segments[0].stop, 31u);
  EXPECT_TRUE(lengths->segments[0].planned);
}

TEST(StopLengths, IsTheSameHoweverTheRecordingIsCut) {
  const auto points = volume_points(12);
  MadeUpLengths run;
  run.broken = {{5, {70.0, false}}};
  auto samples = run.record(places_of(points));
  for (std::size_t k = 40; k < samples.size(); k += 97) samples[k].position += 500.0;  // false samples
  const auto stops = stops_at(points, run.station_mm);
  const auto whole = lengths_at_stops(samples, stops, options());
  ASSERT_TRUE(whole) << whole.error().message;
  EXPECT_EQ(whole->found(), points.size());
  for (const std::size_t piece : {1u, 2u, 3u, 7u, 1000u}) {
    StopListener listener(stops, options());
    for (std::size_t k = 0; k < samples.size(); k += piece)
      listener.push(std::span(samples).subspan(k, std::min(piece, samples.size() - k)));
    listener.interrupt();
    const auto cut = listener.lengths();
    ASSERT_TRUE(cut) << cut.error().message;
    for (std::size_t k = 0; k < points.size(); ++k) {
      ASSERT_TRUE(cut->stops[k].length);
      EXPECT_EQ(cut->stops[k].length->length_mm, whole->stops[k].length->length_mm);
      EXPECT_EQ(cut->stops[k].length->segment, whole->stops[k].length->segment);
    }
  }
}

/// Seconds that so many standstills take, some of them none of the list.
double seconds_for(std::size_t stops) {
  std::vector<Vector3> points = volume_points(stops, 3);
  StopMatcherOptions of_matcher;
  StopPath path({500.0, 300.0, -100.0});
  for (const Vector3 p : points) path.stop(p);
  StopMatcher matcher(path.stops(), of_matcher);
  const double begun = testing_support::cpu_seconds();
  for (std::size_t k = 0; k < points.size(); ++k) {
    Standstill s;
    s.begin_s = 6.0 * static_cast<double>(k);
    s.end_s = s.begin_s + 3.0;
    s.position = Position::native(path.stops()[k].distance_mm() + (k % 10 == 9 ? 77.0 : 0.0));
    s.lowest = Position::native(path.stops()[k].lowest_mm);
    s.highest = Position::native(path.stops()[k].highest_mm);
    s.after_gap = k % 100 == 0;
    matcher.take(s);
  }
  EXPECT_GT(matcher.matched(), stops / 2);
  return testing_support::cpu_seconds() - begun;
}

TEST(StopLengths, TakeTimeInProportionToTheStandstills) {
  const double few = seconds_for(2'000), many = seconds_for(20'000);
  EXPECT_LT(many, 30.0 * few + 0.2) << few;
}

TEST(StopMatcher, KnowsWhichRestsGiveALength) {
  const StopMatcher matcher(stops_at(volume_points(3), {}), {.shortest = Duration::s(1.0)});
  Standstill rest{.begin_s = 2.0, .end_s = 3.5};
  EXPECT_TRUE(matcher.gives_length(rest));
  rest.frozen_from_s = 2.5;
  EXPECT_FALSE(matcher.gives_length(rest)) << "a capture that waits for all lengths is not over";
  rest = {.begin_s = 2.0, .end_s = 2.9};
  EXPECT_FALSE(matcher.gives_length(rest));
}

/// The beam is lost on the way to a stop, near it; the length stands still until it is found again, at the stop behind.
TEST(StopLengths, HasNoLengthOfAStopWhereItFrozeAndJumped) {
  const auto points = volume_points(30);
  MadeUpLengths run;
  auto samples = run.record(places_of(points));
  const auto plain = listen(run, places_of(points), points);
  ASSERT_TRUE(plain && plain->stops[12].length);
  const double rest_at_s = plain->stops[12].length->time_s, next_at_s = plain->stops[13].length->time_s;
  const auto first = std::ranges::lower_bound(samples, rest_at_s, {}, &Sample::time_s);
  for (auto s = first; s->time_s < next_at_s - 0.9 * rest_s / 2.0; ++s) s->position = first->position;
  const auto lengths = lengths_at_stops(samples, stops_at(points, run.station_mm), options());
  ASSERT_TRUE(lengths) << lengths.error().message;
  EXPECT_EQ(lengths->found(), points.size() - 1);
  EXPECT_FALSE(lengths->stops[12].length);
  EXPECT_EQ(lengths->stops[12].lack, StopLack::signal_lost) << lack_name(lengths->stops[12].lack);
  ASSERT_EQ(lengths->segments.size(), 1u);
  EXPECT_EQ(lengths->segments[0].stop, 13u);
}

}  // namespace
}  // namespace axiometry::capture
