// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/volumetric/curves/curve_basis.h"
#include "axiometry/volumetric/singles/single_errors.h"

/// Over which range, and at how many nodes, the axes have curves of single measurements.
namespace axiometry::volumetric {

struct SingleBases {
  std::vector<CurveBasis> bases;       ///< bases of X, Y, Z
  std::array<bool, axis_count> cut{};  ///< whether some errors of an axis were read beyond its curves
  std::vector<NamedFinding> findings;  ///< findings about every axis that is cut
  TravelBox ranges() const;
};

/// As model_of_singles() says. Fails on an axis whose errors have no range in common, and on readings beyond the
/// travel.
Result<SingleBases> bases_of_singles(const TravelBox& travel, const SingleErrors& errors);

}  // namespace axiometry::volumetric
