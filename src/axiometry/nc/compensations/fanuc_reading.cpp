// SPDX-License-Identifier: Apache-2.0
//
// The rule of the control, from the file alone: from the point before to its own each point adds its number times the
// magnification, in detection units; at the reference point the sum is 0, for the negative direction parameter 3627.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/compensations/fanuc_points.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc::fanuc {
namespace {

struct Tape {
  std::map<long long, long long> points;
  std::map<long long, double> parameters;

  double parameter(long long number, double otherwise) const {
    const auto found = parameters.find(number);
    return found == parameters.end() ? otherwise : found->second;
  }
  bool has(long long number) const { return parameters.contains(number); }
};

Result<void> take_point(const TableLine& line, Tape& tape) {
  constexpr std::string_view expected = "N10000+POINT P NUMBER, a number of -127 to 127";
  std::string_view rest = line.text;
  if (!rest.starts_with('N')) return refused(line, expected);
  const std::size_t value = rest.find('P');
  if (value == std::string_view::npos) return refused(line, expected);
  std::string_view name = rest.substr(1, value - 1);
  if (name.ends_with("Q0")) name.remove_suffix(2);
  const auto number = whole_number(name), data = whole_number(rest.substr(value + 1));
  if (!number || *number < 10'000 || *number > 10'000 + number_most || !data ||
      std::abs(*data) > static_cast<long long>(largest_of_any))
    return refused(line, expected);
  if (!tape.points.emplace(*number - 10'000, *data).second) return refused(line, "each point once");
  return {};
}

/// Of what a comment says is held against the options what they say too: the axis, and what one count is.
Result<void> check_comment(const TableLine& line, AxisTableOptions& options) {
  if (const std::size_t behind = line.text.find(behind_axis); behind != std::string_view::npos)
    return check_axis_named(text::trim(line.text.substr(1, behind - 1)), options, line);
  if (!line.text.starts_with(before_count)) return {};
  std::string_view count = line.text.substr(before_count.size());
  if (count.ends_with(')')) count.remove_suffix(1);
  return check_count_text(count, options, line);
}

Result<void> take_parameter(const TableLine& line, AxisTableOptions& options, Tape& tape) {
  if (line.text.starts_with('(')) return check_comment(line, options);
  constexpr std::string_view expected = "PARAMETER = NUMBER, or a comment in brackets";
  const auto a = assignment_of(line.text);
  const auto number = a ? whole_number(a->name.substr(0, a->name.find("#0"))) : std::nullopt;
  const auto value = a ? parse_number(a->value) : std::nullopt;
  if (!number || !value || std::abs(*value) > 1e6) return refused(line, expected);
  if (*number != 3605 && (*number < 3620 || *number > 3627)) return refused(line, "a parameter of 3605, 3620 to 3627");
  if (!tape.parameters.emplace(*number, *value).second) return refused(line, "each parameter once");
  return {};
}

/// The axis and the count that its comments say are those of the options where nobody told them.
Result<Tape> tape_of(std::string_view text, AxisTableOptions& options) {
  Tape tape;
  int percents = 0;
  for (TableLine line : lines_of(text)) {
    line.text = text::trim(line.text);
    if (line.text.empty()) continue;
    if (line.text == "%")
      ++percents;
    else if (percents == 1)
      AXIOMETRY_TRY_VOID(take_point(line, tape));
    else if (percents == 2)
      AXIOMETRY_TRY_VOID(take_parameter(line, options, tape));
    else
      return refused(line, "% before and behind the points");
    if (percents > 2) return refused(line, "% before and behind the points, no more");
  }
  if (percents != 2) return fail(fmt::format("found {} lines of %, expected one before and one behind", percents));
  return tape;
}

struct Frame {
  long long reference = 0, first = 0, last = 0, first_downwards = 0;
  double step = 0.0, count = 0.0, detection_unit = 0.0;
  bool turns = false;
};

Result<Frame> frame_of(const Tape& tape, const AxisTableOptions& options, bool each_way) {
  if (!tape.parameters.empty())
    for (long long number = 3620; number <= 3624; ++number)
      if (!tape.has(number)) return fail(fmt::format("found no parameter {}, expected 3620 to 3624", number));
  Frame f;
  f.turns = tape.has(3625);
  f.step = tape.parameter(3624, options.step);
  if (!(f.step > 0.0))
    return fail("found no spacing, expected parameter 3624 behind the points, or a step beside them");
  if (tape.points.empty()) return fail("found no point, expected at least one");
  f.detection_unit = options.resolution;
  f.count = options.resolution * tape.parameter(3623, options.magnification);
  f.first = std::llround(tape.parameter(3621, static_cast<double>(tape.points.begin()->first)));
  f.last = std::llround(tape.parameter(3622, static_cast<double>(tape.points.rbegin()->first)));
  f.reference = std::llround(tape.parameter(3620, options.number));
  if (f.turns && (tape.parameter(3625, 0.0) != 360.0 || f.reference != f.first ||
                  std::abs(f.step * static_cast<double>(f.last - f.first) - 360.0) > 1e-6))
    return fail("found a turn whose points do not lead from the reference point once round, expected them to");
  if ((tape.parameter(3605, each_way ? 1.0 : 0.0) != 0.0) != each_way)
    return fail(fmt::format("found 3605#0 = {}, expected {}: a table of {}", each_way ? 0 : 1, each_way ? 1 : 0,
                            each_way ? "each direction" : "both directions alike"));
  if (each_way && !(tape.has(3621) && tape.has(3622) && tape.has(3626)))
    return fail("found no 3621, 3622 or 3626, expected them: they part the two directions");
  if (options.kind == AxisKind::rotary && !f.turns && f.step * static_cast<double>(f.last - f.first + 1) > 360.0 + 1e-6)
    return fail("found more than a turn, expected parameter 3625 with a table that turns");
  f.first_downwards = std::llround(tape.parameter(3626, 0.0));
  const long long points = f.last - f.first + 1;
  if (points < 1 || static_cast<std::size_t>(points) * (each_way ? 2 : 1) != tape.points.size())
    return fail(fmt::format("found {} points, expected those from {} to {}{}", tape.points.size(), f.first, f.last,
                            each_way ? " and as many of the negative direction" : ""));
  return f;
}

/// Sums of the numbers at every position, 0 at the reference point: beyond the points at the nearest. They are summed
/// as whole numbers, as the control does: sums of 3.6 ″ each would not come back to 0 after a turn that closes.
Result<std::vector<double>> summed(const Tape& tape, const Frame& f, long long first_point) {
  std::vector<long long> sums{0};
  for (long long n = f.turns ? 1 : 0; n <= f.last - f.first; ++n) {
    const auto point = tape.points.find(first_point + n);
    if (point == tape.points.end())
      return fail(fmt::format("found no point {}, expected all without a gap", first_point + n));
    sums.push_back(sums.back() + point->second);
  }
  if (f.turns && (sums.back() != 0 || tape.points.at(first_point) != tape.points.at(first_point + f.last - f.first)))
    return fail("found a turn that does not close, expected numbers whose sum is 0, the first being the last");
  const long long origin = f.reference - f.first + (f.turns ? 0 : 1);
  const long long there = sums[static_cast<std::size_t>(std::clamp<long long>(origin, 0, std::ssize(sums) - 1))];
  std::vector<double> values;
  for (const long long sum : sums) values.push_back(f.count * static_cast<double>(sum - there));
  return values;
}

}  // namespace

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& options, bool each_way) {
  AxisTableOptions named = options;
  AXIOMETRY_TRY(const Tape tape, tape_of(text, named));
  AXIOMETRY_TRY(const Frame f, frame_of(tape, named, each_way));
  AXIOMETRY_TRY(std::vector<double> up, summed(tape, f, f.first));
  std::vector<double> down = up;
  if (each_way) {
    AXIOMETRY_TRY(down, summed(tape, f, f.first_downwards));
    for (double& value : down) value += f.detection_unit * tape.parameter(3627, 0.0);
  }
  const long long steps = f.first - (f.turns ? 0 : 1) - f.reference;
  return even_correction(options.kind, options.reference + f.step * static_cast<double>(steps), f.step, std::move(up),
                         std::move(down));
}

}  // namespace axiometry::nc::fanuc
