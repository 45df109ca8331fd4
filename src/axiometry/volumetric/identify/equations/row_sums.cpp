// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/equations/row_sums.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "axiometry/numeric/kernels/outer_sums.h"
#include "axiometry/volumetric/curves/beam_row.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t rows_most = 32;  // with 80 entries each they stay in the nearest cache
constexpr std::size_t squares = squareness_names.size();
constexpr std::size_t border = squares + 5;  // squareness, −u, −1, place along a drift
constexpr std::size_t vector_entries = 8;    // doubles that the widest vectors hold

struct Placed {
  std::uint32_t place = 0;  ///< equal for rows whose curves have their coefficients in the same columns
  std::uint32_t at = 0;     ///< index of the reading, counted from the first of its sum
};
constexpr unsigned place_bits = 10;  // bits for each axis: its span (below 400), and whether it has a direction

/// Readings that count, those of the same spans of all axes together, else as they come. By digits: its time grows with
/// the readings alone.
std::vector<Placed> by_place(const Problem& problem, std::size_t begin, std::size_t end) {
  std::vector<Placed> order;
  order.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i) {
    if (problem.weights[i] == 0.0) continue;
    const Approaches approaches = approaches_of(problem, i);
    std::size_t place = 0;
    for (std::size_t a = 0; a < axis_count; ++a) {
      const std::size_t span = problem.coefficients.basis(a).first_active(problem.readings[i].axes_mm[a]);
      place = (place << place_bits) + 2 * span + (approaches[a] != 0.0 ? 1 : 0);
    }
    order.push_back({static_cast<std::uint32_t>(place), static_cast<std::uint32_t>(i - begin)});
  }
  std::vector<Placed> sorted(order.size());
  for (unsigned shift = 0; shift < axis_count * place_bits; shift += place_bits) {
    constexpr std::uint32_t digits = 1u << place_bits;
    const auto digit = [&](const Placed& placed) { return placed.place >> shift & (digits - 1); };
    std::array<std::size_t, digits + 1> next{};
    for (const Placed& placed : order) ++next[digit(placed) + 1];
    for (std::size_t d = 0; d < digits; ++d) next[d + 1] += next[d];
    for (const Placed& placed : order) sorted[next[digit(placed)]++] = placed;
    order.swap(sorted);
  }
  return order;
}

/// A few rows whose curves have the same places, side by side: their curves, squareness, station and dead path.
class RowBlock {
 public:
  RowBlock(const Problem& problem, std::span<const Vector3> beams, std::vector<double>& sums)
      : problem_(problem), beams_(beams), columns_(problem.unknowns.columns), sums_(sums) {}

  /// Adds the rows of at most rows_most readings.
  void add(std::size_t first_reading, std::span<const Placed> alike) {
    fill(first_reading, alike);
    add_curves(alike.size());
    const auto stretch_of = [&](std::size_t n) { return problem_.unknowns.stretch_of[first_reading + alike[n].at]; };
    for (std::size_t begin = 0; begin < alike.size();) {
      std::size_t end = begin + 1;
      while (end < alike.size() && stretch_of(end) == stretch_of(begin)) ++end;
      add_border(begin, end, problem_.unknowns.stretches[stretch_of(begin)]);
      begin = end;
    }
  }

 private:
  struct Curve {
    std::size_t column = 0;
    std::size_t count = 0;
    std::size_t offset = 0;  ///< offset in a row of the block
  };

  void fill(std::size_t first_reading, std::span<const Placed> alike) {
    for (std::size_t n = 0; n < alike.size(); ++n) {
      const std::size_t i = first_reading + alike[n].at;
      const BeamRow beam = beam_row(problem_, i);
      if (n == 0) take_places(beam);
      const Vector3 u = beams_[i];
      const double root = std::sqrt(problem_.weights[i]);
      double* row = values_.data() + n * stride_;
      beam.write(u, root, row);
      row += curves_width_ + squares;
      *row++ = -root * u.x;
      *row++ = -root * u.y;
      *row++ = -root * u.z;
      *row++ = -root;
      *row = root * problem_.unknowns.along_stretch[i];
    }
  }

