// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/sections/source_files.h"

#include "axiometry/base/text/text.h"

namespace axiometry::report {

TableCell file_cell(std::string_view path) {
  if (path.empty()) return quiet_cell("not recorded");
  return path == "-" ? text_cell("standard input") : verbatim_cell(text::without_folders(path));
}

Section provenance_of_files(std::span<const SourceFile> files) {
  Table table;
  table.columns = {{plain("Source"), Align::start, true},
                   {plain("File"), Align::start, true},
                   {plain("SHA-256"), Align::start, false, true}};
  for (const SourceFile& one : files)
    table.rows.push_back({text_cell(one.what), file_cell(one.file),
                          one.sha256.empty() ? quiet_cell("not recorded") : verbatim_cell(one.sha256)});
  Facts facts{"", {{plain("Program"), text_cell(program_text())}}};
  return {"provenance", "Provenance", false, {std::move(table), std::move(facts)}};
}

}  // namespace axiometry::report
