// SPDX-License-Identifier: Apache-2.0
//
// Leadscrew compensation of Haas controls (1999): entries half an inch apart, the first at machine zero, then in the
// negative direction, in 0.0001 inch.
#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable haas_axis_table;

namespace haas {
namespace {

constexpr double entry_um = 2.54;
constexpr double spacing_mm = 12.7;
constexpr double encoder_steps_most = 127.0;

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, haas_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  AXIOMETRY_TRY_VOID(check_origin(correction, haas_axis_table, options.reference));
  std::string text =
      fmt::format("; {}: entry, 0.0001 inch; entry 1 is at machine zero, each half an inch further down\n",
                  options.axis) +
      comment_lines(";", sign_of(haas_axis_table, options));
  const std::vector<double>& values = correction.values(Direction::up);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double value = values[values.size() - 1 - k];
    if (std::abs(value) / options.resolution > encoder_steps_most)
      return fail(fmt::format("found a correction of {:.1f} um, expected at most {} encoder steps of {} um", value,
                              encoder_steps_most, trimmed_fixed(options.resolution, 6)));
    fmt::format_to(std::back_inserter(text), "{} {}\n", k + 1, counts(value, entry_um));
  }
  return text;
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options) {
  std::vector<double> downwards;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text.substr(0, line.text.find(';')));
    if (line.text.empty()) continue;
    const auto words = text::words(line.text);
    const auto number = words.size() == 2 ? whole_number(words[0]) : std::nullopt;
    const auto value = words.size() == 2 ? whole_number(words[1]) : std::nullopt;
    if (!value || number != std::ssize(downwards) + 1 || number > static_cast<long long>(haas_axis_table.limits.points))
      return refused(line, fmt::format("entry {} and a whole number, at most {} entries", downwards.size() + 1,
                                       haas_axis_table.limits.points));
    downwards.push_back(static_cast<double>(*value) * entry_um);
  }
  if (!downwards.empty() && downwards.front() != 0.0)
    return fail("found an entry at machine zero that is not 0, expected 0");
  const double first = options.reference - spacing_mm * (static_cast<double>(downwards.size()) - 1.0);
  std::vector<double> up(downwards.rbegin(), downwards.rend());
  std::vector<double> down = up;
  return even_correction(options.kind, first, spacing_mm, std::move(up), std::move(down));
}

}  // namespace
}  // namespace haas

const AxisTable haas_axis_table = {
    .id = "haas",
    .title = "Haas (1999), leadscrew compensation",
    .extension = ".txt",
    .curves = TableCurves::both_ways,
    .limits = {.points = 256,
               .equidistant = true,
               .step_native = haas::spacing_mm,
               .origin = TableOrigin::last,
               .rotary = false},
    .uses = {.resolution = true, .turned_sign = true, .inch = false},
    .sign = "A positive number moves the axis in the positive direction: it is added (inferred).",
    .loading =
        "Enter the numbers on the page of the axis' leadscrew compensation, which the maker's settings unlock, and "
        "home the axis. One count is one encoder step, of which an entry holds at most 127.",
    .verified =
        "Half an inch between entries, 0.0001 inch, the first entry at machine zero and the others in the negative "
        "direction, 127 encoder steps, 256 entries inside: the manual of 1999.",
    .inferred = "The sign. A re-test after entering it tells it. It is a list to enter by hand. How it is loaded.",
    .turned_sign =
        "A positive number moves the axis in the negative direction: it is taken off (turned against what was "
        "inferred).",
    .write = haas::write,
    .read = haas::read,
    .recognises =
        [](std::string_view text) {
          return text.starts_with("; ") && text.substr(0, 64).find(": entry, 0.0001 inch") != text.npos;
        },
};

}  // namespace axiometry::nc
