// SPDX-License-Identifier: Apache-2.0
#pragma once

// Moments and counts of a row of values for one target; compiled once for each (numeric/vector_target.h). The row is
// read once: numbers of cells are made a group at a time, and counted while they are in the nearest cache.
#include "axiometry/numeric/kernels/lanes.h"
#include "axiometry/uncertainty/summary_kernel_types.h"

static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__, "the number of a cell is the lower half of its word");

namespace axiometry::uncertainty::AXIOMETRY_VECTOR_TARGET {
namespace {

using namespace numeric::AXIOMETRY_VECTOR_TARGET;

constexpr size_t group = 512;
static_assert(group % summary_lanes == 0);
constexpr double two_to_52 = 0x1p52;  // rounds what is added to it to an integer, in the lower bits

/// Leaves the numbers of cells alone.
struct NoCells {
  template <typename Vector>
  [[gnu::always_inline]] void number(size_t, Vector) const {}
  [[gnu::always_inline]] void count(size_t) const {}
};

struct Cells {
  const SummaryCells& cells;
  uint64_t* numbers;  // numbers of a group

  /// A value that is not a number goes to the first cell.
  template <typename Vector>
  [[gnu::always_inline]] void number(size_t i, Vector x) const {
    const Vector place = (x - cells.lower) * cells.cells_per_unit + 0.5;
    const Vector inside = smaller(larger(place, Vector{}), all<Vector>(static_cast<double>(cells.last)));
    store(numbers + i, inside + two_to_52);
  }
  [[gnu::always_inline]] void count(size_t size) const {
    uint32_t* const counts = cells.counts;
#pragma GCC unroll 8
    for (size_t i = 0; i < size; ++i) ++counts[static_cast<uint32_t>(numbers[i])];
  }
};

/// Some whole rounds of all lanes, two registers of lanes at a time.
template <typename To>
[[gnu::always_inline]] inline void add_group(const double* values, size_t size, double near_mean, SummarySums& sums,
                                             const To& to) {
  for (size_t lane = 0; lane < summary_lanes; lane += 2 * lanes<Doubles>) {
    Doubles first[2], second[2], min[2], max[2];
    for (size_t k = 0; k < 2; ++k) {
      const size_t at = lane + k * lanes<Doubles>;
      first[k] = load<Doubles>(sums.first + at);
      second[k] = load<Doubles>(sums.second + at);
      min[k] = load<Doubles>(sums.min + at);
      max[k] = load<Doubles>(sums.max + at);
    }
    for (size_t i = lane; i < size; i += summary_lanes)
      for (size_t k = 0; k < 2; ++k) {
        const Doubles x = load<Doubles>(values + i + k * lanes<Doubles>);
        const Doubles d = x - near_mean;
        first[k] += d;
        second[k] += d * d;
        min[k] = smaller(x, min[k]);
        max[k] = larger(x, max[k]);
        to.number(i + k * lanes<Doubles>, x);
      }
    for (size_t k = 0; k < 2; ++k) {
      const size_t at = lane + k * lanes<Doubles>;
      store(sums.first + at, first[k]);
      store(sums.second + at, second[k]);
      store(sums.min + at, min[k]);
      store(sums.max + at, max[k]);
    }
  }
  to.count(size);
}

template <typename To>
[[gnu::always_inline]] inline void add_all(const double* values, size_t count, double near_mean, SummarySums& sums,
                                           const To& to) {
  const size_t whole = count / summary_lanes * summary_lanes;
  for (size_t begin = 0; begin < whole; begin += group)
    add_group(values + begin, whole - begin < group ? whole - begin : group, near_mean, sums, to);
  for (size_t i = whole; i < count; ++i) {
    const double x = values[i], d = x - near_mean;
    const size_t lane = i - whole;
    sums.first[lane] += d;
    sums.second[lane] += d * d;
    sums.min[lane] = x < sums.min[lane] ? x : sums.min[lane];
    sums.max[lane] = x > sums.max[lane] ? x : sums.max[lane];
    to.number(0, all<Doubles>(x));
    to.count(1);
  }
}

void moments(const double* values, size_t count, double near_mean, SummarySums& sums) {
  add_all(values, count, near_mean, sums, NoCells{});
}

void counts(const double* values, size_t count, double near_mean, SummarySums& sums, const SummaryCells& cells) {
  alignas(64) uint64_t numbers[group];
  add_all(values, count, near_mean, sums, Cells{cells, numbers});
}

}  // namespace

extern const SummaryKernel summary_kernel;
const SummaryKernel summary_kernel = {moments, counts};

}  // namespace axiometry::uncertainty::AXIOMETRY_VECTOR_TARGET
