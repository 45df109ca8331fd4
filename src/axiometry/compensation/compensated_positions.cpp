// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/compensated_positions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/standards/iso230_2/uncertainty/gum_model.h"

namespace axiometry::compensation {
namespace {

using iso230_2::Component;
using iso230_2::ComponentSum;
using iso230_2::ExpandedUncertainty;

constexpr double no_limit = iso230_2::infinite;

double freedom_of(const ExpandedUncertainty& x) { return x.effective_degrees_of_freedom.value_or(no_limit); }

/// (8): the scatter of the approach beside that of the mean, s/√n, which are one s and have its n − 1 together; ν of
/// the rest from what Welch and Satterthwaite made of all.
ExpandedUncertainty of_approach(const ExpandedUncertainty& mean, double s, double n) {
  const double of_mean = s / std::sqrt(n), whole = mean.u.in_native();
  const double rest = std::sqrt(std::max(0.0, whole * whole - of_mean * of_mean));
  const double fourth = std::pow(whole, 4) / freedom_of(mean) - std::pow(of_mean, 4) / (n - 1.0);
  const bool finite = rest > 0.0 && fourth > 1e-9 * std::pow(rest, 4);  // ν above 1e9 is none
  ComponentSum sum;
  sum.add({std::hypot(of_mean, s), n - 1.0});
  sum.add({rest, finite ? std::pow(rest, 4) / fourth : no_limit});
  return sum.expanded();
}

/// A target that has a mean in the direction.
struct MeanOnWay {
  std::size_t target = 0;
  double position = 0.0;
  double mean = 0.0;
  std::size_t count = 0;
};

/// Root mean square distance of means from the line between those `apart` before and behind them; nothing where no
/// mean has them.
std::optional<double> distance_from_lines(const std::vector<MeanOnWay>& means, std::size_t apart) {
  if (means.size() < 2 * apart + 1) return std::nullopt;
  double squares = 0.0;
  const std::size_t count = means.size() - 2 * apart;
  for (std::size_t k = apart; k < apart + count; ++k) {
    const MeanOnWay &a = means[k - apart], &b = means[k + apart];
    const double share = (means[k].position - a.position) / (b.position - a.position);
    const double distance = means[k].mean - a.mean - share * (b.mean - a.mean);
    squares += distance * distance;
  }
  return std::sqrt(squares / static_cast<double>(count));
}

/// (10). Distances of neighbours share a mean: half as many are independent.
std::optional<Component> between_targets(const std::vector<MeanOnWay>& means) {
  const auto near = distance_from_lines(means, 1), far = distance_from_lines(means, 2);
  if (!near) return std::nullopt;
  const double D1 = *near * *near, D2 = far ? *far * *far : D1;
  const double q = std::max(D1 / 16.0, D1 - std::max(0.0, D2 - D1) / 16.0);
  return Component{std::sqrt(q), std::max(1.0, 0.5 * static_cast<double>(means.size() - 2))};
}

/// What the control adds now in place of what it added during the test.
double change_at(const TableInControl& table, double position, Direction direction) {
  const double before = table.removed != nullptr ? table.removed->at(position, direction) : 0.0;
  return table.added.at(position, direction) - before;
}

/// r at the ends of a gap and wherever the table bends between them: the largest by amount.
double largest_residual(const MeanOnWay& a, const MeanOnWay& b, const TableInControl& table, Direction direction,
                        double zero) {
  double largest = 0.0;
  const auto see = [&](double position) {
    const double share = (position - a.position) / (b.position - a.position);
    const double r = a.mean + share * (b.mean - a.mean) + change_at(table, position, direction) - zero;
    if (std::abs(r) > std::abs(largest)) largest = r;
  };
  see(a.position);
  see(b.position);
  for (const AxisCorrection* one : {&table.added, table.removed}) {
    if (one == nullptr) continue;
    const auto& nodes = one->positions();
    for (auto at = std::ranges::upper_bound(nodes, a.position); at != nodes.end() && *at < b.position; ++at) see(*at);
  }
  return largest;
}

std::vector<MeanOnWay> means_on_way(const iso230_2::Evaluation& measured, Direction direction) {
  std::vector<MeanOnWay> means;
  for (std::size_t i = 0; i < measured.positions.size(); ++i) {
    const iso230_2::PositionResult& p = measured.positions[i];
    const bool up = direction == Direction::up;
    if (const auto& mean = up ? p.mean_up : p.mean_down)
      means.push_back({i, p.target.in_native(), mean->in_native(), up ? p.count_up : p.count_down});
  }
  return means;
}

/// Of one direction, for compensated_positions() alone.
class Way {
 public:
  Way(const iso230_2::Evaluation& measured, const TableInControl& table, Direction direction)
      : measured_(measured), table_(table), direction_(direction), means_(means_on_way(measured, direction)) {}

  const std::vector<MeanOnWay>& means() const { return means_; }
  double before_zero(const MeanOnWay& m) const { return m.mean + change_at(table_, m.position, direction_); }

