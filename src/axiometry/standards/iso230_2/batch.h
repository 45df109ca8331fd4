// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "axiometry/model/series.h"
#include "axiometry/numeric/rows.h"
#include "axiometry/numeric/vector_target.h"
#include "axiometry/standards/iso230_2/batch_kernel_types.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// Clause 3 of many trials at once: the inner loop of the Monte Carlo method. The same formulas as evaluate(), which
/// stays the reference: with the same readings (which must be finite), every parameter is equal to its, on every
/// target. (Where the compiler fuses evaluate()'s operations, as it may on other processors than x86-64, the two
/// differ by a few units in the last place of the largest reading.)
namespace axiometry::iso230_2 {

/// What the trials of one test have in common: targets, directions, and which readings are missing.
class BatchLayout {
 public:
  explicit BatchLayout(const Series& series);

  /// 2·m·runs: a row for each reading, ordered direction, target, run (run fastest, as in Series); the rows of
  /// missing readings are not read.
  std::size_t reading_rows() const { return reading_rows_; }
  /// 2·m: a row for each cell, ordered direction, target.
  std::size_t cell_rows() const { return 2 * targets_; }
  /// The parameters that exist, in the order of `parameters`; a row of the output for each.
  std::span<const ParameterInfo* const> outputs() const { return outputs_; }

  BatchView view() const;  ///< what the kernels see

 private:
  std::size_t targets_ = 0;
  std::size_t complete_runs_ = 0;
  std::size_t reading_rows_ = 0;
  std::vector<std::uint32_t> begins_;
  std::vector<std::uint32_t> rows_;
  std::vector<const ParameterInfo*> outputs_;
};

/// The parameters from readings. Contract: `readings` holds layout.reading_rows() and `parameters` holds
/// layout.outputs().size() rows of so many trials.
void evaluate_batch(const BatchLayout& layout, numeric::Rows<const double> readings, std::size_t trials,
                    numeric::Rows<double> parameters, numeric::VectorTarget target = numeric::best_vector_target());

/// In single precision: for readings |x| ≤ X, at most n of them in a cell, and m targets, every parameter is within
/// (11n + 2m + 45)·2⁻²⁴·X of that of the same readings in double precision; 7.3e-6·X for n = 5, m = 11. With u = 2⁻²⁴
/// and X = 1: a mean is within n·u; s, which moves by at most √2 times what the differences move, within
/// √2·(n + 2)u and √2·(n/2 + 2)u for its own operations; A and R add two means and four s.
void evaluate_batch(const BatchLayout& layout, numeric::Rows<const float> readings, std::size_t trials,
                    numeric::Rows<float> parameters, numeric::VectorTarget target = numeric::best_vector_target());

/// The mean and the estimator of every cell.
template <typename Number>
struct CellMoments {
  numeric::Rows<const Number> means;       ///< x̄_i, 3.13; rows of cells without a reading are not read
  numeric::Rows<const Number> estimators;  ///< s_i ≥ 0, 3.18; rows of cells without two readings are not read
};

/// The parameters from the moments of the cells. Contract: both hold layout.cell_rows() rows of so many trials.
void evaluate_batch(const BatchLayout& layout, CellMoments<double> moments, std::size_t trials,
                    numeric::Rows<double> parameters, numeric::VectorTarget target = numeric::best_vector_target());
void evaluate_batch(const BatchLayout& layout, CellMoments<float> moments, std::size_t trials,
                    numeric::Rows<float> parameters, numeric::VectorTarget target = numeric::best_vector_target());

}  // namespace axiometry::iso230_2
