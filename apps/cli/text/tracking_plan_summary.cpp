// SPDX-License-Identifier: Apache-2.0
#include "cli/text/tracking_plan_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "axiometry/base/counted.h"
#include "axiometry/model/aligned.h"
#include "axiometry/report/documents/plan_sheet.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/translated.h"

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
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  const std::size_t width = id_width(plan);
  const std::size_t targets = std::max<std::size_t>(9, display_width(said("targets")) + 2);
  const std::size_t runs = std::max<std::size_t>(6, display_width(said("runs")) + 2);
  std::string text =
      terminal.faint(left(said("line"), width) + left(said("octant"), 8) + right(said("from") + "/mm", 10) +
                     right(said("to") + "/mm", 10) + right(said("targets"), targets) + right(said("runs"), runs) +
                     "  " + said("ends at")) +
      "\n";
  for (const TrackingLine& line : plan.lines) {
    const auto interval = tracking::interval_of(plan.setup, line);
    const auto number = [&](double x) { return right(format_fixed(x, 1, options.numbers), 10); };
    text += left(line.id, width) + left(interval ? interval->octant : "–", 8) +
            (interval ? number(interval->begin_mm) + number(interval->end_mm) : right("–", 10) + right("–", 10)) +
            right(fmt::format("{}", line.plan.targets.size()), targets) +
            right(fmt::format("{}", line.plan.runs), runs) +
            (interval ? "  " + said(interval->limited_by_begin) + "; " + said(interval->limited_by_end)
                      : "  " + said("both ends of the travels")) +
            "\n";
  }
  return text + "\n";
}

std::string entry(std::string_view head, const std::string& text, const Terminal& terminal) {
  return wrapped(std::string(head) + report::printable(text), terminal.width(), display_width(head)) + "\n";
}

/// Lost lines with one reason stand together.
std::string notes(const TrackingPlan& plan, const report::Options& options, const Terminal& terminal) {
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  const std::string lost_word = said("lost"), note_word = said("note");
  const std::size_t indent = std::max(display_width(lost_word), display_width(note_word)) + 2;
  std::vector<LostLine> lost;
  for (const LostLine& one : plan.lost) {
    const auto same = std::ranges::find(lost, one.reason, &LostLine::reason);
    if (same == lost.end())
      lost.push_back(one);
    else
      same->id += ", " + one.id;
  }
  std::string text;
  for (const LostLine& one : lost) text += entry(left(lost_word, indent), one.id + ": " + said(one.reason), terminal);
  for (const std::string& remark : plan.remarks) text += entry(left(note_word, indent), said(remark), terminal);
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string tracking_plan_summary(const app::PlannedLines& planned, const report::Options& options,
                                  const Terminal& terminal) {
  const TrackingPlan& plan = planned.plan;
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  std::string title = plan.title.empty() ? said(is_aligned(plan.setup) ? "Diagonals by an aligned interferometer"
                                                                       : "Lines from a tracking interferometer")
                                         : plan.title;
  if (!plan.machine.empty()) title += (options.language == language::Language::english ? " on " : ", ") + plan.machine;
  std::string text =
      terminal.bold(report::printable(title)) + "\n" +
      said(is_aligned(plan.setup) ? std::string("An interferometer that is aligned with each line in turn")
                                  : fmt::format("Station at {}", place(plan.setup.station.position_mm, options))) +
      "\n\n";
  text += line_table(plan, options, terminal) + notes(plan, options, terminal);
  const std::string kept =
      said(fmt::format("{} of {}.", plan.lines.size(), counted(plan.lines.size() + plan.lost.size(), "line")));
  return text + said(fmt::format("Takes about {}.", report::duration_text(planned.duration))) + " " +
         (plan.lost.empty() ? terminal.green(kept) : terminal.yellow(kept)) + "\n";
}

}  // namespace axiometry::cli
