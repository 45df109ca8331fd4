// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/from_archive/axis_limits.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/results/result_json.h"
#include "axiometry/base/text/number_text.h"

namespace axiometry::app {
namespace {

std::optional<double> limit_of(const std::vector<store::Limit>& limits, std::string_view parameter) {
  const auto found = std::ranges::find(limits, parameter, &store::Limit::parameter);
  return found == limits.end() ? std::nullopt : std::optional(found->value);
}

/// "A 12 → 5 µm, B 3 → – µm"; empty where both are the same.
std::string differences(const std::vector<store::Limit>& before, const store::AxisRecord& now) {
  const AxisKind kind = now.kind == axis_kind_name(AxisKind::rotary) ? AxisKind::rotary : AxisKind::linear;
  const auto shown = [](std::optional<double> limit) { return limit ? format_exact(*limit) : std::string("–"); };
  std::string text;
  for (const auto& parameter : iso230_2::parameters) {
    const auto then = limit_of(before, parameter.key), today = limit_of(now.limits, parameter.key);
    if (then != today)
      text += fmt::format("{}{} {} → {} {}", text.empty() ? "" : ", ", parameter.symbol, shown(then), shown(today),
                          deviation_unit(kind));
  }
  return text;
}

}  // namespace

std::optional<iso230_2::Finding> changed_limits(const FromArchive& taken, const std::optional<store::AxisRecord>& now) {
  if (!taken.axis || !now) return std::nullopt;
  const std::string changed = differences(taken.axis->limits, *now);
  if (changed.empty()) return std::nullopt;
  return iso230_2::Finding{
      "axis-limits-changed", "8.2", iso230_2::Severity::note,
      fmt::format(
          "the limits of the axis have changed since this version was evaluated, and its verdicts rest on those "
          "of its day: {}",
          changed)};
}

json::Value with_finding(json::Value result, const std::optional<iso230_2::Finding>& finding) {
  if (!finding || !result.is(json::Kind::object)) return result;
  const json::Value rows = findings_to_json(std::span(&*finding, 1));
  json::Value all = json::Value::object();
  for (const auto& [name, member] : result.members()) {
    json::Value& added = all.add(name, member);
    if (name == "findings" && added.is(json::Kind::array)) added.push(rows.items().front());
  }
  return all;
}

}  // namespace axiometry::app
