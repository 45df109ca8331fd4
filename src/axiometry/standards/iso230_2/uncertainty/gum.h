// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/inputs/inputs.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// The uncertainty of a positioning test by the law of propagation (GUM, clause 5): at every target after Lira &
/// Cargill, Precision Engineering 28 (2004) 232, and of every parameter of clause 3 by linearisation. Derivation and
/// the paper's example: docs/theory/uncertainty.md.
namespace axiometry::iso230_2 {

/// Why a coverage factor is what it is.
enum class Coverage {
  normal,              ///< k = 2: nothing has finite degrees of freedom
  degrees_of_freedom,  ///< k = t_p(ν_eff) after Welch and Satterthwaite, p = 95.45 %
  correlated,          ///< k = 2: some inputs are correlated, for which ν_eff is not defined
};

std::string_view coverage_key(Coverage coverage);  ///< "normal", "degrees-of-freedom", "correlated"

/// u, and the expanded U = k u for a probability of about 95 %.
struct ExpandedUncertainty {
  Deviation u;
  Deviation U;
  double k = 2.0;
  Coverage coverage = Coverage::normal;
  std::optional<double> effective_degrees_of_freedom;  ///< ν_eff, where `coverage` says so
};

/// A factor that multiplies every position: f_t of the machine or the device, f_a.
struct FactorUncertainty {
  double departure = 0.0;  ///< f − 1 of the estimates, µm/m
  double u = 0.0;          ///< standard uncertainty as used, µm/m
  double u_linear = 0.0;   ///< eq. 15, µm/m; of f_a the same as u_exact
  double u_exact = 0.0;    ///< standard deviation of the factor's distribution (Table A.1), µm/m
};

/// The terms of eq. 8 at one target in one direction: Table 5, with the components of c_s in one.
struct PositionComponents {
  Deviation approaches;       ///< f_t f_a u[p_m]: s/√n for this_machine; the known noise over √n for this_test
  Deviation thermal;          ///< f_a p_m u[f_t], with the device's expansion
  Deviation alignment;        ///< f_t p_m u[f_a]
  Deviation axis_resolution;  ///< u[c_r]
  Deviation instrument;       ///< u[c_s]: resolution, calibration, environment, station
  Deviation other;            ///< inputs of one's own
  ExpandedUncertainty total;  ///< uncertainty of x̄_i in this direction
};

struct PositionUncertainty {
  Position target;
  std::optional<PositionComponents> up;
  std::optional<PositionComponents> down;
  std::optional<ExpandedUncertainty> mean;  ///< uncertainty of x̄_i, eq. 10: Table 6
};

/// A source of uncertainty, one line of every budget.
struct GumSource {
  std::string key;  ///< of the input; "approaches" (type A), "machine_thermal_product", "device_thermal_product",
                    ///< "alignment_mean", "station_mean"
  std::string symbol;
  std::string title;
  std::string source;        ///< equation
  std::string distribution;  ///< as uncertainty::Distribution::text(); empty where there is none
  std::optional<double> u;   ///< uncertainty of one draw, in `unit`; absent where each target has its own
  std::string unit;
  std::string note;
};

/// The uncertainty of one parameter and its budget.
struct GumParameter {
  const ParameterInfo* parameter = nullptr;
  Deviation value;
  ExpandedUncertainty uncertainty;
  std::vector<Deviation> contributions;  ///< |c| u of each of GumUncertainty::sources; their squares sum to u²
};

struct GumUncertainty {
  Measurand measurand = Measurand::this_test;
  double up_down_correlation = 1.0;
  std::optional<FactorUncertainty> machine_thermal;  ///< f_t
  std::optional<FactorUncertainty> device_thermal;
  std::optional<FactorUncertainty> alignment;  ///< f_a
  std::vector<GumSource> sources;
  std::vector<PositionUncertainty> positions;  ///< a position for each target
  std::vector<GumParameter> parameters;        ///< those that exist and on which some source acts
  std::vector<std::string> notes;              ///< what was assumed, and where the method ends
  std::size_t position_notes = 0;              ///< how many of the first notes concern `positions` too

  /// nullptr where it has none.
  const GumParameter* find(std::string_view key) const;
};

/// The inputs of uncertainty_inputs() propagated. Nothing when there are none (for this_machine: when neither they
/// nor that measurand were given). Fails as uncertainty_inputs() does.
///
/// - this_test: the systematic inputs, and the known noise u of a reading (and of a run) as it passes into means
///   (u/√n) and, to first order, into s (u/√(n − 1)). The scatter of the machine itself is no uncertainty here. E_VE as
///   a drift or a random walk moves neighbouring readings alike (environment_modes.h): its covariance is propagated in
///   place of u². Of an unknown kind the largest u of all that the readings do not refute counts (monte_carlo/noise.h).
/// - this_machine: the systematic inputs, and type A: s/√n of a mean and s/√(2(n − 1)) of s, ν = n − 1 at each target
///   and direction. The known noise is part of s and not counted again; what runs have in common is taken out of the
///   single s²/n and shared by all targets. A single approach has no s: there the known noise counts.
/// - u[f_t] is that of eq. 15. Where the exact distribution has one that is larger by more than 1 % (near ΔT = 0 with
///   a poorly known α) the difference enters as a source of its own, the product of both.
/// - The correlation r between ↑ and ↓: in the positions, eq. 10 takes it for the whole of u[x̄_i↑] and u[x̄_i↓], which
///   is the paper's safe side at r = 1. In the parameters the sources are separate: what is shared by the test is the
///   same in both directions, approaches are independent, and r stands between the errors of `target` inputs at one
///   target.
/// - Distributions t: u is the scale, ν counts (of α, ΔT and θ the standard deviation).
/// - ν_eff is not defined for correlated inputs: where 0 < |r| < 1 and a `target` input acts, in eq. 10 unless r = 0,
///   for this_machine with what runs have in common. Then k = 2, and it is said.
///
/// - The readings are not corrected for the mean of f_a, which is below 1: in the parameters it counts as a source of
/// its
///   own, alignment_mean, beside u[f_a]. The positions are the paper's.
/// - p_m is the position as read: (p_n + x)/f_t where the readings were corrected for expansion (`nde.applied` = yes),
///   p_n + x where nobody says so.
///
/// The parameters are extremes; linearised, they follow the targets that are extreme in this test (parameter_
/// gradients(); of targets that share an extreme those with the largest u). Their bias, and another target taking over,
/// only the Monte Carlo method sees; a note says so. A parameter on which no source acts has no uncertainty here: ±0
/// would be a false claim.
Result<std::optional<GumUncertainty>> gum(const Test& test, const Evaluation& evaluation);

}  // namespace axiometry::iso230_2
