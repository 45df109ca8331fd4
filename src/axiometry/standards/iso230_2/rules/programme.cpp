// SPDX-License-Identifier: Apache-2.0
//
// Clause 5: the test programme, and Annex B.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/says_nothing.h"
#include "axiometry/base/text/text.h"
#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"

namespace axiometry::iso230_2::rules {
namespace {

constexpr std::size_t named_at_most = 5;  // most names in the list of a message

bool many_approaches(Programme p) { return required_approaches(p) > 1; }

double mean_interval(const Case& c) { return c.travel() / static_cast<double>(c.series.target_count() - 1); }

std::string listed(const std::vector<std::string>& items) {
  const std::size_t shown = items.size() <= named_at_most + 1 ? items.size() : named_at_most;
  std::string list =
      fmt::format("{}", fmt::join(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(shown), ", "));
  if (shown < items.size()) list += fmt::format(" and {} more", items.size() - shown);
  return list;
}

/// Formula (1) asks for a random part within ±30 % of the interval or one expected period.
bool random_part_may_be_large(const Case& c) {
  const auto& period = c.metadata.axis.expected_period;
  return period && period->in_native() > 0.5 * mean_interval(c);
}

}  // namespace

bool may_serve_acceptance(std::string_view purpose) {
  const std::string word = text::to_lower(purpose);
  return text::says_nothing(word) || word.find("accept") != word.npos || word.find("verif") != word.npos;
}

std::optional<Finding> equally_spaced_targets(const Case& c) {
  const std::size_t m = c.series.target_count();
  const double p = mean_interval(c);
  for (std::size_t i = 1; i < m; ++i)
    if (std::abs(c.target(i) - c.target(i - 1) - p) > equal_interval * p) return std::nullopt;
  if (m < 3 || !c.metadata.artefact.calibrated_positions.empty()) return std::nullopt;  // a gauge has the steps it has
  return note(
      "equally-spaced-targets", "5.2",
      fmt::format(
          "found {} equally spaced targets (every {}), expected a random shift of each where the positions can be "
          "chosen: equal steps can hide a periodic error",
          m, position_text(c, p)));
}

std::optional<Finding> gap_between_targets(const Case& c) {
  const double p = mean_interval(c);
  std::size_t widest = 1;
  for (std::size_t i = 1; i < c.series.target_count(); ++i)
    if (c.target(i) - c.target(i - 1) > c.target(widest) - c.target(widest - 1)) widest = i;
  const double gap = c.target(widest) - c.target(widest - 1);
  if (gap <= 2.0 * p) return std::nullopt;
  return note(
      "gap-between-targets", "5.2",
      fmt::format("found {} between {} and {}, more than twice the mean interval of {}, expected targets spread evenly "
                  "but for the random shift",
                  position_text(c, gap), target_text(c, widest - 1), target_text(c, widest), position_text(c, p)));
}

std::optional<Finding> targets_on_compensation(const Case& c) {
  const auto& points = c.metadata.axis.compensation_points;
  std::vector<std::string> same;
  for (std::size_t i = 0; i < c.series.target_count(); ++i)
    if (std::ranges::any_of(points, [&](double x) { return std::abs(x - c.target(i)) <= same_position.in_native(); }))
      same.push_back(target_text(c, i));
  if (same.empty()) return std::nullopt;
  const std::string message = fmt::format("found {} of {} targets on sampling points of the compensation: {}",
                                          same.size(), c.series.target_count(), listed(same));
  if (!may_serve_acceptance(c.metadata.conditions.purpose))
    return note("targets-on-compensation", "5.2", message + "; not for acceptance or reverification");
  return departure("targets-on-compensation", "5.2",
                   message + ", expected other positions for acceptance or reverification");
}

std::optional<Finding> number_of_targets(const Case& c) {
  const std::size_t m = c.series.target_count();
  const RequiredTargets required = required_targets(c.programme, Position::native(c.travel()));
  if (m >= required.count) return std::nullopt;
  return departure("number-of-targets", programme_clause(c.programme),
                   fmt::format("found {} over {}, expected at least {} ({})", counted(m, "target"),
                               position_text(c, c.travel()), required.count, required.reason));
}

std::optional<Finding> principal_positions(const Case& c) {
  if (c.programme != Programme::one_turn) return std::nullopt;
  std::vector<std::string> absent;
  for (double principal : {0.0, 90.0, 180.0, 270.0}) {
    // The same orientation has several names: −90° is 270°.
    bool inside = false, measured = false;
    for (double turn : {-360.0, 0.0, 360.0}) {
      const double x = principal + turn;
      inside = inside || (x >= c.target(0) && x <= c.target(c.series.target_count() - 1));
      measured = measured || std::ranges::any_of(c.series.targets(), [&](Position p) {
                   return std::abs(p.in_native() - x) <= at_principal.in_native();
                 });
    }
    if (inside && !measured) absent.push_back(figure(principal) + "°");
  }
  if (absent.empty()) return std::nullopt;
  return note("principal-positions", "5.3.4",
              fmt::format("found no target at {}, expected these principal positions where practical", listed(absent)));
}

std::optional<Finding> directions_of_approach(const Case& c) {
  if (c.runs.up > 0 && c.runs.down > 0) return std::nullopt;
  const char* only = c.runs.up > 0 ? "↑" : "↓";
  return departure(
      "directions-of-approach", programme_clause(c.programme),
      fmt::format(
          "found approaches from one direction only ({}), expected {} from each; bidirectional parameters do not "
          "exist",
          only, many_approaches(c.programme) ? "five" : "one"));
}

std::optional<Finding> number_of_approaches(const Case& c) {
  const std::size_t expected = required_approaches(c.programme);
  const auto [up, down] = c.runs;
  const bool both = up > 0 && down > 0;
  const std::size_t either = std::max(up, down);
  if (up == expected && down == expected) return std::nullopt;
  if (!both && either == expected) return std::nullopt;  // directions_of_approach speaks
  const std::string found = both && up != down
                                ? fmt::format("{} ↑ and {} ↓", counted(up, "approach", "approaches"), down)
                                : fmt::format("{} approach{} {}", either, either == 1 ? "" : "es",
                                              both     ? "in each direction"
                                              : up > 0 ? "↑"
                                                       : "↓");
  const std::string_view consequence =
      expected == 1 && either > 1 ? "; R and A over such a travel are no parameters of the standard" : "";
  return departure("number-of-approaches", programme_clause(c.programme),
                   fmt::format("found {} over {}, expected {} in each direction{}", found, position_text(c, c.travel()),
                               expected, consequence));
}

std::optional<Finding> missing_readings(const Case& c) {
  if (c.series.complete()) return std::nullopt;
  std::vector<std::string> absent;
  for (Direction direction : {Direction::up, Direction::down}) {
    if ((direction == Direction::up ? c.runs.up : c.runs.down) == 0) continue;
    std::vector<bool> made(c.series.run_count(), false);
    for (std::size_t i = 0; i < c.series.target_count(); ++i)
      for (std::size_t j = 0; j < made.size(); ++j)
        if (!std::isnan(c.series.cell(i, direction)[j])) made[j] = true;
    for (std::size_t i = 0; i < c.series.target_count(); ++i) {
      if (c.series.count(i, direction) == 0) {
        absent.push_back(fmt::format("{} {} every run", target_text(c, i), arrow(direction)));
        continue;
      }
      for (std::size_t j = 0; j < made.size(); ++j)
        if (made[j] && std::isnan(c.series.cell(i, direction)[j]))
          absent.push_back(fmt::format("{} {} run {}", target_text(c, i), arrow(direction), j + 1));
    }
  }
  if (absent.empty()) return std::nullopt;
  return departure("missing-readings", programme_clause(c.programme),
                   fmt::format("found no reading at {}, expected one from every approach", listed(absent)));
}

/// Five runs are five, but who made six and kept five of them chose: numbers without a reading show it.
std::optional<Finding> runs_left_out(const Case& c) {
  if (c.series.complete()) return std::nullopt;
  std::vector<std::size_t> absent;
  for (std::size_t j = 0; j < c.series.run_count(); ++j) {
    bool read = false;
    for (std::size_t i = 0; !read && i < c.series.target_count(); ++i)
      read = !std::isnan(c.series.cell(i, Direction::up)[j]) || !std::isnan(c.series.cell(i, Direction::down)[j]);
    if (!read) absent.push_back(j + 1);
  }
  if (absent.empty()) return std::nullopt;
  const std::size_t last = c.series.run_count();
  return note("runs-left-out", programme_clause(c.programme),
              absent.size() == 1
                  ? fmt::format("found no reading of run {}, expected one of every run up to the last, run {}: nobody "
                                "can tell whether it was made and left out",
                                absent.front(), last)
                  : fmt::format("found no reading of {} runs, the first of them run {}, expected one of every run up "
                                "to the last, run {}: nobody can tell whether they were made and left out",
                                absent.size(), absent.front(), last));
}

std::optional<DirectionBlocks> directions_in_blocks(const Case& c) {
  if (c.runs.up < 2 || c.runs.down < 2 || c.series.complete()) return std::nullopt;
  std::size_t first[2] = {c.series.run_count(), c.series.run_count()}, last[2] = {0, 0};
  for (const Direction direction : {Direction::up, Direction::down}) {
    const auto d = static_cast<std::size_t>(direction);
    for (std::size_t i = 0; i < c.series.target_count(); ++i) {
      const auto cell = c.series.cell(i, direction);
      for (std::size_t j = 0; j < cell.size(); ++j)
        if (!std::isnan(cell[j])) first[d] = std::min(first[d], j + 1), last[d] = std::max(last[d], j + 1);
    }
  }
  for (const Direction earlier : {Direction::up, Direction::down}) {
    const auto e = static_cast<std::size_t>(earlier);
    if (last[e] < first[1 - e]) return DirectionBlocks{earlier, first[e], last[e], first[1 - e], last[1 - e]};
  }
  return std::nullopt;
}

/// In the standard test cycle every run goes there and back; what drifts while one direction is run after the other
/// makes a reversal error.
std::optional<Finding> runs_in_blocks(const Case& c) {
  const auto blocks = directions_in_blocks(c);
  if (!blocks) return std::nullopt;
  const Direction later = blocks->earlier == Direction::up ? Direction::down : Direction::up;
  return note("runs-in-blocks", programme_clause(c.programme),
              fmt::format("found by their numbers runs {} to {} all {} and runs {} to {} all {}, expected both "
                          "directions in turn (Figure 1): if they were made so, what drifted meanwhile stands in B",
                          blocks->first, blocks->last, arrow(blocks->earlier), blocks->later_first, blocks->later_last,
                          arrow(later)));
}

std::optional<Finding> more_than_five_turns(const Case& c) {
  if (c.programme != Programme::many_turns || c.travel() <= 1800.0 + 1e-6) return std::nullopt;
  return note("more-than-five-turns", "5.3.5",
              fmt::format("found {} measured, more than the five revolutions that the test covers",
                          position_text(c, c.travel())));
}

std::optional<Finding> cycle_declared_otherwise(const Case& c) {
  const bool both = c.runs.up > 0 && c.runs.down > 0;
  switch (c.metadata.conditions.cycle_or_standard()) {
    case TestCycle::pilgrim:
      return departure("cycle-declared-otherwise", programme_clause(c.programme),
                       "found the pilgrim cycle, expected the standard test cycle (Figure 1)");
    case TestCycle::user_defined:
      return departure("cycle-declared-otherwise", programme_clause(c.programme),
                       "found a user-defined cycle, expected the standard test cycle (Figure 1)");
    case TestCycle::unidirectional:
      if (!both) return std::nullopt;  // directions_of_approach speaks
      return departure("cycle-declared-otherwise", programme_clause(c.programme),
                       "found the cycle declared unidirectional and readings from both directions, expected "
                       "the standard test cycle (Figure 1)");
    case TestCycle::standard:
    case TestCycle::step: break;
  }
  return std::nullopt;
}

std::optional<Finding> additional_test(const Case& c) {
  if (c.programme == Programme::long_linear)
    return note(
        "additional-test", "5.3.3",
        c.travel() > 4000.0
            ? "the test with five approaches over one stretch of 2 000 mm, or several as agreed, is also needed (6.2)"
            : "the test with five approaches over 2 000 mm of the normal working area is also needed (6.2)");
  if (c.programme == Programme::many_turns)
    return note("additional-test", "5.3.5",
                "the test with five approaches over 360° of the normal working area is also needed (6.2)");
  const auto whole = axis_ends(c.metadata.axis).length_native();
  if (!whole || required_approaches(programme_of(c.kind(), Position::native(*whole))) > 1) return std::nullopt;
  return note(
      "additional-test", c.linear() ? "5.3.3" : "5.3.5",
      fmt::format(
          "the axis travels {}: the test over its whole travel with one approach from each direction is also needed",
          position_text(c, *whole)));
}

std::vector<Finding> unexplained(const Case& c) {
  std::vector<Finding> all;
  for (Rule* rule : {targets_within_axis_travel, equally_spaced_targets, gap_between_targets, additional_test}) {
    if (rule == gap_between_targets && random_part_may_be_large(c)) continue;
    auto finding = rule(c);
    if (!finding || finding->severity == Severity::departure) continue;  // departures are told by the rule itself
    finding->severity = Severity::missing;
    all.push_back(*std::move(finding));
  }
  return all;
}

std::optional<Finding> step_cycle(const Case& c) {
  if (c.metadata.conditions.cycle != TestCycle::step) return std::nullopt;
  return departure(
      "step-cycle", "Annex B",
      "found the step cycle, expected the standard test cycle (Figure 1): not for acceptance without special "
      "written agreement");
}

}  // namespace axiometry::iso230_2::rules
