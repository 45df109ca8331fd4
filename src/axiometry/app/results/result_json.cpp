// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/result_json.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "axiometry/app/results/corrections_json.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/app/temperatures/temperatures.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/base/version.h"
#include "axiometry/formats/test/metadata_json.h"
#include "axiometry/standards/iso230_2/error_symbol.h"
#include "axiometry/standards/iso230_2/information.h"
#include "axiometry/standards/iso230_2/rules/claims.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::app {
namespace {

using json::Value;

Value position_result_to_json(const iso230_2::PositionResult& p) {
  Value object = Value::object();
  object.add("target", p.target.in_native());
  object.add("n_up", p.count_up);
  object.add("n_down", p.count_down);
  for (const auto& quantity : iso230_2::position_quantities)
    object.add(quantity.key, number_or_null(p.*quantity.member));
  return object;
}

Value judgement_to_json(const iso230_2::Judgement& judgement) {
  Value row = Value::object();
  row.add("parameter", judgement.tolerance.parameter->key);
  row.add("limit", judgement.tolerance.limit.in_native());
  row.add("source", iso230_2::tolerance_source_key(judgement.tolerance.source));
  row.add("verdict", uncertainty::verdict_name(judgement.decision.verdict));
  row.add("rule", judgement.rule.id());
  Value& replaced = row.add("replaced", Value::array());
  for (const iso230_2::ReplacedLimit& other : judgement.tolerance.replaced) {
    Value& limit = replaced.push(Value::object());
    limit.add("limit", other.limit.in_native());
    limit.add("source", iso230_2::tolerance_source_key(other.source));
  }
  row.add("withheld", judgement.withheld.empty() ? Value() : Value(judgement.withheld));
  const auto& known = judgement.uncertainty;
  row.add("u", known ? Value(known->u.in_native()) : Value());
  row.add("u_degrees_of_freedom", known ? number_or_null(known->degrees_of_freedom) : Value());
  row.add("u_method", known ? Value(iso230_2::method_key(known->method)) : Value());
  row.add("u_measurand", known && known->measurand ? Value(iso230_2::measurand_key(*known->measurand)) : Value());
  const bool judged = judgement.decision.verdict != uncertainty::Verdict::not_applicable;
  row.add("guard_band", judged && judgement.has_guard_band() ? Value(judgement.decision.guard_band) : Value());
  row.add("rejection_band", judged && judgement.has_guard_band() ? Value(judgement.decision.rejection_band) : Value());
  row.add("acceptance_limit", number_or_null(judged ? judgement.acceptance_limit() : std::nullopt));
  row.add("rejection_limit", number_or_null(judged ? judgement.rejection_limit() : std::nullopt));
  row.add("probability_conforming", number_or_null(judgement.decision.probability_conforming));
  const auto& range = judgement.decision.probability_range;
  row.add("probability_least", range ? Value(range->least) : Value());
  row.add("probability_most", range ? Value(range->most) : Value());
  row.add("consumer_risk", number_or_null(judgement.decision.consumer_risk));
  row.add("producer_risk", number_or_null(judgement.decision.producer_risk));
  return row;
}

/// "verdict", "tolerances" and, when a table was used, which row of it.
void add_conformity(Value& object, const Evaluated& evaluated) {
  const auto verdict = iso230_2::overall_verdict(evaluated.judgements);
  if (!verdict) return;
  object.add("verdict", uncertainty::verdict_name(*verdict));
  Value& list = object.add("tolerances", Value::array());
  for (const auto& judgement : evaluated.judgements) list.push(judgement_to_json(judgement));
  if (!evaluated.tolerance_band) return;
  const AppliedBand& band = *evaluated.tolerance_band;
  Value& table = object.add("tolerance_table", Value::object());
  table.add("file", band.file);
  table.add("sha256", band.sha256);
  table.add("name", band.name);
  table.add("travel_up_to", band.travel_max ? Value(band.travel_max->in_native()) : Value());
}

json::Value claims_to_json(const iso230_2::Claims& claims, const iso230_2::TestEnvironment* logged) {
  Value list = Value::array();
  for (const iso230_2::Claim& claim : claims) {
    Value& row = list.push(Value::object());
    row.add("key", iso230_2::claim_key(claim.kind));
    row.add("title", claim.title);
    row.add("holds", claim.holds());
    row.add("missing", findings_to_json(claim.against));
    if (claim.kind == iso230_2::ClaimKind::tested) row.add("remark", iso230_2::word_of_the_tester(logged));
  }
  return list;
}

/// What is told for information and never judged; nothing when nothing was asked for.
void add_information(Value& object, const Test& test, const iso230_2::AxisParameters& parameters) {
  const auto smaller = iso230_2::smaller_repeatability(test.metadata, parameters);
  if (!smaller) return;
  Value& row = object.add("information", Value::object()).add("smaller_repeatability", Value::object());
  row.add("value", smaller->value.in_native());
  row.add("of", smaller->parameter->key);
  row.add("remark", iso230_2::smaller_repeatability_remark);
}

/// With the axis (8.2.4), of the parameters that exist; nothing where the axis has no symbol.
void add_symbols(Value& object, const Evaluated& evaluated) {
  const Axis& axis = evaluated.test.metadata.axis;
  if (iso230_2::error_symbol(axis).empty()) return;
  Value& symbols = object.add("symbols", Value::object());
  for (const auto& p : iso230_2::parameters)
    if (evaluated.assessment.evaluation.parameters.*p.member) symbols.add(p.key, iso230_2::error_symbol(axis, p));
}

std::string csv_text(std::string_view s) { return text::csv_cell(text::no_formula(s)); }

void append_parameters(std::string& row, const iso230_2::AxisParameters* parameters) {
  for (const auto& p : iso230_2::parameters) {
    row += ',';
    if (parameters && parameters->*p.member) row += format_exact((parameters->*p.member)->in_native());
  }
}

/// U of record; the Monte Carlo method has columns of its own for its intervals.
void append_uncertainties(std::string& row, const iso230_2::Assessment& assessment) {
  for (const auto& p : iso230_2::parameters) {
    row += ',';
    const auto known = iso230_2::uncertainty_of_record(assessment, p);
    if (known && known->U) row += format_exact(known->U->in_native());
  }
}

/// "annex-a", the word of `uncertainty.method`; empty where nothing was estimated.
std::string_view word_of_record(const iso230_2::Assessment& assessment) {
  const auto method = iso230_2::method_of_record(assessment);
  return method ? iso230_2::method_word(*method) : "";
}

/// Keys of the parameters with this verdict, separated by blanks.
std::string keys_with(const std::vector<iso230_2::Judgement>& judgements, uncertainty::Verdict verdict) {
  std::string keys;
  for (const auto& judgement : judgements)
    if (judgement.decision.verdict == verdict)
      keys.append(keys.empty() ? "" : " ").append(judgement.tolerance.parameter->key);
  return keys;
}

std::string verdict_cells(const std::vector<iso230_2::Judgement>& judgements) {
  const auto verdict = iso230_2::overall_verdict(judgements);
  return fmt::format(",{},{},{}", verdict ? uncertainty::verdict_name(*verdict) : "",
                     keys_with(judgements, uncertainty::Verdict::does_not_conform),
                     keys_with(judgements, uncertainty::Verdict::undecided));
}

std::string claim_cells(const iso230_2::Claims& claims) {
  std::string cells;
  for (const iso230_2::Claim& claim : claims) cells += claim.holds() ? ",yes" : ",no";
  return cells;
}

}  // namespace

