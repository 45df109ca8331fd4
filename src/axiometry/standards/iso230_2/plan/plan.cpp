// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/plan/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/standards/iso230_2/plan/targets.h"
#include "axiometry/standards/iso230_2/programme.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double most = 1e6;            // mm or °: no axis is longer
constexpr double overrun_least = 1.0;   // mm or °
constexpr double overrun_usual = 10.0;  // mm or °: up to here 1 % of the travel is enough
constexpr double overrun_share = 0.1;   // largest share of the travel, for the sake of the feed
constexpr double shift_at_ends = 0.05;  // the farthest shift, as a share of the measurement travel
constexpr double targets_per_period_usual = 8.0;
constexpr double periods_usual = 3.0;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// What the request leaves open, chosen; numbers in mm or °.
struct Frame {
  Plan plan;               ///< without targets and what depends on them
  double low = -infinity;  ///< where the axis may go
  double high = infinity;
  double step = 0.0;
  bool without_end = false;
  Stretch measurement;  ///< 3.2

  AxisKind kind() const { return plan.axis.kind; }
  std::string number(double x) const { return fmt::format("{}", std::round(x * 1e6) / 1e6); }
  std::string text(double x) const { return number(x) + (linear() ? " mm" : "°"); }
  bool linear() const { return kind() == AxisKind::linear; }
};

std::string span_text(const Frame& frame, double from, double to) {
  return fmt::format("{} to {}", frame.number(from), frame.text(to));
}

Result<void> check_stretch(const Frame& frame, std::string_view name, const Stretch& stretch) {
  const double from = stretch.from.in_native(), to = stretch.to.in_native();
  if (std::isfinite(from) && std::isfinite(to) && from < to && -most <= from && to <= most) return {};
  return fail(fmt::format("found the {} {}, expected its lower end and then its higher one, within ±{}", name,
                          span_text(frame, from, to), frame.text(most)));
}

Result<void> check_positive(std::string_view name, std::optional<double> x) {
  if (!x || (std::isfinite(*x) && *x > 0.0 && *x <= 1e9)) return {};
  return fail(fmt::format("found {} {}, expected a number above 0", name, format_exact(*x)));
}

std::optional<double> native(const std::optional<Position>& x) {
  return x ? std::optional(x->in_native()) : std::nullopt;
}

Result<void> check_numbers(const PlanRequest& request) {
  AXIOMETRY_TRY_VOID(check_positive("the interval", native(request.interval)));
  AXIOMETRY_TRY_VOID(check_positive("the overrun", native(request.overrun)));
  AXIOMETRY_TRY_VOID(check_positive("the feed", request.feed));
  AXIOMETRY_TRY_VOID(check_positive("the segment", native(request.segment)));
  AXIOMETRY_TRY_VOID(check_positive("the step of targets", native(request.step)));
  if (request.acceleration) AXIOMETRY_TRY_VOID(check_acceleration(*request.acceleration));
  AXIOMETRY_TRY_VOID(check_positive("the expected period", native(request.axis.expected_period)));
  for (double x : request.axis.compensation_points)
    if (!std::isfinite(x)) return fail("found a sampling point that is not finite, expected positions");
  if (request.count && (*request.count < 2 || *request.count > targets_most))
    return fail(fmt::format("found {}, expected 2 to {}", counted(*request.count, "target"), targets_most));
  return {};
}

Result<void> find_limits(Frame& frame, const PlanRequest& request) {
  Axis& axis = frame.plan.axis;
  if (!axis.travel_begin || !axis.travel_end) return fail("found no axis travel, expected both of its ends");
  const Stretch travel{*axis.travel_begin, *axis.travel_end};
  AXIOMETRY_TRY_VOID(check_stretch(frame, "axis travel", travel));
  if (request.soft_limits) AXIOMETRY_TRY_VOID(check_stretch(frame, "soft limits", *request.soft_limits));
  frame.without_end = !frame.linear() && !request.soft_limits && std::abs(travel.length() - 360.0) < 1e-9;
  frame.measurement = travel;
  if (frame.without_end) {
    axis.travel_begin = axis.travel_end = std::nullopt;
    return {};
  }
  frame.low = travel.from.in_native();
  frame.high = travel.to.in_native();
  if (request.soft_limits) {
    frame.low = std::max(frame.low, request.soft_limits->from.in_native());
    frame.high = std::min(frame.high, request.soft_limits->to.in_native());
    AXIOMETRY_TRY_VOID(check_stretch(frame, "travel inside the soft limits",
                                     {Position::native(frame.low), Position::native(frame.high)}));
  }
  return {};
}

