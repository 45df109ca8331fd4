// SPDX-License-Identifier: Apache-2.0
//
// The project's own format: JSON of metadata and readings. Its schema, of test_schema.cpp, reads the same tables.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>

#include "axiometry/base/counted.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/series/series_order.h"
#include "axiometry/formats/test/metadata_json.h"
#include "axiometry/formats/test/source_json.h"
#include "axiometry/formats/test/test_schema.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

constexpr std::string_view own_members[] = {"$schema", "format", "source", "series", "times_s"};

Result<const Value*> member(const Value& object, std::string_view name, Kind kind, std::string_view expected) {
  if (!object.is(Kind::object))
    return fail(
        fmt::format("found the kind {}, expected an object with a member \"{}\"", json::kind_name(object.kind()), name),
        object.at());
  const Value* value = object.find(name);
  if (value == nullptr) return fail(fmt::format("found no member \"{}\", expected {}", name, expected), object.at());
  if (!value->is(kind))
    return fail(
        fmt::format("found \"{}\" that is of the kind {}, expected {}", name, json::kind_name(value->kind()), expected),
        value->at());
  return value;
}

Result<const Unit*> unit_from(const Value& series, std::string_view name) {
  AXIOMETRY_TRY(const Value* value, member(series, name, Kind::text, "the name of a unit such as \"um\" or \"mm\""));
  if (const Unit* unit = find_unit(value->text())) return unit;
  return fail(fmt::format("found the unknown unit {}, expected one of {}", text::quoted(value->text()), unit_names()),
              value->at());
}

Result<Measured> measured_from(const Value& series) {
  const Value* value = series.find("quantity");
  if (value == nullptr) return Measured::deviation;
  const std::string found = value->is(Kind::text) ? value->text() : std::string(json::kind_name(value->kind()));
  if (value->is(Kind::text) && found == "deviation") return Measured::deviation;
  if (value->is(Kind::text) && found == "position") return Measured::position;
  return fail(fmt::format("found {}, expected \"deviation\" or \"position\"", text::quoted(found)), value->at());
}

struct Targets {
  std::vector<Position> positions;
  TextPosition at;
};

Result<Targets> targets_from(const Value& series, const Unit& unit) {
  AXIOMETRY_TRY(const Value* list, member(series, "targets", Kind::array, "an array of at least 2 target positions"));
  Targets targets{{}, list->at()};
  std::vector<std::pair<Position, TextPosition>> seen;
  for (const Value& item : list->items()) {
    if (!item.is(Kind::number))
      return fail(fmt::format("found a target of the kind {}, expected a number", json::kind_name(item.kind())),
                  item.at());
    targets.positions.push_back(position_in(unit, item.number()));
    seen.emplace_back(targets.positions.back(), item.at());
  }
  std::ranges::stable_sort(seen, {}, &std::pair<Position, TextPosition>::first);
  const auto twice = std::ranges::adjacent_find(seen, {}, &std::pair<Position, TextPosition>::first);
  if (twice != seen.end())
    return fail(fmt::format("found the target {} a second time, expected each once", twice->first.in_native()),
                (twice + 1)->second);
  return targets;
}

/// The runs of one direction; nullptr when the direction was not measured.
Result<const Value*> runs_from(const Value& series, std::string_view direction, std::size_t target_count) {
  const Value* runs = series.find(direction);
  if (runs == nullptr || runs->is(Kind::null)) return nullptr;
  AXIOMETRY_TRY(runs, member(series, direction, Kind::array, "an array of runs"));
  for (const Value& run : runs->items()) {
    if (!run.is(Kind::array))
      return fail(fmt::format("found a run of the kind {}, expected an array of numbers", json::kind_name(run.kind())),
                  run.at());
    if (run.items().size() != target_count)
      return fail(fmt::format("found a run of {}, expected {}, one per target (null where it is missing)",
                              counted(run.items().size(), "reading"), target_count),
                  run.at());
  }
  return runs;
}

struct RunsPerDirection {
  const Value* runs[2] = {};  ///< up and down; null when not there
  std::size_t run_count = 0;
};

