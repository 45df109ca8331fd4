// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/vector_target.h"

#include <vector>

namespace axiometry::numeric {
namespace {

std::vector<VectorTarget> find_targets() {
  std::vector<VectorTarget> found = {VectorTarget::plain};
#if defined(AXIOMETRY_X86_KERNELS)
  // The compiler's run time looks also whether the operating system saves the wide registers.
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2")) found.push_back(VectorTarget::avx2);
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    found.push_back(VectorTarget::avx512);
#endif
  return found;
}

}  // namespace

std::string_view vector_target_name(VectorTarget target) {
  switch (target) {
    case VectorTarget::plain: return "plain";
    case VectorTarget::avx2: return "avx2";
    case VectorTarget::avx512: return "avx512";
  }
  return "";
}

std::span<const VectorTarget> available_vector_targets() {
  static const std::vector<VectorTarget> targets = find_targets();
  return targets;
}

VectorTarget best_vector_target() { return available_vector_targets().back(); }

}  // namespace axiometry::numeric