double usual_overrun(const Frame& frame, const std::optional<Stretch>& measurement) {
  const double travel = frame.measurement.length();
  const double enough = std::clamp(0.01 * travel, overrun_least, overrun_usual);
  const double to_feed = distance_to_feed(frame.plan).in_native();
  const double wanted = std::ceil(std::min(std::max(enough, to_feed), std::max(enough, overrun_share * travel)) - 1e-9);
  if (!measurement) return wanted;
  const double room = std::min(measurement->from.in_native() - frame.low, frame.high - measurement->to.in_native());
  return room >= overrun_least ? std::min(wanted, room) : wanted;
}

/// Fails when an overrun at both ends of the stretch leads beyond where the axis may go.
Result<void> check_room(const Frame& frame, std::string_view name, const Stretch& stretch) {
  const double overrun = frame.plan.overrun.in_native();
  const double from = stretch.from.in_native() - overrun, to = stretch.to.in_native() + overrun;
  const double slack = 1e-9 * std::max({1.0, std::abs(from), std::abs(to)});
  if (from >= frame.low - slack && to <= frame.high + slack) return {};
  return fail(fmt::format("found the {} {} that with overruns of {} reaches from {}, expected room within {}", name,
                          span_text(frame, stretch.from.in_native(), stretch.to.in_native()), frame.text(overrun),
                          span_text(frame, from, to), span_text(frame, frame.low, frame.high)));
}

/// All that the overruns leave.
Result<Stretch> whole_measurement(const Frame& frame) {
  if (frame.without_end) return frame.measurement;
  const double overrun = frame.plan.overrun.in_native();
  double from = frame.low + overrun, to = frame.high - overrun;
  if (from >= to)
    return fail(fmt::format("found overruns of {} at both ends of a travel of {}, expected room for targets between",
                            frame.text(overrun), frame.text(frame.high - frame.low)));
  if (!frame.linear() && to - from > most_turns.in_native()) {
    from = 0.5 * (from + to) - 0.5 * most_turns.in_native();
    to = from + most_turns.in_native();
  }
  return Stretch{Position::native(from), Position::native(to)};
}

Result<Frame> make_frame(const PlanRequest& request) {
  AXIOMETRY_TRY_VOID(check_numbers(request));
  Frame frame;
  Plan& plan = frame.plan;
  plan.axis = request.axis;
  plan.errors = request.errors;
  plan.machine = request.machine;
  plan.rule = request.rule;
  plan.date = request.date;
  plan.cycle = request.periodic ? TestCycle::unidirectional : request.cycle;
  plan.feed = request.feed.value_or(frame.linear() ? 1000.0 : 720.0);
  plan.dwell = request.dwell.value_or(Duration::s(3.0));
  plan.warm_up_runs = request.warm_up_runs.value_or(1);
  plan.acceleration = request.acceleration;
  frame.step = request.step ? request.step->in_native() : frame.linear() ? 1e-3 : 1e-4;
  AXIOMETRY_TRY_VOID(find_limits(frame, request));
  if (request.measurement) AXIOMETRY_TRY_VOID(check_stretch(frame, "measurement travel", *request.measurement));
  plan.overrun = request.overrun.value_or(Position::native(usual_overrun(frame, request.measurement)));
  if (request.measurement) {
    frame.without_end = frame.without_end && request.measurement->length() == 360.0;
    frame.measurement = *request.measurement;
    AXIOMETRY_TRY_VOID(check_room(frame, "measurement travel", frame.measurement));
  } else {
    AXIOMETRY_TRY(frame.measurement, whole_measurement(frame));
  }
  return frame;
}

