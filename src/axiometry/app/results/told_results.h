// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/base/json/json_place.h"

/// The shape of a result in JSON, told once: to_json() and its like of result_json.h and uncertainty_json.h make a tree
/// of it, json_line() a text.
namespace axiometry::app {

void put_result(json::Place place, const Evaluated& evaluated);
void put_uncertainty(json::Place place, const iso230_2::Assessment& assessment);
void put_parameters(json::Place place, const iso230_2::AxisParameters& parameters);

std::optional<double> native_number(const std::optional<Deviation>& x);

}  // namespace axiometry::app
