// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/multilaterate.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <unordered_map>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/tracking.h"

namespace axiometry::app {
namespace {

constexpr std::size_t limit_bytes = std::size_t{4} << 30;

/// The nominal points of another file in the order in which the lengths name them.
Result<void> take_points(Multilaterated& result, formats::NamedPoints points, const std::string& file) {
  formats::RangesFile& ranges = result.ranges;
  if (!ranges.nominal_mm.empty())
    return fail("found nominal places beside the lengths and in another file, expected them once");
  std::unordered_map<std::string_view, std::size_t> numbers;
  for (std::size_t k = 0; k < points.names.size(); ++k) numbers.emplace(points.names[k], k);
  for (std::size_t i = 0; i < ranges.points.size(); ++i) {
    const auto found = numbers.find(ranges.points[i]);
    if (found == numbers.end())
      return fail(fmt::format("found lengths of point {}, which {} does not have", text::quoted(ranges.points[i]),
                              base_name(file)),
                  {ranges.lines[i], 0});
    ranges.nominal_mm.push_back(points.at_mm[found->second]);
  }
  if (const std::size_t left = points.names.size() - ranges.points.size(); left > 0)
    ranges.remarks.push_back(fmt::format("{} nominal point{} no length and {} left out", left,
                                         left == 1 ? " has" : "s have", left == 1 ? "is" : "are"));
  for (std::string& remark : points.remarks) ranges.remarks.push_back(fmt::format("{}: {}", base_name(file), remark));
  return {};
}

Result<void> read_inputs(Multilaterated& result, const MultilaterateRequest& request) {
  AXIOMETRY_TRY(const std::string bytes, bytes_at_hand(request.ranges_bytes, request.ranges, limit_bytes));
  result.sha256 = sha256(bytes);
  AXIOMETRY_TRY(result.ranges, in_file(formats::read_ranges(bytes), request.ranges));
  if (const std::size_t found = result.ranges.stations.size(); found > request.stations_most.value_or(found))
    return in_file(
        Result<void>(fail(fmt::format("found {} stations, expected at most {}", found, *request.stations_most))),
        request.ranges);
  if (request.points.empty()) {
    if (!result.ranges.nominal_mm.empty()) return {};
    return in_file(Result<void>(fail("found no columns x_mm, y_mm, z_mm, expected the nominal points there or in a "
                                     "file of their own")),
                   request.ranges);
  }
  AXIOMETRY_TRY(const std::string points, bytes_at_hand(request.points_bytes, request.points, limit_bytes));
  result.points_sha256 = sha256(points);
  result.points_file = request.points;
  AXIOMETRY_TRY(formats::NamedPoints named, in_file(formats::read_named_points(points), request.points));
  return in_file(take_points(result, std::move(named), request.points), request.ranges);
}

}  // namespace

Result<std::unique_ptr<Multilaterated>> multilaterate_files(const MultilaterateRequest& request) {
  auto result = std::make_unique<Multilaterated>();
  result->file = request.ranges;
  AXIOMETRY_TRY_VOID(read_inputs(*result, request));
  result->options = request.options;
  result->options.station_names = result->ranges.stations;
  result->options.point_names = result->ranges.points;
  const formats::RangesFile& ranges = result->ranges;
  AXIOMETRY_TRY(result->fit, in_file(tracking::multilaterate(ranges.nominal_mm, ranges.stations.size(), ranges.readings,
                                                             result->options),
                                     request.ranges));
  return result;
}

Result<tracking::ScaleModel> parse_scale_model(std::string_view word) {
  using tracking::ScaleModel;
  if (word == "fixed") return ScaleModel::fixed;
  if (word == "common") return ScaleModel::common;
  if (word == "free") return ScaleModel::free;
  return fail(fmt::format("found {}, expected fixed, common or free", text::quoted(word)));
}

report::Document compose(const Multilaterated& result, const report::Options& options) {
  return report::compose(
      report::MultilaterationSubject{result.ranges.nominal_mm, result.ranges.readings, result.fit, result.options,
                                     result.file, result.sha256, result.points_file, result.points_sha256},
      options);
}

}  // namespace axiometry::app
