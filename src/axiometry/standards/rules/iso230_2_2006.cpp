// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/rules/rule_values.h"

namespace axiometry::standards {

extern const AxisRule iso230_2_2006_axis_rule;
const AxisRule iso230_2_2006_axis_rule = {
    .id = "iso-230-2-2006",
    .name = "ISO 230-2:2006",
    .remark = "the formulas of ISO 230-2:2014 under older names",
    .linear_only = false,
    .figures = two_sigma_figures(Evidence::second_hand),
    .findings = nullptr,
};

}  // namespace axiometry::standards
