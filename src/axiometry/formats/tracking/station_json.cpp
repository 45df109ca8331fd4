// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/tracking/station_json.h"

#include <fmt/format.h>

#include <cmath>

#include "axiometry/base/json/json.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/model/station_bounds.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

constexpr double most_points = 1e9;  // more are no location
constexpr double most_chi_squared = 1e100;

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

/// nullptr when absent or null.
const Value* member(const Value& object, std::string_view name) {
  const Value* value = object.find(name);
  return value == nullptr || value->is(Kind::null) ? nullptr : value;
}

/// By which the covariance of a result without one for bounds, as older versions wrote them, is too narrow for bounds:
/// it was multiplied by χ²/ν alone. 1 where no χ² stands beside it, as people write it.
Result<double> left_to_widen(const Value& object) {
  const Value *chi_squared = member(object, "chi_squared"), *degrees = member(object, "degrees_of_freedom");
  if (chi_squared == nullptr || degrees == nullptr) return 1.0;
  AXIOMETRY_TRY(const double chi, number_in(*chi_squared, "chi_squared"));
  AXIOMETRY_TRY(const double nu, number_in(*degrees, "degrees_of_freedom"));
  if (!(chi >= 0.0 && chi <= most_chi_squared))
    return fail(fmt::format("found chi_squared = {}, expected a number from 0 to 1e100", format_exact(chi)),
                chi_squared->at());
  if (!(nu >= 0.0 && nu <= most_points) || nu != std::floor(nu))
    return fail(
        fmt::format("found degrees_of_freedom = {}, expected a whole number from 0 to 1000000000", format_exact(nu)),
        degrees->at());
  const auto whole = static_cast<std::size_t>(nu);
  return widening_for_bounds(chi, whole) / inflation_of(chi, whole);
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
        "found no member \"station\", expected the result of a location of the station or {\"station\": [x, y, z]}",
        object.at());
  AXIOMETRY_TRY(const Vector3 position, vector_in(*station, "station"));
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(position[k]) <= largest_stated))
      return fail(
          fmt::format("found the coordinate {} of the station, expected at most 1e9 mm", format_exact(position[k])),
          station->items()[k].at());
  AXIOMETRY_TRY_VOID(check_usable(root));
  Station result{position};
  if (const Value* wide = member(object, "covariance_for_bounds")) {
    AXIOMETRY_TRY(result.covariance_mm2, covariance_in(*wide, "covariance_for_bounds"));
  } else if (const Value* covariance = member(object, "covariance")) {
    AXIOMETRY_TRY(const double widening, left_to_widen(object));
    AXIOMETRY_TRY(Matrix3 read, covariance_in(*covariance, "covariance"));
    for (auto& row : read)
      for (double& x : row) x *= widening;
    result.covariance_mm2 = read;
  }
  return result;
}

}  // namespace axiometry::formats
