// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/volumetric/identify/equations/least_squares.h"

/// Axes that are of another length, or stand at another angle, for some of the readings than for others. Internal to
/// identify().
namespace axiometry::volumetric::detail {

/// How much longer X, Y and Z are, in µm/m, then C0Y, B0Z and A0Z, in µrad.
inline constexpr int strain_count = 6;
using Strains = Eigen::Matrix<double, strain_count, 1>;

/// What each of them changes in a length along u, µm, at a place from the middle of the volume in metres.
inline Strains strained_um(Vector3 u, Vector3 q_m) {
  Strains strained;
  strained << u.x * q_m.x, u.y * q_m.y, u.z * q_m.z, -u.x * q_m.y, u.x * q_m.z, -u.y * q_m.z;
  return strained;
}

/// Readings that have strains in common, rising.
using ReadingGroup = std::vector<std::size_t>;

/// The normal equations of strains Y of each group beside all that was fitted, J: what curves, stations and dead paths
/// can take is theirs. What all groups have in common is in the curves, and nothing of it is left.
struct StrainSystem {
  Eigen::MatrixXd matrix;                  ///< YᵀWY − YᵀWJ N⁻¹ JᵀWY, by groups, in each by modes
  Eigen::VectorXd right;                   ///< YᵀWv
  Eigen::VectorXd whole;                   ///< diagonal of YᵀWY
  std::vector<std::vector<double>> steps;  ///< N⁻¹ JᵀWY: what the unknowns lose when a strain of 1 is taken out
};

/// `modes`: the strains that a group may have, each a sum of the six.
StrainSystem strain_system(const Problem& problem, const Fit& fit, std::span<const ReadingGroup> groups,
                           std::span<const Strains> modes, Vector3 middle_mm);

/// What the strains of all groups, in the order of the system, change in each reading, µm.
std::vector<double> strains_in_readings(const Problem& problem, const Fit& fit, std::span<const ReadingGroup> groups,
                                        std::span<const Strains> modes, Vector3 middle_mm,
                                        const Eigen::VectorXd& strains);

}  // namespace axiometry::volumetric::detail
