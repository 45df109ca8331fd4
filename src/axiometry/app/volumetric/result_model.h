// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/volumetric/field/error_model.h"

/// What all use cases behind an identification begin with.
namespace axiometry::app {

/// A model as it was kept, and what speaks against it.
struct KeptModel {
  volumetric::ErrorModel model;
  /// Serious findings of the result, each under its own name and as one of what is made of it. But for errors that are
  /// not told: the model has no number for these, and who needs one says so itself.
  std::vector<NamedFinding> against;
};

/// Of a file of `axiometry volumetric identify --out`. Fails as formats::read_error_model(), with the file's name.
Result<KeptModel> kept_model(const std::string& file);

/// Index of the tool; an empty name is the only one there is. Fails with the names there are.
Result<std::size_t> tool_of_model(const volumetric::ErrorModel& model, std::string_view name);

}  // namespace axiometry::app
