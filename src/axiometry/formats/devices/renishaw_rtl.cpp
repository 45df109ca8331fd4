// SPDX-License-Identifier: Apache-2.0
//
// Files in the layout of Renishaw's laser software: .rtl of linear and .rta of rotary axes.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <ranges>

#include "axiometry/base/counted.h"
#include "axiometry/base/read_budget.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/devices/renishaw_rtl_conditions.h"
#include "axiometry/formats/devices/renishaw_rtl_runs.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/series/approaches.h"
#include "axiometry/formats/series/series_order.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/fixed_units.h"
#include "axiometry/formats/text/text_lines.h"
#include "axiometry/formats/text/text_source.h"
#include "axiometry/formats/text/units.h"

namespace axiometry::formats {
namespace renishaw_rtl {
namespace {

constexpr std::size_t target_limit = 1'000'000;

using Sections = std::map<std::string, std::vector<TextLine>>;

std::optional<std::string> section_name(std::string_view line) {
  if (!line.ends_with("::") || line.size() < 3) return std::nullopt;
  return plain_name(line.substr(0, line.size() - 2));
}

/// Whether nothing stands behind the section.
bool is_last_section(const std::vector<TextLine>& lines, std::string_view name) {
  for (const TextLine& line : lines | std::views::reverse)
    if (const auto found = section_name(line.text)) return *found == name;
  return false;
}

Sections sections_of(const std::vector<TextLine>& lines) {
  Sections sections;
  std::vector<TextLine>* section = nullptr;
  for (const TextLine& line : lines) {
    if (const auto name = section_name(line.text)) {
      section = &sections[*name];
    } else if (section != nullptr) {
      section->push_back(line);
    }
  }
  return sections;
}

struct Promise {
  std::size_t count = 0;
  TextPosition at;
};

struct Content {
  bool rotary = false;
  std::vector<double> targets;  ///< in the order of the list
  TextPosition targets_at;
  std::optional<Promise> target_count;
  std::optional<Promise> run_count;
  std::optional<bool> unidirectional;  ///< whether the flags say that the test has one direction
  std::vector<RtlReading> rows;
};

Result<Promise> promise_from(const TaggedValue& item, const TextLine& line) {
  const auto count = parse_count(item.value);
  if (count && *count > 0 && *count <= target_limit) return Promise{static_cast<std::size_t>(*count), {line.number, 1}};
  return fail(fmt::format("found {} = {}, expected a whole number from 1", item.tag, text::quoted(item.value)),
              line.at(item.value));
}

Result<bool> is_rotary(const Sections& sections) {
  if (const auto header = sections.find("header"); header != sections.end())
    for (const TextLine& line : header->second) {
      const auto item = tagged_value(line.text);
      if (!item || (item->tag != "file type" && item->tag != "filetype")) continue;
      if (text::equal_ignoring_case(item->value, "rtl")) return false;
      if (text::equal_ignoring_case(item->value, "rta")) return true;
      return fail(
          fmt::format("found the file type {}, expected rtl (linear) or rta (angular)", text::quoted(item->value)),
          line.at(item->value));
    }
  return fail("found no file type, expected HEADER:: with 'File type : rtl' (linear) or 'rta' (angular)");
}

class ContentReader {
 public:
  Result<Content> read(const Sections& sections) {
    AXIOMETRY_TRY(content_.rotary, is_rotary(sections));
    AXIOMETRY_TRY_VOID(each(sections, "target data", &ContentReader::take_target_line));
    if (content_.targets.empty()) return fail("found no targets, expected a list of them below 'Targets :'");
    AXIOMETRY_TRY_VOID(each(sections, "runs", &ContentReader::take_run_line));
    AXIOMETRY_TRY_VOID(each(sections, "deviations", &ContentReader::take_deviation_line));
    return std::move(content_);
  }

 private:
  Result<void> each(const Sections& sections, const std::string& name,
                    Result<void> (ContentReader::*take)(const TextLine&)) {
    const auto section = sections.find(name);
    if (section == sections.end())
      return fail(fmt::format("found no section {}::, expected HEADER::, TARGET DATA::, RUNS:: and DEVIATIONS::",
                              name == "target data" ? "TARGET DATA"
                              : name == "runs"      ? "RUNS"
                                                    : "DEVIATIONS"));
    for (const TextLine& line : section->second) AXIOMETRY_TRY_VOID((this->*take)(line));
    return {};
  }

  Result<void> take_targets(std::string_view list, const TextLine& line) {
    for (std::string_view word : text::words(list)) {
      AXIOMETRY_TRY(const double target, numbers_.read(word, line.at(word)));
      if (content_.targets.empty()) content_.targets_at = line.at(word);
      content_.targets.push_back(target);
    }
    return {};
  }

