// SPDX-License-Identifier: Apache-2.0

// Whether readings are of an error that their plan was made for.
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/formats/motions/motion_units.h"

namespace axiometry::formats {
namespace {

/// Rotations, or straightness.
std::vector<MotionName> errors_of_kind(const Plan& plan, bool rotation) {
  std::vector<MotionName> errors;
  for (const MotionName& error : plan.errors)
    if (rotation ? error.rotation() : error.straightness()) errors.push_back(error);
  return errors;
}

}  // namespace

Result<void> check_error_of_plan(const std::optional<MotionName>& error, MotionUnit unit, const Plan& plan) {
  if (error && !plan.axis.name.empty() && plan.axis.name != std::string(1, error->axis))
    return fail(fmt::format("found readings of {} with a plan of the axis {}, expected one of {}", error->text(),
                            text::quoted(plan.axis.name), error->axis));
  if (plan.errors.empty()) return {};
  if (error && std::ranges::find(plan.errors, *error) == plan.errors.end())
    return fail(fmt::format("found readings of {} with a plan made for {}, expected one made for {}", error->text(),
                            errors_text(plan), error->text()));
  if (error || !errors_of_kind(plan, is_angle(unit)).empty()) return {};
  return fail(fmt::format("found readings in {} with a plan made for {}, expected one made for {}",
                          motion_unit_symbol(unit), errors_text(plan),
                          is_angle(unit) ? "a rotation such as EAX" : "a straightness such as EYX"));
}

std::optional<MotionName> error_of_plan(const Plan& plan, MotionUnit unit) {
  const std::vector<MotionName> errors = errors_of_kind(plan, is_angle(unit));
  return errors.size() == 1 ? std::optional(errors.front()) : std::nullopt;
}

}  // namespace axiometry::formats
