// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "axiometry/app/volumetric/result_model.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/compensation/compensation.h"
#include "axiometry/model/named_finding.h"

/// The use case "tables of the errors for a control".
namespace axiometry::app {

struct ExportRequest {
  std::string result;      ///< file of `axiometry volumetric identify --out`
  std::string table;       ///< id of a formats::Compensation
  std::string tool;        ///< tool for tables of one axis; may be empty where the machine has one
  std::size_t nodes = 21;  ///< nodes along each axis, 2 to 401
};

struct ExportedTable {
  std::string text;                   ///< the bytes of the file
  std::vector<NamedFinding> against;  ///< what speaks against the result it was made from
};

/// Fails as the result file, on an id that no table has (the message lists those there are),
/// and where the lengths do not tell what the table needs.
Result<ExportedTable> exported_table(const ExportRequest& request);

/// The same of a model that is at hand; request.result is only its name. The first lines of the file say what speaks
/// seriously against the result.
Result<ExportedTable> exported_table(KeptModel kept, const ExportRequest& request);

}  // namespace axiometry::app
