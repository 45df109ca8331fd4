// SPDX-License-Identifier: Apache-2.0
#include "cli/text/plan_summary.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "axiometry/base/counted.h"
#include "axiometry/report/documents/plan_sheet.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/test_standard.h"
#include "cli/text/findings_text.h"
#include "cli/text/title_text.h"

namespace axiometry::cli {
namespace {

constexpr std::size_t rows_at_most = 40;  // of a table of targets; then its ends
constexpr std::size_t rows_at_ends = 5;
constexpr std::size_t number_width = 14;

std::string with_unit(double x, const Plan& plan, const report::Options& options) {
  return report::shown_short(x, options) + (plan.axis.kind == AxisKind::linear ? " mm" : "°");
}

bool both_directions(const Plan& plan) {
  const auto all = approaches(plan);
  return std::ranges::find(all, Direction::up, &Approach::direction) != all.end() &&
         std::ranges::find(all, Direction::down, &Approach::direction) != all.end();
}

std::string programme(const Plan& plan, const report::Options& options, const Terminal& terminal) {
  const std::string text =
      fmt::format("{} from {} to {}, {} {}, {} cycle{}", counted(plan.targets.size(), "target"),
                  report::shown_short(plan.targets.front().in_native(), options),
                  with_unit(plan.targets.back().in_native(), plan, options), counted(plan.runs, "run"),
                  both_directions(plan) ? "in both directions" : "in one direction", cycle_name(plan.cycle),
                  plan.clause.empty() ? "" : fmt::format(" ({})", plan.clause));
  std::string details =
      fmt::format("Feed {}/min, dwell {} s, overrun {}", with_unit(plan.feed, plan, options),
                  report::shown_short(plan.dwell.in_s(), options), with_unit(plan.overrun.in_native(), plan, options));
  if (plan.warm_up_runs > 0) details += fmt::format(", {}", counted(plan.warm_up_runs, "warm-up run"));
  if (plan.seed) details += fmt::format(", seed {}", *plan.seed);
  const std::string errors = plan.errors.empty() ? "" : errors_text(plan) + ": ";
  return errors + report::translated(text, options) + "\n" + terminal.faint(report::translated(details, options)) +
         "\n\n";
}

std::string target_table(const Plan& plan, const report::Options& options, const Terminal& terminal) {
  const std::string_view unit = position_unit(plan.axis.kind);
  const int decimals = report::position_decimals(plan.targets);
  const std::size_t m = plan.targets.size();
  const std::size_t room = options.language == language::Language::english ? 0 : 4;
  std::string text =
      terminal.faint(right("i", 5) +
                     right(fmt::format("{}/{}", report::translated("target", options), unit), number_width + room) +
                     right(fmt::format("{}/{}", report::translated("interval", options), unit), number_width)) +
      "\n";
  for (std::size_t i = 0; i < m; ++i) {
    if (m > rows_at_most && i == rows_at_ends) {
      text += terminal.faint(right("…", 5) + "  " +
                             report::translated(fmt::format("{} more", m - 2 * rows_at_ends), options)) +
              "\n";
      i = m - rows_at_ends;
    }
    const double x = plan.targets[i].in_native();
    text += right(fmt::format("{}", i + 1), 5) + right(format_fixed(x, decimals, options.numbers), number_width + room);
    if (i > 0)
      text += right(format_fixed(x - plan.targets[i - 1].in_native(), decimals, options.numbers), number_width);
    text += '\n';
  }
  return text + "\n";
}

/// "4.3, 5.1": each clause of which something is missing, once.
std::string clauses_missing(const std::vector<iso230_2::Finding>& findings) {
  std::vector<std::string> clauses;
  for (const iso230_2::Finding& finding : findings)
    if (finding.severity == iso230_2::Severity::missing && std::ranges::find(clauses, finding.clause) == clauses.end())
      clauses.push_back(finding.clause);
  return fmt::format("{}", fmt::join(clauses, ", "));
}

std::string conclusion(const app::PlannedTest& planned, const report::Options& options, const Terminal& terminal) {
  const auto said = [&](const std::string& english) { return report::translated(english, options); };
  const auto departures =
      std::ranges::count(planned.findings, iso230_2::Severity::departure, &iso230_2::Finding::severity);
  std::string text =
      fmt::format("Takes about {} at {} {}/s²", report::duration_text(planned.duration_in_all),
                  format_exact(iso230_2::acceleration_of(planned.plan)), position_unit(planned.plan.axis.kind));
  if (!planned.plan.further.empty())
    text += fmt::format(", {} of it over the whole travel", report::duration_text(planned.duration));
  text = said(text + ".") + " ";
  const std::string_view label = cycle_label(planned.plan.cycle);
  const std::string labelled = label.empty() ? "\n" : " " + terminal.bold(said(fmt::format("{}.", label))) + "\n";
  if (!measures_positions(planned.plan)) {
    const std::string errors = errors_text(planned.plan);
    return text +
           (planned.conforming() ? terminal.green(said(fmt::format("Plan for {}.", errors)))
                                 : terminal.red(said(fmt::format("Not a plan for {}: see the findings.", errors)))) +
           labelled;
  }
  const std::string edition = edition_of(planned.plan.axis);
  if (planned.in_accordance())
    text += terminal.green(said(fmt::format("Plan after {}.", edition)));
  else if (planned.conforming())
    text += terminal.bold(
        said(fmt::format("As planned not yet in accordance with {}: {}.", edition, clauses_missing(planned.findings))));
  else
    text += terminal.red(said(
        fmt::format("Not a plan after {}: {}.", edition, counted(static_cast<std::size_t>(departures), "departure"))));
  return text + labelled;
}

}  // namespace

std::string plan_summary(const app::PlannedTest& planned, const report::Options& options, const Terminal& terminal) {
  const Plan& plan = planned.plan;
  const std::string title = title_text(plan.axis, plan.machine, options);
  std::string text = fmt::format("{}  {}\n", terminal.bold(report::printable(title)),
                                 report::translated(axis_kind_name(plan.axis.kind), options));
  text += programme(plan, options, terminal) + target_table(plan, options, terminal);
  for (const Plan& part : plan.further)
    text += terminal.bold(
                report::printable(report::translated(part.title.empty() ? "Further test" : part.title, options))) +
            "\n" + programme(part, options, terminal) + target_table(part, options, terminal);
  return text + findings_text(planned.findings, options, terminal) + conclusion(planned, options, terminal);
}

}  // namespace axiometry::cli
