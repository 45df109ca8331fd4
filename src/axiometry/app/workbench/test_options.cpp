// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/test_options.h"

#include <fmt/format.h>

#include <cmath>

#include "axiometry/app/evaluate/correction_text.h"
#include "axiometry/app/evaluate/uncertainty_text.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/model/fields.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Value;

constexpr double trials_max_workbench = 1e7;  // a minute or so; the command line takes more

Result<void> take_methods(const Value& value, TestOptions& options) {
  AXIOMETRY_TRY(const auto* items, formats::items_in(value, "methods"));
  UncertaintyOptions chosen;
  for (const Value& item : *items) {
    AXIOMETRY_TRY(const std::string name, formats::text_in(item, "a method"));
    if (auto known = choose_methods(name, chosen); !known) return fail(known.error().message, item.at());
  }
  options.gum = chosen.gum;
  options.monte_carlo = chosen.monte_carlo;
  return {};
}

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

Result<void> take_trials(const Value& value, TestOptions& options) {
  AXIOMETRY_TRY(const double trials, formats::number_in(value, "trials"));
  if (trials < trials_min || trials > trials_max_workbench || trials != std::floor(trials))
    return fail(fmt::format("found {} trials, expected null or a whole number from {:.0f} to {:.0f}",
                            format_exact(trials), trials_min, trials_max_workbench),
                value.at());
  options.trials = static_cast<std::size_t>(trials);
  return {};
}

/// A number below seed_limit, or text: of the numbers from there on JSON's readers make others.
Result<void> take_seed(const Value& value, TestOptions& options) {
  if (value.is(json::Kind::number) && value.number() >= 0 && value.number() < static_cast<double>(seed_limit) &&
      value.number() == std::floor(value.number())) {
    options.seed = static_cast<std::uint64_t>(value.number());
    return {};
  }
  const auto whole = value.is(json::Kind::text) ? parse_count(value.text()) : std::nullopt;
  if (!whole)
    return fail("found a seed that is no whole number from 0 to 9007199254740991, or text up to 18446744073709551615",
                value.at());
  options.seed = *whole;
  return {};
}

Result<void> take_coverage(const Value& value, TestOptions& options) {
  AXIOMETRY_TRY(options.coverage, formats::number_in(value, "coverage"));
  if (options.coverage >= 0.5 && options.coverage <= 0.9999) return {};
  return fail(
      fmt::format("found the coverage {}, expected a probability from 0.5 to 0.9999", format_exact(options.coverage)),
      value.at());
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
  if (const Value* methods = members.optional("methods")) AXIOMETRY_TRY_VOID(take_methods(*methods, options));
  if (const Value* trials = members.optional("trials")) AXIOMETRY_TRY_VOID(take_trials(*trials, options));
  if (const Value* seed = members.optional("seed")) AXIOMETRY_TRY_VOID(take_seed(*seed, options));
  if (const Value* coverage = members.optional("coverage")) AXIOMETRY_TRY_VOID(take_coverage(*coverage, options));
  if (const Value* list = members.optional("corrections")) AXIOMETRY_TRY_VOID(take_corrections(*list, options));
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
