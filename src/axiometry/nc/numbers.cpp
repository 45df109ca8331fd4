// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/base/number_text.h"

namespace axiometry::nc {
namespace {

/// A coordinate that was given in decimals is met but for the rounding of doubles: a position below 1e5 has 1.5e-11,
/// and an overrun was added.
constexpr double exact_within = 1e-9;

/// A length given in mm is never exact in inches. Half of the least step of the metric default, 0.1 µm.
constexpr double inch_within_mm = 0.5e-4;

std::string fixed(double x, int decimals) {
  std::string text = fmt::format("{:.{}f}", x, decimals);
  if (text.front() == '-' && text.find_first_of("123456789") == std::string::npos) text.erase(0, 1);
  return text;
}

double read_back(const std::string& text) {
  const auto x = parse_number(text);
  AXIOMETRY_CONTRACT(x.has_value());
  return *x;
}

}  // namespace

Result<Coordinates> Coordinates::make(const Plan& plan, const ProgramOptions& options) {
  if (options.decimals < 0 || options.decimals > decimals_highest)
    return fail(fmt::format("found {} decimals, expected 0 to {}", options.decimals, decimals_highest));
  const bool in_inch = options.unit == LengthUnit::inch && plan.axis.kind == AxisKind::linear;
  const double tolerance = in_inch ? inch_within_mm : exact_within;
  Coordinates coordinates(in_inch, options.decimals);
  // Target and overrun may both be rounded by half a unit, so two of them keep the way to a target from vanishing.
  const auto told_apart = [&] {
    const double overrun = plan.overrun.in_native() / (in_inch ? mm_per_inch : 1.0);
    if (overrun * std::pow(10.0, coordinates.decimals_) < 2.0 - exact_within) return false;
    for (std::size_t i = 1; i < plan.targets.size(); ++i)
      if (coordinates.text(plan.targets[i - 1]) == coordinates.text(plan.targets[i])) return false;
    return true;
  };
  while (coordinates.decimals_ < decimals_highest &&
         (coordinates.target_error(plan).in_native() > tolerance || !told_apart()))
    ++coordinates.decimals_;
  if (!told_apart())
    return fail(
        fmt::format("found targets, or target and overrun, that are alike with {} decimals, expected positions "
                    "that the program can tell apart",
                    decimals_highest));
  return coordinates;
}

std::string Coordinates::text(Position position) const {
  const double x = position.in_native() / (in_inch_ ? mm_per_inch : 1.0);
  return fixed(x, decimals_) + (decimals_ == 0 ? "." : "");
}

Position Coordinates::target_error(const Plan& plan) const {
  double error = 0.0;
  for (Position target : plan.targets) {
    const double printed = read_back(text(target)) * (in_inch_ ? mm_per_inch : 1.0);
    error = std::max(error, std::abs(printed - target.in_native()));
  }
  return Position::native(error);
}

std::string trimmed_number(double x, int decimals) {
  std::string text = fixed(x, decimals);
  if (text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return text;
}

}  // namespace axiometry::nc
