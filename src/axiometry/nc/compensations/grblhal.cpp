// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/nc/compensations/step_settings.h"

namespace axiometry::nc {

extern const AxisTable grblhal_axis_table;

namespace grblhal {
namespace {

Result<steps::Spelling> spelling(const AxisTableOptions& options) {
  AXIOMETRY_TRY(const unsigned axis, steps::axis_number(options, 6));
  return steps::Spelling{";", fmt::format("${}=", 100 + axis), fmt::format("${}=", 160 + axis), {}};
}

}  // namespace
}  // namespace grblhal

const AxisTable grblhal_axis_table = {
    .id = "grblhal",
    .title = "grblHAL, steps per unit and backlash",
    .extension = ".txt",
    .curves = TableCurves::with_backlash,
    .limits = {.points = 2},
    .uses = {.steps_per_unit = true, .inch = false},
    .sign = steps::sign,
    .loading =
        "Send the lines to the control, or enter them in the sender's settings; home the axis. Backlash is there only "
        "when the firmware is built with it. The steps per unit are what the setting 100 and on says now. grbl itself "
        "has no backlash: take the steps alone.",
    .verified =
        "The numbers of the settings, that there is no table, and that the backlash is an option of the build: "
        "sources.",
    .inferred = steps::inferred,
    .write = [](const AxisCorrection& correction, const AxisTableOptions& options) -> Result<std::string> {
      AXIOMETRY_TRY(const steps::Spelling spelling, grblhal::spelling(options));
      return steps::write(correction, options, grblhal_axis_table, spelling);
    },
    .read = [](std::string_view text, const AxisTableOptions& options) -> Result<AxisCorrection> {
      AXIOMETRY_TRY(const steps::Spelling spelling, grblhal::spelling(options));
      return steps::read(text, options, spelling);
    },
};

}  // namespace axiometry::nc
