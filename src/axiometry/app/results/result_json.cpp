// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/result_json.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "axiometry/app/results/corrections_json.h"
#include "axiometry/app/results/told_results.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/app/temperatures/temperatures.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/version.h"
#include "axiometry/formats/test/metadata_place.h"
#include "axiometry/standards/iso230_2/error_symbol.h"
#include "axiometry/standards/iso230_2/information.h"
#include "axiometry/standards/iso230_2/rules/claims.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::app {
namespace {

using json::Place;
using json::Value;

std::optional<std::string_view> unless_empty(std::string_view s) { return s.empty() ? std::nullopt : std::optional(s); }

void put_position(Place place, const iso230_2::PositionResult& p) {
  json::Object object(place);
  object.add("target", p.target.in_native());
  object.add("n_up", p.count_up);
  object.add("n_down", p.count_down);
  for (const auto& quantity : iso230_2::position_quantities)
    object.add(quantity.key, native_number(p.*quantity.member));
}

void put_texts(Place place, const auto& texts) {
  json::List list(place);
  for (const std::string_view text : texts) list.push(text);
}

void put_remedy(json::Object& row, const iso230_2::Remedy& remedy) {
  if (remedy.corrections.empty() && remedy.fields.empty()) return;
  json::Object object = row.object("remedy");
  put_texts(object.at("corrections"), remedy.corrections);
  put_texts(object.at("fields"), remedy.fields);
}

void put_judgement(Place place, const iso230_2::Judgement& judgement) {
  json::Object row(place);
  row.add("parameter", judgement.tolerance.parameter->key);
  row.add("limit", judgement.tolerance.limit.in_native());
  row.add("source", iso230_2::tolerance_source_key(judgement.tolerance.source));
  row.add("verdict", uncertainty::verdict_name(judgement.decision.verdict));
  row.add("rule", judgement.rule.id());
  {
    json::List replaced = row.list("replaced");
    for (const iso230_2::ReplacedLimit& other : judgement.tolerance.replaced) {
      json::Object limit = replaced.object();
      limit.add("limit", other.limit.in_native());
      limit.add("source", iso230_2::tolerance_source_key(other.source));
    }
  }
  row.add("withheld", unless_empty(judgement.withheld));
  put_remedy(row, judgement.remedy);
  const auto& known = judgement.uncertainty;
  const bool measurand_known = known && known->measurand;
  row.add("u", known ? std::optional(known->u.in_native()) : std::nullopt);
  row.add("u_degrees_of_freedom", known ? known->degrees_of_freedom : std::nullopt);
  row.add("u_method", known ? std::optional(iso230_2::method_key(known->method)) : std::nullopt);
  row.add("u_measurand", measurand_known ? std::optional(iso230_2::measurand_key(*known->measurand)) : std::nullopt);
  const bool judged = judgement.decision.verdict != uncertainty::Verdict::not_applicable;
  const bool guarded = judged && judgement.has_guard_band();
  row.add("guard_band", guarded ? std::optional(judgement.decision.guard_band) : std::nullopt);
  row.add("rejection_band", guarded ? std::optional(judgement.decision.rejection_band) : std::nullopt);
  row.add("acceptance_limit", native_number(judged ? judgement.acceptance_limit() : std::nullopt));
  row.add("rejection_limit", native_number(judged ? judgement.rejection_limit() : std::nullopt));
  row.add("probability_conforming", judgement.decision.probability_conforming);
  const auto& range = judgement.decision.probability_range;
  row.add("probability_least", range ? std::optional(range->least) : std::nullopt);
  row.add("probability_most", range ? std::optional(range->most) : std::nullopt);
  row.add("consumer_risk", judgement.decision.consumer_risk);
  row.add("producer_risk", judgement.decision.producer_risk);
}

/// "verdict", "tolerances" and, when a table was used, which row of it.
void add_conformity(json::Object& object, const Evaluated& evaluated) {
  const auto verdict = iso230_2::overall_verdict(evaluated.judgements);
  if (!verdict) return;
  object.add("verdict", uncertainty::verdict_name(*verdict));
  {
    json::List list = object.list("tolerances");
    for (const auto& judgement : evaluated.judgements) put_judgement(list.next(), judgement);
  }
  if (!evaluated.tolerance_band) return;
  const AppliedBand& band = *evaluated.tolerance_band;
  json::Object table = object.object("tolerance_table");
  table.add("file", band.file);
  table.add("sha256", band.sha256);
  table.add("name", band.name);
  table.add("travel_up_to", band.travel_max ? std::optional(band.travel_max->in_native()) : std::nullopt);
}

void put_findings(Place place, std::span<const iso230_2::Finding> findings) {
  json::List list(place);
  for (const auto& finding : findings) {
    json::Object row = list.object();
    row.add("id", finding.id);
    row.add("clause", finding.clause);
    row.add("severity", iso230_2::severity_name(finding.severity));
    row.add("message", finding.message);
    if (!finding.fields.empty()) put_texts(row.at("fields"), finding.fields);
  }
}

void put_claims(Place place, const iso230_2::Claims& claims, const iso230_2::TestEnvironment* surroundings,
                const Test& test) {
  json::List list(place);
  for (const iso230_2::Claim& claim : claims) {
    json::Object row = list.object();
    row.add("key", iso230_2::claim_key(claim.kind));
    row.add("title", claim.title);
    row.add("holds", claim.holds());
    put_findings(row.at("missing"), claim.against);
    if (claim.kind == iso230_2::ClaimKind::tested) row.add("remark", iso230_2::word_of_the_tester(test, surroundings));
  }
}

/// What is told for information and never judged; nothing when nothing was asked for.
void add_information(json::Object& object, const Test& test, const iso230_2::AxisParameters& parameters) {
  const auto smaller = iso230_2::smaller_repeatability(test.metadata, parameters);
  if (!smaller) return;
  json::Object information = object.object("information");
  json::Object row = information.object("smaller_repeatability");
  row.add("value", smaller->value.in_native());
  row.add("of", smaller->parameter->key);
  row.add("remark", iso230_2::smaller_repeatability_remark);
}

/// With the axis (8.2.4), of the parameters that exist; nothing where the axis has no symbol.
void add_symbols(json::Object& object, const Evaluated& evaluated) {
  const Axis& axis = evaluated.test.metadata.axis;
  if (iso230_2::error_symbol(axis).empty()) return;
  json::Object symbols = object.object("symbols");
  for (const auto& p : iso230_2::parameters)
    if (evaluated.assessment.evaluation.parameters.*p.member) symbols.add(p.key, iso230_2::error_symbol(axis, p));
}

void put_source(Place place, const Provenance& provenance, const std::string& test_name) {
  json::Object object(place);
  object.add("file", provenance.file);
  if (!test_name.empty()) object.add("test", test_name);
  object.add("sha256", unless_empty(provenance.sha256));
  object.add("format", provenance.format);
}

void put_program(Place place) {
  json::Object object(place);
  object.add("name", "axiometry");
  object.add("version", version);
}

void put_axis(Place place, const Axis& axis) {
  json::Object object(place);
  object.add("name", axis.name);
  object.add("kind", axis_kind_name(axis.kind));
}

void put_positions(Place place, std::span<const iso230_2::PositionResult> positions) {
  json::List list(place);
  for (const auto& p : positions) put_position(list.next(), p);
}

void put_metadata(Place place, const Metadata& metadata) {
  json::Object object(place);
  formats::add_metadata(object, metadata);
}

void put_verification(Place place, const report::VerifiedFigures& verified) {
  json::Object verification(place);
  verification.add("figures", verified.figures);
  verification.add("verdicts", verified.verdicts);
  verification.add("compared", verified.compared);
  verification.add("differences", std::size_t{0});
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
  return json::tree_of([&](Place place) { put_findings(place, findings); });
}

json::Value source_to_json(const Provenance& provenance, const std::string& test_name) {
  return json::tree_of([&](Place place) { put_source(place, provenance, test_name); });
}

json::Value program_to_json() { return json::tree_of(put_program); }

void put_result(json::Place place, const Evaluated& evaluated) {
  const Test& test = evaluated.test;
  const Metadata& metadata = test.metadata;
  const iso230_2::Assessment& assessment = evaluated.assessment;
  json::Object object(place);
  object.add("standard", edition_of(metadata.axis));
  put_axis(object.at("axis"), metadata.axis);
  object.add("unit", deviation_unit_key(metadata.axis.kind));
  object.add("conforming", assessment.conforming());
  put_claims(object.at("claims"), iso230_2::claims_of(test, assessment), evaluated.environment(), test);
  if (!assessment.label.empty()) object.add("label", assessment.label);
  put_parameters(object.at("parameters"), assessment.evaluation.parameters);
  add_symbols(object, evaluated);
  put_uncertainty(object.at("uncertainty"), assessment);
  add_conformity(object, evaluated);
  add_information(object, test, assessment.evaluation.parameters);
  put_positions(object.at("positions"), assessment.evaluation.positions);
  put_drift(object.at("drift"), test);
  if (evaluated.temperatures) object.add("environment", environment_to_json(*evaluated.temperatures));
  if (evaluated.stated_environment) object.add("environment", environment_to_json(*evaluated.stated_environment));
  put_findings(object.at("findings"), assessment.findings);
  put_metadata(object.at("metadata"), metadata);
  put_source(object.at("source"), test.provenance, evaluated.name);
  add_corrections(object, test);
  put_program(object.at("program"));
  if (evaluated.verified) put_verification(object.at("verification"), *evaluated.verified);
}

json::Value to_json(const Evaluated& evaluated) {
  return json::tree_of([&](Place place) { put_result(place, evaluated); });
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
