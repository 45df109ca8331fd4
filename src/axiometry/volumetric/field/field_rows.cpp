// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/field_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace axiometry::volumetric {
namespace {

double product(std::span<const double> a, std::span<const double> b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

void add_field(DenseRow& row, const ErrorModel& model, Vector3 axes_mm, Vector3 tool_mm, Vector3 direction,
               Approaches approaches, double weight) {
  const double size = norm(direction);
  row.resize(model.coefficients().raw(), 0.0);
  if (size == 0.0) return;
  BeamRow beam(model.coefficients(), model.machine(), axes_mm, tool_mm, approaches);
  beam.along(1.0 / size * direction);
  for (const BeamRow::Piece& piece : beam.pieces())
    for (std::size_t k = 0; k < piece.count; ++k) row[piece.first + k] += weight * size * piece.values[k];
}

Vector3 field_um(const ErrorModel& model, std::span<const double> coefficients, Vector3 axes_mm, Vector3 tool_mm) {
  return BeamRow(model.coefficients(), model.machine(), axes_mm, tool_mm).displacement_um(coefficients);
}

DenseRow covariance_times(const ErrorModel& model, std::span<const double> row) {
  const std::size_t n = model.coefficients().raw();
  DenseRow result(n);
  for (std::size_t i = 0; i < n; ++i)
    if (row[i] != 0.0)
      for (std::size_t k = 0; k < n; ++k) result[k] += row[i] * model.parts().covariance[i * n + k];
  return result;
}

Estimate estimate_of(const ErrorModel& model, std::span<const double> row) {
  return {product(row, model.parts().values), std::sqrt(std::max(0.0, product(row, covariance_times(model, row))))};
}

bool is_told(const ErrorModel& model, std::span<const double> row, double size) {
  return std::ranges::all_of(model.parts().unseen, [&](const std::vector<double>& direction) {
    return std::abs(product(row, direction)) <= told_most * size;
  });
}

Vector3 place_in(const TravelBox& box, Vector3 shares) {
  Vector3 place;
  for (std::size_t a = 0; a < axis_count; ++a)
    place[a] = box.lowest_mm[a] + shares[a] * (box.highest_mm[a] - box.lowest_mm[a]);
  return place;
}

}  // namespace axiometry::volumetric
