// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/compensated_positions.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/standards/iso230_2/inputs/uncorrected_effects.h"
#include "axiometry/standards/iso230_2/monte_carlo/gross_errors.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"
#include "axiometry/standards/iso230_2/uncertainty/gum_model.h"
#include "axiometry/standards/readings/reading_change.h"
#include "axiometry/standards/readings/test_course.h"

namespace axiometry::compensation {
namespace {

using iso230_2::Component;
using iso230_2::ComponentSum;
using iso230_2::ExpandedUncertainty;

constexpr double no_limit = iso230_2::infinite;
constexpr double wide_gap = 2.0;  // of the mean gap, as of targets after 5.2; beyond it nothing is told by the others

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
  const double q = std::max(D1 / 16.0, 4.0 / 3.0 * D1 - 61.0 / 720.0 * std::max(0.0, D2 - D1));
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

/// 0 of fewer than two means.
double mean_gap_of(const std::vector<MeanOnWay>& means) {
  if (means.size() < 2) return 0.0;
  return (means.back().position - means.front().position) / static_cast<double>(means.size() - 1);
}

/// Of one direction, for compensated_positions() alone.
class Way {
 public:
  Way(const iso230_2::Evaluation& measured, const TableInControl& table, Direction direction)
      : measured_(measured),
        table_(table),
        direction_(direction),
        means_(means_on_way(measured, direction)),
        mean_gap_(mean_gap_of(means_)) {}

  const std::vector<MeanOnWay>& means() const { return means_; }
  /// Whether the gap behind mean `k` is one of which the others do not tell.
  bool wide(std::size_t k) const { return gaps_in(k) > wide_gap * (1.0 + 1e-9); }
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
    if (!first || !last || !first->mean || !last->mean || !q || wide(k)) return gap;
    const bool first_mean = first->mean->u.in_native() > last->mean->u.in_native(), first_s = *first->s > *last->s;
    const ExpandedUncertainty& mean = first_mean ? *first->mean : *last->mean;
    ComponentSum sum;
    sum.add({mean.u.in_native(), freedom_of(mean)});
    sum.add({first_s ? *first->s : *last->s, static_cast<double>((first_s ? a : b).count) - 1.0});
    const double bow = std::max(1.0, gaps_in(k) * gaps_in(k));  // grows with the square
    sum.add({bow * q->u, q->degrees_of_freedom});
    gap.approach = sum.expanded();
    return gap;
  }

 private:
  /// The gap behind mean `k`, in mean gaps.
  double gaps_in(std::size_t k) const { return (means_[k + 1].position - means_[k].position) / mean_gap_; }

