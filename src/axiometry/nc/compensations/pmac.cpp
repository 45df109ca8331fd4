// SPDX-License-Identifier: Apache-2.0
//
// Leadscrew compensation of Delta Tau PMAC: entries of 1/16 count at one spacing from home upward, which roll over at
// the length of the table; positions below home are at its end. The table is added to the command; a second one
// (BLCOMP) and the constant Ix86 are taken off it while the motor moves in the negative direction. At home BLCOMP is 0
// by definition: the reversal there is Ix86, and the table holds what differs from it.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {

extern const AxisTable pmac_axis_table;

namespace pmac {
namespace {

constexpr double per_count = 16.0;
constexpr long long entry_most = 8'388'607;  // 24 bits
constexpr std::string_view range_mark = "; range ", count_mark = "; one count = ";

/// Where the table stands, from the first position to the last, home among them.
struct Span {
  double low = 0.0, high = 0.0, step = 0.0;
  long long entries = 0, length_counts = 0;
};

/// Whose position the table follows, and which motor it moves.
struct Motors {
  unsigned source = 1, target = 1;

  bool is_cross() const { return source != target; }
  /// Both are named where they are two. The table belongs to the motor that it moves.
  std::string of_table() const { return is_cross() ? fmt::format("#{},#{},", source, target) : std::string(); }
};

Result<Motors> motors_of(const AxisTableOptions& options) {
  Motors motors;
  motors.source = motors.target = options.number > 0 ? options.number : 1;
  if (options.output_axis.empty() || options.output_axis == options.axis) return motors;
  std::string_view digits = options.output_axis;
  if (digits.starts_with('#')) digits.remove_prefix(1);
  constexpr unsigned long long motors_most = 32;
  const auto target = parse_count(digits);
  if (!target || *target < 1 || *target > motors_most || *target == motors.source)
    return fail(fmt::format("found the output axis {}, expected the number of its motor, 1 to {} and another than {}",
                            text::quoted(options.output_axis), motors_most, motors.source));
  motors.target = static_cast<unsigned>(*target);
  return motors;
}

Result<Span> span_of(const AxisCorrection& correction, const AxisTableOptions& options) {
  const std::vector<double>& positions = correction.positions();
  const auto step = common_step(positions);
  AXIOMETRY_CONTRACT(step);  // check_limits()
  Span span{std::min(positions.front(), options.reference), std::max(positions.back(), options.reference), *step};
  // The one section behind the last position leads back to the first.
  const double entries = (span.high - span.low) / *step + (is_whole_turn(correction) ? 0.0 : 1.0);
  const double length = std::round(entries) * *step * deviation_per_position(options.kind) / options.resolution;
  if (entries > static_cast<double>(AxisCorrection::nodes_max) || !(length < 1e15) || length < 1.0)
    return fail(
        fmt::format("found a table of {:.0f} entries over {:.0f} counts, expected at most {} and at least 1 count",
                    entries, length, AxisCorrection::nodes_max));
  span.entries = std::llround(entries);
  span.length_counts = std::llround(length);
  return span;
}

/// In 1/16 count, less what stands elsewhere.
Result<long long> whole_entry(double correction_native, const AxisTableOptions& options, long long elsewhere) {
  const double value = std::round(correction_native * per_count / options.resolution) - static_cast<double>(elsewhere);
  if (!(std::abs(value) <= static_cast<double>(entry_most)))
    return fail(fmt::format("found a correction of {:.0f} counts / 16, expected at most {}", value, entry_most));
  return static_cast<long long>(value);
}

/// Each entry less that at home, which stands elsewhere.
Result<void> write_entries(std::string& text, const Span& span, const AxisTableOptions& options, long long at_home,
                           auto&& value_at) {
  for (long long k = 1; k <= span.entries; ++k) {
    double position = options.reference + span.step * static_cast<double>(k);
    if (position > span.high + 0.5 * span.step || k == span.entries)
      position -= span.step * static_cast<double>(span.entries);
    AXIOMETRY_TRY(const long long value, whole_entry(value_at(position), options, at_home));
    fmt::format_to(std::back_inserter(text), "{}\n", value);
  }
  return {};
}

Result<std::string> write(const AxisCorrection& correction, const AxisTableOptions& options) {
  AXIOMETRY_TRY_VOID(check_limits(correction, pmac_axis_table));
  AXIOMETRY_TRY_VOID(check_axis_word(options));
  AXIOMETRY_TRY_VOID(check_origin(correction, pmac_axis_table, options.reference));
  AXIOMETRY_TRY(const Span span, span_of(correction, options));
  AXIOMETRY_TRY(const Motors motors, motors_of(options));
  if (motors.is_cross() && !correction.same_both_ways())
    return fail("found a curve for each direction, expected one for both: BLCOMP moves its own motor alone");
  std::string text = comment_lines(";", pmac_axis_table.sign);
  fmt::format_to(std::back_inserter(text), "{}{} to {}\n{}{}\n#{} DEFINE COMP {},{}{}\n", range_mark,
                 trimmed_fixed(span.low, 6), trimmed_fixed(span.high, 6), count_mark, count_text(options),
                 motors.target, span.entries, motors.of_table(), span.length_counts);
  AXIOMETRY_TRY_VOID(write_entries(text, span, options, 0, [&](double x) { return correction.at(x, Direction::up); }));
  if (!correction.same_both_ways()) {
    fmt::format_to(std::back_inserter(text), "#{} DEFINE BLCOMP {},{}\n", motors.target, span.entries,
                   span.length_counts);
    const auto less_at = [&](double x) { return correction.at(x, Direction::up) - correction.at(x, Direction::down); };
    AXIOMETRY_TRY(const long long at_home, whole_entry(less_at(options.reference), options, 0));
    if (at_home < 0)
      return fail(
          "found a negative reversal at the reference point, expected one of 0 or more, which Ix86 can hold, or one "
          "curve for both directions");
    AXIOMETRY_TRY_VOID(write_entries(text, span, options, at_home, less_at));
    fmt::format_to(std::back_inserter(text), "I{}86={}\n", motors.target, at_home);
  }
  return text + "I51=1\n";
}

struct Buffer {
  bool is_backlash = false;
  long long entries = 0, length_counts = 0;
  std::vector<long long> values{};
};

std::optional<Buffer> buffer_of(std::string_view line, const Motors& motors) {
  const std::vector<std::string_view> words = text::words(line);
  if (words.size() != 4 || words[1] != "DEFINE" || (words[2] != "COMP" && words[2] != "BLCOMP")) return std::nullopt;
  const bool is_backlash = words[2] == "BLCOMP";
  if (words[0] != fmt::format("#{}", motors.target) || (is_backlash && motors.is_cross())) return std::nullopt;
  // In the manual's order: how many entries, source and target, the length in counts of the source.
  const auto parts = text::split(words[3], ',');
  const bool names_both = parts.size() == 4 && parts[1] == fmt::format("#{}", motors.source) &&
                          parts[2] == fmt::format("#{}", motors.target);
  if (motors.is_cross() ? !names_both : parts.size() != 2) return std::nullopt;
  const auto entries = whole_number(parts.front());
  const auto length = parse_count(parts.back());
  if (!entries || *entries < 1 || *entries > static_cast<long long>(AxisCorrection::nodes_max) || !length ||
      *length < 1 || *length > 1'000'000'000'000'000ull)
    return std::nullopt;
  return Buffer{is_backlash, *entries, static_cast<long long>(*length)};
}

struct Program {
  std::vector<Buffer> buffers;
  std::optional<std::pair<double, double>> range;
  std::optional<long long> at_home;  // Ix86
  bool is_on = false;
};

Result<void> take(TableLine line, AxisTableOptions& options, const Motors& motors, Program& program) {
  if (line.text.starts_with(count_mark)) return check_count_text(line.text.substr(count_mark.size()), options, line);
  if (line.text.starts_with(range_mark) && !program.range) {
    const auto words = text::words(line.text.substr(range_mark.size()));
    const auto low = words.size() == 3 ? parse_number(words[0]) : std::nullopt;
    const auto high = words.size() == 3 ? parse_number(words[2]) : std::nullopt;
    if (!low || !high || !(*low < *high)) return refused(line, "; range LOW to HIGH");
    program.range = {*low, *high};
    return {};
  }
  line.text = text::trim(line.text.substr(0, line.text.find(';')));
  if (line.text.empty()) return {};
  if (program.is_on) return refused(line, "nothing behind I51=1");
  if (line.text == "I51=1") {
    program.is_on = true;
    return {};
  }
  if (const std::string name = fmt::format("I{}86=", motors.target); line.text.starts_with(name)) {
    const auto value = whole_number(line.text.substr(name.size()));
    if (!value || *value < 0 || *value > entry_most || program.at_home || program.buffers.size() != 2)
      return refused(line, "Ix86 of this motor once, behind BLCOMP, 0 or more");
    program.at_home = *value;
    return {};
  }
  if (line.text.starts_with('#')) {
    const auto buffer = buffer_of(line.text, motors);
    if (!buffer || program.buffers.size() == 2 || buffer->is_backlash != !program.buffers.empty())
      return refused(line, "#MOTOR DEFINE COMP ENTRIES,COUNTS, then BLCOMP, of this motor");
    program.buffers.push_back(*buffer);
    return {};
  }
  if (program.buffers.empty()) return refused(line, "#MOTOR DEFINE COMP before the entries");
  for (const std::string_view word : text::words(line.text)) {
    const auto value = whole_number(word);
    if (!value) return refused(line, "whole numbers of 1/16 count");
    program.buffers.back().values.push_back(*value);
  }
  return {};
}

/// What the table says at a whole number of steps from home: it rolls over.
double rolled(const Buffer& buffer, long long steps) {
  const long long place = ((steps - 1) % buffer.entries + buffer.entries) % buffer.entries;
  return static_cast<double>(buffer.values[static_cast<std::size_t>(place)]);
}

/// Every entry but the one that leads back to the first lies within the range; of a whole turn that one does too. A
/// count of another size than was written makes another number of them.
Result<void> check_range(double range, double step, const Buffer& buffer, AxisKind kind) {
  const double steps = range / step, slack = 0.05 + steps / static_cast<double>(buffer.length_counts);
  const auto entries = static_cast<double>(buffer.entries);
  if (std::abs(steps - (entries - 1.0)) <= slack) return {};
  if (kind == AxisKind::rotary && std::abs(steps - entries) <= slack) return {};
  return fail(
      fmt::format("found a range of {} steps in a table of {} entries, expected {}: is one count another amount?",
                  format_rounded(steps, 3), buffer.entries, buffer.entries - 1));
}

/// BLCOMP had all of the reversal, and there was no Ix86. Other programs write no range.
std::string_view former(std::string_view text) {
  bool has_range = false, has_backlash = false, has_constant = false;
  for (const TableLine& line : lines_of(text)) {
    has_range = has_range || line.text.starts_with(range_mark);
    has_backlash = has_backlash || line.text.contains(" DEFINE BLCOMP ");
    has_constant = has_constant || (line.text.starts_with('I') && line.text.contains("86="));
  }
  return has_range && has_backlash && !has_constant
             ? "found BLCOMP with all of the reversal and no Ix86, as earlier versions of this program wrote it, "
               "expected the reversal at home in Ix86, without which the control has none there: make the table anew"
             : "";
}

Result<AxisCorrection> read(std::string_view text, const AxisTableOptions& told) {
  Program program;
  AxisTableOptions options = told;
  AXIOMETRY_TRY(const Motors motors, motors_of(options));
  for (const TableLine& line : lines_of(text)) AXIOMETRY_TRY_VOID(take(line, options, motors, program));
  if (const std::string_view why = former(text); !why.empty()) return fail(std::string(why));
  if (program.buffers.empty() || !program.is_on) return fail("found no table with I51=1 behind it, expected both");
  const Buffer& comp = program.buffers.front();
  for (const Buffer& buffer : program.buffers)
    if (std::ssize(buffer.values) != buffer.entries || buffer.entries != comp.entries ||
        buffer.length_counts != comp.length_counts)
      return fail(fmt::format("found {} entries, expected {}, as many as are defined, in both tables",
                              buffer.values.size(), comp.entries));
  // What the control has at home is not told otherwise: the entry there is none by one rule of the manuals.
  if (program.buffers.size() == 2 && (!program.at_home || program.buffers.back().values.back() != 0))
    return fail(
        "found BLCOMP without Ix86 or with a last entry that is not 0, expected the reversal at home in Ix86 and 0 as "
        "last entry");
  const double length =
      static_cast<double>(comp.length_counts) * options.resolution / deviation_per_position(options.kind);
  const double step = length / static_cast<double>(comp.entries);
  const double low = program.range ? program.range->first : options.reference;
  const double high = program.range ? program.range->second : options.reference + length;
  if (high - low > length * (1.0 + 1e-6) + 1e-6)
    return fail(fmt::format("found a range of {}, expected at most the length of the table, {}",
                            format_rounded(high - low), format_rounded(length)));
  if (program.range) AXIOMETRY_TRY_VOID(check_range(high - low, step, comp, options.kind));
  std::vector<double> up, down;
  const long long first = std::llround((low - options.reference) / step),
                  last = std::llround((high - options.reference) / step);
  for (long long k = first; k <= last; ++k) {
    up.push_back(rolled(comp, k) / per_count * options.resolution);
    const double less = program.at_home ? (rolled(program.buffers[1], k) + static_cast<double>(*program.at_home)) /
                                              per_count * options.resolution
                                        : 0.0;
    down.push_back(up.back() - less);
  }
  return even_correction(options.kind, options.reference + step * static_cast<double>(first), step, std::move(up),
                         std::move(down));
}

}  // namespace
}  // namespace pmac

const AxisTable pmac_axis_table = {
    .id = "pmac",
    .title = "Delta Tau PMAC, COMP and BLCOMP",
    .extension = ".pmc",
    .curves = TableCurves::each_way,
    .limits =
        {.equidistant = true, .origin = TableOrigin::on_grid, .zero_upwards = true, .closes = true, .rolls_over = true},
    .uses = {.number = true, .resolution = true, .output_axis = true, .inch = false},
    .sign =
        "A positive number of COMP moves the axis in the positive direction; one of BLCOMP in the negative, and only "
        "while it moves in the negative direction.",
    .loading =
        "Delete the buffers that are in the way (TBUF, ROTARY, GATHER, tables of lower motors), send the lines, motors "
        "with the highest number first, SAVE. I51=1 switches all tables on; they are active once the motor is homed. "
        "The number is that of the motor, one count one of its own. With BLCOMP, Ix86 holds the reversal at home and "
        "is among the lines; with Ix85 at 0 none of it acts. A cross table moves the motor of the output axis by the "
        "position of the motor with the number, both with counts of one size; it belongs to the motor that it moves, "
        "and where that has a table already to one without.",
    .verified =
        "The commands, 1/16 count, the first entry one spacing from home, the rollover, that COMP is added in both "
        "directions and BLCOMP and Ix86 taken off in the negative one, that BLCOMP is 0 at home, source and target of "
        "a table: reference and user's manuals. Not tried on a control.",
    .inferred = "24 bits of an entry.",
    .write = pmac::write,
    .read = pmac::read,
    .recognises = [](std::string_view text) { return text.substr(0, 1024).find(" DEFINE COMP ") != text.npos; },
    .former = pmac::former,
};

}  // namespace axiometry::nc
