// SPDX-License-Identifier: Apache-2.0
//
// The data files of the ISO 230 tools of ecmc (EtherCAT motion control for EPICS): lines KEY=value.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <unordered_map>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/series/series_order.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace ecmc_dat {
namespace {

constexpr std::string_view target_key = "TGT_DATA";
constexpr std::string_view reading_keys[] = {"REF_DATA_FWD", "REF_DATA_BWD"};  // in the order of Direction
constexpr std::string_view comment_keys[] = {"REF_PV", "TEST_PV", "TGT_SET_PV"};

struct Assignment {
  std::string_view key;
  std::vector<std::size_t> indices;  ///< of KEY[i] or KEY[i,j], from 1
  std::string_view value;
  TextPosition key_at;
  TextPosition value_at;
};

struct ReferencePosition {
  std::size_t target = 0;  ///< number of the target in the file
  Direction direction = Direction::up;
  std::size_t cycle = 0;
  double value = 0.0;
  TextPosition at;
};

struct Promise {
  std::size_t count = 0;
  TextPosition at;
};

struct Content {
  const Unit* unit = find_unit("mm");
  std::optional<Promise> cycles;
  std::optional<Promise> positions;
  std::string comment;
  std::map<std::size_t, double> targets;  ///< by their number in the file
  std::vector<ReferencePosition> readings;
  std::unordered_map<std::string, std::size_t> lines;  ///< of every key, to name the first of two
};

Result<std::vector<std::size_t>> indices_from(std::string_view list, TextPosition at) {
  std::vector<std::size_t> indices;
  for (std::string_view part : text::split(list, ',')) {
    const auto index = parse_count(text::trim(part));
    if (!index || *index == 0 || *index > 1'000'000)
      return fail(fmt::format("found the index {}, expected a whole number from 1", text::quoted(part)), at);
    indices.push_back(static_cast<std::size_t>(*index));
  }
  return indices;
}

bool is_data_key(std::string_view key) {
  return key == target_key || std::ranges::find(reading_keys, key) != std::end(reading_keys);
}

/// Nothing for a comment and a blank line. Fails on a line without an equals sign.
Result<std::optional<Assignment>> assignment_from(std::string_view line, std::size_t number) {
  const auto column = [&](std::string_view part) { return static_cast<std::size_t>(part.data() - line.data()) + 1; };
  const std::string_view content = text::trim(line);
  const std::size_t equals = content.find('=');
  if (content.empty() || content.starts_with('#')) return std::nullopt;
  if (equals == std::string_view::npos)
    return fail(fmt::format("found {}, expected KEY=value", text::quoted(content)), {number, column(content)});
  Assignment result;
  result.key = text::trim(content.substr(0, equals));
  result.value = text::trim(content.substr(equals + 1));
  result.key_at = {number, column(content)};
  result.value_at = {number, content.data() == nullptr ? 0 : column(content) + equals + 1};
  const std::size_t bracket = result.key.find('[');
  const std::string_view name = text::trim(result.key.substr(0, bracket));
  if (!is_data_key(name)) return result;
  const std::size_t expected = name == target_key ? 1 : 2;
  if (bracket == std::string_view::npos || !result.key.ends_with(']'))
    return fail(fmt::format("found {}, expected {}{}", text::quoted(result.key), name,
                            expected == 1 ? "[position]" : "[position,cycle]"),
                result.key_at);
  AXIOMETRY_TRY(result.indices,
                indices_from(result.key.substr(bracket + 1, result.key.size() - bracket - 2), result.key_at));
  if (result.indices.size() != expected)
    return fail(fmt::format("found {} with {} indices, expected {}", name, result.indices.size(), expected),
                result.key_at);
  result.key = name;
  return result;
}

Result<double> number_from(const Assignment& a) {
  if (const auto x = parse_number(a.value)) return *x;
  return fail(fmt::format("found {}, expected a finite number", text::quoted(a.value)), a.value_at);
}

Result<Promise> promise_from(const Assignment& a) {
  if (const auto count = parse_count(a.value); count && *count > 0)
    return Promise{static_cast<std::size_t>(*count), a.key_at};
  return fail(fmt::format("found {} = {}, expected a whole number from 1", a.key, text::quoted(a.value)), a.value_at);
}

std::string spelled(const Assignment& a) {
  return a.indices.size() == 1 ? fmt::format("{}[{}]", a.key, a.indices[0])
                               : fmt::format("{}[{},{}]", a.key, a.indices[0], a.indices[1]);
}

Result<void> refuse_repetition(Content& content, const Assignment& a) {
  const std::string key = spelled(a);
  const auto [first, inserted] = content.lines.try_emplace(key, a.key_at.line);
  if (inserted) return {};
  return fail(fmt::format("found {} again, expected only that on line {}", key, first->second), a.key_at);
}

Result<void> take(Content& content, const Assignment& a) {
  if (a.key == target_key) {
    AXIOMETRY_TRY_VOID(refuse_repetition(content, a));
    AXIOMETRY_TRY(content.targets[a.indices[0]], number_from(a));
  } else if (const auto key = std::ranges::find(reading_keys, a.key); key != std::end(reading_keys)) {
    AXIOMETRY_TRY_VOID(refuse_repetition(content, a));
    AXIOMETRY_TRY(const double value, number_from(a));
    const auto direction = static_cast<Direction>(key - std::begin(reading_keys));
    content.readings.push_back({a.indices[0], direction, a.indices[1], value, a.value_at});
  } else if (a.key == "UNIT") {
    content.unit = find_unit(a.value);
    if (content.unit == nullptr)
      return fail(fmt::format("found the unknown unit {}, expected one of {}", text::quoted(a.value), unit_names()),
                  a.value_at);
  } else if (a.key == "CYCLES") {
    AXIOMETRY_TRY(content.cycles, promise_from(a));
  } else if (a.key == "POSITIONS") {
    AXIOMETRY_TRY(content.positions, promise_from(a));
  } else if (std::ranges::find(comment_keys, a.key) != std::end(comment_keys) && !a.value.empty()) {
    content.comment += fmt::format("{}{} {}", content.comment.empty() ? "" : "; ", a.key, a.value);
  }
  return {};
}

Result<Content> content_from(std::string_view text) {
  Content content;
  std::size_t number = 0;
  for (std::string_view line : text::split(text, '\n')) {
    AXIOMETRY_TRY(const auto assignment, assignment_from(line, ++number));
    if (assignment) AXIOMETRY_TRY_VOID(take(content, *assignment));
  }
  return content;
}

std::size_t cycle_count(const Content& content) {
  std::size_t cycles = 0;
  for (const ReferencePosition& r : content.readings) cycles = std::max(cycles, r.cycle);
  return cycles;
}

/// CYCLES and POSITIONS, where they stand, promise how much data follows, but the tools leave them as they were: the
/// data are counted, and a difference is told, because a file may also have been cut off.
std::vector<SourceRemark> count_mismatches(const Content& content) {
  std::vector<SourceRemark> remarks;
  const auto compare = [&](std::string_view key, const std::optional<Promise>& promise, std::size_t found,
                           std::string_view noun) {
    if (promise && promise->count != found)
      remarks.push_back({false, fmt::format("found {}={} on line {} and data of {}; the data were counted", key,
                                            promise->count, promise->at.line, counted(found, noun))});
  };
  compare("POSITIONS", content.positions, content.targets.size(), "position");
  compare("CYCLES", content.cycles, cycle_count(content), "cycle");
  return remarks;
}

Result<Series> series_from(const Content& content) {
  const std::size_t m = content.targets.size();
  const std::size_t runs = cycle_count(content);
  AXIOMETRY_TRY_VOID(check_grid({.targets = m, .runs = runs, .readings = content.readings.size()}));
  std::vector<Position> targets;
  std::unordered_map<std::size_t, std::size_t> order;  // number in the file → place in `targets`
  for (const auto& [number, value] : content.targets) {
    order.emplace(number, targets.size());
    targets.push_back(position_in(*content.unit, value));
  }
  const ReadingRule rule{Measured::position, content.unit};
  std::vector<double> deviations(2 * m * runs, std::numeric_limits<double>::quiet_NaN());
  for (const ReferencePosition& r : content.readings) {
    const auto place = order.find(r.target);
    if (place == order.end())
      return fail(
          fmt::format("found a reading of position {}, expected TGT_DATA[{}] to say its target", r.target, r.target),
          r.at);
    const std::size_t i = place->second;
    const auto d = static_cast<std::size_t>(r.direction);
    AXIOMETRY_TRY(deviations[(d * m + i) * runs + r.cycle - 1],
                  placed(native_deviation(rule, targets[i], r.value), r.at));
  }
  return sorted_series(std::move(targets), runs, std::move(deviations));
}

Result<Test> read(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  AXIOMETRY_TRY(Content content, content_from(decoded.text));
  if (content.targets.empty()) return fail("found no TGT_DATA, expected target positions such as TGT_DATA[1]=0");
  AXIOMETRY_TRY(Series series, series_from(content));
  Metadata metadata;
  metadata.axis.kind = content.unit->kind;
  std::vector<SourceRemark> remarks = encoding_remarks(decoded);
  std::ranges::move(count_mismatches(content), std::back_inserter(remarks));
  metadata.conditions.comment = std::move(content.comment);
  Test test{std::move(metadata), std::move(series), {}};
  test.provenance.remarks = std::move(remarks);
  return test;
}

int recognise(std::string_view head) {
  for (std::string_view line : text::split(head, '\n')) {
    const std::string_view content = text::trim(line);
    if (content.starts_with("TGT_DATA[") || content.starts_with("REF_DATA_FWD[") ||
        content.starts_with("REF_DATA_BWD["))
      return 98;
  }
  return 0;
}

constexpr std::string_view manual =
    R"(Text with lines `KEY=value`, as the ISO 230 tools of ecmc (EtherCAT motion control for EPICS) write them.

```
UNIT=mm
CYCLES=2
POSITIONS=2
TGT_DATA[1]=0
TGT_DATA[2]=100
REF_DATA_FWD[1,1]=.0001
REF_DATA_BWD[1,1]=.0011
…
```

- `TGT_DATA[i]` is a target, `REF_DATA_FWD[i,j]` and `REF_DATA_BWD[i,j]` are positions of the reference instrument in
  cycle j, approached forward (up) and backward (down), all in `UNIT` (default mm). The deviation is the reference
  position minus the target.
- The data are counted; where `CYCLES` or `POSITIONS` say otherwise, a finding tells. Single readings may be missing.
  `REF_PV`, `TEST_PV` and `TGT_SET_PV` go into the comment of the test. Comments (`#`) and other keys are skipped.
- Refused: a key given twice, a reading without a target, numbers that are not finite.
)";

}  // namespace
}  // namespace ecmc_dat

extern const Format ecmc_dat_format;
const Format ecmc_dat_format = {
    .id = "ecmc-dat",
    .title = "ecmc ISO 230 data",
    .extensions = ".dat",
    .manual = ecmc_dat::manual,
    .recognise = ecmc_dat::recognise,
    .read = ecmc_dat::read,
};

}  // namespace axiometry::formats
