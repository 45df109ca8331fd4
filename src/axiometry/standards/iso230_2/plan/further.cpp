// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/plan/further.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/standards/iso230_2/programme.h"
#include "axiometry/standards/iso230_2/rules/message.h"

namespace axiometry::iso230_2 {
namespace {

/// Of 2 000 mm the targets at both ends lie up to 5 % inwards (planned that way), of 360° the last may lie an interval
/// before the end of the turn.
constexpr double stretch_covered_least = 0.9;

double span_of(const Plan& plan) { return plan.targets.back().in_native() - plan.targets.front().in_native(); }

bool covers_a_stretch(const Plan& part) {
  const double span = span_of(part);
  const bool rotary = part.axis.kind == AxisKind::rotary;
  const double interval = part.targets.size() > 1 ? span / static_cast<double>(part.targets.size() - 1) : 0.0;
  return span + (rotary ? interval : 0.0) >= stretch_covered_least * normal_stretch(part.axis.kind).in_native();
}

bool is_same_axis(const Axis& a, const Axis& b) {
  return a.name == b.name && a.kind == b.kind && a.line_direction == b.line_direction;
}

bool has_one_approach(const Plan& plan) {
  return required_approaches(programme_of(plan.axis.kind, Position::native(span_of(plan)))) == 1;
}

std::string told_of_another(const Axis& whole, const Axis& part) {
  if (whole.kind != part.kind)
    return part.kind == AxisKind::rotary
               ? "found a further test of a rotary axis, expected one of a linear axis as the test it belongs to"
               : "found a further test of a linear axis, expected one of a rotary axis as the test it belongs to";
  if (whole.name == part.name)
    return "found a further test along another line in space, expected the line of the test it belongs to";
  return fmt::format("found a further test of axis {}, expected one of axis {} as the test it belongs to",
                     text::quoted(part.name), text::quoted(whole.name));
}

}  // namespace

bool has_additional_test(const Plan& plan) {
  const bool whole = has_one_approach(plan);
  return std::ranges::any_of(plan.further, [&](const Plan& part) {
    return measures_positions(part) && is_same_axis(part.axis, plan.axis) && has_one_approach(part) != whole &&
           (!whole || covers_a_stretch(part));
  });
}

std::optional<Finding> of_another_axis(const Plan& whole, const Plan& part) {
  if (is_same_axis(whole.axis, part.axis)) return std::nullopt;
  return rules::departure("plan-further-axis", whole.clause.empty() ? "5.3" : whole.clause,
                          told_of_another(whole.axis, part.axis));
}

Plan on_the_same_axis(const Plan& whole, Plan part) {
  if (is_same_axis(whole.axis, part.axis)) part.axis = whole.axis;
  return part;
}

}  // namespace axiometry::iso230_2
