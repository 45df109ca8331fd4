// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/band_cholesky.h"

#include <algorithm>
#include <cmath>

namespace axiometry::numeric {

void BandMatrix::add_square(std::size_t first, std::span<const double> values, double weight) {
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) rows_[first + i][i - j] += weight * values[i] * values[j];
}

std::optional<BandMatrix> BandMatrix::cholesky() const {
  BandMatrix factor(rows());
  for (std::size_t i = 0; i < rows(); ++i) {
    for (std::size_t back = std::min(width, i) + 1; back-- > 0;) {
      const std::size_t j = i - back;
      double sum = rows_[i][back];
      for (std::size_t k = i - std::min(width, i); k < j; ++k)
        if (j - k <= width) sum -= factor.rows_[i][i - k] * factor.rows_[j][j - k];
      if (back > 0) {
        factor.rows_[i][back] = sum / factor.rows_[j][0];
      } else {
        if (!(sum > 0.0)) return std::nullopt;
        factor.rows_[i][0] = std::sqrt(sum);
      }
    }
  }
  return factor;
}

void BandMatrix::solve(std::span<double> b) const {
  const std::size_t n = rows();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t back = 1; back <= std::min(width, i); ++back) b[i] -= rows_[i][back] * b[i - back];
    b[i] /= rows_[i][0];
  }
  for (std::size_t i = n; i-- > 0;) {
    b[i] /= rows_[i][0];
    for (std::size_t back = 1; back <= std::min(width, i); ++back) b[i - back] -= rows_[i][back] * b[i];
  }
}

}  // namespace axiometry::numeric
