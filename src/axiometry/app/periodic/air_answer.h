// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/standards/readings/air_refraction.h"

/// The use case "which index of refraction has this air".
namespace axiometry::app {

struct AirAnswer {
  AirEquation equation = AirEquation::ciddor;
  double refractivity = 0.0;  ///< n − 1
  Length wavelength_in_air;
  Pressure water_vapour;
  AirSensitivities sensitivities;
};

/// By each equation. Fails as air_refractivity() does.
Result<std::vector<AirAnswer>> answer_air(const Air& air, Length vacuum_wavelength,
                                          const std::vector<AirEquation>& equations);

/// The air, and under "ciddor" and "edlen" what was answered; docs/results.md describes the keys.
json::Value air_to_json(const Air& air, Length vacuum_wavelength, const std::vector<AirAnswer>& answers);

}  // namespace axiometry::app
