// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/rules/rule_values.h"

namespace axiometry::standards {

extern const AxisRule jis_b_6190_2_axis_rule;
const AxisRule jis_b_6190_2_axis_rule = {
    .id = "jis-b-6190-2",
    .name = "JIS B 6190-2",
    .remark = "the formulas of ISO 230-2:2014 under older names",
    .linear_only = false,
    .figures = two_sigma_figures(Evidence::second_hand),
    .findings = nullptr,
};

}  // namespace axiometry::standards
