// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/findings/mixed_days.h"

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/volumetric/identify/findings/tried_fit.h"
#include "axiometry/volumetric/identify/strain_system.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t part_readings_least = 10;  // readings; the place and the dead path of the part take four unknowns
constexpr double days_chance_most = 1e-4;        // low, since every set of lengths is searched unasked
constexpr int kinds = strain_count;

/// Readings of one station, tool and segment, earlier or later ones; where breaks of the beam were found does not
/// matter.
struct SegmentPart {
  std::vector<std::size_t> readings;
  double sign = 1.0;
};

/// Where those begin that were taken after others had been in between, if that is so once; else the middle.
std::size_t parted_at(std::span<const std::size_t> readings, std::span<const std::size_t> segment_of) {
  std::size_t gaps = 0, at = readings.size() / 2;
  for (std::size_t k = 1; k < readings.size() && gaps < 2; ++k) {
    const auto between = segment_of.subspan(readings[k - 1] + 1, readings[k] - readings[k - 1] - 1);
    if (std::ranges::all_of(between, [&](std::size_t s) { return s == segment_of[readings[k]]; })) continue;
    ++gaps;
    at = k;
  }
  return gaps == 1 ? at : readings.size() / 2;
}

std::vector<SegmentPart> parts_of(const Problem& problem, std::span<const std::size_t> kept) {
  const std::vector<BeamStretch>& stretches = problem.unknowns.stretches;
  std::vector<std::size_t> segment_of_stretch;  // first stretch of the same segment
  for (std::size_t j = 0; j < stretches.size(); ++j) {
    const auto is_same = [&](const BeamStretch& other) {
      return other.virtual_station == stretches[j].virtual_station && other.segment == stretches[j].segment;
    };
    segment_of_stretch.push_back(
        static_cast<std::size_t>(std::ranges::find_if(stretches, is_same) - stretches.begin()));
  }
  std::vector<std::size_t> segment_of;
  for (const std::size_t stretch : problem.unknowns.stretch_of) segment_of.push_back(segment_of_stretch[stretch]);
  std::vector<std::vector<std::size_t>> readings(stretches.size());
  for (const std::size_t i : kept)
    if (problem.weights[i] > 0.0) readings[segment_of[i]].push_back(i);
  std::vector<SegmentPart> parts;
  for (const auto& all : readings) {
    const std::size_t at = parted_at(all, segment_of);
    if (at < part_readings_least || all.size() - at < part_readings_least) continue;
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(at);
    parts.push_back({{all.begin(), middle}, -0.5});
    parts.push_back({{middle, all.end()}, 0.5});
  }
  return parts;
}

/// Sums over the parts, of strains of which nothing is left that a place or a dead path of a part could do.
struct StrainSums {
  Eigen::Matrix<double, kinds, kinds> matrix = decltype(matrix)::Zero();
  Strains right = Strains::Zero();
  double of_places = 0.0;  ///< fall of χ² by places and dead paths of the parts alone
};

void add_part(const Problem& problem, const Fit& fit, const SegmentPart& part, Vector3 middle_mm, StrainSums& sums) {
  Eigen::Matrix4d places = Eigen::Matrix4d::Zero();
  // Of the strains, then of the residuals.
  Eigen::MatrixXd rights = Eigen::MatrixXd::Zero(4, kinds + 1);
  for (const std::size_t i : part.readings) {
    const Vector3 u = fit.beams[i];
    const Eigen::Vector4d place(u.x, u.y, u.z, 1.0);  // three coordinates of the station and its dead path
    const double w = problem.weights[i];
    const Strains strain = part.sign * strained_um(u, 1e-3 * (problem.readings[i].axes_mm - middle_mm));
    places += w * place * place.transpose();
    rights.leftCols<kinds>() += w * place * strain.transpose();
    rights.col(kinds) += w * fit.residuals_um[i] * place;
    sums.matrix += w * strain * strain.transpose();
    sums.right += w * fit.residuals_um[i] * strain;
  }
  // Where readings do not tell all of a place, neither sum holds anything of what they do not tell.
  const Eigen::LDLT<Eigen::MatrixXd> solved(places);
  const Eigen::MatrixXd held = rights.transpose() * Eigen::MatrixXd(solved.solve(rights));
  sums.matrix -= held.topLeftCorner<kinds, kinds>();
  sums.right -= held.col(kinds).head<kinds>();
  sums.of_places += std::max(0.0, held(kinds, kinds));
}

}  // namespace

/// gᵀ S⁻¹ g of sums over the parts alone is no more than χ² falls by: what curves hold of the strains makes S less.
void add_mixed_days(const Identifier& done, std::vector<VolumetricFinding>& findings) {
  if (is_stated_wrongly(findings)) return;
  const Problem problem = done.problem();
  const std::vector<std::size_t> kept = readings_to_try(done);
  const std::vector<SegmentPart> parts = parts_of(problem, kept);
  if (parts.empty()) return;
  const Vector3 middle_mm = done.middle_mm();
  StrainSums sums;
  for (const SegmentPart& part : parts) add_part(problem, done.fit(), part, middle_mm, sums);
  const double largest = sums.matrix.diagonal().maxCoeff();
  if (!(largest > 0.0)) return;
  constexpr double none_of_largest = 1e-12;  // below this share an axis stood still and only rounding is left
  const Strains scale = sums.matrix.diagonal().unaryExpr(
      [&](double squares) { return squares > none_of_largest * largest ? 1.0 / std::sqrt(squares) : 0.0; });
  const Eigen::MatrixXd scaled = scale.asDiagonal() * sums.matrix * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(scaled);
  constexpr double told_least = 1e-3;  // smallest eigenvalue of the scaled matrix that counts as told
  const Eigen::VectorXd right = scale.cwiseProduct(sums.right);
  const Eigen::VectorXd along = solved.eigenvectors().transpose() * right;
  Gained gained;
  for (Eigen::Index k = 0; k < along.size(); ++k) {
    if (solved.eigenvalues()[k] < told_least) continue;
    gained.chi_squared += along[k] * along[k] / solved.eigenvalues()[k];
    gained.unknowns += 1.0;
  }
  // Half of the places are those of the stretches, which are fitted already.
  const FitQuality own = seen_quality(done, kept);
  const FitQuality larger{own.chi_squared - sums.of_places - gained.chi_squared,
                          own.degrees_of_freedom - 2.0 * static_cast<double>(parts.size()) - gained.unknowns};
  if (chance_of(gained, larger) > days_chance_most) return;
  findings.push_back(
      {"volumetric-axes-changed", false,
       "the axes seem longer, shorter or less square in later lengths of the same station and tool than in earlier "
       "ones, of one such pair or of several: the machine or the air became warmer or colder, lengths of two days are "
       "mixed, or both directions differ and all was measured forth and then back"});
}

}  // namespace axiometry::volumetric::detail
