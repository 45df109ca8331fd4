// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: none in the formulas. Where readings are missing the standard is
// silent; the header says what is done.
#include "axiometry/standards/iso230_2/parameters.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/moments.h"

namespace axiometry::iso230_2 {
namespace {

using Value = std::optional<Deviation>;

Value some(double x) { return Deviation::native(x); }
double or_zero(Value x) { return x ? x->in_native() : 0.0; }

/// 3.20 with 0 for a term that does not exist.
double repeatability_bound(const PositionResult& p) {
  const double both =
      coverage_factor * or_zero(p.s_up) + coverage_factor * or_zero(p.s_down) + std::abs(or_zero(p.reversal));
  return std::max({both, or_zero(p.R_up), or_zero(p.R_down)});
}

/// 3.19 and 3.20 from s_i; B_i is there already.
void set_estimators(PositionResult& position, Value s_up, Value s_down) {
  constexpr double width = 2.0 * coverage_factor;
  position.s_up = s_up;
  position.s_down = s_down;
  position.R_up = s_up ? some(width * s_up->in_native()) : std::nullopt;
  position.R_down = s_down ? some(width * s_down->in_native()) : std::nullopt;
  const bool exists = position.reversal && s_up && s_down;
  position.R = exists ? some(repeatability_bound(position)) : std::nullopt;
}

bool at_least(Value larger, Value smaller, double tolerance) {
  return !larger || !smaller || larger->in_native() >= smaller->in_native() - tolerance;
}

/// The ordering that follows from the definitions. E, M, B and the maxima of R inherit it from the
/// monotony of rounding; A is a difference of rounded sums, off by at most four half-units in the
/// last place of the boundaries, and B̄ a sum of m terms.
void check_ordering(const AxisParameters& p, double boundary_magnitude, std::size_t target_count) {
  constexpr double epsilon = std::numeric_limits<double>::epsilon();
  const double a_tolerance = 8.0 * epsilon * boundary_magnitude;
  const double mean_tolerance = static_cast<double>(target_count) * epsilon * or_zero(p.B);
  for (Value smaller : {p.E_up, p.E_down, p.M, p.B}) AXIOMETRY_CONTRACT(at_least(p.E, smaller, 0.0));
  for (Value smaller : {p.E, p.A_up, p.A_down, p.R}) AXIOMETRY_CONTRACT(at_least(p.A, smaller, a_tolerance));
  for (Value smaller : {p.R_up, p.R_down, p.B}) AXIOMETRY_CONTRACT(at_least(p.R, smaller, 0.0));
  if (p.B_mean) AXIOMETRY_CONTRACT(at_least(p.B, some(std::abs(p.B_mean->in_native())), mean_tolerance));
}

}  // namespace

void AxisExtremes::DirectionExtremes::see(Value mean, Value s, Value repeatability) {
  if (!mean) return;
  const double band = coverage_factor * or_zero(s);
  means.see(mean->in_native());
  boundaries.see(mean->in_native() + band);
  boundaries.see(mean->in_native() - band);
  if (repeatability) R.see(repeatability->in_native());
}

void AxisExtremes::DirectionExtremes::see(const DirectionExtremes& other) {
  means.see(other.means);
  boundaries.see(other.boundaries);
  R.see(other.R);
}

Value AxisExtremes::DirectionExtremes::A() const { return R.any() ? boundaries.range() : std::nullopt; }

void AxisExtremes::see(const PositionResult& p) {
  ++count_;
  up_.see(p.mean_up, p.s_up, p.R_up);
  down_.see(p.mean_down, p.s_down, p.R_down);
  R_.see(repeatability_bound(p));
  if (!p.reversal) return;
  means_.see(p.mean->in_native());
  B_.see(std::abs(p.reversal->in_native()));
  reversal_sum_ += p.reversal->in_native();
  ++reversal_count_;
}

void AxisExtremes::see(const AxisExtremes& other) {
  count_ += other.count_;
  up_.see(other.up_);
  down_.see(other.down_);
  R_.see(other.R_);
  means_.see(other.means_);
  B_.see(other.B_);
  reversal_sum_ += other.reversal_sum_;
  reversal_count_ += other.reversal_count_;
}

AxisParameters AxisExtremes::parameters() const {
  Extremes both_means = up_.means;
  both_means.see(down_.means);
  Extremes both_boundaries = up_.boundaries;
  both_boundaries.see(down_.boundaries);
  const bool both_directions = up_.means.any() && down_.means.any();
  const bool both_repeat = up_.R.any() && down_.R.any();

  AxisParameters result;
  result.E_up = up_.means.range();
  result.E_down = down_.means.range();
  result.A_up = up_.A();
  result.A_down = down_.A();
  result.R_up = up_.R.maximum();
  result.R_down = down_.R.maximum();
  if (both_directions) result.E = both_means.range();
  if (both_repeat) result.A = both_boundaries.range();
  if (both_repeat && reversal_count_ > 0) result.R = R_.maximum();
  if (reversal_count_ > 0) {
    result.M = means_.range();
    result.B = B_.maximum();
    result.B_mean = some(reversal_sum_ / static_cast<double>(reversal_count_));
  }
  check_ordering(result, both_boundaries.magnitude(), count_);
  return result;
}

const ParameterInfo* find_parameter(std::string_view name) {
  const auto found = std::ranges::find_if(parameters, [&](const auto& p) { return p.key == name || p.symbol == name; });
  return found == std::end(parameters) ? nullptr : found;
}

PositionResult with_estimators(PositionResult position, Value s_up, Value s_down) {
  set_estimators(position, s_up, s_down);
  return position;
}

PositionResult evaluate_position(const Position& target, std::span<const double> up_runs,
                                 std::span<const double> down_runs) {
  const numeric::Moments up = numeric::moments(up_runs);
  const numeric::Moments down = numeric::moments(down_runs);
  PositionResult p;
  p.target = target;
  p.count_up = up.count;
  p.count_down = down.count;
  if (up.count > 0) p.mean_up = some(up.mean);
  if (down.count > 0) p.mean_down = some(down.mean);
  if (up.count > 0 && down.count > 0) {
    p.mean = some((up.mean + down.mean) / 2.0);
    p.reversal = some(up.mean - down.mean);
  }
  set_estimators(p, up.count > 1 ? some(up.standard_deviation) : std::nullopt,
                 down.count > 1 ? some(down.standard_deviation) : std::nullopt);
  return p;
}

std::vector<PositionResult> evaluate_positions(const Series& series) {
  std::vector<PositionResult> positions(series.target_count());
  for (std::size_t i = 0; i < positions.size(); ++i)
    positions[i] =
        evaluate_position(series.targets()[i], series.cell(i, Direction::up), series.cell(i, Direction::down));
  return positions;
}

AxisParameters evaluate_axis(std::span<const PositionResult> positions) {
  AxisExtremes axis;
  for (const PositionResult& p : positions) axis.see(p);
  return axis.parameters();
}

AxisWithoutOne::AxisWithoutOne(std::span<const PositionResult> positions)
    : before_(positions.size()), after_(positions.size()) {
  AxisExtremes seen;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    before_[i] = seen;
    seen.see(positions[i]);
  }
  seen = {};
  for (std::size_t i = positions.size(); i-- > 0;) {
    after_[i] = seen;
    seen.see(positions[i]);
  }
}

AxisParameters AxisWithoutOne::with(std::size_t i, const PositionResult& instead) const {
  AxisExtremes axis = before_[i];
  axis.see(instead);
  axis.see(after_[i]);
  return axis.parameters();
}

Evaluation evaluate(const Series& series) {
  Evaluation result;
  result.positions = evaluate_positions(series);
  result.parameters = evaluate_axis(result.positions);
  return result;
}

}  // namespace axiometry::iso230_2
