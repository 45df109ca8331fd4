// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/kernels/outer_sums.h"

#include "axiometry/numeric/kernels/kernel_table.h"

namespace axiometry::numeric {

AXIOMETRY_KERNEL_TABLE(outer_sums_kernel, OuterSumsKernel);

const OuterSumsKernel& outer_sums_kernel_of(VectorTarget target) { return outer_sums_kernel_table.of(target); }

}  // namespace axiometry::numeric
