// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <utility>

#include "axiometry/app/dynamics/dynamic_motion.h"
#include "axiometry/app/files/request_members.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;
using json::Value;

Result<void> take_positive(JsonMembers& members, std::string_view name, double most, std::optional<double>& target) {
  const Value* value = members.optional(name);
  if (value == nullptr) return {};
  AXIOMETRY_TRY(const double number, formats::number_in(*value, name));
  if (!(number > 0.0 && number <= most))
    return fail(fmt::format("{}: found {}, expected a number above 0 and up to {}", name, format_exact(number), most),
                value->at());
  target = number;
  return {};
}

Result<void> take_reading(JsonMembers& members, DynamicOptions& options) {
  constexpr std::array kinds = {std::pair{std::string_view("linear"), AxisKind::linear},
                                std::pair{std::string_view("rotary"), AxisKind::rotary}};
  AXIOMETRY_TRY_VOID(take_choice<AxisKind>(members, "kind", kinds, options.kind));
  AXIOMETRY_TRY_VOID(members.take("stream", options.stream));
  AXIOMETRY_TRY_VOID(take_positive(members, "rate_hz", largest_stated, options.rate_hz));
  AXIOMETRY_TRY_VOID(take_number(members, "units_per_count", options.units_per_count));
  AXIOMETRY_TRY(const auto axis, whole_member(members, "stream_axis", {1.0, largest_stream_axis}));
  if (axis) options.stream_axis = static_cast<std::size_t>(*axis) - 1;
  AXIOMETRY_TRY_VOID(take_switch(members, "skip_damaged", options.skip_damaged));
  return take_switch(members, "reverse", options.reverse);
}

}  // namespace

Result<DynamicOptions> dynamic_options_from(const Value& asked) {
  constexpr double percent = 100.0;
  DynamicOptions options;
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(asked, "options"));
  AXIOMETRY_TRY_VOID(take_reading(members, options));
  AXIOMETRY_TRY_VOID(take_positive(members, "window_s", largest_stated, options.window_s));
  AXIOMETRY_TRY_VOID(take_number(members, "from_s", options.from_s));
  AXIOMETRY_TRY_VOID(take_number(members, "to_s", options.to_s));
  AXIOMETRY_TRY_VOID(take_positive(members, "feed_per_min", largest_stated, options.feed));
  std::optional<double> even;
  AXIOMETRY_TRY_VOID(take_positive(members, "even_percent", largest_even_percent, even));
  if (even) options.uniform_share = *even / percent;
  AXIOMETRY_TRY_VOID(members.finish());
  return options;
}

}  // namespace axiometry::app
