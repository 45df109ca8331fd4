// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/programme.h"

#include <algorithm>
#include <cmath>

namespace axiometry::iso230_2 {
namespace {

constexpr double travel_slack = 1e-6;  // mm or °
constexpr double about = 1.2;          // "about 250 mm" is met up to 300 mm

/// Whole number at or above x, forgiving the rounding of x itself.
std::size_t at_least(double x) { return static_cast<std::size_t>(std::ceil(std::min(x, 1e9) - 1e-9)); }

}  // namespace

Programme programme_of(AxisKind kind, Position travel) {
  const bool within = travel.in_native() <= normal_stretch(kind).in_native() + travel_slack;
  if (kind == AxisKind::linear) return within ? Programme::short_linear : Programme::long_linear;
  return within ? Programme::one_turn : Programme::many_turns;
}

const char* programme_clause(Programme programme) {
  switch (programme) {
    case Programme::short_linear: return "5.3.2";
    case Programme::long_linear: return "5.3.3";
    case Programme::one_turn: return "5.3.4";
    case Programme::many_turns: return "5.3.5";
  }
  return "";
}

std::size_t required_approaches(Programme programme) {
  return programme == Programme::short_linear || programme == Programme::one_turn ? 5 : 1;
}

RequiredTargets required_targets(Programme programme, Position over) {
  const double travel = over.in_native();
  switch (programme) {
    case Programme::short_linear: {
      const std::size_t per_metre = at_least(5.0 * travel / 1000.0);
      return per_metre > 5 ? RequiredTargets{per_metre, "5 per metre"} : RequiredTargets{5, "at any length"};
    }
    case Programme::long_linear:
      return {at_least(travel / (about * long_axis_interval.in_native())) + 1, "a mean interval of about 250 mm"};
    case Programme::one_turn:
      return travel <= 90.0    ? RequiredTargets{3, "Table 1, up to 90°"}
             : travel <= 180.0 ? RequiredTargets{5, "Table 1, up to 180°"}
                               : RequiredTargets{8, "Table 1, above 180°"};
    case Programme::many_turns: return {at_least(8.0 * travel / 360.0), "8 per revolution"};
  }
  return {};
}

Position normal_stretch(AxisKind kind) { return Position::native(kind == AxisKind::linear ? 2000.0 : 360.0); }

}  // namespace axiometry::iso230_2
