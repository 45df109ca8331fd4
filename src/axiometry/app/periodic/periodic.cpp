// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/periodic/periodic.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "axiometry/app/files/output.h"
#include "axiometry/app/results/document_json.h"
#include "axiometry/app/results/localised_result.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/test/metadata_json.h"
#include "axiometry/report/periodic.h"
#include "axiometry/report/translated.h"

namespace axiometry::app {
namespace {

using iso230_2::PeriodicDirection;
using json::Value;

/// u and U are null where `told` is false: of what noise alone makes as large no interval holds the truth as often as
/// U says.
Value estimate(double value, double u, double k, bool told = true) {
  Value object = Value::object();
  object.add("value", value);
  object.add("u", told ? Value(u) : Value());
  object.add("U", told ? Value(k * u) : Value());
  return object;
}

Value estimate(const iso230_2::Estimate<Deviation>& x, double k, bool told = true) {
  return estimate(x.value.in_native(), x.u.in_native(), k, told);
}

Value estimate(const iso230_2::Estimate<Angle>& x, double k, bool told) {
  return estimate(x.value.in_deg(), x.u.in_deg(), k, told);
}

Value harmonics_to_json(const PeriodicDirection& d) {
  Value list = Value::array();
  for (const auto& h : d.harmonics) {
    Value& row = list.push(Value::object());
    row.add("order", h.order);
    row.add("amplitude", estimate(h.amplitude, d.coverage_factor, d.tells_U() && h.significant));
    row.add("phase_deg", estimate(h.phase, d.coverage_factor, d.tells_U() && h.significant));
    row.add("chance", h.chance);
    row.add("in_curve", h.order == 1 || h.significant);
  }
  return list;
}

Value periodic_points_to_json(const PeriodicDirection& d) {
  Value list = Value::array();
  for (const auto& p : d.points) {
    Value& row = list.push(Value::object());
    row.add("target", p.target.in_native());
    row.add("deviation", p.deviation.in_native());
    row.add("line", p.line.in_native());
    row.add("curve", p.curve.in_native());
    row.add("residual", p.deviation.in_native() - p.line.in_native() - p.curve.in_native());
  }
  return list;
}

Value further_to_json(const PeriodicDirection& d) {
  if (!d.further) return {};
  Value object = Value::object();
  object.add("period", d.further->period.in_native());
  object.add("amplitude", d.further->amplitude.in_native());
  object.add("false_alarm_probability", d.further->false_alarm);
  return object;
}

Value direction_to_json(const PeriodicDirection& d) {
  const double k = d.coverage_factor;
  Value object = Value::object();
  object.add("direction", d.direction == Direction::up ? "up" : "down");
  object.add("targets", d.points.size());
  object.add("runs", d.runs);
  object.add("origin", d.origin.in_native());
  object.add("period_known", d.period_known);
  object.add("period",
             estimate(d.period.value.in_native(), d.period.u.in_native(), k, !d.period_known && d.tells_U()));
  const auto& fundamental = d.harmonics.front();
  object.add("amplitude", estimate(fundamental.amplitude, k, d.tells_U()));
  object.add("phase_deg", estimate(fundamental.phase, k, d.tells_U()));
  object.add("phase_at_zero_deg", estimate(d.phase_at_zero, k, d.tells_U()));
  object.add("harmonics", harmonics_to_json(d));
  object.add("peak_to_valley", estimate(d.peak_to_valley, k, d.tells_U()));
  object.add("range_about_line", d.range_about_line.in_native());
  object.add("range_of_residuals", d.range_of_residuals.in_native());
  object.add("residual_sd", d.residual_sd.in_native());
  object.add("degrees_of_freedom", d.degrees_of_freedom);
  object.add("coverage_factor", k);
  object.add("scatter_of_means", number_or_null(d.scatter_of_means));
  object.add("slope", estimate(d.slope_native.value, d.slope_native.u, k));
  object.add("offset", estimate(d.offset, k));
  object.add("false_alarm_probability", d.false_alarm);
  object.add("false_alarm_probability_correlated", d.false_alarm_correlated);
  object.add("residual_correlation", d.residual_correlation.lag_one);
  object.add("significant", d.significant);
  object.add("periods_covered", d.periods_covered);
  object.add("targets_per_period", d.targets_per_period);
  object.add("further_period", further_to_json(d));
  object.add("points", periodic_points_to_json(d));
  return object;
}

}  // namespace

Result<EvaluatedPeriodic> evaluate_periodic(const std::string& file, const EvaluateOptions& reading,
                                            const iso230_2::PeriodicOptions& options) {
  AXIOMETRY_TRY(Test measured, read_test(file, reading.format));
  const auto evaluate = [&]() -> Result<EvaluatedPeriodic> {
    AXIOMETRY_TRY(Test test, prepare_test(std::move(measured), reading));
    return periodic_error_of(std::move(test), options);
  };
  auto evaluated = evaluate();
  if (!evaluated && evaluated.error().file.empty()) evaluated.error().file = file == "-" ? "(standard input)" : file;
  return evaluated;
}

Result<EvaluatedPeriodic> periodic_error_of(Test test, const iso230_2::PeriodicOptions& options) {
  AXIOMETRY_TRY(iso230_2::PeriodicError result, iso230_2::periodic_error(test, options));
  return EvaluatedPeriodic{std::move(test), std::move(result)};
}

Result<Position> parsed_period(std::string_view text) {
  const auto x = parse_number(text);
  if (!x || !(*x > 0.0)) return fail(fmt::format("found {}, expected a number above 0", text::quoted(text)));
  return Position::native(*x);
}

json::Value to_json(const EvaluatedPeriodic& evaluated) {
  const Metadata& metadata = evaluated.test.metadata;
  Value axis = Value::object();
  axis.add("name", metadata.axis.name);
  axis.add("kind", axis_kind_name(metadata.axis.kind));
  Value metadata_object = Value::object();
  formats::add_metadata(metadata_object, metadata);
  Value directions = Value::array();
  for (const auto& d : evaluated.result.directions) directions.push(direction_to_json(d));

  Value object = Value::object();
  object.add("standard", iso230_2::edition);
  object.add("clause", "Annex C");
  object.add("result", "periodic-error");
  object.add("axis", std::move(axis));
  object.add("unit", deviation_unit_key(metadata.axis.kind));
  object.add("conforming", evaluated.result.conforming());
  if (!evaluated.result.label.empty()) object.add("label", evaluated.result.label);
  object.add("directions", std::move(directions));
  object.add("findings", findings_to_json(evaluated.result.findings));
  object.add("metadata", std::move(metadata_object));
  object.add("source", source_to_json(evaluated.test.provenance));
  object.add("program", program_to_json());
  return object;
}

json::Value to_json(const EvaluatedPeriodic& evaluated, const report::Options& options, bool dark) {
  Value object = localised_result(to_json(evaluated), ResultKind::periodic, {options.language, options.numbers});
  const report::Document document = report::compose({evaluated.test, evaluated.result}, options);
  object.add("document", document_to_json(report::translated(document, options), dark));
  return object;
}

Result<void> write_outputs(const EvaluatedPeriodic& evaluated, const OutputNames& names,
                           const report::Options& options) {
  AXIOMETRY_TRY_VOID(check_inputs_spared(names));
  if (!names.reports.empty()) {
    const report::Document document = report::compose({evaluated.test, evaluated.result}, options);
    AXIOMETRY_TRY_VOID(write_document(document, names.reports, options));
  }
  if (!names.json.empty()) AXIOMETRY_TRY_VOID(write_file(names.json, json::dump(to_json(evaluated)) + "\n"));
  return {};
}

}  // namespace axiometry::app
