// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/environment_findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/base/number_text.h"
#include "axiometry/standards/iso230_2/rules/rules.h"

namespace axiometry::iso230_2 {
namespace {

using Items = std::vector<EnvironmentItem>;

constexpr std::pair<std::string_view, std::string_view> words_of_items[] = {{"lowest_C", "lowest"},
                                                                            {"highest_C", "highest"},
                                                                            {"rate_C_per_h", "rate"},
                                                                            {"rate_before_C_per_h", "rate-before"},
                                                                            {"machine_gradient_C", "gradient"}};

/// "environment-rate-before-exceeded".
std::string key_of(const EnvironmentItem& item, std::string_view what) {
  for (const auto& [key, word] : words_of_items)
    if (key == item.key) return fmt::format("environment-{}-{}", word, what);
  AXIOMETRY_CONTRACT(false);
  return {};
}

Finding keyed(std::string key, Finding finding) {
  finding.key = std::move(key);
  return finding;
}

/// To two decimals, or to as many as tell it from the limit.
std::string apart_from(double x, double limit) {
  for (int decimals = 2; decimals < 9; ++decimals) {
    const double power = std::pow(10.0, decimals);
    const double rounded = std::round(x * power) / power;
    if (rounded != limit) return format_exact(rounded);
  }
  return format_exact(x);
}

std::string measured_in(const EnvironmentItem& item) {
  constexpr double no_limit = 1e9;
  return fmt::format("{} {}", apart_from(*item.measured, item.agreed.value_or(no_limit)), item.unit);
}

std::string limit_in(const EnvironmentItem& item) {
  return fmt::format("{} {} {}", item.lower_limit ? "at least" : "at most", format_exact(*item.agreed), item.unit);
}

Finding exceeded_finding(const EnvironmentItem& item) {
  return keyed(key_of(item, "exceeded"),
               rules::departure(std::string(item.clause),
                                fmt::format("found {}: {}, expected {} as agreed between the parties",
                                            rules::within_sentence(item.title), measured_in(item), limit_in(item))));
}

Finding unmeasured_finding(const EnvironmentItem& item) {
  return keyed(key_of(item, "not-measured"),
               rules::missing(std::string(item.clause),
                              fmt::format("found no measurement of {}, expected one: {} is agreed between the parties",
                                          rules::within_sentence(item.title), limit_in(item))));
}

Finding unlimited_finding(const EnvironmentItem& item) {
  return keyed(key_of(item, "not-agreed"),
               rules::note("4.1", fmt::format("found {}: {}, and no limit that the parties agreed on",
                                              rules::within_sentence(item.title), measured_in(item))));
}

std::optional<Finding> known_in_part(const Items& items) {
  std::vector<std::string> titles;
  for (const EnvironmentItem& item : items)
    if (item.standing == EnvironmentStanding::known_in_part) titles.push_back(rules::within_sentence(item.title));
  if (titles.empty()) return std::nullopt;
  return keyed("environment-known-in-part",
               rules::missing("4.1", fmt::format("found agreed limits of which nobody can say whether they were kept, "
                                                 "since not all of the time is known: {}",
                                                 fmt::join(titles, "; "))));
}

void add_standings(std::vector<Finding>& found, const Items& items, Depth depth) {
  for (const EnvironmentItem& item : items) {
    if (item.standing == EnvironmentStanding::exceeded) found.push_back(exceeded_finding(item));
    if (depth == Depth::departures_only) continue;
    const bool is_rate = item.unit == "°C/h";
    if (item.standing == EnvironmentStanding::not_measured && item.agreed) found.push_back(unmeasured_finding(item));
    if (item.standing == EnvironmentStanding::not_agreed && is_rate) found.push_back(unlimited_finding(item));
  }
}

}  // namespace

std::vector<Finding> environment_findings(const TestEnvironment& environment, Depth depth) {
  std::vector<Finding> found;
  add_standings(found, environment.items, depth);
  if (depth == Depth::departures_only) return found;
  if (auto finding = known_in_part(environment.items)) found.push_back(*std::move(finding));
  for (const std::string& gap : gaps_of(environment))
    found.push_back(keyed("environment-gap", rules::note("4.1", gap)));
  return found;
}

}  // namespace axiometry::iso230_2
