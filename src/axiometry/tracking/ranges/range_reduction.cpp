// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/ranges/range_reduction.h"

namespace axiometry::tracking::detail {
namespace {

/// What one chunk of points sums up.
struct Sums {
  ReducedSystem system;
  ColumnPattern pattern;
  std::vector<double> compact;           // normal matrix of the pattern: upper triangle by rows
  std::vector<double> compact_gradient;  // gradient of the pattern
  std::vector<double> compact_diagonal;
  std::vector<double> w;  // three rows of W, then of L⁻¹W

  explicit Sums(std::size_t size) {
    system.size = size;
    system.matrix.assign(size * size, 0.0);
    system.gradient.assign(size, 0.0);
    system.diagonal.assign(size, 0.0);
  }

  void flush() {
    const auto columns = pattern.columns();
    const std::size_t c = columns.size();
    for (std::size_t a = 0; a < c; ++a) {
      system.gradient[columns[a]] += compact_gradient[a];
      system.diagonal[columns[a]] += compact_diagonal[a];
      for (std::size_t b = a; b < c; ++b) {
        const std::size_t row = std::min(columns[a], columns[b]), column = std::max(columns[a], columns[b]);
        system.matrix[row * system.size + column] += compact[a * c + b];
      }
    }
  }
  void take_pattern(const RangeLayout& layout, std::size_t begin, std::size_t end) {
    if (pattern.fits(layout, begin, end)) return;
    flush();
    pattern.take(layout, begin, end);
    compact.assign(pattern.size() * pattern.size(), 0.0);
    compact_gradient.assign(pattern.size(), 0.0);
    compact_diagonal.assign(pattern.size(), 0.0);
    w.resize(3 * pattern.size());
  }
};

/// δp = −V⁻¹ Σ weight · along (w + a_y δy).
Vector3 point_move(const ReductionInput& input, const ReducedStep& step, std::size_t i) {
  const RangeLayout& layout = input.layout;
  PointFactor v;
  Vector3 right{};
  for (std::size_t t = layout.first[i]; t < layout.first[i + 1]; ++t) {
    const RangeRow row = range_row(layout, step.from, input.weighting, step.from.points[i], t);
    const double* s = step.y.data() + layout.station_column(layout.station[t]);
    double q = row.residual - row.along.x * s[0] - row.along.y * s[1] - row.along.z * s[2] -
               step.y[layout.segment_column(layout.segment[t])];
    if (layout.free_scales) q += row.by_scale * s[3];
    v.add(row.weight, row.along);
    right += row.weight * q * row.along;
  }
  v.factor(step.damping);
  return -v.solve(right);
}

void add_reading(Sums& sums, const RangeLayout& layout, const RangeRow& row, std::size_t k) {
  const std::size_t c = sums.pattern.size();
  const std::size_t at[] = {sums.pattern.station_at(k), sums.pattern.station_at(k) + 1, sums.pattern.station_at(k) + 2,
                            sums.pattern.segment_at(k), sums.pattern.station_at(k) + 3};
  const double by[] = {-row.along.x, -row.along.y, -row.along.z, -1.0, row.by_scale};
  const std::size_t entries = layout.free_scales ? 5 : 4;
  for (std::size_t a = 0; a < entries; ++a) {
    const double wa = row.weight * by[a];
    sums.compact_gradient[at[a]] += wa * row.residual;
    sums.compact_diagonal[at[a]] += wa * by[a];
    sums.w[at[a]] += wa * row.along.x;
    sums.w[c + at[a]] += wa * row.along.y;
    sums.w[2 * c + at[a]] += wa * row.along.z;
    for (std::size_t b = 0; b < entries; ++b)
      if (at[b] >= at[a]) sums.compact[at[a] * c + at[b]] += wa * by[b];
  }
}

/// Subtracts WᵀV⁻¹W and WᵀV⁻¹g of one point.
void eliminate(Sums& sums, const PointFactor& v, Vector3 gradient) {
  const std::size_t c = sums.pattern.size();
  double* b0 = sums.w.data();
  double* b1 = b0 + c;
  double* b2 = b1 + c;
  for (std::size_t a = 0; a < c; ++a) {
    b0[a] /= v.xx;
    b1[a] = (b1[a] - v.yx * b0[a]) / v.yy;
    b2[a] = (b2[a] - v.zx * b0[a] - v.zy * b1[a]) / v.zz;
  }
  const Vector3 h = v.forward(gradient);
  for (std::size_t a = 0; a < c; ++a) {
    const double x0 = b0[a], x1 = b1[a], x2 = b2[a];
    sums.compact_gradient[a] -= x0 * h.x + x1 * h.y + x2 * h.z;
    double* row = sums.compact.data() + a * c;
    for (std::size_t b = a; b < c; ++b) row[b] -= x0 * b0[b] + x1 * b1[b] + x2 * b2[b];
  }
}

void take_point(Sums& sums, const ReductionInput& input, const RangeState& state, std::size_t i, double damping) {
  const RangeLayout& layout = input.layout;
  const std::size_t begin = layout.first[i], end = layout.first[i + 1];
  sums.take_pattern(layout, begin, end);
  std::ranges::fill(sums.w, 0.0);
  PointFactor v;
  Vector3 gradient{};
  for (std::size_t t = begin; t < end; ++t) {
    const RangeRow row = range_row(layout, state, input.weighting, state.points[i], t);
    sums.system.chi_squared += row.weight * row.residual * row.residual;
    v.add(row.weight, row.along);
    gradient += row.weight * row.residual * row.along;
    add_reading(sums, layout, row, t - begin);
  }
  v.factor(damping);
  if (v.weak && sums.system.weak_points++ == 0) sums.system.first_weak = i;
  eliminate(sums, v, gradient);
}

void add(ReducedSystem& sum, const ReducedSystem& part) {
  if (sum.weak_points == 0) sum.first_weak = part.first_weak;
  for (std::size_t k = 0; k < sum.matrix.size(); ++k) sum.matrix[k] += part.matrix[k];
  for (std::size_t k = 0; k < sum.size; ++k) {
    sum.gradient[k] += part.gradient[k];
    sum.diagonal[k] += part.diagonal[k];
  }
  sum.chi_squared += part.chi_squared;
  sum.weak_points += part.weak_points;
  sum.largest_move_mm = std::max(sum.largest_move_mm, part.largest_move_mm);
}

void add_priors(ReducedSystem& system, const ReductionInput& input, const RangeState& state) {
  if (!input.layout.free_scales || !(input.scale_prior > 0.0)) return;
  const double weight = 1.0 / (input.scale_prior * input.scale_prior);
  const double d = input.weighting.scale_length_mm;
  for (std::size_t j = 0; j < input.layout.stations; ++j) {
    const std::size_t k = input.layout.station_column(j) + 3;
    const double off = state.scales[j] - 1.0;
    system.chi_squared += weight * off * off;
    system.gradient[k] += weight * off / d;
    system.diagonal[k] += weight / (d * d);
    system.matrix[k * system.size + k] += weight / (d * d);
  }
}

}  // namespace

ReducedSystem reduce(const ReductionInput& input, RangeState& state, const std::optional<ReducedStep>& step,
                     double damping) {
  const std::size_t size = input.layout.columns();
  std::vector<Sums> parts(input.chunks.count, Sums(size));
  for_chunks(input.chunks, [&](std::size_t chunk, std::size_t begin, std::size_t end) {
    Sums& sums = parts[chunk];
    for (std::size_t i = begin; i < end; ++i) {
      if (step) {
        const Vector3 move = point_move(input, *step, i);
        const double length = norm(move);
        if (!(length <= sums.system.largest_move_mm)) sums.system.largest_move_mm = length;  // a NaN is kept
        state.points[i] = step->from.points[i] + move;
      }
      take_point(sums, input, state, i, damping);
    }
    sums.flush();
  });
  ReducedSystem system = std::move(parts.front().system);
  for (std::size_t k = 1; k < parts.size(); ++k) add(system, parts[k].system);
  add_priors(system, input, state);
  system.damping = damping;
  for (std::size_t a = 0; a < size; ++a) {
    system.matrix[a * size + a] += damping * system.diagonal[a];
    for (std::size_t b = 0; b < a; ++b) system.matrix[a * size + b] = system.matrix[b * size + a];
  }
  return system;
}

}  // namespace axiometry::tracking::detail
