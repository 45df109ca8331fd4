// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/strain_system.h"

#include <numeric>

namespace axiometry::volumetric::detail {
namespace {

/// y of each mode.
Eigen::VectorXd row_of(const Problem& problem, const Fit& fit, std::size_t i, std::span<const Strains> modes,
                       Vector3 middle_mm) {
  const Strains strained = strained_um(fit.beams[i], 1e-3 * (problem.readings[i].axes_mm - middle_mm));
  Eigen::VectorXd row(static_cast<Eigen::Index>(modes.size()));
  for (std::size_t m = 0; m < modes.size(); ++m) row[static_cast<Eigen::Index>(m)] = modes[m].dot(strained);
  return row;
}

}  // namespace

StrainSystem strain_system(const Problem& problem, const Fit& fit, std::span<const ReadingGroup> groups,
                           std::span<const Strains> modes, Vector3 middle_mm) {
  const auto kinds = static_cast<Eigen::Index>(modes.size());
  const auto columns = kinds * static_cast<Eigen::Index>(groups.size());
  StrainSystem system{Eigen::MatrixXd::Zero(columns, columns), Eigen::VectorXd::Zero(columns), {}, {}};
  std::vector<std::vector<double>> gradients;
  for (std::size_t g = 0; g < groups.size(); ++g) {
    const Eigen::Index first = kinds * static_cast<Eigen::Index>(g);
    std::vector<std::vector<double>> changes(modes.size(), std::vector<double>(problem.readings.size(), 0.0));
    for (const std::size_t i : groups[g]) {
      const Eigen::VectorXd y = row_of(problem, fit, i, modes, middle_mm);
      system.matrix.block(first, first, kinds, kinds) += problem.weights[i] * y * y.transpose();
      system.right.segment(first, kinds) += problem.weights[i] * fit.residuals_um[i] * y;
      for (std::size_t m = 0; m < modes.size(); ++m) changes[m][i] = y[static_cast<Eigen::Index>(m)];
    }
    for (const auto& change : changes) {
      gradients.push_back(gradient(problem, fit.beams, change));
      system.steps.push_back(fit.solution.step(gradients.back()));
    }
  }
  system.whole = system.matrix.diagonal();
  for (Eigen::Index c = 0; c < columns; ++c)
    for (Eigen::Index d = 0; d < columns; ++d) {
      const auto& g = gradients[static_cast<std::size_t>(c)];
      system.matrix(c, d) -=
          std::inner_product(g.begin(), g.end(), system.steps[static_cast<std::size_t>(d)].begin(), 0.0);
    }
  return system;
}

std::vector<double> strains_in_readings(const Problem& problem, const Fit& fit, std::span<const ReadingGroup> groups,
                                        std::span<const Strains> modes, Vector3 middle_mm,
                                        const Eigen::VectorXd& strains) {
  const auto kinds = static_cast<Eigen::Index>(modes.size());
  std::vector<double> changes(problem.readings.size(), 0.0);
  for (std::size_t g = 0; g < groups.size(); ++g)
    for (const std::size_t i : groups[g])
      changes[i] =
          row_of(problem, fit, i, modes, middle_mm).dot(strains.segment(kinds * static_cast<Eigen::Index>(g), kinds));
  return changes;
}

}  // namespace axiometry::volumetric::detail
