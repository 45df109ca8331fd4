// SPDX-License-Identifier: Apache-2.0
//
// Logs of EPICS camonitor, recorded while a script of ecmc ran an ISO 230-2 test.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/moment.h"
#include "axiometry/formats/devices/camonitor_codes.h"
#include "axiometry/formats/devices/camonitor_log.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/series/approaches.h"
#include "axiometry/formats/series/target_index.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace camonitor {
namespace {

// Parts of names, in lower case. What stands before the last colon is mostly the name of the control's computer.
constexpr std::string_view set_point_words[] = {"posset",     "poscmd", "setpos", "setpoint",  "set-point", "possp",
                                                "poscommand", "postgt", "tgtpos", "targetpos", "posref"};
constexpr std::string_view reference_words[] = {"laser", "interferom", "ild", "reference", "refpos", "refenc", "xl80"};

struct Roles {
  std::size_t set_point = 0;
  std::size_t reference = 0;
};

struct Directives {
  const Unit* unit = nullptr;  ///< null when not stated
  std::optional<double> gain, offset;
  std::optional<std::size_t> set_point, reference;
};

/// An event that belongs to the test.
struct Point {
  const LogEvent* event = nullptr;
  TestCode code;
};

std::string local_name(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return text::to_lower(colon == std::string_view::npos ? name : name.substr(colon + 1));
}

bool is_set_point(std::string_view name) {
  const std::string local = local_name(name);
  return local.ends_with(".val") ||
         std::ranges::any_of(set_point_words, [&](std::string_view word) { return local.contains(word); });
}

bool is_marked_reference(std::string_view name) {
  const std::string whole = text::to_lower(name);
  const auto is_letter = [](char c) { return c >= 'a' && c <= 'z'; };
  return std::ranges::any_of(reference_words, [&](std::string_view word) {
    // A word, not a part of one: "ild" is in "build".
    for (std::size_t at = whole.find(word); at != std::string::npos; at = whole.find(word, at + 1))
      if (at == 0 || !is_letter(whole[at - 1])) return true;
    return false;
  });
}

std::string names_of(const Log& log, const std::vector<std::size_t>& variables) {
  std::string names;
  for (std::size_t k : variables)
    names += fmt::format("{}{}", names.empty() ? "" : ", ", text::quoted(log.variables[k]));
  return names;
}

class Reader {
 public:
  explicit Reader(const Log& log) : log_(log) {}

  Result<Test> read() {
    AXIOMETRY_TRY_VOID(take_directives());
    AXIOMETRY_TRY_VOID(take_points());
    AXIOMETRY_TRY_VOID(find_roles());
    AXIOMETRY_TRY_VOID(take_approaches());
    AXIOMETRY_TRY_VOID(check_reference());
    AXIOMETRY_TRY(GatheredSeries result, gathered(approaches_));
    Test test{Metadata{}, std::move(result.series), Provenance{}};
    test.times_s = std::move(result.times_s);
    test.metadata.axis.kind = unit().kind;
    if (const std::string_view time = state(points_.front(), roles_.reference).time; time_stamp_s(time))
      test.metadata.conditions.date = time.substr(0, 10);
    test.metadata.conditions.comment =
        fmt::format("Reference {}; set-point {}", log_.variables[roles_.reference], log_.variables[roles_.set_point]);
    test.provenance.remarks = remarks();
    if (result.remark) test.provenance.remarks.push_back(*std::move(result.remark));
    return test;
  }

 private:
  const Unit& unit() const { return directives_.unit == nullptr ? *find_unit("mm") : *directives_.unit; }

  Result<std::size_t> variable(const LogDirective& d) {
    for (std::size_t k = numbers_.size(); k < log_.variables.size(); ++k) numbers_.emplace(log_.variables[k], k);
    if (const auto found = numbers_.find(d.value); found != numbers_.end()) return found->second;
    return fail(fmt::format("found {} = {}, expected a variable of the log", d.key, text::quoted(d.value)), d.at);
  }

  Result<double> number(const LogDirective& d) const {
    if (const auto x = parse_number(d.value)) return *x;
    return fail(fmt::format("found {} = {}, expected a finite number", d.key, text::quoted(d.value)), d.at);
  }

