// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "axiometry/base/contract.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry {
namespace {

constexpr std::size_t approach_limit = 1'000'000;  // a plan is walked in memory

/// Of an overrun in mm or ° and of a feed in mm/min or °/min. Below it an overrun is lost in the rounding of a position
/// of 1e9; beyond these numbers and `dwell_limit_s` the sum of all times is no number.
constexpr double size_least = 1e-6;
constexpr double size_limit = 1e9;
constexpr double dwell_limit_s = 1e6;

Result<void> check_size(std::string_view what, double x) {
  if (x >= size_least && x <= size_limit) return {};
  return fail(fmt::format("found {} of {}, expected {} to {}", what, format_exact(x), size_least, size_limit));
}

Result<void> check_targets(const Plan& plan) {
  if (plan.targets.empty()) return fail("found a plan without targets, expected at least one");
  for (std::size_t i = 0; i < plan.targets.size(); ++i) {
    const double x = plan.targets[i].in_native();
    if (!std::isfinite(x) || std::abs(x) > largest_stated)
      return fail(fmt::format("found target {} at {}, expected a position within ±{}", i + 1, x, largest_stated));
    if (i > 0 && plan.targets[i - 1] >= plan.targets[i])
      return fail(fmt::format("found target {} at {} after {}, expected ascending targets", i + 1, format_exact(x),
                              format_exact(plan.targets[i - 1].in_native())));
  }
  return {};
}

Result<void> check_sequence(const Plan& plan) {
  const bool user_defined = plan.cycle == TestCycle::user_defined;
  if (user_defined && plan.sequence.empty())
    return fail("found a user-defined cycle without a sequence, expected the approaches in their order");
  if (!user_defined && !plan.sequence.empty())
    return fail(
        fmt::format("found a sequence of approaches in the {} cycle, expected one in the user-defined cycle only",
                    cycle_name(plan.cycle)));
  std::set<std::tuple<std::size_t, Direction, std::size_t>> seen;
  for (const Approach& a : plan.sequence) {
    if (a.target >= plan.targets.size())
      return fail(fmt::format("found an approach to target {}, expected 1 to {}", a.target + 1, plan.targets.size()));
    if (a.run >= plan.runs)
      return fail(fmt::format("found run {} in the sequence, expected 1 to {}", a.run + 1, plan.runs));
    if (!seen.emplace(a.target, a.direction, a.run).second)
      return fail(fmt::format("found run {} {} of target {} a second time in the sequence, expected each once",
                              a.run + 1, arrow(a.direction), a.target + 1));
  }
  return {};
}

/// Appends the moves that lead to an approach, from wherever the axis stands.
class Path {
 public:
  explicit Path(const Plan& plan) : plan_(plan), reach_(reach(plan)) { go(reach_.lowest); }

  void warm_up() {
    for (std::size_t run = 0; run < plan_.warm_up_runs; ++run) {
      go(reach_.highest);
      go(reach_.lowest);
    }
  }

  void approach(const Approach& a) {
    const double target = plan_.targets[a.target].in_native();
    const double towards = a.direction == Direction::up ? 1.0 : -1.0;
    const auto& last = moves_.back().approach;
    const bool same_pass = last && last->direction == a.direction && (target - at()) * towards > 0.0;
    const double begin = target - towards * plan_.overrun.in_native();
    // Straight on in one pass; else from an overrun's distance at least, which also takes the axis beyond the last
    // target before it turns.
    if (!same_pass && (begin - at()) * towards < 0.0) go(Position::native(begin));
    moves_.push_back({plan_.targets[a.target], a});
  }

  std::vector<PlannedMove> finish() && {
    go(reach_.lowest);
    return std::move(moves_);
  }

 private:
  double at() const { return moves_.back().to.in_native(); }

  void go(Position to) {
    if (!moves_.empty() && moves_.back().to == to) return;
    moves_.push_back({to, std::nullopt});
  }

  const Plan& plan_;
  Reach reach_;
  std::vector<PlannedMove> moves_;
};

/// A way in space needs a line in space, and both must be in reach of any machine.
Result<void> check_line(const Plan& plan) {
  const bool given = !plan.axis.line_origin_mm.empty() || !plan.axis.line_direction.empty();
  if (given && !spatial_line(plan.axis))
    return fail(
        "found an invalid line in space, expected three finite numbers for its origin and for its direction, not "
        "all zero, of a linear axis");
  if (!given && !(plan.way_in_mm.empty() && plan.way_out_mm.empty()))
    return fail("found a way in or out in space, expected a line in space for it to lead to");
  for (const auto* way : {&plan.way_in_mm, &plan.way_out_mm})
    for (const Vector3& point : *way)
      if (!is_finite(point) || norm(point) > largest_stated)
        return fail(fmt::format("found a way over ({}, {}, {}) mm, expected finite coordinates up to 1e9", point.x,
                                point.y, point.z));
  return {};
}

}  // namespace

Result<void> check_errors(const Plan& plan) {
  if (plan.errors.empty()) return {};
  if (plan.axis.kind != AxisKind::linear || !plan.axis.line_direction.empty())
    return fail(fmt::format("found {} in a plan of a rotary axis or of a line in space, expected one of a linear axis",
                            errors_text(plan)));
  for (std::size_t k = 0; k < plan.errors.size(); ++k) {
    const MotionName& error = plan.errors[k];
    if (!plan.axis.name.empty() && plan.axis.name != std::string(1, error.axis))
      return fail(fmt::format("found the error {} in a plan of the axis {}, expected one of that axis", error.text(),
                              text::quoted(plan.axis.name)));
    if (error.axis != plan.errors[0].axis)
      return fail(
          fmt::format("found {} and {} in one plan, expected errors of one axis", plan.errors[0].text(), error.text()));
    if (std::find(plan.errors.begin(), plan.errors.begin() + static_cast<std::ptrdiff_t>(k), error) !=
        plan.errors.begin() + static_cast<std::ptrdiff_t>(k))
      return fail(fmt::format("found {} twice in a plan, expected each error once", error.text()));
  }
  return {};
}

