// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/compensations/fanuc_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/nc/compensations/increments.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc::fanuc {
namespace {

/// Data of one direction, less what is added at the reference point, from the point `first` on. A whole turn has the
/// number of its last point at the first one too.
Result<void> write_points(std::string& text, const AxisCorrection& correction, Direction direction, double at_reference,
                          long long first, const AxisTableOptions& options) {
  const double count = options.resolution * options.magnification;
  const std::string unit = fmt::format("times {} {}", trimmed_fixed(count, 6), deviation_unit(correction.kind()));
  const long long most = options.largest > 0 ? options.largest : largest_increment;
  std::vector<double> values = correction.values(direction);
  for (double& value : values) value -= at_reference;
  AXIOMETRY_TRY(
      const std::vector<long long> data,
      increments::of_curve(
          correction.positions(), values, count,
          {-most, most, unit,
           "a larger magnification, a smaller spacing, or 127 as largest number where the control takes more"}));
  if (is_whole_turn(correction)) fmt::format_to(std::back_inserter(text), "N{}P{}\n", 10'000 + first++, data.back());
  for (const long long increment : data)
    fmt::format_to(std::back_inserter(text), "N{}P{}\n", 10'000 + first++, increment);
  return {};
}

/// The control wants 3621 ≤ 3620 < 3622: a table beside the reference point goes on to it, and one beyond, with the
/// value of its end, which it holds there anyway.
Result<AxisCorrection> around_reference(const AxisCorrection& correction, double reference) {
  std::vector<double> positions = correction.positions();
  std::vector<double> up = correction.values(Direction::up), down = correction.values(Direction::down);
  const auto step = common_step(positions);
  if (!step || is_whole_turn(correction)) return correction;
  const auto steps = [&](double distance) {
    return static_cast<std::size_t>(std::clamp(std::llround(distance / *step), 0ll, 20'000ll));
  };
  const std::size_t before = steps(positions.front() - reference), behind = steps(reference + *step - positions.back());
  for (std::size_t k = 0; k < before; ++k) {
    positions.insert(positions.begin(), positions.front() - *step);
    up.insert(up.begin(), up.front());
    down.insert(down.begin(), down.front());
  }
  for (std::size_t k = 0; k < behind; ++k) {
    positions.push_back(positions.back() + *step);
    up.push_back(up.back());
    down.push_back(down.back());
  }
  return AxisCorrection::make(correction.kind(), std::move(positions), std::move(up), std::move(down));
}

}  // namespace

Result<std::string> write(const AxisCorrection& given, const AxisTableOptions& options, const AxisTable& table,
                          bool each_way) {
  AXIOMETRY_TRY(const AxisCorrection correction, around_reference(given, options.reference));
  AXIOMETRY_TRY_VOID(check_limits(correction, table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  AXIOMETRY_TRY_VOID(check_origin(correction, table, options.reference));
  if (options.largest > largest_of_any)
    return fail(fmt::format("found {} as the largest number, expected at most {}", options.largest, largest_of_any));
  const std::vector<double>& positions = correction.positions();
  const auto step = common_step(positions);
  AXIOMETRY_CONTRACT(step);  // check_limits()
  const bool turns = is_whole_turn(correction);
  if (turns && std::abs(positions.front() - options.reference) > 1e-6)
    return fail(fmt::format("found a turn from {}, expected it to begin at the reference point, {}",
                            format_rounded(positions.front()), format_rounded(options.reference)));

  const auto sections = static_cast<long long>(positions.size()) - 1;
  const long long before = std::llround((options.reference - positions.front()) / *step);
  const long long reference = options.number > 0 ? static_cast<long long>(options.number) : std::max(before, 0ll);
  const long long first = reference - before + (turns ? 0 : 1);
  const long long last = reference - before + sections;
  const long long end = each_way ? last + 1 + (last - first) : last;
  if (first < 0 || end > number_most)
    return fail(fmt::format("found points from {} to {}, expected 0 to {}: {} before the reference point, which is {}",
                            first, end, number_most, before, reference));

  const long long reversal = counts(correction.at(options.reference, Direction::down), options.resolution);
  constexpr long long reversal_most = 32'767;
  if (each_way && std::abs(reversal) > reversal_most)
    return fail(
        fmt::format("found {} detection units at the reference point in the negative direction, expected at most "
                    "{}",
                    reversal, reversal_most));
  std::string text = "%\n";
  AXIOMETRY_TRY_VOID(write_points(text, correction, Direction::up, 0.0, first, options));
  if (each_way)
    AXIOMETRY_TRY_VOID(write_points(text, correction, Direction::down,
                                    options.resolution * static_cast<double>(reversal), last + 1, options));
  fmt::format_to(
      std::back_inserter(text),
      "%\n({}{}, TO BE SET BY HAND)\n{}{})\n3605#0 = {}\n3620 = {}\n3621 = {}\n3622 = {}\n3623 = {}\n3624 = {}\n",
      options.axis, behind_axis, before_count, count_text(options), each_way ? 1 : 0, reference, first, last,
      options.magnification, trimmed_fixed(*step, 6));
  if (turns) text += "3625 = 360.0\n";
  if (each_way) fmt::format_to(std::back_inserter(text), "3626 = {}\n3627 = {}\n", last + 1, reversal);
  for (const std::string_view line : {sign, std::string_view("3624 is in mm or degrees. Choose the numbers so that no "
                                                             "other axis is overwritten.")})
    fmt::format_to(std::back_inserter(text), "({})\n", line);
  return text;
}

bool recognises(std::string_view text) {
  const std::vector<TableLine> lines = lines_of(text.substr(0, 256));
  return lines.size() > 1 && lines[0].text == "%" && lines[1].text.starts_with("N1") &&
         lines[1].text.find('P') == std::min<std::size_t>(6, lines[1].text.size());
}

}  // namespace axiometry::nc::fanuc
