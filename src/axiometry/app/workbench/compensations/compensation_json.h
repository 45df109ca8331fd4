// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>

#include "axiometry/app/compensate/compensate.h"
#include "axiometry/app/files/reader.h"
#include "axiometry/app/workbench/compensations/compensations.h"
#include "axiometry/base/json/json.h"

/// Tables of compensation as the API spells them (apps/server/openapi.json), and its requests as values.
namespace axiometry::app {

json::Value controls_to_json(const Reader& reader);  ///< JSON of every control, with its texts in the reader's language
json::Value to_json(std::span<const ListedCompensation> listed, const Reader& reader);
json::Value to_json(const MadeCompensation& made, const Reader& reader);
json::Value to_json(const KeptCompensation& kept, const Reader& reader);

/// What a table of that control does by its own rule: ReadTable. Fails as the table does.
Result<json::Value> read_table_to_json(const nc::AxisTable& control, const nc::AxisTableOptions& options,
                                       std::string_view text);

/// "base_version", which must be there, "reason", "retest", which null takes away, and "notes". Fails, with line and
/// column, on members that are unknown or of another kind, and as given_line(), given_text() and given_number() do.
Result<CompensationRevision> compensation_revision_from(const json::Value& value);

}  // namespace axiometry::app