struct Spacing {
  std::optional<std::size_t> count;
  std::optional<double> interval;
  std::optional<double> segment;
  double segments_from = 0.0;
  bool equal_steps = false;
};

/// m over a stretch: as asked for, else what the clause and the scale need.
std::size_t target_count(const Frame& frame, Programme programme, const Stretch& stretch, const Spacing& spacing) {
  const double length = stretch.length();
  const auto intervals = [&](double p) {
    return static_cast<std::size_t>(std::clamp(std::ceil(length / p - 1e-9), 1.0, 1e9));
  };
  const std::size_t closing = frame.without_end ? 0 : 1;
  if (spacing.count) return *spacing.count;
  if (spacing.interval) return std::max<std::size_t>(intervals(*spacing.interval) + closing, 2);
  std::size_t count = required_targets(programme, Position::native(length)).count;
  if (programme == Programme::many_turns) ++count;  // so that every revolution has eight
  if (programme == Programme::long_linear) {
    const double p = std::min(long_axis_interval.in_native(), spacing.segment.value_or(infinity));
    count = std::max(count, intervals(p) + 1);
  }
  return count;
}

TargetGrid grid_over(const Frame& frame, Programme programme, const Stretch& stretch, const Spacing& spacing) {
  TargetGrid grid;
  grid.count = target_count(frame, programme, stretch, spacing);
  grid.first = stretch.from.in_native();
  grid.without_end = frame.without_end;
  grid.interval = stretch.length() / static_cast<double>(frame.without_end ? grid.count : grid.count - 1);
  grid.shift = random_part * grid.interval;
  if (const auto& period = frame.plan.axis.expected_period) grid.shift = std::min(grid.shift, period->in_native());
  grid.shift_inwards = std::min(grid.shift, shift_at_ends * stretch.length());
  if (required_approaches(programme) == 1)
    grid.shift_inwards =
        std::min(grid.shift_inwards, 0.4 * (stretch.length() - normal_stretch(frame.kind()).in_native()));
  grid.step = frame.step;
  grid.principal_positions = programme == Programme::one_turn;
  grid.segment = frame.without_end ? 0.0 : spacing.segment.value_or(0.0);
  grid.segments_from = spacing.segments_from;
  return grid;
}

std::string clause_of(const Plan& plan, Programme programme) {
  if (!measures_positions(plan)) return "";
  switch (plan.cycle) {
    case TestCycle::standard: return programme_clause(programme);
    case TestCycle::step: return "Annex B";
    default: return "";
  }
}

std::size_t last_run(const std::vector<Approach>& sequence) {
  std::size_t runs = 1;
  for (const Approach& a : sequence) runs = std::max(runs, a.run + 1);
  return runs;
}

Result<void> check_count(const Frame& frame, const Stretch& stretch, double count) {
  if (count <= static_cast<double>(targets_most)) return {};
  return fail(fmt::format("found {:.4g} targets over {}, expected at most {}", count, frame.text(stretch.length()),
                          targets_most));
}

/// One test over one stretch. `stream` parts the tests of a plan.
Result<Plan> plan_over(const Frame& frame, const Stretch& stretch, const Spacing& spacing, std::uint64_t seed,
                       std::uint64_t stream) {
  const Programme programme = programme_of(frame.kind(), Position::native(stretch.length()));
  if (spacing.interval) AXIOMETRY_TRY_VOID(check_count(frame, stretch, stretch.length() / *spacing.interval + 1.0));
  if (spacing.segment) AXIOMETRY_TRY_VOID(check_count(frame, stretch, stretch.length() / *spacing.segment));
  TargetGrid grid = grid_over(frame, programme, stretch, spacing);
  if (spacing.equal_steps) {
    grid.shift = grid.shift_inwards = 0.0;
    grid.principal_positions = false;
  }
  AXIOMETRY_TRY_VOID(check_count(frame, stretch, static_cast<double>(grid.count)));
  Plan plan = frame.plan;
  plan.clause = clause_of(plan, programme);
  plan.runs = required_approaches(programme);
  plan.seed = seed;
  AXIOMETRY_TRY(plan.targets, draw_targets(grid, plan.axis.compensation_points, seed, stream));
  return plan;
}

