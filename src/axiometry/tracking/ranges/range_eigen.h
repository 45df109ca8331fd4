// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include "axiometry/base/vector3.h"

/// Vectors for linear algebra and back. Internal to tracking.
namespace axiometry::tracking::detail {

inline Eigen::Vector3d eigen(Vector3 v) { return {v.x, v.y, v.z}; }
inline Vector3 vector(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }

}  // namespace axiometry::tracking::detail
