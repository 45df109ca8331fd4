// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/equations/thinned_problem.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axiometry::volumetric::detail {
namespace {

Unknowns of_no_reading(const Unknowns& whole) {
  Unknowns few;
  few.coefficients = whole.coefficients;
  few.stations = whole.stations;
  few.stretches = whole.stretches;
  few.drift = whole.drift;
  few.columns = whole.columns;
  return few;
}

}  // namespace

ThinnedProblem::ThinnedProblem(const Problem& whole, std::span<const std::size_t> kept)
    : whole_(whole), unknowns_(of_no_reading(whole.unknowns)) {
  for (const std::size_t i : kept) {
    readings_.push_back(whole.readings[i]);
    if (!whole.approaches.empty()) approaches_.push_back(whole.approaches[i]);
    weights_.push_back(whole.weights[i]);
    unknowns_.stretch_of.push_back(whole.unknowns.stretch_of[i]);
    unknowns_.along_stretch.push_back(whole.unknowns.along_stretch[i]);
  }
}

Problem ThinnedProblem::problem() const {
  return {whole_.machine, whole_.coefficients, unknowns_, readings_,  whole_.tools_mm, approaches_,
          weights_,       whole_.threads,      nullptr,   whole_.stop};
}

std::vector<std::size_t> some_of_each_stretch(const Unknowns& unknowns, std::size_t wanted) {
  constexpr double few = 50.0;
  const double share = static_cast<double>(wanted) / static_cast<double>(unknowns.stretch_of.size());
  std::vector<double> rates;
  for (const BeamStretch& stretch : unknowns.stretches) {
    const double least = few / std::max(1.0, static_cast<double>(stretch.readings));
    const double rate = std::max(share, least);
    rates.push_back(rate < 1.0 ? 1.0 / (std::floor(1.0 / rate) + 1.0 / std::numbers::phi) : 1.0);
  }
  std::vector<double> next(unknowns.stretches.size(), 0.0);
  std::vector<std::size_t> some;
  for (std::size_t i = 0; i < unknowns.stretch_of.size(); ++i) {
    const std::size_t stretch = unknowns.stretch_of[i];
    const double before = next[stretch];
    next[stretch] += rates[stretch];
    if (before == 0.0 || std::floor(before) != std::floor(next[stretch])) some.push_back(i);
  }
  return some;
}

}  // namespace axiometry::volumetric::detail
