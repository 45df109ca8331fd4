// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/volumetric/volumetric_result_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/volumetric/machine_json.h"

namespace axiometry::formats {
namespace {

using json::Kind;
using json::Value;
using volumetric::Coefficients;
using volumetric::CurveBasis;
using volumetric::CurveKind;
using volumetric::ErrorModel;
using volumetric::Reversal;

constexpr std::size_t coefficients_most = 4000;
constexpr double coefficient_most = 1e6;  // µm, µrad: a metre
constexpr double variance_most = 1e15;
constexpr double range_slack_mm = 0.02;
constexpr std::array<std::string_view, 3> reversal_names = {"none", "constant", "curves"};
constexpr std::array<CurveKind, 3> kinds = {CurveKind::spline, CurveKind::legendre, CurveKind::nodes};

Value list(const std::vector<double>& numbers) {
  Value array = Value::array();
  for (const double x : numbers) array.push(x);
  return array;
}

Result<std::vector<double>> numbers_in(const Value& value, std::string_view what, std::size_t count) {
  AXIOMETRY_TRY(const std::vector<Value>* items, items_in(value, what));
  if (items->size() != count)
    return fail(fmt::format("found {} numbers of {}, expected {}", items->size(), what, count), value.at());
  std::vector<double> numbers;
  for (const Value& item : *items) {
    AXIOMETRY_TRY(numbers.emplace_back(), number_in(item, what));
  }
  return numbers;
}

Result<CurveBasis> basis_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "curves"));
  std::string kind_name;
  double size = 0.0;
  AXIOMETRY_TRY_VOID(members.take("kind", kind_name));
  AXIOMETRY_TRY_VOID(members.take("size", size));
  AXIOMETRY_TRY(const Value* range, members.required("range_mm"));
  AXIOMETRY_TRY(const std::vector<double> ends, numbers_in(*range, "range_mm", 2));
  AXIOMETRY_TRY_VOID(members.finish());
  if (!(size >= 1.0 && size <= 400.0) || size != std::floor(size))
    return fail("found a size of a curve that is none, expected a whole number from 1 to 400", value.at());
  for (const CurveKind kind : kinds)
    if (volumetric::curve_kind_name(kind) == kind_name) {
      auto basis = CurveBasis::make(kind, ends[0], ends[1], static_cast<std::size_t>(size));
      if (!basis) return fail(basis.error().message, value.at());
      return *basis;
    }
  return fail(fmt::format("found curves of the kind {}, expected b-spline, legendre or nodes", text::quoted(kind_name)),
              value.at());
}

Result<Reversal> reversal_from(const Value& value) {
  AXIOMETRY_TRY(const std::string name, text_in(value, "reversal"));
  for (std::size_t k = 0; k < reversal_names.size(); ++k)
    if (reversal_names[k] == name) return static_cast<Reversal>(k);
  return fail(fmt::format("found the reversal {}, expected none, constant or curves", text::quoted(name)), value.at());
}

Result<std::vector<double>> covariance_from(const Value& value, std::size_t n) {
  AXIOMETRY_TRY(const std::vector<double> lower, numbers_in(value, "covariance", n * (n + 1) / 2));
  std::vector<double> matrix(n * n);
  for (std::size_t i = 0, at = 0; i < n; ++i)
    for (std::size_t k = 0; k <= i; ++k, ++at) matrix[i * n + k] = matrix[k * n + i] = lower[at];
  double largest = 0.0;
  for (std::size_t i = 0; i < n; ++i) largest = std::max(largest, matrix[i * n + i]);
  if (!(largest <= variance_most))
    return fail(fmt::format("found a variance of {}, expected at most {}", largest, variance_most), value.at());
  const double rounding = 1e-9 * largest;
  for (std::size_t i = 0; i < n; ++i) {
    if (matrix[i * n + i] < -rounding)
      return fail(fmt::format("found a variance below 0 of coefficient {}, expected a covariance", i + 1), value.at());
    matrix[i * n + i] = std::max(0.0, matrix[i * n + i]);
  }
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < i; ++k)
      if (std::abs(matrix[i * n + k]) > (1.0 + 1e-6) * std::sqrt(matrix[i * n + i] * matrix[k * n + k]) + rounding)
        return fail(fmt::format("found a covariance of coefficients {} and {} beyond their variances, expected a "
                                "covariance matrix",
                                i + 1, k + 1),
                    value.at());
  return matrix;
}

}  // namespace

