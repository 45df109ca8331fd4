// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// Systematic effects on the readings that the metadata tell of and that are neither corrected nor part of the
/// uncertainty. What such an effect does is no doubt about a value but an error in it, so that no probability and no
/// verdict may rest on a value that holds one (GUM, 3.2.4; 4.1 of ISO 230-2:2014).
namespace axiometry::iso230_2 {

/// What mends an effect, for programs: any of the corrections, or statements.
struct Remedy {
  std::vector<std::string> corrections{};  ///< as `axiometry evaluate --correct` takes them: "nde", "air=ciddor"
  std::vector<std::string> fields{};       ///< keys of the metadata (model/fields.h)
};

struct UncorrectedEffect {
  std::string key;   ///< "expansion", "expansion-coefficient", "air", "dead-path", "gain", "sign", "station"
  std::string what;  ///< words for people: "thermal expansion, about 104.7 µm over the travel,"
  /// How much it may change what depends on lengths (A, E, M and their like), and what depends on repetition and
  /// reversal (R, B and their like). Absent where nobody can tell.
  std::optional<Deviation> on_lengths;
  std::optional<Deviation> on_repeats;
  std::string remedy;  ///< what mends it, in words: "the correction for thermal expansion"
  Remedy by{};         ///< the same

  /// How much it may change a parameter; absent where nobody can tell.
  std::optional<Deviation> on(const ParameterInfo& parameter) const;
  /// "thermal expansion, about 104.7 µm over the travel, is neither corrected nor in the uncertainty; the correction …"
  std::string reason() const;
};

/// - expansion, linear axes, unless `nde.applied` is yes: P (f_t of the machine − that of the equipment). Temperatures:
///   sensors with role machine, else of the equipment, else of the air, the one farthest from 20 °C; or ΔT of the
///   machine where it was stated and is larger. None where all of it lies within ± R(θ)/2 of the machine, which the
///   uncertainty contains. Where nobody said whether it was corrected it may not have been.
/// - expansion-coefficient: the readings were corrected with an α that differs from what is stated of the machine (for
///   the uncertainty, of its scale; 12 µm/(m·°C) where the correction took 0) by more than R(α)/2, which is in the
///   uncertainty: what that leaves at the same temperatures.
/// - air: the instrument assumed an index of refraction (`instrument.refractive_index`) and the readings were not
///   brought to that of the air.
/// - dead-path: there is one, and it was not corrected.
/// - gain, sign: told of the sensor, and the readings were taken as they are.
/// - station: of a tracking interferometer, where it cannot be used in the uncertainty (station_offset_problem()).
///
/// Sizes below 0.005 µm are none. The cosine error of a misalignment, a station with its uncertainty, and whatever else
/// the inputs of the uncertainty hold, is inside the uncertainty and not listed.
std::vector<UncorrectedEffect> uncorrected_effects(const Test& test);

}  // namespace axiometry::iso230_2
