// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "axiometry/base/unit_sizes.h"
#include "axiometry/standards/iso230_2/uncertainty/gum.h"
#include "axiometry/standards/iso230_2/uncertainty/gum_environment.h"
#include "axiometry/standards/readings/station_offset.h"

/// What the law of propagation needs of the inputs: their u and ν, the factors, the noise. For the sources
/// gum*.cpp alone.
namespace axiometry::iso230_2 {

inline constexpr double infinite = std::numeric_limits<double>::infinity();

/// A component: its standard uncertainty and degrees of freedom.
struct Component {
  double u = 0.0;
  double degrees_of_freedom = infinite;
};

/// The scale and ν of a t distribution, else the standard deviation; for α, ΔT, θ and Δ always the latter.
Component component_of(const UncertaintyInput& input);

/// Adds squares, and what Welch and Satterthwaite need.
class ComponentSum {
 public:
  void add(Component component);
  double u() const;
  bool has_finite() const { return fourth_powers_ > 0.0; }
  /// U of the sum; `correlated` components have no ν_eff.
  ExpandedUncertainty expanded(bool correlated = false) const;

 private:
  double squares_ = 0.0;
  double fourth_powers_ = 0.0;  // Σ u⁴/ν
};

/// The station of a tracking interferometer. An error of readings is a function of Δ⊥² = Σ Δ²; to first order each
/// Δ² is an input of its own, with its mean and standard deviation. The readings are not corrected for the mean, which
/// counts as one more source (GUM, F.2.4.5).
struct StationModel {
  StationErrors errors;
  double mean_mm2 = 0.0;       ///< mean of Δ⊥²
  std::vector<double> sd_mm2;  ///< standard deviation of Δ² of each input; 0 of those that are no station

  double sensitivity(std::size_t target) const { return errors.slope_um_per_mm2(target, mean_mm2); }
  double mean_error(std::size_t target) const { return errors.error_um(target, mean_mm2); }
};

struct GumModel {
  Measurand measurand = Measurand::this_test;
  UncertaintyInputs inputs;
  std::vector<Component> components;  ///< a component for each input
  std::optional<FactorUncertainty> machine_thermal;
  std::optional<FactorUncertainty> device_thermal;
  std::optional<FactorUncertainty> alignment;
  std::optional<StationModel> station;
  /// What the readings show too little on average because of the alignment, for which they are not corrected: one more
  /// source (GUM, F.2.4.5), µm/m. It moves parameters; the positions are those of the paper.
  double alignment_mean = 0.0;
  bool expansion_in_readings = false;            ///< nobody says that the readings were corrected for it
  double run_noise = 0.0;                        ///< standard uncertainty of what a run has in common
  std::optional<EnvironmentEffect> environment;  ///< effect where E_VE is an input

  double thermal_factor() const { return machine_thermal ? 1.0 + 1e-6 * machine_thermal->departure : 1.0; }
  double alignment_factor() const { return alignment ? 1.0 + 1e-6 * alignment->departure : 1.0; }
  /// Whether the scatter of n approaches counts, not the known noise.
  bool takes_scatter(std::size_t n) const { return measurand == Measurand::this_machine && n > 1; }
};

GumModel make_model(const Test& test, UncertaintyInputs inputs, Measurand measurand);

/// The product of both uncertainties of a thermal factor, µm/m: 0 where eq. 15 is used alone.
double thermal_product(const std::optional<FactorUncertainty>& factor);

/// Eqs. 8 to 10 at every target.
std::vector<PositionUncertainty> propagate_positions(const GumModel& model, const Series& series,
                                                     const Evaluation& evaluation);

}  // namespace axiometry::iso230_2
