// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tests/support/nc_text.h"

/// What controls make of the number of a rotary axis.
namespace axiometry::testing_support {

/// How a control drives an axis to a number (in absolute words), each rule after its own manual.
enum class AxisRule {
  counts_on,    ///< the number is the position
  shortest,     ///< Fanuc with parameter 1008 ROA 1 and RAB 0, and the like: the shorter way to the angle
  by_sign,      ///< with RAB 1: the sign is the direction, the magnitude the angle
  wrapped,      ///< LinuxCNC, WRAPPED_ROTARY: likewise, of an angle below a turn
  within_turn,  ///< Heidenhain with a display below 360° and without M126: never through 0
  modulo,       ///< Siemens, ROT_IS_MODULO: likewise, and DC, ACP, ACN say which way
};

/// The control and where its axes stand before the program.
struct NcSetup {
  AxisRule rotary = AxisRule::counts_on;
  double start_deg = 0.0;
};

/// From `at` (which counts turns) to where a rotary axis is driven by a word's number, °.
inline double turned_to(AxisRule rule, double at, std::string_view word) {
  const auto angle_of = [](double x) { return x - 360.0 * std::floor(x / 360.0); };
  const auto up_to = [&](double angle) { return at + angle_of(angle - at); };
  const auto down_to = [&](double angle) { return at - angle_of(at - angle); };
  if (rule == AxisRule::modulo && word.ends_with(')')) {
    const std::string_view way = word.substr(0, word.find('('));
    const double x = nc_number(word.substr(way.size() + 1, word.size() - way.size() - 2));
    if (way == "IC") return at + x;
    if (x < 0.0 || x >= 360.0) throw std::runtime_error("alarm 16830, modulo position " + std::string(word));
    if (way == "ACP") return up_to(x);
    if (way == "ACN") return down_to(x);
    if (way == "DC") return at + std::remainder(x - at, 360.0);
  }
  const double x = nc_number(word);
  switch (rule) {
    case AxisRule::counts_on: return x;
    case AxisRule::shortest: return at + std::remainder(x - at, 360.0);
    case AxisRule::wrapped:
      if (std::abs(x) >= 360.0) throw std::runtime_error("an angle beyond a turn for a wrapped axis");
      [[fallthrough]];
    case AxisRule::by_sign: return std::signbit(x) ? down_to(-x) : up_to(x);
    case AxisRule::within_turn:
    case AxisRule::modulo:
      if (x < 0.0 || x >= 360.0) throw std::runtime_error("an angle beyond the range " + std::string(word));
      return at + x - angle_of(at);
  }
  throw std::runtime_error("no rule");
}

}  // namespace axiometry::testing_support
