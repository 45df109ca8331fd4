// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "axiometry/numeric/curve_kernel_types.h"
#include "axiometry/numeric/random/random.h"

namespace axiometry::numeric {
namespace {

TEST(CurveKernel, AddsColumnsInTheirOrderOnEveryTarget) {
  constexpr std::size_t curves = 3;
  for (std::size_t m : {1u, 2u, 7u, 8u, 9u, 11u, 12u, 13u, 24u, 25u, 47u, 48u, 49u, 64u}) {
    const std::size_t stride = (m + curve_padding - 1) / curve_padding * curve_padding;
    std::vector<double> columns(curves * m * stride), means(curves * m), sds(curves * m), normals(curves * (m + 2));
    fill_normal({1, 0, m}, columns);
    fill_normal({1, 1, m}, means);
    fill_uniform({1, 2, m}, sds);
    fill_normal({1, 3, m}, normals);
    std::vector<CurveView> views;
    for (std::size_t c = 0; c < curves; ++c)
      views.push_back({means.data() + c * m, sds.data() + c * m, columns.data() + c * m * stride, m, stride});
    for (VectorTarget target : available_vector_targets()) {
      SCOPED_TRACE(std::string(vector_target_name(target)) + ", " + std::to_string(m));
      std::vector<double> values(curves * (stride + 1), -99.0);
      curve_kernel_of(target).draw({views.data(), curves, normals.data(), m + 2, values.data(), stride + 1});
      for (std::size_t c = 0; c < curves; ++c) {
        for (std::size_t i = 0; i < m; ++i) {
          double sum = 0.0;
          for (std::size_t k = 0; k < m; ++k)
            sum += (views[c].means[k] + views[c].sds[k] * normals[c * (m + 2) + k]) * views[c].columns[k * stride + i];
          ASSERT_EQ(values[c * (stride + 1) + i], sum) << i;
        }
        EXPECT_EQ(values[c * (stride + 1) + stride], -99.0) << "beyond the places";
      }
    }
  }
}

}  // namespace
}  // namespace axiometry::numeric
