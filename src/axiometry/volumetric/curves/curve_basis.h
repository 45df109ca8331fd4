// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"

/// What the error motions of an axis are made of: sums of basis functions of its position.
namespace axiometry::volumetric {

enum class CurveKind {
  spline,    ///< cubic B-splines on equidistant knots: smooth, and each has a place
  legendre,  ///< Legendre polynomials up to a degree
  nodes,     ///< values at equidistant nodes with straight lines between: what a control's table does
};
/// "b-spline", "legendre", "nodes".
std::string_view curve_kind_name(CurveKind kind);

/// The functions that are not 0 at a position: `count` of them from `first` on; values behind these are not set.
struct ActiveFunctions {
  static constexpr std::size_t most = 16;
  std::size_t first = 0;
  std::size_t count = 0;
  std::array<double, most> values;
};

class CurveBasis {
 public:
  /// `size` are the spans between knots or nodes, or the degree of the polynomials. Fails unless lower < upper and 1 ≤
  /// size ≤ 400 (polynomials: 15).
  static Result<CurveBasis> make(CurveKind kind, double lower_mm, double upper_mm, std::size_t size);

  CurveKind kind() const { return kind_; }
  double lower_mm() const { return lower_; }
  double upper_mm() const { return upper_; }
  std::size_t size() const { return size_; }
  std::size_t functions() const { return functions_; }

  /// At a position; outside of [lower, upper] what the nearest span continues to.
  ActiveFunctions at(double position_mm) const {
    ActiveFunctions active;
    set_at(position_mm, active);
    return active;
  }
  void set_at(double position_mm, ActiveFunctions& active) const;  ///< the same, without a copy

  /// `first` of at().
  std::size_t first_active(double position_mm) const;

  /// ∫ B_k dq / (upper − lower), of each function.
  std::vector<double> means() const;
  /// ∫ B_k x dq / (upper − lower) with x = (2q − lower − upper)/(upper − lower), from −1 to 1.
  std::vector<double> slopes() const;

  /// Coefficients of the straight line x, from −1 at `lower` to 1 at `upper`, which every basis holds.
  std::vector<double> line() const;

  friend bool operator==(const CurveBasis&, const CurveBasis&) = default;

 private:
  CurveBasis() = default;
  double spans_along(double position_mm) const { return (position_mm - lower_) * spans_per_mm_; }
  template <typename Weight>
  std::vector<double> integrals(Weight weight) const;

  CurveKind kind_ = CurveKind::spline;
  double lower_ = 0.0;
  double upper_ = 1.0;
  double spans_per_mm_ = 1.0;
  std::size_t size_ = 1;
  std::size_t functions_ = 4;
};

}  // namespace axiometry::volumetric
