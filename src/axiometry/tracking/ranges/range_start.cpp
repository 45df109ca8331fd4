// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/range_start.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/counted.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/tracking/ranges/range_eigen.h"

namespace axiometry::tracking::detail {
namespace {

constexpr double farthest_radii = 1e3;     // of a start from the points: beyond, beams are parallel to all digits
constexpr std::size_t linear_most = 4000;  // readings that a start is found from
constexpr std::size_t search_most = 400;   // likewise when many starts are tried

/// Some of the readings, spread evenly.
std::vector<std::size_t> sample(std::size_t count, std::size_t most) {
  std::vector<std::size_t> chosen;
  const std::size_t wanted = std::min(count, most);
  for (std::size_t k = 0; k < wanted; ++k) chosen.push_back(k * count / wanted);
  return chosen;
}

struct Cloud {
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();
  double radius = 0.0;  // root mean square distance from the centre
  Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
  double thickness = 0.0;  // extent along the normal divided by the radius
};

Cloud cloud_of(const StationReadings& r, std::span<const std::size_t> chosen) {
  Cloud cloud;
  for (std::size_t k : chosen) cloud.centre += eigen(r.nominal_mm[k]) / static_cast<double>(chosen.size());
  Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();
  for (std::size_t k : chosen) {
    const Eigen::Vector3d off = eigen(r.nominal_mm[k]) - cloud.centre;
    moments += off * off.transpose() / static_cast<double>(chosen.size());
  }
  cloud.radius = std::sqrt(moments.trace());
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  cloud.normal = solver.eigenvectors().col(0);
  for (Eigen::Index k : {2, 1, 0}) {  // upwards
    if (std::abs(cloud.normal[k]) < 1e-6) continue;
    if (cloud.normal[k] < 0.0) cloud.normal = -cloud.normal;
    break;
  }
  cloud.thickness = cloud.radius > 0.0 ? std::sqrt(std::max(solver.eigenvalues()[0], 0.0)) / cloud.radius : 0.0;
  return cloud;
}

/// Eq. 14 with the readings of one segment, centred and scaled.
std::optional<Eigen::Vector3d> linear_start(const StationReadings& r, const Cloud& cloud) {
  std::vector<std::size_t> counts(r.segments, 0);
  for (std::size_t s : r.segment) ++counts[s];
  const auto longest = static_cast<std::size_t>(std::ranges::max_element(counts) - counts.begin());
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < r.segment.size(); ++k)
    if (r.segment[k] == longest) rows.push_back(k);
  if (rows.size() < 5) return std::nullopt;
  double mean = 0.0;
  for (std::size_t k : rows) mean += r.length_mm[k] / static_cast<double>(rows.size());
  const auto some = sample(rows.size(), linear_most);
  Eigen::MatrixXd a(static_cast<Eigen::Index>(some.size()), 5);
  Eigen::VectorXd b(a.rows());
  for (Eigen::Index i = 0; i < a.rows(); ++i) {
    const std::size_t k = rows[some[static_cast<std::size_t>(i)]];
    const Eigen::Vector3d p = (eigen(r.nominal_mm[k]) - cloud.centre) / cloud.radius;
    const double l = (r.length_mm[k] - mean) / cloud.radius;
    a.row(i) << 2.0 * p.transpose(), 2.0 * l, -1.0;
    b[i] = p.squaredNorm() - l * l;
  }
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr;
  qr.setThreshold(1e-7);
  qr.compute(a);
  if (qr.rank() < 5) return std::nullopt;
  const Eigen::VectorXd x = qr.solve(b);
  if (!x.allFinite() || x.head<3>().norm() > farthest_radii) return std::nullopt;
  return cloud.centre + cloud.radius * x.head<3>();
}

/// Gauss–Newton with damping on s; the dead paths are the means of their segments.
struct Refined {
  Eigen::Vector3d station = Eigen::Vector3d::Zero();
  double squares = std::numeric_limits<double>::infinity();
};

class Refinement {
 public:
  Refinement(const StationReadings& r, const Cloud& cloud, std::vector<std::size_t> chosen)
      : r_(r), centre_(cloud.centre), farthest_(farthest_radii * cloud.radius), chosen_(std::move(chosen)) {}

  Refined from(Eigen::Vector3d s) {
    double squares = linearise(s);
    double damping = 1e-6;
    for (int k = 0; k < 60 && std::isfinite(squares); ++k) {
      const Eigen::Matrix3d normal = normal_;
      const Eigen::Vector3d gradient = gradient_;
      Eigen::Matrix3d damped = normal;
      damped.diagonal() += damping * (normal.diagonal().array() + 1e-12 * normal.trace()).matrix();
      const Eigen::Vector3d step = -damped.ldlt().solve(gradient);
      // A place that noise draws away without end is held where its lengths still have digits.
      const bool is_far = !((s + step - centre_).norm() <= farthest_);
      const double tried = is_far ? std::numeric_limits<double>::infinity() : linearise(s + step);
      if (tried <= squares) {
        s += step;
        const bool done = step.norm() < 1e-9 * (1.0 + s.norm()) || squares - tried < 1e-14 * squares;
        squares = tried;
        damping = std::max(0.1 * damping, 1e-12);
        if (done) break;
      } else {
        damping = std::max(10.0 * damping, 1e-6);
        normal_ = normal;
        gradient_ = gradient;
        if (damping > 1e12) break;
      }
    }
    return {s, squares};
  }

