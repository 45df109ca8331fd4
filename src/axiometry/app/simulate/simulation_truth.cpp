// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/simulate/simulation_truth.h"

#include <limits>
#include <vector>

#include "axiometry/base/contract.h"

namespace axiometry::app {
namespace {

using json::Value;

Value parameters_value(const iso230_2::AxisParameters& parameters) {
  Value value = Value::object();
  for (const auto& info : iso230_2::parameters) {
    const auto& x = parameters.*info.member;
    value.add(info.key, x ? Value(x->in_native()) : Value());
  }
  return value;
}

/// Numbers count from 1, as in the standard.
Value simulated_approach_value(const Approach& a, bool extra) {
  Value value = Value::object();
  value.add("target", a.target + 1);
  value.add("direction", a.direction == Direction::up ? "up" : "down");
  value.add("run", a.run + 1);
  if (extra) value.add("extra", true);
  return value;
}

Value readings_value(std::span<const simulation::TrueReading> readings) {
  Value list = Value::array();
  for (const auto& r : readings) {
    Value& value = list.push(simulated_approach_value(r.approach, r.extra));
    value.add("time_s", r.time.in_s());
    value.add("true", r.deviation.in_native());
    value.add("instrument", r.instrument.in_native());
    if (r.outlier) value.add("outlier", true);
  }
  return list;
}

Value expected_value(std::span<const simulation::ExpectedCell> cells) {
  Value list = Value::array();
  for (const auto& cell : cells) {
    Value& value = list.push(Value::object());
    value.add("target", cell.target + 1);
    value.add("direction", cell.direction == Direction::up ? "up" : "down");
    value.add("runs", cell.runs);
    value.add("mean", cell.mean.in_native());
    value.add("s", cell.spread.in_native());
  }
  return list;
}

Value recording_value(const SimulationRequest& request, const simulation::TrueRecording& recording) {
  Value value = Value::object();
  value.add("rate", request.recording.rate);
  value.add("duration_s", recording.duration.in_s());
  value.add("samples", recording.samples);
  value.add("lost", recording.lost);
  Value& gaps = value.add("gaps", Value::array());
  for (const simulation::Gap& gap : request.recording.gaps) {
    Value& g = gaps.push(Value::object());
    g.add("begin_s", gap.begin.in_s());
    g.add("length_s", gap.length.in_s());
  }
  value.add("drop_out", request.recording.drop_out_probability);
  Value& list = value.add("standstills", Value::array());
  for (const auto& s : recording.standstills) {
    Value& standstill = list.push(simulated_approach_value(s.approach, s.extra));
    standstill.add("begin_s", s.begin.in_s());
    standstill.add("end_s", s.end.in_s());
    standstill.add("samples", s.samples);
    standstill.add("true", s.mean ? Value(s.mean->in_native()) : Value());
  }
  return value;
}

Value departures_value(const simulation::Departures& departures) {
  Value value = Value::object();
  Value& missed = value.add("missed", Value::array());
  for (const Approach& a : departures.missed) missed.push(simulated_approach_value(a, false));
  Value& doubled = value.add("doubled", Value::array());
  for (const Approach& a : departures.doubled) doubled.push(simulated_approach_value(a, false));
  Value& reversed = value.add("reversed_runs", Value::array());
  for (const std::size_t run : departures.reversed_runs) reversed.push(run + 1);
  return value;
}

}  // namespace

iso230_2::AxisParameters true_parameters_of_test(const simulation::SimulatedTest& simulated) {
  const Series& series = simulated.test.series;
  const std::size_t m = series.target_count(), n = series.run_count();
  std::vector<double> deviations(2 * m * n, std::numeric_limits<double>::quiet_NaN());
  for (const auto& r : simulated.readings)
    if (!r.extra)
      deviations[(static_cast<std::size_t>(r.approach.direction) * m + r.approach.target) * n + r.approach.run] =
          r.deviation.in_native();
  const auto truth = Series::make_dense({series.targets().begin(), series.targets().end()}, n, std::move(deviations));
  AXIOMETRY_CONTRACT(truth.has_value());  // the same cells as the readings'
  return iso230_2::evaluate(*truth).parameters;
}

iso230_2::AxisParameters true_parameters_of_machine(const simulation::SimulatedTest& simulated) {
  const Series& series = simulated.test.series;
  std::vector<iso230_2::PositionResult> positions(series.target_count());
  std::vector<std::optional<Deviation>> s_up(positions.size()), s_down(positions.size());
  for (const auto& cell : simulated.expected) {
    iso230_2::PositionResult& p = positions[cell.target];
    const bool up = cell.direction == Direction::up;
    (up ? p.count_up : p.count_down) = cell.runs;
    (up ? p.mean_up : p.mean_down) = cell.mean;
    (up ? s_up : s_down)[cell.target] = cell.spread;
  }
  for (std::size_t i = 0; i < positions.size(); ++i) {
    iso230_2::PositionResult& p = positions[i];
    p.target = series.targets()[i];
    if (p.mean_up && p.mean_down) {
      const double up = p.mean_up->in_native(), down = p.mean_down->in_native();
      p.mean = Deviation::native((up + down) / 2.0);
      p.reversal = Deviation::native(up - down);
    }
    p = iso230_2::with_estimators(p, s_up[i], s_down[i]);
  }
  return iso230_2::evaluate_axis(positions);
}

Value truth_value(const SimulationRequest& request, const simulation::SimulatedTest& simulated,
                  const std::optional<simulation::TrueRecording>& recording) {
  const Plan& plan = request.simulate.plan;
  Value value = Value::object();
  value.add("format", "axiometry-truth/1");
  value.add("fault", request.simulate.fault);
  value.add("seed", static_cast<double>(request.simulate.seed));
  value.add("unit", deviation_unit_key(plan.axis.kind));
  value.add("target_unit", plan.axis.kind == AxisKind::linear ? "mm" : "deg");
  Value& targets = value.add("targets", Value::array());
  for (const Position p : plan.targets) targets.push(p.in_native());
  value.add("departures", departures_value(request.simulate.departures));
  value.add("this_test", parameters_value(true_parameters_of_test(simulated)));
  value.add("this_machine", parameters_value(true_parameters_of_machine(simulated)));
  value.add("expected", expected_value(simulated.expected));
  value.add("readings", readings_value(simulated.readings));
  if (recording) value.add("recording", recording_value(request, *recording));
  return value;
}

}  // namespace axiometry::app
