// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as each table and document of a tracking interferometer.
#include <fstream>
#include <iterator>

#include "axiometry/formats/plan/tracking_plan_json.h"
#include "axiometry/formats/tracking/location_points_csv.h"
#include "axiometry/formats/tracking/polar_csv.h"
#include "axiometry/formats/tracking/ranges_csv.h"
#include "axiometry/formats/tracking/station_json.h"
#include "axiometry/formats/tracking/tracking_lengths_csv.h"
#include "described.h"

using namespace axiometry;

namespace {

/// The plan against which lengths are read.
const TrackingPlan& seven_lines() {
  static const TrackingPlan plan = [] {
    std::ifstream file(AXIOMETRY_SOURCE_DIR "/tests/transcripts/tracking-evaluate.files/seven.json", std::ios::binary);
    return *formats::read_tracking_plan(std::string(std::istreambuf_iterator<char>(file), {}));
  }();
  return plan;
}

template <typename T>
bool sound(const Result<T>& read) {
  if (!read) fuzzing::check_error(read.error());
  return read.has_value();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzzing::as_text(data, size);
  if (const auto plan = formats::read_tracking_plan(bytes); sound(plan)) {
    const std::string written = formats::write_tracking_plan(*plan);
    const auto again = formats::read_tracking_plan(written);
    AXIOMETRY_CONTRACT(again && formats::write_tracking_plan(*again) == written);
  }
  if (const auto ranges = formats::read_ranges(bytes); sound(ranges))
    AXIOMETRY_CONTRACT(ranges->readings.size() == ranges->reading_lines.size());
  if (const auto points = formats::read_named_points(bytes); sound(points))
    AXIOMETRY_CONTRACT(points->names.size() == points->at_mm.size());
  if (const auto polar = formats::read_polar(bytes); sound(polar))
    for (const auto& row : polar->rows)
      AXIOMETRY_CONTRACT(row.point < polar->points.size() && row.segment < polar->segments[row.station].size());
  sound(formats::read_location_points(bytes));
  sound(formats::read_station(bytes));
  if (const auto lengths = formats::read_tracking_lengths(bytes, seven_lines()); sound(lengths))
    AXIOMETRY_CONTRACT(!lengths->rows.empty());
  return 0;
}