/// The stretches of the normal working area that a long test needs beside it.
Result<std::vector<Stretch>> areas_of(const Frame& frame, const PlanRequest& request) {
  std::vector<Stretch> areas = request.areas;
  const double length = normal_stretch(frame.kind()).in_native();
  if (areas.empty()) {
    const double middle = 0.5 * (frame.measurement.from.in_native() + frame.measurement.to.in_native());
    areas = {{Position::native(std::round(middle - 0.5 * length)), {}}};
    areas[0].to = Position::native(areas[0].from.in_native() + length);
    if (areas[0].from < frame.measurement.from || areas[0].to > frame.measurement.to) {
      areas[0].from = Position::native(middle - 0.5 * length);
      areas[0].to = Position::native(middle + 0.5 * length);
    }
  }
  for (const Stretch& area : areas) {
    AXIOMETRY_TRY_VOID(check_stretch(frame, "normal working area", area));
    if (area.length() > length + 1e-6)
      return fail(fmt::format("found a stretch of {} of the normal working area, expected at most {}",
                              frame.text(area.length()), frame.text(length)));
    AXIOMETRY_TRY_VOID(check_room(frame, "normal working area", area));
  }
  return areas;
}

Result<void> add_further(Plan& plan, const Frame& frame, const PlanRequest& request) {
  AXIOMETRY_TRY(const std::vector<Stretch> areas, areas_of(frame, request));
  plan.title = "Whole travel";
  const Spacing spacing{request.area_targets, {}, {}, 0.0, request.equal_steps};
  for (const Stretch& area : areas) {
    AXIOMETRY_TRY(Plan part, plan_over(frame, area, spacing, request.seed, plan.further.size() + 1));
    part.title = fmt::format("Normal working area, {}", span_text(frame, area.from.in_native(), area.to.in_native()));
    part.warm_up_runs = 0;  // the test over the whole travel goes before
    part.runs = std::max(part.runs, request.least_runs);
    plan.further.push_back(std::move(part));
  }
  return {};
}

Result<Plan> plan_of_given_targets(const Frame& frame, const PlanRequest& request) {
  Plan plan = frame.plan;
  plan.targets = request.targets;
  std::ranges::sort(plan.targets);
  AXIOMETRY_TRY_VOID(check_sound([&] {
    Plan probe = plan;  // the cycle and its sequence are judged when the runs are known
    probe.cycle = TestCycle::standard;
    return probe;
  }()));
  const Stretch stretch{plan.targets.front(), plan.targets.back()};
  AXIOMETRY_TRY_VOID(check_room(frame, "targets from", stretch));
  if (const auto& within = request.measurement; within && (stretch.from < within->from || stretch.to > within->to))
    return fail(fmt::format("found targets from {}, expected them within the measurement travel {}",
                            span_text(frame, stretch.from.in_native(), stretch.to.in_native()),
                            span_text(frame, within->from.in_native(), within->to.in_native())));
  const Programme programme = programme_of(frame.kind(), Position::native(stretch.length()));
  plan.clause = clause_of(plan, programme);
  plan.runs = required_approaches(programme);
  return plan;
}

/// Targets at an eighth of the period over three periods, or as many as there is room for, but two at least.
Result<Plan> plan_for_period(const Frame& frame, const PlanRequest& request) {
  if (!request.axis.expected_period) return fail("found no period, expected that of the periodic error");
  const double period = request.axis.expected_period->in_native();
  const double middle = request.periodic->at
                            ? request.periodic->at->in_native()
                            : 0.5 * (frame.measurement.from.in_native() + frame.measurement.to.in_native());
  const double room =
      2.0 * std::min(middle - frame.measurement.from.in_native(), frame.measurement.to.in_native() - middle);
  if (!(room >= 2.0 * period))
    return fail(fmt::format("found room for {} about {}, expected two periods of {} at least", frame.text(room),
                            frame.text(middle), frame.text(period)));
  const double length = std::min(periods_usual * period, room);
  TargetGrid grid;
  const double wanted = request.interval ? request.interval->in_native() : period / targets_per_period_usual;
  const double count = request.count ? static_cast<double>(*request.count) : std::ceil(length / wanted - 1e-9) + 1.0;
  AXIOMETRY_TRY_VOID(check_count(frame, {Position::native(0.0), Position::native(length)}, count));
  grid.count = std::max<std::size_t>(static_cast<std::size_t>(count), 2);
  grid.first = middle - 0.5 * length;
  grid.interval = length / static_cast<double>(grid.count - 1);
  grid.shift = random_part * grid.interval;
  grid.step = frame.step;
  Plan plan = frame.plan;
  plan.clause = "Annex C";
  plan.title = "Periodic positioning error";
  plan.runs = 1;
  plan.seed = request.seed;
  AXIOMETRY_TRY(plan.targets, draw_targets(grid, {}, request.seed, 0));
  return plan;
}

