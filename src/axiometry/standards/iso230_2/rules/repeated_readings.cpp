// SPDX-License-Identifier: Apache-2.0
//
// Clause 3.18: readings that stand in a test more than once, though each was to be measured, or in steps as wide as
// their scatter.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"

namespace axiometry::iso230_2::rules {
namespace {

/// Of the readings there are. Their s would not do: the mean of equal readings is rounded.
bool all_equal(std::span<const double> cell) {
  const auto first = std::ranges::find_if_not(cell, [](double x) { return std::isnan(x); });
  return std::all_of(first, cell.end(), [&](double x) { return std::isnan(x) || x == *first; });
}

struct RepeatedDirections {
  bool up = false;
  bool down = false;
};

/// In which directions every run has the same readings.
RepeatedDirections repeated_directions(const Case& c) {
  const auto repeats = [&](Direction direction) {
    for (std::size_t i = 0; i < c.series.target_count(); ++i)
      if (!all_equal(c.series.cell(i, direction))) return false;
    return true;
  };
  const AxisParameters& p = c.evaluation.parameters;
  return {p.R_up && repeats(Direction::up), p.R_down && repeats(Direction::down)};
}

/// A run in one direction: its readings at all targets, with the sign that makes the first one that is not 0 positive,
/// so that a copy with the other sign is the same.
struct OneWayRun {
  std::size_t run = 0;
  Direction direction = Direction::up;
  double sign = 1.0;

