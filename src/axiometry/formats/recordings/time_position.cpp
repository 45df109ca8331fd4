// SPDX-License-Identifier: Apache-2.0
//
// Text of two columns, time and position, as data loggers and scripts write it.
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recordings/line_reader.h"
#include "axiometry/formats/recordings/sample_columns.h"
#include "axiometry/formats/recordings/time_text.h"

namespace axiometry::formats {
namespace time_position {
namespace {

constexpr std::size_t columns_looked_at = 16;  // for one that may be the position
constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";

bool is_comment(std::string_view line) { return line.empty() || line.front() == '#' || line.front() == '%'; }

class TimePositionReader final : public LineReader {
 public:
  explicit TimePositionReader(const RecordingOptions& options)
      : LineReader(options, StampJudge::Kind::times),
        kind_(options.kind),
        meaning_(options.meaning),
        choice_{.stated = options.axis_stated || options.axis > 0 ? std::optional(options.axis) : std::nullopt,
                .at_standstill = options.at_standstill} {}

  const Unit* unit() const override { return columns_ ? columns_->unit : nullptr; }
  std::string_view name() const override { return columns_ ? std::string_view(columns_->name) : ""; }

 private:
  Result<void> take(std::string_view line) override {
    if (line_number() == 1 && line.starts_with(byte_order_mark)) line.remove_prefix(byte_order_mark.size());
    line = text::trim(line);
    if (is_comment(line)) return {};
    if (!columns_) return begin(line);
    const auto cells = cells_of(line, columns_->delimiter);
    if (cells.size() <= std::max(columns_->time, columns_->position) || (width_ != 0 && cells.size() != width_))
      return fail(fmt::format("found {}, expected {} columns as in the lines before", text::quoted(line), width_));
    width_ = cells.size();
    AXIOMETRY_TRY(const double time_s, time_of(cells[columns_->time]));
    const auto position = number_of(cells[columns_->position], columns_->delimiter);
    if (!position)
      return fail(fmt::format("found {}, expected a finite number as {}", text::quoted(cells[columns_->position]),
                              meaning_ == ChannelMeaning::position ? "position" : "reading"));
    return emit({time_s, *position * columns_->position_factor / columns_->position_divisor});
  }

  /// The first line that is no comment: values, or a header.
  Result<void> begin(std::string_view line) {
    columns_ = columns_by_values(line, choice_.stated);
    if (columns_) return take(line);
    AXIOMETRY_TRY(columns_, meaning_ == ChannelMeaning::position ? columns_by_header(line, kind_, choice_)
                                                                 : value_columns_by_header(line, choice_.stated));
    return {};
  }

  Result<double> time_of(std::string_view cell) {
    if (!time_seen_) {
      if (columns_->by_header) columns_->stamps = parse_time_stamp(cell).has_value();
      tell_units_assumed();
    }
    time_seen_ = true;
    if (!columns_->stamps) {
      const auto time = number_of(cell, columns_->delimiter);
      if (!time) return fail(fmt::format("found {}, expected a finite number as time", text::quoted(cell)));
      return *time * columns_->seconds_per_unit;
    }
    const auto stamp_ns = parse_time_stamp(cell);
    if (!stamp_ns)
      return fail(fmt::format("found {}, expected a time such as 2026-11-21T12:34:56.789", text::quoted(cell)));
    if (!first_stamp_ns_) first_stamp_ns_ = stamp_ns;
    return seconds_between(*first_stamp_ns_, *stamp_ns);
  }

  /// Of a header, whose names could have said it; two columns of numbers alone are s and mm or ° by definition.
  void tell_units_assumed() {
    if (!columns_->by_header) return;
    if (!columns_->stamps && !columns_->time_has_unit)
      remark("the header names no unit of the time, which is taken to be in seconds");
    if (meaning_ == ChannelMeaning::position && !columns_->position_has_unit)
      remark(kind_ == AxisKind::linear ? "the header names no unit of the position, which is taken to be in mm"
                                       : "the header names no unit of the position, which is taken to be in degrees");
  }

