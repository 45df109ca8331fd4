// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/kept_assessment.h"

#include <optional>

#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"

namespace axiometry::app {
namespace {

using json::Kind;
using json::Value;

/// nullptr also when a step on the way is missing or no object.
const Value* present_member(const Value* object, std::string_view name) {
  if (object == nullptr || !object->is(Kind::object)) return nullptr;
  const Value* found = object->find(name);
  return found == nullptr || found->is(Kind::null) ? nullptr : found;
}

std::optional<double> number(const Value* object, std::string_view name) {
  const Value* found = present_member(object, name);
  return found != nullptr && found->is(Kind::number) ? std::optional(found->number()) : std::nullopt;
}

iso230_2::AxisParameters parameters_of(const Value* object) {
  iso230_2::AxisParameters parameters;
  for (const auto& parameter : iso230_2::parameters)
    if (const auto x = number(object, parameter.key)) parameters.*parameter.member = Deviation::native(*x);
  return parameters;
}

iso230_2::GumUncertainty gum_of(const Value* object) {
  iso230_2::GumUncertainty gum;
  for (const auto& parameter : iso230_2::parameters) {
    const Value* own = present_member(object, parameter.key);
    const auto value = number(own, "value");
    const auto U = number(own, "U");
    if (!value || !U) continue;
    iso230_2::GumParameter found;
    found.parameter = &parameter;
    found.value = Deviation::native(*value);
    found.uncertainty.U = Deviation::native(*U);
    gum.parameters.push_back(std::move(found));
  }
  return gum;
}

/// Nothing of a result that an earlier program has kept, which chose by the same default.
std::optional<UncertaintyMethod> method_of(const Value* record) {
  const Value* key = present_member(record, "method");
  if (key == nullptr || !key->is(Kind::text)) return std::nullopt;
  for (const auto method : {UncertaintyMethod::annex_a, UncertaintyMethod::gum, UncertaintyMethod::monte_carlo})
    if (key->text() == iso230_2::method_key(method)) return method;
  return std::nullopt;
}

iso230_2::MonteCarlo monte_carlo_of(const Value* object) {
  iso230_2::MonteCarlo monte_carlo;
  for (std::size_t k = 0; k < std::size(iso230_2::parameters); ++k) {
    const Value* own = present_member(object, iso230_2::parameters[k].key);
    const auto u = number(own, "u");
    const Value* interval = present_member(own, "symmetric");
    if (!u || interval == nullptr || !interval->is(Kind::array) || interval->items().size() != 2) continue;
    const auto& ends = interval->items();
    if (!ends[0].is(Kind::number) || !ends[1].is(Kind::number)) continue;
    iso230_2::ParameterDistribution distribution;
    distribution.summary.sd = *u;
    distribution.summary.symmetric = {ends[0].number(), ends[1].number()};
    distribution.low = number(own, "low").value_or(ends[0].number());  // older results had the one interval
    distribution.high = number(own, "high").value_or(ends[1].number());
    if (const Value* refusal = present_member(own, "refusal"); refusal != nullptr && refusal->is(Kind::text))
      distribution.refusal = refusal->text();
    monte_carlo.distributions[k] = std::move(distribution);
  }
  return monte_carlo;
}

}  // namespace

iso230_2::Assessment assessment_shown_by(const json::Value& result) {
  iso230_2::Assessment assessment;
  assessment.evaluation.parameters = parameters_of(present_member(&result, "parameters"));
  const Value* uncertainty = present_member(&result, "uncertainty");
  if (const Value* annex_a = present_member(uncertainty, "annex_a")) {
    assessment.annex_a.emplace();
    assessment.annex_a->U = parameters_of(annex_a);
  }
  assessment.method_of_record = method_of(present_member(uncertainty, "record"));
  if (const Value* gum = present_member(uncertainty, "gum")) assessment.gum = gum_of(gum);
  if (const Value* run = present_member(uncertainty, "monte_carlo")) assessment.monte_carlo = monte_carlo_of(run);
  return assessment;
}

AxisKind axis_kind_of(const json::Value& result) {
  const Value* kind = present_member(present_member(&result, "axis"), "kind");
  return kind != nullptr && kind->is(Kind::text) && kind->text() == axis_kind_name(AxisKind::rotary) ? AxisKind::rotary
                                                                                                     : AxisKind::linear;
}

}  // namespace axiometry::app
