// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/curves/beam_row.h"

namespace axiometry::volumetric {

BeamRow::BeamRow(const Coefficients& coefficients, const MachineModel& machine, Vector3 axes_mm, Vector3 tool_mm,
                 Approaches approaches)
    : axes_m_(1e-3 * axes_mm) {
  const std::array<Vector3, 3> levers = machine.levers_mm(axes_mm, tool_mm);
  for (std::size_t a = 0; a < axis_count; ++a) {
    Source& source = sources_[source_count_++];
    coefficients.basis(a).set_at(axes_mm[a], source.active);
    source.lever_m = 1e-3 * levers[a];
    add_piece(coefficients.curve(a) + source.active.first * motion_count, source.active.count * motion_count);
  }
  for (std::size_t a = 0; a < axis_count; ++a) {
    if (coefficients.reversal() == Reversal::none || approaches[a] == 0.0) continue;
    Source& source = sources_[source_count_++];
    source = sources_[a];
    if (coefficients.reversal() == Reversal::constant) {
      source.active.first = 0;
      source.active.count = 1;
      source.active.values[0] = 1.0;
    }
    for (std::size_t k = 0; k < source.active.count; ++k) source.active.values[k] *= approaches[a];
    add_piece(coefficients.half(a) + source.active.first * motion_count, source.active.count * motion_count);
  }
  add_piece(coefficients.squareness(), 3);
}

void BeamRow::add_piece(std::size_t first, std::size_t count) {
  pieces_[piece_count_++] = {first, count, values_.data() + value_count_};
  value_count_ += count;
}

std::array<double, motion_count> BeamRow::plucker(Vector3 u, Vector3 lever_m) {
  const Vector3 turn = cross(lever_m, u);
  return {u.x, u.y, u.z, turn.x, turn.y, turn.z};
}

Vector3 BeamRow::displacement_um(std::span<const double> raw) const {
  const double* square = raw.data() + pieces_[source_count_].first;
  Vector3 sum{-square[0] * axes_m_.y + square[1] * axes_m_.z, -square[2] * axes_m_.z, 0.0};
  for (std::size_t s = 0; s < source_count_; ++s) {
    const ActiveFunctions& active = sources_[s].active;
    const double* from = raw.data() + pieces_[s].first;
    std::array<double, motion_count> e{};
    for (std::size_t k = 0; k < active.count; ++k, from += motion_count) {
      const double value = active.values[k];
      for (std::size_t m = 0; m < motion_count; ++m) e[m] += value * from[m];
    }
    sum += Vector3{e[0], e[1], e[2]} + cross({e[3], e[4], e[5]}, sources_[s].lever_m);
  }
  return sum;
}

void BeamRow::add_times(Vector3 u, double factor, std::span<double> sum) const {
  for (std::size_t s = 0; s < source_count_; ++s) {
    const ActiveFunctions& active = sources_[s].active;
    std::array<double, motion_count> p = plucker(u, sources_[s].lever_m);
    for (double& x : p) x *= factor;
    double* to = sum.data() + pieces_[s].first;
    for (std::size_t k = 0; k < active.count; ++k, to += motion_count) {
      const double value = active.values[k];
      for (std::size_t m = 0; m < motion_count; ++m) to[m] += value * p[m];
    }
  }
  const std::array<double, 3> square = squareness(u);
  double* to = sum.data() + pieces_[source_count_].first;
  for (std::size_t k = 0; k < square.size(); ++k) to[k] += factor * square[k];
}

void BeamRow::write(Vector3 u, double factor, double* to) const {
  for (std::size_t s = 0; s < source_count_; ++s) {
    const ActiveFunctions& active = sources_[s].active;
    std::array<double, motion_count> p = plucker(u, sources_[s].lever_m);
    for (double& x : p) x *= factor;
    for (std::size_t k = 0; k < active.count; ++k, to += motion_count) {
      const double value = active.values[k];
      for (std::size_t m = 0; m < motion_count; ++m) to[m] = value * p[m];
    }
  }
  for (const double entry : squareness(u)) *to++ = factor * entry;
}

double BeamRow::times(std::span<const double> raw) const {
  double sum = 0.0;
  for (const Piece& piece : pieces())
    for (std::size_t k = 0; k < piece.count; ++k) sum += piece.values[k] * raw[piece.first + k];
  return sum;
}

double BeamRow::squares() const {
  double sum = 0.0;
  for (const Piece& piece : pieces())
    for (std::size_t k = 0; k < piece.count; ++k) sum += piece.values[k] * piece.values[k];
  return sum;
}

double quadratic(const BeamRow& a, std::span<const double> matrix, std::size_t width, const BeamRow& b) {
  double sum = 0.0;
  for (const BeamRow::Piece& rows : a.pieces())
    for (std::size_t i = 0; i < rows.count; ++i) {
      const double* row = matrix.data() + (rows.first + i) * width;
      double inner = 0.0;
      for (const BeamRow::Piece& columns : b.pieces())
        for (std::size_t k = 0; k < columns.count; ++k) inner += row[columns.first + k] * columns.values[k];
      sum += rows.values[i] * inner;
    }
  return sum;
}

}  // namespace axiometry::volumetric
