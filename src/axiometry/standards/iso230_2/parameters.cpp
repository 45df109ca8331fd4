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

/// Algebraic maximum and minimum of what it has seen.
class Extremes {
 public:
  void see(double x) {
    max_ = std::max(max_, x);
    min_ = std::min(min_, x);
  }
  void see(const Extremes& other) {
    max_ = std::max(max_, other.max_);
    min_ = std::min(min_, other.min_);
  }
  bool any() const { return max_ >= min_; }
  Value range() const { return any() ? some(max_ - min_) : std::nullopt; }
  Value maximum() const { return any() ? some(max_) : std::nullopt; }
  double magnitude() const { return std::max(std::abs(max_), std::abs(min_)); }

 private:
  double max_ = -std::numeric_limits<double>::infinity();
  double min_ = std::numeric_limits<double>::infinity();
};

/// What one direction of approach contributes to the axis.
struct DirectionExtremes {
  Extremes means;       // x̄_i
  Extremes boundaries;  // x̄_i ± 2 s_i
  Extremes R;           // R_i of this direction

  void see(Value mean, Value s, Value repeatability) {
    if (!mean) return;
    const double band = coverage_factor * or_zero(s);
    means.see(mean->in_native());
    boundaries.see(mean->in_native() + band);
    boundaries.see(mean->in_native() - band);
    if (repeatability) R.see(repeatability->in_native());
  }
  Value A() const { return R.any() ? boundaries.range() : std::nullopt; }
};

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

const ParameterInfo* find_parameter(std::string_view name) {
  const auto found = std::ranges::find_if(parameters, [&](const auto& p) { return p.key == name || p.symbol == name; });
  return found == std::end(parameters) ? nullptr : found;
}

PositionResult with_estimators(PositionResult position, Value s_up, Value s_down) {
  set_estimators(position, s_up, s_down);
  return position;
}

std::vector<PositionResult> evaluate_positions(const Series& series) {
  std::vector<PositionResult> positions(series.target_count());
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const numeric::Moments up = numeric::moments(series.cell(i, Direction::up));
    const numeric::Moments down = numeric::moments(series.cell(i, Direction::down));
    PositionResult& p = positions[i];
    p.target = series.targets()[i];
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
  }
  return positions;
}

AxisParameters evaluate_axis(std::span<const PositionResult> positions) {
  DirectionExtremes up;
  DirectionExtremes down;
  Extremes means;
  Extremes R;
  Extremes B;
  double reversal_sum = 0.0;
  std::size_t reversal_count = 0;
  for (const PositionResult& p : positions) {
    up.see(p.mean_up, p.s_up, p.R_up);
    down.see(p.mean_down, p.s_down, p.R_down);
    R.see(repeatability_bound(p));
    if (!p.reversal) continue;
    means.see(p.mean->in_native());
    B.see(std::abs(p.reversal->in_native()));
    reversal_sum += p.reversal->in_native();
    ++reversal_count;
  }
  Extremes both_means = up.means;
  both_means.see(down.means);
  Extremes both_boundaries = up.boundaries;
  both_boundaries.see(down.boundaries);
  const bool both_directions = up.means.any() && down.means.any();
  const bool both_repeat = up.R.any() && down.R.any();

  AxisParameters result;
  result.E_up = up.means.range();
  result.E_down = down.means.range();
  result.A_up = up.A();
  result.A_down = down.A();
  result.R_up = up.R.maximum();
  result.R_down = down.R.maximum();
  if (both_directions) result.E = both_means.range();
  if (both_repeat) result.A = both_boundaries.range();
  if (both_repeat && reversal_count > 0) result.R = R.maximum();
  if (reversal_count > 0) {
    result.M = means.range();
    result.B = B.maximum();
    result.B_mean = some(reversal_sum / static_cast<double>(reversal_count));
  }
  check_ordering(result, both_boundaries.magnitude(), positions.size());
  return result;
}

Evaluation evaluate(const Series& series) {
  Evaluation result;
  result.positions = evaluate_positions(series);
  result.parameters = evaluate_axis(result.positions);
  return result;
}

}  // namespace axiometry::iso230_2
