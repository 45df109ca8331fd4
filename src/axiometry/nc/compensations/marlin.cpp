// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/nc/compensations/step_settings.h"

namespace axiometry::nc {

extern const AxisTable marlin_axis_table;

namespace marlin {
namespace {

Result<steps::Spelling> spelling(const AxisTableOptions& options) {
  AXIOMETRY_TRY([[maybe_unused]] const unsigned axis, steps::axis_number(options, 6));
  return steps::Spelling{";", fmt::format("M92 {}", options.axis), fmt::format("M425 F1 {}", options.axis), {"M500"}};
}

}  // namespace
}  // namespace marlin

const AxisTable marlin_axis_table = {
    .id = "marlin",
    .title = "Marlin, M92 and M425",
    .extension = ".gcode",
    .curves = TableCurves::with_backlash,
    .limits = {.points = 2},
    .uses = {.steps_per_unit = true, .inch = false},
    .sign = steps::sign,
    .loading =
        "Send the lines in mm (G21); M500 keeps them. M425 is there only when the firmware is built with "
        "BACKLASH_COMPENSATION and BACKLASH_GCODE. The steps per unit are what M92 says now.",
    .verified =
        "M425 with a backlash in mm for each axis and F as the share of it: the change that brought the command.",
    .inferred = steps::inferred,
    .write = [](const AxisCorrection& correction, const AxisTableOptions& options) -> Result<std::string> {
      AXIOMETRY_TRY(const steps::Spelling spelling, marlin::spelling(options));
      return steps::write(correction, options, marlin_axis_table, spelling);
    },
    .read = [](std::string_view text, const AxisTableOptions& options) -> Result<AxisCorrection> {
      AXIOMETRY_TRY(const steps::Spelling spelling, marlin::spelling(options));
      return steps::read(text, options, spelling);
    },
    .recognises = [](std::string_view text) { return text.substr(0, 1024).find("\nM425 F") != text.npos; },
};

}  // namespace axiometry::nc
