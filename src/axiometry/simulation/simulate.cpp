// SPDX-License-Identifier: Apache-2.0
#include "axiometry/simulation/simulate.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "axiometry/model/simulated.h"
#include "axiometry/simulation/axis_errors.h"
#include "axiometry/simulation/instrument_errors.h"

namespace axiometry::simulation {
namespace {

/// Means and spreads of what was expected in the runs of one cell.
struct Moments {
  std::vector<double> expected;
  double variance = 0.0;  ///< of what is random, the same in every run

  ExpectedCell cell(std::size_t target, Direction direction) const {
    const auto n = static_cast<double>(expected.size());
    double mean = 0.0, squares = 0.0;
    for (const double x : expected) mean += x / n;
    for (const double x : expected) squares += (x - mean) * (x - mean);
    const double between = expected.size() > 1 ? squares / (n - 1.0) : 0.0;
    return {target, direction, expected.size(), Deviation::native(mean),
            Deviation::native(std::sqrt(variance + between))};
  }
};

TestConditions conditions_of(const Request& request) {
  const Plan& plan = request.plan;
  TestConditions c;
  c.date = plan.date.empty() ? std::string(simulated_date) : plan.date;
  c.inspector = "axiometry simulate";
  c.purpose = simulation_purpose;
  c.comment = fmt::format("Simulated, not measured{}; seed {}",
                          request.fault.empty() ? "" : fmt::format(": fault {}", request.fault), request.seed);
  c.cycle = plan.cycle;
  c.feed = plan.feed;
  c.dwell = plan.dwell;
  c.warm_up = plan.warm_up_runs == 0
                  ? "None"
                  : fmt::format("{} there and back over the measurement travel at {:g} {}/min",
                                plan.warm_up_runs == 1 ? "Once" : fmt::format("{} times", plan.warm_up_runs), plan.feed,
                                position_unit(plan.axis.kind));
  c.axes_not_under_test = "None";
  c.tool_offset_mm = {0.0, 0.0, 0.0};
  c.workpiece_offset_mm = {0.0, 0.0, 0.0};
  return c;
}

/// "X" or, of a line in space, the axes that move on it: "XZ".
std::string usual_name(const Axis& axis) {
  const auto line = spatial_line(axis);
  if (!line) return axis.kind == AxisKind::linear ? "X" : "C";
  std::string name;
  for (std::size_t k = 0; k < 3; ++k) {
    SpatialLine along{};
    along.direction[k] = line->direction[k];
    if (moving_axes(along) > 0) name += "XYZ"[k];
  }
  return name;
}

/// What the axes need to walk the plan.
std::string travels_of(const Plan& plan, std::string_view name) {
  const auto [lowest, highest] = reach(plan);
  const auto line = spatial_line(plan.axis);
  if (!line)
    return fmt::format("{} {:g} to {:g} {}", name, lowest.in_native(), highest.in_native(),
                       position_unit(plan.axis.kind));
  const Vector3 from = line->at(lowest), to = line->at(highest);
  return fmt::format("X {:g} to {:g} mm, Y {:g} to {:g} mm, Z {:g} to {:g} mm", std::min(from.x, to.x),
                     std::max(from.x, to.x), std::min(from.y, to.y), std::max(from.y, to.y), std::min(from.z, to.z),
                     std::max(from.z, to.z));
}

/// Clause 8.1, as far as a simulation has an answer.
Metadata metadata_of(const Request& request) {
  const Plan& plan = request.plan;
  const VirtualInstrument& instrument = request.axis.instrument;
  const auto expansion = instrument.expansion.value_or(VirtualInstrument::Expansion{});
  Metadata m;
  m.axis = plan.axis;
  if (m.axis.name.empty()) m.axis.name = usual_name(plan.axis);
  if (m.axis.measurement_line.empty())
    m.axis.measurement_line = is_diagonal(plan.axis) ? "Line in space, along the way of the axes, without offset"
                                                     : "In the axis of motion, without offset";
  if (m.axis.scale_type.empty()) m.axis.scale_type = "Simulated";
  if (m.axis.compensation.empty()) m.axis.compensation = "none";
  m.machine.name = plan.machine.empty() ? std::string(virtual_machine) : simulated_machine(plan.machine);
  m.machine.type = "Simulated axis";
  m.machine.axes_travel = travels_of(plan, m.axis.name);
  m.conditions = conditions_of(request);
  m.equipment = {{"Instrument", "Axiometry", "Simulated", fmt::format("seed {}", request.seed)}};
  m.nde.applied = plan.axis.kind == AxisKind::linear;
  if (plan.axis.kind == AxisKind::linear) {
    if (!m.axis.scale_expansion) m.axis.scale_expansion = expansion.machine_expansion;
    m.nde.machine_expansion = expansion.assumed_expansion;
    m.nde.routine = "Once, with the temperature of the machine";
    m.nde.datum = plan.targets.front();
  }
  m.environment.air_temperature_start = m.environment.air_temperature_end = expansion.machine;
  m.environment.air_pressure_start = m.environment.air_pressure_end = Pressure::kPa(101.325);
  m.environment.air_humidity_start = m.environment.air_humidity_end = RelativeHumidity::percent(50.0);
  m.environment.sensors = {{"machine", "Simulated", expansion.machine, expansion.machine}};
  return m;
}

}  // namespace

Result<SimulatedTest> simulate(const Request& request) {
  AXIOMETRY_TRY_VOID(check_sound(request.axis, request.plan));
  AXIOMETRY_TRY(const Timeline timeline, Timeline::make(request.plan, request.axis, request.departures));
  AXIOMETRY_TRY(const InstrumentErrors instrument,
                InstrumentErrors::make(request.axis.instrument, request.plan, timeline, request.seed));
  const AxisErrors axis(request.axis, request.plan, timeline, request.seed);
  const std::size_t m = request.plan.targets.size(), n = request.plan.runs;
  const double per_position = deviation_per_position(request.plan.axis.kind);
  std::vector<double> noise(timeline.legs().size());
  numeric::fill_normal({request.seed, stream_reading_noise, 0}, noise);

  std::vector<double> deviations(2 * m * n, std::numeric_limits<double>::quiet_NaN()), times = deviations;
  std::map<std::pair<Direction, std::size_t>, Moments> cells;
  std::vector<TrueReading> readings;
  for (std::size_t k = 0; k < timeline.legs().size(); ++k) {
    const Leg& leg = timeline.legs()[k];
    if (!leg.approach) continue;
    const Approach& a = *leg.approach;
    const double t = leg.leave;
    const double lag = timeline.following_error(leg.phases.back(), t) * per_position;
    const double truth = axis.rest(k) + axis.in_time(k, leg.to, t) - lag;
    const double measured =
        truth + (instrument.at(k, leg.to, t) + request.axis.instrument.noise.in_native() * noise[k]);
    const double shown = instrument.shown(leg.to, measured);
    readings.push_back({a, leg.extra, Duration::s(t), Deviation::native(truth), Deviation::native(shown - truth),
                        instrument.is_outlier(k)});
    if (leg.extra) continue;
    const std::size_t place = (static_cast<std::size_t>(a.direction) * m + a.target) * n + a.run;
    deviations[place] = shown;
    times[place] = t;
    Moments& cell = cells[{a.direction, a.target}];
    cell.expected.push_back(truth - axis.stick(k) - axis.hunting(k, t) + axis.stick_expected(leg));
    cell.variance = axis.variance(leg);
  }
  std::vector<ExpectedCell> expected;
  for (const auto& [place, moments] : cells) expected.push_back(moments.cell(place.second, place.first));
  AXIOMETRY_TRY(Series series, Series::make_dense(request.plan.targets, n, std::move(deviations)));
  return SimulatedTest{
      {.metadata = metadata_of(request), .series = std::move(series), .provenance = {}, .times_s = std::move(times)},
      std::move(readings),
      std::move(expected)};
}

}  // namespace axiometry::simulation