  Result<void> take_directives() {
    for (const LogDirective& d : log_.directives) {
      if (text::equal_ignoring_case(d.key, "UNIT")) {
        directives_.unit = find_unit(d.value);
        if (directives_.unit == nullptr)
          return fail(fmt::format("found the unknown unit {}, expected one of {}", text::quoted(d.value), unit_names()),
                      d.at);
      } else if (text::equal_ignoring_case(d.key, "REF_PV")) {
        AXIOMETRY_TRY(directives_.reference, variable(d));
      } else if (text::equal_ignoring_case(d.key, "TGT_SET_PV")) {
        AXIOMETRY_TRY(directives_.set_point, variable(d));
      } else if (text::equal_ignoring_case(d.key, "REF_GAIN")) {
        AXIOMETRY_TRY(directives_.gain, number(d));
      } else if (text::equal_ignoring_case(d.key, "REF_OFFSET")) {
        AXIOMETRY_TRY(directives_.offset, number(d));
      }
    }
    return {};
  }

  Result<void> take_points() {
    if (!log_.test_number)
      return fail(
          "found no variable with TestNumber in its name, expected the numbers of an ISO 230-2 test; a first line "
          "'# TEST_PV=NAME' names another");
    std::vector<std::string_view> codes;
    for (const LogEvent& event : log_.events) {
      if (!is_test_code(event.code)) continue;
      codes.push_back(event.code);
      points_.push_back({&event, {}});
    }
    if (points_.empty())
      return fail(fmt::format("found no test number of an ISO 230-2 test in {}, expected 1101, 1102, …",
                              text::quoted(log_.variables[*log_.test_number])));
    AXIOMETRY_TRY(const std::vector<TestCode> meanings, test_codes(codes));
    for (std::size_t k = 0; k < points_.size(); ++k) points_[k].code = meanings[k];
    return {};
  }

  LogState state(const Point& point, std::size_t number) const {
    return number < point.event->states.size() ? point.event->states[number] : LogState{};
  }

  /// Whether the variable is a number that differs between the points.
  bool varies(std::size_t number) const {
    std::optional<double> first;
    for (const Point& point : points_) {
      const auto value = parse_number(state(point, number).value);
      if (!value) continue;
      if (first && *value != *first) return true;
      first = value;
    }
    return false;
  }

  Result<void> find_roles() {
    std::vector<std::size_t> set_points, marked, others;
    for (std::size_t k = 0; k < log_.variables.size(); ++k) {
      if (k == *log_.test_number || !varies(k)) continue;
      if (is_set_point(log_.variables[k])) {
        set_points.push_back(k);
      } else if (k != directives_.set_point) {
        (is_marked_reference(log_.variables[k]) ? marked : others).push_back(k);
      }
    }
    if (directives_.set_point) set_points = {*directives_.set_point};
    if (set_points.size() != 1)
      return fail(fmt::format("found {} set-points{}{}, expected one; a line '# TGT_SET_PV=NAME' names it",
                              set_points.size(), set_points.empty() ? "" : ": ", names_of(log_, set_points)));
    std::vector<std::size_t>& references = marked.empty() ? others : marked;
    if (directives_.reference) references = {*directives_.reference};
    if (references.size() != 1)
      return fail(
          fmt::format("found {} variables that may be the reference{}{}, expected one; a line '# REF_PV=NAME' "
                      "names it",
                      references.size(), references.empty() ? "" : ": ", names_of(log_, references)));
    roles_ = {set_points.front(), references.front()};
    for (std::size_t k : {roles_.set_point, roles_.reference})
      if (text::invalid_utf8(log_.variables[k]))
        return fail(fmt::format("found the name {}, expected UTF-8", text::quoted(log_.variables[k])));
    return {};
  }

  Result<double> value_before(const Point& point, std::size_t number) const {
    const LogState s = state(point, number);
    if (s.line == 0)
      return fail(fmt::format("found the test number {} before any value of {}, expected one", point.event->code,
                              text::quoted(log_.variables[number])),
                  {point.event->line, 1});
    if (const auto value = parse_number(s.value)) return *value;
    return fail(fmt::format("found {}, expected a finite number", text::quoted(s.value)), {s.line, 1});
  }

  /// The last change of the set-point tells from where the target was approached; without one since the point before
  /// the axis stood still.
  Result<void> check_direction(const Point& point, std::size_t line_before, double set_point) const {
    const LogState s = state(point, roles_.set_point);
    const auto before = parse_number(s.previous);
    if (s.line < line_before || !before || *before == set_point) return {};
    const Direction moved = set_point > *before ? Direction::up : Direction::down;
    if (moved == point.code.direction) return {};
    return fail(fmt::format("found test number {} after a move {} from {} to {}, expected {} for a number that begins "
                            "with {}",
                            point.event->code, arrow(moved), format_exact(*before), format_exact(set_point),
                            arrow(point.code.direction), point.event->code.front()),
                {point.event->line, 1});
  }

