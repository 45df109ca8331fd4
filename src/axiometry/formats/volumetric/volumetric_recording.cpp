// SPDX-License-Identifier: Apache-2.0
//
// A table of lengths or a continuous recording of them?
#include "axiometry/formats/recording.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/formats/text/decoded_text.h"
#include "axiometry/formats/text/table_heads.h"
#include "axiometry/formats/volumetric/volumetric_lengths_csv.h"

namespace axiometry::formats {
namespace {

bool names_station_or_tool(const TableLine& line) {
  const auto cells = split_row(line.text, delimiter_of(line.text), line.number);
  if (!cells) return false;
  for (const CsvCell& cell : *cells) {
    const std::string name = table_head(cell.text).name;
    for (const std::string_view known : {"station", "station id", "tracker", "tool", "tool id", "reflector"})
      if (name == known) return true;
  }
  return false;
}

}  // namespace

bool is_volumetric_recording(std::string_view head) {
  if (!recognise_recording(head)) return false;
  const auto decoded = decoded_text(head);
  if (!decoded) return true;
  bool table = false;
  static_cast<void>(for_table_lines(decoded->text, [&](const TableLine& line) -> Result<void> {
    if (line.content.starts_with('#') || line.content.starts_with('%')) return {};
    table = names_station_or_tool(line);
    return fail("enough");
  }));
  return !table;
}

}  // namespace axiometry::formats
