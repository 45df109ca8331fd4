// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "axiometry/volumetric/identify/equations/normal_equations.h"

/// Some readings in place of very many. Internal to identify().
namespace axiometry::volumetric::detail {

/// Some of the readings as a problem of their own, with the same unknowns. The whole one must outlive it.
class ThinnedProblem {
 public:
  ThinnedProblem(const Problem& whole, std::span<const std::size_t> kept);
  ThinnedProblem(const ThinnedProblem&) = delete;
  ThinnedProblem& operator=(const ThinnedProblem&) = delete;

  Problem problem() const;

 private:
  const Problem whole_;
  Unknowns unknowns_;
  std::vector<VolumetricReading> readings_;
  std::vector<Approaches> approaches_;
  std::vector<double> weights_;
};

/// About `wanted` readings, rising: of each stretch the same share, and not less than a few. They are taken in steps
/// that no grid of points shares.
std::vector<std::size_t> some_of_each_stretch(const Unknowns& unknowns, std::size_t wanted);

}  // namespace axiometry::volumetric::detail