  Result<void> take_target_line(const TextLine& line) {
    const auto item = tagged_value(line.text);
    if (!item) return in_targets_ ? take_targets(line.text, line) : Result<void>();
    in_targets_ = item->tag == "targets";
    if (in_targets_) return take_targets(item->value, line);
    if (item->tag == "target count") {
      AXIOMETRY_TRY(content_.target_count, promise_from(*item, line));
    }
    if (item->tag == "flags") {
      const auto flags = text::words(item->value);
      if (flags.size() >= 2 && (flags[1] == "0" || flags[1] == "1")) content_.unidirectional = flags[1] == "1";
    }
    return {};
  }

  Result<void> take_run_line(const TextLine& line) {
    const auto item = tagged_value(line.text);
    if (item && item->tag == "run count") {
      AXIOMETRY_TRY(content_.run_count, promise_from(*item, line));
    }
    return {};
  }

  Result<std::size_t> number_up_to(std::size_t limit, std::string_view what, std::string_view word,
                                   const TextLine& line) {
    const auto number = parse_count(word);
    if (number && *number >= 1 && *number <= limit) return static_cast<std::size_t>(*number);
    return fail(fmt::format("found the {} {}, expected a whole number from 1 to {}", what, text::quoted(word), limit),
                line.at(word));
  }

  Result<void> take_deviation_line(const TextLine& line) {
    const auto names = tagged_value(line.text);  // of the columns; some go on with the first reading
    if (names && names->value.find_first_of("0123456789") != 0) return {};
    const auto words = text::words(names ? std::string_view(names->value) : line.text);
    if (words.size() != 3)
      return fail(fmt::format("found {}, expected three numbers: run, target and deviation{}", text::quoted(line.text),
                              line.has_break ? "" : "; the file ends here, is it cut off?"),
                  {line.number, line.column});
    RtlReading row{.at = line.at(words[0])};
    AXIOMETRY_TRY(row.run, number_up_to(2 * read_budget::runs, "run", words[0], line));
    AXIOMETRY_TRY(row.target, number_up_to(content_.targets.size(), "target", words[1], line));
    AXIOMETRY_TRY(row.value, numbers_.read(words[2], line.at(words[2])));
    content_.rows.push_back(row);
    return {};
  }

