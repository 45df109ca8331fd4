// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/tables/export_tables.h"

#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/volumetric/result_model.h"

namespace axiometry::app {

Result<ExportedTable> exported_table(const ExportRequest& request) {
  AXIOMETRY_TRY_VOID(formats::compensation_named(request.table));
  AXIOMETRY_TRY(KeptModel kept, kept_model(request.result));
  return exported_table(std::move(kept), request);
}

Result<ExportedTable> exported_table(KeptModel kept, const ExportRequest& request) {
  AXIOMETRY_TRY(const formats::Compensation* compensation, formats::compensation_named(request.table));
  std::size_t tool = 0;
  if (compensation->of_one_tool || !request.tool.empty()) {
    AXIOMETRY_TRY(tool, in_file(tool_of_model(kept.model, request.tool), request.result));
  }
  AXIOMETRY_TRY(std::string text, in_file(formats::written_table(*compensation, {kept.model, tool, request.nodes},
                                                                 warning_of(kept.against)),
                                          request.result));
  return ExportedTable{std::move(text), std::move(kept.against)};
}

}  // namespace axiometry::app