/// "up" and "down" of the readings or of their times.
Result<RunsPerDirection> directions_from(const Value& object, std::size_t target_count) {
  RunsPerDirection result;
  constexpr std::string_view directions[] = {"up", "down"};
  for (std::size_t d = 0; d < 2; ++d) {
    AXIOMETRY_TRY(result.runs[d], runs_from(object, directions[d], target_count));
    if (result.runs[d] != nullptr) result.run_count = std::max(result.run_count, result.runs[d]->items().size());
  }
  return result;
}

Result<double> reading_from(const Value& value, const ReadingRule& rule, Position target) {
  if (value.is(Kind::null)) return std::numeric_limits<double>::quiet_NaN();
  if (!value.is(Kind::number))
    return fail(fmt::format("found a reading of the kind {}, expected a number or null", json::kind_name(value.kind())),
                value.at());
  return placed(native_deviation(rule, target, value.number()), value.at());
}

/// Readings that a JSON text of a few bytes may claim: runs × targets are all spelled out, so only a
/// direction that is missing altogether can double what stands there.
Result<Series> series_from(const Value& series, const ReadingRule& rule, const Unit& target_unit) {
  AXIOMETRY_TRY(Targets targets, targets_from(series, target_unit));
  const std::size_t m = targets.positions.size();
  AXIOMETRY_TRY(const RunsPerDirection found, directions_from(series, m));
  const auto& [runs, run_count] = found;
  if (run_count == 0) return fail("found no runs, expected readings in \"up\" or \"down\" or both", series.at());
  std::vector<double> deviations(2 * m * run_count, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t d = 0; d < 2; ++d) {
    for (std::size_t j = 0; runs[d] != nullptr && j < runs[d]->items().size(); ++j) {
      const auto& readings = runs[d]->items()[j].items();
      for (std::size_t i = 0; i < m; ++i) {
        AXIOMETRY_TRY(deviations[(d * m + i) * run_count + j], reading_from(readings[i], rule, targets.positions[i]));
      }
    }
  }
  return placed(sorted_series(std::move(targets.positions), run_count, std::move(deviations)), targets.at);
}

/// Times stand as readings do, in the order of the targets of the file; here they follow the ascending ones.
Result<std::vector<double>> times_from(const Value& times, const Value& series, std::size_t run_count) {
  if (times.is(Kind::null)) return std::vector<double>{};
  if (!times.is(Kind::object))
    return fail(fmt::format("found \"times_s\" that is of the kind {}, expected an object with up and down",
                            json::kind_name(times.kind())),
                times.at());
  for (const auto& [name, value] : times.members())
    if (name != "up" && name != "down")
      return fail(fmt::format("found the unknown member {} in times_s, expected up and down", text::quoted(name)),
                  value.at());
  const auto& targets = series.find("targets")->items();
  const std::size_t m = targets.size();
  AXIOMETRY_TRY(const RunsPerDirection found, directions_from(times, m));
  if (found.run_count > run_count)
    return fail(fmt::format("found times of {}, expected at most {} as there are readings of",
                            counted(found.run_count, "run"), run_count),
                times.at());
  std::vector<std::size_t> order(m);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t k) { return targets[k].number(); });
  std::vector<double> result(2 * m * run_count, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t d = 0; d < 2; ++d)
    for (std::size_t j = 0; found.runs[d] != nullptr && j < found.runs[d]->items().size(); ++j)
      for (std::size_t i = 0; i < m; ++i) {
        const Value& time = found.runs[d]->items()[j].items()[order[i]];
        if (time.is(Kind::null)) continue;
        if (!time.is(Kind::number))
          return fail(
              fmt::format("found a time of the kind {}, expected seconds or null", json::kind_name(time.kind())),
              time.at());
        result[(d * m + i) * run_count + j] = time.number();
      }
  return result;
}

constexpr std::string_view series_members[] = {"quantity", "unit", "target_unit", "targets", "up", "down"};

