// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/uncertainty_json.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/results/annex_a_json.h"
#include "axiometry/app/results/told_results.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/report/resolved_text.h"
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"

namespace axiometry::app {
namespace {

using iso230_2::Contribution;
using iso230_2::ExpandedUncertainty;
using iso230_2::GumUncertainty;
using iso230_2::MonteCarlo;
using iso230_2::ParameterDistribution;
using json::Place;
using json::Value;

Value texts(const std::vector<std::string>& list) { return Value::array({list.begin(), list.end()}); }

Value pair(const uncertainty::Interval& interval) { return Value::array({interval.lower, interval.upper}); }

/// A member per parameter, in the order of `parameters`.
template <typename ToJson>
Value per_parameter(const ToJson& to_json) {
  Value object = Value::object();
  for (const auto& p : iso230_2::parameters) object.add(p.key, to_json(p));
  return object;
}

/// The same put into a place: `put(place, parameter)`.
template <typename Put>
void put_per_parameter(Place place, const Put& put) {
  json::Object object(place);
  for (const auto& p : iso230_2::parameters) put(object.at(p.key), p);
}

void add_expanded(Value& object, const ExpandedUncertainty& uncertainty) {
  object.add("u", uncertainty.u.in_native());
  object.add("U", uncertainty.U.in_native());
  object.add("k", uncertainty.k);
  object.add("nu_eff", number_or_null(uncertainty.effective_degrees_of_freedom));
  object.add("coverage", iso230_2::coverage_key(uncertainty.coverage));
}

Value gum_to_json(const GumUncertainty& gum) {
  return per_parameter([&](const iso230_2::ParameterInfo& parameter) {
    const auto* found = gum.find(parameter.key);
    if (found == nullptr) return Value();
    Value object = Value::object();
    object.add("value", found->value.in_native());
    add_expanded(object, found->uncertainty);
    return object;
  });
}

Value gum_source_to_json(const iso230_2::GumSource& source) {
  Value object = Value::object();
  object.add("key", source.key);
  object.add("symbol", source.symbol);
  object.add("title", source.title);
  object.add("source", source.source);
  object.add("distribution", source.distribution.empty() ? Value() : Value(source.distribution));
  object.add("u", number_or_null(source.u));
  object.add("unit", source.unit);
  if (!source.note.empty()) object.add("note", source.note);
  return object;
}

/// |c| u of every source, by its key, for each parameter.
Value gum_contributions_to_json(const GumUncertainty& gum) {
  Value list = Value::array();
  for (std::size_t k = 0; k < gum.sources.size(); ++k) {
    Value& row = list.push(Value::object());
    row.add("key", gum.sources[k].key);
    row.add("u", per_parameter([&](const iso230_2::ParameterInfo& parameter) {
              const auto* found = gum.find(parameter.key);
              return found ? Value(found->contributions[k].in_native()) : Value();
            }));
  }
  return list;
}

Value components_to_json(const std::optional<iso230_2::PositionComponents>& components) {
  if (!components) return {};
  Value object = Value::object();
  object.add("approaches", components->approaches.in_native());
  object.add("thermal", components->thermal.in_native());
  object.add("alignment", components->alignment.in_native());
  object.add("axis_resolution", components->axis_resolution.in_native());
  object.add("instrument", components->instrument.in_native());
  object.add("other", components->other.in_native());
  add_expanded(object, components->total);
  return object;
}

Value position_uncertainty_to_json(const iso230_2::PositionUncertainty& position) {
  Value object = Value::object();
  object.add("target", position.target.in_native());
  object.add("up", components_to_json(position.up));
  object.add("down", components_to_json(position.down));
  Value& mean = object.add("mean", Value());
  if (!position.mean) return object;
  mean = Value::object();
  add_expanded(mean, *position.mean);
  return object;
}

Value factor_to_json(const std::optional<iso230_2::FactorUncertainty>& factor) {
  if (!factor) return {};
  Value object = Value::object();
  object.add("departure", factor->departure);
  object.add("u", factor->u);
  object.add("u_linear", factor->u_linear);
  object.add("u_exact", factor->u_exact);
  return object;
}

Value gum_budget_to_json(const GumUncertainty& gum) {
  Value object = Value::object();
  object.add("measurand", iso230_2::measurand_key(gum.measurand));
  object.add("up_down_correlation", gum.up_down_correlation);
  Value& factors = object.add("factors_um_per_m", Value::object());
  factors.add("machine_thermal", factor_to_json(gum.machine_thermal));
  factors.add("device_thermal", factor_to_json(gum.device_thermal));
  factors.add("alignment", factor_to_json(gum.alignment));
  Value& sources = object.add("sources", Value::array());
  for (const auto& source : gum.sources) sources.push(gum_source_to_json(source));
  object.add("contributions", gum_contributions_to_json(gum));
  Value& positions = object.add("positions", Value::array());
  for (const auto& position : gum.positions) positions.push(position_uncertainty_to_json(position));
  object.add("notes", texts(gum.notes));
  return object;
}

using Hypotheses = std::vector<const iso230_2::NoiseHypothesis*>;

/// Those that trials were drawn for.
Hypotheses drawn_hypotheses(const MonteCarlo& monte_carlo) {
  Hypotheses drawn;
  for (const auto& hypothesis : monte_carlo.hypotheses)
    if (!hypothesis.refuted) drawn.push_back(&hypothesis);
  return drawn;
}

Value distribution_to_json(const ParameterDistribution& d, const Hypotheses& hypotheses) {
  const auto& s = d.summary;
  Value counts = Value::array();
  for (std::uint64_t count : s.histogram.counts) counts.push(static_cast<std::size_t>(count));
  Value histogram = Value::object();
  histogram.add("lower", s.histogram.lower);
  histogram.add("width", s.histogram.width);
  histogram.add("counts", std::move(counts));
  Value object = Value::object();
  object.add("value", d.value);
  object.add("mean", s.mean);
  object.add("u", s.sd);
  object.add("bias", d.bias());
  object.add("low", d.low);
  object.add("high", d.high);
  if (!hypotheses.empty()) {
    object.add("low_from", hypotheses[d.low_from]->key);
    object.add("high_from", hypotheses[d.high_from]->key);
  }
  if (!d.refusal.empty()) object.add("refusal", d.refusal);
  Value& by_hypothesis = object.add("by_hypothesis", Value::object());
  for (std::size_t h = 0; h < std::min(hypotheses.size(), d.by_hypothesis.size()); ++h) {
    const auto& own = d.by_hypothesis[h];
    Value& row = by_hypothesis.add(hypotheses[h]->key, Value::object());
    row.add("mean", own.mean);
    row.add("u", own.sd);
    row.add("symmetric", pair(own.symmetric));
  }
  object.add("symmetric", pair(s.symmetric));
  object.add("shortest", pair(s.shortest));
  object.add("delta", s.tolerance);
  object.add("stable", s.stable);
  object.add("mean_error", s.mean_error);
  object.add("u_error", s.sd_error);
  object.add("symmetric_error", pair(s.symmetric_error));
  object.add("histogram", std::move(histogram));
  return object;
}

const std::optional<ParameterDistribution>& distribution_of(const MonteCarlo& monte_carlo,
                                                            const iso230_2::ParameterInfo& parameter) {
  return monte_carlo.distributions[static_cast<std::size_t>(&parameter - iso230_2::parameters)];
}

Value monte_carlo_to_json(const MonteCarlo& monte_carlo) {
  return per_parameter([&](const iso230_2::ParameterInfo& parameter) {
    const auto& found = distribution_of(monte_carlo, parameter);
    return found ? distribution_to_json(*found, drawn_hypotheses(monte_carlo)) : Value();
  });
}

Value input_to_json(const iso230_2::UncertaintyInput& input) {
  Value object = Value::object();
  object.add("key", input.key);
  object.add("symbol", input.symbol);
  object.add("title", input.title);
  object.add("source", input.source);
  object.add("effect", iso230_2::effect_key(input.effect));
  object.add("distribution", input.distribution.text());
  object.add("u", number_or_null(input.distribution.standard_deviation()));
  object.add("unit", input.unit);
  if (!input.note.empty()) object.add("note", input.note);
  return object;
}

Value mean_to_json(const std::optional<iso230_2::MeanInterval>& interval) {
  if (!interval) return {};
  Value object = Value::object();
  object.add("value", interval->value);
  object.add("mean", interval->mean);
  object.add("u", interval->u);
  object.add("low", interval->low);
  object.add("high", interval->high);
  return object;
}

/// x̄_i of every target that has an interval, as gum_budget.positions of the law of propagation.
Value means_to_json(const MonteCarlo& run) {
  Value list = Value::array();
  for (const iso230_2::MeanDistribution& position : run.means) {
    Value& row = list.push(Value::object());
    row.add("target", position.target.in_native());
    row.add("up", mean_to_json(position.up));
    row.add("down", mean_to_json(position.down));
    row.add("mean", mean_to_json(position.mean));
  }
  return list;
}

Value monte_carlo_run_to_json(const MonteCarlo& run) {
  Value object = Value::object();
  object.add("measurand", iso230_2::measurand_key(run.measurand));
  const bool sampled = run.measurand == iso230_2::Measurand::this_machine;
  object.add("type_a", sampled ? Value(iso230_2::type_a_key(run.type_a)) : Value());
  object.add("trials", run.trials);
  object.add("adaptive", run.adaptive);
  object.add("stable", run.stable);
  object.add("seed", seed_to_json(run.seed));
  object.add("coverage", run.coverage);
  Value& hypotheses = object.add("hypotheses", Value::array());
  for (const auto& hypothesis : run.hypotheses) {
    Value& row = hypotheses.push(Value::object());
    row.add("key", hypothesis.key);
    row.add("title", hypothesis.title);
    row.add("refuted", hypothesis.refuted);
    row.add("p", number_or_null(hypothesis.p));
    row.add("reason", hypothesis.reason);
  }
  Value& inputs = object.add("inputs", Value::array());
  for (const auto& input : run.inputs) inputs.push(input_to_json(input));
  Value& contributions = object.add("contributions", Value::array());
  for (const Contribution& contribution : run.contributions) {
    Value& row = contributions.push(Value::object());
    row.add("key", contribution.key);
    row.add("title", contribution.title);
    row.add("u", per_parameter([&](const iso230_2::ParameterInfo& parameter) {
              const auto p = static_cast<std::size_t>(&parameter - iso230_2::parameters);
              return run.distributions[p] ? Value(contribution.u[p]) : Value();
            }));
  }
  object.add("positions", means_to_json(run));
  object.add("position_trials", run.mean_trials);
  object.add("notes", texts(run.notes));
  return object;
}

void put_inputs(Place place, const iso230_2::ResolvedInputs& inputs) {
  json::List list(place);
  for (const iso230_2::ResolvedRow& input : inputs.rows) {
    json::Object row = list.object();
    row.add("key", input.key);
    row.add("symbol", input.symbol);
    row.add("title", report::input_title(input));
    if (input.value)
      row.add("value", *input.value);
    else
      row.add("value", input.word);
    row.add("unit", input.unit);
    row.add("origin", iso230_2::origin_key(input.origin));
    row.add("origin_title", report::origin_text(input));
    if (!input.instrument.empty()) row.add("instrument", input.instrument);
    row.add("use", iso230_2::use_key(input.use));
    row.add("use_title", report::use_text(input));
    if (!input.reason.empty()) row.add("reason", input.reason);
  }
}

/// The uncertainty that stands with the results, whatever else was estimated.
void put_record(Place place, const iso230_2::Assessment& assessment) {
  const auto method = iso230_2::method_of_record(assessment);
  json::Object object(place);
  object.add("method", method ? std::optional(iso230_2::method_key(*method)) : std::nullopt);
  object.add("chosen", assessment.method_of_record.has_value());
  put_per_parameter(object.at("parameters"), [&](Place of, const iso230_2::ParameterInfo& parameter) {
    const auto known = iso230_2::uncertainty_of_record(assessment, parameter);
    if (!known) return of.put(std::nullopt);
    json::Object row(of);
    row.add("u", known->u.in_native());
    row.add("U", native_number(known->U));
    row.add("low", known->interval.lower);
    row.add("high", known->interval.upper);
  });
}

}  // namespace

json::Value number_or_null(const std::optional<double>& x) { return x ? Value(*x) : Value(); }

json::Value number_or_null(const std::optional<Deviation>& x) { return x ? Value(x->in_native()) : Value(); }

json::Value seed_to_json(std::uint64_t seed) {
  return seed < seed_limit ? Value(static_cast<double>(seed)) : Value(fmt::format("{}", seed));
}

std::optional<double> native_number(const std::optional<Deviation>& x) {
  return x ? std::optional(x->in_native()) : std::nullopt;
}

void put_parameters(Place place, const iso230_2::AxisParameters& parameters) {
  put_per_parameter(place, [&](Place of, const auto& p) { of.put(native_number(parameters.*p.member)); });
}

json::Value parameters_to_json(const iso230_2::AxisParameters& parameters) {
  return json::tree_of([&](Place place) { put_parameters(place, parameters); });
}

void put_uncertainty(Place place, const iso230_2::Assessment& assessment) {
  const auto& [annex_a, gum, monte_carlo] = std::tie(assessment.annex_a, assessment.gum, assessment.monte_carlo);
  json::Object object(place);
  put_record(object.at("record"), assessment);
  put_inputs(object.at("inputs"), assessment.inputs);
  if (annex_a)
    put_parameters(object.at("annex_a"), annex_a->U);
  else
    object.add("annex_a", std::nullopt);
  object.add("gum", gum ? gum_to_json(*gum) : Value());
  object.add("monte_carlo", monte_carlo ? monte_carlo_to_json(*monte_carlo) : Value());
  if (annex_a) put_annex_a_budget(object.at("annex_a_budget"), *annex_a);
  if (gum) object.add("gum_budget", gum_budget_to_json(*gum));
  if (monte_carlo) object.add("monte_carlo_run", monte_carlo_run_to_json(*monte_carlo));
}

json::Value uncertainty_to_json(const iso230_2::Assessment& assessment) {
  return json::tree_of([&](Place place) { put_uncertainty(place, assessment); });
}

}  // namespace axiometry::app
