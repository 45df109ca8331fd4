// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compensate/control_findings.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <utility>

#include "axiometry/base/text/rounded_text.h"

namespace axiometry::app {
namespace {

/// Of a control that counts: without the size of a count the numbers of its table are worth nothing, and the usual one
/// of a linear axis in mm, 1 µm, is that of no control in degrees or inches.
NamedFinding finding_of_count(const nc::AxisTableOptions& options, bool was_read) {
  constexpr std::string_view wrong = "where it is another amount, all that the table does is wrong in that proportion";
  if (options.kind == AxisKind::rotary)
    return {
        "compensation-count-assumed", true,
        fmt::format("one count of the control is taken for 1 ″, and many controls count in 0.001° (3.6 ″): {}", wrong)};
  if (options.in_inch)
    return {"compensation-count-assumed", true,
            fmt::format("one count of the control is taken for 1 µm, and many controls in inches count in 0.0001 inch "
                        "(2.54 µm): {}",
                        wrong)};
  if (was_read)
    return {"compensation-count-assumed", true,
            fmt::format("one count of the control is taken for 1 µm, in the table that was active too: {}", wrong)};
  return {"compensation-count-assumed", false, fmt::format("one count of the control is taken for 1 µm: {}", wrong)};
}

/// Of a table that rolls over: what it does beyond its ends nobody expects. Round a turn it has none.
std::optional<NamedFinding> finding_of_ends(const AxisCorrection& applied) {
  const std::vector<double>& positions = applied.positions();
  if (positions.size() < 2) return std::nullopt;
  const double low = positions.front(), high = positions.back(), step = positions[1] - low;
  if (applied.kind() == AxisKind::rotary && high - low + step > 360.0 - 1e-6) return std::nullopt;
  const std::string_view unit = position_unit(applied.kind());
  return NamedFinding{
      "compensation-rolls-over", false,
      fmt::format("beyond {} to {} {} the control does not hold the last value: over the next {} {} it goes on to that "
                  "of the other end",
                  format_rounded(low), format_rounded(high), unit, format_rounded(step), unit)};
}

}  // namespace

std::vector<NamedFinding> findings_of_control(const nc::AxisTable& control, const nc::AxisTableOptions& options,
                                              const AxisCorrection& applied, const CountStanding& count) {
  std::vector<NamedFinding> findings;
  if (control.uses.resolution && !count.said && options.resolution == nc::AxisTableOptions{}.resolution)
    findings.push_back(finding_of_count(options, count.was_read));
  if (options.turned_sign)
    findings.push_back({"compensation-sign-turned", false,
                        fmt::format("the sign is turned against what was inferred of {}: only a re-test tells whether "
                                    "this is the one of the control",
                                    control.title)});
  const double backlash = applied.values(Direction::up).front() - applied.values(Direction::down).front();
  if (!control.backlash.empty() && backlash != 0.0)
    findings.push_back(
        {"compensation-number-beside", false,
         fmt::format("beside the table {} must be what it was while the axis was measured and {:.3f} {} added: the "
                     "prediction counts on it, and no control reads it from the file",
                     control.backlash, backlash, deviation_unit(options.kind))});
  if (control.uses.steps_per_unit && options.steps_per_unit == 0.0)
    findings.push_back({"compensation-scale-left-out", false,
                        "nobody tells the steps per unit of the control: the scale is in the file as a comment alone, "
                        "and what is predicted is of the backlash"});
  if (control.limits.rolls_over)
    if (auto ends = finding_of_ends(applied)) findings.push_back(*std::move(ends));
  return findings;
}

}  // namespace axiometry::app
