// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/station_json.h"

#include <fmt/format.h>

#include <cmath>

#include "axiometry/base/json.h"
#include "axiometry/base/number_text.h"
#include "axiometry/formats/text/json_members.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

constexpr double coordinate_limit_mm = 1e9;  // the Plan's own limit

/// A location that should not be used as it is says so among its findings.
Result<void> check_usable(const Value& root) {
  const Value* findings = root.find("findings");
  if (findings == nullptr || !findings->is(Kind::array)) return {};
  for (const Value& finding : findings->items()) {
    if (!finding.is(Kind::object)) continue;
    const Value *severity = finding.find("severity"), *message = finding.find("message");
    if (severity != nullptr && severity->is(Kind::text) && severity->text() == "serious")
      return fail(fmt::format("found a station that should not be used as it is{}; expected one without a serious "
                              "finding, or its coordinates by hand, as {{\"station\": [x, y, z]}}",
                              message != nullptr && message->is(Kind::text) ? ": " + message->text() : ""),
                  finding.at());
  }
  return {};
}

}  // namespace

Result<Station> read_station(std::string_view bytes) {
  AXIOMETRY_TRY(const Value root, json::parse(bytes));
  if (!root.is(Kind::object))
    return fail(fmt::format("found {} at the top, expected an object with the station", json::kind_name(root.kind())),
                root.at());
  const Value* refined = root.find("refined");
  const Value& object = refined != nullptr && refined->is(Kind::object) ? *refined : root;
  const Value* station = object.find("station");
  if (station == nullptr)
    return fail(
        "found no member \"station\", expected the result of 'axiometry tracking locate --json' or "
        "{\"station\": [x, y, z]}",
        object.at());
  AXIOMETRY_TRY(const Vector3 position, vector_in(*station, "station"));
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(position[k]) <= coordinate_limit_mm))
      return fail(
          fmt::format("found the coordinate {} of the station, expected at most 1e9 mm", format_exact(position[k])),
          station->items()[k].at());
  AXIOMETRY_TRY_VOID(check_usable(root));
  Station result{position};
  if (const Value* covariance = object.find("covariance"); covariance != nullptr && !covariance->is(Kind::null)) {
    AXIOMETRY_TRY(result.covariance_mm2, covariance_in(*covariance, "covariance"));
  }
  return result;
}

}  // namespace axiometry::formats
