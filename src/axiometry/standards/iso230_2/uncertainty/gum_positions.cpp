// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: x̄_i↑ and x̄_i↓ may be correlated by less than 1; the noise of known size takes the place
// of s where this test is the measurand; u[c_e] has the unit that K per metre gives it.
#include <cmath>

#include "axiometry/standards/iso230_2/uncertainty/gum_model.h"

namespace axiometry::iso230_2 {
namespace {

/// What eq. 8 needs at one target in one direction.
struct Cell {
  std::size_t target = 0;
  double position_m = 0.0;         // p_n
  double actual_position_m = 0.0;  // p_m: as read, before any correction for expansion
  double s = 0.0;
  std::size_t n = 0;
  Direction direction = Direction::up;
};

/// The squares of Table 5's columns as they are added up.
struct Squares {
  double approaches = 0.0;
  double thermal = 0.0;
  double alignment = 0.0;
  double axis_resolution = 0.0;
  double instrument = 0.0;
  double other = 0.0;

  double& of(const UncertaintyInput& input) {
    if (input.key == "axis_resolution") return axis_resolution;
    if (input.key == "instrument_resolution" || input.key == "device" || input.key == "device_constant" ||
        input.key == "environment" || input.effect == Effect::station)
      return instrument;
    return other;
  }
};

/// What the environment does to the mean of a cell. Shapes along the time of the test move its readings together.
double of_environment(const GumModel& model, const Series& series, const Cell& cell) {
  const auto n = static_cast<double>(cell.n);
  const std::size_t runs = series.run_count();
  const std::size_t first = (static_cast<std::size_t>(cell.direction) * series.target_count() + cell.target) * runs;
  const auto readings = series.cell(cell.target, cell.direction);
  WeightedReadings sum{{}, model.takes_scatter(cell.n) ? 0.0 : 1.0 / std::sqrt(n)};
  for (std::size_t j = 0; j < runs; ++j)
    if (!std::isnan(readings[j])) sum.terms.push_back({first + j, 1.0 / n});
  return model.environment->of(sum);
}

/// Inputs that act as numbers of their own, not through a factor. Alike those of noise: u/√n of n readings.
void add_inputs(Squares& squares, ComponentSum& sum, const GumModel& model, const Series& series, const Cell& cell) {
  for (std::size_t k = 0; k < model.inputs.inputs.size(); ++k) {
    const UncertaintyInput& input = model.inputs.inputs[k];
    Component part = model.components[k];
    switch (input.effect) {
      case Effect::scale: part.u *= std::abs(cell.position_m); break;
      case Effect::station:
        part.u = model.station ? model.station->sd_mm2[k] * std::abs(model.station->sensitivity(cell.target)) : 0.0;
        break;
      // A mean deviation is a displacement from the place where the instrument was set to zero.
      case Effect::displacement:
      case Effect::target:
      case Effect::target_direction: break;
      case Effect::run:
      case Effect::reading:
        if (input.key == "environmental_variation")
          part.u = of_environment(model, series, cell);
        else
          part.u = model.takes_scatter(cell.n) ? 0.0 : part.u / std::sqrt(static_cast<double>(cell.n));
        squares.approaches += part.u * part.u;
        sum.add(part);
        continue;
      default: continue;
    }
    squares.of(input) += part.u * part.u;
    sum.add(part);
  }
  if (!model.station) return;
  const double mean = model.station->mean_error(cell.target);
  squares.instrument += mean * mean;
  sum.add({std::abs(mean), infinite});
}

PositionComponents components(const GumModel& model, const Series& series, const Cell& cell) {
  const double f_t = model.thermal_factor();
  const double f_a = model.alignment_factor();
  const double p_m = std::abs(cell.actual_position_m);
  Squares squares;
  ComponentSum sum;
  if (model.takes_scatter(cell.n)) {
    const double n = static_cast<double>(cell.n);
    const double f_t_of_s = model.expansion_in_readings ? f_t : 1.0;  // otherwise s contains it already
    const double u = f_t_of_s * f_a * cell.s / std::sqrt(n);
    squares.approaches = u * u;
    sum.add({u, n - 1.0});
  }
  for (const auto* factor : {&model.machine_thermal, &model.device_thermal}) {
    if (!*factor) continue;
    const double u = f_a * p_m * (*factor)->u;
    squares.thermal += u * u;
    sum.add({u, infinite});
  }
  if (model.alignment) {
    const double u = f_t * p_m * model.alignment->u;
    squares.alignment = u * u;
    sum.add({u, infinite});
  }
  add_inputs(squares, sum, model, series, cell);
  const auto root = [](double square) { return Deviation::native(std::sqrt(square)); };
  return {root(squares.approaches), root(squares.thermal), root(squares.alignment), root(squares.axis_resolution),
          root(squares.instrument), root(squares.other),   sum.expanded()};
}

std::optional<PositionComponents> components(const GumModel& model, const Series& series, const PositionResult& p,
                                             std::size_t target, Direction direction) {
  const bool up = direction == Direction::up;
  const auto& mean = up ? p.mean_up : p.mean_down;
  const auto& s = up ? p.s_up : p.s_down;
  if (!mean) return std::nullopt;
  const double p_n = p.target.in_native() / mm_per_m;
  const double read = p_n + mean->in_native() * 1e-6;
  return components(model, series,
                    {target, p_n, model.expansion_in_readings ? read : read / model.thermal_factor(),
                     s ? s->in_native() : 0.0, up ? p.count_up : p.count_down, direction});
}

/// Eq. 10 with r. Where r is not 0 the components of ↑ and ↓ are not independent.
ExpandedUncertainty mean_of(const ExpandedUncertainty& up, const ExpandedUncertainty& down, double r) {
  const double a = up.u.in_native() / 2.0;
  const double b = down.u.in_native() / 2.0;
  const auto nu = [](const ExpandedUncertainty& x) { return x.effective_degrees_of_freedom.value_or(infinite); };
  if (r == 0.0) {
    ComponentSum sum;
    sum.add({a, nu(up)});
    sum.add({b, nu(down)});
    return sum.expanded();
  }
  ExpandedUncertainty result;
  // (a − b)² + 2 (1 + r) a b: no cancellation at r = −1
  const double u = std::sqrt((a - b) * (a - b) + 2.0 * (1.0 + r) * a * b);
  result.u = Deviation::native(u);
  result.U = Deviation::native(result.k * u);
  if (std::isfinite(nu(up)) || std::isfinite(nu(down))) result.coverage = Coverage::correlated;
  return result;
}

}  // namespace

std::vector<PositionUncertainty> propagate_positions(const GumModel& model, const Series& series,
                                                     const Evaluation& evaluation) {
  std::vector<PositionUncertainty> positions;
  for (const PositionResult& p : evaluation.positions) {
    PositionUncertainty& row = positions.emplace_back();
    row.target = p.target;
    const std::size_t i = positions.size() - 1;
    row.up = components(model, series, p, i, Direction::up);
    row.down = components(model, series, p, i, Direction::down);
    if (row.up && row.down) row.mean = mean_of(row.up->total, row.down->total, model.inputs.up_down_correlation);
  }
  return positions;
}

}  // namespace axiometry::iso230_2
