// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/rules/environment_findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"

namespace axiometry::iso230_2 {
namespace {

using Items = std::vector<EnvironmentItem>;

/// Of what is said of each quantity.
struct Ids {
  std::string_view key;
  const char *exceeded, *not_measured, *not_agreed;
};
constexpr Ids ids_of_items[] = {
    {"lowest_C", "environment-lowest-exceeded", "environment-lowest-not-measured", nullptr},
    {"highest_C", "environment-highest-exceeded", "environment-highest-not-measured", nullptr},
    {"rate_C_per_h", "environment-rate-exceeded", "environment-rate-not-measured", "environment-rate-not-agreed"},
    {"rate_before_C_per_h", "environment-rate-before-exceeded", "environment-rate-before-not-measured",
     "environment-rate-before-not-agreed"},
    {"machine_gradient_C", "environment-gradient-exceeded", "environment-gradient-not-measured", nullptr}};

const Ids& ids_of(const EnvironmentItem& item) {
  const auto ids = std::ranges::find(ids_of_items, item.key, &Ids::key);
  AXIOMETRY_CONTRACT(ids != std::end(ids_of_items));
  return *ids;
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
  const std::string id = ids_of(item).exceeded;
  return rules::departure(id, std::string(item.clause),
                          fmt::format("found {}: {}, expected {} as agreed between the parties",
                                      rules::within_sentence(item.title), measured_in(item), limit_in(item)));
}

/// By which who tested may state what was measured.
std::string_view field_of(const EnvironmentItem& item) {
  const Field* field = find_field(fmt::format("environment.{}", item.key));
  AXIOMETRY_CONTRACT(field != nullptr);
  return field->key;
}

Finding doubtful_finding(const EnvironmentItem& item) {
  return rules::answered_by(
      {field_of(item)},
      rules::missing("environment-perhaps-exceeded", std::string(item.clause),
                     fmt::format("found {}: {}, expected {} as agreed between the parties; nobody can say whether "
                                 "that was during the test",
                                 rules::within_sentence(item.title), measured_in(item), limit_in(item))));
}

Finding unmeasured_finding(const EnvironmentItem& item) {
  const std::string id = ids_of(item).not_measured;
  return rules::answered_by(
      {field_of(item)},
      rules::missing(id, std::string(item.clause),
                     fmt::format("found no measurement of {}, expected one: {} is agreed between the parties",
                                 rules::within_sentence(item.title), limit_in(item))));
}

Finding unlimited_finding(const EnvironmentItem& item) {
  const std::string id = ids_of(item).not_agreed;
  return rules::note(id, "4.1",
                     fmt::format("found {}: {}, and no limit that the parties agreed on",
                                 rules::within_sentence(item.title), measured_in(item)));
}

std::optional<Finding> known_in_part(const Items& items) {
  std::vector<std::string> titles;
  std::vector<std::string_view> fields;
  for (const EnvironmentItem& item : items) {
    if (item.standing != EnvironmentStanding::known_in_part || item.perhaps_exceeded) continue;
    titles.push_back(rules::within_sentence(item.title));
    fields.push_back(field_of(item));
  }
  if (titles.empty()) return std::nullopt;
  return rules::answered_by(std::move(fields),
                            rules::missing("environment-known-in-part", "4.1",
                                           fmt::format("found agreed limits of which nobody can say whether they were "
                                                       "kept, since not all of the time is known: {}",
                                                       fmt::join(titles, "; "))));
}

void add_standings(std::vector<Finding>& found, const Items& items, Depth depth) {
  for (const EnvironmentItem& item : items) {
    if (item.standing == EnvironmentStanding::exceeded) found.push_back(exceeded_finding(item));
    if (depth == Depth::departures_only) continue;
    if (item.perhaps_exceeded) found.push_back(doubtful_finding(item));
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
  for (const std::string& gap : time_gaps_of(environment)) found.push_back(rules::note("environment-gap", "4.1", gap));
  return found;
}

}  // namespace axiometry::iso230_2
