// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

/// Which instructions the kernels use. Every kernel is one source, compiled once for each target
/// (axiometry_vector_kernels() in cmake/AxiometryHelpers.cmake) and chosen when it runs, so that one program is
/// fast everywhere. All targets give the same bits: they differ in how many lanes go through one instruction, and
/// only + − × ÷ √ of IEEE 754, comparisons and integers are used, nothing contracted, in a fixed order.
namespace axiometry::numeric {

enum class VectorTarget {
  plain,   ///< what the compiler's target has anyway: SSE2 on x86-64, NEON on 64-bit ARM
  avx2,    ///< AVX2; needs no FMA
  avx512,  ///< AVX-512 F, BW, DQ, VL
};

std::string_view vector_target_name(VectorTarget target);  ///< "plain", "avx2", "avx512"

/// The targets this program contains and this processor runs, slowest first; never empty.
std::span<const VectorTarget> available_vector_targets();

/// The last of them.
VectorTarget best_vector_target();

}  // namespace axiometry::numeric