  Result<void> end() override {
    return time_seen_ ? Result<void>{} : fail("found no sample, expected lines of time and position");
  }

  AxisKind kind_;
  ChannelMeaning meaning_;
  PositionChoice choice_;
  std::optional<SampleColumns> columns_;
  std::size_t width_ = 0;
  bool time_seen_ = false;
  std::optional<std::int64_t> first_stamp_ns_;
};

Result<std::unique_ptr<RecordingReader>> open(const RecordingOptions& options) {
  AXIOMETRY_TRY_VOID(check_times_and_positions(options));
  return std::make_unique<TimePositionReader>(options);
}

/// The first two lines that are no comments: a header and values, or values twice.
int recognise(std::string_view head) {
  if (head.starts_with(byte_order_mark)) head.remove_prefix(byte_order_mark.size());
  std::string_view lines[2];
  std::size_t count = 0;
  while (!head.empty() && count < 2) {
    const std::size_t end = std::min(head.find('\n'), head.size());
    const std::string_view line = text::trim(head.substr(0, end));
    head.remove_prefix(std::min(end + 1, head.size()));
    if (!is_comment(line)) lines[count++] = line;
  }
  if (count == 0) return 0;
  const auto values = columns_by_values(lines[0], std::nullopt);
  if (values && (count == 1 || columns_by_values(lines[1], std::nullopt))) return values->stamps ? 70 : 50;
  if (values || count < 2) return 0;
  const std::size_t beside = cells_of(lines[1], sample_delimiter(lines[0])).size();
  for (AxisKind kind : {AxisKind::linear, AxisKind::rotary})
    for (std::size_t column = 0; column + 1 < beside && column < columns_looked_at; ++column) {
      const auto columns = columns_by_header(lines[0], kind, {.stated = column, .in_any_unit = true});
      if (!columns) continue;
      const auto cells = cells_of(lines[1], columns->delimiter);
      if (cells.size() <= std::max(columns->time, columns->position)) continue;
      const bool time = number_of(cells[columns->time], columns->delimiter) || parse_time_stamp(cells[columns->time]);
      if (time && number_of(cells[columns->position], columns->delimiter)) return 80;
    }
  return 0;
}

constexpr std::string_view manual =
    R"(Text with one sample per line: time and position, as data loggers and scripts write it.

```
time_s,position_mm
0.000,-5.0000
0.010,-5.0001
0.020,-4.9999
```

- UTF-8, or UTF-16 with a byte order mark, as programs of Windows write it.
- Columns are separated by comma, semicolon, tab or blanks. Numbers have a decimal point, or a decimal comma where the
  comma parts no columns.
- Without a header there are two columns: time in s, position in mm (° on a rotary axis). A header names the columns
  (`time`, `t`, `zeit`, and the position) and their units, as `_ms`, `[ms]`, `(ms)` or `/ms`: s, ms, us, ns,
  min, h; mm, um, nm, m, in, deg, arcsec, rad and so on. Of several columns the only
  one with a unit of position, or called one, is read, setpoints and deviations left aside; else `--stream-axis` says
  which.
- Readings of a straightness or a rotation (`axiometry capture --stops`) are read in the unit that the header or
  `--unit` names, of several columns from that of `--stream-axis`.
- The time may be a point in time: `2026-11-21T12:34:56.789Z`, `2026-11-21 12:34:56,789`; it counts from the first.
- Lines that begin with `#` or `%` and empty lines are passed over.
- Refused: lines with other columns than those before, numbers that are none or beyond 1e15, time that runs backwards,
  positions in a unit of the other kind of axis. Of a live stream and with `--skip-damaged` such lines are counted and
  left out, also a line whose time ran ahead; five in order behind the time before are a clock that was set, and are
  taken.
)";

}  // namespace
}  // namespace time_position

extern const Recording time_position_recording;
const Recording time_position_recording = {
    .id = "time-position",
    .title = "Text with time and position",
    .extensions = ".csv .txt",
    .manual = time_position::manual,
    .of_any_quantity = true,
    .channels_share_time = true,
    .recognise = time_position::recognise,
    .open = time_position::open,
};

}  // namespace axiometry::formats
