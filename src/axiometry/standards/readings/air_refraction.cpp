// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the sources. Ciddor: none. Edlén: the factor 292.75 K/T of the water vapour (NIST), and carbon
// dioxide other than the 450 ppm of Birch and Downs by Edlén's own factor, 1 + 0.540 (x − 0.0003), relative to theirs.
#include "axiometry/standards/readings/air_refraction.h"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "axiometry/base/text/number_text.h"

namespace axiometry {
namespace {

constexpr double zero_celsius = 273.15;  // K
constexpr double pascal_per_kPa = 1000.0;
constexpr double per_1e8 = 1e-8;
constexpr double per_percent = 0.01;

/// All in the units of the papers: Pa, °C, µm⁻².
struct State {
  double t;   // °C
  double T;   // K
  double p;   // Pa
  double pv;  // Pa, partial pressure of water vapour
  double co2_ppm;
};

namespace ciddor {

constexpr double gas_constant = 8.314510;   // R, J/(mol·K), of the paper's time
constexpr double mass_of_water = 0.018015;  // M_w, kg/mol

/// Saturation pressure over water (Giacomo, Davis) and ice, Pa.
double saturation_pressure(double T) {
  if (T < zero_celsius) return std::pow(10.0, -2663.5 / T + 12.537);
  return std::exp(1.2378847e-5 * T * T - 1.9121316e-2 * T + 33.93711047 - 6.3431645e3 / T);
}

/// f: how much more vapour moist air holds than a vacuum.
double enhancement(double p, double t) { return 1.00062 + 3.14e-8 * p + 5.6e-7 * t * t; }

/// Z, equation (12), for a mole fraction x of water.
double compressibility(double T, double p, double x) {
  const double t = T - zero_celsius;
  const double ratio = p / T;
  const double linear = 1.58123e-6 - 2.9331e-8 * t + 1.1043e-10 * t * t + (5.707e-6 - 2.051e-8 * t) * x +
                        (1.9898e-4 - 2.376e-6 * t) * x * x;
  return 1.0 - ratio * linear + ratio * ratio * (1.83e-11 - 0.765e-8 * x * x);
}

/// Density of a share of the air, kg/m³ (4).
double density(double T, double p, double x, double molar_mass, double share) {
  return share * p * molar_mass / (compressibility(T, p, x) * gas_constant * T);
}

double refractivity(const State& s, double sigma2) {
  const double dry = per_1e8 * (5792105.0 / (238.0185 - sigma2) + 167917.0 / (57.362 - sigma2));  // (1)
  const double air = dry * (1.0 + 0.534e-6 * (s.co2_ppm - 450.0));                                // (2)
  const double vapour =
      1.022 * per_1e8 *
      (295.235 + 2.6422 * sigma2 - 0.032380 * sigma2 * sigma2 + 0.004028 * sigma2 * sigma2 * sigma2);  // (3)
  const double mass_of_air = 1e-3 * (28.9635 + 12.011e-6 * (s.co2_ppm - 400.0));
  const double x = enhancement(s.p, s.t) * s.pv / s.p;
  const double air_standard = density(288.15, 101325.0, 0.0, mass_of_air, 1.0);
  const double vapour_standard = density(293.15, 1333.0, 1.0, mass_of_water, 1.0);
  return density(s.T, s.p, x, mass_of_air, 1.0 - x) / air_standard * air +
         density(s.T, s.p, x, mass_of_water, x) / vapour_standard * vapour;  // (5)
}

}  // namespace ciddor

namespace edlen {

/// Saturation pressure over water (IAPWS-IF97, region 4) and ice (IAPWS 1993), Pa.
double saturation_pressure(double T) {
  if (T < zero_celsius) {
    const double theta = T / 273.16;
    return 611.657 * std::exp(-13.928169 * (1.0 - std::pow(theta, -1.5)) + 34.7078238 * (1.0 - std::pow(theta, -1.25)));
  }
  const double omega = T - 0.238555575678 / (T - 650.175348448);
  const double a = omega * omega + 1167.05214528 * omega - 724213.167032;
  const double b = -17.0738469401 * omega * omega + 12020.8247025 * omega - 3232555.03223;
  const double c = 14.9151086135 * omega * omega - 4823.26573616 * omega + 405113.405421;
  return 1e6 * std::pow(2.0 * c / (-b + std::sqrt(b * b - 4.0 * a * c)), 4);
}

/// 1 + 0.540 (x − 0.0003)
double co2_factor(double ppm) { return 1.0 + 0.540 * (ppm * 1e-6 - 0.0003); }

double refractivity(const State& s, double sigma2) {
  const double standard = per_1e8 * (8342.54 + 2406147.0 / (130.0 - sigma2) + 15998.0 / (38.9 - sigma2)) *
                          co2_factor(s.co2_ppm) / co2_factor(450.0);
  const double dry =
      s.p * standard / 96095.43 * (1.0 + per_1e8 * (0.601 - 0.00972 * s.t) * s.p) / (1.0 + 0.0036610 * s.t);
  return dry - 292.75 / s.T * s.pv * (3.7345 - 0.0401 * sigma2) * 1e-10;
}

}  // namespace edlen

double saturation_pressure(AirEquation equation, double T) {
  return equation == AirEquation::ciddor ? ciddor::saturation_pressure(T) : edlen::saturation_pressure(T);
}

State state_of(AirEquation equation, const Air& air) {
  const double t = air.temperature.in_celsius();
  return {t, t + zero_celsius, air.pressure.in_kPa() * pascal_per_kPa,
          water_vapour_pressure(equation, air).in_kPa() * pascal_per_kPa, air.co2_ppm};
}

struct Range {
  std::string_view what;
  std::string_view unit;
  double low;
  double high;
};

constexpr Range temperatures{"an air temperature of", " °C", -40.0, 100.0};
constexpr Range pressures{"an air pressure of", " kPa", 10.0, 140.0};
constexpr Range humidities{"a relative humidity of", " %", 0.0, 100.0};
constexpr Range co2_shares{"carbon dioxide of", " ppm", 0.0, 2000.0};
constexpr Range wavelengths{"a vacuum wavelength of", " nm", 300.0, 1700.0};

/// Which unit a pressure out of range may have been given in.
std::string_view pressure_hint(double kPa) {
  if (kPa >= 600.0 && kPa <= 800.0) return ": is it hPa or mmHg?";
  if (kPa > 140.0 && kPa <= 1400.0) return ": is it hPa?";
  return kPa >= 10'000.0 && kPa <= 140'000.0 ? ": is it Pa?" : "";
}

Result<void> check(const Range& range, double x, std::string_view hint = "") {
  if (x >= range.low && x <= range.high) return {};
  return fail(fmt::format("found {} {}{}, expected {} to {}{}{}", range.what, format_exact(x), range.unit, range.low,
                          range.high, range.unit, hint));
}

Result<void> check_ranges(AirEquation equation, const Air& air, Length vacuum_wavelength) {
  const double kPa = air.pressure.in_kPa();
  AXIOMETRY_TRY_VOID(check(temperatures, air.temperature.in_celsius()));
  AXIOMETRY_TRY_VOID(check(pressures, kPa, pressure_hint(kPa)));
  AXIOMETRY_TRY_VOID(check(humidities, air.humidity.in_percent()));
  AXIOMETRY_TRY_VOID(check(co2_shares, air.co2_ppm));
  const double nm = vacuum_wavelength.in_nm();
  AXIOMETRY_TRY_VOID(check(wavelengths, nm, nm > 0.29 && nm < 1.71 ? ": is it µm?" : ""));
  const double vapour = water_vapour_pressure(equation, air).in_kPa();
  if (vapour >= 0.0 && vapour < kPa) return {};
  return fail(fmt::format("found water vapour of {:.4g} kPa in air of {} kPa, expected less than the pressure", vapour,
                          format_exact(kPa)));
}

}  // namespace

std::string_view air_equation_key(AirEquation equation) { return equation == AirEquation::ciddor ? "ciddor" : "edlen"; }

std::string_view air_equation_name(AirEquation equation) {
  return equation == AirEquation::ciddor ? "Ciddor 1996" : "Edlén, Birch and Downs 1994";
}

Pressure water_vapour_pressure(AirEquation equation, const Air& air) {
  if (air.water_vapour) return *air.water_vapour;
  const double T = air.temperature.in_celsius() + zero_celsius;
  return Pressure::kPa(air.humidity.in_percent() * per_percent * saturation_pressure(equation, T) / pascal_per_kPa);
}

double unchecked_air_refractivity(AirEquation equation, const Air& air, Length vacuum_wavelength) {
  const double sigma2 = 1.0 / (vacuum_wavelength.in_um() * vacuum_wavelength.in_um());
  const State s = state_of(equation, air);
  return equation == AirEquation::ciddor ? ciddor::refractivity(s, sigma2) : edlen::refractivity(s, sigma2);
}

Result<double> air_refractivity(AirEquation equation, const Air& air, Length vacuum_wavelength) {
  AXIOMETRY_TRY_VOID(check_ranges(equation, air, vacuum_wavelength));
  return unchecked_air_refractivity(equation, air, vacuum_wavelength);
}

Result<AirSensitivities> air_sensitivities(AirEquation equation, const Air& air, Length vacuum_wavelength) {
  AXIOMETRY_TRY_VOID(check_ranges(equation, air, vacuum_wavelength));
  // n − 1 is smooth far beyond the ranges, and has 12 digits behind steps that bend it by less than 1e-6.
  const auto slope = [&](double step, const auto& changed_by) {
    const double above = unchecked_air_refractivity(equation, changed_by(step), vacuum_wavelength);
    const double below = unchecked_air_refractivity(equation, changed_by(-step), vacuum_wavelength);
    return (above - below) / (2.0 * step);
  };
  const auto warmer = [&](double by) {
    Air other = air;
    other.temperature = air.temperature + Temperature::celsius(by);
    return other;
  };
  const auto denser = [&](double by) {
    Air other = air;
    other.pressure = air.pressure + Pressure::kPa(by);
    return other;
  };
  const auto moister = [&](double by) {
    Air other = air;
    other.humidity = air.humidity + RelativeHumidity::percent(by);
    return other;
  };
  const auto with_co2 = [&](double by) {
    Air other = air;
    other.co2_ppm += by;
    return other;
  };
  return AirSensitivities{.per_celsius = slope(0.05, warmer),
                          .per_pascal = slope(0.01, denser) / pascal_per_kPa,
                          .per_percent = slope(0.1, moister),
                          .per_ppm_co2 = slope(1.0, with_co2)};
}

}  // namespace axiometry