  double at(const Series& series, std::size_t target) const { return sign * series.cell(target, direction)[run]; }
  std::string name() const { return fmt::format("{}{}", run + 1, arrow(direction)); }
};

/// Those with a reading at every target.
std::vector<OneWayRun> one_way_runs(const Series& series) {
  std::vector<OneWayRun> all;
  for (const Direction direction : {Direction::up, Direction::down})
    for (std::size_t run = 0; run < series.run_count(); ++run) {
      OneWayRun made{run, direction};
      bool whole = true;
      double first = 0.0;
      for (std::size_t i = 0; whole && i < series.target_count(); ++i) {
        const double x = series.cell(i, direction)[run];
        whole = !std::isnan(x);
        if (first == 0.0) first = x;
      }
      made.sign = first < 0.0 ? -1.0 : 1.0;
      if (whole) all.push_back(made);
    }
  return all;
}

std::size_t agreements(const Series& series, const OneWayRun& a, const OneWayRun& b) {
  std::size_t agree = 0;
  for (std::size_t i = 0; i < series.target_count(); ++i)
    if (a.at(series, i) == b.at(series, i)) ++agree;
  return agree;
}

/// How many pairs of runs are to be expected equal at all m targets if they are honest: Σ p^m over the pairs of
/// different runs, p from the targets at which the two agree, which coarse readings do, and runs that were shifted
/// alike.
double expected_equal_pairs(const Series& series, std::span<const OneWayRun> different, std::size_t runs) {
  constexpr std::size_t looked_at = 32;  // runs: 496 pairs tell it
  different = different.first(std::min(different.size(), looked_at));
  const auto pairs_of = [](std::size_t n) { return 0.5 * static_cast<double>(n) * static_cast<double>(n - 1); };
  const auto m = static_cast<double>(series.target_count());
  double expected = 0.0;
  for (std::size_t a = 0; a < different.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      expected += std::pow((static_cast<double>(agreements(series, different[a], different[b])) + 1.0) / (m + 1.0), m);
  return expected * pairs_of(runs) / pairs_of(different.size());
}

/// Whether every reading has one of the other direction beside it, of its run at its target, that is the same.
bool directions_equal(const Series& series) {
  for (std::size_t i = 0; i < series.target_count(); ++i)
    if (!std::ranges::equal(series.cell(i, Direction::up), series.cell(i, Direction::down),
                            [](double a, double b) { return a == b; }))
      return false;
  return true;
}

/// Where chance is no measure: of one run, and of readings so coarse that they agree often.
std::optional<Finding> directions_copied(const Series& series) {
  if (!directions_equal(series)) return std::nullopt;
  return note("readings-copied", "3.18",
              "found every reading ↓ equal to the one ↑ of its run and target, expected some reversal or scatter "
              "between them; copied or coarsely rounded readings make every reversal error zero");
}

/// Whether a scatter is surely more than half of any step that the readings may have: a step divides each of them, so
/// it is no larger than the smallest. Of less than 1e-6 µm or ″ a reading is a 0 with what computed it.
bool surely_beyond_steps(const Series& series, double scatter) {
  double smallest = std::numeric_limits<double>::infinity();
  for (const Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i)
      for (const double x : series.cell(i, direction))
        if (std::abs(x) > 1e-6) smallest = std::min(smallest, std::abs(x));
  return scatter > 0.51 * smallest;
}

}  // namespace

std::optional<Finding> readings_repeat_exactly(const Case& c) {
  const AxisParameters& p = c.evaluation.parameters;
  const auto [up, down] = repeated_directions(c);
  if (!up && !down) return std::nullopt;
  if ((p.R_up && !up) || (p.R_down && !down)) {
    const std::string_view copied = up ? "↑" : "↓";
    return note("readings-repeat-exactly", "3.18",
                fmt::format("found the same reading {} in every run at every target, expected some scatter; copied or "
                            "coarsely rounded readings make R{} zero",
                            copied, copied));
  }
  return note("readings-repeat-exactly", "3.18",
              "found the same reading in every run at every target, expected some scatter; copied or coarsely "
              "rounded readings make every repeatability zero");
}

std::optional<Finding> readings_copied(const Case& c) {
  constexpr double hardly_ever = 0.01;  // share of honest tests that may look copied
  const Series& series = c.series;
  const auto [up, down] = repeated_directions(c);
  if (up || down) return std::nullopt;  // readings_repeat_exactly speaks
  std::vector<OneWayRun> runs = one_way_runs(series);
  const auto order = [&](const OneWayRun& a, const OneWayRun& b) {
    for (std::size_t i = 0; i < series.target_count(); ++i)
      if (const double x = a.at(series, i), y = b.at(series, i); x != y) return x < y;
    return false;
  };
  std::ranges::stable_sort(runs, order);
  std::vector<OneWayRun> different;
  const OneWayRun *copy = nullptr, *original = nullptr;
  for (const OneWayRun& run : runs) {
    if (different.empty() || order(different.back(), run))
      different.push_back(run);
    else if (copy == nullptr)
      copy = &run, original = &*std::ranges::lower_bound(runs, run, order);
  }
  const std::size_t copies = runs.size() - different.size();
  if (copy == nullptr || different.size() < 2)  // nothing tells how often readings agree honestly
    return directions_copied(series);
  const double expected = std::min(1.0, expected_equal_pairs(series, different, runs.size()));
  if (std::pow(expected, static_cast<double>(copies)) > hardly_ever) return directions_copied(series);
  return note(
      "readings-copied", "3.18",
      fmt::format("found {} of {} runs, each direction counted, equal to another at all {} targets, such as run {} "
                  "to run {}{}; chance hardly makes that, and what was copied was not measured",
                  copies, runs.size(), series.target_count(), copy->name(), original->name(),
                  copy->sign == original->sign ? "" : " with the other sign"));
}

/// A scatter of half a step holds at least a third of rounding, step²/12 of s²; of a smaller one nothing may be left.
std::optional<Finding> readings_coarsely_rounded(const Case& c) {
  constexpr double degrees_needed = 16.0;  // two runs of a short test may agree by chance
  double squares = 0.0, degrees = 0.0;
  for (std::size_t i = 0; i < c.series.target_count(); ++i)
    for (const Direction direction : {Direction::up, Direction::down}) {
      const PositionResult& position = c.evaluation.positions[i];
      const auto& s = direction == Direction::up ? position.s_up : position.s_down;
      if (!s) continue;
      const double of_cell = static_cast<double>(c.series.count(i, direction)) - 1.0;
      squares += of_cell * s->in_native() * s->in_native();
      degrees += of_cell;
    }
  if (degrees < degrees_needed || squares == 0.0 || readings_repeat_exactly(c)) return std::nullopt;
  const double scatter = std::sqrt(squares / degrees);
  const auto& resolution = c.metadata.gum.instrument_resolution;
  if (!resolution && surely_beyond_steps(c.series, scatter)) return std::nullopt;
  if (const double step = step_of(c.series); step > 0.0) {
    if (scatter > 0.5 * step) return std::nullopt;
    return note(
        "readings-coarsely-rounded", "3.18",
        message("found readings in steps of {} that scatter by {} about their means, no more than half a step: "
                    "rounding may have made or hidden as much, and s_i and what rests on it are those of the "
                    "steps as much as of the machine",
                    deviation_message(c, step), deviation_message(c, scatter)));
  }
  // Corrected or averaged, they show no steps themselves.
  if (!resolution || scatter > 0.5 * resolution->in_native()) return std::nullopt;
  return note(
      "readings-coarsely-rounded", "3.18",
      message("found readings that scatter by {} about their means, no more than half of the resolution of {} that "
                  "is stated: rounding may have made or hidden as much, and s_i and what rests on it are those of its "
                  "steps as much as of the machine",
                  deviation_message(c, scatter), deviation_message(c, resolution->in_native())));
}

}  // namespace axiometry::iso230_2::rules
