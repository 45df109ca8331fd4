// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/rules/rule_values.h"

namespace axiometry::standards {

extern const AxisRule gb_t_17421_2_2000_axis_rule;
const AxisRule gb_t_17421_2_2000_axis_rule = {
    .id = "gb-t-17421-2-2000",
    .name = "GB/T 17421.2-2000",
    .remark = "the formulas of ISO 230-2:2014 under older names",
    .linear_only = false,
    .figures = two_sigma_figures(Evidence::program),
    .findings = nullptr,
};

}  // namespace axiometry::standards
