// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/nc/numbers.h"
#include "axiometry/nc/walk.h"

namespace axiometry::nc {
namespace {

/// Stops, ends and calls of programs; spindle; tool and pallet change: at a machine on which somebody stands beside
/// optics, none of these is a trigger.
constexpr std::array<unsigned, 13> never_a_trigger = {0, 1, 2, 3, 4, 6, 13, 14, 17, 30, 60, 98, 99};

Result<std::string> axis_word(const Axis& axis, const ControlLimits& limits) {
  std::string name(text::trim(axis.name));
  for (char& c : name)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  const bool linear = axis.kind == AxisKind::linear;
  const std::string_view known = linear ? limits.linear_axes : limits.rotary_axes;
  const auto digits = std::count_if(name.begin(), name.end(), [](char c) { return c >= '0' && c <= '9'; });
  const bool numbered = limits.numbered_axes && name.size() > 1 && name.size() <= 3 && name[1] != '0' &&
                        static_cast<std::size_t>(digits) == name.size() - 1;
  if (!name.empty() && name[0] != ' ' && known.find(name[0]) != std::string_view::npos &&
      (name.size() == 1 || numbered))
    return name;
  return fail(fmt::format("found axis {}, expected one of {}{} for a {} axis", text::quoted(axis.name), known,
                          limits.numbered_axes ? ", with or without a number," : "", axis_kind_name(axis.kind)));
}

Result<std::string> feed_word(const Plan& plan, bool in_inch, const ControlLimits& limits) {
  const double feed = in_inch ? plan.feed / mm_per_inch * limits.feed_per_inch : plan.feed;
  const std::string text =
      trimmed_number(feed, limits.feed_decimals + (in_inch && limits.feed_per_inch == 1.0 ? 1 : 0));
  const auto printed = parse_number(text);
  const bool right = printed && std::abs(*printed - feed) <= 0.001 * feed;
  if (right && plan.feed <= limits.feed_highest) return text;
  return fail(fmt::format("found a feed of {} {}/min, expected one that the control can be told, up to {}",
                          format_exact(plan.feed), position_unit(plan.axis.kind), format_exact(limits.feed_highest)));
}

Result<long> dwell_steps(Duration dwell, const ControlLimits& limits) {
  if (dwell > limits.dwell_longest)
    return fail(fmt::format("found a dwell of {} s, expected at most {}", format_exact(dwell.in_s()),
                            format_exact(limits.dwell_longest.in_s())));
  const double steps = dwell.in_s() / limits.dwell_step.in_s();
  return static_cast<long>(std::ceil(steps - 1e-6));  // what was given in whole steps is not one more
}

Result<void> check_trigger(std::optional<unsigned> code, const ControlLimits& limits) {
  if (!code) return {};
  if (std::ranges::find(never_a_trigger, *code) != never_a_trigger.end())
    return fail(
        fmt::format("found M{} as trigger, expected an M code that leaves program, spindle and tool alone", *code));
  for (const auto& [first, last] : limits.m_codes)
    if (*code >= first && *code <= last) return {};
  std::vector<std::string> ranges;
  for (const auto& [first, last] : limits.m_codes)
    if (first <= last)
      ranges.push_back(first == last ? fmt::format("M{}", first) : fmt::format("M{} to M{}", first, last));
  return fail(fmt::format("found M{} as trigger, expected one of {}", *code, fmt::join(ranges, ", ")));
}

Result<void> check_reach(const Plan& plan, const ControlLimits& limits) {
  const Reach ends = reach(plan);
  for (Position end : {ends.lowest, ends.highest})
    if (std::abs(end.in_native()) > limits.farthest.in_native())
      return fail(fmt::format("found a way to {} {}, expected positions within ±{}", format_exact(end.in_native()),
                              position_unit(plan.axis.kind), format_exact(limits.farthest.in_native())));
  return {};
}

std::string_view word_of(Direction direction) { return direction == Direction::up ? "UP" : "DOWN"; }

/// What a stretch of several times does: "RUNS 1 TO 5".
std::string loop_remark(const Stretch& stretch) {
  std::optional<Approach> first;
  bool one_target = true;
  for (const PlannedMove& move : stretch.moves) {
    if (!move.approach) continue;
    if (!first) first = move.approach;
    one_target = one_target && move.approach->target == first->target;
  }
  if (!first) return fmt::format("{} TIMES THERE AND BACK WITHOUT READINGS", stretch.times);
  // The runs of a user-defined cycle may come in any order.
  const bool in_order = stretch.last_run + 1 == first->run + stretch.times;
  const std::string runs = in_order ? fmt::format("RUNS {} TO {}", first->run + 1, stretch.last_run + 1)
                                    : fmt::format("{} RUNS", stretch.times);
  return one_target ? fmt::format("TARGET {}, {}", first->target + 1, runs) : runs;
}

class Writer {
 public:
  Writer(const ProgramOptions& options, const ControlLimits& limits, Coordinates coordinates, long dwell)
      : options_(options), limits_(limits), coordinates_(coordinates), dwell_(dwell) {}

