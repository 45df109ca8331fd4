// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/model/axis.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// Symbols that name the axis and the parameter together (8.2.4).
namespace axiometry::iso230_2 {

/// E_XX of axis X: its positioning error (ISO 230-1:2012). Empty where the axis has no name that controls give, one
/// capital letter and perhaps a digit, and of a diagonal, whose error is none of one axis.
std::string error_symbol(const Axis& axis);

/// "E_XX,A↑"; empty where the axis has no symbol.
std::string error_symbol(const Axis& axis, const ParameterInfo& parameter);

}  // namespace axiometry::iso230_2
