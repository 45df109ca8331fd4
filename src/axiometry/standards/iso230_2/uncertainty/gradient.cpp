// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/uncertainty/gradient.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <utility>

namespace axiometry::iso230_2 {
namespace {

using Terms = std::initializer_list<CellTerm>;

/// The largest values seen, as far as rounding cannot tell them apart, with what each depends on.
class Largest {
 public:
  void see(double value, Terms terms) { seen_.push_back({value, terms}); }
  void see(const Largest& other) { seen_.insert(seen_.end(), other.seen_.begin(), other.seen_.end()); }

  std::vector<Gradient> terms(double bound) const {
    std::vector<Gradient> tied;
    if (seen_.empty()) return tied;
    const double largest = std::ranges::max_element(seen_, {}, &Seen::value)->value;
    for (const Seen& seen : seen_)
      if (seen.value >= largest - bound) tied.push_back(seen.terms);
    if (tied.size() > 2 * tied_at_each_end) tied.erase(tied.begin() + tied_at_each_end, tied.end() - tied_at_each_end);
    return tied;
  }

 private:
  static constexpr std::ptrdiff_t tied_at_each_end = 8;
  struct Seen {
    double value = 0.0;
    Gradient terms;
  };
  std::vector<Seen> seen_;
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
  std::vector<Gradient> terms(double bound) const {
    std::vector<Gradient> combinations;
    const std::vector<Gradient> smallest_terms = smallest.terms(bound);
    for (const Gradient& high : largest.terms(bound))
      for (const Gradient& low : smallest_terms) {
        Gradient all = high;
        all.insert(all.end(), low.begin(), low.end());
        combinations.push_back(merged(std::move(all)));
      }
    return combinations;
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

  void see(std::size_t i, const PositionResult& p, double bound) {
    using enum Direction;
    if (!p.reversal) return;
    const double mean = p.mean->in_native();
    const double reversal = p.reversal->in_native();
    means.largest.see(mean, {{i, up, 0.5, 0.0}, {i, down, 0.5, 0.0}});
    means.smallest.see(-mean, {{i, up, -0.5, 0.0}, {i, down, -0.5, 0.0}});
    const double s = (p.s_up ? p.s_up->in_native() : 0.0) + (p.s_down ? p.s_down->in_native() : 0.0);
    for (const double sign : {1.0, -1.0}) {
      if (sign * reversal < -bound) continue;  // a reversal of 0 has both signs
      B.see(std::abs(reversal), {{i, up, sign, 0.0}, {i, down, -sign, 0.0}});
      R.see(coverage_factor * s + std::abs(reversal),
            {{i, up, sign, p.s_up ? coverage_factor : 0.0}, {i, down, -sign, p.s_down ? coverage_factor : 0.0}});
    }
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

double tie_bound(const Evaluation& evaluation) {
  constexpr double native_per_position = 3600.0;  // ″ per °; µm per mm are fewer
  double largest = 0.0;
  double n = 0.0;
  for (const PositionResult& p : evaluation.positions) {
    const double count = static_cast<double>(std::max(p.count_up, p.count_down));
    n = std::max(n, count);
    const double position = native_per_position * std::abs(p.target.in_native());
    for (const auto& [mean, s] : {std::pair(p.mean_up, p.s_up), std::pair(p.mean_down, p.s_down)}) {
      if (!mean) continue;
      // No reading is farther from the mean than √n s.
      const double spread = s ? std::sqrt(count) * s->in_native() : 0.0;
      largest = std::max(largest, std::abs(mean->in_native()) + spread + position);
    }
  }
  return (8.0 * n + 32.0) * std::numeric_limits<double>::epsilon() * largest;
}

std::array<std::vector<Gradient>, std::size(parameters)> parameter_gradients(const Evaluation& evaluation) {
  const double bound = tie_bound(evaluation);
  DirectionParts up;
  DirectionParts down;
  BothParts both;
  for (std::size_t i = 0; i < evaluation.positions.size(); ++i) {
    const PositionResult& p = evaluation.positions[i];
    up.see(i, Direction::up, p.mean_up, p.s_up);
    down.see(i, Direction::down, p.mean_down, p.s_down);
    both.see(i, p, bound);
  }
  Range E = up.means;
  E.see(down.means);
  Range A = up.boundaries;
  A.see(down.boundaries);
  Largest R = both.R;
  R.see(up.R);
  R.see(down.R);

  // In the order of `parameters`.
  std::array<std::vector<Gradient>, std::size(parameters)> gradients = {A.terms(bound),
                                                                        up.boundaries.terms(bound),
                                                                        down.boundaries.terms(bound),
                                                                        E.terms(bound),
                                                                        up.means.terms(bound),
                                                                        down.means.terms(bound),
                                                                        both.means.terms(bound),
                                                                        R.terms(bound),
                                                                        up.R.terms(bound),
                                                                        down.R.terms(bound),
                                                                        both.B.terms(bound),
                                                                        {mean_reversal(evaluation.positions)}};
  for (std::size_t k = 0; k < gradients.size(); ++k)
    if (!(evaluation.parameters.*parameters[k].member)) gradients[k].clear();
  return gradients;
}

}  // namespace axiometry::iso230_2
