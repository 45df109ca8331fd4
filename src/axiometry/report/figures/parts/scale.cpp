// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/scale.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "axiometry/base/contract.h"
#include "axiometry/report/figures/parts/ink.h"

namespace axiometry::report::plot {
namespace {

/// Beyond these shown numbers a power of ten goes into the unit.
constexpr double too_large = 1e6;
constexpr double too_small = 1e-2;

/// A unit and the magnitude (native) from which it is the one to use.
struct UnitStep {
  std::string_view name;
  double native;
  double from;
};

constexpr UnitStep length_deviation[] = {{"nm", 1e-3, 0.0}, {"µm", 1.0, 5e-2}, {"mm", 1e3, 1e4}, {"m", 1e6, 1e7}};
constexpr UnitStep angle_deviation[] = {{"″", 1.0, 0.0}, {"°", 3600.0, 1e4}};
constexpr UnitStep length_position[] = {{"nm", 1e-6, 0.0}, {"µm", 1e-3, 1e-3}, {"mm", 1.0, 0.1}, {"m", 1e3, 1e5}};
constexpr UnitStep angle_position[] = {{"°", 1.0, 0.0}};

AxisUnit choose(std::span<const UnitStep> units, double largest) {
  const UnitStep* chosen = &units.front();
  for (const UnitStep& unit : units) {
    if (largest >= unit.from) chosen = &unit;
  }
  const double shown = largest / chosen->native;
  if (shown == 0.0 || (shown < too_large && shown >= too_small)) return {chosen->native, {plain(chosen->name)}};
  const int exponent = std::clamp(3 * static_cast<int>(std::floor(std::log10(shown) / 3.0)), -306, 306);
  const std::string digits = (exponent < 0 ? "\u2212" : "") + std::to_string(std::abs(exponent));
  return {chosen->native * std::pow(10.0, exponent),
          {plain("10"), {.text = digits, .script = Script::super}, plain("\u2009" + std::string(chosen->name))}};
}

struct Step {
  double size = 1.0;
  int parts = 5;  ///< minor divisions
};

constexpr Step angular_steps[] = {{5, 5}, {10, 5}, {15, 3}, {30, 3}, {45, 3}, {60, 4}, {90, 3}, {180, 4}, {360, 4}};

Step round_step(double at_least, Division division) {
  if (division == Division::angular && at_least > 2.0) {
    for (const Step& step : angular_steps) {
      if (step.size >= at_least) return step;
    }
    const Step turns = round_step(at_least / 360.0, Division::decimal);
    return {360.0 * turns.size, turns.parts};
  }
  const double decade = std::pow(10.0, std::floor(std::log10(at_least)));
  for (const Step& step : {Step{1, 5}, Step{2, 4}, Step{5, 5}}) {
    if (step.size * decade >= at_least * (1.0 - 1e-9)) return {step.size * decade, step.parts};
  }
  return {10.0 * decade, 5};
}

int decimals_of(double step) {
  constexpr int most = 15;
  return std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, most);
}

}  // namespace

AxisUnit deviation_axis_unit(AxisKind kind, DisplayUnit preferred, double largest) {
  if (kind == AxisKind::rotary) return choose(angle_deviation, largest);
  if (preferred == DisplayUnit::nm && largest < 100.0) return {1e-3, {plain("nm")}};
  return choose(length_deviation, largest);
}

AxisUnit position_axis_unit(AxisKind kind, double largest) {
  return kind == AxisKind::rotary ? choose(angle_position, largest) : choose(length_position, largest);
}

Ticks divide(double low, double high, double wanted, Division division) {
  AXIOMETRY_CONTRACT(std::isfinite(low) && std::isfinite(high) && low < high && wanted >= 1.0);
  const Step step = round_step((high - low) / wanted, division);
  const double minor = step.size / step.parts;
  // A range's edge that is a tick but for rounding counts as one.
  const double slack = 1e-9 * step.parts;
  const double first = std::ceil(low / minor - slack);
  const double last = std::floor(high / minor + slack);
  Ticks ticks{.major = {}, .minor = {}, .decimals = decimals_of(step.size)};
  const auto count = static_cast<std::size_t>(std::max(last - first + 1.0, 0.0));
  for (std::size_t k = 0; k < count; ++k) {
    const double number = first + static_cast<double>(k);
    const bool is_major = std::remainder(number, step.parts) == 0.0;
    if (is_major) {
      ticks.major.push_back(number / step.parts * step.size);
    } else {
      ticks.minor.push_back(number * minor);
    }
  }
  return ticks;
}

std::string tick_label(double value, int decimals, NumberStyle style) {
  constexpr std::size_t ungrouped_digits = 4;
  constexpr std::string_view thin_space = "\u2009";
  std::string text = format_fixed(value, decimals, style);
  const std::size_t first = text.find_first_of("0123456789");
  std::size_t end = text.find(style.decimal_mark);
  if (end == std::string::npos) end = text.size();
  if (end - first <= ungrouped_digits) return text;
  for (std::size_t at = end; at > first + 3;) {
    at -= 3;
    text.insert(at, thin_space);
  }
  return text;
}

double widest_label(const Ticks& ticks, NumberStyle style) {
  double widest = 0.0;
  for (const double tick : ticks.major) {
    widest = std::max(widest, text_width({plain(tick_label(tick, ticks.decimals, style))}, ink::tick_text_size));
  }
  return widest;
}

}  // namespace axiometry::report::plot
