// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/machine_zero.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

namespace axiometry::volumetric {
namespace {

/// Linear in raw coefficients.
class MoveToZero {
 public:
  explicit MoveToZero(const ErrorModel& model) : coefficients_(model.coefficients()) {
    for (std::size_t a = 0; a < axis_count; ++a) {
      points_m_[a] = 1e-3 * model.machine().functional_point_mm[a];
      lines_[a] = coefficients_.basis(a).line();
      slopes_[a] = coefficients_.basis(a).slopes();
    }
  }

  void move(std::span<double> raw) const {
    std::array<std::array<double, 3>, axis_count> tilts{};  // [axis][along], µrad
    for (std::size_t a = 0; a < axis_count; ++a) {
      shift(raw.subspan(coefficients_.curve(a)), coefficients_.basis(a).functions(), points_m_[a]);
      shift(raw.subspan(coefficients_.half(a)), coefficients_.half_functions(a), points_m_[a]);
      for (std::size_t along = 0; along < 3; ++along)
        if (along != a) tilts[a][along] = level(raw, {a, along});
    }
    // Three of the slopes are squareness; the others turn the whole machine.
    double* square = raw.data() + coefficients_.squareness();
    square[static_cast<std::size_t>(Squareness::C0Y)] -= tilts[1][0] + tilts[0][1];
    square[static_cast<std::size_t>(Squareness::B0Z)] += tilts[2][0] + tilts[0][2];
    square[static_cast<std::size_t>(Squareness::A0Z)] -= tilts[2][1] + tilts[1][2];
  }

 private:
  static void shift(std::span<double> curves, std::size_t functions, Vector3 point_m) {
    for (std::size_t k = 0; k < functions; ++k) {
      double* e = curves.data() + k * motion_count;
      const Vector3 moved = cross({e[3], e[4], e[5]}, point_m);
      for (std::size_t m = 0; m < first_rotation; ++m) e[m] -= moved[m];
    }
  }

  /// Takes the best straight line out, and gives its slope.
  double level(std::span<double> raw, ErrorMotion error) const {
    const std::size_t a = error.axis;
    double* first = raw.data() + coefficients_.curve(a) + error.motion;
    double rise = 0.0;  // from the middle to the end; ∫ x² is 1/3
    for (std::size_t k = 0; k < slopes_[a].size(); ++k) rise += 3.0 * slopes_[a][k] * first[k * motion_count];
    for (std::size_t k = 0; k < lines_[a].size(); ++k) first[k * motion_count] -= rise * lines_[a][k];
    const CurveBasis& basis = coefficients_.basis(a);
    return 1e3 * rise / (0.5 * (basis.upper_mm() - basis.lower_mm()));
  }

  const Coefficients& coefficients_;
  std::array<Vector3, axis_count> points_m_;
  std::array<std::vector<double>, axis_count> lines_, slopes_;
};

void move_rows(const MoveToZero& zero, std::vector<double>& square, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i) zero.move(std::span(square).subspan(i * width, width));
}

void transpose(std::vector<double>& square, std::size_t width) {
  for (std::size_t i = 0; i < width; ++i)
    for (std::size_t k = 0; k < i; ++k) std::swap(square[i * width + k], square[k * width + i]);
}

}  // namespace

bool is_at_machine_zero(const MachineModel& machine) {
  return std::ranges::all_of(machine.functional_point_mm, [](const Vector3& c) { return c == Vector3{}; });
}

ErrorModel at_machine_zero(const ErrorModel& model) {
  if (is_at_machine_zero(model.machine())) return model;
  const MoveToZero zero(model);
  const std::size_t n = model.coefficients().raw();
  ErrorModel::Parts parts = model.parts();
  zero.move(parts.values);
  move_rows(zero, parts.covariance, n);
  transpose(parts.covariance, n);
  move_rows(zero, parts.covariance, n);
  for (std::vector<double>& direction : parts.unseen) {
    zero.move(direction);
    double squares = 0.0;
    for (const double x : direction) squares += x * x;
    for (double& x : direction) x /= std::sqrt(squares);
  }
  parts.machine.functional_point_mm = {};
  return ErrorModel(std::move(parts));
}

}  // namespace axiometry::volumetric
