// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/script.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/numbers.h"
#include "axiometry/nc/walk.h"

namespace axiometry::nc {
namespace {

/// Of a line.
constexpr std::array<std::string_view, 3> axes_in_space = {"X", "Y", "Z"};

Result<void> check_axes_in_space(const ControlLimits& limits) {
  for (std::string_view axis : axes_in_space)
    if (limits.linear_axes.find(axis) == std::string_view::npos)
      return fail(
          fmt::format("found a line in space, expected a test of one of the control's axes {}", limits.linear_axes));
  return {};
}

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

Result<void> check_coordinate(double x, std::string_view axis, const Plan& plan, const ControlLimits& limits) {
  if (std::abs(x) <= limits.farthest.in_native()) return {};
  return fail(fmt::format("found a way to {}{}{} {}, expected positions within ±{}", axis, axis.empty() ? "" : " ",
                          format_exact(x), position_unit(plan.axis.kind), format_exact(limits.farthest.in_native())));
}

Result<void> check_reach(const Plan& plan, const ControlLimits& limits) {
  const Reach ends = reach(plan);
  const auto line = spatial_line(plan.axis);
  if (!line) {
    for (Position end : {ends.lowest, ends.highest})
      AXIOMETRY_TRY_VOID(check_coordinate(end.in_native(), "", plan, limits));
    return {};
  }
  std::vector<Vector3> points = {line->at(ends.lowest), line->at(ends.highest)};
  points.insert(points.end(), plan.way_in_mm.begin(), plan.way_in_mm.end());
  points.insert(points.end(), plan.way_out_mm.begin(), plan.way_out_mm.end());
  for (Vector3 point : points)
    for (std::size_t k = 0; k < 3; ++k) AXIOMETRY_TRY_VOID(check_coordinate(point[k], axes_in_space[k], plan, limits));
  return {};
}

Result<void> check_rollover(AxisKind kind, bool asked, const ControlLimits& limits) {
  if (!asked) return {};
  if (kind != AxisKind::rotary) return fail("found rollover asked for, expected it of a rotary axis alone");
  if (limits.rollover != RolloverWords::none) return {};
  return fail("found rollover asked for, expected none: the rotary axes of this control count on through 0° and 360°");
}

std::string_view word_of(Direction direction) { return direction == Direction::up ? "UP" : "DOWN"; }

/// What a stretch of several times does: "RUNS 1 TO 5".
std::string loop_remark(const RepeatedMoves& stretch) {
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

/// What a plan needs to be spelled.
struct Spelling {
  std::string axis;  ///< of a plan without a line in space
  std::optional<SpatialLine> line;
  Coordinates coordinates;
  std::string feed;
  long dwell = 0;

  std::vector<AxisWord> at(Vector3 point) const {
    std::vector<AxisWord> words;
    for (std::size_t k = 0; k < 3; ++k) words.push_back({std::string(axes_in_space[k]), coordinates.text(point[k])});
    return words;
  }
  /// Only those that move on the line, or all three of them.
  std::vector<AxisWord> at(Position position, bool all) const {
    if (!line) return {{axis, coordinates.text(position.in_native())}};
    std::vector<AxisWord> words = at(line->at(position));
    if (all) return words;
    std::vector<AxisWord> moving;
    for (std::size_t k = 0; k < 3; ++k)
      if (moves_along(*line, k)) moving.push_back(std::move(words[k]));
    return moving;
  }
};

Result<Spelling> make_spelling(const Plan& plan, const ProgramOptions& options, const ControlLimits& limits) {
  const auto line = spatial_line(plan.axis);
  std::string axis;
  if (line) {
    AXIOMETRY_TRY_VOID(check_axes_in_space(limits));
  } else {
    AXIOMETRY_TRY(axis, axis_word(plan.axis, limits));
  }
  AXIOMETRY_TRY_VOID(check_reach(plan, limits));
  AXIOMETRY_TRY(const Coordinates coordinates, Coordinates::make(plan, options));
  AXIOMETRY_TRY(std::string feed, feed_word(plan, coordinates.in_inch(), limits));
  AXIOMETRY_TRY(const long dwell, dwell_steps(plan.dwell, limits));
  return Spelling{std::move(axis), line, coordinates, std::move(feed), dwell};
}

/// The block before tells where several axes are, which would be too long for a display.
OperatorStop stop_at(const Move& last, std::string_view unit) {
  if (last.axes.size() > 1) return {"SET THE INSTRUMENT, THE AXES ARE AT THE START OF THE LINE"};
  return {fmt::format("SET THE INSTRUMENT, {} IS AT {}{}", last.axes[0].axis, last.axes[0].coordinate, unit)};
}

/// What follows on a move to a reading: dwell, trigger, and its end where it would stay on.
void add_rest(std::vector<Instruction>& list, long dwell, const ProgramOptions& options, const ControlLimits& limits) {
  const long before = options.trigger_m_code ? dwell / 2 : dwell;
  if (before > 0 || (dwell == 0 && limits.dwell_stops)) list.push_back(Dwell{before});
  if (!options.trigger_m_code) return;
  list.push_back(Trigger{*options.trigger_m_code});
  if (dwell > before) list.push_back(Dwell{dwell - before});
  if (const auto off = off_code(*options.trigger_m_code, limits.m_codes)) list.push_back(Trigger{*off});
}

class ScriptWriter {
 public:
  ScriptWriter(const ProgramOptions& options, const ControlLimits& limits)
      : options_(options), limits_(limits), loops_left_(options.unrolled ? 0 : limits.loops) {}

  /// Everything that the plan's axes do.
  void walk_plan(const Plan& plan, const Spelling& spelling, const std::vector<RepeatedMoves>& stretches) {
    spelling_ = &spelling;
    if (options_.rollover) turn_.emplace(limits_.rollover, spelling.coordinates);
    for (Vector3 point : plan.way_in_mm) way(point, "WAY IN");
    start_ = spelling.line ? "TO " + line_name(plan) : "TO THE START";
    const bool stops = options_.stop_at_lines || (options_.stop_at_start && !std::exchange(started_, true));
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      stretch(stretches[k]);
      if (k == 0 && stops) list_.push_back(stop_at(std::get<Move>(list_.back()), spelling.coordinates.unit_word()));
    }
    for (Vector3 point : plan.way_out_mm) way(point, "WAY OUT");
  }

  /// The stretches of a plan with as many loops as there are left.
  std::vector<RepeatedMoves> stretches_of(const Plan& plan, std::vector<std::string>& remarks) {
    std::vector<RepeatedMoves> list = walk(plan, loops_left_);
    const auto loops =
        static_cast<std::size_t>(std::ranges::count_if(list, [](const RepeatedMoves& s) { return s.times > 1; }));
    if (loops_left_ > 0 && loops == 0 && plan.cycle == TestCycle::user_defined)
      remarks.emplace_back("WRITTEN OUT, THE ORDER OF APPROACHES DOES NOT REPEAT");
    if (loops_left_ > 0 && loops == loops_left_)
      remarks.push_back(fmt::format("AT MOST {} LOOPS, WHAT IS LEFT IS WRITTEN OUT", limits_.loops));
    loops_left_ -= loops;
    return list;
  }

  void remark(std::string text) { list_.push_back(Remark{std::move(text)}); }
  bool has_loops() const { return loops_ > 0; }
  /// Of the last plan; 0 where no word is an increment.
  int increment_decimals() const { return turn_ ? turn_->decimals_needed() : 0; }
  std::vector<Instruction> finish() && { return std::move(list_); }

 private:
  void way(Vector3 point, std::string remark) {
    list_.push_back(Move{spelling_->at(point), spelling_->feed, std::move(remark)});
  }

  void stretch(const RepeatedMoves& s) {
    // Words that tell the way from the position before are right every time only where each ends as it began.
    const bool returns = !turn_ || turn_->is_at(s.moves.back().to);
    if (s.times > 1 && !returns) {
      for (const PlannedMove& move : s.moves) drive(move, false);
      RepeatedMoves rest = s;
      --rest.times;
      for (PlannedMove& move : rest.moves)
        if (move.approach) ++move.approach->run;
      return once_or_loop(rest, true);
    }
    once_or_loop(s, false);
  }

  /// `goes_on`: it is what is left of a stretch, whose runs may have come in any order.
  void once_or_loop(const RepeatedMoves& s, bool goes_on) {
    const bool loop = s.times > 1;
    if (loop) {
      remark(loop_remark(s));
      list_.push_back(LoopBegin{++loops_, s.times});
    }
    for (const PlannedMove& move : s.moves) drive(move, loop || goes_on);
    if (loop) list_.push_back(LoopEnd{loops_, s.times});
  }

  void drive(const PlannedMove& move, bool loop) {
    std::string remark = std::exchange(start_, "");
    const bool first = !remark.empty();
    if (move.approach)
      remark = fmt::format("TARGET {} {}", move.approach->target + 1, word_of(move.approach->direction));
    if (move.approach && !loop) remark += fmt::format(" RUN {}", move.approach->run + 1);
    if (turn_)
      turn_to(move.to, remark);
    else
      list_.push_back(Move{spelling_->at(move.to, first), spelling_->feed, std::move(remark)});
    if (move.approach) add_rest(list_, spelling_->dwell, options_, limits_);
  }

  void turn_to(Position position, const std::string& remark) {
    for (TurnWord& word : turn_->to(position))
      list_.push_back(Move{{{spelling_->axis, std::move(word.coordinate), word.way}}, spelling_->feed, "ON THE WAY"});
    std::get<Move>(list_.back()).remark = remark;
  }

  const ProgramOptions& options_;
  const ControlLimits& limits_;
  const Spelling* spelling_ = nullptr;
  std::optional<Turn> turn_;
  std::size_t loops_left_ = 0;
  std::size_t loops_ = 0;
  std::string start_;  ///< what is said of the next move, the first of a plan
  bool started_ = false;
  std::vector<Instruction> list_;
};

std::string decimals_remark(const Coordinates& coordinates, const Plan& plan, const ProgramOptions& options) {
  const double error = coordinates.target_error(plan).in_native() * deviation_per_position(plan.axis.kind);
  const int decimals = coordinates.decimals();
  std::string text = fmt::format("COORDINATES WITH {} DECIMAL{}", decimals, decimals == 1 ? "" : "S");
  if (decimals > options.decimals) text += fmt::format(", {} WOULD MOVE {}", options.decimals, coordinates.moved());
  if (error > 1e-5)
    text += fmt::format(", ROUNDED BY UP TO {:.4f} {}", error, plan.axis.kind == AxisKind::linear ? "UM" : "ARCSEC");
  return text;
}

/// "plan 4, LINE XY"
std::string place_of(const Plan& plan, std::size_t k) { return fmt::format("plan {}, {}", k + 1, line_name(plan)); }

/// Between a line in space and a test of one axis nobody knows where the other axes stand.
Result<void> check_lines(std::span<const Plan> plans) {
  if (plans.empty()) return fail("found no plan, expected at least one");
  for (std::size_t k = 0; k < plans.size() && plans.size() > 1; ++k)
    if (!spatial_line(plans[k].axis))
      return fail(fmt::format("found {} without a line in space among several, expected one for each plan of a program",
                              place_of(plans[k], k)));
  return {};
}

/// What is said of a rotary axis, whether it has rollover or not.
std::vector<std::string> rollover_remarks(const Plan& plan, const Coordinates& coordinates, bool rollover,
                                          const ControlLimits& limits, int decimals) {
  if (plan.axis.kind != AxisKind::rotary || limits.rollover == RolloverWords::none) return {};
  if (!rollover) return {rollover_off_remark(plan)};
  const bool directed = limits.rollover == RolloverWords::directed;
  const std::string start = Turn(limits.rollover, coordinates).to(reach(plan).lowest).front().coordinate;
  const std::string first = fmt::format("THE FIRST MOVE, TO {} DEG, GOES {}", start,
                                        directed ? "THE SHORT WAY" : "THE WAY THAT THE CONTROL CHOOSES");
  if (directed) return {"ROLLOVER ON, ANGLES OF ONE TURN WITH THEIR DIRECTION", first};
  std::vector<std::string> remarks = {"ROLLOVER ON, ALL MOVES BUT THE FIRST ARE INCREMENTS", first,
                                      "DO NOT BEGIN IN THE MIDDLE"};
  if (decimals > 0)
    remarks.push_back(fmt::format("THE CONTROL MUST KEEP {} DECIMAL{}, WHAT IT DROPS WOULD ADD UP", decimals,
                                  decimals == 1 ? "" : "S"));
  return remarks;
}

std::vector<std::string> tour_heading(const PointTour& tour, std::size_t readings, const Coordinates& coordinates,
                                      const WorkFrame& frame) {
  std::vector<std::string> heading = tour.heading;
  heading.push_back(fmt::format("{} READINGS, FEED {} MM/MIN ALONG THE PATH, DWELL {} S", readings,
                                format_exact(tour.feed_mm_per_min), format_exact(tour.dwell.in_s())));
  heading.push_back(frame.remark);
  heading.emplace_back("ALL WAYS ARE STRAIGHT, AT FEED, AND MUST BE FREE");
  const Vector3 first = tour.stops.front().at_mm;
  heading.push_back(fmt::format("THE FIRST FROM WHERE THE AXES STAND TO X {} Y {} Z {}", format_exact(first.x),
                                format_exact(first.y), format_exact(first.z)));
  heading.push_back(fmt::format("COORDINATES WITH {} DECIMALS", coordinates.decimals()));
  return heading;
}

}  // namespace

Result<Script> make_script(const PointTour& tour, const ProgramOptions& options, const ControlLimits& limits) {
  const auto readings = static_cast<std::size_t>(std::ranges::count(tour.stops, true, &TourStop::is_reading));
  if (readings == 0) return fail("found no point to read a length at, expected at least one");
  AXIOMETRY_TRY_VOID(check_axes_in_space(limits));
  AXIOMETRY_TRY_VOID(check_trigger(options.trigger_m_code, limits.m_codes));
  AXIOMETRY_TRY_VOID(check_rollover(AxisKind::linear, options.rollover, limits));
  AXIOMETRY_TRY(WorkFrame frame, work_frame(options.frame, limits.frames));
  Plan plan;  // of a linear axis: what the checks of feed and coordinates ask
  plan.feed = tour.feed_mm_per_min;
  std::vector<Vector3> points;
  for (const TourStop& stop : tour.stops) {
    points.push_back(stop.at_mm);
    for (std::size_t k = 0; k < 3; ++k)
      AXIOMETRY_TRY_VOID(check_coordinate(stop.at_mm[k], axes_in_space[k], plan, limits));
  }
  AXIOMETRY_TRY(const Coordinates coordinates, Coordinates::of_points(points, options));
  AXIOMETRY_TRY(const std::string feed, feed_word(plan, coordinates.in_inch(), limits));
  AXIOMETRY_TRY(const long dwell, dwell_steps(tour.dwell, limits));
  Script script;
  script.inch = coordinates.in_inch();
  script.heading = tour_heading(tour, readings, coordinates, frame);
  script.frame = std::move(frame);
  std::size_t reading = 0;
  for (const TourStop& stop : tour.stops) {
    Move move{{}, feed, stop.is_reading ? fmt::format("POINT {} OF {}", ++reading, readings) : "ON THE WAY"};
    for (std::size_t k = 0; k < 3; ++k)
      move.axes.push_back({std::string(axes_in_space[k]), coordinates.text(stop.at_mm[k])});
    script.instructions.push_back(std::move(move));
    if (!stop.is_reading) continue;
    if (reading == 1 && options.stop_at_start)
      script.instructions.push_back(OperatorStop{"SET THE INSTRUMENT, THE AXES ARE AT THE FIRST POINT"});
    else if (stop.find_beam)
      script.instructions.push_back(OperatorStop{"FIND THE BEAM AGAIN, A SEGMENT BEGINS"});
    add_rest(script.instructions, dwell, options, limits);
  }
  return script;
}

Result<Script> make_script(std::span<const Plan> plans, const ProgramOptions& options, const ControlLimits& limits) {
  AXIOMETRY_TRY_VOID(check_lines(plans));
  AXIOMETRY_TRY_VOID(check_trigger(options.trigger_m_code, limits.m_codes));
  AXIOMETRY_TRY_VOID(check_rollover(plans.front().axis.kind, options.rollover, limits));
  const bool several = plans.size() > 1;
  Script script;
  AXIOMETRY_TRY(script.frame, work_frame(options.frame, limits.frames));
  script.inch = options.unit == LengthUnit::inch;
  script.heading =
      several ? headlines(plans, options, script.frame.remark) : headlines(plans.front(), options, script.frame.remark);
  ScriptWriter writer(options, limits);
  for (std::size_t k = 0; k < plans.size(); ++k) {
    const Plan& plan = plans[k];
    auto spelling = make_spelling(plan, options, limits);
    if (!spelling && several) spelling.error().message += fmt::format(" ({})", place_of(plan, k));
    AXIOMETRY_TRY_VOID(spelling);
    std::vector<std::string> remarks = {decimals_remark(spelling->coordinates, plan, options)};
    const std::vector<RepeatedMoves> stretches = writer.stretches_of(plan, remarks);
    if (several) {
      writer.remark(fmt::format("{} OF {}, {}", k + 1, plans.size(), line_name(plan)));
      for (std::string& line : line_headlines(plan)) writer.remark(std::move(line));
      for (std::string& line : remarks) writer.remark(std::move(line));
    } else {
      std::ranges::move(remarks, std::back_inserter(script.heading));
    }
    writer.walk_plan(plan, *spelling, stretches);
    if (!several)
      std::ranges::move(
          rollover_remarks(plan, spelling->coordinates, options.rollover, limits, writer.increment_decimals()),
          std::back_inserter(script.heading));
  }
  script.has_loops = writer.has_loops();
  script.instructions = std::move(writer).finish();
  return script;
}

}  // namespace axiometry::nc
