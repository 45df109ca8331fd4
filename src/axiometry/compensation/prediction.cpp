// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/prediction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "axiometry/numeric/moments.h"

namespace axiometry::compensation {
namespace {

constexpr std::array both_directions{Direction::up, Direction::down};

/// The series with something else at every target and direction: f(target index, direction) is added to its readings.
template <typename Added>
Result<Series> shifted(const Series& series, const Added& added) {
  const std::size_t m = series.target_count(), n = series.run_count();
  std::vector<double> deviations;
  deviations.reserve(2 * m * n);
  for (const Direction direction : both_directions)
    for (std::size_t i = 0; i < m; ++i) {
      const double by = added(i, direction);
      for (const double x : series.cell(i, direction)) deviations.push_back(x + by);
    }
  return Series::make_dense({series.targets().begin(), series.targets().end()}, n, std::move(deviations));
}

double change_at(double position, Direction direction, const AxisCorrection& added, const AxisCorrection* removed) {
  return added.at(position, direction) - (removed ? removed->at(position, direction) : 0.0);
}

/// At one target and direction that both tests have.
struct RetestChange {
  double position = 0.0;
  Direction direction = Direction::up;
  double wanted = 0.0;                 ///< by the table
  double exchanged = 0.0;              ///< and by it with its directions exchanged
  double mirrored = 0.0;               ///< or its positions
  double found = 0.0, variance = 0.0;  ///< x̄_retest − x̄_before
  double variance_before = 0.0;        ///< the part of x̄_before, whose scatter the table was made of too
  double reversal = 0.0;               ///< by the table: between this direction and the other
};

std::size_t way_index(Direction direction) { return static_cast<std::size_t>(direction); }

std::vector<RetestChange> changes_of(const Series& before, const Series& after, const AxisCorrection& added,
                                     const AxisCorrection* removed, double same_target_native) {
  std::vector<RetestChange> changes;
  const double ends = added.positions().front() + added.positions().back();
  for (const Direction direction : both_directions) {
    const Direction other = direction == Direction::up ? Direction::down : Direction::up;
    std::size_t j = 0;
    for (std::size_t i = 0; i < before.target_count(); ++i) {
      const double position = before.targets()[i].in_native();
      while (j < after.target_count() && after.targets()[j].in_native() < position - same_target_native) ++j;
      if (j == after.target_count() || after.targets()[j].in_native() > position + same_target_native) continue;
      const numeric::Moments a = numeric::moments(before.cell(i, direction));
      const numeric::Moments b = numeric::moments(after.cell(j, direction));
      if (a.count == 0 || b.count == 0) continue;
      const double was = removed ? removed->at(position, direction) : 0.0;
      changes.push_back({position, direction, added.at(position, direction) - was, added.at(position, other) - was,
                         added.at(ends - position, direction) - was, b.mean - a.mean,
                         a.standard_deviation * a.standard_deviation / static_cast<double>(a.count) +
                             b.standard_deviation * b.standard_deviation / static_cast<double>(b.count),
                         a.standard_deviation * a.standard_deviation / static_cast<double>(a.count),
                         change_at(position, direction, added, removed) - change_at(position, other, added, removed)});
    }
  }
  return changes;
}

/// Least squares of found = γ·w + a, with sums about the means: w of what should be, f of what was found.
struct ChangeLine {
  double ww = 0.0, wf = 0.0, ff = 0.0;
  double variance = 0.0;           ///< variance of all f together
  double variance_of_share = 0.0;  ///< variance of γ by that of f
  double count = 0.0;

  double gamma() const { return wf / ww; }
  double left_at(double share) const { return std::max(0.0, ff - share * (2.0 * wf - share * ww)); }
  double left() const { return left_at(gamma()); }
  double u_of_scatter() const { return std::sqrt(variance_of_share); }
  /// By scatter twice as large as both tests show, or but for a tenth.
  bool is_explained(double rest) const { return rest <= std::max(4.0 * variance, 0.1 * ff); }

