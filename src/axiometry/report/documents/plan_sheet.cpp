// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/documents/plan_sheet.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/base/counted.h"
#include "axiometry/model/fields.h"
#include "axiometry/report/figures/programme.h"
#include "axiometry/report/sections/fact.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/iso230_2/plan/plan.h"
#include "axiometry/standards/rules/rule.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::report {
namespace {

using iso230_2::Severity;

constexpr std::size_t most_targets_of_plan = 500;

std::string with_unit(double x, const Plan& plan, const Options& options, std::string_view per = "") {
  const std::string_view unit = position_unit(plan.axis.kind);
  return fmt::format("{}{}{}{}", shown_short(x, options), unit == "°" ? "" : "\u00a0", unit, per);
}

TableCell text_or_quiet(std::string_view text) { return text.empty() ? quiet_cell("not stated") : text_cell(text); }

/// The same of words of the user.
TableCell verbatim_or_quiet(std::string_view text) {
  return text.empty() ? quiet_cell("not stated") : verbatim_cell(text);
}

std::string travel_text(const Plan& plan, const Options& options) {
  const Axis& axis = plan.axis;
  if (!axis.travel_begin || !axis.travel_end) return "";
  return fmt::format("{} to {}", shown_short(axis.travel_begin->in_native(), options),
                     with_unit(axis.travel_end->in_native(), plan, options));
}

std::string cycle_text(const Plan& plan) {
  return fmt::format("{}{}{}", cycle_name(plan.cycle), plan.clause.empty() ? "" : ", ", plan.clause);
}

Facts programme_facts(const Plan& plan, Duration duration, const Options& options) {
  const auto [lowest, highest] = reach(plan);
  Facts facts{"Programme", {}};
  auto& list = facts.facts;
  if (!plan.errors.empty()) list.push_back(fact("Errors", errors_text(plan)));
  list.push_back(fact("Test cycle", cycle_text(plan)));
  if (const auto* rule = standards::find_axis_rule(plan.rule)) list.push_back(fact("Rule", std::string(rule->name)));
  list.push_back(fact("Targets", fmt::format("{} from {} to {}", plan.targets.size(),
                                             shown_short(plan.targets.front().in_native(), options),
                                             with_unit(plan.targets.back().in_native(), plan, options))));
  list.push_back(
      fact("Approaches", fmt::format("{} in {} run{}", approaches(plan).size(), plan.runs, plan.runs == 1 ? "" : "s")));
  list.push_back(fact("Feed speed", with_unit(plan.feed, plan, options, "/min")));
  list.push_back(fact("Dwell at each target", fmt::format("{}\u00a0s", shown_short(plan.dwell.in_s(), options))));
  list.push_back(fact("Overrun", with_unit(plan.overrun.in_native(), plan, options)));
  list.push_back(fact("The axis moves", fmt::format("from {} to {}", shown_short(lowest.in_native(), options),
                                                    with_unit(highest.in_native(), plan, options))));
  list.push_back(fact("Warm-up", plan.warm_up_runs == 0
                                     ? std::string("none in the programme")
                                     : fmt::format("{} run{} there and back at the feed speed", plan.warm_up_runs,
                                                   plan.warm_up_runs == 1 ? "" : "s")));
  list.push_back(fact("Duration, about", fmt::format("{} (at {}\u00a0{}/s²)", duration_text(duration),
                                                     shown_short(iso230_2::acceleration_of(plan), options),
                                                     position_unit(plan.axis.kind))));
  return facts;
}

Facts origin_facts(const Plan& plan, const Options& options) {
  Facts facts{"Choice of the targets (5.2)", {}};
  facts.facts.push_back({plain("Axis travel"), text_or_quiet(travel_text(plan, options))});
  facts.facts.push_back(
      {plain("Expected period"),
       text_or_quiet(plan.axis.expected_period ? with_unit(plan.axis.expected_period->in_native(), plan, options)
                                               : "")});
  const std::size_t points = plan.axis.compensation_points.size();
  facts.facts.push_back({plain("Sampling points of the compensation"),
                         text_or_quiet(points == 0 ? "" : fmt::format("{} avoided", points))});
  facts.facts.push_back({plain("Random part"), plan.seed ? text_cell(fmt::format("drawn, seed {}", *plan.seed))
                                                         : text_cell("none: targets as given")});
  return facts;
}

Table target_table(const Plan& plan, const Options& options) {
  const std::string unit(position_unit(plan.axis.kind));
  const int decimals = position_decimals(plan.targets);
  Table table;
  table.columns = {{italic("i"), Align::start, true},
                   {joined({symbol("P_i"), plain(" / " + unit)}), Align::decimal},
                   {plain("Interval / " + unit), Align::decimal},
                   {plain("Off even spacing / " + unit), Align::decimal}};
  const std::size_t m = plan.targets.size();
  const double first = plan.targets.front().in_native();
  const double p = m < 2 ? 0.0 : (plan.targets.back().in_native() - first) / static_cast<double>(m - 1);
  for (std::size_t i = 0; i < std::min(m, most_targets_of_plan); ++i) {
    const double x = plan.targets[i].in_native();
    const double interval = i == 0 ? 0.0 : x - plan.targets[i - 1].in_native();
    table.rows.push_back({text_cell(fmt::format("{}", i + 1)), text_cell(format_fixed(x, decimals, options.numbers)),
                          i == 0 ? quiet_cell("–") : text_cell(format_fixed(interval, decimals, options.numbers)),
                          text_cell(format_fixed(x - first - static_cast<double>(i) * p, decimals, options.numbers))});
  }
  if (m > most_targets_of_plan)
    table.notes.push_back(
        plain(fmt::format("… and {} more; all of them stand in the plan.", m - most_targets_of_plan)));
  table.dense = m > 12;
  return table;
}

/// What a plan knows of the items of clause 8.1.
Metadata known_before(const Plan& plan) {
  Metadata known;
  known.axis = plan.axis;
  known.machine.name = plan.machine;
  known.conditions.cycle = plan.cycle;
  known.conditions.feed = plan.feed;
  known.conditions.dwell = plan.dwell;
  if (plan.warm_up_runs > 0) known.conditions.warm_up = counted(plan.warm_up_runs, "run");
  return known;
}

Section checklist(const Plan& plan) {
  Section section{"conditions", "To be noted at the test (8.1)", false, {}};
  const Metadata known = known_before(plan);
  Metadata corrected = known;  // the items that only a correction for expansion needs
  corrected.nde.applied = true;
  Facts machine{"Test, machine and axis", {}}, equipment{"Equipment and surroundings", {}};
  for (const Field& field : metadata_fields()) {
    if (!is_wanted(field, corrected) || is_given(field, known)) continue;
    const std::string_view unit = field_unit(field, plan.axis.kind);
    const bool is_of_machine =
        std::ranges::any_of(std::array{"test.", "machine.", "axis."},
                            [&](std::string_view prefix) { return field.key.starts_with(prefix); });
    (is_of_machine ? machine : equipment)
        .facts.push_back(
            {plain(unit.empty() ? std::string(field.title) : fmt::format("{} / {}", field.title, unit)), to_fill_in()});
  }
  section.blocks.emplace_back(std::move(machine));
  section.blocks.emplace_back(std::move(equipment));
  return section;
}

Section plan_finding_section(std::span<const iso230_2::Finding> findings) {
  Section section = finding_section(findings);
  if (findings.empty()) section.blocks = {Paragraph{plain("None: nothing in the plan departs from clauses 3 to 5.")}};
  return section;
}

void append_programme(Document& document, const Plan& plan, Duration duration, std::size_t number,
                      const Options& options) {
  const std::string suffix = number == 0 ? "" : fmt::format("-{}", number);
  const std::string title = plan.title.empty() ? std::string("Test programme") : plan.title;
  Section programme{"programme" + suffix, title, true, {}};
  programme.blocks.emplace_back(programme_facts(plan, duration, options));
  if (number == 0) programme.blocks.emplace_back(origin_facts(plan, options));
  programme.blocks.emplace_back(programme_figure(plan, options));
  document.sections.push_back(std::move(programme));
  Section targets{"targets" + suffix, number == 0 ? "Target positions" : "Target positions: " + title, true, {}};
  targets.blocks.emplace_back(target_table(plan, options));
  document.sections.push_back(std::move(targets));
}

/// A plan of other errors than positions, of which the standard says nothing.
Notice status_of_errors(const PlanSubject& subject) {
  const std::string errors = errors_text(subject.plan);
  if (iso230_2::conforming(subject.findings)) return {Tone::good, plain(fmt::format("Plan for {}", errors)), {}};
  return {Tone::bad, plain(fmt::format("Not a plan for {}, see Findings", errors)), {}};
}

Notice status(const PlanSubject& subject) {
  if (!measures_positions(subject.plan)) return status_of_errors(subject);
  if (iso230_2::in_accordance(subject.findings))
    return {Tone::good, plain(fmt::format("Plan according to {}", subject.plan.standard)), {}};
  const bool departs = !iso230_2::conforming(subject.findings);
  Notice notice{Tone::bad, plain(fmt::format("Not a plan according to {}, see Findings", subject.plan.standard)), {}};
  if (!departs)
    notice = {Tone::caution,
              plain(fmt::format("As planned not yet in accordance with {}, see Findings", subject.plan.standard)),
              {}};
  for (const iso230_2::Finding& finding : subject.findings)
    if (finding.severity == (departs ? Severity::departure : Severity::missing) && notice.lines.size() < 3)
      notice.lines.push_back(finding_line(finding));
  return notice;
}

Document title_page(const PlanSubject& subject, const Options& options) {
  const Plan& plan = subject.plan;
  Document document;
  document.kind = "Test plan";
  const std::string_view test = !measures_positions(plan) ? "Test of error motions"
                                : is_diagonal(plan.axis)  ? "Displacement test"
                                                          : "Positioning test";
  document.title = fmt::format("{} of {}", test,
                               plan.axis.name.empty()
                                   ? fmt::format("{} {}", is_diagonal(plan.axis) ? "a" : "an NC", word_for(plan.axis))
                                   : fmt::format("{} {}", word_for(plan.axis), plan.axis.name));
  document.edition = measures_positions(plan) && iso230_2::in_accordance(subject.findings)
                         ? plan.standard
                         : fmt::format("Terms of {}", plan.standard);
  document.identity = {{plain(is_diagonal(plan.axis) ? "Diagonal" : "Axis"), text_cell(description_of(plan.axis))},
                       {plain("Machine"), verbatim_or_quiet(plan.machine)},
                       {plain("Date of plan"), verbatim_or_quiet(plan.date)},
                       {plain("Duration, about"), text_cell(duration_text(subject.duration_in_all))}};
  document.status.push_back(status(subject));
  put_label(document, std::string(cycle_label(plan.cycle)));
  document.running_head = translated(plan.axis.name.empty() ? description_of(plan.axis) : title_of(plan.axis), options);
  if (!plan.machine.empty()) document.running_head += " · " + plan.machine;
  document.running_status = "Test plan · " + document.edition;
  if (!document.label.empty()) document.running_status += " · " + document.label;
  document.date = plan.date;
  return document;
}

}  // namespace

std::string duration_text(Duration duration) {
  const double seconds = duration.in_s();
  if (seconds < 90.0) return fmt::format("{:.0f} s", std::max(1.0, seconds));
  const auto minutes = static_cast<long long>(std::llround(std::min(seconds, 1e15) / 60.0));
  if (minutes < 90) return fmt::format("{} min", minutes);
  return fmt::format("{} h {} min", minutes / 60, minutes % 60);
}

Document plan_sheet(const PlanSubject& subject, const Options& options) {
  Document document = title_page(subject, options);
  append_programme(document, subject.plan, subject.duration, 0, options);
  for (std::size_t k = 0; k < subject.plan.further.size(); ++k)
    append_programme(document, subject.plan.further[k], iso230_2::estimated_duration(subject.plan.further[k]), k + 1,
                     options);
  document.sections.push_back(plan_finding_section(subject.findings));
  document.sections.push_back(checklist(subject.plan));
  return document;
}

}  // namespace axiometry::report
