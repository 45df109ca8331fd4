// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/app/results/experiment.h"
#include "axiometry/formats/tracking/polar_csv.h"
#include "axiometry/tracking/instruments/tracker_kinds.h"
#include "axiometry/tracking/polar/polar_network.h"

/// The use case "from lengths and angles of one or more instruments to coordinates with their covariances".
namespace axiometry::app {

/// What is known of readings whose rows do not state their own uncertainty; each U with k = 2.
struct PolarUncertainty {
  std::optional<RangingUncertainty> length{};  ///< U = a + b·L
  std::optional<RangingUncertainty> across{};  ///< U of the angles at right angles to the beam at the distance L
};

struct PolarRequest {
  std::vector<std::string> files;  ///< files of readings; "-" is the standard input
  std::string points;              ///< file of nominal points; may be empty
  /// What counts where a row states nothing, in this order: the instrument of its station, `stated`, the instrument of
  /// all stations. Instruments are kinds of tracker_kinds().
  std::vector<std::pair<std::string, std::string>> instruments;  ///< station (empty: all) and name
  PolarUncertainty stated;
  /// Those of each of `files`, and of `points`, where they are at hand; they must outlive the call. No file is looked
  /// for then.
  std::vector<std::string_view> bytes{};
  std::optional<std::string_view> points_bytes{};
  std::stop_token stop{};   ///< nobody waits for it any more
  bool in_station = false;  ///< whether coordinates are those of the first station with angles, with nominal points too
};

/// What was noticed in a file: a sentence without full stop.
struct PolarRemark {
  std::string file;
  std::string text;
};

struct PolarSource {
  std::string file;
  std::string sha256;
};

/// A result with the names it speaks of.
struct PolarResult {
  std::vector<std::string> points, stations;
  std::vector<std::vector<std::string>> segments;  ///< names of the segments per station
  std::vector<Vector3> nominal_mm;                 ///< nominal place per point, or empty
  std::vector<tracking::PolarReading> readings;
  std::vector<PolarSource> sources;
  std::optional<PolarSource> points_source;
  std::vector<PolarRemark> remarks;
  tracking::PolarOptions options;
  tracking::PolarFit fit;

  PolarResult() = default;
  PolarResult(const PolarResult&) = delete;  // options look at names and places of it
  PolarResult& operator=(const PolarResult&) = delete;
};

/// "15um+6um/m" (at right angles to the beam, over the distance) or "2arcsec", k = 2. Fails on anything else.
Result<RangingUncertainty> parse_across(std::string_view text);

/// Reads, joins and adjusts. Fails, with file and line where there is one, as read_polar(), read_named_points() and
/// adjust_polar() do; on one station in two files, an instrument of no station, a name that no kind has, a reading
/// whose uncertainty nobody states, files without any angle, and a point without nominal place where these are given.
Result<std::unique_ptr<PolarResult>> adjust_polar_files(const PolarRequest& request);

/// Document and JSON.
Experiment present(const PolarResult& result, const report::Options& options);

/// "NAME" or "STATION=NAME" of an instrument, put where it belongs. Fails without a station before "=".
Result<void> put_tracker(std::string_view text, PolarRequest& request);
/// U = a + b·L of lengths, likewise. Fails as parse_ranging() does and on the name of an instrument.
Result<void> put_polar_lengths(std::string_view text, PolarRequest& request);

/// CSV of the points found, with their covariances.
std::string polar_points_csv(const PolarResult& result);
Result<void> write_polar_points(const PolarResult& result, const std::string& file);

}  // namespace axiometry::app
