// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/requirements.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

namespace axiometry::app {
namespace {

using iso230_2::AxisParameters;
using iso230_2::ParameterInfo;
using iso230_2::Tolerance;

/// Why a series lacks a parameter that others have.
std::string reason_for_absence(const Series& series, const ParameterInfo& parameter) {
  const bool up = series.has(Direction::up);
  const bool down = series.has(Direction::down);
  const bool of_up = parameter.symbol.ends_with("↑");
  const bool of_down = parameter.symbol.ends_with("↓");
  const bool lacks_direction = of_up ? !up : of_down ? !down : !(up && down);
  if (lacks_direction)
    return fmt::format("approaches from {} only ({})", up ? "below (↑)" : "above (↓)", parameter.clause);
  const bool repeated = series.run_count() > 1;
  return repeated ? fmt::format("no target with the approaches it needs ({})", parameter.clause)
                  : "a single approach to each target per direction (6.2)";
}

/// A limit that a user sets by hand for one test is meant for what that test has.
Result<void> check_existence(const std::vector<Tolerance>& tolerances, const Series& series,
                             const AxisParameters& measured) {
  for (const Tolerance& tolerance : tolerances) {
    const ParameterInfo& parameter = *tolerance.parameter;
    if (measured.*parameter.member) continue;
    std::vector<std::string_view> present;
    for (const ParameterInfo& p : iso230_2::parameters)
      if (measured.*p.member) present.push_back(p.key);
    return fail(fmt::format("found a tolerance of {} for a test with {}, where {} does not exist; expected one of {}",
                            parameter.key, reason_for_absence(series, parameter), parameter.key,
                            fmt::join(present, ", ")));
  }
  return {};
}

/// The limits of both, those of `over` in place of those below.
std::vector<Tolerance> overlaid(std::vector<Tolerance> below, const std::vector<Tolerance>& over) {
  for (const Tolerance& tolerance : over) {
    const auto same = std::ranges::find(below, tolerance.parameter, &Tolerance::parameter);
    if (same == below.end()) {
      below.push_back(tolerance);
    } else {
      *same = tolerance;
    }
  }
  return below;
}

/// "Grinder, up to 500 mm, in limits.csv, SHA-256 12ab…": without the folder, which no reader of a report knows.
std::string origin_of(const AppliedBand& band) {
  return fmt::format("{}, {}, in {}, SHA-256 {}", band.name, band.travel,
                     std::filesystem::path(band.file).filename().string(), band.sha256);
}

}  // namespace

Result<Requirements> requirements_for(const Test& test, const AxisParameters& measured,
                                      const ToleranceOptions& options) {
  const AxisKind kind = test.metadata.axis.kind;
  Requirements all;
  if (options.table) {
    const std::string& name = options.table_name.empty() ? test.metadata.tolerance.table : options.table_name;
    AXIOMETRY_TRY(const ToleranceBand* band, select_band(*options.table, name, kind, test.series));
    all.tolerances = band->limits;
    all.band = {options.table->file, options.table->sha256, band->name, band->travel_max, travel_text(*band)};
    for (Tolerance& tolerance : all.tolerances) tolerance.origin = origin_of(*all.band);
    if (band->rule) {
      AXIOMETRY_TRY(all.rule, rule_for(kind, *band->rule));
    }
  }
  all.tolerances = overlaid(std::move(all.tolerances), iso230_2::stated_tolerances(test.metadata));
  AXIOMETRY_TRY(const auto stated, stated_rule(test.metadata));
  if (stated) all.rule = *stated;
  AXIOMETRY_TRY(const auto given, tolerances_for(kind, options.limits));
  if (!options.many_tests) AXIOMETRY_TRY_VOID(check_existence(given, test.series, measured));
  all.tolerances = overlaid(std::move(all.tolerances), given);
  if (all.tolerances.empty()) all.tolerances = options.of_axis;
  if (options.rule) {
    AXIOMETRY_TRY(all.rule, rule_for(kind, *options.rule));
  }
  std::ranges::sort(all.tolerances, {}, &Tolerance::parameter);
  return all;
}

}  // namespace axiometry::app
