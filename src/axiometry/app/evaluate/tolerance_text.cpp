// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/tolerance_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

using uncertainty::DecisionRule;
using RuleKind = DecisionRule::Kind;

constexpr double largest_native = 1e6;  // a metre: beyond, the unit is wrong, as for the limits in a test's file
constexpr std::string_view rule_words = "simple, iso14253-1 or guard-band=WIDTH such as guard-band=3um";

std::string_view units_of(AxisKind kind) { return kind == AxisKind::linear ? "um, mm or nm" : "arcsec or deg"; }

/// "10um", "0.003 mm"
struct DeviationAmount {
  std::optional<double> value;
  const formats::Unit* unit = nullptr;
};

DeviationAmount deviation_amount_from(std::string_view text) {
  const std::string_view amount = text::trim(text);
  const std::size_t digits_end = std::min(amount.find_first_not_of("0123456789.+-eE"), amount.size());
  return {parse_number(text::trim(amount.substr(0, digits_end))),
          formats::find_unit(text::trim(amount.substr(digits_end)))};
}

}  // namespace

std::string ToleranceText::text() const {
  return fmt::format("{}={}{}", parameter->key, format_exact(value), unit->name);
}

Result<ToleranceText> parse_tolerance(std::string_view text) {
  const auto expected = [&](std::string_view what) {
    return fail(fmt::format("found the tolerance {}, expected {}", text::quoted(text), what));
  };
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return expected("PARAMETER=LIMIT such as A=10um");
  const auto* parameter = iso230_2::find_parameter(text::trim(text.substr(0, equals)));
  if (parameter == nullptr) {
    std::vector<std::string_view> keys;
    for (const auto& p : iso230_2::parameters) keys.push_back(p.key);
    return expected(fmt::format("one of the parameters {}", fmt::join(keys, ", ")));
  }
  const auto [value, unit] = deviation_amount_from(text.substr(equals + 1));
  if (!value || *value <= 0) return expected("a limit that is a number above 0, with a decimal point");
  if (unit == nullptr) return expected("a limit with its unit um, mm, nm, arcsec or deg");
  if (formats::deviation_in(*unit, *value).in_native() > largest_native)
    return expected(
        fmt::format("a limit of at most {} {}", format_exact(largest_native), deviation_unit_key(unit->kind)));
  return ToleranceText{parameter, *value, unit};
}

Result<void> check_tolerances(const std::vector<ToleranceText>& texts) {
  for (auto t = texts.begin(); t != texts.end(); ++t) {
    const auto before = std::find_if(texts.begin(), t, [&](const ToleranceText& other) {
      return other.parameter == t->parameter && other.unit->kind == t->unit->kind;
    });
    if (before != t)
      return fail(fmt::format("found the tolerances {} and {}, expected one limit of {}", before->text(), t->text(),
                              t->parameter->key));
  }
  return {};
}

Result<std::vector<iso230_2::Tolerance>> tolerances_for(AxisKind kind, const std::vector<ToleranceText>& texts) {
  std::vector<iso230_2::Tolerance> tolerances;
  for (const ToleranceText& t : texts) {
    if (t.unit->kind == kind) {
      tolerances.push_back({t.parameter, formats::deviation_in(*t.unit, t.value), iso230_2::ToleranceSource::user});
      continue;
    }
    const bool has_other = std::ranges::any_of(
        texts, [&](const ToleranceText& other) { return other.parameter == t.parameter && other.unit->kind == kind; });
    if (!has_other)
      return fail(fmt::format("found the tolerance {} for a {} axis, expected a limit in {}", t.text(),
                              axis_kind_name(kind), units_of(kind)));
  }
  return tolerances;
}

Result<RuleText> parse_rule(std::string_view text) {
  const std::string_view word = text::trim(text.substr(0, text.find('=')));
  const bool has_width = text.find('=') != std::string_view::npos;
  if (word == "simple" && !has_width) return RuleText{RuleKind::simple, 0.0, nullptr};
  if (word == "iso14253-1" && !has_width) return RuleText{RuleKind::iso_14253_1, 0.0, nullptr};
  if (word != "guard-band" || !has_width)
    return fail(fmt::format("found the rule {}, expected {}", text::quoted(text), rule_words));
  const auto [value, unit] = deviation_amount_from(text.substr(text.find('=') + 1));
  if (!value || *value < 0 || unit == nullptr || formats::deviation_in(*unit, *value).in_native() > largest_native)
    return fail(
        fmt::format("found the rule {}, expected a width that is a number, 0 or more, with its unit um, mm, "
                    "nm, arcsec or deg",
                    text::quoted(text)));
  return RuleText{RuleKind::guard_band, *value, unit};
}

Result<DecisionRule> rule_for(AxisKind kind, const RuleText& text) {
  if (text.unit == nullptr) return DecisionRule{text.kind, 0.0};
  if (text.unit->kind != kind)
    return fail(fmt::format("found the rule guard-band={}{} for a {} axis, expected a width in {}",
                            format_exact(text.guard_band), text.unit->name, axis_kind_name(kind), units_of(kind)));
  return DecisionRule{text.kind, formats::deviation_in(*text.unit, text.guard_band).in_native()};
}

Result<std::optional<DecisionRule>> stated_rule(const Metadata& metadata) {
  const std::string& rule = metadata.tolerance.rule;
  const std::optional<Deviation>& width = metadata.tolerance.guard_band;
  if (width && rule != "guard-band")
    return fail(fmt::format("found tolerance.guard_band with {}, expected tolerance.rule = guard-band",
                            rule.empty() ? "no tolerance.rule" : "tolerance.rule = " + rule));
  if (rule.empty()) return std::optional<DecisionRule>();
  if (rule == "simple") return std::optional(DecisionRule{RuleKind::simple, 0.0});
  if (rule == "iso14253-1") return std::optional(DecisionRule{RuleKind::iso_14253_1, 0.0});
  if (!width)
    return fail(
        fmt::format("found tolerance.rule = guard-band alone, expected its width in tolerance.guard_band, in "
                    "{}",
                    deviation_unit(metadata.axis.kind)));
  return std::optional(DecisionRule{RuleKind::guard_band, width->in_native()});
}

}  // namespace axiometry::app
