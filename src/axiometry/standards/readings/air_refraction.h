// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>

#include "axiometry/base/quantity.h"
#include "axiometry/base/result.h"

/// Phase refractive index n of air, by which the wavelength of a laser in air is shorter than in vacuum. Two equations
/// that agree within 1e-8 in a laboratory; formulas, ranges and sources: docs/theory/reading-corrections.md.
///
/// - Ciddor: P. E. Ciddor, Applied Optics 35 (1996) 1566, equations (1) to (5) and appendices, with the vapour pressure
///   of Giacomo and Davis. Stated by its author for 2e-8 to 5e-8 (one standard uncertainty) over its wide range.
/// - Edlén: B. Edlén, Metrologia 2 (1966) 71, as updated by K. P. Birch and M. J. Downs, Metrologia 30 (1993) 155 with
///   their correction in 31 (1994) 315. Stated for 1e-8 (one standard uncertainty) in the air of a laboratory. The term
///   of water vapour is scaled by 292.75 K/T, as by the NIST Engineering Metrology Toolbox, without which it holds near
///   20 °C only; the vapour pressure is that of IAPWS.
///
/// Neither figure holds the uncertainty of the temperature, pressure and humidity that are put in, which is larger in
/// every workshop: see air_sensitivities().
namespace axiometry {

enum class AirEquation { ciddor, edlen };

std::string_view air_equation_key(AirEquation equation);   ///< "ciddor", "edlen"
std::string_view air_equation_name(AirEquation equation);  ///< "Ciddor 1996", "Edlén, Birch and Downs 1994"

/// The air along the beam.
struct Air {
  Temperature temperature;                 ///< −40 to 100 °C
  Pressure pressure;                       ///< 10 to 140 kPa
  RelativeHumidity humidity;               ///< 0 to 100 %, over water; over ice below 0 °C
  double co2_ppm = 450.0;                  ///< carbon dioxide by volume, 0 to 2000
  std::optional<Pressure> water_vapour{};  ///< partial pressure, in place of the humidity where it was measured
};

/// Refractivity n − 1, without the cancellation that 1 + (n − 1) − 1 would bring.
///
/// Fails, naming the quantity, what was found and the range, outside the ranges above, at a vacuum wavelength outside
/// 300 to 1700 nm, on a number that is not finite, and where the vapour would exceed the pressure. A pressure that
/// looks like hPa, mmHg or Pa is told so.
Result<double> air_refractivity(AirEquation equation, const Air& air, Length vacuum_wavelength);

/// The same without looking at the ranges: for air between two states that are within them.
double unchecked_air_refractivity(AirEquation equation, const Air& air, Length vacuum_wavelength);

/// What n changes by, per unit of each input, the others held; near 20 °C, 101 kPa and 50 %: −0.95e-6 per °C (−0.93e-6
/// in dry air), 2.68e-9 per Pa, −0.85e-8 per % and 1.45e-10 per ppm. For uncertainties.
struct AirSensitivities {
  double per_celsius = 0.0;
  double per_pascal = 0.0;
  double per_percent = 0.0;  ///< derivative by relative humidity
  double per_ppm_co2 = 0.0;
};

/// Central differences, whose error is below 1e-6 of each. Fails as air_refractivity() does.
Result<AirSensitivities> air_sensitivities(AirEquation equation, const Air& air, Length vacuum_wavelength);

/// Partial pressure of the water vapour in this air, as the equation takes it: its own saturation pressure times the
/// relative humidity, or what was measured. Needs air within the ranges above.
Pressure water_vapour_pressure(AirEquation equation, const Air& air);

}  // namespace axiometry
