// SPDX-License-Identifier: Apache-2.0
//
// The columns of the combined CSV.
#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>

#include "axiometry/app/results/uncertainty_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"

namespace axiometry::app {
namespace {

using iso230_2::ParameterDistribution;

/// One group of columns: a name before the parameter's key and its cells.
struct CsvGroup {
  std::string_view prefix;
  std::optional<double> (*value)(const iso230_2::Assessment&, const iso230_2::ParameterInfo&);
};

std::optional<double> gum_U(const iso230_2::Assessment& assessment, const iso230_2::ParameterInfo& parameter) {
  const auto* found = assessment.gum ? assessment.gum->find(parameter.key) : nullptr;
  return found ? std::optional(found->uncertainty.U.in_native()) : std::nullopt;
}

template <auto Member>
std::optional<double> of_monte_carlo(const iso230_2::Assessment& assessment, const iso230_2::ParameterInfo& parameter) {
  if (!assessment.monte_carlo) return std::nullopt;
  const auto& found = assessment.monte_carlo->distributions[iso230_2::index_of(parameter)];
  return found && found->refusal.empty() ? std::optional(Member(*found)) : std::nullopt;
}

constexpr CsvGroup gum_groups[] = {{"gum_U_", &gum_U}};
constexpr CsvGroup monte_carlo_groups[] = {
    {"mc_mean_", &of_monte_carlo<[](const ParameterDistribution& d) { return d.summary.mean; }>},
    {"mc_u_", &of_monte_carlo<[](const ParameterDistribution& d) { return d.summary.sd; }>},
    {"mc_low_", &of_monte_carlo<[](const ParameterDistribution& d) { return std::min(d.low, d.value); }>},
    {"mc_high_", &of_monte_carlo<[](const ParameterDistribution& d) { return std::max(d.high, d.value); }>},
};

template <typename Cell>
std::string csv_cells(const UncertaintyOptions& asked, const Cell& cell) {
  std::string text;
  const auto append = [&](std::span<const CsvGroup> groups) {
    for (const CsvGroup& group : groups)
      for (const auto& parameter : iso230_2::parameters) text += "," + cell(group, parameter);
  };
  if (asked.gum) append(gum_groups);
  if (asked.monte_carlo) append(monte_carlo_groups);
  return text;
}

}  // namespace

std::string method_csv_header(const UncertaintyOptions& asked) {
  return csv_cells(asked, [](const CsvGroup& group, const auto& parameter) {
    return fmt::format("{}{}", group.prefix, parameter.key);
  });
}

std::string method_csv_cells(const UncertaintyOptions& asked, const Evaluated* evaluated) {
  return csv_cells(asked, [evaluated](const CsvGroup& group, const auto& parameter) {
    const auto value = evaluated ? group.value(evaluated->assessment, parameter) : std::nullopt;
    return value ? format_exact(*value) : std::string();
  });
}

}  // namespace axiometry::app
