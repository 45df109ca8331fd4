// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/volumetric/curves/curve_basis.h"
#include "axiometry/volumetric/singles/single_errors.h"

/// What a model of single measurements is a sum of: readings beside the nodes of its curves, however many there are,
/// all of a straightness line longer than its curve, and squareness; behind these the halves of reversal at the
/// readings, a slope of each error of which nothing but its uncertainty is known, and the directions in which axes came
/// to rest of which nothing is known: +1 or −1, so 0 with u = 1.
namespace axiometry::volumetric {

class SingleInputs {
 public:
  /// Of the curves of each axis; `errors` must outlive it.
  SingleInputs(const SingleErrors& errors, std::vector<CurveBasis> bases);

  std::size_t count() const { return count_; }
  double node_mm(std::size_t axis, std::size_t node) const;

  /// Whether an error was read beyond the range that all of its axis have in common.
  bool is_longer(const SingleMotion& m) const;

  /// A column of what is summed up; of an item of SingleErrors.
  Eigen::Index reading(std::size_t motion, std::size_t position) const;
  Eigen::Index square(std::size_t squareness) const { return static_cast<Eigen::Index>(first_square_ + squareness); }

  /// The direction in which `stood` had come to rest while `moved` was measured.
  Eigen::Index approach(std::size_t moved, std::size_t stood) const {
    return static_cast<Eigen::Index>(first_approach_ + moved * axis_count + stood);
  }

  /// What was read of an error at each node, as sums of inputs: means, or halves of reversal (contract: there are).
  Eigen::MatrixXd means_at_nodes(std::size_t motion) const;
  Eigen::MatrixXd halves_at_nodes(std::size_t motion) const;

  /// The inputs, and the covariance of sums of them: a mean and a half of one position belong together.
  Eigen::VectorXd values() const;
  Eigen::MatrixXd covariance(const Eigen::MatrixXd& sums) const;

  /// Between which readings a node lies: (1 − share) of `above` − 1 and share of `above`.
  struct NodeShare {
    std::size_t above = 1;
    double share = 0.0;
    double between(const std::vector<double>& numbers) const {
      return (1.0 - share) * numbers[above - 1] + share * numbers[above];
    }
  };
  NodeShare share_of(const SingleMotion& m, std::size_t node) const;

 private:
  Eigen::MatrixXd at_nodes(std::size_t motion, std::size_t behind) const;
  Eigen::Index slope(std::size_t motion) const { return static_cast<Eigen::Index>(first_slope_ + motion); }

  const SingleErrors& errors_;
  std::vector<CurveBasis> bases_;
  std::vector<std::vector<std::size_t>> used_;   ///< readings that are inputs, of each motion
  std::vector<std::size_t> first_, first_half_;  ///< number of the first one of each motion
  std::size_t first_square_ = 0, first_slope_ = 0, first_approach_ = 0, count_ = 0;
};

}  // namespace axiometry::volumetric