  Result<void> take_approaches() {
    struct Target {
      double value = 0.0;
      std::size_t line = 0;
    };
    std::map<std::size_t, Target> targets;
    const ReadingRule rule{Measured::position, &unit()};
    std::size_t line_before = 0;
    for (const Point& point : points_) {
      const TextPosition at{point.event->line, 1};
      AXIOMETRY_TRY(const double set_point, value_before(point, roles_.set_point));
      AXIOMETRY_TRY(const double shown, value_before(point, roles_.reference));
      AXIOMETRY_TRY_VOID(check_direction(point, line_before, set_point));
      line_before = at.line;
      const Position target = position_in(unit(), set_point);
      const auto [first, is_new] = targets.try_emplace(point.code.target, Target{target.in_native(), at.line});
      if (!(std::abs(first->second.value - target.in_native()) <= same_target))
        return fail(
            fmt::format("found target {} at {}, expected {} as on line {}", point.code.target,
                        format_exact(target.in_native()), format_exact(first->second.value), first->second.line),
            at);
      const double measured = directives_.gain.value_or(1.0) * shown + directives_.offset.value_or(0.0);
      AXIOMETRY_TRY(const double deviation, placed(native_deviation(rule, target, measured), at));
      approaches_.push_back(
          {.target = target,
           .direction = point.code.direction,
           .run = point.code.cycle,
           .deviation = Deviation::native(deviation),
           .time_s =
               time_stamp_s(state(point, roles_.reference).time).value_or(std::numeric_limits<double>::quiet_NaN()),
           .at = at});
    }
    return {};
  }

  /// A reference that counts the other way, or in other units, is no position: what it shows must follow the set-point
  /// one to one, within a tenth, which no axis misses.
  Result<void> check_reference() {
    double mean_target = 0.0;
    double mean_deviation = 0.0;
    const auto n = static_cast<double>(approaches_.size());
    for (const ListedReading& a : approaches_) {
      mean_target += a.target.in_native() / n;
      mean_deviation += a.deviation.in_native() / n;
    }
    double squares = 0.0;
    double products = 0.0;
    double largest_target = 0.0;
    for (const ListedReading& a : approaches_) {
      const double t = a.target.in_native() - mean_target;
      squares += t * t;
      products += t * (a.deviation.in_native() - mean_deviation);
      largest_target = std::max(largest_target, std::abs(t));
    }
    const double per_position = deviation_per_position(unit().kind);
    constexpr double tolerated = 0.1;
    const double slope = squares > 0.0 ? 1.0 + products / squares / per_position : 1.0;
    if (!(std::abs(slope - 1.0) <= tolerated))
      return fail(
          fmt::format("found a reference {} that changes by {:.4g} when the set-point changes by 1, expected 1; "
                      "lines '# REF_GAIN=-1' and '# REF_OFFSET=…' state how it counts",
                      text::quoted(log_.variables[roles_.reference]), slope));
    constexpr double share_of_travel = 0.01;
    if (std::abs(mean_deviation) > share_of_travel * largest_target * per_position) constant_ = mean_deviation;
    return {};
  }

  std::vector<SourceRemark> remarks() const {
    std::vector<SourceRemark> list;
    list.push_back(
        {false, fmt::format("found a log; the reading of a point is the last value of {} before its number in "
                            "{}, its target the last value of {}",
                            log_.variables[roles_.reference], text::quoted(log_.variables[*log_.test_number]),
                            log_.variables[roles_.set_point])});
    if (directives_.unit == nullptr) list.push_back({false, "found lengths without a unit; they were taken in mm"});
    if (directives_.gain || directives_.offset)
      list.push_back({false, fmt::format("found a stated reference; its values were multiplied by {} and {} was added",
                                         format_exact(directives_.gain.value_or(1.0)),
                                         format_exact(directives_.offset.value_or(0.0)))});
    if (constant_)
      list.push_back({false, fmt::format("found another zero of the reference than of the axis: deviations have the "
                                         "mean {} {}, on which no parameter depends",
                                         format_fixed(*constant_, 1), deviation_unit(unit().kind))});
    if (const auto backwards = time_running_backwards(log_, {roles_.set_point, roles_.reference, *log_.test_number}))
      list.push_back({false, *backwards});
    if (const std::size_t others = log_.events.size() - points_.size(); others > 0)
      list.push_back({false, fmt::format("found {} that no ISO 230-2 test has; they were passed over",
                                         counted(others, "other test number"))});
    if (log_.skipped_lines > 0)
      list.push_back({false, fmt::format("found {} without a value, the first on line {}; they were passed over",
                                         counted(log_.skipped_lines, "line"), log_.first_skipped)});
    return list;
  }

