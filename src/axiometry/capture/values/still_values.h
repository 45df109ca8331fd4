// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/model/recording.h"

/// Whether what an instrument reads across an axis, or of its rotations, stood still for a while. µm, µrad or ″ in
/// Sample::position; derivations: docs/theory/capture.md.
namespace axiometry::capture {

/// The four means of a quarter of the samples each lie within rest_threshold(). Nothing but the readings tells what is
/// too much, so that `greatest` is ten times `smallest`.
struct StillOptions {
  double smallest = 1.0;              ///< 1 µm, 1″ or as much in µrad
  std::optional<double> threshold{};  ///< T itself, instead of all that
  std::string_view unit = "µm";       ///< unit of all values, for sentences
};

/// The mean of samples that stood still.
struct StillValue {
  double from_s = 0.0;
  double to_s = 0.0;
  std::size_t count = 0;     ///< averaged
  std::size_t rejected = 0;  ///< outliers, left out
  double value = 0.0;
  double spread = 0.0;  ///< standard deviation s of the samples; 0 of a single one, which tells none
  double drift = 0.0;   ///< slope of a line through the four means, times from_s to to_s
};

/// Of fewer samples nothing tells rest from motion.
inline constexpr std::size_t samples_to_judge = 16;

/// Fails on fewer samples than that, and when their means lie farther apart than T. Needs finite samples in order of
/// time (contract).
Result<StillValue> still_value(std::span<const Sample> samples, const StillOptions& options);

}  // namespace axiometry::capture
