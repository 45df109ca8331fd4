// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/export_tables.h"

#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/volumetric/result_model.h"

namespace axiometry::app {

Result<ExportedTable> exported_table(const ExportRequest& request) {
  AXIOMETRY_TRY_VOID(formats::compensation_named(request.table));
  AXIOMETRY_TRY(KeptModel kept, kept_model(request.result));
  AXIOMETRY_TRY(std::string text, exported_table(kept.model, request));
  return ExportedTable{std::move(text), std::move(kept.against)};
}

Result<std::string> exported_table(const volumetric::ErrorModel& model, const ExportRequest& request) {
  AXIOMETRY_TRY(const formats::Compensation* compensation, formats::compensation_named(request.table));
  std::size_t tool = 0;
  if (compensation->of_one_tool || !request.tool.empty()) {
    AXIOMETRY_TRY(tool, in_file(tool_of_model(model, request.tool), request.result));
  }
  return in_file(compensation->write({model, tool, request.nodes}), request.result);
}

}  // namespace axiometry::app