Result<void> check_series_members(const Value& series) {
  for (const auto& [name, value] : series.members()) {
    if (std::ranges::find(series_members, std::string_view(name)) != std::end(series_members)) continue;
    const auto near = text::nearest(name, {std::begin(series_members), std::end(series_members)});
    return fail(fmt::format("found the unknown member {} in series, expected {}", text::quoted(name),
                            near ? fmt::format("perhaps {}", text::quoted(*near))
                                 : fmt::format("one of {}", fmt::join(series_members, ", "))),
                value.at());
  }
  return {};
}

Result<void> check_format(const Value& root) {
  AXIOMETRY_TRY(const Value* format,
                member(root, "format", Kind::text, fmt::format("\"format\": \"{}\"", test_format_name)));
  if (format->text() == test_format_name) return {};
  return fail(fmt::format("found the format {}, expected \"{}\"", text::quoted(format->text()), test_format_name),
              format->at());
}

/// "axis": {"kind": …} may be left out; when it is there, the units must agree with it.
Result<void> settle_kind(Metadata& metadata, const Value& root, AxisKind kind_by_units) {
  const Value* axis = root.find("axis");
  const Value* kind = axis != nullptr && axis->is(Kind::object) ? axis->find("kind") : nullptr;
  if (kind != nullptr && kind->is(Kind::text) && metadata.axis.kind != kind_by_units)
    return fail(fmt::format("found axis.kind {} and readings in units of a {} axis, expected the same",
                            text::quoted(kind->text()), kind_by_units == AxisKind::linear ? "linear" : "rotary"),
                kind->at());
  metadata.axis.kind = kind_by_units;
  return {};
}

Result<Test> read(std::string_view bytes) {
  AXIOMETRY_TRY(const std::string_view text, readable_text(bytes));
  AXIOMETRY_TRY(const Value root, json::parse(text));
  if (!root.is(Kind::object)) return fail("found JSON that is no object, expected a test", root.at());
  AXIOMETRY_TRY_VOID(check_format(root));
  AXIOMETRY_TRY(Metadata metadata, metadata_from(root, own_members));
  AXIOMETRY_TRY(const Value* series, member(root, "series", Kind::object, "an object with targets and readings"));
  AXIOMETRY_TRY_VOID(check_series_members(*series));
  AXIOMETRY_TRY(const Measured measured, measured_from(*series));
  AXIOMETRY_TRY(const Unit* unit, unit_from(*series, "unit"));
  AXIOMETRY_TRY(const Unit* target_unit, unit_from(*series, "target_unit"));
  AXIOMETRY_TRY(const AxisKind kind, placed(kind_of(*target_unit, *unit), series->find("unit")->at()));
  AXIOMETRY_TRY_VOID(settle_kind(metadata, root, kind));
  AXIOMETRY_TRY(Series readings, series_from(*series, {measured, unit}, *target_unit));
  if (measured == Measured::deviation) AXIOMETRY_TRY_VOID(placed(check_deviations(readings, kind), series->at()));
  Test test{std::move(metadata), std::move(readings), {}};
  if (const Value* times = root.find("times_s")) {
    AXIOMETRY_TRY(test.times_s, times_from(*times, *series, test.series.run_count()));
  }
  if (const Value* source = root.find("source")) {
    AXIOMETRY_TRY(test.provenance.remarks, source_from(*source));
  }
  return test;
}

/// Runs up to the last one with a reading: a direction with fewer runs than the other is not padded.
std::size_t runs_measured(const Series& series, Direction direction) {
  for (std::size_t j = series.run_count(); j > 0; --j)
    for (std::size_t i = 0; i < series.target_count(); ++i)
      if (series.reading(i, direction, j - 1)) return j;
  return 0;
}

Value runs_to_json(const Series& series, Direction direction, std::size_t run_count) {
  Value runs = Value::array();
  for (std::size_t j = 0; j < run_count; ++j) {
    Value& run = runs.push(Value::array());
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const auto reading = series.reading(i, direction, j);
      run.push(reading ? Value(reading->in_native()) : Value());
    }
  }
  return runs;
}