  TableShare share() const {
    const double rest = left();
    const double by_rest = count > 2.0 ? rest / (count - 2.0) / ww : 0.0;
    return {gamma(), std::sqrt(std::max(variance_of_share, by_rest)), ff > 0.0 ? 1.0 - rest / ff : 1.0,
            is_explained(rest), ff <= std::max(4.0 * variance, 0.2 * 0.2 * ww)};
  }
};

ChangeLine line_of(const std::vector<RetestChange>& changes, double RetestChange::*wanted) {
  ChangeLine line;
  line.count = static_cast<double>(changes.size());
  double wanted_mean = 0.0, found_mean = 0.0, weighted = 0.0;
  for (const RetestChange& c : changes) wanted_mean += c.*wanted / line.count, found_mean += c.found / line.count;
  for (const RetestChange& c : changes) {
    const double w = c.*wanted - wanted_mean, f = c.found - found_mean;
    line.ww += w * w, line.wf += w * f, line.ff += f * f;
    line.variance += c.variance;
    weighted += c.variance * w * w;
  }
  line.variance_of_share = line.ww > 0.0 ? weighted / (line.ww * line.ww) : 0.0;
  return line;
}

constexpr double least_reversal = 0.01;  // µm or ″, root mean square: less of a table is of rounding

bool has_reversal(const std::vector<RetestChange>& changes) {
  double sum = 0.0;
  for (const RetestChange& c : changes) sum += c.reversal * c.reversal;
  return sum > least_reversal * least_reversal * static_cast<double>(changes.size());
}

void add_reversal(const std::vector<RetestChange>& changes, RetestEffect& effect) {
  double rr = 0.0, rf = 0.0, rv = 0.0, common = 0.0;
  const auto first_down = std::ranges::find(changes, Direction::down, &RetestChange::direction);
  auto down = first_down;  // both directions ascend
  for (auto up = changes.begin(); up != first_down; ++up) {
    while (down != changes.end() && down->position < up->position) ++down;
    if (down == changes.end()) break;
    if (down->position > up->position) continue;
    const double wanted = up->wanted - down->wanted;
    rr += wanted * wanted;
    rf += wanted * (up->found - down->found);
    rv += wanted * wanted * (up->variance + down->variance);
    common += up->variance_before + down->variance_before;
  }
  if (!(rr > 0.0)) return;
  effect.of_reversal = rf / rr;
  // Of a table that is scatter of the first test a right one shows up to twice: that scatter is in what is wanted and,
  // the other way, in what was found.
  effect.u_of_reversal = std::hypot(std::sqrt(rv), common) / rr;
}

}  // namespace

bool tells_scatter(const Series& series) {
  for (const Direction direction : both_directions)
    for (std::size_t i = 0; i < series.target_count(); ++i)
      if (series.count(i, direction) > 1) return true;
  return false;
}

Result<Series> shifted_series(const Series& series, const std::function<double(double, Direction)>& added) {
  return shifted(series,
                 [&](std::size_t i, Direction direction) { return added(series.targets()[i].in_native(), direction); });
}

Result<Series> corrected_series(const Series& series, const AxisCorrection& added, const AxisCorrection* removed) {
  return shifted_series(
      series, [&](double position, Direction direction) { return change_at(position, direction, added, removed); });
}

Result<Series> scatter_alone(const Series& series) {
  return shifted(series,
                 [&](std::size_t i, Direction direction) { return -numeric::moments(series.cell(i, direction)).mean; });
}

std::optional<RetestEffect> effect_of_table(const Series& before, const Series& after, const AxisCorrection& added,
                                            const AxisCorrection* removed, double same_target_native) {
  const std::vector<RetestChange> changes = changes_of(before, after, added, removed, same_target_native);
  std::vector<double> places;
  for (const RetestChange& c : changes) places.push_back(c.position);
  std::ranges::sort(places);
  places.erase(std::ranges::unique(places).begin(), places.end());
  if (changes.size() < 3 || places.size() < std::min<std::size_t>(3, before.target_count())) return std::nullopt;
  const ChangeLine line = line_of(changes, &RetestChange::wanted);
  if (!(line.ww > 0.0)) return std::nullopt;
  RetestEffect effect{line.share()};
  effect.u_of_scatter = line.u_of_scatter();
  effect.compared = changes.size();
  effect.targets = places.size();
  effect.first = places.front();
  effect.last = places.back();
  for (const Direction direction : both_directions) {
    std::vector<RetestChange> way;
    std::ranges::copy_if(changes, std::back_inserter(way),
                         [&](const RetestChange& c) { return c.direction == direction; });
    if (way.size() < 3) continue;
    const ChangeLine own = line_of(way, &RetestChange::wanted);
    if (own.ww > 0.0 && own.share().u < share_u_most) effect.directions[way_index(direction)] = own.share();
  }
  const auto is_explained_as = [&](double RetestChange::*by) {
    const ChangeLine other = line_of(changes, by);
    return other.is_explained(other.left_at(1.0));
  };
  effect.exchanged = is_explained_as(&RetestChange::exchanged);
  effect.mirrored = is_explained_as(&RetestChange::mirrored);
  effect.has_reversal = has_reversal(changes);
  if (effect.has_reversal) add_reversal(changes, effect);
  return effect;
}

}  // namespace axiometry::compensation
