// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/range_covariance.h"

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/tracking/ranges/range_eigen.h"

namespace axiometry::tracking::detail {
namespace {

using Dense = Eigen::MatrixXd;
using PointGauge = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 7>;
using GaugeSquare = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 7, 7>;

/// What a translation, a turn and a change of size about `centre` do to something at `at`.
PointGauge gauge_at(Vector3 at, Vector3 centre, double length_mm, bool with_size) {
  PointGauge g(3, with_size ? 7 : 6);
  const Vector3 off = 1.0 / length_mm * (at - centre);
  g.leftCols<3>().setIdentity();
  for (std::size_t k = 0; k < 3; ++k) {
    Vector3 axis{};
    axis[k] = 1.0;
    g.col(static_cast<Eigen::Index>(3 + k)) = eigen(cross(axis, off));
  }
  if (with_size) g.col(6) = eigen(off);
  return g;
}

/// One point linearised: V⁻¹ and Y = V⁻¹W in compact columns.
struct PointBlocks {
  ColumnPattern pattern;
  Dense y;
  Eigen::Matrix3d inverse;
  std::vector<RangeRow> rows;

  /// Whether the pattern is another one than before.
  bool take(const RangeLayout& layout, const RangeState& state, const RangeWeighting& weighting, std::size_t i) {
    const std::size_t begin = layout.first[i], end = layout.first[i + 1];
    const bool changed = !pattern.fits(layout, begin, end);
    if (changed) {
      pattern.take(layout, begin, end);
      y.resize(3, static_cast<Eigen::Index>(pattern.size()));
    }
    rows.clear();
    y.setZero();
    PointFactor v;
    for (std::size_t t = begin; t < end; ++t) {
      const RangeRow row = rows.emplace_back(range_row(layout, state, weighting, state.points[i], t));
      v.add(row.weight, row.along);
      const Eigen::Vector3d a = row.weight * eigen(row.along);
      const auto s = static_cast<Eigen::Index>(pattern.station_at(t - begin));
      for (Eigen::Index c = 0; c < 3; ++c) y.col(s + c) -= row.along[static_cast<std::size_t>(c)] * a;
      if (layout.free_scales) y.col(s + 3) += row.by_scale * a;
      y.col(static_cast<Eigen::Index>(pattern.segment_at(t - begin))) -= a;
    }
    v.factor(0.0);
    for (std::size_t k = 0; k < 3; ++k) {
      Vector3 axis{};
      axis[k] = 1.0;
      inverse.col(static_cast<Eigen::Index>(k)) = eigen(v.solve(axis));
    }
    y.applyOnTheLeft(inverse);
    return changed;
  }
};

/// Sums over the points that bring a covariance from one gauge into that of the inner constraints.
struct GaugeSums {
  Dense t;             // Σ YᵀG
  GaugeSquare points;  // Σ GᵀV⁻¹G
  GaugeSquare gram;    // Σ GᵀG
};

class Covariances {
 public:
  explicit Covariances(const RangeCovarianceInput& input)
      : in_(input),
        g_(input.with_size ? 7 : 6),
        reduced_(Eigen::Map<const Dense>(input.reduced.data(), size(), size())) {
    for (const Vector3& p : in_.state.points) centre_ += 1.0 / static_cast<double>(in_.layout.points) * p;
    sum_gauge();
  }

  RangeCovariances all() {
    RangeCovariances result;
    result.residuals.resize(in_.layout.readings());
    if (in_.per_point) {
      result.points.resize(in_.layout.points);
      result.normalised.resize(in_.layout.readings());
    }
    for_chunks(in_.chunks, [&](std::size_t, std::size_t begin, std::size_t end) { points(result, begin, end); });
    stations(result);
    return result;
  }

 private:
  Eigen::Index size() const { return static_cast<Eigen::Index>(in_.layout.columns()); }
  PointGauge gauge(Vector3 at) const { return gauge_at(at, centre_, in_.weighting.scale_length_mm, in_.with_size); }

  void sum_gauge() {
    std::vector<GaugeSums> parts(in_.chunks.count,
                                 {Dense::Zero(size(), g_), GaugeSquare::Zero(g_, g_), GaugeSquare::Zero(g_, g_)});
    for_chunks(in_.chunks, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
      GaugeSums& sums = parts[chunk];
      PointBlocks blocks;
      for (std::size_t i = begin; i < end; ++i) {
        blocks.take(in_.layout, in_.state, in_.weighting, i);
        const PointGauge g = gauge(in_.state.points[i]);
        const auto columns = blocks.pattern.columns();
        for (std::size_t c = 0; c < columns.size(); ++c)
          sums.t.row(static_cast<Eigen::Index>(columns[c])) +=
              blocks.y.col(static_cast<Eigen::Index>(c)).transpose() * g;
        sums.points += g.transpose() * blocks.inverse * g;
        sums.gram += g.transpose() * g;
      }
    });
    GaugeSums sum = std::move(parts.front());
    for (std::size_t k = 1; k < parts.size(); ++k) {
      sum.t += parts[k].t;
      sum.points += parts[k].points;
      sum.gram += parts[k].gram;
    }
    ct_ = reduced_ * sum.t;
    m_ = numeric::inverse(sum.gram);
    mqm_ = m_ * (sum.points + GaugeSquare(sum.t.transpose() * ct_)) * m_;
  }

