// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// Where a tracking interferometer stands, as the other verbs of `axiometry tracking` read it.
namespace axiometry::formats {

/// The result of `axiometry tracking locate --json`: the refined station and its covariance as wide as bounds need it
/// (`covariance_for_bounds`, or, of a result without it, `covariance` widened by widening_for_bounds() of its
/// `chi_squared` and `degrees_of_freedom`). An object that people wrote does as well: {"station": [x, y, z],
/// "covariance": [[…], […], […]]}, in mm and mm², taken as that of a normal station; the covariance may be left out.
/// Other members are passed over.
///
/// Fails, with line and column, on what is no JSON, on a station that is missing or is not three numbers up to 1e9 mm,
/// on one with a serious finding, which the location itself says not to use, as covariance_in() does, and on a χ² that
/// is needed and is no number from 0 on, or degrees of freedom that are no whole number.
Result<Station> read_station(std::string_view bytes);

/// JSON Schema (draft 2020-12) of such files. schema/axiometry-station.schema.json is this text.
json::Value station_schema();

}  // namespace axiometry::formats
