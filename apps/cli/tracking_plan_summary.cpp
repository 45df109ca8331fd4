// SPDX-License-Identifier: Apache-2.0
#include "tracking_plan_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "axiometry/report/plan_sheet.h"
#include "axiometry/report/utf8.h"

namespace axiometry::cli {
namespace {

std::string place(Vector3 v, const report::Options& options) {
  return fmt::format("X {}, Y {}, Z {} mm", format_fixed(v.x, 3, options.numbers),
                     format_fixed(v.y, 3, options.numbers), format_fixed(v.z, 3, options.numbers));
}

std::size_t id_width(const TrackingPlan& plan) {
  std::size_t width = 5;
  for (const TrackingLine& line : plan.lines) width = std::max(width, display_width(line.id));
  for (const LostLine& line : plan.lost) width = std::max(width, display_width(line.id));
  return width + 2;
}

std::string line_table(const TrackingPlan& plan, const report::Options& options, const Terminal& terminal) {
  const std::size_t width = id_width(plan);
  std::string text = terminal.faint(left("line", width) + left("octant", 8) + right("from/mm", 10) +
                                    right("to/mm", 10) + right("targets", 9) + right("runs", 6) + "  ends at") +
                     "\n";
  for (const TrackingLine& line : plan.lines) {
    const auto interval = tracking::interval_of(plan.setup, line);
    const auto number = [&](double x) { return right(format_fixed(x, 1, options.numbers), 10); };
    text += left(line.id, width) + left(interval ? interval->octant : "–", 8) +
            (interval ? number(interval->begin_mm) + number(interval->end_mm) : right("–", 10) + right("–", 10)) +
            right(fmt::format("{}", line.plan.targets.size()), 9) + right(fmt::format("{}", line.plan.runs), 6) +
            (interval ? fmt::format("  {}; {}", interval->limited_by_begin, interval->limited_by_end)
                      : "  both ends of the travels") +
            "\n";
  }
  return text + "\n";
}

std::string entry(std::string_view head, const std::string& text, const Terminal& terminal) {
  constexpr std::size_t indent = 6;
  return wrapped(left(head, indent) + report::printable(text), terminal.width(), indent) + "\n";
}

/// Lost lines with one reason stand together.
std::string notes(const TrackingPlan& plan, const Terminal& terminal) {
  std::vector<LostLine> lost;
  for (const LostLine& one : plan.lost) {
    const auto same = std::ranges::find(lost, one.reason, &LostLine::reason);
    if (same == lost.end())
      lost.push_back(one);
    else
      same->id += ", " + one.id;
  }
  std::string text;
  for (const LostLine& one : lost) text += entry("lost", one.id + ": " + one.reason, terminal);
  for (const std::string& remark : plan.remarks) text += entry("note", remark, terminal);
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string tracking_plan_summary(const app::PlannedLines& planned, const report::Options& options,
                                  const Terminal& terminal) {
  const TrackingPlan& plan = planned.plan;
  std::string title = plan.title.empty() ? "Lines from a tracking interferometer" : plan.title;
  if (!plan.machine.empty()) title += " on " + plan.machine;
  std::string text = terminal.bold(report::printable(title)) + "\n" +
                     fmt::format("Station at {}\n\n", place(plan.setup.station.position_mm, options));
  text += line_table(plan, options, terminal) + notes(plan, terminal);
  const std::string kept = fmt::format("{} of {} lines.", plan.lines.size(), plan.lines.size() + plan.lost.size());
  return text + fmt::format("Takes about {}. ", report::duration_text(planned.duration)) +
         (plan.lost.empty() ? terminal.green(kept) : terminal.yellow(kept)) + "\n";
}

}  // namespace axiometry::cli
