// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/field/error_model.h"

/// The part of a result file that the field, predictions and tables are computed from: machine, curves, coefficients
/// and their covariance.
namespace axiometry::formats {

/// {"machine", "reversal", "curves": {"X": {"kind", "size", "range_mm"}, …}, "coefficients", "covariance" (lower
/// triangle by rows, in places of the coefficients), "unseen", "observed_mm"}.
json::Value error_model_value(const volumetric::ErrorModel& model);

/// Fails, with line and column, on anything that is not as error_model_value() writes it, on a covariance with a
/// variance below 0, and on more than 4000 coefficients.
Result<volumetric::ErrorModel> error_model_from(const json::Value& value);

/// JSON Schema of a result file.
json::Value volumetric_result_schema();

/// Of the member "model" of a result file.
Result<volumetric::ErrorModel> read_error_model(std::string_view bytes);
Result<volumetric::ErrorModel> error_model_of(const json::Value& result);

}  // namespace axiometry::formats
