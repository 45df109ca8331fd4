// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/programme.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "axiometry/base/counted.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/label.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/scale.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/iso230_2/plan/plan.h"

namespace axiometry::report {
namespace {

using plot::label;
using plot::Operations;
namespace ink = plot::ink;

constexpr double plot_left = 46.0;    // room for the times
constexpr double plot_right = 440.0;  // beyond it the names of the runs
constexpr double names_at = 446.0;
constexpr double head = 16.0;  // the numbers of the targets
constexpr double foot = 30.0;  // positions and their unit
constexpr double legend_room = 16.0;
constexpr double height_per_move = 2.6;
constexpr double least_height = 150.0;
constexpr double most_height = 320.0;
constexpr double least_pitch = 9.0;          // between labels
constexpr double number_width = 11.0;        // width of a target's number
constexpr double least_gap = 0.1;            // between the lines of targets, which are 0.5 wide
constexpr std::size_t most_readings = 1500;  // readings that are drawn as dots
constexpr std::size_t most_legs = 20'000;    // beyond which a picture would be a black box of many megabytes
constexpr double pad = 0.03;                 // free share of the reach beside it

/// Where the axis is when; times in s.
struct Station {
  double time = 0.0;
  double position = 0.0;
};

struct Leg {
  Station from, to;
  double leave = 0.0;  ///< after the dwell
  std::optional<Approach> approach;
  bool warm_up = false;
};

std::vector<Leg> legs_of(const Plan& plan) {
  const std::vector<PlannedMove> list = moves(plan);
  const std::vector<Duration> durations = iso230_2::move_durations(list, plan.feed, iso230_2::acceleration_of(plan));
  std::vector<Leg> legs;
  double now = 0.0;
  bool warm_up = plan.warm_up_runs > 0;
  for (std::size_t k = 1; k < list.size(); ++k) {
    Leg leg{{now, list[k - 1].to.in_native()}, {}, 0.0, list[k].approach, false};
    warm_up = warm_up && k <= 2 * plan.warm_up_runs;
    leg.warm_up = warm_up;
    leg.to = {now + durations[k].in_s(), list[k].to.in_native()};
    leg.leave = now = leg.to.time + (leg.approach ? plan.dwell.in_s() : 0.0);
    legs.push_back(leg);
  }
  return legs;
}

/// What a stretch of the cycle is called beside it; readings of one name stand together.
std::string name_of(const Plan& plan, const Leg& leg) {
  if (leg.warm_up) return "Warm-up";
  if (!leg.approach) return "";
  switch (plan.cycle) {
    case TestCycle::standard:
    case TestCycle::unidirectional: return fmt::format("Run {}", leg.approach->run + 1);
    case TestCycle::step: return fmt::format("Target {}", leg.approach->target + 1);
    case TestCycle::pilgrim: return fmt::format("All runs {}", arrow(leg.approach->direction));
    case TestCycle::user_defined: break;
  }
  return "";
}

class ProgrammeDrawing {
 public:
  ProgrammeDrawing(const Plan& plan, const Options& options) : plan_(plan), options_(options), legs_(legs_of(plan)) {
    const auto [lowest, highest] = reach(plan);
    low_ = lowest.in_native();
    high_ = highest.in_native();
    const double room = pad * (high_ - low_);
    x_ = {low_ - room, high_ + room, plot_left, plot_right};
  }

  Figure draw() {
    const double top =
        plot::draw_label(operations_, translated(cycle_label(plan_.cycle), options_), 0.0, plot_right) + head;
    const double height = std::clamp(height_per_move * static_cast<double>(legs_.size()), least_height, most_height);
    y_ = {0.0, legs_.back().leave, top + 5.0, top + height - 5.0};
    top_ = top;
    bottom_ = top + height;
    draw_overruns();
    draw_targets();
    draw_times();
    draw_positions();
    draw_way();
    draw_names();
    draw_legend();
    Figure figure{.width = plot::plate_width,
                  .height = bottom_ + foot + legend_room,
                  .title = caption(),
                  .description = description(),
                  .operations = std::move(operations_)};
    return figure;
  }

 private:
  std::string caption() const {
    return fmt::format("Test programme, {} cycle: the way of the axis over the time{}", cycle_name(plan_.cycle),
                       plan_.title.empty() ? "" : ". " + plan_.title);
  }

