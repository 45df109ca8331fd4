// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/requirements.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "axiometry/base/text/number_text.h"

namespace axiometry::app {
namespace {

using iso230_2::AxisParameters;
using iso230_2::Finding;
using iso230_2::merged_limits;
using iso230_2::ParameterInfo;
using iso230_2::Severity;
using iso230_2::Tolerance;
using iso230_2::ToleranceSource;

/// Why a series lacks a parameter that others have.
std::string reason_for_absence(const Series& series, const ParameterInfo& parameter) {
  const bool up = series.has(Direction::up);
  const bool down = series.has(Direction::down);
  const bool of_up = parameter.symbol.ends_with("↑");
  const bool of_down = parameter.symbol.ends_with("↓");
  const bool lacks_direction = of_up ? !up : of_down ? !down : !(up && down);
  if (lacks_direction)
    return fmt::format("approaches from {} only ({})", up ? "below (↑)" : "above (↓)", parameter.clause);
  const bool repeated = series.run_count() > 1;
  return repeated ? fmt::format("no target with the approaches it needs ({})", parameter.clause)
                  : "a single approach to each target per direction (6.2)";
}

/// A limit that a user sets by hand for one test is meant for what that test has.
Result<void> check_existence(const std::vector<Tolerance>& tolerances, const Series& series,
                             const AxisParameters& measured) {
  for (const Tolerance& tolerance : tolerances) {
    const ParameterInfo& parameter = *tolerance.parameter;
    if (measured.*parameter.member) continue;
    std::vector<std::string_view> present;
    for (const ParameterInfo& p : iso230_2::parameters)
      if (measured.*p.member) present.push_back(p.key);
    return fail(fmt::format("found a tolerance of {} for a test with {}, where {} does not exist; expected one of {}",
                            parameter.key, reason_for_absence(series, parameter), parameter.key,
                            fmt::join(present, ", ")));
  }
  return {};
}

std::string_view source_words(ToleranceSource source) {
  switch (source) {
    case ToleranceSource::axis: return "of the axis";
    case ToleranceSource::table: return "of the tolerance table";
    case ToleranceSource::test: return "of the test's file";
    case ToleranceSource::entered: return "entered for this test";
    case ToleranceSource::user: return "of the command line";
  }
  return "";
}

/// Whether a person stated an item over what the file says.
bool was_entered(std::string_view key, std::span<const std::pair<std::string, std::string>> entries) {
  return std::ranges::find(entries, key, &std::pair<std::string, std::string>::first) != entries.end();
}

/// The limits of a test's file, and over them those that were entered for it. One that was taken away is told.
std::vector<Tolerance> stated_for(const Metadata& metadata, const Metadata& file,
                                  std::span<const std::pair<std::string, std::string>> entries,
                                  std::vector<Finding>& findings) {
  const std::vector<Tolerance> now = iso230_2::stated_tolerances(metadata);
  std::vector<Tolerance> all, entered;
  for (const Tolerance& of_file : iso230_2::stated_tolerances(file)) {
    const auto kept = std::ranges::find(now, of_file.parameter, &Tolerance::parameter);
    if (kept != now.end() && kept->limit.in_native() != of_file.limit.in_native())
      all.push_back(of_file);
    else if (kept == now.end())
      findings.push_back({"limit-taken-away", "8.2", Severity::note,
                          fmt::format("the limit of {} of the test's file, {} {}, was taken away for this test",
                                      of_file.parameter->key, format_exact(of_file.limit.in_native()),
                                      deviation_unit(metadata.axis.kind))});
  }
  for (Tolerance tolerance : now) {
    const bool by_person = was_entered(fmt::format("tolerance.{}", tolerance.parameter->key), entries);
    if (by_person) tolerance.source = ToleranceSource::entered;
    entered.push_back(std::move(tolerance));
  }
  return merged_limits(std::move(all), entered);
}

std::string rule_phrase(const uncertainty::DecisionRule& rule, AxisKind kind) {
  if (rule.kind != uncertainty::DecisionRule::Kind::guard_band) return std::string(rule.id());
  return fmt::format("{} of {} {}", rule.id(), format_exact(rule.guard_band), deviation_unit(kind));
}

/// The rule that counts, by whom it was stated; of two that differ the one below is told.
class RuleOfRecord {
 public:
  RuleOfRecord(AxisKind kind, std::vector<Finding>& findings) : kind_(kind), findings_(findings) {}

