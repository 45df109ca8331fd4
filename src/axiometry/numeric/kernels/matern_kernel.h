// SPDX-License-Identifier: Apache-2.0
#pragma once

// The passes of matern_filter.h for one target; compiled once for each (vector_target.h).
#include "axiometry/numeric/kernels/lanes.h"
#include "axiometry/numeric/kernels/matern_kernel_types.h"

namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET {
namespace {

/// f, f′ and f″ in units of the length over √5.
struct State {
  Doubles x[3];
};

[[gnu::always_inline]] inline State moved(const double* a, const State& s) {
  State to;
  for (size_t i = 0; i < 3; ++i) to.x[i] = a[3 * i] * s.x[0] + a[3 * i + 1] * s.x[1] + a[3 * i + 2] * s.x[2];
  return to;
}

/// The state of one column of data, without and then with what its value here tells.
[[gnu::always_inline]] inline Doubles innovation(State& s, const double* a, Doubles value) {
  s = moved(a, s);
  return value - s.x[0];
}

[[gnu::always_inline]] inline void correct(State& s, const Doubles* gain, Doubles innovation) {
  for (size_t i = 0; i < 3; ++i) s.x[i] += gain[i] * innovation;
}

/// A symmetric matrix: 00, 01, 02, 11, 12, 22.
struct Covariance {
  Doubles p[6];
};

/// A P Aᵀ + λ Q.
[[gnu::always_inline]] inline Covariance predicted(const MaternStep& step, const Covariance& from, Doubles ratio) {
  const double* const a = step.transition;
  Doubles ap[9];
  for (size_t i = 0; i < 3; ++i) {
    const double a0 = a[3 * i], a1 = a[3 * i + 1], a2 = a[3 * i + 2];
    ap[3 * i] = a0 * from.p[0] + a1 * from.p[1] + a2 * from.p[2];
    ap[3 * i + 1] = a0 * from.p[1] + a1 * from.p[3] + a2 * from.p[4];
    ap[3 * i + 2] = a0 * from.p[2] + a1 * from.p[4] + a2 * from.p[5];
  }
  Covariance to;
  size_t k = 0;
  for (size_t i = 0; i < 3; ++i)
    for (size_t j = i; j < 3; ++j, ++k)
      to.p[k] =
          (ap[3 * i] * a[3 * j] + ap[3 * i + 1] * a[3 * j + 1] + ap[3 * i + 2] * a[3 * j + 2]) + ratio * step.noise[k];
  return to;
}

template <bool keeps>
[[gnu::always_inline]] inline void filter_lanes(const MaternCurve& curve, size_t lane, const double* ratios,
                                                const double* values, MaternSums& sums, double* products,
                                                double* kept) {
  const Doubles ratio = load<Doubles>(ratios + lane);
  const Doubles one = all<Doubles>(1.0);
  Covariance p{};
  State value{}, first{}, second{};
  Doubles vv{}, v0{}, v1{}, t00{}, t01{}, t11{}, product = one;
  for (size_t i = 0; i < curve.places; ++i) {
    const MaternStep& step = curve.steps[i];
    p = predicted(step, p, ratio);
    const Doubles variance = p.p[0] + 1.0;
    const Doubles inverse = one / variance;
    const Doubles gain[3] = {p.p[0] * inverse, p.p[1] * inverse, p.p[2] * inverse};
    p.p[3] -= gain[1] * p.p[1];
    p.p[4] -= gain[1] * p.p[2];
    p.p[5] -= gain[2] * p.p[2];
    for (size_t k = 0; k < 3; ++k) p.p[k] = gain[k];
    product *= variance;
    if ((i + 1) % matern_product == 0 || i + 1 == curve.places) {
      store(products + i / matern_product * matern_lanes + lane, product);
      product = one;
    }
    const Doubles n = innovation(value, step.transition, load<Doubles>(values + i * matern_lanes + lane));
    const Doubles n0 = innovation(first, step.transition, all<Doubles>(curve.trend[0][i]));
    const Doubles n1 = innovation(second, step.transition, all<Doubles>(curve.trend[1][i]));
    correct(value, gain, n);
    correct(first, gain, n0);
    correct(second, gain, n1);
    const Doubles w = n * inverse, w0 = n0 * inverse, w1 = n1 * inverse;
    vv += w * n;
    v0 += w * n0;
    v1 += w * n1;
    t00 += w0 * n0;
    t01 += w0 * n1;
    t11 += w1 * n1;
    if constexpr (keeps) {
      double* const to = kept + i * matern_kept * matern_lanes + lane;
      store(to, w);
      store(to + matern_lanes, w0);
      store(to + 2 * matern_lanes, w1);
      for (size_t k = 0; k < 3; ++k) store(to + (3 + k) * matern_lanes, gain[k]);
    }
  }
  store(sums.values + lane, vv);
  store(sums.values_trend[0] + lane, v0);
  store(sums.values_trend[1] + lane, v1);
  store(sums.trend[0] + lane, t00);
  store(sums.trend[1] + lane, t01);
  store(sums.trend[2] + lane, t11);
}

void filter(const MaternCurve& curve, const double* ratios, const double* values, MaternSums& sums, double* products,
            double* kept) {
  for (size_t lane = 0; lane < matern_lanes; lane += lanes<Doubles>) {
    if (kept != nullptr)
      filter_lanes<true>(curve, lane, ratios, values, sums, products, kept);
    else
      filter_lanes<false>(curve, lane, ratios, values, sums, products, nullptr);
  }
}

void smooth(const MaternCurve& curve, const double* kept, const double* factors, double* results) {
  for (size_t lane = 0; lane < matern_lanes; lane += lanes<Doubles>) {
    const Doubles f0 = load<Doubles>(factors + lane), f1 = load<Doubles>(factors + matern_lanes + lane);
    State pull{};  // what the places behind this one ask of its state
    for (size_t i = curve.places; i-- > 0;) {
      const double* const from = kept + i * matern_kept * matern_lanes + lane;
      Doubles u =
          load<Doubles>(from) - f0 * load<Doubles>(from + matern_lanes) - f1 * load<Doubles>(from + 2 * matern_lanes);
      for (size_t k = 0; k < 3; ++k) u -= load<Doubles>(from + (3 + k) * matern_lanes) * pull.x[k];
      store(results + i * matern_lanes + lane, u);
      pull.x[0] += u;
      const double* const a = curve.steps[i].transition;
      State back;
      for (size_t k = 0; k < 3; ++k) back.x[k] = a[k] * pull.x[0] + a[3 + k] * pull.x[1] + a[6 + k] * pull.x[2];
      pull = back;
    }
  }
}

void simulate(const MaternCurve& curve, const double* normals, double* values) {
  for (size_t lane = 0; lane < matern_lanes; lane += lanes<Doubles>) {
    State s{};
    for (size_t i = 0; i < curve.places; ++i) {
      const double* const z = normals + i * 3 * matern_lanes + lane;
      const Doubles z0 = load<Doubles>(z), z1 = load<Doubles>(z + matern_lanes),
                    z2 = load<Doubles>(z + 2 * matern_lanes);
      const double* const c = curve.steps[i].root;
      s = moved(curve.steps[i].transition, s);
      s.x[0] += c[0] * z0;
      s.x[1] += c[1] * z0 + c[2] * z1;
      s.x[2] += c[3] * z0 + c[4] * z1 + c[5] * z2;
      store(values + i * matern_lanes + lane, s.x[0]);
    }
  }
}

}  // namespace

extern const MaternKernel matern_kernel;
const MaternKernel matern_kernel = {filter, smooth, simulate};

}  // namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET
