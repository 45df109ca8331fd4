// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "axiometry/model/metadata.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// What some ask for beside the parameters of the standard, told only on request
/// (TestConditions::smaller_repeatability) and never judged.
namespace axiometry::iso230_2 {

/// The smaller of R↑ and R↓, which lists of export control call unidirectional positioning repeatability.
struct SmallerRepeatability {
  Deviation value;
  const ParameterInfo* parameter = nullptr;  ///< R↑ or R↓, R↑ where they are equal
};

inline constexpr std::string_view smaller_repeatability_remark =
    "the smaller of R↑ and R↓, called unidirectional positioning repeatability in lists of export control; for "
    "information only: no parameter of the standard, and not judged";

/// Nothing where it was not asked for, or where one of R↑ and R↓ does not exist.
std::optional<SmallerRepeatability> smaller_repeatability(const Metadata& metadata, const AxisParameters& parameters);

}  // namespace axiometry::iso230_2
