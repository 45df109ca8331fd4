// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <stop_token>
#include <vector>

#include "axiometry/volumetric/curves/beam_row.h"
#include "axiometry/volumetric/identify/equations/unknowns.h"

/// The lengths linearised (Lee et al., eq. 2, with the machine instead of free points):
///   l_i = |q_i + t + δ(q_i, t) − s_v| − l0 + drift·x + ε,  ∂l = u·∂δ − u·∂s − ∂l0 + x ∂drift,
/// with u from the station to the reflector. µm, µrad, levers in m. Internal to identify().
namespace axiometry::volumetric::detail {

class CurvaturePenalty;

struct Problem {
  const MachineModel& machine;
  const Coefficients& coefficients;
  const Unknowns& unknowns;
  std::span<const VolumetricReading> readings;
  std::span<const Vector3> tools_mm;          ///< tools of the readings
  std::span<const Approaches> approaches;     ///< approaches per reading; empty without reversal
  std::span<const double> weights;            ///< weight per reading: 1/σ², 1/µm²; 0 leaves it out
  std::size_t threads = 1;                    ///< does not change the result
  const CurvaturePenalty* penalty = nullptr;  ///< penalty of curves that are to be smooth
  std::stop_token stop{};                     ///< no step begins any more

  Vector3 tool_mm(std::size_t i) const { return tools_mm[readings[i].tool]; }
};

inline Approaches approaches_of(const Problem& problem, std::size_t i) {
  return problem.approaches.empty() ? Approaches{} : problem.approaches[i];
}

/// What the coefficients make of a reading.
inline BeamRow beam_row(const Problem& problem, std::size_t i) {
  return {problem.coefficients, problem.machine, problem.readings[i].axes_mm, problem.tool_mm(i),
          approaches_of(problem, i)};
}

/// Symmetric, by rows, only its upper triangle filled.
struct NormalEquations {
  std::size_t columns = 0;
  std::vector<double> matrix;  ///< Σ w a aᵀ
};

/// All that a state says of the readings.
struct Sights {
  std::vector<double> residuals_um;  ///< v_i: measured less predicted
  std::vector<Vector3> beams;        ///< u_i
  std::vector<double> gradient;      ///< Σ w a v
};
Sights sights(const Problem& problem, const State& state);

NormalEquations normal_equations(const Problem& problem, const Sights& sights);

/// Σ w a v of any v.
std::vector<double> gradient(const Problem& problem, std::span<const Vector3> beams, std::span<const double> v);

/// Every station at the mean of its places with several tools, where these are alike to 20 mm: only there is what one
/// station at one place cannot tell exactly a null direction. The scatter of the places seems to tell it.
State with_stations_joined(const Problem& problem, const State& state);

/// Σ w v².
double chi_squared(const Problem& problem, std::span<const double> residuals);

}  // namespace axiometry::volumetric::detail
