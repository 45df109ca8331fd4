// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/results/outputs.h"
#include "axiometry/base/json/json.h"
#include "axiometry/formats/tracking/ranges_csv.h"
#include "axiometry/report/report.h"
#include "axiometry/tracking/ranges/multilateration.h"

/// The use case "from lengths between points and stations to where both are".
namespace axiometry::app {

struct MultilaterateRequest {
  std::string ranges;  ///< file; "-" is the standard input
  std::string points;  ///< file of nominal points; empty when they stand beside the lengths
  tracking::MultilaterationOptions options = {};
  /// Those of `ranges` and `points` where they are at hand; they must outlive the call. No file is looked for then.
  std::optional<std::string_view> ranges_bytes{}, points_bytes{};
  std::optional<std::size_t> stations_most{};  ///< absent: any number
};

/// A result with the names it speaks of.
struct Multilaterated {
  formats::RangesFile ranges;  ///< readings with their nominal points
  tracking::MultilaterationOptions options;
  tracking::MultilaterationFit fit;
  std::string file, sha256;
  std::string points_file, points_sha256;  ///< empty when there was none

  Multilaterated() = default;
  Multilaterated(const Multilaterated&) = delete;  // options look at names in `ranges`
  Multilaterated& operator=(const Multilaterated&) = delete;
};

/// Reads and solves. Fails, with file and line where there is one, as read_ranges(), read_named_points() and
/// tracking::multilaterate() do, on a point without nominal place, on nominal places in two files and on more stations
/// than asked for.
Result<std::unique_ptr<Multilaterated>> multilaterate_files(const MultilaterateRequest& request);

report::Document compose(const Multilaterated& result, const report::Options& options);

/// Everything: docs/results.md.
json::Value to_json(const Multilaterated& result);
/// CSV of the points found, and of the readings with their residuals.
std::string points_csv(const Multilaterated& result);
std::string residuals_csv(const Multilaterated& result);

/// Fails on anything but "fixed", "common" and "free".
Result<tracking::ScaleModel> parse_scale_model(std::string_view word);

struct MultilateratedNames {
  OutputNames outputs;
  std::string points;     ///< CSV of the points found
  std::string residuals;  ///< CSV of the readings with their residuals
};

/// JSON (docs/results.md; one line for each point, so that many need little memory), reports and tables. Fails when an
/// output is an input or cannot be written.
Result<void> write_outputs(const Multilaterated& result, const report::Document& document,
                           const MultilateratedNames& names, const report::Options& options);

}  // namespace axiometry::app
