// SPDX-License-Identifier: Apache-2.0
// Two targets, two runs, worked by hand: means ↑ 1 and 2, ↓ 0 and 1; s 0; B = 1, E = 2, A = 2.
#include <axiometry/standards/iso230_2/parameters.h>

#include <cstdio>

int main() {
  using namespace axiometry;
  const auto series = Series::make_dense({Position::native(0), Position::native(100)}, 2, {1, 1, 2, 2, 0, 0, 1, 1});
  if (!series) return 1;
  const auto parameters = iso230_2::evaluate(*series).parameters;
  std::printf("A = %g um, B = %g um\n", parameters.A->in_native(), parameters.B->in_native());
  return parameters.A->in_native() == 2.0 && parameters.B->in_native() == 1.0 ? 0 : 1;
}
