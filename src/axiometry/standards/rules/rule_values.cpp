// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/rules/rule_values.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace axiometry::standards {
namespace {

bool both_run(const RuleCase& c) { return c.series.has_both_directions(); }

/// Smallest and largest of what is seen.
struct Span {
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  void see(double x) {
    lowest = std::min(lowest, x);
    highest = std::max(highest, x);
  }
};

}  // namespace

const std::optional<Deviation>& mean_of(const iso230_2::PositionResult& p, Direction direction) {
  return direction == Direction::up ? p.mean_up : p.mean_down;
}

const std::optional<Deviation>& s_of(const iso230_2::PositionResult& p, Direction direction) {
  return direction == Direction::up ? p.s_up : p.s_down;
}

std::string_view lack_of_reversal(const RuleCase& c) {
  if (!both_run(c)) return needs_both_directions;
  for (const auto& p : c.positions())
    if (!p.reversal) return needs_both_everywhere;
  return {};
}

std::string_view lack_of_scatter(const RuleCase& c) {
  if (const std::string_view lack = lack_of_reversal(c); !lack.empty()) return lack;
  for (const auto& p : c.positions())
    if (!p.s_up || !p.s_down) return needs_two_from_both;
  return {};
}

std::string_view lack_of_means(const RuleCase& c, Direction direction) {
  if (!c.series.has(direction)) return needs_this_direction;
  for (const auto& p : c.positions())
    if (!mean_of(p, direction)) return needs_reading_everywhere;
  return {};
}

std::string_view lack_of_scatter(const RuleCase& c, Direction direction) {
  if (const std::string_view lack = lack_of_means(c, direction); !lack.empty()) return lack;
  for (const auto& p : c.positions())
    if (!s_of(p, direction)) return needs_two;
  return {};
}

double largest_reversal(const RuleCase& c) {
  return largest(c, [](const auto& p) { return std::abs(p.reversal->in_native()); });
}

double range_of_bands(const RuleCase& c, double k) {
  Span all;
  for (const auto& p : c.positions())
    for (const Direction direction : {Direction::up, Direction::down}) {
      const double mean = mean_of(p, direction)->in_native(), s = s_of(p, direction)->in_native();
      all.see(mean + k * s);
      all.see(mean - k * s);
    }
  return all.highest - all.lowest;
}

double range_of_means(const RuleCase& c) { return range_of_bands(c, 0.0); }

std::size_t fewest_approaches(const RuleCase& c) {
  std::size_t least = c.series.run_count();
  for (std::size_t i = 0; i < c.positions().size(); ++i) {
    const auto& p = c.positions()[i];
    if (c.series.has(Direction::up)) least = std::min(least, p.count_up);
    if (c.series.has(Direction::down)) least = std::min(least, p.count_down);
  }
  return least;
}

void expect_approaches(const RuleCase& c, std::string id, std::size_t least, std::string_view what,
                       std::vector<iso230_2::Finding>& findings) {
  const std::size_t found = fewest_approaches(c);
  if (found >= least) return;
  findings.push_back({std::move(id), "", iso230_2::Severity::departure,
                      fmt::format("found {} approach{} to a target from one direction, expected {} or more for {}",
                                  found, found == 1 ? "" : "es", least, what)});
}

}  // namespace axiometry::standards