  CompensatedMean at(const MeanOnWay& m, double zero, const iso230_2::GumUncertainty* gum) const {
    CompensatedMean found{before_zero(m) - zero,
                          table_.added.at(m.position, direction_) - table_.unrounded.at(m.position, direction_),
                          {},
                          {},
                          {}};
    const iso230_2::PositionResult& p = measured_.positions[m.target];
    const auto& s = direction_ == Direction::up ? p.s_up : p.s_down;
    if (!s || m.count < 2 || gum == nullptr) return found;
    const iso230_2::PositionUncertainty& known = gum->positions[m.target];
    const auto& components = direction_ == Direction::up ? known.up : known.down;
    if (!components) return found;
    found.s = s->in_native();
    found.mean = components->total;
    found.approach = of_approach(components->total, *found.s, static_cast<double>(m.count));
    return found;
  }

  /// (9) between means `k` and `k + 1`.
  CompensatedGap gap(std::size_t k, double zero, const std::optional<CompensatedMean>& first,
                     const std::optional<CompensatedMean>& last, const std::optional<Component>& q) const {
    const MeanOnWay &a = means_[k], &b = means_[k + 1];
    CompensatedGap gap{Position::native(a.position), Position::native(b.position),
                       largest_residual(a, b, table_, direction_, zero), std::nullopt};
    if (!first || !last || !first->mean || !last->mean || !q) return gap;
    const bool first_mean = first->mean->u.in_native() > last->mean->u.in_native(), first_s = *first->s > *last->s;
    const ExpandedUncertainty& mean = first_mean ? *first->mean : *last->mean;
    ComponentSum sum;
    sum.add({mean.u.in_native(), freedom_of(mean)});
    sum.add({first_s ? *first->s : *last->s, static_cast<double>((first_s ? a : b).count) - 1.0});
    sum.add(*q);
    gap.approach = sum.expanded();
    return gap;
  }

 private:
  const iso230_2::Evaluation& measured_;
  const TableInControl& table_;
  Direction direction_;
  std::vector<MeanOnWay> means_;
};

/// The largest |r| + U; nothing more once one is not known.
class LargestBound {
 public:
  void see(double residual, const std::optional<ExpandedUncertainty>& u) {
    known_ = known_ && u.has_value();
    if (u) most_ = std::max(most_, std::abs(residual) + u->U.in_native());
  }
  std::optional<double> most() const { return known_ ? std::optional(most_) : std::nullopt; }

 private:
  bool known_ = true;
  double most_ = 0.0;
};

double zero_of(const std::array<Way, 2>& ways) {
  double sum = 0.0, count = 0.0;
  for (const Way& way : ways)
    for (const MeanOnWay& m : way.means()) sum += way.before_zero(m), count += 1.0;
  return count > 0.0 ? sum / count : 0.0;
}

bool knows_scatter_alone(const iso230_2::GumUncertainty& gum) {
  return std::ranges::all_of(gum.sources, [](const iso230_2::GumSource& source) { return source.key == "approaches"; });
}

}  // namespace

Result<CompensatedPositions> compensated_positions(const Test& test, const TableInControl& table) {
  Test machine = test;  // what it will do, not what this test was
  machine.metadata.gum.measurand = Measurand::this_machine;
  const iso230_2::Evaluation measured = iso230_2::evaluate(machine.series);
  AXIOMETRY_TRY(const auto gum, iso230_2::gum(machine, measured));
  const std::array<Way, 2> ways{Way(measured, table, Direction::up), Way(measured, table, Direction::down)};
  CompensatedPositions found;
  found.zero = zero_of(ways);
  for (const iso230_2::PositionResult& p : measured.positions) found.targets.push_back({p.target, {}, {}});
  LargestBound at_targets, anywhere;
  for (std::size_t d = 0; d < ways.size(); ++d) {
    const auto& means = ways[d].means();
    const auto of = [&](std::size_t k) -> std::optional<CompensatedMean>& {
      CompensatedTarget& target = found.targets[means[k].target];
      return d == 0 ? target.up : target.down;
    };
    const auto q = means.empty() ? std::nullopt : between_targets(means);
    if (q) found.between_targets[d] = q->u;
    for (std::size_t k = 0; k < means.size(); ++k) {
      of(k) = ways[d].at(means[k], found.zero, gum ? &*gum : nullptr);
      at_targets.see(of(k)->residual, of(k)->approach);
      anywhere.see(of(k)->residual, of(k)->approach);
    }
    for (std::size_t k = 0; k + 1 < means.size(); ++k) {
      const CompensatedGap gap = ways[d].gap(k, found.zero, of(k), of(k + 1), q);
      anywhere.see(gap.residual, gap.approach);
      found.gaps[d].push_back(gap);
    }
  }
  found.at_targets = at_targets.most();
  found.anywhere = anywhere.most();
  if (!gum || knows_scatter_alone(*gum))
    found.notes.emplace_back(
        "nothing is stated of the uncertainty of instrument, temperatures and alignment: only the scatter of the "
        "approaches counts");
  return found;
}

}  // namespace axiometry::compensation
