// SPDX-License-Identifier: Apache-2.0
#pragma once

// Clause 3 of many trials for one target; compiled once for each (numeric/vector_target.h). Operation by operation
// what evaluate() does, but that the largest R_i is found from the largest s_i: × 4 is exact and keeps the order.
#include "axiometry/numeric/kernels/lanes.h"
#include "axiometry/standards/iso230_2/batch_kernel_types.h"

namespace axiometry::iso230_2::AXIOMETRY_VECTOR_TARGET {
namespace {

using namespace numeric::AXIOMETRY_VECTOR_TARGET;

/// x̄_i and s_i (3.13, 3.18) of one target and direction; s_i is 0 where there are not two readings.
template <typename Vector>
struct Cell {
  Vector mean, s;
};

/// Moments of the readings at `at(0)` … `at(count − 1)`, as numeric::moments(). A constant count unrolls the loops.
template <typename Vector, typename Count, typename At>
[[gnu::always_inline]] inline Cell<Vector> moments(Count count, At at) {
  using Number = decltype(Vector{}[0] + 0);
  Vector sum = at(0);
  for (size_t j = 1; j < count; ++j) sum += at(j);
  const Vector mean = sum / static_cast<Number>(static_cast<size_t>(count));
  if (count < 2) return {mean, Vector{}};
  const Vector first = at(0) - mean;
  Vector squares = first * first;
  for (size_t j = 1; j < count; ++j) {
    const Vector difference = at(j) - mean;
    squares += difference * difference;
  }
  return {mean, square_root(squares / static_cast<Number>(count - 1))};
}

template <size_t n>
struct Fixed {
  constexpr operator size_t() const { return n; }
};

/// Cells with the same number of readings in each, known to the compiler.
template <typename Vector, typename Number, size_t n>
struct CompleteReadings {
  BatchInput<Number> readings;
  [[gnu::always_inline]] bool has(size_t) const { return true; }
  [[gnu::always_inline]] Cell<Vector> cell(size_t c, size_t t) const {
    const Number* const first = readings.values + c * n * readings.stride + t;
    return moments<Vector>(Fixed<n>{}, [&](size_t j) { return load<Vector>(first + j * readings.stride); });
  }
};

/// Any number of readings, even none, in each cell.
template <typename Vector, typename Number>
struct SomeReadings {
  const BatchView& view;
  BatchInput<Number> readings;
  [[gnu::always_inline]] bool has(size_t c) const { return view.begins[c + 1] > view.begins[c]; }
  [[gnu::always_inline]] Cell<Vector> cell(size_t c, size_t t) const {
    const uint32_t* const rows = view.rows + view.begins[c];
    const size_t count = view.begins[c + 1] - view.begins[c];
    return moments<Vector>(count,
                           [&](size_t j) { return load<Vector>(readings.values + rows[j] * readings.stride + t); });
  }
};

/// Means and estimators that are there already.
template <typename Vector, typename Number>
struct GivenMoments {
  const BatchView& view;
  BatchInput<Number> means;
  BatchInput<Number> estimators;
  [[gnu::always_inline]] bool has(size_t c) const { return view.begins[c + 1] > view.begins[c]; }
  [[gnu::always_inline]] Cell<Vector> cell(size_t c, size_t t) const {
    const bool scatters = view.begins[c + 1] - view.begins[c] > 1;
    return {load<Vector>(means.values + c * means.stride + t),
            scatters ? load<Vector>(estimators.values + c * estimators.stride + t) : Vector{}};
  }
};

template <typename Vector>
struct Extremes {
  Vector high, low;
  [[gnu::always_inline]] void see(Vector above, Vector below) {
    high = larger(above, high);
    low = smaller(below, low);
  }
};

/// What one direction contributes to the axis.
template <typename Vector>
struct DirectionExtremes {
  Extremes<Vector> means, boundaries;  // x̄_i, x̄_i ± 2 s_i
  Vector s{};
  [[gnu::always_inline]] void see(Cell<Vector> cell) {
    const Vector band = cell.s + cell.s;
    means.see(cell.mean, cell.mean);
    boundaries.see(cell.mean + band, cell.mean - band);
    s = larger(cell.s, s);
  }
};

template <typename Vector>
[[gnu::always_inline]] inline Vector range(Extremes<Vector> a, Extremes<Vector> b) {
  return larger(a.high, b.high) - smaller(a.low, b.low);
}

/// The parameters of lanes<Vector> trials from t on.
template <typename Vector, typename Number, typename Cells>
[[gnu::always_inline]] inline void evaluate(const BatchView& view, const Cells& cells, size_t t,
                                            BatchOutput<Number> output) {
  const Vector infinite = all<Vector>(static_cast<Number>(__builtin_inf()));
  const Extremes<Vector> none{-infinite, infinite};
  DirectionExtremes<Vector> up{none, none}, down{none, none};
  Extremes<Vector> means = none;
  Vector R{}, B{}, reversal_sum{}, reversal_count{};
  for (size_t i = 0; i < view.targets; ++i) {
    const bool has_up = cells.has(i), has_down = cells.has(view.targets + i);
    Cell<Vector> above{}, below{};
    if (has_up) up.see(above = cells.cell(i, t));
    if (has_down) down.see(below = cells.cell(view.targets + i, t));
    if (!has_up || !has_down) continue;
    const Vector reversal = above.mean - below.mean;
    const Vector mean = (above.mean + below.mean) * static_cast<Number>(0.5);
    means.see(mean, mean);
    B = larger(magnitude(reversal), B);
    R = larger(((above.s + above.s) + (below.s + below.s)) + magnitude(reversal), R);
    reversal_sum += reversal;
    reversal_count += static_cast<Number>(1);
  }
  const Number width = 4;
  const Vector R_up = up.s * width, R_down = down.s * width;
  const Vector values[batch_parameters] = {range(up.boundaries, down.boundaries),
                                           up.boundaries.high - up.boundaries.low,
                                           down.boundaries.high - down.boundaries.low,
                                           range(up.means, down.means),
                                           up.means.high - up.means.low,
                                           down.means.high - down.means.low,
                                           means.high - means.low,
                                           larger(R, larger(R_up, R_down)),
                                           R_up,
                                           R_down,
                                           B,
                                           reversal_sum / reversal_count};
  for (size_t k = 0; k < batch_parameters; ++k)
    if (view.output_rows[k] >= 0)
      store(output.values + static_cast<size_t>(view.output_rows[k]) * output.stride + t, values[k]);
}

template <typename Vector, typename Number, typename Cells>
[[gnu::always_inline]] inline void evaluate_all(const BatchView& view, const Cells& cells, size_t trials,
                                                BatchOutput<Number> output) {
  for (size_t t = 0; t + lanes<Vector> <= trials; t += lanes<Vector>) evaluate<Vector>(view, cells, t, output);
  if (trials % lanes<Vector> != 0) evaluate<Vector>(view, cells, trials - lanes<Vector>, output);
}

template <typename Vector, typename Number>
void from_readings(const BatchView& view, BatchInput<Number> readings, size_t trials, BatchOutput<Number> output) {
  if (view.complete_runs == 5)  // the number of the standard programme, 5.3.2
    evaluate_all<Vector>(view, CompleteReadings<Vector, Number, 5>{readings}, trials, output);
  else
    evaluate_all<Vector>(view, SomeReadings<Vector, Number>{view, readings}, trials, output);
}

template <typename Vector, typename Number>
void from_moments(const BatchView& view, BatchInput<Number> means, BatchInput<Number> estimators, size_t trials,
                  BatchOutput<Number> output) {
  evaluate_all<Vector>(view, GivenMoments<Vector, Number>{view, means, estimators}, trials, output);
}

}  // namespace

extern const BatchKernel batch_kernel;
const BatchKernel batch_kernel = {from_readings<Doubles, double>, from_readings<Floats, float>,
                                  from_moments<Doubles, double>, from_moments<Floats, float>};

}  // namespace axiometry::iso230_2::AXIOMETRY_VECTOR_TARGET
