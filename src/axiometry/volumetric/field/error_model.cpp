// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/error_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/base/contract.h"

namespace axiometry::volumetric {

ErrorModel::ErrorModel(Parts parts) : parts_(std::move(parts)) {
  const std::size_t n = parts_.coefficients.raw();
  AXIOMETRY_CONTRACT(parts_.values.size() == n && parts_.covariance.size() == n * n);
}

bool ErrorModel::is_told(const BeamRow& row) const {
  const double limit = told_most * std::sqrt(row.squares());
  return std::ranges::all_of(
      parts_.unseen, [&](const std::vector<double>& direction) { return std::abs(row.times(direction)) <= limit; });
}

std::optional<Estimate> ErrorModel::estimate(const BeamRow& row) const {
  if (!is_told(row)) return std::nullopt;
  const double variance = quadratic(row, parts_.covariance, parts_.coefficients.raw(), row);
  return Estimate{row.times(parts_.values), std::sqrt(std::max(0.0, variance))};
}

std::optional<Estimate> ErrorModel::motion(ErrorMotion error, double position_mm, double approach) const {
  const Coefficients& c = parts_.coefficients;
  std::vector<std::pair<std::size_t, double>> row;
  const ActiveFunctions f = c.basis(error.axis).at(position_mm);
  const auto place = [&](std::size_t begin, std::size_t k) { return begin + k * motion_count + error.motion; };
  for (std::size_t k = 0; k < f.count; ++k) row.emplace_back(place(c.curve(error.axis), f.first + k), f.values[k]);
  if (approach != 0.0 && c.reversal() == Reversal::constant) row.emplace_back(place(c.half(error.axis), 0), approach);
  if (approach != 0.0 && c.reversal() == Reversal::curves)
    for (std::size_t k = 0; k < f.count; ++k)
      row.emplace_back(place(c.half(error.axis), f.first + k), approach * f.values[k]);
  return estimate(row);
}

std::optional<Estimate> ErrorModel::estimate(const std::vector<std::pair<std::size_t, double>>& row) const {
  double squares = 0.0;
  for (const auto& [place, value] : row) squares += value * value;
  for (const auto& direction : parts_.unseen) {
    double share = 0.0;
    for (const auto& [place, value] : row) share += value * direction[place];
    if (std::abs(share) > told_most * std::sqrt(squares)) return std::nullopt;
  }
  Estimate estimate;
  double variance = 0.0;
  for (const auto& [i, a] : row) {
    estimate.value += a * parts_.values[i];
    for (const auto& [k, b] : row) variance += a * b * parts_.covariance[i * parts_.coefficients.raw() + k];
  }
  estimate.u = std::sqrt(std::max(0.0, variance));
  return estimate;
}

std::optional<Estimate> ErrorModel::squareness(Squareness which) const {
  return estimate({{parts_.coefficients.squareness() + static_cast<std::size_t>(which), 1.0}});
}

/// Of what is unseen, between two raw places.
std::vector<std::size_t> ErrorModel::touched_errors(std::size_t first, std::size_t end) const {
  std::vector<bool> touched(axis_count * motion_count + 3, false);
  for (const auto& direction : parts_.unseen)
    for (std::size_t k = first; k < end; ++k)
      if (std::abs(direction[k]) > told_most) touched[parts_.coefficients.error_of(k)] = true;
  std::vector<std::size_t> errors;
  for (std::size_t e = 0; e < touched.size(); ++e)
    if (touched[e]) errors.push_back(e);
  return errors;
}

std::vector<std::size_t> ErrorModel::unseen_means() const { return touched_errors(0, parts_.coefficients.half(0)); }

std::vector<std::size_t> ErrorModel::unseen_reversals() const {
  return touched_errors(parts_.coefficients.half(0), parts_.coefficients.raw());
}

std::vector<std::size_t> ErrorModel::unseen_errors() const { return touched_errors(0, parts_.coefficients.raw()); }

/// A displacement that all places share with this tool, as squareness gives that is counted from the machine's zero, is
/// the place of the whole machine.
bool ErrorModel::is_told_but_for_a_constant(Vector3 axes_mm, Vector3 tool_mm, Approaches approaches,
                                            std::size_t component) const {
  if (parts_.unseen.empty()) return true;
  Vector3 middle, along{};
  along[component] = 1.0;
  for (std::size_t a = 0; a < axis_count; ++a)
    middle[a] = 0.5 * (parts_.coefficients.basis(a).lower_mm() + parts_.coefficients.basis(a).upper_mm());
  BeamRow there(parts_.coefficients, parts_.machine, middle, tool_mm);
  there.along(along);
  const auto is_same = [&](Vector3 place) {
    BeamRow row(parts_.coefficients, parts_.machine, place, tool_mm, approaches);
    row.along(along);
    const double limit = told_most * std::sqrt(row.squares() + there.squares());
    return std::ranges::all_of(parts_.unseen, [&](const std::vector<double>& direction) {
      return std::abs(row.times(direction) - there.times(direction)) <= limit;
    });
  };
  if (!is_same(axes_mm)) return false;
  // In the middle nothing differs from the middle: what is told there is told beside it too.
  constexpr double beside = 0.01;  // of the range
  for (std::size_t a = 0; a < axis_count; ++a) {
    const auto& basis = parts_.coefficients.basis(a);
    Vector3 place = axes_mm;
    place[a] += (place[a] < middle[a] ? beside : -beside) * (basis.upper_mm() - basis.lower_mm());
    if (!is_same(place)) return false;
  }
  return true;
}

ToolPointError ErrorModel::at(Vector3 axes_mm, Vector3 tool_mm, Approaches approaches) const {
  const std::size_t width = parts_.coefficients.raw();
  BeamRow x(parts_.coefficients, parts_.machine, axes_mm, tool_mm, approaches);
  BeamRow y(parts_.coefficients, parts_.machine, axes_mm, tool_mm, approaches);
  BeamRow z(parts_.coefficients, parts_.machine, axes_mm, tool_mm, approaches);
  x.along({1.0, 0.0, 0.0});
  y.along({0.0, 1.0, 0.0});
  z.along({0.0, 0.0, 1.0});
  const std::array<const BeamRow*, 3> rows = {&x, &y, &z};
  ToolPointError field;
  for (std::size_t i = 0; i < 3; ++i)
    if (is_told_but_for_a_constant(axes_mm, tool_mm, approaches, i)) field.error_um[i] = rows[i]->times(parts_.values);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = i; k < 3; ++k) {
      if (!field.error_um[i] || !field.error_um[k]) continue;
      field.covariance_um2[i][k] = quadratic(*rows[i], parts_.covariance, width, *rows[k]);
      if (i == k) field.covariance_um2[i][i] = std::max(0.0, field.covariance_um2[i][i]);
      field.covariance_um2[k][i] = field.covariance_um2[i][k];
    }
  return field;
}

}  // namespace axiometry::volumetric
