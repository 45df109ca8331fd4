// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/station_json.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "axiometry/base/json.h"
#include "axiometry/base/number_text.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;

constexpr double coordinate_limit_mm = 1e9;  // the Plan's own limit
constexpr char axis_names[] = {'X', 'Y', 'Z'};

Result<Vector3> vector_from(std::string_view name, const Value& value) {
  if (!value.is(Kind::array) || value.items().size() != 3)
    return fail(fmt::format("found \"{}\" that is no array of three numbers, expected [x, y, z]", name), value.at());
  Vector3 vector;
  for (std::size_t k = 0; k < 3; ++k) {
    const Value& item = value.items()[k];
    if (!item.is(Kind::number))
      return fail(fmt::format("found a {} in \"{}\", expected a number", json::kind_name(item.kind()), name),
                  item.at());
    vector[k] = item.number();
  }
  return vector;
}

/// Rounding of a text of 15 digits.
bool nearly_equal(double a, double b) { return std::abs(a - b) <= 1e-12 * (std::abs(a) + std::abs(b)); }

Result<Matrix3> covariance_from(const Value& value) {
  if (!value.is(Kind::array) || value.items().size() != 3)
    return fail("found \"covariance\" that is no 3 by 3 array, expected three rows of three numbers", value.at());
  Matrix3 matrix{};
  for (std::size_t i = 0; i < 3; ++i) {
    AXIOMETRY_TRY(const Vector3 row, vector_from("covariance", value.items()[i]));
    for (std::size_t k = 0; k < 3; ++k) matrix[i][k] = row[k];
    if (!(matrix[i][i] >= 0.0))
      return fail(
          fmt::format("found the variance {} of {}, expected 0 or more", format_exact(matrix[i][i]), axis_names[i]),
          value.items()[i].at());
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const double covariance = matrix[i][k];
      if (!nearly_equal(covariance, matrix[k][i]))
        return fail(fmt::format("found the covariances {} and {} of {} and {}, expected a symmetric matrix",
                                format_exact(covariance), format_exact(matrix[k][i]), axis_names[i], axis_names[k]),
                    value.items()[i].at());
      if (std::abs(covariance) > std::sqrt(matrix[i][i] * matrix[k][k]) * (1.0 + 1e-9))
        return fail(fmt::format("found the covariance {} of {} and {}, expected at most the root of the product of "
                                "their variances",
                                format_exact(covariance), axis_names[i], axis_names[k]),
                    value.items()[i].at());
    }
  return matrix;
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
  AXIOMETRY_TRY(const Vector3 position, vector_from("station", *station));
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(position[k]) <= coordinate_limit_mm))
      return fail(
          fmt::format("found the coordinate {} of the station, expected at most 1e9 mm", format_exact(position[k])),
          station->items()[k].at());
  Station result{position};
  if (const Value* covariance = object.find("covariance"); covariance != nullptr && !covariance->is(Kind::null)) {
    AXIOMETRY_TRY(result.covariance_mm2, covariance_from(*covariance));
  }
  return result;
}

}  // namespace axiometry::formats
