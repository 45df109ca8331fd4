// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/axis.h"

namespace axiometry {

std::string_view position_unit(AxisKind kind) { return kind == AxisKind::linear ? "mm" : "°"; }

std::string_view deviation_unit(AxisKind kind) { return kind == AxisKind::linear ? "µm" : "″"; }

std::string_view deviation_unit_key(AxisKind kind) { return kind == AxisKind::linear ? "um" : "arcsec"; }

std::string_view axis_kind_name(AxisKind kind) { return kind == AxisKind::linear ? "linear" : "rotary"; }

}  // namespace axiometry