  std::string description() const {
    return fmt::format("{}, {}, {}.", counted(plan_.targets.size(), "target"), counted(plan_.runs, "run"),
                       counted(approaches(plan_).size(), "reading"));
  }

  void draw_overruns() {
    const double first = plan_.targets.front().in_native(), last = plan_.targets.back().in_native();
    for (const auto& [from, to] : {std::pair{low_, first}, std::pair{last, high_}})
      operations_.push_back(Path{.points = {{x_(from), top_}, {x_(to), top_}, {x_(to), bottom_}, {x_(from), bottom_}},
                                 .closed = true,
                                 .stroke = ink::solid(ink::none, 0.0),
                                 .fill = ink::minor_grid_grey});
  }

  void draw_targets() {
    const double last = x_(plan_.targets.back().in_native());
    double free_from = -1.0, line_from = -1.0;
    for (std::size_t i = 0; i < plan_.targets.size(); ++i) {
      const double x = x_(plan_.targets[i].in_native());
      if (x >= line_from) {
        operations_.push_back(plot::line({x, top_}, {x, bottom_}, ink::solid(ink::grid_grey, 0.5)));
        line_from = x + least_gap;
      }
      if (x < free_from || (x > last - number_width && i + 1 < plan_.targets.size())) continue;
      operations_.push_back(label({plot::plain(fmt::format("{}", i + 1))}, {x, top_ - 4.0}, ink::tick_text_size,
                                  Anchor::middle, ink::grey));
      free_from = x + number_width;
    }
    operations_.push_back(label({plot::italic("i")}, {plot_left - 6.0, top_ - 4.0}, ink::text_size, Anchor::end));
  }

  void draw_times() {
    const bool minutes = legs_.back().leave > 300.0;
    const double unit = minutes ? 60.0 : 1.0;
    const plot::Ticks ticks = plot::divide(0.0, legs_.back().leave / unit, 6.0, plot::Division::decimal);
    for (double t : ticks.major) {
      const double y = y_(t * unit);
      operations_.push_back(plot::line({plot_left - 3.0, y}, {plot_left, y}, ink::solid(ink::black, 0.6)));
      operations_.push_back(label({plot::plain(plot::tick_label(t, ticks.decimals, options_.numbers))},
                                  {plot_left - 6.0, y + 2.5}, ink::tick_text_size, Anchor::end));
    }
    operations_.push_back(plot::line({plot_left, top_}, {plot_left, bottom_}, ink::solid(ink::black, 0.6)));
    Text title = label({plot::plain(translated(minutes ? "Time / min" : "Time / s", options_))},
                       {10.0, 0.5 * (top_ + bottom_)}, ink::text_size, Anchor::middle);
    title.degrees = 90.0;
    operations_.push_back(std::move(title));
  }

  void draw_positions() {
    const AxisKind kind = plan_.axis.kind;
    const plot::AxisUnit unit = plot::position_axis_unit(kind, std::max(std::abs(low_), std::abs(high_)));
    const plot::Ticks ticks =
        plot::divide(x_.value_low / unit.native, x_.value_high / unit.native, 7.0,
                     kind == AxisKind::linear ? plot::Division::decimal : plot::Division::angular);
    for (double x : ticks.major) {
      const double at = x_(x * unit.native);
      operations_.push_back(plot::line({at, bottom_}, {at, bottom_ + 3.0}, ink::solid(ink::black, 0.6)));
      operations_.push_back(label({plot::plain(plot::tick_label(x, ticks.decimals, options_.numbers))},
                                  {at, bottom_ + 11.0}, ink::tick_text_size, Anchor::middle));
    }
    operations_.push_back(plot::line({plot_left, bottom_}, {plot_right, bottom_}, ink::solid(ink::black, 0.6)));
    operations_.push_back(label(plot::joined({plot::plain(translated("Position", options_) + " / ")}, unit.name),
                                {0.5 * (plot_left + plot_right), bottom_ + 22.0}, ink::text_size, Anchor::middle));
  }

  static Stroke pen(const Leg& leg) {
    return leg.approach ? ink::solid(ink::of(leg.approach->direction), 0.8) : ink::solid(ink::extension_grey, 0.6);
  }