  Content content_;
  NumberReader numbers_{' '};
  bool in_targets_ = false;
};

Result<void> check_counts(const Content& content) {
  const std::size_t m = content.targets.size();
  if (content.target_count && content.target_count->count != m)
    return fail(fmt::format("found Target-count {} and a list of {}, expected the same number",
                            content.target_count->count, counted(m, "target")),
                content.target_count->at);
  if (content.rows.empty()) return fail("found no readings below DEVIATIONS::, expected one per line");
  const std::size_t runs = rtl_run_count(content.rows);
  if (content.run_count && content.run_count->count != runs)
    return fail(fmt::format("found Run-count {} and data of {}, expected the same number of one-way runs",
                            content.run_count->count, counted(runs, "run")),
                content.run_count->at);
  std::vector<bool> measured(m);
  for (const RtlReading& row : content.rows) measured[row.target - 1] = true;
  if (const auto none = std::ranges::find(measured, false); none != measured.end())
    return fail(fmt::format("found no reading of target {} ({}), expected at least one", none - measured.begin() + 1,
                            format_exact(content.targets[static_cast<std::size_t>(none - measured.begin())])),
                content.targets_at);
  return {};
}

/// The direction of the first run: that in which the list of targets goes.
Result<Direction> first_direction(const Content& content) {
  const auto& t = content.targets;
  if (std::ranges::adjacent_find(t, std::greater_equal<>()) == t.end()) return Direction::up;
  if (std::ranges::adjacent_find(t, std::less_equal<>()) == t.end()) return Direction::down;
  return fail("found targets in no order, expected them to ascend or to descend, which tells the direction of runs",
              content.targets_at);
}

Direction opposite(Direction direction) { return direction == Direction::up ? Direction::down : Direction::up; }

Result<std::vector<ListedReading>> approaches_from(const Content& content, const RtlRunRule& rule) {
  const Unit& target_unit = *find_unit(content.rotary ? "deg" : "mm");
  const ReadingRule reading{Measured::deviation, find_unit(content.rotary ? "mrad" : "um")};
  AXIOMETRY_TRY(const Direction first, first_direction(content));
  std::vector<ListedReading> approaches;
  for (const RtlReading& row : content.rows) {
    if (rule.absent[row.run - 1]) continue;
    const bool returns = !rule.one_way && row.run % 2 == 0;
    const Position target = position_in(target_unit, content.targets[row.target - 1]);
    AXIOMETRY_TRY(const double deviation, placed(native_deviation(reading, target, row.value), row.at));
    approaches.push_back({.target = target,
                          .direction = returns ? opposite(first) : first,
                          .run = rule.one_way ? row.run : (row.run + 1) / 2,
                          .deviation = Deviation::native(deviation),
                          .at = row.at});
  }
  return approaches;
}

std::span<const TextLine> lines_of(const Sections& sections, const std::string& name) {
  const auto section = sections.find(name);
  return section == sections.end() ? std::span<const TextLine>() : std::span<const TextLine>(section->second);
}

Result<Test> read(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  const std::vector<TextLine> lines = content_lines(decoded.text);
  const Sections sections = sections_of(lines);
  AXIOMETRY_TRY(const Content content, ContentReader().read(sections));
  if (content.rotary)
    AXIOMETRY_TRY_VOID(expect_fixed_units(lines, {"deg", "mrad"}));
  else
    AXIOMETRY_TRY_VOID(expect_fixed_units(lines, {"mm", "um"}));
  AXIOMETRY_TRY_VOID(check_counts(content));
  AXIOMETRY_TRY(RtlRunRule rule, rtl_run_rule(content.rows, content.unidirectional));
  AXIOMETRY_TRY(const std::vector<ListedReading> approaches, approaches_from(content, rule));
  AXIOMETRY_TRY(GatheredSeries gathered_series, gathered(approaches));
  const AxisKind kind = content.rotary ? AxisKind::rotary : AxisKind::linear;
  AXIOMETRY_TRY_VOID(placed(check_deviations(gathered_series.series, kind), content.rows.front().at));
  Metadata metadata;
  metadata.axis.kind = kind;
  Provenance provenance;
  provenance.remarks = encoding_remarks(decoded);
  std::ranges::move(rule.remarks, std::back_inserter(provenance.remarks));
  if (!lines.back().has_break && is_last_section(lines, "deviations"))
    provenance.remarks.push_back(
        {false,
         "the file ends within a line of readings, expected EOF:: or another section behind them: its last "
         "reading may be cut off"});
  if (content.rotary)
    provenance.remarks.push_back(
        {false,
         "found an angular file; it was taken as the test of a rotary axis, targets in degrees "
         "and deviations in mrad, and not as pitch or yaw of a linear axis"});
  const RtlConditions conditions{lines_of(sections, "user text"), lines_of(sections, "equipment"),
                                 lines_of(sections, "environment")};
  AXIOMETRY_TRY(std::vector<SourceRemark> remarks, add_conditions(metadata, conditions));
  std::ranges::move(remarks, std::back_inserter(provenance.remarks));
  return Test{std::move(metadata), std::move(gathered_series.series), std::move(provenance)};
}

int recognise(std::string_view head) {
  int sections = 0;
  for (const TextLine& line : content_lines(head))
    if (const auto name = section_name(line.text))
      sections += *name == "header" || *name == "target data" || *name == "runs" || *name == "deviations";
  return sections >= 2 ? 97 : sections == 1 ? 60 : 0;
}

constexpr std::string_view manual =
    R"(Text in sections, as Renishaw's laser software (Laser10, XCal) and programs for it write them.

```
HEADER::
File type  : rtl
TARGET DATA::
Filetype  : ISO
Target-count: 3
Targets :
0.000000  50.000000  100.000000
Flags: 0 0 2 0
USER-TEXT::
Machine: Mill 5
Axis: X
RUNS::
Run-count: 2
DEVIATIONS::
Run Target Data:
   1    1    0.100
   1    2    0.400
   1    3    0.700
   2    3    1.900
   2    2    1.600
   2    1    1.100
EOF::
```

- `File type` rtl: targets in mm, deviations in µm. rta: targets in degrees of a rotary axis, deviations in mrad (a file
  of pitch or yaw along a linear axis looks the same and is no positioning test).
- Readings are placed by the columns of run and target, not by the order of the rows. Runs count one way: odd runs go
  along the list of targets, even ones return. A list that ascends makes odd runs ↑, one that descends makes them ↓.
- The order of the target numbers within a run must confirm that. Where all even runs are listed along the list, the
  second of `Flags` decides: 0 bidirectional (rows were sorted), 1 unidirectional (every run goes the same way); without
  flags the file is refused. Even runs of zeros alone in a unidirectional file are taken as absent.
- The sign is taken as found: deviation = measured minus target. Some programs can write it reversed.
- `Target-count` and `Run-count`, when they stand in the file, must agree with the data.
- Machine, Serial No, Date, By, Axis, Location and TITLE, the equipment, and from `ENVIRONMENT::` Air temp (°C), Air
  Press (mbar, or with a unit), Air Humid, Mat temp, Exp coeff and Date Time go into the metadata; what stands behind
  `Final Data` is taken as the end of the test. A sensor that shows 0 is taken as not connected, with a remark.
- Encodings: UTF-8, UTF-16, GBK, Windows-1252, Latin-1. Decimal point or comma.
- Refused: an unknown file type, targets in no order, a target without readings, a reading given twice, runs whose order
  contradicts their number.
)";

}  // namespace
}  // namespace renishaw_rtl

extern const Format renishaw_rtl_format;
const Format renishaw_rtl_format = {
    .id = "renishaw-rtl",
    .title = "Renishaw laser, linear or angular",
    .extensions = ".rtl .rta",
    .manual = renishaw_rtl::manual,
    .recognise = renishaw_rtl::recognise,
    .read = renishaw_rtl::read,
};

}  // namespace axiometry::formats
