// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/cumulative_rows.h"

#include <limits>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/cumulative_kernel_types.h"
#include "axiometry/numeric/kernel_table.h"

namespace axiometry::numeric {

AXIOMETRY_KERNEL_TABLE(cumulative_kernel, CumulativeKernel);

const CumulativeKernel& cumulative_kernel_of(VectorTarget target) { return cumulative_kernel_table.of(target); }

CumulativeRows::CumulativeRows(std::size_t rows, std::size_t numbers)
    : rows_(rows),
      numbers_(numbers),
      blocks_((numbers + cumulative_block - 1) / cumulative_block),
      ends_((blocks_ - 1 + cumulative_block - 1) / cumulative_block * cumulative_block),
      stride_(ends_ + blocks_ * cumulative_block),
      values_(rows * stride_, std::numeric_limits<float>::infinity()) {
  AXIOMETRY_CONTRACT(numbers > 0);
}

void CumulativeRows::set(std::size_t row, std::size_t index, float number) {
  AXIOMETRY_CONTRACT(row < rows_ && index < numbers_);
  float* const own = values_.data() + row * stride_;
  own[ends_ + index] = number;
  const std::size_t block = index / cumulative_block;
  if (index % cumulative_block == cumulative_block - 1 && block + 1 < blocks_) own[block] = number;
}

void CumulativeRows::count_up_to(std::span<const float> numbers, std::span<const std::uint32_t> rows,
                                 std::span<std::uint32_t> found, VectorTarget target) const {
  AXIOMETRY_CONTRACT(found.size() >= numbers.size() && (rows.empty() ? numbers.size() <= rows_ : true));
  AXIOMETRY_CONTRACT(rows.empty() || rows.size() >= numbers.size());
  cumulative_kernel_of(target).count_up_to({values_.data(), stride_, ends_}, rows.empty() ? nullptr : rows.data(),
                                           numbers.data(), numbers.size(), found.data());
}

}  // namespace axiometry::numeric
