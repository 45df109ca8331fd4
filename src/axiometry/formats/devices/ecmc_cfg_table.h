// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/model/test.h"

/// The table of measured points that ecmc_cfg_tool writes, whether as CSV or in Markdown.
namespace axiometry::formats {

struct CfgRow {
  std::vector<CsvCell> cells;
  std::size_t line = 0;
};

struct CfgTable {
  CfgRow header;
  std::vector<CfgRow> rows;
};

/// Whether the columns are those of the tool: cycle, direction, target and an error of the reference.
bool is_cfg_header(const std::vector<CsvCell>& header);

/// The readings are the errors of the reference as measured ("Raw Ref Err", "ref_error"), never those of the axis's own
/// read-back. Lengths are taken in mm, which the file does not state; a remark says so. Fails, with the place, on a
/// missing column, a cell that is not understood, and as gathered() does.
Result<Test> cfg_test(const CfgTable& table);

}  // namespace axiometry::formats
