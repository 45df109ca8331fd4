// SPDX-License-Identifier: Apache-2.0
//
// The axis is spelled as in the test format and comes from the same table of metadata, so that an axis can be
// copied from one file into the other.
#include "axiometry/formats/plan/plan_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/test/metadata_json.h"
#include "axiometry/formats/test/test_schema.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

constexpr TestCycle cycles[] = {TestCycle::standard, TestCycle::step, TestCycle::pilgrim, TestCycle::unidirectional,
                                TestCycle::user_defined};

std::unexpected<Error> wrong_kind(std::string_view name, const Value& value, std::string_view expected) {
  return fail(
      fmt::format("found \"{}\" that is of the kind {}, expected {}", name, json::kind_name(value.kind()), expected),
      value.at());
}

Result<std::string> text_from(std::string_view name, const Value& value) {
  if (!value.is(Kind::text)) return wrong_kind(name, value, "a string");
  return value.text();
}

Result<std::string> date_from(std::string_view name, const Value& value) {
  AXIOMETRY_TRY(std::string date, text_from(name, value));
  AXIOMETRY_TRY_VOID(placed(check_plan_date(date), value.at()));
  return date;
}

/// Under the name of another standard or clause a plan would be judged and walked as one after it.
template <const auto& known>
Result<std::string> known_text(std::string_view name, const Value& value) {
  AXIOMETRY_TRY(std::string text, text_from(name, value));
  if (std::ranges::find(known, text) != std::end(known)) return text;
  return fail(fmt::format("found the {} {}, expected one of {}", name, text::quoted(text), fmt::join(known, ", ")),
              value.at());
}

Result<double> number_from(std::string_view name, const Value& value) {
  if (!value.is(Kind::number)) return wrong_kind(name, value, "a number");
  return value.number();
}

Result<std::size_t> count_from(std::string_view name, const Value& value) {
  AXIOMETRY_TRY(const double x, number_from(name, value));
  if (x >= 0.0 && x < exact_whole_numbers && x == std::floor(x)) return static_cast<std::size_t>(x);
  return fail(fmt::format("found \"{}\" {}, expected a whole number of 0 or more", name, format_exact(x)), value.at());
}

Result<std::uint64_t> seed_from(std::string_view name, const Value& value) {
  if (value.is(Kind::number)) {
    if (const auto count = count_from(name, value)) return *count;
  } else if (value.is(Kind::text)) {
    if (const auto seed = parse_count(value.text())) return *seed;
  }
  const std::string found = value.is(Kind::number) ? format_exact(value.number())
                            : value.is(Kind::text) ? text::quoted(value.text())
                                                   : std::string(json::kind_name(value.kind()));
  return fail(
      fmt::format("found the {} {}, expected a whole number below 2^53, or one below 2^64 as a string", name, found),
      value.at());
}

Result<TestCycle> cycle_from(std::string_view name, const Value& value) {
  AXIOMETRY_TRY(const std::string word, text_from(name, value));
  for (TestCycle cycle : cycles)
    if (cycle_name(cycle) == word) return cycle;
  const auto words = cycles | std::views::transform(cycle_name);
  return fail(fmt::format("found the cycle {}, expected one of {}", text::quoted(word), fmt::join(words, ", ")),
              value.at());
}

Result<std::vector<MotionName>> errors_from(std::string_view name, const Value& list) {
  if (!list.is(Kind::array)) return wrong_kind(name, list, "an array of names such as \"EYX\"");
  std::vector<MotionName> errors;
  for (const Value& item : list.items()) {
    AXIOMETRY_TRY(const std::string word, text_from(name, item));
    AXIOMETRY_TRY(errors.emplace_back(), placed(motion_name(word), item.at()));
  }
  return errors;
}

Result<Axis> axis_from(std::string_view, const Value& value) {
  if (!value.is(Kind::object)) return wrong_kind("axis", value, "an object with at least its kind");
  if (value.find("kind") == nullptr)
    return fail("found no member \"kind\" in axis, expected \"linear\" or \"rotary\"", value.at());
  Value group = Value::object();
  group.add("axis", value);
  AXIOMETRY_TRY(Metadata metadata, metadata_from(group, {}));
  return metadata.axis;
}

