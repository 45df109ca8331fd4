// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/base/vector3.h"
#include "axiometry/volumetric/curves/coefficients.h"
#include "axiometry/volumetric/machine/machine_model.h"
#include "axiometry/volumetric/machine/volumetric_data.h"

/// What is unknown beside the errors: where the instrument stood, and the dead paths. Internal to identify().
namespace axiometry::volumetric::detail {

/// A station as one tool sees it. Each has a place of its own, so that a wrong offset of a tool only moves it and
/// enters the errors as a lever alone (1 mm costs about 0.1 µm).
struct VirtualStation {
  std::size_t station = 0;
  std::size_t tool = 0;
  std::size_t column = 0;  ///< column of x of its place; y and z follow
};

/// Readings with one dead path: from one break of the beam to the next.
struct BeamStretch {
  std::size_t virtual_station = 0;
  std::size_t segment = 0;  ///< as the file has it
  std::size_t readings = 0;
  std::size_t column = 0;  ///< column of its dead path; its drift follows, where drift is looked for
};

/// Columns of the normal equations: raw coefficients, then places of stations, then dead paths and drifts.
struct Unknowns {
  std::size_t coefficients = 0;
  std::vector<VirtualStation> stations;
  std::vector<BeamStretch> stretches;
  std::vector<std::size_t> stretch_of;  ///< stretch per reading
  std::vector<double> along_stretch;    ///< place per reading from −1/2 to 1/2, what a drift is multiplied by
  bool drift = false;
  std::size_t columns = 0;
};

/// `breaks` are readings before which the beam was broken though the file does not say so.
Unknowns unknowns_of(const Coefficients& coefficients, std::span<const VolumetricReading> readings,
                     std::span<const std::size_t> breaks, bool drift);

/// Values of the unknowns.
struct State {
  std::vector<double> coefficients;  ///< raw, µm and µrad
  std::vector<Vector3> stations_mm;
  std::vector<double> dead_paths_mm;
  std::vector<double> drifts_um;  ///< drift over each stretch
};

/// `step`: of all columns, raw, µm and µrad.
void add_step(const Unknowns& unknowns, std::span<const double> step, State& state);

}  // namespace axiometry::volumetric::detail
