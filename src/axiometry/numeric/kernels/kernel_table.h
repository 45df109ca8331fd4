// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/numeric/vector_target.h"

/// For the sources that choose between compiled kernels, inside the library only: which ones there are is known only
/// to it (AXIOMETRY_X86_KERNELS).
namespace axiometry::numeric {

/// One kernel per target; a target that is not compiled leaves a null pointer.
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

/// AXIOMETRY_KERNEL_TABLE(name, Kernel): declares the `name` that the compiled kernels define in the namespaces of
/// their targets, and defines the table `name_table` of them. Use in the namespace that holds these.
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
  static constexpr ::axiometry::numeric::KernelTable<Kernel> name##_table { &plain::name, &avx2::name, &avx512::name }
#else
#define AXIOMETRY_KERNEL_TABLE(name, Kernel) \
  namespace plain {                          \
  extern const Kernel name;                  \
  }                                          \
  static constexpr ::axiometry::numeric::KernelTable<Kernel> name##_table { &plain::name, nullptr, nullptr }
#endif
