// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "axiometry/base/vector3.h"
#include "axiometry/volumetric/curves/coefficients.h"
#include "axiometry/volumetric/machine/machine_model.h"

/// What the component of the tool point's displacement along a direction u is of the raw coefficients. Of axis a it is
/// the six Plücker coordinates [u; r_a × u] of the beam times the values of the basis, of C0Y −u_x y, of B0Z u_x z, of
/// A0Z −u_y z: µm from µm and µrad, with levers in m. So only what is active at q is not 0.
namespace axiometry::volumetric {

class BeamRow {
 public:
  /// Neighbouring entries of a row that is 0 elsewhere.
  struct Piece {
    std::size_t first = 0;
    std::size_t count = 0;
    const double* values = nullptr;
  };

  BeamRow(const Coefficients& coefficients, const MachineModel& machine, Vector3 axes_mm, Vector3 tool_mm,
          Approaches approaches = {});
  BeamRow(const BeamRow&) = delete;
  BeamRow& operator=(const BeamRow&) = delete;

  /// What raw coefficients make of the tool point, µm.
  Vector3 displacement_um(std::span<const double> raw_coefficients) const;
  /// Adds factor · the row of a direction: of one use less work than along().
  void add_times(Vector3 direction, double factor, std::span<double> sum) const;

  /// Writes factor · the row of a direction: the entries of its pieces, one behind the other.
  void write(Vector3 direction, double factor, double* to) const;

  /// Turns the row into that of another direction of length 1 (at first: of none).
  void along(Vector3 direction) { write(direction, 1.0, values_.data()); }

  /// Of the curves of X, Y, Z, of their reversal where there is one, and last of squareness.
  std::span<const Piece> pieces() const { return {pieces_.data(), piece_count_}; }
  double times(std::span<const double> raw_coefficients) const;
  double squares() const;  ///< Σ a²

 private:
  struct Source {
    ActiveFunctions active;
    Vector3 lever_m;
  };
  void add_piece(std::size_t first, std::size_t count);
  /// Plücker coordinates of a beam through the tool point.
  static std::array<double, motion_count> plucker(Vector3 direction, Vector3 lever_m);
  /// Of C0Y, B0Z and A0Z.
  std::array<double, 3> squareness(Vector3 direction) const {
    return {-direction.x * axes_m_.y, direction.x * axes_m_.z, -direction.y * axes_m_.z};
  }

  std::array<Source, 2 * axis_count> sources_;
  std::size_t source_count_ = 0;
  std::array<Piece, 2 * axis_count + 1> pieces_;  ///< pieces of the sources, then of squareness
  std::size_t piece_count_ = 0;
  Vector3 axes_m_;
  std::size_t value_count_ = 0;
  std::array<double, 2 * axis_count * ActiveFunctions::most * motion_count + 3> values_;
};

/// aᵀ C b, of rows and a symmetric matrix of raw coefficients.
double quadratic(const BeamRow& a, std::span<const double> matrix, std::size_t width, const BeamRow& b);

}  // namespace axiometry::volumetric
