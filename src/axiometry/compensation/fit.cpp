// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/fit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "axiometry/base/text/rounded_text.h"
#include "axiometry/numeric/band_cholesky.h"
#include "axiometry/numeric/moments.h"

namespace axiometry::compensation {
namespace {

constexpr double tie = 0.02;  // ρ
constexpr std::size_t folds_most = 10;
constexpr double decade_lowest = 1e-4, decade_highest = 1e8;  // bounds of λ

/// The wanted correction at a target of one direction: −x̄_i, with its number of readings.
struct Wanted {
  double position = 0.0;
  double value = 0.0;
  double weight = 0.0;
};

std::vector<Wanted> wanted_of(const Series& series, Direction direction) {
  std::vector<Wanted> wanted;
  for (std::size_t i = 0; i < series.target_count(); ++i) {
    const numeric::Moments m = numeric::moments(series.cell(i, direction));
    if (m.count > 0) wanted.push_back({series.targets()[i].in_native(), -m.mean, static_cast<double>(m.count)});
  }
  return wanted;
}

/// Where a position lies among nodes: between `node` and the next one, at that share of the way.
struct Place {
  std::size_t node = 0;
  double share = 0.0;
};

Place place_of(double position, std::span<const double> nodes) {
  if (position <= nodes.front() || nodes.size() == 1) return {0, 0.0};
  const std::size_t last = nodes.size() - 1;
  if (position >= nodes[last]) return {last - 1, 1.0};
  const auto above = static_cast<std::size_t>(std::ranges::upper_bound(nodes, position) - nodes.begin());
  return {above - 1, (position - nodes[above - 1]) / (nodes[above] - nodes[above - 1])};
}

double line_at(double position, std::span<const double> nodes, std::span<const double> values) {
  const Place at = place_of(position, nodes);
  if (nodes.size() == 1) return values.front();
  return values[at.node] + at.share * (values[at.node + 1] - values[at.node]);
}

std::vector<double> interpolated(std::span<const Wanted> wanted, std::span<const double> nodes) {
  std::vector<double> positions, values, result;
  for (const Wanted& w : wanted) positions.push_back(w.position), values.push_back(w.value);
  for (const double node : nodes) result.push_back(line_at(node, positions, values));
  return result;
}

double mean_weight(std::span<const Wanted> wanted) {
  double sum = 0.0;
  for (const Wanted& w : wanted) sum += w.weight;
  return sum / static_cast<double>(wanted.size());
}

/// Second difference at node k, with the mean spacing as its unit, so that λ has no unit either.
std::array<double, 3> second_difference(std::span<const double> nodes, std::size_t k) {
  const double mean = (nodes.back() - nodes.front()) / static_cast<double>(nodes.size() - 1);
  const double before = (nodes[k] - nodes[k - 1]) / mean, behind = (nodes[k + 1] - nodes[k]) / mean;
  const double scale = 2.0 / (before + behind);
  return {scale / before, -scale * (1.0 / before + 1.0 / behind), scale / behind};
}

/// Those between the ends of the table: beyond them the control holds the last value, whatever was measured there. All
/// where hardly any is left.
std::vector<Wanted> within_table(std::span<const Wanted> wanted, std::span<const double> nodes) {
  std::vector<Wanted> within;
  for (const Wanted& w : wanted)
    if (w.position >= nodes.front() && w.position <= nodes.back()) within.push_back(w);
  return within.size() >= 2 ? within : std::vector<Wanted>(wanted.begin(), wanted.end());
}

std::vector<double> least_squares(std::span<const Wanted> all, std::span<const double> nodes, double lambda) {
  const std::vector<double> plain = interpolated(all, nodes);
  const std::vector<Wanted> wanted = within_table(all, nodes);
  const double n = mean_weight(wanted);
  numeric::BandMatrix normal(nodes.size());
  std::vector<double> right(nodes.size());
  for (const Wanted& w : wanted) {
    const Place at = place_of(w.position, nodes);
    const std::array row{1.0 - at.share, at.share};
    const std::size_t used = nodes.size() == 1 ? 1 : 2;
    normal.add_square(at.node, std::span(row).first(used), w.weight);
    for (std::size_t k = 0; k < used; ++k) right[at.node + k] += w.weight * row[k] * w.value;
  }
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    normal.add_square(k, std::array{1.0}, tie * n);
    right[k] += tie * n * plain[k];
  }
  if (lambda > 0.0)
    for (std::size_t k = 1; k + 1 < nodes.size(); ++k)
      normal.add_square(k - 1, second_difference(nodes, k), lambda * n);
  if (const auto factor = normal.cholesky()) {
    factor->solve(right);
    return right;
  }
  return plain;  // weights beyond what doubles hold
}

/// How badly inner targets are foretold that were left out, Σ n_i (…)² over the folds.
double foretelling_error(std::span<const Wanted> wanted, std::span<const double> nodes, double lambda) {
  const std::size_t inner = wanted.size() - 2, folds = std::min(folds_most, inner);
  double sum = 0.0;
  for (std::size_t fold = 0; fold < folds; ++fold) {
    std::vector<Wanted> kept, left_out;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
      const bool is_inner = i > 0 && i + 1 < wanted.size();
      (is_inner && (i - 1) % folds == fold ? left_out : kept).push_back(wanted[i]);
    }
    const std::vector<double> values = least_squares(kept, nodes, lambda);
    for (const Wanted& w : left_out) {
      const double difference = line_at(w.position, nodes, values) - w.value;
      sum += w.weight * difference * difference;
    }
  }
  return sum;
}

