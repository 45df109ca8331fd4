// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/station_refining.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace axiometry::capture {
namespace {

constexpr std::size_t fewest_matches = 8;
constexpr int refining_rounds = 8;
constexpr double length_sigma_mm = 0.1;
constexpr double huber_mm = 0.2;

struct SeenLength {
  Vector3 reflector_mm;
  double length_mm = 0.0;  // grows with the distance
  std::size_t segment = 0;
};

Matrix3 inverse(const Matrix3& m) {
  const auto minor = [&](std::size_t i, std::size_t k) {
    const std::size_t a = (i + 1) % 3, b = (i + 2) % 3, c = (k + 1) % 3, d = (k + 2) % 3;
    return m[a][c] * m[b][d] - m[a][d] * m[b][c];
  };
  const double determinant = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
  Matrix3 result{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) result[i][k] = minor(k, i) / determinant;
  return result;
}

Vector3 product(const Matrix3& m, Vector3 v) {
  Vector3 result;
  for (std::size_t i = 0; i < 3; ++i) result[i] = m[i][0] * v.x + m[i][1] * v.y + m[i][2] * v.z;
  return result;
}

class StationFitting {
 public:
  StationFitting(std::span<const SeenLength> lengths, Vector3 station_mm, double error_mm)
      : lengths_(lengths), before_(station_mm), station_(station_mm), prior_(4.0 / (error_mm * error_mm)) {}

  void run() {
    weights_.assign(lengths_.size(), 1.0);
    for (int round = 0; round < refining_rounds; ++round) step();
  }
  Vector3 station_mm() const { return station_; }
  const Matrix3& covariance_mm2() const { return covariance_; }

 private:
  struct Beam {
    Vector3 direction;
    double rest_mm = 0.0;  // y − |p − s|
  };
  Beam beam(const SeenLength& length) const {
    const Vector3 way = length.reflector_mm - station_;
    const double distance_mm = std::max(norm(way), 1e-3);
    return {1.0 / distance_mm * way, length.length_mm - distance_mm};
  }

  /// Gauss–Newton on the changes of length: the rest of one changes by −(u_k − u_{k−1})·Δ where the station moves by Δ.
  void step() {
    std::vector<double> rests(lengths_.size());
    std::vector<Vector3> turns(lengths_.size());
    Matrix3 normal{};
    Vector3 right = -prior_ * (station_ - before_);
    for (std::size_t i = 0; i < 3; ++i) normal[i][i] = prior_;
    for (std::size_t k = 1; k < lengths_.size(); ++k) {
      if (lengths_[k].segment != lengths_[k - 1].segment) continue;
      const Beam from = beam(lengths_[k - 1]), to = beam(lengths_[k]);
      turns[k] = to.direction - from.direction;
      rests[k] = to.rest_mm - from.rest_mm;
      const double w = weights_[k] / (2.0 * length_sigma_mm * length_sigma_mm);
      right -= w * rests[k] * turns[k];
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) normal[i][j] += w * turns[k][i] * turns[k][j];
    }
    covariance_ = inverse(normal);
    const Vector3 move = product(covariance_, right);
    station_ += move;
    for (std::size_t k = 1; k < lengths_.size(); ++k) {
      const double left = std::abs(rests[k] + dot(turns[k], move));
      weights_[k] = left > huber_mm ? huber_mm / left : 1.0;
    }
  }

  std::span<const SeenLength> lengths_;
  Vector3 before_, station_;
  double prior_;  // 1/mm²
  std::vector<double> weights_;
  Matrix3 covariance_{};
};

}  // namespace

std::vector<ExpectedStop> refined_stops(const StopMatcher& matcher) {
  std::vector<ExpectedStop> stops(matcher.stops().begin(), matcher.stops().end());
  const std::vector<StopMatch> matches = matcher.matches();
  const double error_mm = matcher.options().station_error_mm;
  if (!(error_mm > 0.0)) return stops;
  std::size_t match = 0, segment = 0;
  for (std::size_t first = 0; first < stops.size();) {
    std::size_t end = first;
    while (end < stops.size() && stops[end].station_mm == stops[first].station_mm) ++end;
    std::vector<SeenLength> lengths;
    for (; match < matches.size() && matches[match].stop < end; ++match) {
      segment += matches[match].begins_segment ? 1 : 0;
      const double shown = matcher.standstills()[matches[match].standstill].position.in_native();
      lengths.push_back(
          {stops[matches[match].stop].reflector_mm, matcher.options().reversed ? -shown : shown, segment});
    }
    if (lengths.size() >= fewest_matches) {
      StationFitting fit(lengths, stops[first].station_mm, error_mm);
      fit.run();
      for (std::size_t k = first; k < end; ++k) {
        const double before = stops[k].distance_mm();
        stops[k].station_mm = fit.station_mm();
        stops[k].station_covariance_mm2 = fit.covariance_mm2();
        stops[k].lowest_mm += stops[k].distance_mm() - before;
        stops[k].highest_mm += stops[k].distance_mm() - before;
      }
    }
    first = end;
  }
  return stops;
}

}  // namespace axiometry::capture
