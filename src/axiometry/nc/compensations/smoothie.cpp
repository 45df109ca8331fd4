// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/nc/compensations/step_settings.h"

namespace axiometry::nc {

extern const AxisTable smoothie_axis_table;

namespace smoothie {
namespace {

Result<steps::Spelling> spelling(const AxisTableOptions& options) {
  AXIOMETRY_TRY(const unsigned axis, steps::axis_number(options, 3));
  constexpr std::string_view names[] = {"alpha", "beta", "gamma"};
  return steps::Spelling{"#",
                         fmt::format("{}_steps_per_mm ", names[axis]),
                         fmt::format("{}_backlash_mm ", names[axis]),
                         {"backlash_enable true"}};
}

}  // namespace
}  // namespace smoothie

const AxisTable smoothie_axis_table = {
    .id = "smoothie",
    .title = "Smoothieware, steps per mm and backlash",
    .extension = ".txt",
    .curves = TableCurves::with_backlash,
    .limits = {.points = 2, .rotary = false},
    .uses = {.steps_per_unit = true, .inch = false},
    .sign = steps::sign,
    .loading =
        "Put the lines in the file config in place of those that are there, and reset the control. Backlash is there "
        "only when the firmware is built with BACKLASH=1. The steps per unit are what the file says now.",
    .verified =
        "The settings of the backlash, and that it is an option of the build: the change that brings it (pull request "
        "1543, open).",
    .inferred = steps::inferred,
    .write = [](const AxisCorrection& correction, const AxisTableOptions& options) -> Result<std::string> {
      AXIOMETRY_TRY(const steps::Spelling spelling, smoothie::spelling(options));
      return steps::write(correction, options, smoothie_axis_table, spelling);
    },
    .read = [](std::string_view text, const AxisTableOptions& options) -> Result<AxisCorrection> {
      AXIOMETRY_TRY(const steps::Spelling spelling, smoothie::spelling(options));
      return steps::read(text, options, spelling);
    },
    .recognises = [](std::string_view text) { return text.substr(0, 1024).find("_backlash_mm ") != text.npos; },
};

}  // namespace axiometry::nc
