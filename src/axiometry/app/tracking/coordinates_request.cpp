// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/tracking/coordinates_request.h"

#include <fmt/format.h>

#include "axiometry/app/files/request_members.h"
#include "axiometry/app/tracking/tracking_text.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/tracking/polar/polar_network.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Value;

constexpr std::size_t most_instruments = tracking::polar_stations_most + 1;  // of each station, and of all

Result<void> take_scale(JsonMembers& members, const Value& options, tracking::MultilaterationOptions& taken) {
  AXIOMETRY_TRY_VOID(take_text(members, "scale", [&](const std::string& word) -> Result<void> {
    AXIOMETRY_TRY(taken.scale, parse_scale_model(word));
    return {};
  }));
  std::optional<double> ppm;
  AXIOMETRY_TRY_VOID(take_number(members, "scale_prior_ppm", ppm));
  if (!ppm) return {};
  const TextPosition at = options.find("scale_prior_ppm")->at();
  if (!(*ppm > 0.0))
    return fail(fmt::format("scale_prior_ppm: found {}, expected a number above 0", format_exact(*ppm)), at);
  if (taken.scale == tracking::ScaleModel::fixed)
    return fail("scale_prior_ppm: found it with a fixed scale, expected scale common or free", at);
  taken.scale_prior = 1e-6 * *ppm;
  return {};
}

Result<tracking::MultilaterationOptions> range_options_from(const Value& options) {
  tracking::MultilaterationOptions taken;
  taken.threads = 1;
  if (options.is(json::Kind::null)) return taken;
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(options, "options"));
  AXIOMETRY_TRY_VOID(take_scale(members, options, taken));
  AXIOMETRY_TRY_VOID(take_text(members, "ranging", [&](const std::string& text) -> Result<void> {
    AXIOMETRY_TRY(taken.ranging, parse_ranging(text));
    return {};
  }));
  AXIOMETRY_TRY_VOID(take_text(members, "repeatability", [&](const std::string& text) -> Result<void> {
    AXIOMETRY_TRY(const Length sigma, parse_length_sigma(text));
    taken.repeatability_sigma_mm = sigma.in_mm();
    return {};
  }));
  AXIOMETRY_TRY_VOID(take_switch(members, "find_breaks", taken.find_breaks));
  AXIOMETRY_TRY_VOID(take_switch(members, "covariances", taken.point_covariances));
  AXIOMETRY_TRY_VOID(members.finish());
  if (!(taken.ranging.standard_mm(1000.0) > 0.0) && taken.repeatability_sigma_mm == 0.0)
    return fail("ranging: found an uncertainty of 0, expected one above 0 to weigh by", options.at());
  return taken;
}

Result<void> take_polar(const Value& options, PolarRequest& request) {
  if (options.is(json::Kind::null)) return {};
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(options, "options"));
  AXIOMETRY_TRY_VOID(take_texts(members, "instruments", most_instruments,
                                [&](const std::string& text) { return put_tracker(text, request); }));
  AXIOMETRY_TRY_VOID(
      take_text(members, "ranging", [&](const std::string& text) { return put_polar_lengths(text, request); }));
  AXIOMETRY_TRY_VOID(take_text(members, "angles", [&](const std::string& text) -> Result<void> {
    AXIOMETRY_TRY(request.stated.across, parse_across(text));
    return {};
  }));
  AXIOMETRY_TRY_VOID(take_switch(members, "in_station", request.in_station));
  AXIOMETRY_TRY_VOID(members.finish());
  if (request.in_station && !request.points_bytes)
    return fail("in_station: found it without nominal points, expected both: without, they are anyway", options.at());
  return {};
}

}  // namespace

Result<std::unique_ptr<Multilaterated>> multilaterate_given(const RangesGiven& files, const Value& options) {
  MultilaterateRequest request;
  AXIOMETRY_TRY(request.options, range_options_from(options));
  request.options.stop = files.stop;
  request.ranges = files.ranges.name;
  request.ranges_bytes = files.ranges.bytes;
  request.stations_most = range_stations_most;
  if (files.points) {
    request.points = files.points->name;
    request.points_bytes = files.points->bytes;
  }
  return multilaterate_files(request);
}

Result<std::unique_ptr<PolarResult>> adjust_polar_given(const PolarGiven& files, const Value& options) {
  if (files.readings.size() > tracking::polar_stations_most)
    return fail(fmt::format("found {} files of readings, expected at most {}", files.readings.size(),
                            tracking::polar_stations_most));
  PolarRequest request;
  request.stop = files.stop;
  for (const GivenFile& file : files.readings) {
    request.files.push_back(file.name);
    request.bytes.push_back(file.bytes);
  }
  if (files.points) {
    request.points = files.points->name;
    request.points_bytes = files.points->bytes;
  }
  AXIOMETRY_TRY_VOID(take_polar(options, request));
  return adjust_polar_files(request);
}

}  // namespace axiometry::app