/// Segments of a scale ask for a target each where targets are drawn and there is more than one of them.
Result<void> check_segment(const Frame& frame, const PlanRequest& request) {
  if (!request.segment) return {};
  if (request.periodic)
    return fail("found segments of a scale in the test for a periodic error, expected them in one over the travel");
  if (!request.targets.empty())
    return fail("found segments of a scale beside positions of targets, expected them where targets are drawn");
  if (frame.without_end)
    return fail("found segments of a scale of an axis that turns without end, expected an axis with soft limits");
  const double segment = request.segment->in_native(), begin = request.axis.travel_begin->in_native();
  const double first = frame.measurement.from.in_native(), last = frame.measurement.to.in_native();
  if (begin + (std::floor((first - begin) / segment) + 1.0) * segment < last) return {};
  return fail(fmt::format("found segments of {}, of which one holds the measurement travel {}, expected shorter ones",
                          frame.text(segment), span_text(frame, first, last)));
}

Result<Plan> plan_without_sequence(const Frame& frame, const PlanRequest& request) {
  if (request.periodic) return plan_for_period(frame, request);
  if (!request.targets.empty()) return plan_of_given_targets(frame, request);
  const Spacing spacing{request.count, native(request.interval), native(request.segment),
                        request.axis.travel_begin->in_native(), request.equal_steps};
  return plan_over(frame, frame.measurement, spacing, request.seed, 0);
}

}  // namespace

Result<Plan> make_plan(const PlanRequest& request) {
  AXIOMETRY_TRY(const Frame frame, make_frame(request));
  AXIOMETRY_TRY_VOID(check_segment(frame, request));
  AXIOMETRY_TRY(Plan plan, plan_without_sequence(frame, request));
  plan.sequence = request.sequence;
  plan.runs = request.runs.value_or(std::max(plan.runs, request.least_runs));
  if (plan.cycle == TestCycle::user_defined) plan.runs = last_run(plan.sequence);
  if (request.runs && plan.runs != *request.runs && !plan.sequence.empty())
    return fail(
        fmt::format("found {} as number of runs beside a sequence of {}, expected the sequence alone, which says it",
                    *request.runs, plan.runs));
  if (plan.targets.size() > targets_most)
    return fail(fmt::format("found {} targets, expected at most {}", plan.targets.size(), targets_most));
  AXIOMETRY_TRY_VOID(check_sound(plan));
  const double measured = plan.targets.back().in_native() - plan.targets.front().in_native();
  if (!measures_positions(plan)) {
    if (request.areas.empty()) return plan;
    return fail(fmt::format("found a normal working area for a plan made for {}, expected one for positions only",
                            errors_text(plan)));
  }
  const bool needs_further = !request.periodic && plan.cycle != TestCycle::user_defined &&
                             required_approaches(programme_of(frame.kind(), Position::native(measured))) == 1;
  if (request.step && !request.targets.empty() && !needs_further)
    return fail(
        "found a step of targets beside their positions, expected one of them: positions are taken as they are");
  if (needs_further) AXIOMETRY_TRY_VOID(add_further(plan, frame, request));
  if (!needs_further && !request.areas.empty())
    return fail(fmt::format("found a normal working area for a test over {}, expected one above {} only",
                            frame.text(measured), frame.text(normal_stretch(frame.kind()).in_native())));
  return plan;
}

}  // namespace axiometry::iso230_2
