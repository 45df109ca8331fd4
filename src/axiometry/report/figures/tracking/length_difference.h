// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/model/tracking.h"
#include "axiometry/report/drawing/figure.h"
#include "axiometry/report/report.h"

/// What an error of the station does along lines, as figures (Lee et al., 4.1, Figs 11 to 13; docs/theory/
/// length-difference.md). Where nothing finite is given, a diagram without curves.
namespace axiometry::report {

/// One curve over the distances of its subject.
struct DistanceCurve {
  std::string label;           ///< "x"
  std::vector<double> values;  ///< one per distance; one that is not finite breaks the curve
};

struct DistanceSubject {
  std::span<const double> distances_mm;  ///< distances from the station, above 0, ascending
  std::vector<DistanceCurve> curves;     ///< curves, of which at most seven can be told apart
  std::string title{};
  std::string description{};
};

/// α in degrees over the distance, both logarithmic: it falls as 1/d (Fig. 11).
Figure station_angle_figure(const DistanceSubject& subject, const Options& options);

/// Δd in µm over the distance, logarithmic (Figs 12 and 13): above, as it is; below, its magnitude on a logarithmic
/// scale with the expanded uncertainty a + b·d of the instrument, where given, which it may be compared with.
Figure length_difference_figure(const DistanceSubject& subject, const std::optional<RangingUncertainty>& ranging,
                                const Options& options);

}  // namespace axiometry::report
