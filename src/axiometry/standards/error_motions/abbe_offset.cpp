// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/error_motions/abbe_offset.h"

#include <cstddef>

#include "axiometry/base/contract.h"

namespace axiometry::error_motions {
namespace {

/// (ε × r)_c = ε_{c+1} r_{c+2} − ε_{c+2} r_{c+1}, indices modulo 3.
struct Lever {
  std::size_t angle = 0;
  double mm = 0.0;
};

std::array<Lever, 2> levers_of(const Vector3& offset_mm, std::size_t coordinate) {
  const std::size_t next = (coordinate + 1) % 3, last = (coordinate + 2) % 3;
  return {Lever{next, offset_mm[last]}, Lever{last, -offset_mm[next]}};
}

}  // namespace

std::string missing_angles(const AxisAngles& angles, const Vector3& offset_mm, std::size_t coordinate) {
  std::string missing;
  for (const Lever& lever : levers_of(offset_mm, coordinate))
    if (lever.mm != 0.0 && !angles.urad[lever.angle]) missing += static_cast<char>('A' + lever.angle);
  return missing;
}

std::array<std::optional<std::vector<double>>, 3> abbe_displacement(const AxisAngles& angles,
                                                                    const Vector3& offset_mm) {
  std::size_t count = 0;
  for (const auto& list : angles.urad)
    if (list) {
      AXIOMETRY_CONTRACT(count == 0 || list->size() == count);
      count = list->size();
    }
  std::array<std::optional<std::vector<double>>, 3> moved;
  for (std::size_t c = 0; c < moved.size(); ++c) {
    if (!missing_angles(angles, offset_mm, c).empty()) continue;
    auto& list = moved[c].emplace(count, 0.0);
    for (const Lever& lever : levers_of(offset_mm, c))
      if (lever.mm != 0.0)
        for (std::size_t i = 0; i < count; ++i) list[i] += 1e-3 * lever.mm * (*angles.urad[lever.angle])[i];
  }
  return moved;
}

}  // namespace axiometry::error_motions