 private:
  double linearise(const Eigen::Vector3d& s) {
    const std::size_t n = r_.segments;
    count_.assign(n, 0.0);
    mean_.assign(n, Eigen::Vector4d::Zero());
    rows_.clear();
    for (std::size_t k : chosen_) {
      const Eigen::Vector3d beam = eigen(r_.nominal_mm[k]) - s;
      const double d = beam.norm();
      Eigen::Vector4d& row = rows_.emplace_back();
      row << (d > 0.0 ? Eigen::Vector3d(-beam / d) : Eigen::Vector3d::Zero()), d - r_.length_mm[k];
      count_[r_.segment[k]] += 1.0;
      mean_[r_.segment[k]] += row;
    }
    for (std::size_t j = 0; j < n; ++j)
      if (count_[j] > 0.0) mean_[j] /= count_[j];
    Eigen::Matrix4d sum = Eigen::Matrix4d::Zero();
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Eigen::Vector4d row = rows_[i] - mean_[r_.segment[chosen_[i]]];
      sum += row * row.transpose();
    }
    normal_ = sum.topLeftCorner<3, 3>();
    gradient_ = sum.topRightCorner<3, 1>();
    return sum(3, 3);
  }

  const StationReadings& r_;
  Eigen::Vector3d centre_;
  double farthest_ = 0.0;
  std::vector<std::size_t> chosen_;
  std::vector<double> count_;
  std::vector<Eigen::Vector4d> mean_;
  std::vector<Eigen::Vector4d> rows_;
  Eigen::Matrix3d normal_;
  Eigen::Vector3d gradient_;
};

Refined search(const StationReadings& r, const Cloud& cloud) {
  Refinement refinement(r, cloud, sample(r.length_mm.size(), search_most));
  Refined best;
  for (double radius : {1.0, 2.0, 5.0})
    for (int x = -1; x <= 1; ++x)
      for (int y = -1; y <= 1; ++y)
        for (int z = -1; z <= 1; ++z) {
          if (x == 0 && y == 0 && z == 0) continue;
          const Eigen::Vector3d direction = Eigen::Vector3d(x, y, z).normalized();
          const Refined tried = refinement.from(cloud.centre + radius * cloud.radius * direction);
          if (tried.squares < best.squares) best = tried;
        }
  return best;
}

}  // namespace

Result<StationStart> start_station(const StationReadings& r, const std::string& name) {
  const std::size_t n = r.length_mm.size();
  if (n < 3 + r.segments)
    return fail(fmt::format("found {} of station {} in {}, expected at least {}", counted(n, "reading"), name,
                            counted(r.segments, "segment"), 3 + r.segments));
  const std::vector<std::size_t> chosen = sample(n, linear_most);
  const Cloud cloud = cloud_of(r, n > linear_most && r.segments > 1 ? sample(n, n) : chosen);
  if (!(cloud.radius > 0.0))
    return fail(
        fmt::format("found all {} nominal points of station {} at one place, expected different ones", n, name));

  Refinement refinement(r, cloud, r.segments > 1 ? sample(n, n) : chosen);
  Refined best;
  if (const auto linear = linear_start(r, cloud)) best = refinement.from(*linear);
  const double poor = 1e-3 * cloud.radius;  // machines err less
  const auto rms = [&](const Refined& fit) { return std::sqrt(fit.squares / static_cast<double>(n)); };
  if (!(rms(best) < poor) || best.station.hasNaN()) {
    const Refined found = refinement.from(search(r, cloud).station);
    if (!(best.squares <= found.squares)) best = found;
  }
  if (!std::isfinite(best.squares)) return fail(fmt::format("no place fits the lengths of station {}", name));

  StationStart start;
  // Off the plane of the points its other side fits as well, or nearly.
  const double height = (best.station - cloud.centre).dot(cloud.normal);
  if (cloud.thickness < 1e-3 && std::abs(height) > 1e-6 * cloud.radius) {
    const Refined other = refinement.from(best.station - 2.0 * height * cloud.normal);
    const double least = 1e-6 * cloud.radius;  // difference of residuals that tells the two apart
    const bool ambiguous =
        rms(other) < 2.0 * rms(best) + least && (other.station - best.station).norm() > 1e-3 * cloud.radius;
    if (ambiguous) {
      const bool take_other = height < 0.0;
      start.mirror_mm = vector(take_other ? best.station : other.station);
      if (take_other) best = other;
    }
  }
  start.station_mm = vector(best.station);
  std::vector<double> count(r.segments, 0.0);
  start.dead_mm.assign(r.segments, 0.0);
  for (std::size_t k = 0; k < n; ++k) {
    start.dead_mm[r.segment[k]] += distance(r.nominal_mm[k], start.station_mm) - r.length_mm[k];
    count[r.segment[k]] += 1.0;
  }
  for (std::size_t j = 0; j < r.segments; ++j)
    if (count[j] > 0.0) start.dead_mm[j] /= count[j];
  double squares = 0.0;
  for (std::size_t k = 0; k < n; ++k) {
    const double w = distance(r.nominal_mm[k], start.station_mm) - r.length_mm[k] - start.dead_mm[r.segment[k]];
    squares += w * w;
  }
  start.rms_mm = std::sqrt(squares / static_cast<double>(n));
  return start;
}

}  // namespace axiometry::tracking::detail