double chosen_lambda(std::span<const std::vector<Wanted>> directions, std::span<const double> nodes) {
  const auto error_of = [&](double lambda) {
    double sum = 0.0;
    for (const std::vector<Wanted>& wanted : directions)
      if (wanted.size() > 3) sum += foretelling_error(wanted, nodes, lambda);
    return sum;
  };
  if (nodes.size() < 3) return 0.0;
  double best = 0.0, least = error_of(0.0);
  for (double lambda = decade_lowest; lambda <= decade_highest; lambda *= std::sqrt(10.0))
    if (const double error = error_of(lambda); error < least) least = error, best = lambda;
  return best;
}

/// Both directions as one: −x̄ of both, that of ↓ less what the backlash takes.
std::vector<Wanted> joined(std::span<const Wanted> up, std::span<const Wanted> down, double backlash) {
  std::vector<Wanted> both;
  std::size_t j = 0;
  for (const Wanted& u : up) {
    while (j < down.size() && down[j].position < u.position)
      both.push_back({down[j].position, down[j].value - backlash, down[j].weight}), ++j;
    if (j < down.size() && down[j].position == u.position) {
      const double weight = u.weight + down[j].weight;
      const double value = (u.weight * u.value + down[j].weight * (down[j].value - backlash)) / weight;
      both.push_back({u.position, value, weight});
      ++j;
    } else {
      both.push_back(u);
    }
  }
  for (; j < down.size(); ++j) both.push_back({down[j].position, down[j].value - backlash, down[j].weight});
  return both;
}

/// The mean of x̄_i↑ − x̄_i↓ over targets with both (3.17): what the control adds in the negative direction.
std::optional<double> mean_reversal(const Series& series) {
  double sum = 0.0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < series.target_count(); ++i) {
    const numeric::Moments up = numeric::moments(series.cell(i, Direction::up));
    const numeric::Moments down = numeric::moments(series.cell(i, Direction::down));
    if (up.count > 0 && down.count > 0) sum += up.mean - down.mean, ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

/// Whether every target was approached as often from both sides.
bool is_measured_alike(const Series& series) {
  for (std::size_t i = 0; i < series.target_count(); ++i)
    if (series.count(i, Direction::up) != series.count(i, Direction::down)) return false;
  return true;
}

Result<void> check_covered(std::span<const Wanted> wanted, std::span<const double> nodes, std::string_view of) {
  const double slack = 1e-9 * std::max(1.0, std::abs(nodes.back()) + std::abs(nodes.front()));
  if (nodes.front() >= wanted.front().position - slack && nodes.back() <= wanted.back().position + slack) return {};
  return fail(
      fmt::format("found a table from {} to {}, expected it within {} to {}, where {} were measured: nothing is "
                  "extrapolated",
                  format_rounded(nodes.front()), format_rounded(nodes.back()), format_rounded(wanted.front().position),
                  format_rounded(wanted.back().position), of));
}

Result<void> check_nodes(std::span<const double> nodes) {
  if (nodes.empty()) return fail("found no position for the table, expected at least one");
  for (std::size_t k = 1; k < nodes.size(); ++k)
    if (!(nodes[k] > nodes[k - 1])) return fail("found positions of the table that do not ascend");
  return {};
}

void shift(std::vector<double>& values, double by) {
  for (double& value : values) value -= by;
}

}  // namespace

