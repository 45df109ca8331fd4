// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2_gradient.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>

namespace axiometry::iso230_2 {
namespace {

using Terms = std::initializer_list<CellTerm>;

/// The largest value seen, with what it depends on.
class Largest {
 public:
  void see(double value, Terms terms) {
    if (value_ && *value_ >= value) return;
    value_ = value;
    terms_ = terms;
  }
  void see(const Largest& other) {
    if (!other.value_ || (value_ && *value_ >= *other.value_)) return;
    *this = other;
  }
  const Gradient& terms() const { return terms_; }

 private:
  std::optional<double> value_;
  Gradient terms_;
};

/// Terms of the same target and direction in one, without those that have cancelled.
Gradient merged(Gradient terms) {
  Gradient result;
  for (const CellTerm& term : terms) {
    const auto same = std::ranges::find_if(result, [&](const CellTerm& other) {
      return other.target == term.target && other.direction == term.direction;
    });
    if (same == result.end()) {
      result.push_back(term);
    } else {
      same->by_mean += term.by_mean;
      same->by_s += term.by_s;
    }
  }
  std::erase_if(result, [](const CellTerm& term) { return term.by_mean == 0.0 && term.by_s == 0.0; });
  return result;
}

/// Largest and smallest, the latter as the largest negative.
struct Range {
  Largest largest;
  Largest smallest;

  void see(const Range& other) {
    largest.see(other.largest);
    smallest.see(other.smallest);
  }
  Gradient terms() const {
    Gradient all = largest.terms();
    all.insert(all.end(), smallest.terms().begin(), smallest.terms().end());
    return merged(std::move(all));
  }
};

struct DirectionParts {
  Range means;
  Range boundaries;
  Largest R;

  void see(std::size_t i, Direction direction, std::optional<Deviation> mean, std::optional<Deviation> s) {
    if (!mean) return;
    const double x = mean->in_native();
    const double band = s ? coverage_factor * s->in_native() : 0.0;
    const double by_s = s ? coverage_factor : 0.0;
    means.largest.see(x, {{i, direction, 1.0, 0.0}});
    means.smallest.see(-x, {{i, direction, -1.0, 0.0}});
    boundaries.largest.see(x + band, {{i, direction, 1.0, by_s}});
    boundaries.smallest.see(-(x - band), {{i, direction, -1.0, by_s}});
    if (s) R.see(2.0 * band, {{i, direction, 0.0, 2.0 * coverage_factor}});
  }
};

/// What needs both directions of a target.
struct BothParts {
  Range means;
  Largest B;
  Largest R;

  void see(std::size_t i, const PositionResult& p) {
    using enum Direction;
    if (!p.reversal) return;
    const double mean = p.mean->in_native();
    const double reversal = p.reversal->in_native();
    const double sign = reversal < 0.0 ? -1.0 : 1.0;
    means.largest.see(mean, {{i, up, 0.5, 0.0}, {i, down, 0.5, 0.0}});
    means.smallest.see(-mean, {{i, up, -0.5, 0.0}, {i, down, -0.5, 0.0}});
    B.see(std::abs(reversal), {{i, up, sign, 0.0}, {i, down, -sign, 0.0}});
    const double s = (p.s_up ? p.s_up->in_native() : 0.0) + (p.s_down ? p.s_down->in_native() : 0.0);
    R.see(coverage_factor * s + std::abs(reversal),
          {{i, up, sign, p.s_up ? coverage_factor : 0.0}, {i, down, -sign, p.s_down ? coverage_factor : 0.0}});
  }
};

Gradient mean_reversal(const std::vector<PositionResult>& positions) {
  Gradient terms;
  for (std::size_t i = 0; i < positions.size(); ++i) {
    if (!positions[i].reversal) continue;
    terms.push_back({i, Direction::up, 1.0, 0.0});
    terms.push_back({i, Direction::down, -1.0, 0.0});
  }
  const double count = static_cast<double>(terms.size()) / 2.0;
  for (CellTerm& term : terms) term.by_mean /= count;
  return terms;
}

}  // namespace

std::array<Gradient, std::size(parameters)> parameter_gradients(const Evaluation& evaluation) {
  DirectionParts up;
  DirectionParts down;
  BothParts both;
  for (std::size_t i = 0; i < evaluation.positions.size(); ++i) {
    const PositionResult& p = evaluation.positions[i];
    up.see(i, Direction::up, p.mean_up, p.s_up);
    down.see(i, Direction::down, p.mean_down, p.s_down);
    both.see(i, p);
  }
  Range E = up.means;
  E.see(down.means);
  Range A = up.boundaries;
  A.see(down.boundaries);
  Largest R = both.R;
  R.see(up.R);
  R.see(down.R);

  // In the order of `parameters`.
  std::array<Gradient, std::size(parameters)> gradients = {
      A.terms(),        up.boundaries.terms(), down.boundaries.terms(), E.terms(),
      up.means.terms(), down.means.terms(),    both.means.terms(),      R.terms(),
      up.R.terms(),     down.R.terms(),        both.B.terms(),          mean_reversal(evaluation.positions)};
  for (std::size_t k = 0; k < gradients.size(); ++k)
    if (!(evaluation.parameters.*parameters[k].member)) gradients[k].clear();
  return gradients;
}

}  // namespace axiometry::iso230_2
