// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

#include "axiometry/app/files/given_file.h"
#include "axiometry/app/tracking/multilaterate.h"
#include "axiometry/app/tracking/polar.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"

/// Points from lengths, and from lengths with angles, as the workbench asks for them: files that are at hand, and how
/// they are adjusted. No text of a request is taken for the name of a file.
namespace axiometry::app {

inline constexpr std::size_t range_stations_most = 100;  ///< the work grows with the cube of their number

struct RangesGiven {
  GivenFile ranges;
  std::optional<GivenFile> points;
  std::stop_token stop{};  ///< nobody waits for the answer any more
};

/// Options: {"scale": "fixed", "common" or "free", "scale_prior_ppm": 0.1, "ranging": "0.2um+0.3um/m", "repeatability":
/// "0.5um", "find_breaks", "covariances"}; all may be left out, and so may they all (null). In one thread. Fails, with
/// line and column, on members that are unknown or of another kind, on a prior of a scale that is fixed, on a length
/// without any uncertainty, on more than range_stations_most stations, and as multilaterate_files() does.
Result<std::unique_ptr<Multilaterated>> multilaterate_given(const RangesGiven& files, const json::Value& options);

struct PolarGiven {
  std::vector<GivenFile> readings;
  std::optional<GivenFile> points;
  std::stop_token stop{};  ///< nobody waits for the answer any more
};

/// Options: {"instruments": ["leica-at901", "TR=etalon-lasertracer"], "ranging": "20um+1um/m", "angles": "4arcsec",
/// "in_station"}; all may be left out (null). Fails, with line and column, on members that are unknown or of another
/// kind, on more than 51 instruments, on in_station without nominal points, on more files than stations are possible,
/// and as put_tracker(), put_polar_lengths(), parse_across() and adjust_polar_files() do.
Result<std::unique_ptr<PolarResult>> adjust_polar_given(const PolarGiven& files, const json::Value& options);

}  // namespace axiometry::app