Value series_to_json(const Series& series, AxisKind kind) {
  const bool linear = kind == AxisKind::linear;
  Value result = Value::object();
  result.add("quantity", "deviation");
  result.add("unit", linear ? "um" : "arcsec");
  result.add("target_unit", linear ? "mm" : "deg");
  Value& targets = result.add("targets", Value::array());
  for (Position p : series.targets()) targets.push(p.in_native());
  std::size_t up = runs_measured(series, Direction::up);
  std::size_t down = runs_measured(series, Direction::down);
  // A last run without any reading still counts as a run.
  if (std::max(up, down) < series.run_count()) (up > 0 ? up : down) = series.run_count();
  if (up > 0) result.add("up", runs_to_json(series, Direction::up, up));
  if (down > 0) result.add("down", runs_to_json(series, Direction::down, down));
  return result;
}

/// A direction without any time is left out; without any time at all there is no object.
Value times_to_json(const Test& test) {
  Value result = Value::object();
  const std::size_t m = test.series.target_count();
  const std::size_t n = test.series.run_count();
  constexpr std::string_view directions[] = {"up", "down"};
  for (std::size_t d = 0; d < 2; ++d) {
    const auto times = std::span(test.times_s).subspan(d * m * n, m * n);
    if (std::ranges::all_of(times, [](double t) { return std::isnan(t); })) continue;
    Value& runs = result.add(directions[d], Value::array());
    for (std::size_t j = 0; j < n; ++j) {
      Value& run = runs.push(Value::array());
      for (std::size_t i = 0; i < m; ++i) run.push(std::isnan(times[i * n + j]) ? Value() : Value(times[i * n + j]));
    }
  }
  return result;
}

std::string write(const Test& test) {
  Value root = Value::object();
  root.add("format", test_format_name);
  if (!test.provenance.file.empty()) root.add("source", source_to_json(test.provenance));
  add_metadata(root, test.metadata);
  root.add("series", series_to_json(test.series, test.metadata.axis.kind));
  if (!test.times_s.empty())
    if (Value times = times_to_json(test); !times.members().empty()) root.add("times_s", std::move(times));
  return json::dump(root) + "\n";
}

int recognise(std::string_view head) {
  if (!text::trim(head).starts_with('{')) return 0;
  return head.find("axiometry-test/") != std::string_view::npos ? 100 : 30;
}

constexpr std::string_view manual = R"(One JSON object (RFC 8259, UTF-8). `axiometry schema` prints its JSON Schema.

```json
{
  "format": "axiometry-test/1",
  "machine": {"name": "Mill 5"},
  "axis": {"name": "X", "kind": "linear"},
  "series": {
    "quantity": "deviation",
    "unit": "um",
    "target_unit": "mm",
    "targets": [0, 250, 500, 750, 1000],
    "up": [[0.1, 0.4, 0.9, 1.1, 1.4], [0.2, 0.4, 0.8, 1.0, null]],
    "down": [[0.9, 1.1, 1.6, 1.9, 2.0], [0.8, 1.2, 1.5, 1.8, 2.1]]
  }
}
```

- `series.quantity`: `deviation` (actual minus target; the default) or `position` (the measured position).
- `series.unit`, `series.target_unit`: units of readings and targets. Lengths make a linear axis, angles a rotary one.
- `series.targets`: every target once, in any order. `up` and `down` hold one list per run with one reading per
  target, **in the order of `targets`**, not in the order of the measurement; `null` where a reading is missing. A
  direction that was not measured is left out.
- `times_s`: when each reading was taken, s since some beginning, in the shape of `up` and `down`; optional.
- `source`: the file or stream that this one was taken from (`file`, `sha256`, empty when not known, `format`), what
  was guessed or left out of it (`remarks`), `departures`, for which it is no test after ISO 230-2, and whether its
  targets run the other way than its labels of direction say (`swapped_labels`); optional.
- The other members are the metadata of the test, all optional.

Refused: unknown members, members given twice, numbers that overflow, runs of the wrong length, nesting deeper
than 64 levels, more than 64 MiB.
)";

}  // namespace

extern const Format axiometry_json_format;
const Format axiometry_json_format = {
    .id = "json",
    .title = "Axiometry test, JSON",
    .extensions = ".json",
    .manual = manual,
    .recognise = recognise,
    .read = read,
    .write = write,
};

}  // namespace axiometry::formats