  const Log& log_;
  std::map<std::string_view, std::size_t> numbers_;  // of the variables, once one is asked for
  Directives directives_;
  std::vector<Point> points_;
  Roles roles_;
  std::vector<ListedReading> approaches_;
  std::optional<double> constant_;
};

Result<Test> read(std::string_view bytes) {
  // Decoding copies, and a log may have gigabytes of ASCII.
  if (const auto text = readable_text(bytes)) {
    AXIOMETRY_TRY(const Log log, read_log(*text));
    return Reader(log).read();
  }
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  AXIOMETRY_TRY(const Log log, read_log(decoded.text));
  AXIOMETRY_TRY(Test test, Reader(log).read());
  std::ranges::move(encoding_remarks(decoded), std::back_inserter(test.provenance.remarks));
  return test;
}

/// Logs of other programs have times too: names of EPICS have a colon, and the test needs its numbers.
int recognise(std::string_view head) {
  std::size_t values = 0;
  std::size_t lines = 0;
  for (std::string_view line : text::split(head.substr(0, std::min<std::size_t>(head.size(), 8192)), '\n')) {
    const std::string_view content = text::trim(line);
    if (content.empty() || content.starts_with('#')) continue;
    ++lines;
    const auto found = log_line(line);
    values += found && found->name.contains(':') && parse_number(found->value);
  }
  if (values == 0 || 2 * values < lines) return 0;
  const std::string text = text::to_lower(head);
  return text.contains("testnumber") || text.contains("test_pv") ? 95 : 40;
}

constexpr std::string_view manual =
    R"(A log of EPICS `camonitor`, recorded while a script of ecmc ran an ISO 230-2 test.

```
# UNIT=mm
IOC:LaserPos    2026-01-31 10:00:00.100000 0.0000
IOC:TestNumber  2026-01-31 09:12:00.000000 0
IOC:X-PosSet    2026-01-31 09:59:00.000000 -1
IOC:X-PosSet    2026-01-31 10:00:01.000000 0
IOC:LaserPos    2026-01-31 10:00:02.000000 0.0001
IOC:TestNumber  2026-01-31 10:00:03.000000 1101
IOC:X-PosSet    2026-01-31 10:00:04.000000 100
IOC:LaserPos    2026-01-31 10:00:05.000000 100.0004 HIHI MAJOR
IOC:TestNumber  2026-01-31 10:00:06.000000 1102
```

- Lines are `NAME  YYYY-MM-DD hh:mm:ss.ffffff value`, and severity words may follow. Their order is that of the log; the
  first value of each variable, printed while camonitor connects, may be old. Other lines are passed over and counted.
- Every change of the variable with `TestNumber` in its name to a number D C P is a reading: D 1 ↑ or 2 ↓, C the cycle,
  P the target. How many digits C has is found from all numbers. The reading is the last value of the reference before
  it, the target the last value of the set-point. The move before must go in the direction that the number says.
- The set-point is the variable whose name holds PosSet, PosCmd, SetPoint or the like. The reference is the one whose
  name holds Laser, ILD, Interferometer, Reference or the like, or else the only other variable that moves. Where that
  leaves a choice the log is refused, naming the variables. A remark tells what was taken, another where the times of
  these variables run backwards.
- Lines that you may add: `# REF_PV=NAME`, `# TGT_SET_PV=NAME`, `# TEST_PV=NAME`, `# UNIT=mm` (mm when not given, with a
  remark), `# REF_GAIN=-1` and `# REF_OFFSET=50` for a reference that counts otherwise: reading = gain·value + offset.
- Refused: a reference that does not follow the set-point one to one within a tenth, a number given twice, a target
  whose set-point changes from cycle to cycle, values that are no numbers.
)";

}  // namespace
}  // namespace camonitor

extern const Format camonitor_format;
const Format camonitor_format = {
    .id = "camonitor",
    .title = "EPICS camonitor log of an ecmc test",
    .extensions = ".log .txt",
    .manual = camonitor::manual,
    .recognise = camonitor::recognise,
    .read = camonitor::read,
};

}  // namespace axiometry::formats
