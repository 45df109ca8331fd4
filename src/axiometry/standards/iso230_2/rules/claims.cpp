// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/says_nothing.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/fields.h"
#include "axiometry/model/simulated.h"
#include "axiometry/model/swapped_labels.h"
#include "axiometry/standards/environment/environment.h"
#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"
#include "axiometry/standards/iso230_2/severity_order.h"
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"
#include "axiometry/standards/readings/reading_correction.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::iso230_2 {
namespace {

using rules::Case;
using Against = std::vector<Finding>;

/// Where a rule finds what was not stated; its notes and departures are looked for elsewhere.
void add_missing(Against& against, std::optional<Finding> finding) {
  if (finding && finding->severity == Severity::missing) against.push_back(*std::move(finding));
}

/// The same of a rule whose finding may stand among those of the assessment, which then need not be made again.
void add_missing(Against& against, const Assessment& assessment, std::string_view id, rules::Rule* rule,
                 const Case& c) {
  const auto made = std::ranges::find(assessment.findings, id, &Finding::id);
  add_missing(against, made != assessment.findings.end() ? *made : rule(c));
}

void add_unless_given(Against& against, const char* clause, std::string_view key, const Metadata& metadata) {
  const Field* field = find_field(key);
  AXIOMETRY_CONTRACT(field != nullptr);
  if (!rules::is_stated(*field, metadata))
    against.push_back(
        rules::missing("item-not-stated", clause, rules::within_sentence(field->title) + " is not stated"));
}

// Clause 3

/// Readers say so of files that hold no approaches but what was made of them.
bool holds_no_approaches(const SourceRemark& remark) {
  return remark.departs && (remark.message.contains("expected single approaches") ||
                            remark.message.contains("expected measured approaches"));
}

/// Where evaluate() puts 0 in the place of a term, R and A are lower bounds and not those of 3.22 and 3.27.
bool stands_zero_for_a_term(const Evaluation& evaluation) {
  const AxisParameters& p = evaluation.parameters;
  return std::ranges::any_of(evaluation.positions, [&](const PositionResult& at) {
    const bool up = p.R_up && at.mean_up && !at.s_up;
    const bool down = p.R_down && at.mean_down && !at.s_down;
    const bool reversal = p.R && !at.reversal;
    return up || down || reversal;
  });
}

Against against_computed(const Test& test, const Assessment& assessment) {
  Against against;
  for (const SourceRemark& remark : test.provenance.remarks)
    if (holds_no_approaches(remark))
      against.push_back({"source-remark", source_clause, Severity::departure, remark.message});
  if (stands_zero_for_a_term(assessment.evaluation))
    against.push_back(
        rules::departure("zero-for-a-term", "3.18",
                         "found targets without s_i or B_i where others have it: 0 stands for them, and R "
                         "and A are lower bounds"));
  if (test.metadata.conditions.cycle == TestCycle::step)
    against.push_back(
        rules::departure("step-cycle", "Annex B",
                         "found the step cycle, whose results may not be published with reference to the standard"));
  return against;
}

// Clauses 4 and 5

bool any_temperature(const Environment& environment) {
  const bool sensor =
      std::ranges::any_of(environment.sensors, [](const TemperatureSensor& s) { return s.start.has_value() && s.end; });
  return sensor || (environment.air_temperature_start && environment.air_temperature_end);
}

/// What was agreed on the surroundings, and of which nobody can say that it was kept.
bool is_open_of_surroundings(const Finding& finding) {
  return finding.severity == Severity::missing && finding.id.starts_with("environment");
}

void add_temperatures(Against& against, const Case& c, const Assessment& assessment) {
  const Metadata& m = c.metadata;
  const bool stated = any_temperature(m.environment);
  // Of a log only who corrected the expansion needs no number here: what 26 °C do to an axis is judged by what is
  // stated.
  const bool settled = assessment.temperatures_recorded && (!c.linear() || m.nde.applied == true);
  if (!stated && !settled)
    against.push_back(rules::missing(
        "temperatures-not-stated", "4.1",
        assessment.temperatures_recorded
            ? "temperatures at the start and the end of the test are in the log alone, expected them stated too where "
              "nobody says that differential expansion was corrected: its size is judged by them"
            : "temperatures at the start and the end of the test are not stated"));
  if (!c.linear()) return;
  add_missing(against, rules::temperature_without_correction(c));
  if (!m.nde.applied && !stated)
    against.push_back(rules::missing("temperature-correction-not-stated", "4.1",
                                     "whether differential expansion was corrected is not stated"));
  if (m.nde.applied != true) return;
  add_unless_given(against, "5.3.1", "nde.machine_expansion_um_per_m_C", m);
  add_unless_given(against, "5.3.1", "nde.routine", m);
  add_unless_given(against, "5.3.1", "sensors", m);
  add_missing(against, rules::sensors_complete(c));
}

void add_targets(Against& against, const Case& c) {
  const Axis& axis = c.metadata.axis;
  std::ranges::move(rules::unexplained(c), std::back_inserter(against));
  if (may_be_compensated(axis) && axis.compensation_points.empty() &&
      rules::may_serve_acceptance(c.metadata.conditions.purpose))
    against.push_back(rules::missing("sampling-points-not-stated", "5.2",
                                     "sampling points of the compensation are not stated, so that nobody can tell "
                                     "whether targets lie on them"));
}

constexpr std::pair<const char*, std::string_view> items_of_the_test[] = {{"4.2", "test.axes_not_under_test"},
                                                                          {"4.2", "axis.compensation"},
                                                                          {"4.3", "test.warm_up"},
                                                                          {"5.1", "test.feed"},
                                                                          {"5.1", "test.dwell_s"},
                                                                          {"5.3.1", "axis.measurement_line"}};

/// Statements that no test can be made with.
void add_impossible(Against& against, const Metadata& m) {
  const TestConditions& of_test = m.conditions;
  if (of_test.feed && !(*of_test.feed > 0.0))
    against.push_back(
        rules::missing("feed-of-zero", "5.1", "found a feed of 0, expected the one that the axis was driven with"));
  if (of_test.dwell && !(of_test.dwell->in_s() > 0.0))
    against.push_back(
        rules::missing("dwell-of-zero", "5.1", "found a dwell of 0 s, expected the axis at rest while it is read"));
  if (text::says_no_warm_up(of_test.warm_up))
    against.push_back(rules::missing("warm-up-not-made", "4.3",
                                     "a warm-up is stated not to have been made; whether that was agreed is not"));
}

/// Readings that a test in accordance with the standard can have, though hardly has: whether the machine was warm, and
/// the readings those of several runs, only who tested can tell.
void add_doubts(Against& against, const Case& c, const Assessment& assessment) {
  const auto ask = [&](std::optional<Finding> finding) {
    if (!finding) return;
    finding->severity = Severity::missing;
    against.push_back(*std::move(finding));
  };
  ask(rules::part_of_axis_travel(c));
  ask(rules::readings_beyond_errors(c));
  ask(rules::readings_repeat_exactly(c));
  ask(rules::readings_copied(c));
  ask(rules::runs_left_out(c));
  ask(rules::runs_in_blocks(c));
  ask(assessment.progression);
  if (!assessment.temperatures_recorded) ask(rules::temperature_change(c));  // a log has findings of its own
  ask(rules::air_pressure_unlikely(c));
  ask(rules::impossible_date(c));
}

}  // namespace

