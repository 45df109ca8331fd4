// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "axiometry/app/recordings/recording_members.h"
#include "axiometry/app/volumetric/part_stops.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/identification.h"

/// What is asked of an identification, as a request says it.
namespace axiometry::app {

struct IdentifyChoices {
  volumetric::IdentifyOptions model;
  std::vector<PartRange> parts;  ///< parts that the recordings hold, in their order; none: they are recognised
  CaptureOptions recording;      ///< what a recording does not say itself
};

/// {"curves": "b-spline", "legendre" or "nodes", "spans": 8 or [8, 6, 4], "reversal": "none", "constant" or "curves",
/// "smoothness": "none", "auto", 5 or [5, 8] (µm, µrad), "drift": "auto", "none" or "linear", "find_breaks",
/// "find_outliers", "find_part_scales", "parts": ["1", "5-8"], "reversed", "recording": {"rate": "1000"}}; all may be
/// left out. Fails, with line and column, on members that are unknown or of another kind, on spans that are no whole
/// numbers from 1 to 400, on a smoothness beyond its bounds, on more than 500 parts, and as take_recording() does.
Result<IdentifyChoices> identify_choices_from(const json::Value& value);

/// The same back, but for what is as usual: identify_choices_from() of it is `choices`. `recording` is what
/// choices.recording was made of.
json::Value to_json(const IdentifyChoices& choices, const RecordingTexts& recording);

/// What the flags of the same names mean, by the same words and bounds.
Result<volumetric::CurveKind> parse_curves(std::string_view word);
Result<volumetric::Reversal> parse_reversal(std::string_view word);
Result<volumetric::DriftModel> parse_drift(std::string_view word);

using CurveSizes = std::array<std::size_t, volumetric::axis_count>;
/// "8" for all axes, or "8,6,4" for X, Y, Z.
Result<CurveSizes> parse_spans(std::string_view text);

/// "none", "auto", "5" (µm and µrad) or "5,8": what `--smoothness` means.
Result<volumetric::Smoothness> parse_smoothness(std::string_view text);

}  // namespace axiometry::app
