// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/identify/identification_test_support.h"

/// What findings say of lengths of a known machine.
namespace axiometry::volumetric::test {

inline TrueMachine machine_with_repeatability(const char* chain, unsigned seed) {
  TrueMachine machine(chain, seed);
  machine.model.repeatability = Length::um(0.3);
  return machine;
}

inline Identification identified(const TrueMachine& machine, const VolumetricLengths& lengths,
                                 const IdentifyOptions& options = {}) {
  auto result = identify(machine.model, lengths, options);
  if (!result) {
    ADD_FAILURE() << result.error().message;
    std::abort();
  }
  return *std::move(result);
}

inline std::string told(const Identification& result, std::string_view id) {
  for (const VolumetricFinding& f : result.findings)
    if (f.id == id) return f.message;
  return "";
}

inline std::size_t causes_told(const Identification& result) {
  std::size_t count = 0;
  for (const char* id : {"volumetric-chain-order", "volumetric-reversal", "volumetric-axes-changed"})
    count += told(result, id).empty() ? 0u : 1u;
  return count;
}

inline Vector3 beam(const TrueMachine& machine, const VolumetricReading& reading) {
  return unit(reading.axes_mm + machine.model.tools[reading.tool].offset_mm - four_stations()[reading.station].at_mm);
}

/// Axes that are longer by so much at each station with each tool.
template <typename Scale>
void make_longer(const TrueMachine& machine, VolumetricLengths& lengths, const Scale& um_per_m) {
  for (VolumetricReading& reading : lengths.readings)
    reading.length_mm += 1e-6 * um_per_m(reading.station, reading.tool) * dot(reading.axes_mm, beam(machine, reading));
}

}  // namespace axiometry::volumetric::test
