// SPDX-License-Identifier: Apache-2.0
#include <string>
#include <vector>

#include "axiometry/app/compare_rules/compare_rules.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/formats/test/metadata_json.h"
#include "axiometry/language/language.h"
#include "axiometry/report/rules.h"

namespace axiometry::app {
namespace {

using json::Value;

/// Spells a comparison: as files have it, or for a reader, in whose language texts then are.
class RulesSpelt {
 public:
  RulesSpelt(const ComparedRules& compared, const Reader* reader) : compared_(compared), reader_(reader) {}

  Value object() const {
    const AxisKind kind = compared_.test.metadata.axis.kind;
    const iso230_2::Assessment& assessment = compared_.comparison.iso230_2;
    Value axis = Value::object();
    axis.add("name", compared_.test.metadata.axis.name);
    axis.add("kind", axis_kind_name(kind));
    Value object = Value::object();
    object.add("standard", iso230_2::edition);
    object.add("result", "rules-compared");
    object.add("axis", std::move(axis));
    object.add("unit", deviation_unit_key(kind));
    object.add("conforming", assessment.conforming());
    if (!assessment.label.empty()) object.add("label", said(assessment.label));
    object.add("parameters", parameters_to_json(assessment.evaluation.parameters));
    Value& rules = object.add("rules", Value::array());
    for (const auto& rule : compared_.comparison.rules) rules.push(rule_value(rule));
    Value& remarks = object.add("remarks", Value::array());
    remarks.push(said(standards::no_conformity_stated));
    remarks.push(said(standards::uncertainty_statement(compared_.comparison)));
    object.add("uncertainty", uncertainty_value());
    object.add("warnings", findings_value(compared_.comparison.warnings));
    object.add("findings", findings_value(compared_.comparison.findings));
    return object;
  }

 private:
  std::string said(std::string_view english) const {
    return reader_ == nullptr ? std::string(english)
                              : language::translated(english, reader_->language, reader_->numbers);
  }
  Value said_or_null(std::string_view english) const { return english.empty() ? Value() : Value(said(english)); }

  Value findings_value(std::vector<iso230_2::Finding> findings) const {
    for (auto& finding : findings) finding.message = said(finding.message);
    return findings_to_json(findings);
  }

  /// Of the trials behind the intervals; null without.
  Value uncertainty_value() const {
    const auto& trials = compared_.comparison.trials;
    if (!trials) return {};
    Value object = Value::object();
    object.add("method", "monte-carlo");
    object.add("measurand", iso230_2::measurand_key(trials->measurand));
    object.add("coverage", trials->coverage);
    object.add("trials", trials->trials);
    object.add("seed", seed_to_json(trials->seed));
    object.add("stable", trials->stable);
    Value& notes = object.add("notes", Value::array());
    for (const std::string& note : trials->notes) notes.push(said(note));
    return object;
  }

  static Value interval_value(const std::optional<standards::FigureInterval>& interval) {
    if (!interval) return {};
    Value object = Value::object();
    object.add("low", interval->low.in_native());
    object.add("high", interval->high.in_native());
    object.add("u", interval->u.in_native());
    object.add("stable", interval->stable);
    return object;
  }

  Value rule_value(const standards::ComparedRule& compared) const {
    Value object = Value::object();
    object.add("id", compared.rule->id);
    object.add("name", compared.rule->name);
    object.add("remark", said(compared.rule->remark));
    std::vector<report::RuleRow> shown;
    if (reader_ != nullptr) {
      report::Options options;
      options.language = reader_->language;
      options.numbers = reader_->numbers;
      shown = report::rule_rows(compared, compared_.comparison, options);
    }
    Value& figures = object.add("figures", Value::array());
    for (std::size_t k = 0; k < compared.figures.size(); ++k) {
      Value& figure = figures.push(figure_value(compared.figures[k]));
      if (reader_ != nullptr) figure.add("shown", shown_value(shown[k]));
    }
    return object;
  }

  Value figure_value(const standards::ComparedFigure& compared) const {
    const standards::RuleFigure& figure = *compared.figure;
    Value object = Value::object();
    object.add("key", figure.key);
    object.add("symbol", figure.symbol.empty() ? Value() : Value(figure.symbol));
    object.add("title", said(figure.title));
    object.add("clause", said_or_null(figure.clause));
    object.add("value", number_or_null(compared.value));
    object.add("absent_because", said_or_null(compared.absence));
    object.add("interval", interval_value(compared.interval));
    object.add("no_interval_because", said_or_null(compared.no_interval_because));
    object.add("share_of_travel", number_or_null(compared.share_of_travel));
    object.add("evidence", standards::evidence_key(figure.evidence));
    object.add("evidence_text", said(standards::evidence_words(figure.evidence)));
    object.add("checked_against_text", figure.evidence == standards::Evidence::text);
    const bool beside = compared.counterpart != nullptr;
    object.add("beside", beside ? Value(compared.counterpart->key) : Value());
    object.add("beside_value", number_or_null(compared.counterpart_value));
    object.add("difference", number_or_null(compared.difference()));
    object.add("relative_difference", number_or_null(compared.relative_difference()));
    object.add("departs_by", said_or_null(figure.departs_by));
    return object;
  }

  /// Empty texts where there is nothing.
  Value shown_value(const report::RuleRow& row) const {
    Value object = Value::object();
    object.add("value", row.value);
    object.add("interval", row.interval.empty() ? std::string() : said(row.interval));
    object.add("share_of_travel", row.share_of_travel);
    object.add("beside_value", row.counterpart_value);
    object.add("difference", row.difference);
    object.add("relative_difference", row.relative);
    return object;
  }

  const ComparedRules& compared_;
  const Reader* reader_;
};

}  // namespace

json::Value to_json(const ComparedRules& compared) {
  const Metadata& metadata = compared.test.metadata;
  Value metadata_object = Value::object();
  formats::add_metadata(metadata_object, metadata);
  Value object = RulesSpelt(compared, nullptr).object();
  object.add("metadata", std::move(metadata_object));
  object.add("source", source_to_json(compared.test.provenance));
  object.add("program", program_to_json());
  return object;
}

json::Value to_json(const ComparedRules& compared, const Reader& reader) {
  return RulesSpelt(compared, &reader).object();
}

}  // namespace axiometry::app
