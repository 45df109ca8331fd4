// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/model/tracking.h"

/// Kinds of tracking instruments with what their makers stated (Lee et al., Sensors 16 (2016) 482, Table 1: catalogues
/// of 2016, as printed there). They are presets of uncertainty: an instrument's own certificate is better.
namespace axiometry::tracking {

/// One figure of the table.
struct StatedAccuracy {
  double constant_um = 0.0;
  double um_per_m = 0.0;
  /// k = 2 is stated. Without: ±(constant + per metre) is taken as bounds within which every value is alike, with the
  /// standard uncertainty of the half width over √3 (GUM, 4.3.7). That is more than half of it: the safer reading.
  bool expanded = false;

  /// As U = a + b·L with k = 2.
  RangingUncertainty expanded_uncertainty() const;
};

struct TrackerKind {
  std::string_view id;                             ///< "leica-at901"
  std::string_view title;                          ///< "Leica AT901"
  std::string_view range_m;                        ///< as printed: "50/160", by its models
  std::optional<StatedAccuracy> across{};          ///< its angles, at right angles to the beam, over the distance
  std::optional<StatedAccuracy> absolute{};        ///< lengths by absolute distance measurement (ADM)
  std::optional<StatedAccuracy> interferometer{};  ///< lengths by interferometer (IFM), or both together (AIFM)
};

/// Those of Table 1, in its order.
std::span<const TrackerKind> tracker_kinds();

/// Which lengths are asked for.
enum class LengthMode {
  changes,   ///< changes from a zero that is not known: by the interferometer where it has one
  absolute,  ///< distances (eq. 1): absolute where it has them
};

/// A kind by its id, or "id:adm", "id:ifm" for one of its lengths.
struct ChosenTracker {
  const TrackerKind* kind = nullptr;
  std::optional<StatedAccuracy> length;  ///< absent where the table has none
};
/// Nothing when no kind has that id. Fails on a length that the kind does not have.
Result<std::optional<ChosenTracker>> find_tracker(std::string_view name, LengthMode mode);

}  // namespace axiometry::tracking
