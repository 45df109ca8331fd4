// SPDX-License-Identifier: Apache-2.0
//
// The reports of ecmc_cfg_tool in Markdown: their table of measured points.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/devices/ecmc_cfg_table.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/text_lines.h"
#include "axiometry/model/fields.h"

namespace axiometry::formats {
namespace ecmc_cfg_md {
namespace {

constexpr std::string_view heading = "## Raw Measured Points";
constexpr std::string_view dwell_item = "- Settle time:";
constexpr std::string_view reference_item = "Selected reference";

bool is_heading(std::string_view line) { return text::equal_ignoring_case(line, heading); }

/// The cells between the bars of a row.
std::vector<CsvCell> row_cells(const TextLine& line) {
  std::string_view inner = line.text.substr(1);
  if (inner.ends_with('|')) inner.remove_suffix(1);
  std::vector<CsvCell> cells;
  for (std::string_view part : text::split(inner, '|')) {
    const std::string_view content = text::trim(part);
    cells.push_back({std::string(content), line.at(content).column});
  }
  return cells;
}

bool is_rule(const std::vector<CsvCell>& cells) {
  return std::ranges::all_of(cells, [](const CsvCell& cell) {
    return cell.text.find_first_not_of(":- ") == std::string::npos && cell.text.contains('-') &&
           cell.text.find_first_of("0123456789") == std::string::npos;
  });
}

/// What stands between the first two backquotes.
std::optional<std::string_view> quoted_part(std::string_view line) {
  const std::size_t begin = line.find('`');
  const std::size_t end = begin == std::string_view::npos ? begin : line.find('`', begin + 1);
  if (end == std::string_view::npos) return std::nullopt;
  return text::trim(line.substr(begin + 1, end - begin - 1));
}

struct Report {
  CfgTable points;
  std::string reference;
  std::string settle_time_s;
};

Result<Report> report_from(std::string_view text) {
  Report report;
  bool below_heading = false;
  for (const TextLine& line : content_lines(text)) {
    const auto value = quoted_part(line.text);
    if (line.text.starts_with(dwell_item) && value && value->ends_with(" s"))
      report.settle_time_s = text::trim(value->substr(0, value->size() - 2));
    if (line.text.starts_with('#')) below_heading = is_heading(line.text);
    if (!below_heading) continue;
    if (line.text.starts_with(reference_item) && value) report.reference = *value;
    if (!line.text.starts_with('|')) continue;
    std::vector<CsvCell> cells = row_cells(line);
    if (report.points.header.line == 0) {
      report.points.header = {std::move(cells), line.number};
      continue;
    }
    if (is_rule(cells)) continue;
    if (cells.size() != report.points.header.cells.size())
      return fail(fmt::format("found {}, expected {} as in the header on line {}{}", counted(cells.size(), "cell"),
                              report.points.header.cells.size(), report.points.header.line,
                              line.has_break ? "" : "; the file ends here, is it cut off?"),
                  {line.number, line.column});
    report.points.rows.push_back({std::move(cells), line.number});
  }
  if (report.points.header.line == 0) return fail(fmt::format("found no table below '{}', expected one", heading));
  return report;
}

Result<Test> read(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  AXIOMETRY_TRY(const Report report, report_from(decoded.text));
  AXIOMETRY_TRY(Test test, cfg_test(report.points));
  if (!report.reference.empty()) test.metadata.conditions.comment = fmt::format("Reference {}", report.reference);
  if (!report.settle_time_s.empty() && !set_field_text(test.metadata, "test.dwell_s", report.settle_time_s))
    test.provenance.remarks.push_back(
        {false, fmt::format("found the settle time {}, which was not understood", text::quoted(report.settle_time_s))});
  std::ranges::move(encoding_remarks(decoded), std::back_inserter(test.provenance.remarks));
  return test;
}

int recognise(std::string_view head) {
  bool title = false;
  for (const TextLine& line : content_lines(head)) {
    if (is_heading(line.text)) return 97;
    title |= line.text.starts_with("# ecmc ISO 230");
  }
  return title ? 80 : 0;  // the table may stand far below the pictures
}

constexpr std::string_view manual =
    R"(The report of ecmc_cfg_tool (EtherCAT motion control for EPICS) in Markdown.

```
# ecmc ISO 230 Bidirectional Positioning Report

- Settle time: `1.00000 s`

## Raw Measured Points

Selected reference for report/error columns: `IOC:LASER`

| Cycle | Direction | Target | Raw Ref Mean | Raw Ref Err | RBV Err | Timestamp |
| --- | --- | --- | --- | --- | --- | --- |
| 1 | forward | 0.00000 | 0.00010 | 0.00010 | 0.00001 | 2026-01-31 10:00:00 |
| 1 | forward | 100.00000 | 100.00040 | 0.00040 | 0.00001 | 2026-01-31 10:00:10 |
| 1 | reverse | 100.00000 | 100.00110 | 0.00110 | 0.00001 | 2026-01-31 10:00:20 |
| 1 | reverse | 0.00000 | 0.00090 | 0.00090 | 0.00001 | 2026-01-31 10:00:30 |
```

- Read is the table below `## Raw Measured Points`; the results above it are computed again. The readings are
  `Raw Ref Err` (older reports: `Ref Err`), never `RBV Err`, which is what the axis says about itself.
- The digits shown are all there is: the CSV file of the same test (`ecmc-cfg-csv`) has more.
- The report states no unit: lengths are taken in mm, and a remark says so.
- `Settle time` becomes the dwell time, `Timestamp` the times of the readings and the date of the test.
- Refused: a row with other than the header's number of cells, a reading given twice.
)";

}  // namespace
}  // namespace ecmc_cfg_md

extern const Format ecmc_cfg_md_format;
const Format ecmc_cfg_md_format = {
    .id = "ecmc-cfg-md",
    .title = "ecmc_cfg_tool, report",
    .extensions = ".md",
    .manual = ecmc_cfg_md::manual,
    .recognise = ecmc_cfg_md::recognise,
    .read = ecmc_cfg_md::read,
};

}  // namespace axiometry::formats
