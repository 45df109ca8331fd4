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

/// One kernel of the table per target; a target that is not there leaves a null pointer.
template <typename Kernel>
struct KernelTable {
  const Kernel* plain = nullptr;
  const Kernel* avx2 = nullptr;
  const Kernel* avx512 = nullptr;

  const Kernel& of(VectorTarget target) const {
    const Kernel* chosen = target == VectorTarget::avx512 ? avx512 : target == VectorTarget::avx2 ? avx2 : plain;
    return *(chosen ? chosen : plain);
  }
};

}  // namespace axiometry::numeric

/// AXIOMETRY_KERNEL_TABLE(name, Kernel): declares, in the namespaces of the targets, the `name` that the compiled
/// kernels define, and the table `name_table` of those this program contains. Use in axiometry::numeric or alike.
#if defined(AXIOMETRY_X86_KERNELS)
#define AXIOMETRY_KERNEL_TABLE(name, Kernel) \
  namespace plain {                          \
  extern const Kernel name;                  \
  }                                          \
  namespace avx2 {                           \
  extern const Kernel name;                  \
  }                                          \
  namespace avx512 {                         \
  extern const Kernel name;                  \
  }                                          \
  inline constexpr ::axiometry::numeric::KernelTable<Kernel> name##_table { &plain::name, &avx2::name, &avx512::name }
#else
#define AXIOMETRY_KERNEL_TABLE(name, Kernel) \
  namespace plain {                          \
  extern const Kernel name;                  \
  }                                          \
  inline constexpr ::axiometry::numeric::KernelTable<Kernel> name##_table { &plain::name, nullptr, nullptr }
#endif