Result<void> check_acceleration(double acceleration) {
  constexpr double least = 1e-3, highest = 1e6;
  if (acceleration >= least && acceleration <= highest) return {};
  return fail(fmt::format("found the acceleration {}, expected {} to {}", format_exact(acceleration), least, highest));
}

Result<void> check_sound(const Plan& plan) {
  AXIOMETRY_TRY_VOID(check_targets(plan));
  AXIOMETRY_TRY_VOID(check_line(plan));
  AXIOMETRY_TRY_VOID(check_errors(plan));
  if (plan.runs == 0 || plan.runs > read_budget::runs)
    return fail(fmt::format("found {} runs, expected 1 to {}", plan.runs, read_budget::runs));
  AXIOMETRY_TRY_VOID(check_size("an overrun", plan.overrun.in_native()));
  AXIOMETRY_TRY_VOID(check_size("a feed", plan.feed));
  if (plan.acceleration) AXIOMETRY_TRY_VOID(check_acceleration(*plan.acceleration));
  if (!(plan.dwell.in_s() >= 0.0 && plan.dwell.in_s() <= dwell_limit_s))
    return fail(fmt::format("found a dwell of {} s, expected 0 to {}", plan.dwell.in_s(), dwell_limit_s));
  if (plan.warm_up_runs > read_budget::runs)
    return fail(fmt::format("found {} warm-up runs, expected at most {}", plan.warm_up_runs, read_budget::runs));
  AXIOMETRY_TRY_VOID(check_sequence(plan));
  const std::size_t passes = plan.cycle == TestCycle::unidirectional ? plan.runs : 2 * plan.runs;
  const std::size_t count = plan.cycle == TestCycle::user_defined ? plan.sequence.size() : plan.targets.size() * passes;
  if (count > approach_limit)
    return fail(fmt::format("found {} approaches, expected at most {}", count, approach_limit));
  for (const Plan& part : plan.further) {
    if (!part.further.empty()) return fail("found a further plan with further plans, expected one level");
    AXIOMETRY_TRY_VOID(check_sound(part));
  }
  return {};
}

bool measures_positions(const Plan& plan) {
  return plan.errors.empty() ||
         std::ranges::any_of(plan.errors, [](const MotionName& e) { return e.coordinate == e.axis; });
}

std::string errors_text(const Plan& plan) {
  std::string list;
  for (const MotionName& error : plan.errors) list += (list.empty() ? "" : ", ") + error.text();
  return list;
}

Result<void> check_measures_positions(const Plan& plan) {
  if (measures_positions(plan)) return {};
  return fail(fmt::format("found a plan made for {}, expected one of positions", errors_text(plan)));
}

std::vector<Approach> approaches(const Plan& plan) {
  const std::size_t m = plan.targets.size(), n = plan.runs;
  std::vector<Approach> list;
  const auto pass = [&](Direction direction, std::size_t run) {
    for (std::size_t k = 0; k < m; ++k) list.push_back({direction == Direction::up ? k : m - 1 - k, direction, run});
  };
  switch (plan.cycle) {
    case TestCycle::standard:
      for (std::size_t j = 0; j < n; ++j) {
        pass(Direction::up, j);
        pass(Direction::down, j);
      }
      break;
    case TestCycle::unidirectional:
      for (std::size_t j = 0; j < n; ++j) pass(Direction::up, j);
      break;
    case TestCycle::step:
      for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j)
          for (Direction direction : {Direction::up, Direction::down}) list.push_back({i, direction, j});
      break;
    case TestCycle::pilgrim:
      for (Direction direction : {Direction::up, Direction::down})
        for (std::size_t k = 0; k < m; ++k)
          for (std::size_t j = 0; j < n; ++j)
            list.push_back({direction == Direction::up ? k : m - 1 - k, direction, j});
      break;
    case TestCycle::user_defined: list = plan.sequence; break;
  }
  return list;
}

std::vector<PlannedMove> moves(const Plan& plan) {
  AXIOMETRY_CONTRACT(check_sound(plan).has_value());
  Path path(plan);
  path.warm_up();
  for (const Approach& a : approaches(plan)) path.approach(a);
  return std::move(path).finish();
}

Reach reach(const Plan& plan) {
  const double overrun = plan.overrun.in_native();
  return {Position::native(plan.targets.front().in_native() - overrun),
          Position::native(plan.targets.back().in_native() + overrun)};
}

std::string_view cycle_name(TestCycle cycle) {
  switch (cycle) {
    case TestCycle::standard: return "standard";
    case TestCycle::step: return "step";
    case TestCycle::pilgrim: return "pilgrim";
    case TestCycle::unidirectional: return "unidirectional";
    case TestCycle::user_defined: return "user-defined";
  }
  return "";
}

std::string_view cycle_label(TestCycle cycle) {
  switch (cycle) {
    case TestCycle::standard: return "";
    case TestCycle::step: return "step cycle (Annex B), not for acceptance";
    case TestCycle::pilgrim: return "pilgrim cycle, not for acceptance";
    case TestCycle::unidirectional: return "unidirectional cycle, not for acceptance";
    case TestCycle::user_defined: return "user-defined cycle, not for acceptance";
  }
  return "";
}

}  // namespace axiometry
