// SPDX-License-Identifier: Apache-2.0
//
// The log of camonitor (EPICS): one line for every change of a process variable.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <unordered_set>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recordings/line_reader.h"
#include "axiometry/formats/recordings/time_text.h"

namespace axiometry::formats {
namespace camonitor_stream {
namespace {

/// Name, time stamp and value of one line, or nothing.
struct Change {
  std::string_view name;
  std::int64_t stamp_ns = 0;
  std::string_view value;
};

std::optional<Change> change_of(std::string_view line) {
  const auto words = text::words(line);
  if (words.size() < 4 || words[1].size() != 10 || words[2].find(':') == words[2].npos) return std::nullopt;
  const auto stamp = parse_time_stamp(fmt::format("{}T{}", words[1], words[2]));
  if (!stamp) return std::nullopt;
  return Change{words[0], *stamp, words[3]};
}

class CamonitorStreamReader final : public LineReader {
 public:
  explicit CamonitorStreamReader(const RecordingOptions& options)
      : LineReader(options, StampJudge::Kind::times), axis_(options.axis) {}

 private:
  Result<void> take(std::string_view line) override {
    const std::string_view content = text::trim(line);
    if (content.empty() || content.find("***") != content.npos) return {};  // "*** Not connected (PV not found)"
    const auto change = change_of(content);
    if (!change)
      return fail(
          fmt::format("found {}, expected a process variable, its time stamp and its value", text::quoted(content)));
    if (!is_chosen(change->name)) return {};
    const auto value = parse_number(change->value);
    if (!value) return fail(fmt::format("found the value {}, expected a finite number", text::quoted(change->value)));
    if (!first_ns_) first_ns_ = change->stamp_ns;
    return emit({seconds_between(*first_ns_, change->stamp_ns), *value});
  }

  /// Process variables are numbered as they appear.
  bool is_chosen(std::string_view name) {
    if (names_.size() > axis_) return names_[axis_] == name;
    if (seen_.emplace(name).second) names_.emplace_back(name);
    return names_.size() > axis_ && names_[axis_] == name;
  }

  Result<void> end() override {
    if (first_ns_) return {};
    return fail(
        fmt::format("found {} process variables in the log, expected number {} among them", names_.size(), axis_ + 1));
  }

  std::size_t axis_;
  std::vector<std::string> names_;  // as they appear
  std::unordered_set<std::string> seen_;
  std::optional<std::int64_t> first_ns_;
};

Result<std::unique_ptr<RecordingReader>> open(const RecordingOptions& options) {
  AXIOMETRY_TRY_VOID(check_times_and_positions(options));
  return std::make_unique<CamonitorStreamReader>(options);
}

int recognise(std::string_view head) {
  const std::size_t end = head.find('\n');
  return change_of(head.substr(0, end)) ? 90 : 0;
}

constexpr std::string_view manual =
    R"(The log that camonitor of EPICS prints: one line for every change of a process variable.

```
IOC:Axis1-PosAct 2026-11-21 12:00:00.000000 -5.0001
IOC:Axis1-PosAct 2026-11-21 12:00:00.100000 -5.0000
IOC:Axis1-PosAct 2026-11-21 12:00:00.200000 -4.9999
```

- Name, date, time of day, value in mm (° on a rotary axis); words of alarms behind the value are passed over.
- Of several process variables the first one is read; `--stream-axis` chooses another, in the order in which they
  appear.
- A variable that is only sent when it changes by a dead band shows no noise at rest and leaves gaps; log the encoder
  itself, with a dead band of zero.
- Refused: other lines, values that are no finite numbers, time that runs backwards. Of a live stream and with
  `--skip-damaged` such lines are counted and left out, as `axiometry formats time-position` tells.
)";

}  // namespace
}  // namespace camonitor_stream

extern const Recording camonitor_stream_recording;
const Recording camonitor_stream_recording = {
    .id = "camonitor-stream",
    .title = "camonitor log (EPICS)",
    .extensions = ".log .txt",
    .manual = camonitor_stream::manual,
    .of_any_quantity = true,
    .recognise = camonitor_stream::recognise,
    .open = camonitor_stream::open,
};

}  // namespace axiometry::formats
