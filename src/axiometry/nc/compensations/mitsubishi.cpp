// SPDX-License-Identifier: Apache-2.0
//
// Memory type pitch error compensation of MELDAS, incremental: (spacing − actual move) × 2 on the positive side of the
// reference point, (spacing + actual move) × 2 on the negative one, where the move is negative. Both are twice what the
// correction grows by from the more negative point to the other.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/compensations/increments.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable mitsubishi_axis_table;

namespace mitsubishi {
namespace {

constexpr std::string_view sign =
    "A positive number moves the axis in the positive direction, on its way from the point before to its own, by half "
    "of "
    "so many output units.";
constexpr long long first_number = 4101, last_number = 5124, lowest = -128, highest = 127;

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, mitsubishi_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  AXIOMETRY_TRY_VOID(check_origin(correction, mitsubishi_axis_table, options.reference));
  const auto step = common_step(correction.positions());
  AXIOMETRY_CONTRACT(step);  // check_limits()
  if (is_whole_turn(correction) && std::abs(correction.positions().front() - options.reference) > 1e-6)
    return fail(fmt::format("found a turn from {}, expected it to begin at the reference point",
                            format_rounded(correction.positions().front())));
  const double count = 0.5 * options.resolution * options.magnification;
  const std::string unit = fmt::format("times {} {}", trimmed_fixed(count, 6), deviation_unit(options.kind));
  AXIOMETRY_TRY(const std::vector<long long> data,
                increments::of_curve(correction.positions(), correction.values(Direction::up), count,
                                     {lowest, highest, unit, "a larger magnification or a smaller spacing"}));
  const long long before = std::llround((options.reference - correction.positions().front()) / *step);
  const long long reference =
      options.number > 0 ? static_cast<long long>(options.number) : first_number - 1 + std::max(before, 0ll);
  const long long first = reference - before + 1, last = reference - before + std::ssize(data);
  if (first < first_number || last > last_number)
    return fail(fmt::format("found points from {} to {}, expected {} to {}", first, last, first_number, last_number));
  std::string text;
  fmt::format_to(std::back_inserter(text),
                 "#4001 {0}\n#4002 {0}\n#4003 {1}\n#4004 {2}\n#4005 {3}\n#4006 {4}\n#4007 {5}\n", options.axis,
                 reference, first, last, options.magnification, trimmed_fixed(*step / position_per_unit(options), 9));
  for (std::size_t k = 0; k < data.size(); ++k)
    fmt::format_to(std::back_inserter(text), "#{} {}\n", first + static_cast<long long>(k), data[k]);
  return text;
}

struct Sheet {
  std::map<long long, double> settings;
  std::map<long long, long long> points;
};

Result<Sheet> sheet_of(std::string_view text, AxisTableOptions options) {
  Sheet sheet;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text);
    if (line.text.empty()) continue;
    const std::vector<std::string_view> words = text::words(line.text);
    const auto number =
        words.size() == 2 && words[0].starts_with('#') ? whole_number(words[0].substr(1)) : std::nullopt;
    if (!number) return refused(line, "#NUMBER VALUE");
    if (*number == 4001 || *number == 4002) {
      if (!is_axis_named(words[1], options)) return refused(line, fmt::format("the axis {}", options.axis));
      continue;
    }
    if (*number >= 4003 && *number <= 4007) {
      const auto value = parse_number(words[1]);
      if (!value || !sheet.settings.emplace(*number, *value).second) return refused(line, "a number, once");
      continue;
    }
    const auto value = whole_number(words[1]);
    if (*number < first_number || *number > last_number || !value || *value < lowest || *value > highest)
      return refused(line, "#4101 to #5124 with a number of -128 to 127");
    if (!sheet.points.emplace(*number, *value).second) return refused(line, "each point once");
  }
  for (long long setting = 4003; setting <= 4007; ++setting)
    if (!sheet.settings.contains(setting)) return fail(fmt::format("found no #{}, expected #4003 to #4007", setting));
  return sheet;
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  AXIOMETRY_TRY(const Sheet sheet, sheet_of(text, options));
  const auto whole = [&](long long setting) { return std::llround(std::clamp(sheet.settings.at(setting), 0.0, 1e6)); };
  const long long reference = whole(4003), first = whole(4004), last = whole(4005);
  const double step = sheet.settings.at(4007) * position_per_unit(options);
  if (!(step > 0.0)) return fail("found a spacing (#4007) that is not above 0");
  if (last < first || last - first + 1 != std::ssize(sheet.points))
    return fail(fmt::format("found {} points, expected those from {} to {}", sheet.points.size(), first, last));
  const double half = options.resolution * sheet.settings.at(4006) / 2.0;
  std::vector<double> sums{0.0};
  for (long long n = first; n <= last; ++n) {
    const auto point = sheet.points.find(n);
    if (point == sheet.points.end()) return fail(fmt::format("found no point #{}, expected all without a gap", n));
    sums.push_back(sums.back() + half * static_cast<double>(point->second));
  }
  const long long origin = std::clamp<long long>(reference - first + 1, 0, std::ssize(sums) - 1);
  const double there = sums[static_cast<std::size_t>(origin)];
  for (double& sum : sums) sum -= there;
  std::vector<double> down = sums;
  return even_correction(options.kind, options.reference + step * static_cast<double>(first - 1 - reference), step,
                         std::move(sums), std::move(down));
}

}  // namespace
}  // namespace mitsubishi

const AxisTable mitsubishi_axis_table = {
    .id = "mitsubishi",
    .title = "Mitsubishi MELDAS C64, E68, incremental pitch errors",
    .extension = ".txt",
    .curves = TableCurves::both_ways,
    .limits = {.points = 1024, .equidistant = true, .origin = TableOrigin::on_grid, .closes = true},
    .uses = {.number = true, .resolution = true, .magnification = true},
    .sign = mitsubishi::sign,
    .loading =
        "Enter the numbers in the parameters for axis compensation, incremental system, and switch the control off and "
        "on. One count is the output unit; the number is #4003, so that no other axis is overwritten.",
    .verified =
        "The formulas of both sides, twice the difference in output units, -128 to 127: manuals of C64 and E68.",
    .inferred =
        "The numbers of the parameters, that a point's number is used from the point before to it, and that #4006 "
        "multiplies. It is a list to enter by hand; the layout of a parameter file was not seen. How it is loaded.",
    .write = mitsubishi::write,
    .read = mitsubishi::read,
    .recognises = [](std::string_view text) { return text.starts_with("#4001 "); },
};

}  // namespace axiometry::nc
