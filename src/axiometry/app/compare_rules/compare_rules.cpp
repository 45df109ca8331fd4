// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compare_rules/compare_rules.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "axiometry/app/files/output.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/test/metadata_json.h"
#include "axiometry/report/rules.h"

namespace axiometry::app {
namespace {

using json::Value;

Value text_or_null(std::string_view text) { return text.empty() ? Value() : Value(text); }

Value figure_to_json(const standards::ComparedFigure& compared) {
  const standards::RuleFigure& figure = *compared.figure;
  Value object = Value::object();
  object.add("key", figure.key);
  object.add("symbol", text_or_null(figure.symbol));
  object.add("title", figure.title);
  object.add("clause", text_or_null(figure.clause));
  object.add("value", number_or_null(compared.value));
  object.add("absent_because", text_or_null(compared.absence));
  object.add("share_of_travel", number_or_null(compared.share_of_travel));
  object.add("evidence", standards::evidence_key(figure.evidence));
  object.add("evidence_text", standards::evidence_words(figure.evidence));
  object.add("checked_against_text", figure.evidence == standards::Evidence::text);
  const bool beside = compared.counterpart != nullptr;
  object.add("beside", beside ? Value(compared.counterpart->key) : Value());
  object.add("beside_value", number_or_null(compared.counterpart_value));
  object.add("difference", number_or_null(compared.difference()));
  object.add("relative_difference", number_or_null(compared.relative_difference()));
  object.add("departs_by", text_or_null(figure.departs_by));
  return object;
}

Value rule_to_json(const standards::ComparedRule& compared) {
  Value object = Value::object();
  object.add("id", compared.rule->id);
  object.add("name", compared.rule->name);
  object.add("remark", compared.rule->remark);
  Value& figures = object.add("figures", Value::array());
  for (const auto& figure : compared.figures) figures.push(figure_to_json(figure));
  return object;
}

}  // namespace

Result<std::vector<const standards::AxisRule*>> named_rules(std::span<const std::string> ids) {
  std::vector<const standards::AxisRule*> rules;
  for (const std::string& id : ids) {
    const standards::AxisRule* rule = standards::find_axis_rule(id);
    if (rule == nullptr) {
      std::vector<std::string_view> known;
      for (const auto* each : standards::axis_rule_table()) known.push_back(each->id);
      return fail(fmt::format("found {}, expected one of {}", text::quoted(id), fmt::join(known, ", ")));
    }
    if (std::ranges::find(rules, rule) != rules.end())
      return fail(fmt::format("found {} twice, expected each rule once", text::quoted(id)));
    rules.push_back(rule);
  }
  return rules;
}

Result<ComparedRules> compare_rules_of(const std::string& file, const EvaluateOptions& reading,
                                       std::span<const standards::AxisRule* const> rules) {
  AXIOMETRY_TRY(Test measured, read_test(file, reading.format));
  const auto compare = [&]() -> Result<ComparedRules> {
    AXIOMETRY_TRY(Test test, prepare_test(std::move(measured), reading));
    AXIOMETRY_TRY(standards::RuleComparison comparison, standards::compare_rules(test, rules));
    return ComparedRules{std::move(test), std::move(comparison)};
  };
  auto compared = compare();
  if (!compared && compared.error().file.empty()) compared.error().file = file == "-" ? "(standard input)" : file;
  return compared;
}

json::Value to_json(const ComparedRules& compared) {
  const Metadata& metadata = compared.test.metadata;
  const iso230_2::Assessment& assessment = compared.comparison.iso230_2;
  Value axis = Value::object();
  axis.add("name", metadata.axis.name);
  axis.add("kind", axis_kind_name(metadata.axis.kind));
  Value metadata_object = Value::object();
  formats::add_metadata(metadata_object, metadata);
  Value rules = Value::array();
  for (const auto& rule : compared.comparison.rules) rules.push(rule_to_json(rule));

  Value object = Value::object();
  object.add("standard", iso230_2::edition);
  object.add("result", "rules-compared");
  object.add("axis", std::move(axis));
  object.add("unit", deviation_unit_key(metadata.axis.kind));
  object.add("conforming", assessment.conforming());
  if (!assessment.label.empty()) object.add("label", assessment.label);
  object.add("parameters", parameters_to_json(assessment.evaluation.parameters));
  object.add("rules", std::move(rules));
  Value& remarks = object.add("remarks", Value::array());
  remarks.push(standards::no_conformity_stated);
  remarks.push(standards::no_uncertainty_stated);
  object.add("warnings", findings_to_json(compared.comparison.warnings));
  object.add("findings", findings_to_json(compared.comparison.findings));
  object.add("metadata", std::move(metadata_object));
  object.add("source", source_to_json(compared.test.provenance));
  object.add("program", program_to_json());
  return object;
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
