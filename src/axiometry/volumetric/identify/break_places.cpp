// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/break_places.h"

#include <algorithm>
#include <optional>

#include "axiometry/volumetric/identify/anomalies.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t least_beside_break = 2;      // readings; one alone may be an outlier
constexpr double thousandth = 13.815510557964274;  // by which χ² must fall: 2 ln 1000

/// χ² of some readings about the mean, or the straight line, of those among them that fit a stretch; as much as can be
/// for each other.
class SideCost {
 public:
  SideCost(bool drifts, double most) : drifts_(drifts), most_(most) {}

  void add(double along, double off_um, double weight) {
    if (weight * off_um * off_um > most_) {
      others_ += most_;
      return;
    }
    ++fitting_;
    weight_ += weight;
    x_ += weight * along;
    xx_ += weight * along * along;
    v_ += weight * off_um;
    xv_ += weight * along * off_um;
    vv_ += weight * off_um * off_um;
  }

  std::size_t fitting() const { return fitting_; }
  double value() const {
    if (fitting_ < 2) return others_;
    double left = vv_ - v_ * v_ / weight_;
    if (drifts_) {
      const double lean = xv_ - x_ * v_ / weight_;
      left -= lean * lean / (xx_ - x_ * x_ / weight_);
    }
    return others_ + std::max(0.0, left);
  }

 private:
  bool drifts_;
  double most_;
  std::size_t fitting_ = 0;
  double others_ = 0.0;
  double weight_ = 0.0, x_ = 0.0, xx_ = 0.0, v_ = 0.0, xv_ = 0.0, vv_ = 0.0;
};

/// A reading of one of two stretches, about what was fitted of each.
struct Held {
  std::size_t reading = 0;
  double weight = 0.0;  ///< weight of the reading divided by the robust variance
  double off_before_um = 0.0;
  double off_behind_um = 0.0;
};

/// A dead path and its drift over the readings of its stretch.
struct Course {
  double level_um = 0.0;
  double slope_um = 0.0;  ///< drift per reading
  double middle = 0.0;    ///< reading in the middle of the stretch

  double at(double reading) const { return level_um + slope_um * (reading - middle); }
};

/// As lengths have it: a longer dead path makes them shorter.
Course course_of(const Unknowns& unknowns, const State& state, std::size_t stretch) {
  const double last = static_cast<double>(unknowns.stretches[stretch].readings) - 1.0;
  Course course{-1000.0 * state.dead_paths_mm[stretch], 0.0, 0.5 * last};
  if (unknowns.drift && last > 0.0) course.slope_um = state.drifts_um[stretch] / last;
  return course;
}

/// All places of one break.
class PlaceSearch {
 public:
  PlaceSearch(std::vector<Held> held, bool drifts, double most) : held_(std::move(held)) {
    const double middle = 0.5 * static_cast<double>(held_.size());
    const auto along = [&](std::size_t k) { return static_cast<double>(k) - middle; };
    SideCost before(drifts, most), behind(drifts, most);
    costs_.resize(held_.size());
    for (std::size_t k = 0; k < held_.size(); ++k) {
      if (before.fitting() >= least_beside_break) costs_[k] = before.value();
      before.add(along(k), held_[k].off_before_um, held_[k].weight);
    }
    for (std::size_t k = held_.size(); k-- > 0;) {
      behind.add(along(k), held_[k].off_behind_um, held_[k].weight);
      if (behind.fitting() < least_beside_break) costs_[k].reset();
      if (costs_[k]) *costs_[k] += behind.value();
    }
  }

  std::optional<BreakPlace> found() const {
    std::optional<std::size_t> best;
    for (std::size_t k = 0; k < costs_.size(); ++k)
      if (costs_[k] && (!best || *costs_[k] < *costs_[*best])) best = k;
    if (!best) return std::nullopt;
    const auto is_likely = [&](std::size_t k) { return costs_[k] && *costs_[k] <= *costs_[*best] + thousandth; };
    std::size_t first = *best, last = *best;
    for (std::size_t k = 0; k < costs_.size(); ++k) {
      if (!is_likely(k)) continue;
      first = std::min(first, k);
      last = std::max(last, k);
    }
    return BreakPlace{held_[*best].reading, held_[first].reading, held_[last].reading};
  }

 private:
  std::vector<Held> held_;
  std::vector<std::optional<double>> costs_;  ///< cost of a break before each; none where a side has too few
};

}  // namespace

std::vector<BreakPlace> break_places(const Problem& everything, const State& state, std::span<const double> residuals,
                                     std::span<const std::size_t> breaks) {
  const Unknowns& unknowns = everything.unknowns;
  const double scale = robust_scale(everything, residuals);
  const double limit = outlier_limit(residuals.size());
  std::vector<std::vector<std::size_t>> readings(unknowns.stretches.size());
  for (std::size_t i = 0; i < residuals.size(); ++i) readings[unknowns.stretch_of[i]].push_back(i);
  std::vector<std::size_t> begin_of(unknowns.stretches.size(), 0);  // behind the readings in doubt of the last break
  std::vector<BreakPlace> places;
  for (const std::size_t break_before : breaks) {
    const std::size_t from = stretch_before(unknowns, break_before), to = unknowns.stretch_of[break_before];
    const Course before = course_of(unknowns, state, from), behind = course_of(unknowns, state, to);
    const double count = static_cast<double>(readings[from].size());
    std::vector<Held> held;
    const auto hold = [&](std::size_t i, double along, const Course& own, double own_along) {
      if (everything.weights[i] == 0.0 || i < begin_of[from]) return;
      const double length_um = residuals[i] + own.at(own_along);
      held.push_back({i, everything.weights[i] / (scale * scale), length_um - before.at(along),
                      length_um - behind.at(along - count)});
    };
    for (std::size_t k = 0; k < readings[from].size(); ++k)
      hold(readings[from][k], static_cast<double>(k), before, static_cast<double>(k));
    for (std::size_t k = 0; k < readings[to].size(); ++k)
      hold(readings[to][k], count + static_cast<double>(k), behind, static_cast<double>(k));
    const auto found = PlaceSearch(std::move(held), unknowns.drift, limit * limit + thousandth).found();
    places.push_back(found.value_or(BreakPlace{break_before, break_before, break_before}));
    begin_of[to] = places.back().latest;
  }
  return places;
}

}  // namespace axiometry::volumetric::detail
