// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/clause3.h"

#include <algorithm>
#include <cmath>

namespace axiometry::verification {
namespace {

/// Sums of decimals are exact; only the quotients and the root are intervals.
ExactCell exact_cell(std::span<const double> readings) {
  ExactCell cell;
  Integer sum = 0;
  Integer squares = 0;
  for (const double x : readings) {
    if (std::isnan(x)) continue;
    const Integer whole = Interval::of(x).lower();  // exact down to 10⁻⁴⁰
    sum += whole;
    squares += whole * whole;
    ++cell.count;
  }
  if (cell.count == 0) return cell;
  const Integer n = cell.count;
  cell.mean = Interval::ratio(sum, n * power_of_ten(places));
  if (cell.count < 2) return cell;
  const Integer spread = n * squares - sum * sum;
  cell.s = Interval::root_of_squares(spread, n * (n - 1));
  cell.variance = Interval::ratio(spread, n * (n - 1) * power_of_ten(places) * power_of_ten(places));
  return cell;
}

/// Largest less smallest, absent when nothing was seen.
class Span {
 public:
  void see(const Interval& x) {
    high_ = high_ ? larger(*high_, x) : x;
    low_ = low_ ? smaller(*low_, x) : x;
  }
  void see(const Exact& x) {
    if (x) see(*x);
  }
  Exact width() const { return high_ ? Exact(*high_ - *low_) : std::nullopt; }
  const Exact& top() const { return high_; }

 private:
  Exact high_;
  Exact low_;
};

Interval or_nothing(const Exact& x) { return x.value_or(Interval(0)); }

Exact repeatability(const Exact& s) { return s ? Exact(Interval(4) * *s) : std::nullopt; }

/// 3.20; what does not exist counts as 0.
Interval band(const ExactPosition& p) {
  const Interval both =
      Interval(2) * or_nothing(p.up.s) + Interval(2) * or_nothing(p.down.s) + magnitude(or_nothing(p.reversal()));
  return larger(both, larger(Interval(4) * or_nothing(p.up.s), Interval(4) * or_nothing(p.down.s)));
}

/// Means with and without their band of two s.
void see_cell(const ExactCell& cell, Span& means, Span& boundaries) {
  if (!cell.mean) return;
  const Interval reach = Interval(2) * or_nothing(cell.s);
  means.see(cell.mean);
  boundaries.see(*cell.mean + reach);
  boundaries.see(*cell.mean - reach);
}

}  // namespace

std::optional<Parameter> parameter_of_key(std::string_view key) {
  const auto found = std::ranges::find(parameter_names, key, &ParameterName::key);
  if (found == parameter_names.end()) return std::nullopt;
  return static_cast<Parameter>(found - parameter_names.begin());
}

std::optional<Parameter> parameter_of_symbol(std::string_view symbol) {
  const auto found = std::ranges::find(parameter_names, symbol, &ParameterName::symbol);
  if (found == parameter_names.end()) return std::nullopt;
  return static_cast<Parameter>(found - parameter_names.begin());
}

Exact ExactPosition::mean() const {
  if (!up.mean || !down.mean) return std::nullopt;
  return (*up.mean + *down.mean) / Interval(2);
}

Exact ExactPosition::reversal() const {
  if (!up.mean || !down.mean) return std::nullopt;
  return *up.mean - *down.mean;
}

Exact ExactPosition::R_up() const { return repeatability(up.s); }

Exact ExactPosition::R_down() const { return repeatability(down.s); }

Exact ExactPosition::R() const {
  if (!reversal() || !up.s || !down.s) return std::nullopt;
  return band(*this);
}

std::vector<ExactPosition> exact_positions(const Series& series) {
  std::vector<ExactPosition> positions;
  positions.reserve(series.target_count());
  for (std::size_t i = 0; i < series.target_count(); ++i)
    positions.push_back({Interval::of(series.targets()[i].in_native()), exact_cell(series.cell(i, Direction::up)),
                         exact_cell(series.cell(i, Direction::down))});
  return positions;
}

ExactParameters exact_parameters(std::span<const ExactPosition> positions) {
  Span means_up, means_down, means_all, boundaries_up, boundaries_down, boundaries_all;
  Span middle, R_up, R_down, R_any, B;
  Interval reversals = 0;
  int both_directions = 0;
  for (const ExactPosition& p : positions) {
    see_cell(p.up, means_up, boundaries_up);
    see_cell(p.down, means_down, boundaries_down);
    see_cell(p.up, means_all, boundaries_all);
    see_cell(p.down, means_all, boundaries_all);
    R_up.see(p.R_up());
    R_down.see(p.R_down());
    R_any.see(band(p));
    const Exact reversal = p.reversal();
    if (!reversal) continue;
    middle.see(p.mean());
    B.see(magnitude(*reversal));
    reversals = reversals + *reversal;
    ++both_directions;
  }
  const bool two_ways = means_up.width() && means_down.width();
  const bool repeated = R_up.top() && R_down.top();
  ExactParameters all;
  of(all, Parameter::E_up) = means_up.width();
  of(all, Parameter::E_down) = means_down.width();
  if (two_ways) of(all, Parameter::E) = means_all.width();
  if (R_up.top()) of(all, Parameter::A_up) = boundaries_up.width();
  if (R_down.top()) of(all, Parameter::A_down) = boundaries_down.width();
  if (repeated) of(all, Parameter::A) = boundaries_all.width();
  of(all, Parameter::R_up) = R_up.top();
  of(all, Parameter::R_down) = R_down.top();
  if (both_directions == 0) return all;
  if (repeated) of(all, Parameter::R) = R_any.top();
  of(all, Parameter::M) = middle.width();
  of(all, Parameter::B) = B.top();
  of(all, Parameter::B_mean) = reversals / Interval(both_directions);
  return all;
}

Interval rounding_of(const Series& series) {
  double largest = 0.0;
  for (std::size_t i = 0; i < series.target_count(); ++i)
    for (const Direction direction : {Direction::up, Direction::down})
      for (const double x : series.cell(i, direction))
        if (std::abs(x) > largest) largest = std::abs(x);
  const auto operations = static_cast<int>(12 * series.run_count() + 2 * series.target_count() + 112);
  // 2⁻⁵³, and as much as the last digit of the shortest decimal of a double may be off.
  const Interval roundoff = Interval::of(1.2e-16);
  return Interval(operations) * roundoff * Interval::of(largest) + Interval::of(1e-30);
}

std::size_t fewest_runs(std::span<const ExactPosition> positions) {
  std::size_t fewest = 0;
  for (const ExactPosition& p : positions)
    for (const std::size_t count : {p.up.count, p.down.count})
      if (count > 0 && (fewest == 0 || count < fewest)) fewest = count;
  return fewest;
}

std::vector<ExactPosition> without_environment(std::vector<ExactPosition> positions, const Interval& U_eve,
                                               const Interval& rounding) {
  const Interval u = U_eve / Interval(2);
  const auto correct = [&](ExactCell& cell) {
    if (!cell.variance) return;
    const Interval difference = *cell.variance - u * u;
    const Interval apart =
        (Interval(2) * *cell.s + rounding) * rounding + Interval::of(1e-15) * (*cell.variance + u * u);
    cell.s = root({difference.lower() - apart.upper(), difference.upper() + apart.upper()});
  };
  for (ExactPosition& p : positions) {
    correct(p.up);
    correct(p.down);
  }
  return positions;
}

}  // namespace axiometry::verification
