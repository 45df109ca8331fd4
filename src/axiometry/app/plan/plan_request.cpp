// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/plan/plan_request.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <string>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/plan/plan_text.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/standards/rules/planned_rule.h"

namespace axiometry::app {
namespace {

using iso230_2::PlanRequest;
using iso230_2::Stretch;

constexpr std::string_view of_axis = "Axis", of_targets = "Targets", of_programme = "Programme";
constexpr std::size_t most_areas = 100;

Result<double> number_of(const std::string& text) {
  const auto x = parse_number(text);
  if (!x) return fail(fmt::format("found {}, expected a number", text::quoted(text)));
  return *x;
}

Result<unsigned long long> count_of(const std::string& text) {
  const auto count = parse_count(text);
  if (!count) return fail(fmt::format("found {}, expected a whole number", text::quoted(text)));
  return *count;
}

/// A number that becomes the value of a member by `make`.
template <auto member, auto make>
Result<void> put_number(const std::string& text, PlanRequestDraft& wish) {
  AXIOMETRY_TRY(const double x, number_of(text));
  std::invoke(member, wish.request) = make(x);
  return {};
}

template <auto member>
Result<void> put_position(const std::string& text, PlanRequestDraft& wish) {
  return put_number<member, Position::native>(text, wish);
}

template <auto member>
Result<void> put_plain(const std::string& text, PlanRequestDraft& wish) {
  return put_number<member, [](double x) { return x; }>(text, wish);
}

template <auto member>
Result<void> put_count(const std::string& text, PlanRequestDraft& wish) {
  AXIOMETRY_TRY(std::invoke(member, wish.request), count_of(text));
  return {};
}

template <auto member>
Result<void> put_text(const std::string& text, PlanRequestDraft& wish) {
  std::invoke(member, wish.request) = text;
  return {};
}

template <auto member>
Result<void> put_stretch(const std::string& text, PlanRequestDraft& wish) {
  AXIOMETRY_TRY(std::invoke(member, wish.request), parse_stretch(text));
  return {};
}

Result<void> put_name(const std::string& text, PlanRequestDraft& wish) {
  wish.request.axis.name = text;
  return {};
}

/// "EYX", or several with commas between.
Result<void> put_error(const std::string& text, PlanRequestDraft& wish) {
  for (const std::string_view part : text::split(text, ',')) {
    AXIOMETRY_TRY(const MotionName error, motion_name(text::trim(part)));
    wish.request.errors.push_back(error);
  }
  return {};
}

Result<void> put_kind(const std::string& text, PlanRequestDraft& wish) {
  if (text != "linear" && text != "rotary")
    return fail(fmt::format("found {}, expected linear or rotary", text::quoted(text)));
  wish.request.axis.kind = text == "linear" ? AxisKind::linear : AxisKind::rotary;
  return {};
}

Result<void> put_travel(const std::string& text, PlanRequestDraft& wish) {
  AXIOMETRY_TRY(const Stretch travel, parse_stretch(text));
  wish.request.axis.travel_begin = travel.from;
  wish.request.axis.travel_end = travel.to;
  return {};
}

Result<void> put_period(const std::string& text, PlanRequestDraft& wish) {
  AXIOMETRY_TRY(const double x, number_of(text));
  wish.request.axis.expected_period = Position::native(x);
  return {};
}

Result<void> put_compensation_points(const std::string& text, PlanRequestDraft& wish) {
  AXIOMETRY_TRY(wish.request.axis.compensation_points, parse_positions(text));
  return {};
}

Result<void> put_targets(const std::string& text, PlanRequestDraft& wish) {
  if (const auto count = parse_count(text)) {
    wish.request.count = *count;
    return {};
  }
  AXIOMETRY_TRY(const std::vector<double> positions, parse_positions(text));
  for (double x : positions) wish.request.targets.push_back(Position::native(x));
  return {};
}

Result<void> put_seed(const std::string& text, PlanRequestDraft& wish) {
  AXIOMETRY_TRY(wish.seed, count_of(text));
  return {};
}

Result<void> put_area(const std::string& text, PlanRequestDraft& wish) {
  if (wish.areas.size() == most_areas)
    return fail(fmt::format("found more than {} stretches, expected at most {}", most_areas, most_areas));
  wish.areas.push_back(text);
  return {};
}

Result<void> put_periodic(const std::string& text, PlanRequestDraft& wish) {
  AXIOMETRY_TRY_VOID(put_period(text, wish));
  wish.request.periodic.emplace();
  return {};
}

Result<void> put_periodic_at(const std::string& text, PlanRequestDraft& wish) {
  AXIOMETRY_TRY(const double x, number_of(text));
  wish.periodic_at = Position::native(x);
  return {};
}

Result<void> put_cycle(const std::string& text, PlanRequestDraft& wish) {
  using enum TestCycle;
  for (TestCycle cycle : {standard, step, pilgrim, unidirectional, user_defined})
    if (cycle_name(cycle) == text) {
      wish.request.cycle = cycle;
      wish.says_cycle = true;
      return {};
    }
  return fail(
      fmt::format("found {}, expected standard, step, pilgrim, unidirectional or user-defined", text::quoted(text)));
}

Result<void> put_rule(const std::string& text, PlanRequestDraft& wish) {
  AXIOMETRY_TRY(wish.rule, standards::rule_named(text));
  return {};
}

Result<void> put_sequence(const std::string& text, PlanRequestDraft& wish) {
  wish.sequence = text;
  return {};
}

// The order is that of the help.
constexpr PlanOption plan_option_table[] = {
    {"--axis", "NAME", "Name of the axis", of_axis, false, put_name},
    {"--kind", "KIND", "linear (mm) or rotary (°); linear when not given, which an axis A, B or C is not", of_axis,
     false, put_kind},
    {"--travel", "FROM:TO",
     "Axis travel (3.1). A rotary axis of exactly 360° is taken for one that turns without end, unless --soft-limits "
     "are given",
     of_axis, false, put_travel},
    {"--error", "NAME",
     "What is to be read at each stop where it is not the positions: EYX (straightness of X along Y), EAX (roll of X); "
     "EXX are its positions; may be repeated",
     of_axis, true, put_error},
    {"--soft-limits", "FROM:TO", "Of the control, where they are narrower than the travel", of_axis, false,
     put_stretch<&PlanRequest::soft_limits>},
    {"--period", "PERIOD",
     "Expected period of a periodic error, such as the pitch of the screw: targets shift by up to one period", of_axis,
     false, put_period},
    {"--compensation-points", "LIST",
     "Sampling points of the compensation, which targets keep off: 0:500:50 (from, to, every) or a list", of_axis,
     false, put_compensation_points},
    {"--segment", "LENGTH", "Length of the segments of a scale, each of which is given a target (5.3.3)", of_axis,
     false, put_position<&PlanRequest::segment>},
    {"--acceleration", "A", "Of the axis, mm/s² or °/s² (1000 or 500)", of_axis, false,
     put_plain<&PlanRequest::acceleration>},
    {"--machine", "NAME", "Name of the machine", of_axis, false, put_text<&PlanRequest::machine>},
    {"--date", "DATE", "Date of the plan, such as 2026-11-21; today when not given", of_axis, false,
     put_text<&PlanRequest::date>},
    {"--targets", "N or LIST", "Number of targets, or their positions; as many as the clause asks for", of_targets,
     false, put_targets},
    {"--interval", "P", "Mean interval of the targets at most", of_targets, false,
     put_position<&PlanRequest::interval>},
    {"--step", "STEP", "To which targets are rounded (0.001 mm or 0.0001°)", of_targets, false,
     put_position<&PlanRequest::step>},
    {"--seed", "N", "Of the random part of the targets; drawn and written into the plan when not given", of_targets,
     false, put_seed},
    {"--area", "FROM[:TO]",
     "Stretch of the normal working area for the tests that belong to one above 2 000 mm or 360°; TO may be left out; "
     "may be repeated; the middle",
     of_targets, true, put_area},
    {"--periodic", "PERIOD",
     "Plan the test for a periodic error of this period (Annex C) instead: dense targets from one direction",
     of_targets, false, put_periodic},
    {"--at", "POSITION", "Middle of that test; of the travel", of_targets, false, put_periodic_at},
    {"--measure", "FROM:TO", "Measurement travel (3.2); all that the overruns leave", of_targets, false,
     put_stretch<&PlanRequest::measurement>},
    {"--cycle", "CYCLE", "standard, step (Annex B), pilgrim, unidirectional or user-defined", of_programme, false,
     put_cycle},
    {"--standard", "NAME",
     "Keep to the cycle of another rule too, as far as that is known: its approaches, targets and steps where nothing "
     "else is asked for ('axiometry compare-rules --help' lists the rules)",
     of_programme, false, put_rule},
    {"--sequence", "LIST or FILE",
     "The approaches of the user-defined cycle: '1+ 2+ 2- 1-', numbers of targets and directions", of_programme, false,
     put_sequence},
    {"--runs", "N", "Approaches to each target from each direction (5; 1 above 2 000 mm or 360°)", of_programme, false,
     put_count<&PlanRequest::runs>},
    {"--overrun", "LENGTH",
     "Distance beyond a target before the direction changes (1 % of the travel within 1 and 10, more to reach the "
     "feed)",
     of_programme, false, put_position<&PlanRequest::overrun>},
    {"--feed", "FEED", "mm/min or °/min (1000 or 720)", of_programme, false, put_plain<&PlanRequest::feed>},
    {"--dwell", "SECONDS", "At rest on every target (3)", of_programme, false,
     put_number<&PlanRequest::dwell, [](double x) { return Duration::s(x); }>},
    {"--warm-up", "N", "Runs there and back before the first reading (1)", of_programme, false,
     put_count<&PlanRequest::warm_up_runs>},
};

constexpr PlanOptionPair apart[] = {
    {"--periodic", "--period"},   {"--targets", "--interval"}, {"--targets", "--periodic"},  {"--cycle", "--periodic"},
    {"--sequence", "--periodic"}, {"--error", "--periodic"},   {"--standard", "--periodic"},
};

Result<void> check_plan_names(const Plan& plan) {
  AXIOMETRY_TRY_VOID(given_line("the name of the axis", plan.axis.name));
  AXIOMETRY_TRY_VOID(given_line("the name of the machine", plan.machine));
  AXIOMETRY_TRY_VOID(given_line("the title of the plan", plan.title));
  for (const Plan& further : plan.further) AXIOMETRY_TRY_VOID(check_plan_names(further));
  return {};
}

bool has_drawn_targets(const Plan& plan) {
  return plan.seed.has_value() || std::ranges::any_of(plan.further, has_drawn_targets);
}

}  // namespace

Result<void> check_seed_used(const PlanRequestDraft& wish, const Plan& plan) {
  if (!wish.seed || has_drawn_targets(plan)) return {};
  return fail("found a seed beside the positions of all targets, expected one of them: nothing is drawn");
}

std::size_t planned_readings(const Plan& plan) {
  std::size_t all = plan.sequence.empty() ? 2 * plan.targets.size() * plan.runs : plan.sequence.size();
  for (const Plan& part : plan.further) all += planned_readings(part);
  return all;
}

std::span<const PlanOption> plan_options() { return plan_option_table; }

std::span<const PlanOptionPair> plan_options_apart() { return apart; }

Result<PlanRequest> completed(const PlanRequestDraft& wish) {
  PlanRequest request = wish.request;
  for (const std::string& text : wish.areas) {
    AXIOMETRY_TRY(request.areas.emplace_back(), parse_area(text, request.axis.kind));
  }
  if (wish.sequence && request.sequence.empty()) {
    AXIOMETRY_TRY(request.sequence, parse_sequence(*wish.sequence));
  }
  if (request.periodic) request.periodic->at = wish.periodic_at;
  request.seed = wish.seed ? *wish.seed : drawn_seed();
  AXIOMETRY_TRY(request.date, plan_date(request.date));
  if (wish.rule == nullptr) return request;
  AXIOMETRY_TRY(request, standards::with_cycle_of(*wish.rule, std::move(request)));
  if (wish.says_cycle) request.cycle = wish.request.cycle;
  return request;
}

Result<void> check_presentable(const Plan& plan) {
  AXIOMETRY_TRY_VOID(check_plan_names(plan));
  const std::size_t readings = planned_readings(plan);
  if (readings <= most_planned_readings) return {};
  return fail(fmt::format("found {} targets in {} runs, {} readings in all, expected at most {}", plan.targets.size(),
                          plan.runs, readings, most_planned_readings));
}

}  // namespace axiometry::app