/// [[0, 0, 500], [10, 20, 500]]
Result<std::vector<Vector3>> way_from(std::string_view name, const Value& list) {
  if (!list.is(Kind::array)) return wrong_kind(name, list, "an array of points [x, y, z]");
  std::vector<Vector3> way;
  for (const Value& item : list.items()) {
    if (!item.is(Kind::array) || item.items().size() != 3)
      return fail(fmt::format("found a point of \"{}\" that is none, expected [x, y, z] in mm", name), item.at());
    Vector3& point = way.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      AXIOMETRY_TRY(point[k], number_from(name, item.items()[k]));
    }
  }
  return way;
}

/// The smallest plan that can be walked. With one member replaced, check_sound() judges that member.
Plan smallest_plan() {
  Plan plan;
  plan.targets = {Position::native(0.0)};
  plan.runs = 1;
  plan.overrun = Position::native(1.0);
  plan.feed = 1.0;
  return plan;
}

/// With a way it needs a line to lead to.
Plan smallest_plan_in_space() {
  Plan plan = smallest_plan();
  set_spatial_line(plan.axis, {{}, {1.0, 0.0, 0.0}});
  return plan;
}

/// Ascending; `rank` of a target as listed is its index among them.
struct Targets {
  std::vector<Position> ascending;
  std::vector<std::size_t> rank;
};

Result<Targets> targets_from(const Value& list) {
  if (!list.is(Kind::array)) return wrong_kind("targets", list, "an array of positions");
  const auto& items = list.items();
  std::vector<std::size_t> order(items.size());
  std::vector<Position> listed(items.size());
  for (std::size_t k = 0; k < items.size(); ++k) {
    order[k] = k;
    AXIOMETRY_TRY(const double x, number_from("targets", items[k]));
    listed[k] = Position::native(x);
    Plan probe = smallest_plan();
    probe.targets = {listed[k]};
    AXIOMETRY_TRY_VOID(placed(check_sound(probe), items[k].at()));
  }
  std::ranges::stable_sort(order, {}, [&](std::size_t k) { return listed[k]; });
  Targets targets{{}, std::vector<std::size_t>(items.size())};
  for (std::size_t k : order) {
    if (!targets.ascending.empty() && targets.ascending.back() == listed[k])
      return fail(
          fmt::format("found the target {} a second time, expected each once", format_exact(listed[k].in_native())),
          items[k].at());
    targets.rank[k] = targets.ascending.size();
    targets.ascending.push_back(listed[k]);
  }
  return targets;
}

/// [3, "up", 1]. The number of the target is its place in the file's list.
Result<Approach> approach_from(const Value& item, const Targets& targets) {
  constexpr std::string_view expected = "[number of the target, \"up\" or \"down\", number of the run]";
  if (!item.is(Kind::array) || item.items().size() != 3) return fail(fmt::format("expected {}", expected), item.at());
  const auto& parts = item.items();
  AXIOMETRY_TRY(const std::size_t target, count_from("sequence", parts[0]));
  if (target == 0 || target > targets.rank.size())
    return fail(fmt::format("found an approach to target {}, expected 1 to {}", target, targets.rank.size()),
                parts[0].at());
  AXIOMETRY_TRY(const std::string direction, text_from("sequence", parts[1]));
  if (direction != "up" && direction != "down")
    return fail(fmt::format("found {}, expected \"up\" or \"down\"", text::quoted(direction)), parts[1].at());
  AXIOMETRY_TRY(const std::size_t run, count_from("sequence", parts[2]));
  if (run == 0) return fail("found run 0, expected runs from 1", parts[2].at());
  return Approach{targets.rank[target - 1], direction == "up" ? Direction::up : Direction::down, run - 1};
}

Result<std::vector<Approach>> sequence_from(const Value& list, const Targets& targets) {
  if (!list.is(Kind::array)) return wrong_kind("sequence", list, "an array of approaches");
  std::vector<Approach> sequence;
  for (const Value& item : list.items()) {
    AXIOMETRY_TRY(sequence.emplace_back(), approach_from(item, targets));
  }
  return sequence;
}

