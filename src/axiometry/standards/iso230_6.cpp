// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_6.h"

#include <cmath>

namespace axiometry::iso230_6 {
namespace {

/// Which way each axis moves along a diagonal: −1, 0 (it stands in the middle) or 1.
using Signs = std::array<int, 3>;

char letter(int sign) { return sign > 0 ? 'P' : sign < 0 ? 'N' : '0'; }

Diagonal diagonal(const TravelBox& box, const Signs& signs) {
  Diagonal result;
  std::string begin;
  std::string end;
  for (std::size_t k = 0; k < 3; ++k) {
    const double low = box.lowest_mm[k];
    const double high = box.highest_mm[k];
    const double middle = low + (high - low) / 2.0;
    result.begin_mm[k] = signs[k] > 0 ? low : signs[k] < 0 ? high : middle;
    result.end_mm[k] = signs[k] > 0 ? high : signs[k] < 0 ? low : middle;
    begin += letter(-signs[k]);
    end += letter(signs[k]);
  }
  result.id = begin + "-" + end;
  return result;
}

template <std::size_t n>
std::vector<Diagonal> diagonals(const TravelBox& box, const std::array<Signs, n>& all) {
  std::vector<Diagonal> result;
  for (const Signs& signs : all) result.push_back(diagonal(box, signs));
  return result;
}

/// The larger one; the first of several that are alike.
void take_larger(std::optional<DiagonalSummary::Largest>& largest, const std::string& id,
                 const std::optional<Deviation>& value) {
  if (value && (!largest || *value > largest->value)) largest = DiagonalSummary::Largest{id, *value};
}

}  // namespace

std::vector<Diagonal> body_diagonals(const TravelBox& box) {
  return diagonals(box, std::array<Signs, 4>{{{1, 1, 1}, {1, 1, -1}, {1, -1, 1}, {1, -1, -1}}});
}

std::vector<Diagonal> face_diagonals(const TravelBox& box) {
  return diagonals(box, std::array<Signs, 6>{{{1, 1, 0}, {1, -1, 0}, {1, 0, 1}, {1, 0, -1}, {0, 1, 1}, {0, 1, -1}}});
}

DiagonalSummary summarise(std::span<const NamedEvaluation> diagonals) {
  DiagonalSummary summary;
  for (const NamedEvaluation& diagonal : diagonals) {
    const iso230_2::AxisParameters& parameters = diagonal.evaluation.parameters;
    take_larger(summary.E, diagonal.id, parameters.E);
    take_larger(summary.R, diagonal.id, parameters.R);
    take_larger(summary.B, diagonal.id, parameters.B);
  }
  return summary;
}

}  // namespace axiometry::iso230_6
