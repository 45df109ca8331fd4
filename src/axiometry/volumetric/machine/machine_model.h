// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/quantity.h"
#include "axiometry/base/vector3.h"
#include "axiometry/model/tracking.h"
#include "axiometry/volumetric/machine/chain.h"

/// What must be known of a machine before its 21 errors can be found.
namespace axiometry::volumetric {

/// From where the axes stand to the centre of the reflector.
struct Tool {
  std::string name;
  Vector3 offset_mm;  ///< t
};

/// A station that is planned, or where the instrument is said to stand; its name is that of the lengths.
struct NamedStation {
  std::string name;
  Vector3 at_mm;  ///< place in the machine's coordinates
};

struct MachineModel {
  std::string name = {};
  KinematicChain chain;
  TravelBox travel = {};
  std::vector<Tool> tools = {};
  std::vector<NamedStation> stations = {};  ///< places where they are said to stand; may be empty
  RangingUncertainty ranging = {};          ///< uncertainty of a length, independent from one to the next
  /// Standard uncertainty of what all lengths have in common, as the wavelength of air: adds to the slopes of EXX, EYY
  /// and EZZ. Absent when nothing was said of it.
  std::optional<RelativeLength> scale_uncertainty = {};
  Length repeatability = {};  ///< standard deviation of the machine at a stop along the beam
  /// c_a: where the error motions of axis a are stated. Straightness depends on it; at the machine's zero by default.
  std::array<Vector3, 3> functional_point_mm{};

  /// r_a less the functional point, mm.
  std::array<Vector3, 3> levers_mm(Vector3 axes_mm, Vector3 tool_mm) const {
    std::array<Vector3, 3> r = chain.levers(axes_mm, tool_mm);
    for (std::size_t a = 0; a < 3; ++a) r[a] -= functional_point_mm[a];
    return r;
  }
  std::optional<std::size_t> tool_named(std::string_view wanted) const {
    for (std::size_t k = 0; k < tools.size(); ++k)
      if (tools[k].name == wanted) return k;
    return std::nullopt;
  }
  /// σ of one length at a distance, k = 1, µm: the instrument's and the machine's.
  double sigma_um(double distance_mm) const {
    return std::hypot(1000.0 * ranging.standard_mm(distance_mm), repeatability.in_um());
  }
};

}  // namespace axiometry::volumetric