/// The plan's members are sound; what may be wrong is how its ways fit its line, and its sequence its cycle. Names the
/// first approach with which it is.
Result<void> check_whole(const Plan& plan, const Value& root) {
  const auto sound = check_sound(plan);
  const Value* list = root.find("sequence");
  if (!spatial_line(plan.axis))
    for (const auto& [way, name] : {std::pair{&plan.way_in_mm, "way_in_mm"}, std::pair{&plan.way_out_mm, "way_out_mm"}})
      if (!way->empty()) return placed(sound, root.find(name)->at());
  if (sound || plan.sequence.empty()) return placed(sound, root.find("cycle")->at());
  Plan part = plan;
  const auto sound_up_to = [&](std::size_t count) {
    part.sequence.assign(plan.sequence.begin(), plan.sequence.begin() + static_cast<std::ptrdiff_t>(count));
    return check_sound(part).has_value();
  };
  std::size_t good = 0, bad = plan.sequence.size();
  while (bad - good > 1) {
    const std::size_t middle = good + (bad - good) / 2;
    (sound_up_to(middle) ? good : bad) = middle;
  }
  return placed(sound, list->items()[bad - 1].at());
}

constexpr std::string_view required_members[] = {"axis", "cycle", "targets", "runs", "overrun", "feed", "dwell_s"};
constexpr std::string_view passed_over[] = {"$schema", "findings", "duration_s", "request"};

using Take = Result<void> (*)(Plan&, std::string_view name, const Value&);
struct Member {
  std::string_view name;
  Take take;  ///< nullptr: plan_from() sees to it, which knows the other members
};

/// Takes what needs no check beyond its own.
template <auto Plan::*member, auto read>
Result<void> take(Plan& plan, std::string_view name, const Value& value) {
  AXIOMETRY_TRY(plan.*member, read(name, value));
  return {};
}

/// Takes what a plan that can be walked may have.
template <auto Plan::*member, auto read, auto smallest = smallest_plan>
Result<void> put(Plan& plan, std::string_view name, const Value& value) {
  Plan probe = smallest();
  AXIOMETRY_TRY(probe.*member, read(name, value));
  AXIOMETRY_TRY_VOID(placed(check_sound(probe), value.at()));
  plan.*member = probe.*member;
  return {};
}

Result<Position> position_from(std::string_view name, const Value& value) {
  AXIOMETRY_TRY(const double x, number_from(name, value));
  return Position::native(x);
}

Result<Duration> seconds_from(std::string_view name, const Value& value) {
  AXIOMETRY_TRY(const double x, number_from(name, value));
  return Duration::s(x);
}

/// First of all, since another format has other members.
Result<void> check_format(const Value& value) {
  if (value.is(Kind::text) && value.text() == plan_format_name) return {};
  if (value.is(Kind::text) && value.text() == tracking_plan_format_name)
    return fail("found a tracking plan of several lines, expected the plan of one test, such as one of its lines",
                value.at());
  return fail(
      fmt::format("found the \"format\" {}, expected \"{}\"",
                  value.is(Kind::text) ? text::quoted(value.text()) : std::string(json::kind_name(value.kind())),
                  plan_format_name),
      value.at());
}

constexpr Member members[] = {
    {"format", nullptr},
    {"standard", take<&Plan::standard, known_text<plan_standards>>},
    {"clause", take<&Plan::clause, known_text<plan_clauses>>},
    {"rule", take<&Plan::rule, text_from>},
    {"title", take<&Plan::title, text_from>},
    {"machine", take<&Plan::machine, text_from>},
    {"date", take<&Plan::date, date_from>},
    {"axis", put<&Plan::axis, axis_from>},
    {"errors", put<&Plan::errors, errors_from>},
    {"cycle", take<&Plan::cycle, cycle_from>},
    {"targets", nullptr},
    {"runs", put<&Plan::runs, count_from>},
    {"overrun", put<&Plan::overrun, position_from>},
    {"feed", put<&Plan::feed, number_from>},
    {"acceleration", put<&Plan::acceleration, number_from>},
    {"dwell_s", put<&Plan::dwell, seconds_from>},
    {"warm_up_runs", put<&Plan::warm_up_runs, count_from>},
    {"seed", take<&Plan::seed, seed_from>},
    {"way_in_mm", put<&Plan::way_in_mm, way_from, smallest_plan_in_space>},
    {"way_out_mm", put<&Plan::way_out_mm, way_from, smallest_plan_in_space>},
    {"sequence", nullptr},
    {"further", nullptr},
};