  const iso230_2::Evaluation& measured_;
  const TableInControl& table_;
  Direction direction_;
  std::vector<MeanOnWay> means_;
  double mean_gap_;
};

/// The largest |r| + U; nothing more once one is not known.
class LargestBound {
 public:
  void see(double residual, const std::optional<ExpandedUncertainty>& u) {
    known_ = known_ && u.has_value();
    if (u) most_ = std::max(most_, std::abs(residual) + u->U.in_native());
  }
  /// With what it may be off beside U.
  std::optional<double> most(const std::optional<double>& more) const {
    return known_ && more ? std::optional(most_ + *more) : std::nullopt;
  }

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

/// What U does not hold.
struct Caveats {
  std::vector<std::string> notes;
  std::optional<double> more = 0.0;  ///< by how much positions may be off beside it; absent where nobody can tell
};

void add_uncorrected(Caveats& caveats, const Test& test) {
  const auto effects = iso230_2::uncorrected_effects(test);
  const auto targets = test.series.targets();
  const double datum = datum_of(test).in_native(), travel = test.series.travel_native();
  const double farthest =
      std::max(std::abs(targets.front().in_native() - datum), std::abs(targets.back().in_native() - datum));
  const double lever = travel > 0.0 ? std::max(1.0, farthest / travel) : 1.0;  // sizes are those over the travel
  for (const iso230_2::UncorrectedEffect& effect : effects) {
    const double own = effect.key == "dead-path" ? 1.0 : lever;  // the same at every position
    caveats.notes.push_back(effect.reason());
    if (!effect.on_lengths || !effect.on_repeats)
      caveats.more.reset();
    else if (caveats.more)
      *caveats.more += std::max(own * effect.on_lengths->in_native(), effect.on_repeats->in_native());
  }
  if (effects.empty()) return;
  caveats.notes.emplace_back(
      caveats.more ? "what such an effect may amount to is added to the largest that is stated, not to U of a target"
                   : "to within what positions are known is not stated: nobody knows how large such an effect is");
}

void add_gross_errors(Caveats& caveats, const Test& test) {
  const double step = iso230_2::step_of(test.as_measured ? *test.as_measured : test.series);
  const auto errors = iso230_2::gross_errors(test.series, course_of(test), step);
  if (errors.empty()) return;
  caveats.more.reset();
  caveats.notes.push_back(iso230_2::reason_of(errors, test));
  caveats.notes.emplace_back(
      "to within what positions are known is not stated: no scatter explains all of the readings");
}

bool is_of_instrument(const iso230_2::UncertaintyInput& input) {
  using iso230_2::Effect;
  if (input.key == "environment" || input.key.ends_with("_resolution") || input.key == "probing") return false;
  return input.effect == Effect::scale || input.effect == Effect::displacement || input.effect == Effect::target ||
         input.effect == Effect::target_direction;
}

/// Groups of inputs of which nothing is stated.
void add_missing(Caveats& caveats, const iso230_2::UncertaintyInputs& inputs, AxisKind kind) {
  using iso230_2::Effect;
  bool instrument = false, temperatures = kind != AxisKind::linear, alignment = temperatures;
  for (const iso230_2::UncertaintyInput& input : inputs.inputs) {
    instrument = instrument || is_of_instrument(input);
    temperatures =
        temperatures || input.effect == Effect::machine_expansion || input.effect == Effect::machine_temperature;
    alignment = alignment || input.effect == Effect::alignment || input.effect == Effect::station;
  }
  if (!instrument)
    caveats.notes.emplace_back("the calibration of the instrument is not in U: nothing is stated of its uncertainty");
  if (!temperatures)
    caveats.notes.emplace_back(
        "temperatures and expansion of the machine are not in U: nothing is stated of their uncertainty");
  if (!alignment) caveats.notes.emplace_back("the alignment is not in U: nothing is stated of its uncertainty");
}

/// Why some place has no U, and what that of places between targets does not hold.
void add_of_places(Caveats& caveats, const std::array<Way, 2>& ways, const CompensatedPositions& found) {
  bool once = false, few = false, wide = false;
  for (const CompensatedTarget& target : found.targets)
    for (const auto* side : {&target.up, &target.down}) once = once || (*side && !(*side)->approach);
  for (const Way& way : ways) {
    const std::size_t count = way.means().size();
    few = few || count == 2;
    for (std::size_t k = 0; k + 1 < count; ++k) wide = wide || (count > 2 && way.wide(k));
  }
  if (once)
    caveats.notes.emplace_back(
        "to within what positions are known is not stated: it takes two approaches to every target");
  if (few) caveats.notes.emplace_back("what is between the targets is not stated: it takes three of them");
  if (wide)
    caveats.notes.emplace_back(
        "what is between targets over twice as far apart as they are on average is not stated: the other gaps do not "
        "tell");
  caveats.notes.emplace_back(
      "an error that repeats from target to target alike, as with the pitch of a screw, is not in what is stated "
      "between the targets");
}

}  // namespace

Result<CompensatedPositions> compensated_positions(const Test& test, const TableInControl& table) {
  Test machine = test;  // a test of what the machine will do, not of what it did
  machine.metadata.gum.measurand = Measurand::this_machine;
  const iso230_2::Evaluation measured = iso230_2::evaluate(machine.series);
  AXIOMETRY_TRY(const auto gum, iso230_2::gum(machine, measured));
  AXIOMETRY_TRY(const auto inputs,
                iso230_2::uncertainty_inputs(machine.metadata, machine.series, machine.provenance.stated));
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
  Caveats caveats;
  add_uncorrected(caveats, test);
  add_gross_errors(caveats, test);
  add_missing(caveats, inputs, test.metadata.axis.kind);
  if (gum)
    caveats.notes.insert(caveats.notes.end(), gum->notes.begin(),
                         gum->notes.begin() + static_cast<std::ptrdiff_t>(gum->position_notes));
  add_of_places(caveats, ways, found);
  found.at_targets = at_targets.most(caveats.more);
  found.anywhere = anywhere.most(caveats.more);
  found.notes = std::move(caveats.notes);
  return found;
}

}  // namespace axiometry::compensation
