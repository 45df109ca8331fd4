// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/files/reader.h"
#include "axiometry/app/volumetric/tables/volume_compensation.h"

/// What the workbench asks of a table from the 21 errors: VolumetricCompensationRequest and VolumetricCompensation of
/// apps/server/openapi.json.
namespace axiometry::app {

/// But for its model. Fails, with line and column, on members that are unknown, missing or of another kind, and as
/// compensate_request_from().
Result<VolumeCompensationRequest> volume_compensation_request_from(const json::Value& body);

/// "Y-siemens-lec.ini"; of a table that moves X by the position of Y "X-by-Y-siemens-cec.ini".
std::string table_file_name(const VolumeCompensation& made);

/// The file with its name, and the result in the reader's language.
json::Value volume_compensation_value(const VolumeCompensation& made, const Reader& reader);

}  // namespace axiometry::app
