// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as the table of every control, after options of the first byte: read by the control's rule, or refused.
// What is read is a correction that is finite everywhere, and what is written of it is read again.
#include <cmath>

#include "axiometry/nc/axis_table.h"
#include "described.h"

using namespace axiometry;

namespace {

/// Eight ways of how a control counts, those that it has a use for.
nc::AxisTableOptions options_by(unsigned choice, const nc::AxisTable& table) {
  nc::AxisTableOptions options;
  options.kind = (choice & 1U) != 0 && table.limits.rotary ? AxisKind::rotary : AxisKind::linear;
  options.in_inch = (choice & 2U) != 0 && table.uses.inch;
  if ((choice & 4U) != 0) options.step = 10.0;
  if (table.uses.steps_per_unit) options.steps_per_unit = 80.0;
  return options;
}

void check_read(const nc::AxisTable& table, const nc::AxisTableOptions& options, std::string_view bytes) {
  const auto correction = table.read(bytes, options);
  if (!correction) return fuzzing::check_error(correction.error());
  for (const double position : {-1e9, -1.0, 0.0, 0.5, 1e9})
    for (const Direction direction : {Direction::up, Direction::down})
      AXIOMETRY_CONTRACT(std::isfinite(correction->at(position, direction)));
  const auto written = table.write(*correction, options);
  if (!written) return fuzzing::check_error(written.error());
  AXIOMETRY_CONTRACT(table.read(*written, options).has_value());
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes = fuzzing::as_text(data + 1, size - 1);
  for (const nc::AxisTable* table : nc::axis_table_table()) {
    if (table->recognises != nullptr) static_cast<void>(table->recognises(bytes));
    check_read(*table, options_by(data[0], *table), bytes);
  }
  return 0;
}
