// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/volumetric/field/error_model.h"

/// What all use cases behind an identification begin with.
namespace axiometry::app {

/// Of a file of `axiometry volumetric identify --out`. Fails as formats::read_error_model(), with the file's name.
Result<volumetric::ErrorModel> model_of_result(const std::string& file);

/// Index of the tool; an empty name is the only one there is. Fails with the names there are.
Result<std::size_t> tool_of_model(const volumetric::ErrorModel& model, std::string_view name);

}  // namespace axiometry::app