Result<void> take_member(Plan& plan, const std::string& name, const Value& value) {
  if (std::ranges::find(passed_over, std::string_view(name)) != std::end(passed_over)) return {};
  const auto* member = std::ranges::find(members, std::string_view(name), &Member::name);
  if (member == std::end(members)) {
    std::vector<std::string_view> known;
    for (const Member& m : members) known.push_back(m.name);
    const auto near = text::nearest(name, known);
    return fail(fmt::format("found the unknown member {} in the plan, expected {}", text::quoted(name),
                            near ? fmt::format("perhaps {}", text::quoted(*near))
                                 : fmt::format("one of {}", fmt::join(known, ", "))),
                value.at());
  }
  const bool required = std::ranges::find(required_members, member->name) != std::end(required_members);
  if (value.is(Kind::null) && !required) return {};
  return member->take == nullptr ? Result<void>() : member->take(plan, name, value);
}

/// The value of a member that may be absent or null.
const Value* given(const Value& root, std::string_view name) {
  const Value* value = root.find(name);
  return value != nullptr && !value->is(Kind::null) ? value : nullptr;
}

Result<Plan> plan_from(const Value& root, bool further) {
  if (!root.is(Kind::object)) return fail("found JSON that is no object, expected a plan", root.at());
  if (const Value* format = given(root, "format")) AXIOMETRY_TRY_VOID(check_format(*format));
  for (std::string_view name : required_members)
    if (root.find(name) == nullptr)
      return fail(
          fmt::format("found no member \"{}\" in the plan, expected {}", name, fmt::join(required_members, ", ")),
          root.at());
  Plan plan;
  for (const auto& [name, value] : root.members()) AXIOMETRY_TRY_VOID(take_member(plan, name, value));
  AXIOMETRY_TRY(Targets targets, targets_from(*root.find("targets")));
  plan.targets = targets.ascending;
  if (const Value* sequence = given(root, "sequence")) {
    AXIOMETRY_TRY(plan.sequence, sequence_from(*sequence, targets));
  }
  if (const Value* errors = given(root, "errors")) AXIOMETRY_TRY_VOID(placed(check_errors(plan), errors->at()));
  AXIOMETRY_TRY_VOID(plan.targets.empty() ? placed(check_sound(plan), root.find("targets")->at())
                                          : check_whole(plan, root));
  if (const Value* parts = given(root, "further")) {
    if (further) return fail("found a further plan with further plans, expected one level", parts->at());
    if (!parts->is(Kind::array)) return wrong_kind("further", *parts, "an array of plans");
    for (const Value& part : parts->items()) {
      AXIOMETRY_TRY(plan.further.emplace_back(), plan_from(part, true));
    }
  }
  return plan;
}

}  // namespace

Result<Plan> plan_from_value(const Value& value) { return plan_from(value, false); }

std::string plan_date_refusal(std::string_view date) {
  return fmt::format("found the date of the plan {}, expected a day such as 2026-11-21", text::quoted(date));
}

Result<void> check_plan_date(std::string_view date) {
  if (is_no_day(date)) return fail(plan_date_refusal(date));
  return {};
}

Result<Plan> read_plan(std::string_view bytes) {
  AXIOMETRY_TRY(const std::string_view text, utf8_text(bytes));
  AXIOMETRY_TRY(const Value root, json::parse(text));
  return plan_from(root, false);
}

}  // namespace axiometry::formats
