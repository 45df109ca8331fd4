// SPDX-License-Identifier: Apache-2.0
//
// The CSV files of measured points that ecmc_cfg_tool writes.
#include <algorithm>

#include "axiometry/formats/devices/ecmc_cfg_table.h"
#include "axiometry/formats/format.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/text_lines.h"
#include "axiometry/formats/text/text_source.h"

namespace axiometry::formats {
namespace ecmc_cfg_csv {
namespace {

Result<Test> read(std::string_view bytes) {
  AXIOMETRY_TRY(const DecodedText decoded, decoded_text(bytes));
  CfgTable table;
  for (const TextLine& line : content_lines(decoded.text)) {
    AXIOMETRY_TRY(std::vector<CsvCell> cells, split_row(line.text, ',', line.number));
    if (table.header.line == 0) {
      table.header = {std::move(cells), line.number};
      continue;
    }
    AXIOMETRY_TRY_VOID(check_cell_count(cells, {.expected = table.header.cells.size(),
                                                .needed = table.header.cells.size(),
                                                .header_line = table.header.line,
                                                .line = line.number,
                                                .delimiter = ',',
                                                .cut_off = !line.has_break}));
    table.rows.push_back({std::move(cells), line.number});
  }
  AXIOMETRY_TRY(Test test, cfg_test(table));
  std::ranges::move(encoding_remarks(decoded), std::back_inserter(test.provenance.remarks));
  return test;
}

/// Only the tool's own columns: another CSV file with an error of a reference is csv-long's.
int recognise(std::string_view head) {
  const auto lines = content_lines(head.substr(0, head.find('\n')));
  if (lines.empty()) return 0;
  const auto header = split_row(lines.front().text, ',', 1);
  if (!header || !is_cfg_header(*header)) return 0;
  const auto is_own = [](const CsvCell& cell) { return cell.text.starts_with("selected_reference"); };
  return std::ranges::any_of(*header, is_own) ? 97 : 0;
}

constexpr std::string_view manual =
    R"(The CSV file of measured points of ecmc_cfg_tool (EtherCAT motion control for EPICS).

```
cycle,direction,target,selected_reference_slot,selected_reference_pv,reference_mean,ref_error,timestamp
1,forward,0,0,IOC:LASER,0.0001,0.0001,2026-01-31T10:00:00
1,forward,100,0,IOC:LASER,100.0004,0.0004,2026-01-31T10:00:10
1,reverse,100,0,IOC:LASER,100.0011,0.0011,2026-01-31T10:00:20
1,reverse,0,0,IOC:LASER,0.0009,0.0009,2026-01-31T10:00:30
```

- The readings are `ref_error`, deviations of the selected reference (`raw_ref_error`, where it stands). Read-back
  errors, other references and standard deviations are not read. forward is ↑, reverse is ↓.
- The file states no unit: lengths are taken in mm, and a remark says so.
- `timestamp` gives the times of the readings and the date of the test. An empty error is a missing reading.
- Where `reference_mean` minus `target` is not the error, a remark tells the largest difference.
- Refused: a row with fewer cells than the header, a reading given twice, other words for the direction.
)";

}  // namespace
}  // namespace ecmc_cfg_csv

extern const Format ecmc_cfg_csv_format;
const Format ecmc_cfg_csv_format = {
    .id = "ecmc-cfg-csv",
    .title = "ecmc_cfg_tool, CSV",
    .extensions = ".csv",
    .manual = ecmc_cfg_csv::manual,
    .recognise = ecmc_cfg_csv::recognise,
    .read = ecmc_cfg_csv::read,
};

}  // namespace axiometry::formats