std::vector<Finding> errors_known_of(const Test& test, const Assessment& assessment) {
  std::vector<Finding> against;
  if (auto why = simulated_by_purpose(test.metadata.conditions.purpose))
    against.push_back(rules::missing("simulated", "1", *std::move(why)));
  if (has_swapped_labels(test))
    against.push_back(rules::missing("source-remark", source_clause, std::string(swapped_labels)));
  if (was_corrected(test, "drift"))
    against.push_back(rules::missing(
        "drift-taken-out", "5.3.1",
        "found readings from which a drift was taken, of which nobody can tell that the machine had no part in it"));
  for (const UncorrectedEffect& effect : assessment.uncorrected)
    against.push_back(rules::missing("uncorrected-effect", "4.1", effect.reason()));
  return against;
}

namespace {

Against against_tested(const Case& c, const Test& test, const Assessment& assessment) {
  Against against;
  against.reserve(std::size(items_of_the_test) + 4);  // of a test of which nothing is stated
  if (is_diagonal(c.metadata.axis))
    against.push_back(rules::missing(
        "diagonal-line", "1",
        "found several axes moving at once, which is no test of a single axis; the text of ISO 230-6 was not at hand"));
  std::ranges::copy_if(assessment.findings, std::back_inserter(against), [](const Finding& finding) {
    return finding.severity == Severity::departure || is_open_of_surroundings(finding);
  });
  add_targets(against, c);
  add_temperatures(against, c, assessment);
  for (const auto& [clause, key] : items_of_the_test) add_unless_given(against, clause, key, c.metadata);
  add_impossible(against, c.metadata);
  add_doubts(against, c, assessment);
  std::ranges::move(errors_known_of(test, assessment), std::back_inserter(against));
  const std::string& artefact = c.metadata.artefact.type;
  const bool by_artefact = !text::says_nothing(artefact) && !text::says_none(artefact);
  if (!by_artefact) add_unless_given(against, "5.3.1", "equipment", c.metadata);
  return against;
}

// Clause 8

/// The parameters that 8.2.2 or 8.2.3 lists and this test does not have.
std::optional<Finding> parameters_missing(const Case& c) {
  const bool repeated = required_approaches(c.programme) > 1;
  std::vector<std::string_view> absent;
  for (const ParameterInfo& parameter : parameters) {
    const bool rests_on_s = parameter.symbol.starts_with('A') || parameter.symbol.starts_with('R');
    if ((repeated || !rests_on_s) && !(c.evaluation.parameters.*parameter.member)) absent.push_back(parameter.symbol);
  }
  if (absent.empty()) return std::nullopt;
  return rules::missing("parameters-missing", repeated ? "8.2.2" : "8.2.3",
                        fmt::format("no value of the listed parameters {}", fmt::join(absent, ", ")));
}

/// What has a value and no uncertainty of record.
std::optional<Finding> uncertainty_of_record_missing(const Assessment& assessment) {
  if (!method_of_record(assessment)) return std::nullopt;
  std::vector<std::string_view> without;
  for (const ParameterInfo& parameter : parameters)
    if (assessment.evaluation.parameters.*parameter.member && !uncertainty_of_record(assessment, parameter))
      without.push_back(parameter.symbol);
  if (without.empty()) return std::nullopt;
  return rules::missing("uncertainty-of-record-missing", "8.2.1",
                        fmt::format("no uncertainty is stated of {}", fmt::join(without, ", ")));
}

Against against_reported(const Case& c, const Assessment& assessment) {
  Against against;
  add_missing(against, rules::impossible_date(c));
  add_missing(against, rules::date_not_read(c));
  add_missing(against, assessment, "items-of-identification", rules::items_of_identification, c);
  add_missing(against, rules::equipment_identified(c));
  add_missing(against, rules::calibration_date_not_read(c));
  if (auto outdated = rules::equipment_calibrated(c)) {  // no certificate of the day is stated on which U could rest
    outdated->severity = Severity::missing;
    against.push_back(*std::move(outdated));
  }
  add_missing(against, rules::sensors_complete(c));
  add_missing(against, rules::line_in_space(c));
  add_missing(against, parameters_missing(c));
  add_missing(against, assessment, "uncertainty-stated", rules::uncertainty_stated, c);
  add_missing(against, rules::uncertainty_of_zero(c));
  add_missing(against, uncertainty_of_record_missing(assessment));
  add_missing(against, rules::station_stated(c));
  return against;
}

std::string title_of_claim(ClaimKind kind, const Axis& axis) {
  switch (kind) {
    case ClaimKind::computed: return fmt::format("Computed after clause 3 of {}", edition);
    case ClaimKind::tested:
      return fmt::format("Tested in accordance with {}", is_diagonal(axis) ? standard_of(axis) : edition);
    case ClaimKind::reported: return fmt::format("Report complete after clause 8 of {}", edition);
  }
  return "";
}

Claim made(ClaimKind kind, const Axis& axis, Against against) {
  sort_by_severity(against);
  return {kind, title_of_claim(kind, axis), std::move(against)};
}

std::string_view word_on_all(const TestEnvironment* surroundings) {
  const bool soaked = surroundings != nullptr && surroundings->soaked_h && *surroundings->soaked_h > 0.0;
  const EnvironmentItem* gradient = nullptr;
  if (surroundings != nullptr)
    for (const EnvironmentItem& item : surroundings->items)
      if (item.key == "machine_gradient_C" && item.standing == EnvironmentStanding::kept) gradient = &item;
  if (gradient != nullptr && !gradient->stated)
    return soaked ? "on the word of who tested, since no item of a test states it: the standard test cycle was run "
                    "where no other is given, the machine complete, levelled and without load (4.2), and at rest when "
                    "it was read (5.1); the log of temperatures shows their gradient over the machine within what was "
                    "agreed, and how long machine and instrument were soaked is stated (4.1)"
                  : "on the word of who tested, since no item of a test states it: the standard test cycle was run "
                    "where no other is given, machine and instrument were soaked (4.1), the machine complete, levelled "
                    "and without load (4.2), and at rest when it was read (5.1); the log of temperatures shows their "
                    "gradient over the machine within what was agreed (4.1)";
  if (gradient != nullptr)
    return soaked ? "on the word of who tested, since no item of a test states it: the standard test cycle was run "
                    "where no other is given, the machine complete, levelled and without load (4.2), and at rest when "
                    "it was read (5.1); the gradient over the machine, within what was agreed, and how long machine "
                    "and instrument were soaked are stated (4.1)"
                  : "on the word of who tested, since no item of a test states it: the standard test cycle was run "
                    "where no other is given, machine and instrument were soaked (4.1), the machine complete, levelled "
                    "and without load (4.2), and at rest when it was read (5.1); the gradient over the machine is "
                    "stated, within what was agreed (4.1)";
  return soaked ? "on the word of who tested, since no item of a test states it: the standard test cycle was run "
                  "where no other is given, the gradient of the temperature was within what was agreed (4.1), the "
                  "machine complete, levelled and without load (4.2), and at rest when it was read (5.1); how long "
                  "machine and instrument were soaked is stated (4.1)"
                : "on the word of who tested, since no item of a test states it: the standard test cycle was run "
                  "where no other is given, machine and instrument were soaked and the gradient of the temperature "
                  "within what was agreed (4.1), the machine complete, levelled and without load (4.2), and at rest "
                  "when it was read (5.1)";
}

}  // namespace

