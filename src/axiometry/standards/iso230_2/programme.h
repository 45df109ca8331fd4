// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "axiometry/model/axis.h"

/// What clause 5.3 asks of a test programme, for those who make one (plan/plan.h) and those who judge one that was
/// measured (rules/rules.h). Clauses 5.3.3 and 5.3.4 follow general knowledge.
namespace axiometry::iso230_2 {

/// Which of the four tests of clause 5.3 the measured travel calls for.
enum class Programme {
  short_linear,  ///< linear travel up to 2 000 mm: 5.3.2
  long_linear,   ///< linear travel above 2 000 mm: 5.3.3
  one_turn,      ///< rotary travel up to 360°: 5.3.4
  many_turns,    ///< rotary travel above 360°: 5.3.5
};

/// A travel longer by 1e-6 mm or ° than a limit is still within it: a sum of rounded targets is no longer axis.
Programme programme_of(AxisKind kind, Position travel);

/// Clause of the programme: "5.3.2".
const char* programme_clause(Programme programme);

/// n: approaches to each target from each direction, 5 or 1.
std::size_t required_approaches(Programme programme);

/// How many targets the programme needs at least, and why.
struct RequiredTargets {
  std::size_t count = 0;
  std::string_view reason;  ///< "5 per metre", "Table 1, up to 90°"
};

/// `travel` is the distance from the first to the last target. A count beyond 1e9 is given as 1e9.
RequiredTargets required_targets(Programme programme, Position travel);

/// The stretch that the test with five approaches covers where the travel is longer: 2 000 mm or 360°.
Position normal_stretch(AxisKind kind);

/// The most that the test with one approach covers on a rotary axis: five revolutions (5.3.5).
inline constexpr Position most_turns = Position::native(1800.0);

/// p̄ of the test over the whole of a long axis (5.3.3): "about 250 mm", which is met up to 1.2 times that.
inline constexpr Position long_axis_interval = Position::native(250.0);

/// Bound of the random part r of a target when no periodic error is expected: ±30 % of the interval p (5.2).
inline constexpr double random_part = 0.3;

/// Targets whose steps depart from the mean interval by no more than this part of it are equally spaced: the random
/// part is too small to sample a periodic error.
inline constexpr double equal_interval = 1e-3;

/// Two positions nearer than this are the same (mm or °), as for targets and sampling points of the compensation.
inline constexpr Position same_position = Position::native(1e-3);

/// A target nearer than this to 0°, 90°, 180° or 270° stands for that principal position (5.3.4).
inline constexpr Position at_principal = Position::native(0.1);

}  // namespace axiometry::iso230_2
