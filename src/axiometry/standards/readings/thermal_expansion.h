// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <utility>

#include "axiometry/base/result.h"
#include "axiometry/uncertainty/distribution.h"

/// The thermal correction factor f_t = 1/(1 + αΔT) of a length that was read at 20 °C + ΔT, and its uncertainty.
/// Lira & Cargill, Precision Engineering 28 (2004) 232, eqs. 13 to 17 and Table A.1. Derivation and the misprint in
/// the table: docs/theory/uncertainty.md.
///
/// f_t differs from 1 by 1e-5 or so: everything works with the departure f_t − 1, in µm/m, and never subtracts
/// numbers near 1.
namespace axiometry {

/// α in µm/(m·°C) and ΔT in °C. Contract wherever it is used: |αΔT| < 5e5 µm/m.
struct ThermalState {
  double expansion = 0.0;
  double difference = 0.0;
};

/// f_t − 1 in µm/m, eq. 14.
double thermal_departure(ThermalState state);

/// f_t.
double thermal_factor(ThermalState state);

/// The derivatives of f_t, in µm/m: by α, per µm/(m·°C); by ΔT, per °C.
ThermalState thermal_sensitivity(ThermalState state);

/// u[f_t] in µm/m by the law of propagation, eq. 15; `u` holds u[α] and u[ΔT]. At ΔT = 0 it knows nothing of u[α].
double thermal_uncertainty(ThermalState state, ThermalState u);

/// Mean and standard deviation of f_t − 1, in µm/m.
struct FactorMoments {
  double mean = 0.0;
  double standard_deviation = 0.0;
};

/// The whole of f_t's distribution, nothing linearised. For uniform α and ΔT (a constant is one of no width) exact
/// to a relative 1e-13; for others within 3·max|αΔT| of the standard deviation, from that of the product αΔT.
/// Contract: both have a standard deviation.
FactorMoments thermal_moments(const uncertainty::Distribution& expansion, const uncertainty::Distribution& difference);

/// The probability density of f_t for uniform α > 0 and uniform ΔT of any sign: Table A.1.
class ThermalFactorDistribution {
 public:
  /// Fails unless 0 < α_m < α_M and ΔT_m < ΔT_M, and on |αΔT| ≥ 5e5 µm/m.
  static Result<ThermalFactorDistribution> make(uncertainty::Uniform expansion, uncertainty::Uniform difference);

  /// Of the departure f_t − 1 in µm/m, per µm/m; 0 outside the limits.
  double density(double departure) const;

  std::pair<double, double> limits() const;  ///< least and greatest departure, µm/m
  FactorMoments moments() const;             ///< as thermal_moments()

 private:
  ThermalFactorDistribution(uncertainty::Uniform expansion, uncertainty::Uniform difference)
      : expansion_(expansion), difference_(difference) {}
  uncertainty::Uniform expansion_;
  uncertainty::Uniform difference_;
};

}  // namespace axiometry