std::string_view claim_key(ClaimKind kind) {
  switch (kind) {
    case ClaimKind::computed: return "computed";
    case ClaimKind::tested: return "tested";
    case ClaimKind::reported: return "reported";
  }
  return "";
}

Claims claims_of(const Test& test, const Assessment& assessment) {
  const Axis& axis = test.metadata.axis;
  const Case c = rules::make_case(test.metadata, test.series, assessment.evaluation, assessment.annex_a);
  return {made(ClaimKind::computed, axis, against_computed(test, assessment)),
          made(ClaimKind::tested, axis, against_tested(c, test, assessment)),
          made(ClaimKind::reported, axis, against_reported(c, assessment))};
}

std::string against_text(const Claim& claim) {
  const auto departures = std::ranges::count(claim.against, Severity::departure, &Finding::severity);
  const auto missing = static_cast<std::ptrdiff_t>(claim.against.size()) - departures;
  const auto points = [](std::ptrdiff_t n) { return n == 1 ? "1 point" : fmt::format("{} points", n); };
  std::string text;
  if (departures > 0) text = fmt::format("contradicted by {}", points(departures));
  if (missing > 0) text += fmt::format("{}{} open", text.empty() ? "" : ", ", points(missing));
  return text;
}

namespace {

std::string word_on_cycle_and_machine(const TestEnvironment* surroundings, bool both_directions) {
  constexpr std::string_view cycle = "the standard test cycle was run where no other is given, ";
  std::string word(word_on_all(surroundings));
  if (both_directions) return word;
  const std::size_t at = word.find(cycle);
  AXIOMETRY_CONTRACT(at != word.npos);
  word.erase(at, cycle.size());
  constexpr std::string_view machine = "the machine ";
  if (word.substr(at).starts_with(machine)) word.insert(at + machine.size(), "was ");
  return word;
}

}  // namespace

std::string word_of_the_tester(const Test& test, const TestEnvironment* surroundings) {
  std::string word = word_on_cycle_and_machine(surroundings, test.series.has_both_directions());
  if (axis_ends(test.metadata.axis).length_native()) return word;
  return fmt::format(
      "{}; and, since the ends of the axis travel are not stated, that as much of it was measured as was agreed (3.2)",
      word);
}

}  // namespace axiometry::iso230_2
