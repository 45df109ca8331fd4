// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/evaluate_options.h"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "axiometry/app/evaluate/uncertainty_members.h"
#include "axiometry/app/files/given_text.h"
#include "axiometry/app/files/request_members.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/model/fields.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using iso230_2::TypeA;
using json::Value;

constexpr std::size_t most_items = 200;
constexpr std::pair<std::string_view, TypeA> type_a_words[] = {
    {"pooled", TypeA::pooled}, {"t-scaled", TypeA::t_scaled}, {"resampled", TypeA::resampled}};

/// "machine.name=Mill 5", as --set has it.
Result<void> set_item(const std::string& text, TrackingEvaluateOptions& options) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return fail(fmt::format("set: found {}, expected KEY=VALUE", text::quoted(text)));
  AXIOMETRY_TRY(std::string key, given_line("set", text.substr(0, equals)));
  AXIOMETRY_TRY(std::string value, given_text("set", text.substr(equals + 1)));
  Metadata trial;
  AXIOMETRY_TRY_VOID(set_field_text(trial, key, value));
  options.metadata.emplace_back(std::move(key), std::move(value));
  return {};
}

Result<void> take_break_threshold(JsonMembers& members, const Value& value, TrackingEvaluateOptions& options) {
  std::optional<double>& threshold = options.break_threshold_mm;
  AXIOMETRY_TRY_VOID(take_number(members, "break_threshold_mm", threshold));
  if (!threshold || (*threshold > 0.0 && *threshold <= 1e6)) return {};
  return fail(fmt::format("break_threshold_mm: found {}, expected a length above 0 mm", format_exact(*threshold)),
              value.find("break_threshold_mm")->at());
}

Result<void> take_verdict(JsonMembers& members, TrackingEvaluateOptions& options) {
  AXIOMETRY_TRY_VOID(take_texts(members, "tolerances", most_items,
                                [&](const std::string& text) { return add_tolerance(text, options); }));
  AXIOMETRY_TRY_VOID(members.take("tolerance_table", options.tolerance.table_name));
  const Value* rule = members.optional("rule");
  if (rule == nullptr) return {};
  AXIOMETRY_TRY(const std::string text, formats::text_in(*rule, "rule"));
  AXIOMETRY_TRY(options.tolerance.rule, parse_rule(text));
  return {};
}

/// As parse_rule() reads it.
std::string rule_word(const RuleText& rule) {
  using Kind = uncertainty::DecisionRule::Kind;
  if (rule.kind == Kind::simple) return "simple";
  if (rule.kind == Kind::iso_14253_1) return "iso14253-1";
  return fmt::format("guard-band={}{}", format_exact(rule.guard_band), rule.unit == nullptr ? "" : rule.unit->name);
}

Value tolerances_value(const TrackingEvaluateOptions& options) {
  Value list = Value::array();
  for (const ToleranceText& limit : options.tolerance.limits) list.push(limit.text());
  for (const LineTolerance& own : options.line_tolerances) list.push(own.line + ":" + own.limit.text());
  return list;
}

void add_uncertainty(Value& object, const UncertaintyOptions& options) {
  const UncertaintyOptions usual;
  Value methods = Value::array();
  if (options.gum) methods.push("gum");
  if (options.monte_carlo) methods.push("monte-carlo");
  if (!methods.items().empty()) object.add("methods", std::move(methods));
  const auto &trials = options.trials, &usual_trials = usual.trials;
  if (trials.propagation.trials) object.add("trials", *trials.propagation.trials);
  if (trials.seed != usual_trials.seed) object.add("seed", seed_to_json(trials.seed));
  if (trials.propagation.coverage != usual_trials.propagation.coverage)
    object.add("coverage", trials.propagation.coverage);
  if (trials.type_a != usual_trials.type_a) object.add("type_a", iso230_2::type_a_key(trials.type_a));
}

}  // namespace

Result<TrackingEvaluateOptions> evaluate_options_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "options"));
  TrackingEvaluateOptions options;
  AXIOMETRY_TRY_VOID(take_switch(members, "reversed", options.reversed));
  AXIOMETRY_TRY_VOID(take_switch(members, "find_breaks", options.find_breaks));
  AXIOMETRY_TRY_VOID(take_break_threshold(members, value, options));
  AXIOMETRY_TRY_VOID(
      take_texts(members, "set", most_items, [&](const std::string& text) { return set_item(text, options); }));
  AXIOMETRY_TRY_VOID(take_verdict(members, options));
  AXIOMETRY_TRY_VOID(take_uncertainty(members, options.uncertainty));
  AXIOMETRY_TRY_VOID(take_choice<TypeA>(members, "type_a", type_a_words, options.uncertainty.trials.type_a));
  if (!options.uncertainty.monte_carlo)
    for (const char* name : {"trials", "seed", "coverage", "type_a"})
      if (const Value* own = value.find(name); own != nullptr && !own->is(json::Kind::null))
        return fail(fmt::format("{}: found it without the method it belongs to, expected monte-carlo in methods", name),
                    own->at());
  AXIOMETRY_TRY_VOID(take_recording(members, options.recording));
  AXIOMETRY_TRY_VOID(members.finish());
  return options;
}

Result<void> take_tolerances(const std::optional<GivenFile>& file, ToleranceOptions& tolerance) {
  if (!file && tolerance.table_name.empty()) return {};
  if (!file) return fail("found the name of a tolerance table and no file tolerances, expected both");
  AXIOMETRY_TRY(tolerance.table, in_file(read_tolerance_table(file->bytes, file->name), file->name));
  return {};
}

Value to_json(const TrackingEvaluateOptions& options, const RecordingTexts& recording) {
  Value object = Value::object();
  if (Value tolerances = tolerances_value(options); !tolerances.items().empty())
    object.add("tolerances", std::move(tolerances));
  if (!options.tolerance.table_name.empty()) object.add("tolerance_table", options.tolerance.table_name);
  if (options.tolerance.rule) object.add("rule", rule_word(*options.tolerance.rule));
  if (!options.metadata.empty()) {
    Value& set = object.add("set", Value::array());
    for (const auto& [key, text] : options.metadata) set.push(key + "=" + text);
  }
  if (options.reversed) object.add("reversed", true);
  if (!options.find_breaks) object.add("find_breaks", false);
  if (options.break_threshold_mm) object.add("break_threshold_mm", *options.break_threshold_mm);
  add_uncertainty(object, options.uncertainty);
  if (!recording.empty()) object.add("recording", recording_value(recording));
  return object;
}

}  // namespace axiometry::app
