// SPDX-License-Identifier: Apache-2.0
//
// The rule of the control (emc/usr_intf/… and emc/motion of LinuxCNC): three numbers a line, reading ends without a
// word at the first line that is not; nominal positions must grow; a trim is added to the command of the joint.
#include "axiometry/nc/compensations/linuxcnc_lines.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>
#include <vector>

#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc::linuxcnc {

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options, const AxisTable& table,
                          Type type) {
  AXIOMETRY_TRY_VOID(check_limits(correction, table));
  const double unit = position_per_unit(options), per_deviation = unit_per_deviation(options);
  const int decimals = table_decimals(options);
  std::string text;
  for (std::size_t k = 0; k < correction.positions().size(); ++k) {
    const double nominal = correction.positions()[k] / unit;
    const double forward = correction.values(Direction::up)[k] * per_deviation;
    const double reverse = correction.values(Direction::down)[k] * per_deviation;
    // Type 0: where the axis really was when it should have been at the nominal position, before it is corrected.
    const bool as_positions = type == Type::positions;
    fmt::format_to(std::back_inserter(text), "{} {} {}\n", fixed_number(nominal, decimals),
                   fixed_number(as_positions ? nominal - forward : forward, decimals),
                   fixed_number(as_positions ? nominal - reverse : reverse, decimals));
  }
  return text;
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options, Type type) {
  constexpr std::size_t longest_line = 254;
  std::vector<double> positions, up, down;
  for (const TableLine& line : lines_of(text)) {
    const auto numbers = line.text.size() > longest_line ? std::nullopt : numbers_of(line.text);
    if (!numbers || numbers->size() < 3)
      return fail(
          "found a line that is not three numbers, where LinuxCNC ends reading without a word, expected "
          "NOMINAL FORWARD REVERSE",
          {line.number, 0});
    if (positions.size() == points_most)
      return fail(fmt::format("found more than {} positions, expected at most so many", points_most), {line.number, 0});
    const double nominal = (*numbers)[0];
    const auto trim = [&](double number) {
      return static_cast<double>(static_cast<float>(type == Type::positions ? nominal - number : number));
    };
    positions.push_back(nominal * position_per_unit(options));
    up.push_back(trim((*numbers)[1]) / unit_per_deviation(options));
    down.push_back(trim((*numbers)[2]) / unit_per_deviation(options));
    if (positions.size() > 1 && !(positions.back() > positions[positions.size() - 2]))
      return fail("found a nominal position that is not above the one before, which LinuxCNC refuses",
                  {line.number, 0});
  }
  return AxisCorrection::make(options.kind, std::move(positions), std::move(up), std::move(down));
}

}  // namespace axiometry::nc::linuxcnc