  /// One line for each stretch of one colour.
  void draw_way() {
    if (legs_.size() > most_legs) {
      operations_.push_back(
          label({plot::plain(translated(fmt::format("{} moves: too many to draw", legs_.size()), options_))},
                {0.5 * (plot_left + plot_right), 0.5 * (top_ + bottom_)}, ink::text_size, Anchor::middle, ink::grey));
      return;
    }
    const bool dots = approaches(plan_).size() <= most_readings;
    std::vector<Operation> readings;
    Path path;
    for (std::size_t k = 0; k < legs_.size(); ++k) {
      const Leg& leg = legs_[k];
      const Point from{x_(leg.from.position), y_(leg.from.time)}, to{x_(leg.to.position), y_(leg.to.time)};
      if (path.points.empty()) path = {.points = {from}, .closed = false, .stroke = pen(leg), .fill = ink::none};
      path.points.push_back(to);
      const Point left{to.x, y_(leg.leave)};
      if (leg.approach) path.points.push_back(left);
      if (leg.approach && dots)
        readings.push_back(
            Disc{.centre = left, .radius = 1.3, .fill = ink::of(leg.approach->direction), .stroke = {.width = 0.0}});
      if (k + 1 < legs_.size() && pen(legs_[k + 1]).colour == pen(leg).colour) continue;
      operations_.push_back(std::exchange(path, Path{}));
    }
    std::ranges::move(readings, std::back_inserter(operations_));
  }

  /// In the middle of what they name; those that would touch are left out.
  void draw_names() {
    double free_from = -1.0;
    for (std::size_t k = 0; k < legs_.size();) {
      const std::string name = name_of(plan_, legs_[k]);
      if (name.empty()) {
        ++k;
        continue;
      }
      std::size_t end = k + 1, last = k;
      for (; end < legs_.size(); ++end) {
        const std::string next = name_of(plan_, legs_[end]);
        if (next == name) last = end;
        if (next != name && !next.empty()) break;
      }
      const double top = y_(legs_[k].from.time), bottom = y_(legs_[last].leave);
      if (0.5 * (top + bottom) - 0.5 * least_pitch >= free_from) {
        operations_.push_back(plot::line({names_at - 2.0, top + 1.0}, {names_at - 2.0, bottom - 1.0},
                                         ink::solid(ink::extension_grey, 0.6)));
        operations_.push_back(label({plot::plain(translated(name, options_))},
                                    {names_at + 3.0, 0.5 * (top + bottom) + 2.5}, ink::tick_text_size, Anchor::start,
                                    ink::black));
        free_from = 0.5 * (top + bottom) + 0.5 * least_pitch;
      }
      k = last + 1;
    }
  }

  void draw_legend() {
    std::vector<plot::LegendEntry> entries;
    const auto entry = [&](Colour colour, bool mark, std::string_view text) {
      entries.push_back(
          {ink::solid(colour, 0.8),
           std::nullopt,
           mark ? std::optional(Disc{.radius = 1.3, .fill = colour, .stroke = {.width = 0.0}}) : std::nullopt,
           {plot::plain(translated(text, options_))}});
    };
    const std::vector<Approach> all = approaches(plan_);
    for (Direction direction : {Direction::up, Direction::down})
      if (std::ranges::find(all, direction, &Approach::direction) != all.end())
        entry(ink::of(direction), true,
              direction == Direction::up ? "Approach ↑ and reading" : "Approach ↓ and reading");
    entry(ink::extension_grey, false, "Way without reading");
    entries.push_back({std::nullopt, ink::grid_grey, std::nullopt, {plot::plain(translated("Overrun", options_))}});
    plot::draw_legend(operations_, entries, {plot_left, bottom_ + foot}, plot_right - plot_left);
  }

  const Plan& plan_;
  const Options& options_;
  std::vector<Leg> legs_;
  double low_ = 0.0, high_ = 0.0;  ///< ends of the reach
  plot::Scale x_, y_;
  double top_ = 0.0, bottom_ = 0.0;  ///< edges of the plot on paper
  Operations operations_;
};

}  // namespace

Figure programme_figure(const Plan& plan, const Options& options) { return ProgrammeDrawing(plan, options).draw(); }

}  // namespace axiometry::report
