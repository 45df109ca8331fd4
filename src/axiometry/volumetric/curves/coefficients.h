// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/volumetric/curves/curve_basis.h"
#include "axiometry/volumetric/curves/gauge.h"
#include "axiometry/volumetric/machine/kinematics.h"

/// The numbers that the 21 errors are made of, and their places.
namespace axiometry::volumetric {

/// How an axis' errors differ between its two directions: none, a constant of each of the six motions, or a curve of
/// each. Half of the difference is added where the axis came to rest moving up, and taken away where it moved down.
enum class Reversal { none, constant, curves };

/// In which direction each axis came to rest: +1, −1, or 0 for the mean of both.
using Approaches = std::array<double, axis_count>;

/// Numbers the coefficients. Raw: of axis a first those of the common curves, [function][motion], then squareness, then
/// the halves of reversal likewise. Free: those that are left under the gauge, in the same order.
class Coefficients {
 public:
  Coefficients(std::array<CurveBasis, axis_count> bases, Reversal reversal);
  /// Of curves of one kind over ranges of the axes. Fails as CurveBasis::make().
  static Result<Coefficients> make(CurveKind kind, const TravelBox& ranges, std::array<std::size_t, axis_count> sizes,
                                   Reversal reversal);

  const CurveBasis& basis(std::size_t axis) const { return bases_[axis]; }
  Reversal reversal() const { return reversal_; }
  const Gauge& gauge(ErrorMotion error) const { return gauges_[error.axis * motion_count + error.motion]; }

  std::size_t raw() const { return raw_; }
  std::size_t free() const { return free_.size(); }
  std::size_t curve(std::size_t axis) const { return curve_[axis]; }  ///< first raw place
  std::size_t squareness() const { return squareness_; }              ///< place of C0Y; B0Z and A0Z follow
  std::size_t half(std::size_t axis) const { return half_[axis]; }
  std::size_t half_functions(std::size_t axis) const;  ///< 0, 1 or as the basis

  std::vector<double> raw_of(std::span<const double> free_coefficients) const;
  /// A symmetric matrix of at least raw() rows of `width` numbers, whose first raw() rows and columns are coefficients
  /// and the others anything else: H N Hᵀ in place, without what the gauge removes: see kept().
  void turn(std::vector<double>& matrix, std::size_t width) const;
  void turn_vector(std::vector<double>& vector) const;
  /// Gᵀ C G of a symmetric matrix of free coefficients, for raw ones.
  std::vector<double> raw_covariance(const std::vector<double>& free_covariance) const;
  /// Raw places that stay after turn(), in order.
  const std::vector<std::size_t>& kept() const { return free_; }
  /// What raw coefficients make of all errors when the axes stand at q.
  ErrorValues errors(std::span<const double> raw_coefficients, Vector3 axes_mm, Approaches approaches = {}) const;
  /// Which error a raw place belongs to, 0 to 20 in the order of error_names().
  std::size_t error_of(std::size_t raw_place) const;

 private:
  template <typename Apply>
  void for_functions(const Apply& apply) const;

  std::array<CurveBasis, axis_count> bases_;
  Reversal reversal_;
  std::vector<Gauge> gauges_;
  std::array<std::size_t, axis_count> curve_{}, half_{};
  std::size_t squareness_ = 0, raw_ = 0;
  std::vector<std::size_t> free_;
};

}  // namespace axiometry::volumetric