Value error_model_value(const ErrorModel& model) {
  const Coefficients& c = model.coefficients();
  Value value = Value::object();
  value.add("machine", machine_value(model.machine()));
  value.add("reversal", reversal_names[static_cast<std::size_t>(c.reversal())]);
  Value& curves = value.add("curves", Value::object());
  for (std::size_t a = 0; a < 3; ++a) {
    Value& axis = curves.add(linear_axis_names[a], Value::object());
    axis.add("kind", volumetric::curve_kind_name(c.basis(a).kind()));
    axis.add("size", c.basis(a).size());
    axis.add("range_mm", Value::array({c.basis(a).lower_mm(), c.basis(a).upper_mm()}));
  }
  Value& observed = value.add("observed_mm", Value::object());
  for (std::size_t a = 0; a < 3; ++a)
    observed.add(linear_axis_names[a], Value::array({model.observed().lowest_mm[a], model.observed().highest_mm[a]}));
  value.add("coefficients", list(model.parts().values));
  const std::size_t n = c.raw();
  std::vector<double> lower;
  lower.reserve(n * (n + 1) / 2);
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k <= i; ++k) lower.push_back(model.parts().covariance[i * n + k]);
  value.add("covariance", list(lower));
  Value& unseen = value.add("unseen", Value::array());
  for (const auto& direction : model.parts().unseen) unseen.push(list(direction));
  return value;
}

Result<ErrorModel> error_model_from(const Value& value) {
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(value, "model"));
  AXIOMETRY_TRY(const Value* machine_member, members.required("machine"));
  AXIOMETRY_TRY(MachineFile file, machine_from(*machine_member));
  AXIOMETRY_TRY(const Value* reversal_member, members.required("reversal"));
  AXIOMETRY_TRY(const Reversal reversal, reversal_from(*reversal_member));
  AXIOMETRY_TRY(const Value* curves, members.required("curves"));
  AXIOMETRY_TRY(JsonMembers axes, JsonMembers::of(*curves, "curves"));
  AXIOMETRY_TRY(const Value* observed_member, members.required("observed_mm"));
  AXIOMETRY_TRY(JsonMembers observed_axes, JsonMembers::of(*observed_member, "observed_mm"));
  std::vector<CurveBasis> bases;
  TravelBox observed;
  for (std::size_t a = 0; a < 3; ++a) {
    AXIOMETRY_TRY(const Value* axis, axes.required(linear_axis_names[a]));
    AXIOMETRY_TRY(const CurveBasis basis, basis_from(*axis));
    bases.push_back(basis);
    AXIOMETRY_TRY(const Value* ends_member, observed_axes.required(linear_axis_names[a]));
    AXIOMETRY_TRY(const std::vector<double> ends, numbers_in(*ends_member, "observed_mm", 2));
    observed.lowest_mm[a] = ends[0];
    observed.highest_mm[a] = ends[1];
    const bool is_inside = basis.lower_mm() >= file.machine.travel.lowest_mm[a] - range_slack_mm &&
                           basis.upper_mm() <= file.machine.travel.highest_mm[a] + range_slack_mm &&
                           ends[0] >= basis.lower_mm() - range_slack_mm && ends[0] < ends[1] &&
                           ends[1] <= basis.upper_mm() + range_slack_mm;
    if (!is_inside)
      return fail(
          fmt::format("found ranges of {} that do not lie in one another, expected readings within curves within "
                      "the travel",
                      linear_axis_names[a]),
          ends_member->at());
  }
  const Coefficients coefficients({bases[0], bases[1], bases[2]}, reversal);
  const std::size_t n = coefficients.raw();
  if (n > coefficients_most)
    return fail(fmt::format("found {} coefficients, expected at most {}", n, coefficients_most), value.at());
  AXIOMETRY_TRY(const Value* values_member, members.required("coefficients"));
  AXIOMETRY_TRY(std::vector<double> values, numbers_in(*values_member, "coefficients", n));
  if (std::ranges::any_of(values, [](double x) { return std::abs(x) > coefficient_most; }))
    return fail(fmt::format("found a coefficient beyond {}, expected errors of a machine", coefficient_most),
                values_member->at());
  AXIOMETRY_TRY(const Value* covariance_member, members.required("covariance"));
  AXIOMETRY_TRY(std::vector<double> covariance, covariance_from(*covariance_member, n));
  std::vector<std::vector<double>> unseen;
  if (const Value* unseen_member = members.optional("unseen")) {
    AXIOMETRY_TRY(const std::vector<Value>* directions, items_in(*unseen_member, "unseen"));
    for (const Value& direction : *directions) {
      AXIOMETRY_TRY(unseen.emplace_back(), numbers_in(direction, "unseen", n));
    }
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return ErrorModel(
      {std::move(file.machine), coefficients, std::move(values), std::move(covariance), std::move(unseen), observed});
}

Result<ErrorModel> read_error_model(std::string_view bytes) {
  AXIOMETRY_TRY(const Value root, json::parse(bytes));
  return error_model_of(root);
}

Result<ErrorModel> error_model_of(const Value& root) {
  const Value* model = root.is(Kind::object) ? root.find("model") : nullptr;
  if (model == nullptr)
    return fail("found no member \"model\", expected the result of a volumetric calibration", root.at());
  return error_model_from(*model);
}

}  // namespace axiometry::formats