Result<Fit> fit_correction(const Series& series, AxisKind kind, const FitRequest& request) {
  AXIOMETRY_TRY_VOID(check_nodes(request.nodes));
  const std::vector<Wanted> up = wanted_of(series, Direction::up), down = wanted_of(series, Direction::down);
  const std::optional<double> reversal = mean_reversal(series);
  if (request.curves != TableCurves::both_ways && (up.empty() || down.empty()))
    return fail(fmt::format("found readings of the {} direction alone, expected both for a table {}",
                            up.empty() ? "negative" : "positive",
                            request.curves == TableCurves::each_way ? "of each direction" : "with a backlash"));
  if (request.curves == TableCurves::with_backlash && !reversal)
    return fail("found no target that was approached from both sides, expected one for a backlash");

  // One curve for both directions lies in their middle also where one of them was measured more often, or alone.
  const bool in_middle = request.curves == TableCurves::both_ways && reversal && !is_measured_alike(series);
  const double taken_off = in_middle || request.curves == TableCurves::with_backlash ? *reversal : 0.0;
  std::vector<std::vector<Wanted>> curves;
  if (request.curves == TableCurves::each_way) {
    curves = {up, down};
  } else {
    curves = {joined(up, down, taken_off)};
  }
  const bool is_backlash_alone = request.nodes.size() == 1;
  if (!is_backlash_alone && !request.hold_ends)
    for (std::size_t c = 0; c < curves.size(); ++c)
      AXIOMETRY_TRY_VOID(check_covered(curves[c], request.nodes,
                                       curves.size() == 1 ? "targets"
                                       : c == 0           ? "targets ↑"
                                                          : "targets ↓"));

  const double lambda =
      request.smooth && request.method == Method::least_squares ? chosen_lambda(curves, request.nodes) : 0.0;
  std::vector<std::vector<double>> values;
  for (const std::vector<Wanted>& wanted : curves)
    values.push_back(request.method == Method::interpolation ? interpolated(wanted, request.nodes)
                                                             : least_squares(wanted, request.nodes, lambda));
  if (in_middle) shift(values.front(), -0.5 * *reversal);
  if (values.size() == 1) values.push_back(values.front());
  if (request.curves == TableCurves::with_backlash) shift(values[1], -*reversal);
  AXIOMETRY_TRY(AxisCorrection correction, AxisCorrection::make(kind, request.nodes, values[0], values[1]));
  return Fit{std::move(correction), lambda};
}

Result<AxisCorrection> updated(const AxisCorrection& existing, const AxisCorrection& change) {
  std::array<std::vector<double>, 2> values{change.values(Direction::up), change.values(Direction::down)};
  for (const Direction direction : {Direction::up, Direction::down})
    for (std::size_t k = 0; k < change.positions().size(); ++k)
      values[static_cast<std::size_t>(direction)][k] += existing.at(change.positions()[k], direction);
  return AxisCorrection::make(change.kind(), change.positions(), std::move(values[0]), std::move(values[1]));
}

Result<AxisCorrection> closed_turn(const AxisCorrection& correction) {
  const std::vector<double>& positions = correction.positions();
  if (correction.kind() != AxisKind::rotary || std::abs(positions.back() - positions.front() - 360.0) > 1e-6)
    return correction;
  std::array<std::vector<double>, 2> values{correction.values(Direction::up), correction.values(Direction::down)};
  for (std::vector<double>& v : values) v.front() = v.back() = 0.5 * (v.front() + v.back());
  return AxisCorrection::make(correction.kind(), positions, std::move(values[0]), std::move(values[1]));
}

Result<AxisCorrection> with_zero_at(const AxisCorrection& correction, TableCurves curves, double position) {
  const double up_there = correction.at(position, Direction::up), down_there = correction.at(position, Direction::down);
  const double zero = curves == TableCurves::with_backlash ? up_there : 0.5 * (up_there + down_there);
  std::vector<double> up = correction.values(Direction::up), down = correction.values(Direction::down);
  shift(up, zero);
  shift(down, zero);
  return AxisCorrection::make(correction.kind(), correction.positions(), std::move(up), std::move(down));
}

}  // namespace axiometry::compensation
