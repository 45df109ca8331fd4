// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/singles/single_inputs.h"

#include <algorithm>
#include <utility>

#include "axiometry/base/contract.h"

namespace axiometry::volumetric {

SingleInputs::SingleInputs(const SingleErrors& errors, std::vector<CurveBasis> bases)
    : errors_(errors), bases_(std::move(bases)) {
  for (const SingleMotion& m : errors_.motions) {
    std::vector<std::size_t>& used = used_.emplace_back();
    const bool all = m.error.is_straightness() && is_longer(m);
    for (std::size_t k = 0; all && k < m.positions_mm.size(); ++k) used.push_back(k);
    for (std::size_t n = 0; !all && n < bases_[m.error.axis].functions(); ++n) {
      const std::size_t above = share_of(m, n).above;
      for (const std::size_t k : {above - 1, above})
        if (used.empty() || used.back() < k) used.push_back(k);
    }
    first_.push_back(first_square_);
    first_square_ += used.size();
  }
  count_ = first_square_ + errors_.squareness.size();
  for (std::size_t k = 0; k < used_.size(); ++k) {
    first_half_.push_back(count_);
    if (errors_.motions[k].reversal) count_ += used_[k].size();
  }
  first_slope_ = count_;
  first_approach_ = count_ += used_.size();
  count_ += axis_count * axis_count;
}

double SingleInputs::node_mm(std::size_t axis, std::size_t node) const {
  const CurveBasis& b = bases_[axis];
  return b.lower_mm() + (b.upper_mm() - b.lower_mm()) * static_cast<double>(node) / static_cast<double>(b.size());
}

bool SingleInputs::is_longer(const SingleMotion& m) const {
  const CurveBasis& basis = bases_[m.error.axis];
  return m.positions_mm.front() < basis.lower_mm() - 1e-6 || m.positions_mm.back() > basis.upper_mm() + 1e-6;
}

SingleInputs::NodeShare SingleInputs::share_of(const SingleMotion& m, std::size_t node) const {
  const double at = node_mm(m.error.axis, node);
  const auto found = std::ranges::lower_bound(m.positions_mm, at - 1e-9);
  const auto k =
      std::clamp<std::size_t>(static_cast<std::size_t>(found - m.positions_mm.begin()), 1, m.positions_mm.size() - 1);
  const double low = m.positions_mm[k - 1], high = m.positions_mm[k];
  return {k, std::clamp((at - low) / (high - low), 0.0, 1.0)};
}

Eigen::Index SingleInputs::reading(std::size_t motion, std::size_t position) const {
  const auto at = std::ranges::lower_bound(used_[motion], position) - used_[motion].begin();
  return static_cast<Eigen::Index>(first_[motion]) + at;
}

Eigen::MatrixXd SingleInputs::at_nodes(std::size_t motion, std::size_t behind) const {
  const SingleMotion& m = errors_.motions[motion];
  const auto nodes = static_cast<Eigen::Index>(bases_[m.error.axis].functions());
  Eigen::MatrixXd curve = Eigen::MatrixXd::Zero(nodes, static_cast<Eigen::Index>(count_));
  for (Eigen::Index n = 0; n < nodes; ++n) {
    const auto [above, share] = share_of(m, static_cast<std::size_t>(n));
    curve(n, reading(motion, above - 1) + static_cast<Eigen::Index>(behind)) += 1.0 - share;
    curve(n, reading(motion, above) + static_cast<Eigen::Index>(behind)) += share;
  }
  return curve;
}

/// The slope turns about the first reading: what it moves all values by is their gauge's.
Eigen::MatrixXd SingleInputs::means_at_nodes(std::size_t motion) const {
  const SingleMotion& m = errors_.motions[motion];
  Eigen::MatrixXd curve = at_nodes(motion, 0);
  for (Eigen::Index n = 0; n < curve.rows(); ++n)
    curve(n, slope(motion)) = node_mm(m.error.axis, static_cast<std::size_t>(n)) - m.positions_mm.front();
  return curve;
}

Eigen::MatrixXd SingleInputs::halves_at_nodes(std::size_t motion) const {
  AXIOMETRY_CONTRACT(errors_.motions[motion].reversal.has_value());
  return at_nodes(motion, first_half_[motion] - first_[motion]);
}

Eigen::VectorXd SingleInputs::values() const {
  Eigen::VectorXd values = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(count_));
  for (std::size_t item = 0; item < used_.size(); ++item) {
    const SingleMotion& m = errors_.motions[item];
    for (std::size_t i = 0; i < used_[item].size(); ++i) {
      values[static_cast<Eigen::Index>(first_[item] + i)] = m.values[used_[item][i]];
      if (m.reversal) values[static_cast<Eigen::Index>(first_half_[item] + i)] = m.reversal->halves[used_[item][i]];
    }
  }
  for (std::size_t k = 0; k < errors_.squareness.size(); ++k) values[square(k)] = errors_.squareness[k].urad;
  return values;
}

Eigen::MatrixXd SingleInputs::covariance(const Eigen::MatrixXd& sums) const {
  Eigen::MatrixXd spread = Eigen::MatrixXd::Zero(sums.rows(), sums.cols());  // the sums times the inputs' covariance
  for (std::size_t item = 0; item < used_.size(); ++item) {
    const SingleMotion& m = errors_.motions[item];
    for (std::size_t i = 0; i < used_[item].size(); ++i) {
      const std::size_t k = used_[item][i];
      const auto mean = static_cast<Eigen::Index>(first_[item] + i);
      spread.col(mean) += m.u[k] * m.u[k] * sums.col(mean);
      if (!m.reversal) continue;
      const auto half = static_cast<Eigen::Index>(first_half_[item] + i);
      spread.col(half) += m.reversal->u[k] * m.reversal->u[k] * sums.col(half);
      spread.col(mean) += m.reversal->covariances[k] * sums.col(half);
      spread.col(half) += m.reversal->covariances[k] * sums.col(mean);
    }
    spread.col(slope(item)) = m.slope_u_per_mm * m.slope_u_per_mm * sums.col(slope(item));
  }
  for (std::size_t k = 0; k < errors_.squareness.size(); ++k) {
    const double u = errors_.squareness[k].u_urad;
    spread.col(square(k)) += u * u * sums.col(square(k));
  }
  const auto unknown = static_cast<Eigen::Index>(axis_count * axis_count);
  spread.rightCols(unknown) = sums.rightCols(unknown);
  return spread * sums.transpose();
}

}  // namespace axiometry::volumetric
