// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/kernels/affine_rows.h"

#include <algorithm>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/kernels/kernel_table.h"

namespace axiometry::numeric {

AXIOMETRY_KERNEL_TABLE(affine_kernel, AffineKernel);

const AffineKernel& affine_kernel_of(VectorTarget target) { return affine_kernel_table.of(target); }

AffineRows::AffineRows(std::span<const Row> rows) : begins_{0} {
  for (const Row& row : rows) {
    constants_.push_back(row.constant);
    constants_single_.push_back(static_cast<float>(row.constant));
    for (const Term& term : row.terms) {
      source_count_ = std::max(source_count_, term.source + 1);
      sources_.push_back(static_cast<std::uint32_t>(term.source));
      factors_.push_back(term.factor);
      factors_single_.push_back(static_cast<float>(term.factor));
    }
    begins_.push_back(static_cast<std::uint32_t>(sources_.size()));
  }
}

void AffineRows::apply(Rows<const double> sources, Rows<double> rows, std::size_t trials, VectorTarget target) const {
  AXIOMETRY_CONTRACT(sources.hold(source_count_, trials) && rows.hold(row_count(), trials));
  const AffineMapView<double> map{row_count(), constants_.data(), begins_.data(), sources_.data(), factors_.data()};
  affine_kernel_of(target).apply(map, {sources.values.data(), sources.stride, trials}, rows.values.data(), rows.stride);
}

void AffineRows::apply(Rows<const float> sources, Rows<float> rows, std::size_t trials, VectorTarget target) const {
  AXIOMETRY_CONTRACT(sources.hold(source_count_, trials) && rows.hold(row_count(), trials));
  const AffineMapView<float> map{row_count(), constants_single_.data(), begins_.data(), sources_.data(),
                                 factors_single_.data()};
  affine_kernel_of(target).apply_single(map, {sources.values.data(), sources.stride, trials}, rows.values.data(),
                                        rows.stride);
}

void subtract_products(std::span<const double> factors, Rows<const double> sources, Rows<double> rows,
                       std::size_t trials, VectorTarget target) {
  const std::size_t count = rows.stride == 0 ? 0 : rows.values.size() / rows.stride;
  if (count == 0) return;
  const std::size_t terms = factors.size() / count;
  AXIOMETRY_CONTRACT(terms * count == factors.size() && sources.hold(terms, trials) && rows.hold(count, trials));
  affine_kernel_of(target).subtract(factors.data(), terms, count, {sources.values.data(), sources.stride, trials},
                                    rows.values.data(), rows.stride);
}

void subtract_products(std::span<const double> factors, Rows<const double> sources, std::span<double> row,
                       VectorTarget target) {
  subtract_products(factors, sources, Rows<double>{row, row.size()}, row.size(), target);
}

}  // namespace axiometry::numeric
