// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/volumetric/identify/anomalies.h"
#include "axiometry/volumetric/identify/break_places.h"
#include "axiometry/volumetric/identify/curvature_penalty.h"
#include "axiometry/volumetric/identify/curve_choice.h"
#include "axiometry/volumetric/identify/equations/least_squares.h"
#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/identify/part_scales.h"

/// The order of things in identify(). Internal.
namespace axiometry::volumetric::detail {

/// An axis came to rest in the direction of its last move within the same station and tool; before its first move: 0.
std::vector<Approaches> directions_of_rest(std::span<const VolumetricReading> readings);
inline bool has_unknown_direction(const Approaches& approaches) {
  return std::ranges::find(approaches, 0.0) != approaches.end();
}

/// What is being fitted: the parts that Problem looks at, in one place.
class Identifier {
 public:
  static Result<Identifier> make(const MachineModel& machine, const VolumetricLengths& lengths,
                                 const IdentifyOptions& options);

  /// Breaks, readings set aside, sizes of the curves, drift, all by the lengths alone; then smooth curves where they
  /// are asked for; then the last fit, from which scales of the parts are taken where they have some of their own.
  Result<void> run();

  const std::vector<BreakPlace>& breaks() const { return judged_.places; }
  const std::vector<double>& sigmas_um() const { return sigmas_; }
  const std::vector<Vector3>& tools_mm() const {
    return tools_mm_;
  }  ///< of the lengths, as they count (point_spread.h)
  const std::vector<bool>& set_aside() const { return judged_.aside; }
  /// Which side of a break it belongs to.
  bool in_doubt(std::size_t reading) const { return judged_.doubtful[reading]; }
  const Coefficients& coefficients() const { return *coefficients_; }
  const Unknowns& unknowns() const { return *unknowns_; }
  const Fit& fit() const { return *fit_; }
  const std::array<CurveDomain, axis_count>& domains() const { return domains_; }
  const TravelBox& observed() const { return observed_; }
  Vector3 middle_mm() const { return 0.5 * (observed_.lowest_mm + observed_.highest_mm); }
  const std::vector<double>& weights() const { return judged_.weights; }
  bool drift() const { return drift_; }
  const std::optional<CurvaturePenalty>& penalty() const { return penalty_; }
  const Smoothness& smoothness() const { return options_.smoothness; }
  bool bends_settled() const { return bends_settled_; }                 ///< what smoothness() lets find was found
  const PerCurve& plain_variances() const { return plain_variances_; }  ///< variances without the penalty, before φ
  /// Absent where parts were not looked at, or differ in scale no more than chance lets them.
  const std::optional<PartScaleFit>& part_scales() const { return part_scales_; }
  bool looks_for_part_scales() const { return options_.find_part_scales; }
  bool has_part_scales() const { return part_scales_ && part_scales_->told.held; }  ///< they are taken out of the fit
  double taken_by_scales() const { return has_part_scales() ? part_scales_->taken : 0.0; }  ///< so many unknowns
  std::size_t count() const;                                                                ///< readings that are used
  bool is_copy(std::size_t reading) const { return is_copy_[reading]; }
  /// Left out because nothing tells in which direction an axis had come to rest.
  bool is_of_unknown_direction(std::size_t reading) const { return of_unknown_direction_[reading]; }
  const std::vector<Approaches>& approaches() const { return approaches_; }  ///< empty without reversal
  std::size_t copies() const;                                                ///< readings that are written twice
  Problem problem() const;

 private:
  /// What was found of the readings. It is kept and taken back as one.
  struct Judged {
    std::vector<std::size_t> breaks;  ///< readings, rising
    std::vector<BreakPlace> places;   ///< places of the breaks, once they are settled
    std::vector<bool> doubtful, aside;
    std::vector<double> weights;
  };

  Identifier(const MachineModel& machine, const VolumetricLengths& lengths, const IdentifyOptions& options)
      : machine_(machine), lengths_(lengths), options_(options) {}
  Result<void> check_readings();
  void find_copies();
  void find_unknown_directions();
  bool has_no_say(std::size_t reading) const { return is_copy_[reading] || of_unknown_direction_[reading]; }
  Result<void> choose_first_sizes();
  Result<void> choose_sizes();
  struct Trial {
    double akaike = 0.0;
    std::vector<std::size_t> unseen;  ///< errors, rising
  };
  std::optional<Trial> trial(const Sizes& sizes) const;
  Sizes with_margin(Sizes sizes, const std::optional<Trial>& coarsest) const;
  Result<Coefficients> coefficients_of(const Sizes& sizes) const;
  Result<void> take_sizes(const Sizes& sizes);
  Result<void> start();
  void take_sigmas();
  void refine_start();
  Result<void> fit_first();
  Result<void> refit();
  Result<void> find_breaks();
  bool heed_stretches_set_aside();
  Result<void> take_breaks_for_drift();
  double cost_of_dead_paths(double scale) const;
  Result<void> drop_unclear_breaks();
  Result<void> settle_breaks();
  bool take_places(std::vector<BreakPlace> places);
  Result<void> find_outliers();
  Result<void> find_drift();
  Result<void> fit_with_drift(bool drift);
  Result<void> find_drift_and_breaks();
  Result<void> take_finer_sizes();
  Result<void> smooth();
  Result<void> find_part_scales();
  bool set_aside_beyond_limit();
  void weigh_what_is_used();
  std::vector<double> stated_weights() const;  ///< 0 where nothing tells which dead path a reading has
  std::vector<double> instrument_weights() const;
  std::optional<double> criterion(const Sizes& sizes, const std::optional<Trial>& coarsest) const;
  std::size_t unknown_count() const;  ///< unknowns under the gauge
  std::size_t threads() const;

  const MachineModel& machine_;
  const VolumetricLengths& lengths_;
  const IdentifyOptions& options_;
  std::vector<Vector3> tools_mm_;
  std::vector<Approaches> approaches_;
  std::vector<double> sigmas_;
  std::vector<bool> is_copy_, of_unknown_direction_;
  Judged judged_;
  bool drift_ = false;
  TravelBox observed_;
  std::array<CurveDomain, axis_count> domains_;
  std::array<std::vector<std::size_t>, axis_count> supported_;
  Sizes sizes_{};
  std::optional<Coefficients> coefficients_;
  std::optional<Unknowns> unknowns_;
  std::optional<State> state_;  ///< start of the next fit
  std::optional<Fit> fit_;
  std::optional<CurvaturePenalty> penalty_;
  PerCurve plain_variances_{};
  bool bends_settled_ = true;
  std::optional<PartScaleFit> part_scales_;
};

}  // namespace axiometry::volumetric::detail
