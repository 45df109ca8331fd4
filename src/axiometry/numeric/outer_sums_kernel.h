// SPDX-License-Identifier: Apache-2.0
#pragma once

// The sums of outer_sums.h for one target; compiled once for each (vector_target.h).
#include "axiometry/numeric/lanes.h"
#include "axiometry/numeric/outer_sums_kernel_types.h"

namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET {
namespace {

/// to += factor · values.
[[gnu::always_inline]] inline void add_times(double factor, const double* values, size_t count, double* to) {
  const Doubles factors = all<Doubles>(factor);
  size_t k = 0;
  for (; k + lanes<Doubles> <= count; k += lanes<Doubles>)
    store(to + k, load<Doubles>(to + k) + factors * load<Doubles>(values + k));
  for (; k < count; ++k) to[k] += factor * values[k];
}

/// The same of a number of entries that is known: six motions of four cubic B-splines.
template <size_t count>
[[gnu::always_inline]] inline void add_many(Doubles factors, const double* values, double* to) {
#pragma GCC unroll 16
  for (size_t k = 0; k < count; k += lanes<Doubles>)
    store(to + k, load<Doubles>(to + k) + factors * load<Doubles>(values + k));
}

constexpr size_t usual = 24;
static_assert(usual % lanes<Doubles> == 0);

/// From entry i on, or a few before it: what lies below the diagonal is nobody's.
[[gnu::always_inline]] inline void add_own(Doubles factors, const RowPiece& own, size_t i, double* to) {
  for (size_t k = i / lanes<Doubles> * lanes<Doubles>; k < usual; k += lanes<Doubles>)
    store(to + k, load<Doubles>(to + k) + factors * load<Doubles>(own.values + k));
}

void add(PiecedRow row, double* matrix, size_t columns) {
  for (size_t p = 0; p < row.count; ++p) {
    const RowPiece own = row.pieces[p];
    for (size_t i = 0; i < own.count; ++i) {
      const double factor = row.weight * own.values[i];
      const Doubles factors = all<Doubles>(factor);
      double* const to = matrix + (own.first + i) * columns;
      if (own.count == usual)
        add_own(factors, own, i, to + own.first);
      else
        add_times(factor, own.values + i, own.count - i, to + own.first + i);
      for (size_t r = p + 1; r < row.count; ++r) {
        const RowPiece& other = row.pieces[r];
        if (other.count == usual)
          add_many<usual>(factors, other.values, to + other.first);
        else
          for (size_t k = 0; k < other.count; ++k) to[other.first + k] += factor * other.values[k];
      }
    }
  }
}

/// to += Σ factor · values of four rows.
[[gnu::always_inline]] inline void add_four_times(const double* factors, const double* const* values, size_t begin,
                                                  size_t count, double* to) {
  const Doubles f0 = all<Doubles>(factors[0]), f1 = all<Doubles>(factors[1]), f2 = all<Doubles>(factors[2]),
                f3 = all<Doubles>(factors[3]);
  const double *v0 = values[0], *v1 = values[1], *v2 = values[2], *v3 = values[3];
  size_t k = begin;
  for (; k + lanes<Doubles> <= count; k += lanes<Doubles>)
    store(to + k, load<Doubles>(to + k) + ((f0 * load<Doubles>(v0 + k) + f1 * load<Doubles>(v1 + k)) +
                                           (f2 * load<Doubles>(v2 + k) + f3 * load<Doubles>(v3 + k))));
  for (; k < count; ++k) to[k] += (factors[0] * v0[k] + factors[1] * v1[k]) + (factors[2] * v2[k] + factors[3] * v3[k]);
}

void add_four(const PiecedRow* rows, double* matrix, size_t columns) {
  for (size_t p = 0; p < rows[0].count; ++p) {
    const RowPiece own = rows[0].pieces[p];
    for (size_t i = 0; i < own.count; ++i) {
      double factors[4];
      for (size_t n = 0; n < 4; ++n) factors[n] = rows[n].weight * rows[n].pieces[p].values[i];
      double* const to = matrix + (own.first + i) * columns;
      for (size_t r = p; r < rows[0].count; ++r) {
        const RowPiece& other = rows[0].pieces[r];
        const double* values[4];
        for (size_t n = 0; n < 4; ++n) values[n] = rows[n].pieces[r].values;
        const size_t begin = r == p ? i / lanes<Doubles> * lanes<Doubles> : 0;
        if (other.count == usual)
          add_four_times(factors, values, begin, usual, to + other.first);
        else
          add_four_times(factors, values, begin, other.count, to + other.first);
      }
    }
  }
}

}  // namespace

extern const OuterSumsKernel outer_sums_kernel;
const OuterSumsKernel outer_sums_kernel = {add, add_four};

}  // namespace axiometry::numeric::AXIOMETRY_VECTOR_TARGET
