// SPDX-License-Identifier: Apache-2.0
//
// A table of lengths or a continuous recording of them?
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recording.h"
#include "axiometry/formats/recordings/time_text.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/table_heads.h"
#include "axiometry/formats/tracking/tracking_lengths_csv.h"

namespace axiometry::formats {
namespace {

constexpr std::size_t steps_to_judge = 64;
constexpr double dwell_share = 0.25;
constexpr double least_step_s = 0.1;  // where the plan has no dwell

/// What the header of a table says, and the times of the first rows below it.
struct HeadOfLengths {
  bool has_header = false;
  bool lengths = false;
  bool lines = false;
  std::optional<std::size_t> time;
  std::vector<double> times_s;
};

std::optional<double> seconds_of(std::string_view cell, double unit_s) {
  if (const auto stamp_ns = parse_time_stamp(cell)) return static_cast<double>(*stamp_ns) * 1e-9;
  const auto number = parse_number(cell);
  return number ? std::optional(*number * unit_s) : std::nullopt;
}

HeadOfLengths head_of(std::string_view text) {
  HeadOfLengths head;
  char delimiter = ',';
  double unit_s = 1.0;
  static_cast<void>(for_table_lines(text, [&](const TableLine& line) -> Result<void> {
    if (line.content.starts_with('#') || line.content.starts_with('%')) return {};
    const auto cells = split_row(line.text, head.has_header ? delimiter : delimiter_of(line.text), line.number);
    if (!cells) return fail("no row");
    if (!head.has_header) {
      head.has_header = true;
      delimiter = delimiter_of(line.text);
      for (std::size_t k = 0; k < cells->size(); ++k) {
        const TableHead named = table_head((*cells)[k].text);
        head.lengths = head.lengths || named.name == "length" || is_length_difference(named.name);
        head.lines = head.lines || named.name == "line";
        if (head.time || !(named.name.starts_with("time") || named.name == "t" || named.name == "zeit")) continue;
        head.time = k;
        const std::string_view unit =
            named.unit.empty() ? std::string_view(named.name).substr(named.name.rfind(' ') + 1) : named.unit;
        unit_s = seconds_per_unit(unit).value_or(1.0);
      }
      return {};
    }
    if (!head.time || *head.time >= cells->size() || head.times_s.size() > steps_to_judge) return fail("enough");
    if (const auto time = seconds_of((*cells)[*head.time].text, unit_s)) head.times_s.push_back(*time);
    return {};
  }));
  return head;
}

/// NaN where fewer than two rows have one.
double usual_step_s(const std::vector<double>& times_s) {
  std::vector<double> steps;
  for (std::size_t k = 1; k < times_s.size(); ++k) steps.push_back(times_s[k] - times_s[k - 1]);
  if (steps.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::ranges::nth_element(steps, middle);
  return *middle;
}

}  // namespace

bool is_length_recording(std::string_view bytes, const TrackingPlan& plan) {
  if (!recognise_recording(bytes)) return false;
  const auto decoded = decoded_text(bytes);
  if (!decoded) return true;
  const HeadOfLengths head = head_of(decoded->text);
  if (!head.lengths) return true;
  if (head.lines || !head.time) return false;
  double dwell_s = std::numeric_limits<double>::infinity();
  for (const TrackingLine& line : plan.lines) dwell_s = std::min(dwell_s, line.plan.dwell.in_s());
  return usual_step_s(head.times_s) < std::max(least_step_s, dwell_share * dwell_s);
}

}  // namespace axiometry::formats
