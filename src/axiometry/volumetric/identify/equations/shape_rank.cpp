// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/equations/shape_rank.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/volumetric/identify/curve_choice.h"
#include "axiometry/volumetric/identify/equations/linear_solution.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t judging_degree = 3;

bool holds_cubics(const CurveBasis& basis) {
  return basis.kind() == CurveKind::spline || (basis.kind() == CurveKind::legendre && basis.size() >= judging_degree);
}

/// At least the degree of polynomials that the curves are themselves.
CurveBasis judging_basis(const Problem& problem, std::size_t axis) {
  const CurveBasis& own = problem.coefficients.basis(axis);
  std::vector<double> positions;
  for (const VolumetricReading& reading : problem.readings) positions.push_back(reading.axes_mm[axis]);
  const std::size_t places = different_places(std::move(positions), judging_degree + 1);
  std::size_t degree = std::max(places, std::size_t{2}) - 1;
  if (own.kind() == CurveKind::legendre) degree = std::max(degree, own.size());
  return CurveBasis::make(CurveKind::legendre, own.lower_mm(), own.upper_mm(), degree).value();
}

Unknowns with_coefficients(Unknowns unknowns, std::size_t coefficients) {
  const auto moved = [&](std::size_t column) { return column - unknowns.coefficients + coefficients; };
  for (VirtualStation& station : unknowns.stations) station.column = moved(station.column);
  for (BeamStretch& stretch : unknowns.stretches) stretch.column = moved(stretch.column);
  unknowns.columns = moved(unknowns.columns);
  unknowns.coefficients = coefficients;
  return unknowns;
}

/// Of a sum of Legendre polynomials: its first ones, or its values at nodes.
void take_curve(const CurveBasis& from, const double* numbers, const CurveBasis& to, double* taken) {
  for (std::size_t k = 0; k < to.functions(); ++k) {
    double& own = taken[k * motion_count];
    if (to.kind() == CurveKind::legendre) {
      own = k < from.functions() ? numbers[k * motion_count] : 0.0;
      continue;
    }
    const double share = static_cast<double>(k) / static_cast<double>(to.size());
    const ActiveFunctions f = from.at(to.lower_mm() + share * (to.upper_mm() - to.lower_mm()));
    own = 0.0;
    for (std::size_t j = 0; j < f.count; ++j) own += f.values[j] * numbers[(f.first + j) * motion_count];
  }
}

std::vector<double> taken_over(const Coefficients& judging, const std::vector<double>& direction,
                               const Coefficients& own) {
  std::vector<double> raw(own.raw(), 0.0);
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      take_curve(judging.basis(a), direction.data() + judging.curve(a) + m, own.basis(a),
                 raw.data() + own.curve(a) + m);
      if (own.reversal() == Reversal::constant) raw[own.half(a) + m] = direction[judging.half(a) + m];
      if (own.reversal() == Reversal::curves)
        take_curve(judging.basis(a), direction.data() + judging.half(a) + m, own.basis(a),
                   raw.data() + own.half(a) + m);
    }
  for (std::size_t k = 0; k < squareness_names.size(); ++k)
    raw[own.squareness() + k] = direction[judging.squareness() + k];
  double squares = 0.0;
  for (const double x : raw) squares += x * x;
  for (double& x : raw) x /= std::sqrt(squares);
  return raw;
}

}  // namespace

std::vector<std::vector<double>> told_by_shape_alone(const Problem& problem, const State& state) {
  const Coefficients& own = problem.coefficients;
  if (holds_cubics(own.basis(0)) && holds_cubics(own.basis(1)) && holds_cubics(own.basis(2))) return {};
  const Coefficients judging({judging_basis(problem, 0), judging_basis(problem, 1), judging_basis(problem, 2)},
                             own.reversal());
  const Unknowns unknowns = with_coefficients(problem.unknowns, judging.raw());
  const Problem judged{problem.machine,    judging,         unknowns,       problem.readings, problem.tools_mm,
                       problem.approaches, problem.weights, problem.threads};
  State at = with_stations_joined(judged, state);
  at.coefficients.assign(judging.raw(), 0.0);
  NormalEquations equations = normal_equations(judged, sights(judged, at));
  NullDirections nulls = null_directions(judging, equations);
  std::vector<std::vector<double>> directions;
  if (nulls.empty()) return directions;
  for (const auto& direction : LinearSolution(judging, std::move(equations), std::move(nulls)).unseen())
    directions.push_back(taken_over(judging, direction, own));
  return directions;
}

}  // namespace axiometry::volumetric::detail
