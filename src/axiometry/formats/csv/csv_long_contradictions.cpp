// SPDX-License-Identifier: Apache-2.0
//
// What columns of a long CSV file say against one another.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/csv/csv_long_rows.h"
#include "axiometry/formats/series/sweep_directions.h"
#include "axiometry/model/swapped_labels.h"

namespace axiometry::formats {
namespace {

/// One in the last digit of a number as it is written, in native units of deviations.
double last_digit(std::string_view number, const ReadingRule& rule) {
  const std::size_t point = number.find_first_of(".,");
  const auto decimals = point == std::string_view::npos ? 0.0 : static_cast<double>(number.size() - point - 1);
  const auto step = native_deviation(rule, Position::native(0.0), std::pow(10.0, -decimals));
  return step ? std::abs(*step) : 0.0;
}

}  // namespace

void LongRows::compare_with_position(const std::vector<CsvCell>& cells, Position target, double deviation) {
  if (!layout_.beside || *layout_.beside >= cells.size()) return;
  const CsvCell& cell = cells[*layout_.beside];
  const auto number = numbers_.read(cell.text, {line_, cell.column});
  if (!number) return;
  const auto from_position = native_deviation(layout_.rule_beside, target, *number);
  if (!from_position) return;
  Comparison& c = comparison_;
  ++c.count;
  c.apart = std::max(c.apart, std::abs(deviation - *from_position));
  c.mirrored = std::max(c.mirrored, std::abs(deviation + *from_position));
  c.largest = std::max(c.largest, std::abs(deviation));
  c.last_digits = std::max(c.last_digits, last_digit(cells[layout_.reading].text, layout_.rule) +
                                              last_digit(cell.text, layout_.rule_beside));
}

// Columns that contradict one another: the sign is refused, since every parameter with one would be wrong; what a
// program may have taken out is told.
Result<void> LongRows::check_comparison(TextPosition at) {
  const Comparison c = std::exchange(comparison_, {});
  if (c.count == 0 || c.apart <= c.last_digits) return {};
  const std::string& position = preamble_.columns[*layout_.beside].name;
  const std::string& deviation = preamble_.columns[layout_.reading].name;
  if (c.mirrored <= c.last_digits && c.largest > c.last_digits)
    return fail(fmt::format("found in the column {} target minus {}, expected measured minus target; read as the "
                            "format generic its sign is turned",
                            text::quoted(deviation), text::quoted(position)),
                at);
  remarks_.push_back(
      {false, fmt::format("the deviations in the column {} are not {} minus target: they differ by up "
                          "to {:.4g} {}; a gain or an offset may have been taken out, or they are "
                          "corrected",
                          text::quoted(deviation), text::quoted(position), c.apart, deviation_unit(layout_.kind))});
  return {};
}

// Measured positions rise with their targets, or fall where the scale is turned. Numbers that do neither are
// deviations, and would be read as errors as large as the travel.
Result<void> LongRows::check_positions(TextPosition at) const {
  constexpr double least_slope = 0.1;
  const double per_position = deviation_per_position(layout_.kind);
  const auto count = static_cast<double>(readings_.size());
  double middle = 0.0;
  for (const RowReading& row : readings_) middle += targets_.targets()[row.target] / count;
  double products = 0.0;
  double squares = 0.0;
  for (const RowReading& row : readings_) {
    const double target = targets_.targets()[row.target];
    products += (target - middle) * (target + row.deviation / per_position);
    squares += (target - middle) * (target - middle);
  }
  if (std::abs(products) >= least_slope * squares) return {};
  return fail(fmt::format("found in the column {} numbers that do not follow the targets, expected measured positions; "
                          "deviations are named so, as in deviation_um or deviation_arcsec",
                          text::quoted(preamble_.columns[layout_.reading].name)),
              at);
}

/// Labels ↑ and ↓ against the way the targets run, where rows stand in the order of the measurement.
void LongRows::remark_swapped_labels() {
  constexpr double most = 0.9;
  std::vector<std::uint32_t> ranks;
  for (const RowReading& row : readings_) ranks.push_back(targets_.ranks()[row.target]);
  const generic::Motion motion = generic::motion_of(ranks, targets_.targets().size());
  if (!motion.is_sweeps || !motion.has_up || !motion.has_down) return;
  std::size_t against = 0;
  for (std::size_t k = 0; k < readings_.size(); ++k)
    against += static_cast<Direction>(readings_[k].direction) != motion.directions[k];
  if (static_cast<double>(against) < most * static_cast<double>(readings_.size())) return;
  remarks_.push_back(swapped_labels_remark());
}

}  // namespace axiometry::formats