  void stretch(const Stretch& s) {
    const bool loop = s.times > 1;
    if (loop) {
      remark(loop_remark(s));
      list_.push_back(LoopBegin{++loops_, s.times});
    }
    for (const PlannedMove& move : s.moves) drive(move, loop);
    if (loop) list_.push_back(LoopEnd{loops_, s.times});
  }

  void remark(std::string text) { list_.push_back(Remark{std::move(text)}); }
  void stop(std::string message) { list_.push_back(OperatorStop{std::move(message)}); }
  std::size_t loops() const { return loops_; }
  std::vector<Instruction> finish() && { return std::move(list_); }

 private:
  void drive(const PlannedMove& move, bool loop) {
    std::string remark;
    if (!moved_) remark = "TO THE START";
    moved_ = true;
    if (move.approach)
      remark = fmt::format("TARGET {} {}", move.approach->target + 1, word_of(move.approach->direction));
    if (move.approach && !loop) remark += fmt::format(" RUN {}", move.approach->run + 1);
    list_.push_back(Move{coordinates_.text(move.to), std::move(remark)});
    if (!move.approach) return;
    const long before = options_.trigger_m_code ? dwell_ / 2 : dwell_;
    if (before > 0 || (dwell_ == 0 && limits_.dwell_stops)) list_.push_back(Dwell{before});
    if (!options_.trigger_m_code) return;
    list_.push_back(Trigger{*options_.trigger_m_code});
    if (dwell_ > before) list_.push_back(Dwell{dwell_ - before});
  }

  const ProgramOptions& options_;
  const ControlLimits& limits_;
  Coordinates coordinates_;
  long dwell_ = 0;
  std::size_t loops_ = 0;
  bool moved_ = false;
  std::vector<Instruction> list_;
};

std::string decimals_remark(const Coordinates& coordinates, const Plan& plan, const ProgramOptions& options) {
  const double error = coordinates.target_error(plan).in_native() * deviation_per_position(plan.axis.kind);
  std::string text = fmt::format("COORDINATES WITH {} DECIMALS", coordinates.decimals());
  if (coordinates.decimals() > options.decimals) text += fmt::format(", {} WOULD MOVE TARGETS", options.decimals);
  if (error > 1e-5)
    text += fmt::format(", ROUNDED BY UP TO {:.4f} {}", error, plan.axis.kind == AxisKind::linear ? "UM" : "ARCSEC");
  return text;
}

}  // namespace

Result<Script> make_script(const Plan& plan, const ProgramOptions& options, const ControlLimits& limits) {
  Script script;
  AXIOMETRY_TRY(script.axis, axis_word(plan.axis, limits));
  AXIOMETRY_TRY_VOID(check_reach(plan, limits));
  AXIOMETRY_TRY_VOID(check_trigger(options.trigger_m_code, limits));
  AXIOMETRY_TRY(const Coordinates coordinates, Coordinates::make(plan, options));
  AXIOMETRY_TRY(script.feed, feed_word(plan, coordinates.in_inch(), limits));
  AXIOMETRY_TRY(const long dwell, dwell_steps(plan.dwell, limits));
  script.inch = options.unit == LengthUnit::inch;

  Writer writer(options, limits, coordinates, dwell);
  for (std::string& line : headlines(plan, options)) writer.remark(std::move(line));
  writer.remark(decimals_remark(coordinates, plan, options));
  const std::size_t loop_limit = options.unrolled ? 0 : limits.loops;
  const std::vector<Stretch> stretches = walk(plan, loop_limit);
  const auto loops =
      static_cast<std::size_t>(std::ranges::count_if(stretches, [](const Stretch& s) { return s.times > 1; }));
  if (loop_limit > 0 && loops == 0 && plan.cycle == TestCycle::user_defined)
    writer.remark("WRITTEN OUT, THE ORDER OF APPROACHES DOES NOT REPEAT");
  if (loop_limit > 0 && loops == loop_limit)
    writer.remark(fmt::format("AT MOST {} LOOPS, WHAT IS LEFT IS WRITTEN OUT", loops));
  for (std::size_t k = 0; k < stretches.size(); ++k) {
    writer.stretch(stretches[k]);
    if (k == 0 && options.stop_at_start)
      writer.stop(
          fmt::format("SET THE INSTRUMENT, {} IS AT {}", script.axis, coordinates.text(stretches[0].moves[0].to)));
  }
  script.has_loops = loops > 0;
  script.instructions = std::move(writer).finish();
  return script;
}

}  // namespace axiometry::nc
