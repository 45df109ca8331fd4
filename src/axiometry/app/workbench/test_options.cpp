// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/test_options.h"

#include <fmt/format.h>

#include "axiometry/app/evaluate/correction_text.h"
#include "axiometry/app/evaluate/uncertainty_members.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/app/workbench/from_archive/kept_temperatures.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/model/fields.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Value;

Result<void> take_corrections(const Value& value, TestOptions& options) {
  AXIOMETRY_TRY(const auto* items, formats::items_in(value, "corrections"));
  CorrectionRequest request;
  for (const Value& item : *items) {
    AXIOMETRY_TRY(std::string name, formats::text_in(item, "a correction"));
    if (auto known = choose_corrections(name, request); !known) return fail(known.error().message, item.at());
    options.corrections.push_back(std::move(name));
  }
  return {};
}

}  // namespace

json::Value to_json(const TestOptions& options) {
  Value methods = Value::array();
  if (options.gum) methods.push("gum");
  if (options.monte_carlo) methods.push("monte-carlo");
  Value corrections = Value::array();
  for (const std::string& correction : options.corrections) corrections.push(correction);
  Value object = Value::object();
  object.add("methods", std::move(methods));
  object.add("trials", options.trials ? Value(*options.trials) : Value());
  object.add("seed", seed_to_json(options.seed));
  object.add("coverage", options.coverage);
  object.add("corrections", std::move(corrections));
  if (options.temperatures) object.add("temperatures", to_json(*options.temperatures));
  return object;
}

json::Value to_json(const Changes& changes) {
  Value object = Value::object();
  for (const auto& [key, text] : changes) object.add(key, text);
  return object;
}

Result<TestOptions> test_options_from(const json::Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "options"));
  TestOptions options;
  UncertaintyOptions chosen;
  chosen.gum = options.gum;
  AXIOMETRY_TRY_VOID(take_uncertainty(members, chosen));
  options.gum = chosen.gum;
  options.monte_carlo = chosen.monte_carlo;
  options.trials = chosen.trials.propagation.trials;
  options.seed = chosen.trials.seed;
  options.coverage = chosen.trials.propagation.coverage;
  if (const Value* list = members.optional("corrections")) AXIOMETRY_TRY_VOID(take_corrections(*list, options));
  if (const Value* log = members.optional("temperatures")) {
    AXIOMETRY_TRY(options.temperatures, kept_temperatures_from(*log));
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return options;
}

Result<Changes> changes_from(const json::Value& value) {
  if (!value.is(json::Kind::object))
    return fail(fmt::format("found {} as changes, expected an object", json::kind_name(value.kind())), value.at());
  Changes changes;
  Metadata trial;
  for (const auto& [key, given] : value.members()) {
    if (find_field(key) == nullptr) return fail(set_field_text(trial, key, "").error().message, given.at());
    AXIOMETRY_TRY(const std::string raw, formats::text_in(given, key));
    auto text = given_text(key, raw);
    if (!text) return fail(text.error().message, given.at());
    changes.emplace_back(key, *std::move(text));
  }
  return changes;
}

Result<EvaluateOptions> evaluate_options(const TestOptions& options) {
  EvaluateOptions wanted;
  for (const std::string& correction : options.corrections)
    AXIOMETRY_TRY_VOID(choose_corrections(correction, wanted.corrections));
  wanted.uncertainty.gum = options.gum;
  wanted.uncertainty.monte_carlo = options.monte_carlo;
  wanted.uncertainty.trials.seed = options.seed;
  wanted.uncertainty.trials.propagation.trials = options.trials;
  wanted.uncertainty.trials.propagation.coverage = options.coverage;
  return wanted;
}

std::vector<std::pair<std::string, std::string>> metadata_items(const Changes& changes) {
  std::vector<std::pair<std::string, std::string>> items;
  for (const auto& [key, text] : changes) {
    const Field* field = find_field(key);
    if (field == nullptr || field->type != FieldType::records) {
      items.emplace_back(key, text);
      continue;
    }
    items.emplace_back(key, "");
    for (const std::string_view line : text::split(text, '\n'))
      if (!text::trim(line).empty()) items.emplace_back(key, line);
  }
  return items;
}

}  // namespace axiometry::app