  void take(const uncertainty::DecisionRule& rule, ToleranceSource source) {
    if (source_ && rule_phrase(rule, kind_) != rule_phrase(rule_, kind_))
      findings_.push_back(
          {"decision-rule-replaced", "8.2", Severity::note,
           fmt::format("found two decision rules: {} ({}) takes the place of {} ({})", rule_phrase(rule, kind_),
                       source_words(source), rule_phrase(rule_, kind_), source_words(*source_))});
    rule_ = rule;
    source_ = source;
  }
  const uncertainty::DecisionRule& rule() const { return rule_; }

 private:
  AxisKind kind_;
  std::vector<Finding>& findings_;
  uncertainty::DecisionRule rule_{};
  std::optional<ToleranceSource> source_;
};

/// A limit that another replaces, unless both say the same.
void tell_replaced(std::vector<Finding>& findings, const Tolerance& tolerance, AxisKind kind) {
  for (const iso230_2::ReplacedLimit& replaced : tolerance.replaced) {
    if (replaced.limit.in_native() == tolerance.limit.in_native()) continue;
    const auto size = [&](Deviation limit) {
      return fmt::format("{} {}", format_exact(limit.in_native()), deviation_unit(kind));
    };
    findings.push_back({"limit-replaced", "8.2", Severity::note,
                        fmt::format("found two limits of {}: {} ({}) takes the place of {} ({})",
                                    tolerance.parameter->key, size(tolerance.limit), source_words(tolerance.source),
                                    size(replaced.limit), source_words(replaced.source))});
  }
}

/// A limit that nothing can be held against: the test may not pass for that.
void tell_unjudged(std::vector<Finding>& findings, const Tolerance& tolerance, const Series& series) {
  const ParameterInfo& parameter = *tolerance.parameter;
  findings.push_back(
      {"limit-not-judged", "8.2", Severity::missing,
       fmt::format("found a tolerance of {} ({}) for a test with {}, where {} does not exist: no verdict "
                   "on it, and none that the test conforms",
                   parameter.key, source_words(tolerance.source), reason_for_absence(series, parameter),
                   parameter.key)});
}

/// "Grinder, up to 500 mm, in limits.csv, SHA-256 12ab…": without the folder, which no reader of a report knows.
std::string origin_of(const AppliedBand& band) {
  return fmt::format("{}, {}, in {}, SHA-256 {}", band.name, band.travel,
                     std::filesystem::path(band.file).filename().string(), band.sha256);
}

}  // namespace

Result<Requirements> requirements_for(const Test& test, const AxisParameters& measured, const ToleranceOptions& options,
                                      std::span<const std::pair<std::string, std::string>> entries,
                                      const Metadata* file) {
  const AxisKind kind = test.metadata.axis.kind;
  const Metadata& before = file != nullptr ? *file : test.metadata;
  Requirements all;
  RuleOfRecord rule(kind, all.findings);
  all.tolerances = options.of_axis;
  if (options.table) {
    const std::string& name = options.table_name.empty() ? test.metadata.tolerance.table : options.table_name;
    AXIOMETRY_TRY(const ToleranceBand* band, select_band(*options.table, name, kind, test.series));
    all.band = {options.table->file, options.table->sha256, band->name, band->travel_max, travel_text(*band)};
    std::vector<Tolerance> limits = band->limits;
    for (Tolerance& tolerance : limits) tolerance.origin = origin_of(*all.band);
    all.tolerances = merged_limits(std::move(all.tolerances), limits);
    if (band->rule) {
      AXIOMETRY_TRY(const auto of_band, rule_for(kind, *band->rule));
      rule.take(of_band, ToleranceSource::table);
    }
  }
  all.tolerances = merged_limits(std::move(all.tolerances), stated_for(test.metadata, before, entries, all.findings));
  AXIOMETRY_TRY(const auto of_file, stated_rule(before));
  if (of_file) rule.take(*of_file, ToleranceSource::test);
  AXIOMETRY_TRY(const auto stated, stated_rule(test.metadata));
  if (stated)
    rule.take(*stated, was_entered("tolerance.rule", entries) ? ToleranceSource::entered : ToleranceSource::test);
  AXIOMETRY_TRY(const auto given, tolerances_for(kind, options.limits));
  if (!options.many_tests) AXIOMETRY_TRY_VOID(check_existence(given, test.series, measured));
  all.tolerances = merged_limits(std::move(all.tolerances), given);
  if (options.rule) {
    AXIOMETRY_TRY(const auto of_user, rule_for(kind, *options.rule));
    rule.take(of_user, ToleranceSource::user);
  }
  all.rule = rule.rule();
  std::ranges::sort(all.tolerances, {}, &Tolerance::parameter);
  for (const Tolerance& tolerance : all.tolerances) {
    tell_replaced(all.findings, tolerance, kind);
    if (!(measured.*tolerance.parameter->member)) tell_unjudged(all.findings, tolerance, test.series);
  }
  return all;
}

}  // namespace axiometry::app