  void points(RangeCovariances& result, std::size_t begin, std::size_t end) const {
    PointBlocks blocks;
    Dense reduced, ct, z;
    for (std::size_t i = begin; i < end; ++i) {
      const bool changed = blocks.take(in_.layout, in_.state, in_.weighting, i);
      for (std::size_t k = 0; k < blocks.rows.size(); ++k)
        result.residuals[in_.layout.reading[in_.layout.first[i] + k]] = blocks.rows[k].residual;
      if (!in_.per_point) continue;
      if (changed) {
        const auto columns = blocks.pattern.columns();
        reduced = reduced_(columns, columns);
        ct = ct_(columns, Eigen::all);
      }
      z.noalias() = reduced * blocks.y.transpose();
      const Eigen::Matrix3d seen = blocks.y * z;
      const PointGauge g = gauge(in_.state.points[i]);
      const PointGauge k = blocks.inverse * g + blocks.y * ct;
      const Eigen::Matrix3d mixed = g * m_ * k.transpose();
      const Eigen::Matrix3d c = blocks.inverse + seen - mixed - mixed.transpose() + g * mqm_ * g.transpose();
      store(result.points[i], c);
      residuals(result, blocks, reduced, z, blocks.inverse + seen, in_.layout.first[i]);
    }
  }

  /// w over σ√r, r the redundancy number: 1 less the share of the reading's variance that the fit explains.
  void residuals(RangeCovariances& result, const PointBlocks& blocks, const Dense& reduced, const Dense& z,
                 const Eigen::Matrix3d& point, std::size_t first) const {
    for (std::size_t k = 0; k < blocks.rows.size(); ++k) {
      const RangeRow& row = blocks.rows[k];
      const auto s = static_cast<Eigen::Index>(blocks.pattern.station_at(k));
      const auto d = static_cast<Eigen::Index>(blocks.pattern.segment_at(k));
      const Eigen::Index at[] = {s, s + 1, s + 2, d, s + 3};
      const double by[] = {-row.along.x, -row.along.y, -row.along.z, -1.0, row.by_scale};
      const std::size_t entries = in_.layout.free_scales ? 5 : 4;
      const Eigen::Vector3d a = eigen(row.along);
      double variance = a.dot(point * a);
      for (std::size_t x = 0; x < entries; ++x) {
        variance -= 2.0 * by[x] * z.row(at[x]).dot(a);
        for (std::size_t y = 0; y < entries; ++y) variance += by[x] * by[y] * reduced(at[x], at[y]);
      }
      const double redundancy = 1.0 - row.weight * variance;
      result.normalised[in_.layout.reading[first + k]] =
          redundancy > 1e-6 ? row.residual * std::sqrt(row.weight / redundancy) : 0.0;
    }
  }

  void stations(RangeCovariances& result) const {
    const RangeLayout& layout = in_.layout;
    const double length = in_.weighting.scale_length_mm;
    for (std::size_t j = 0; j < layout.stations; ++j) {
      const auto at = static_cast<Eigen::Index>(layout.station_column(j));
      const PointGauge g = gauge(in_.state.stations[j]);
      const Eigen::Matrix3d mixed = g * m_ * ct_.middleRows(at, 3).transpose();
      store(result.stations.emplace_back(),
            reduced_.block<3, 3>(at, at) + mixed + mixed.transpose() + g * mqm_ * g.transpose());
      double variance = 0.0;  // variance of κ times the length
      if (layout.free_scales) variance = reduced_(at + 3, at + 3);
      if (in_.with_size) {
        const double kappa = -in_.state.scales[j];
        if (layout.free_scales) variance += 2.0 * kappa * m_.row(6).dot(ct_.row(at + 3));
        variance += kappa * kappa * mqm_(6, 6);
      }
      result.scale_sigmas.push_back(std::sqrt(std::max(variance, 0.0)) / length);
    }
    for (std::size_t k = 0; k < layout.owner.size(); ++k) {
      const auto at = static_cast<Eigen::Index>(layout.segment_column(k));
      result.dead_sigmas.push_back(std::sqrt(std::max(reduced_(at, at), 0.0)));
    }
  }

  static void store(Matrix3& to, const Eigen::Matrix3d& from) {
    for (std::size_t a = 0; a < 3; ++a)
      for (std::size_t b = 0; b < 3; ++b)
        to[a][b] = 0.5 * (from(static_cast<Eigen::Index>(a), static_cast<Eigen::Index>(b)) +
                          from(static_cast<Eigen::Index>(b), static_cast<Eigen::Index>(a)));
  }

  const RangeCovarianceInput& in_;
  Eigen::Index g_;
  Dense reduced_;
  Vector3 centre_{};
  Dense ct_;  // C T
  GaugeSquare m_;
  GaugeSquare mqm_;
};

}  // namespace

RangeCovariances range_covariances(const RangeCovarianceInput& input) { return Covariances(input).all(); }

}  // namespace axiometry::tracking::detail
