// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/compensate/control_findings.h"

#include <fmt/format.h>

namespace axiometry::app {

std::vector<NamedFinding> findings_of_control(const nc::AxisTable& control, const nc::AxisTableOptions& options,
                                              const AxisCorrection& applied) {
  std::vector<NamedFinding> findings;
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
  return findings;
}

}  // namespace axiometry::app