  void take_places(const BeamRow& beam) {
    curve_count_ = 0;
    curves_width_ = 0;
    for (const BeamRow::Piece& piece : beam.pieces().first(beam.pieces().size() - 1)) {
      curves_[curve_count_++] = {piece.first, piece.count, curves_width_};
      curves_width_ += piece.count;
    }
    stride_ = (curves_width_ + border + vector_entries - 1) / vector_entries * vector_entries;
    values_.resize(std::max(values_.size(), rows_most * stride_));
    border_.resize(std::max(border_.size(), border * stride_));
  }

  std::span<const Curve> curves() const { return {curves_.data(), curve_count_}; }

  void add_curves(std::size_t rows) {
    for (std::size_t p = 0; p < curve_count_; ++p)
      for (std::size_t r = p; r < curve_count_; ++r)
        numeric::add_outer_sums({values_.data() + curves_[p].offset, curves_[p].count,
                                 values_.data() + curves_[r].offset, curves_[r].count, rows, stride_},
                                sums_.data() + curves_[p].column * columns_ + curves_[r].column, columns_);
  }

  /// Rows `begin` to before `end` of the block, which are of one stretch.
  void add_border(std::size_t begin, std::size_t end, const BeamStretch& stretch) {
    std::fill_n(border_.begin(), border * stride_, 0.0);
    const double* first = values_.data() + begin * stride_;
    numeric::add_outer_sums({first + curves_width_, border, first, curves_width_ + border, end - begin, stride_},
                            border_.data(), stride_);
    const std::size_t station = problem_.unknowns.stations[stretch.virtual_station].column;
    const std::size_t paths = problem_.unknowns.drift ? 2 : 1;
    add_border_rows(0, squares, problem_.coefficients.squareness(), {});
    add_border_rows(squares, 3, station, {{station, 3}});
    add_border_rows(squares + 3, paths, stretch.column, {{station, 3}, {stretch.column, paths}});
  }

  struct Columns {
    std::size_t first = 0;
    std::size_t count = 0;
  };

  /// To `count` rows of the matrix from `row` on: what they have with curves, squareness, and the columns behind these.
  void add_border_rows(std::size_t from, std::size_t count, std::size_t row, std::initializer_list<Columns> behind) {
    for (std::size_t i = 0; i < count; ++i) {
      const double* own = border_.data() + (from + i) * stride_;
      double* to = sums_.data() + (row + i) * columns_;
      for (const Curve& curve : curves())
        for (std::size_t k = 0; k < curve.count; ++k) to[curve.column + k] += own[curve.offset + k];
      own += curves_width_;
      for (std::size_t k = 0; k < squares; ++k) to[problem_.coefficients.squareness() + k] += *own++;
      for (const Columns& columns : behind)
        for (std::size_t k = 0; k < columns.count; ++k) to[columns.first + k] += *own++;
    }
  }

  const Problem& problem_;
  std::span<const Vector3> beams_;
  std::size_t columns_;
  std::vector<double>& sums_;
  std::array<Curve, 2 * axis_count> curves_{};
  std::size_t curve_count_ = 0, curves_width_ = 0, stride_ = 0;
  std::vector<double> values_;  ///< √w a
  std::vector<double> border_;
};

}  // namespace

std::vector<double> row_sums(const Problem& problem, std::span<const Vector3> beams, std::size_t begin,
                             std::size_t end) {
  std::vector<double> sums(problem.unknowns.columns * problem.unknowns.columns, 0.0);
  const std::vector<Placed> order = by_place(problem, begin, end);
  RowBlock block(problem, beams, sums);
  for (std::size_t k = 0; k < order.size();) {
    std::size_t last = k + 1;
    while (last < order.size() && last - k < rows_most && order[last].place == order[k].place) ++last;
    block.add(begin, std::span(order).subspan(k, last - k));
    k = last;
  }
  return sums;
}

void fill_upper_triangle(const Problem& problem, std::vector<double>& sums) {
  const std::size_t n = problem.unknowns.columns, square = problem.coefficients.squareness();
  const auto take = [&](std::size_t row, std::size_t columns) {
    for (std::size_t k = 0; k < columns; ++k) sums[k * n + row] = sums[row * n + k];
  };
  for (std::size_t row = square; row < square + squares; ++row) take(row, square);
  for (std::size_t row = problem.coefficients.raw(); row < n; ++row) take(row, row);
}

}  // namespace axiometry::volumetric::detail
