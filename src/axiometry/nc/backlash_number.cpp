// SPDX-License-Identifier: Apache-2.0
//
// The number for the reversal beside a table of one curve, which stands in the file as a comment (table_text.h).
#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {
namespace {

/// What stands before the number beside a table.
std::string backlash_words(std::string_view mark, const AxisTable& table) {
  return fmt::format("{} {} = its value while the axis was measured + ", mark, table.backlash);
}

}  // namespace

Result<double> backlash_of(const AxisCorrection& correction) {
  constexpr double slack = 1e-6;  // µm or ″: what differences of doubles leave
  const std::vector<double>&up = correction.values(Direction::up), &down = correction.values(Direction::down);
  const double backlash = up.front() - down.front();
  const std::string_view unit = deviation_unit(correction.kind());
  for (std::size_t k = 0; k < up.size(); ++k)
    if (std::abs(up[k] - down[k] - backlash) > slack)
      return fail(fmt::format("found a backlash of {:.3f} and one of {:.3f} {}, expected the same everywhere", backlash,
                              up[k] - down[k], unit));
  return std::abs(backlash) <= slack ? 0.0 : backlash;
}

std::string backlash_line(std::string_view mark, const AxisTable& table, double backlash,
                          const AxisTableOptions& options) {
  return fmt::format("{}{}\n", backlash_words(mark, table),
                     fixed_number(backlash * unit_per_deviation(options), table_decimals(options)));
}

Result<double> backlash_in(std::string_view text, std::string_view mark, const AxisTable& table,
                           const AxisTableOptions& options) {
  const std::string beginning = backlash_words(mark, table);
  std::optional<double> found;
  for (const TableLine& line : lines_of(text)) {
    if (!line.text.starts_with(beginning)) continue;
    const auto number = parse_number(text::trim(line.text.substr(beginning.size())));
    if (found || !number) return refused(line, "one backlash, a number");
    found = *number / unit_per_deviation(options);
  }
  return found.value_or(0.0);
}

}  // namespace axiometry::nc
