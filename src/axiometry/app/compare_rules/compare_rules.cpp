// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compare_rules/compare_rules.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/app/files/output.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/rules.h"
#include "axiometry/standards/rules/rule_trials.h"

namespace axiometry::app {

Result<std::vector<const standards::AxisRule*>> named_rules(std::span<const std::string> ids) {
  std::vector<const standards::AxisRule*> rules;
  for (const std::string& id : ids) {
    AXIOMETRY_TRY(const standards::AxisRule* rule, standards::rule_named(id));
    if (std::ranges::find(rules, rule) != rules.end())
      return fail(fmt::format("found {} twice, expected each rule once", text::quoted(id)));
    rules.push_back(rule);
  }
  return rules;
}

Result<ComparedRules> compare_rules_of(Test test, std::span<const standards::AxisRule* const> rules,
                                       const UncertaintyOptions& uncertainty) {
  AXIOMETRY_TRY(standards::RuleComparison comparison, standards::compare_rules(test, rules));
  if (uncertainty.monte_carlo) AXIOMETRY_TRY_VOID(standards::add_intervals(comparison, test, uncertainty.trials));
  return ComparedRules{std::move(test), std::move(comparison)};
}

Result<ComparedRules> compare_rules_of(const std::string& file, const EvaluateOptions& reading,
                                       std::span<const standards::AxisRule* const> rules) {
  AXIOMETRY_TRY(Test measured, read_test(file, reading.format));
  const auto compare = [&]() -> Result<ComparedRules> {
    AXIOMETRY_TRY(Test test, prepare_test(std::move(measured), reading));
    return compare_rules_of(std::move(test), rules, reading.uncertainty);
  };
  auto compared = compare();
  if (!compared && compared.error().file.empty()) compared.error().file = file == "-" ? "(standard input)" : file;
  return compared;
}

Result<void> write_outputs(const ComparedRules& compared, const OutputNames& names, const report::Options& options) {
  AXIOMETRY_TRY_VOID(check_inputs_spared(names));
  if (!names.reports.empty()) {
    const report::Document document = report::compose({compared.test, compared.comparison}, options);
    AXIOMETRY_TRY_VOID(write_document(document, names.reports, options));
  }
  if (!names.json.empty()) AXIOMETRY_TRY_VOID(write_file(names.json, json::dump(to_json(compared)) + "\n"));
  return {};
}

}  // namespace axiometry::app