json::Value findings_to_json(std::span<const iso230_2::Finding> findings) {
  Value list = Value::array();
  for (const auto& finding : findings) {
    Value& row = list.push(Value::object());
    row.add("id", finding.id);
    row.add("clause", finding.clause);
    row.add("severity", iso230_2::severity_name(finding.severity));
    row.add("message", finding.message);
  }
  return list;
}

json::Value source_to_json(const Provenance& provenance, const std::string& test_name) {
  Value object = Value::object();
  object.add("file", provenance.file);
  if (!test_name.empty()) object.add("test", test_name);
  object.add("sha256", provenance.sha256.empty() ? Value() : Value(provenance.sha256));
  object.add("format", provenance.format);
  return object;
}

json::Value program_to_json() {
  Value object = Value::object();
  object.add("name", "axiometry");
  object.add("version", version);
  return object;
}

json::Value to_json(const Evaluated& evaluated) {
  const Metadata& metadata = evaluated.test.metadata;
  Value axis = Value::object();
  axis.add("name", metadata.axis.name);
  axis.add("kind", axis_kind_name(metadata.axis.kind));
  Value metadata_object = Value::object();
  formats::add_metadata(metadata_object, metadata);
  Value positions = Value::array();
  for (const auto& p : evaluated.assessment.evaluation.positions) positions.push(position_result_to_json(p));

  Value object = Value::object();
  object.add("standard", edition_of(metadata.axis));
  object.add("axis", std::move(axis));
  object.add("unit", deviation_unit_key(metadata.axis.kind));
  object.add("conforming", evaluated.assessment.conforming());
  object.add("claims", claims_to_json(iso230_2::claims_of(evaluated.test, evaluated.assessment),
                                      evaluated.temperatures ? &evaluated.temperatures->environment : nullptr));
  if (!evaluated.assessment.label.empty()) object.add("label", evaluated.assessment.label);
  object.add("parameters", parameters_to_json(evaluated.assessment.evaluation.parameters));
  add_symbols(object, evaluated);
  object.add("uncertainty", uncertainty_to_json(evaluated.assessment));
  add_conformity(object, evaluated);
  add_information(object, evaluated.test, evaluated.assessment.evaluation.parameters);
  object.add("positions", std::move(positions));
  object.add("drift", drift_to_json(evaluated.test));
  if (evaluated.temperatures) object.add("environment", environment_to_json(*evaluated.temperatures));
  object.add("findings", findings_to_json(evaluated.assessment.findings));
  object.add("metadata", std::move(metadata_object));
  object.add("source", source_to_json(evaluated.test.provenance, evaluated.name));
  add_corrections(object, evaluated.test);
  object.add("program", program_to_json());
  if (evaluated.verified) {
    Value& verification = object.add("verification", Value::object());
    verification.add("figures", evaluated.verified->figures);
    verification.add("verdicts", evaluated.verified->verdicts);
    verification.add("compared", evaluated.verified->compared);
    verification.add("differences", std::size_t{0});
  }
  return object;
}

json::Value error_to_json(const std::string& file, const Error& error) {
  Value source = Value::object();
  source.add("file", file);
  Value object = Value::object();
  object.add("source", std::move(source));
  object.add("error", error.to_string());
  return object;
}

std::string combined_csv_header(const UncertaintyOptions& asked) {
  std::string header = "file,test,axis,kind,unit,conforming";
  for (const auto& p : iso230_2::parameters) header += fmt::format(",{}", p.key);
  for (const auto& p : iso230_2::parameters) header += fmt::format(",U_{}", p.key);
  return header + ",error,verdict,does_not_conform,undecided" + method_csv_header(asked) +
         ",label,uncertainty_method,computed,tested,reported,symbol\r\n";
}

std::string combined_csv_row(const Evaluated& evaluated, const UncertaintyOptions& asked) {
  const Axis& axis = evaluated.test.metadata.axis;
  std::string row = fmt::format("{},{},{},{},{},{}", csv_text(evaluated.test.provenance.file), csv_text(evaluated.name),
                                csv_text(axis.name), axis_kind_name(axis.kind), deviation_unit_key(axis.kind),
                                evaluated.assessment.conforming() ? "yes" : "no");
  append_parameters(row, &evaluated.assessment.evaluation.parameters);
  append_uncertainties(row, evaluated.assessment);
  return row + "," + verdict_cells(evaluated.judgements) + method_csv_cells(asked, &evaluated) + "," +
         csv_text(evaluated.assessment.label) + "," + std::string(word_of_record(evaluated.assessment)) +
         claim_cells(iso230_2::claims_of(evaluated.test, evaluated.assessment)) + "," + iso230_2::error_symbol(axis) +
         "\r\n";
}

std::string combined_csv_error_row(const std::string& file, const Error& error, const UncertaintyOptions& asked) {
  std::string row = csv_text(file) + ",,,,,";
  append_parameters(row, nullptr);
  append_parameters(row, nullptr);
  return row + "," + csv_text(error.to_string()) + verdict_cells({}) + method_csv_cells(asked, nullptr) + ",,,,,,\r\n";
}

}  // namespace axiometry::app
