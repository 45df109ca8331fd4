// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/shown_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/number_text.h"

namespace axiometry::report {

namespace {

std::string localised(std::string digits, const Options& options) {
  std::ranges::replace(digits, '.', options.numbers.decimal_mark);
  return digits.starts_with('-') ? "\u2212" + digits.substr(1) : digits;
}

}  // namespace

ParameterScale parameter_scale(AxisKind kind, DisplayUnit unit) {
  if (kind == AxisKind::linear) {
    if (unit == DisplayUnit::mm) return {"mm", 1e-3, 3};
    if (unit == DisplayUnit::nm) return {"nm", 1e3, -3};
  } else if (unit == DisplayUnit::deg) {
    return {"°", 1.0 / 3600.0, 4};
  }
  return {deviation_unit(kind), 1.0, 0};
}

bool is_unit_of(AxisKind kind, DisplayUnit unit) {
  using enum DisplayUnit;
  if (unit == native) return true;
  return (unit == deg || unit == arcsec) == (kind == AxisKind::rotary);
}

int uncertainty_decimals(Deviation uncertainty, const ParameterScale& scale, const Options& options) {
  constexpr double rounding_noise = 1e-6;  // native
  return uncertainty.in_native() > rounding_noise
             ? decimals_for(uncertainty.in_native() * scale.per_native, options.uncertainty_digits)
             : std::max(0, *options.deviation_decimals + scale.further_decimals);
}

std::string shown_deviation(Deviation deviation, const Options& options) {
  return format_fixed(deviation.in_native(), *options.deviation_decimals, options.numbers);
}

std::string shown_limit(Deviation limit, const ParameterScale& scale, const Options& options) {
  constexpr int digits_of_decimals = 12;  // more would show what the conversion of units leaves
  return shown_short(limit.in_native() * scale.per_native, options, digits_of_decimals);
}

double acceptance_limit_to(double limit, int decimals) {
  constexpr double rounding = 1e-9;  // of the calculation: 10 − 0.3 is 9.7
  const double unit = std::pow(10.0, decimals);
  const double nearest = std::round(limit * unit) / unit;
  return std::abs(nearest - limit) <= rounding * std::max(1.0, std::abs(limit)) ? nearest
                                                                                : std::floor(limit * unit) / unit;
}

double rejection_limit_to(double limit, int decimals) { return -acceptance_limit_to(-limit, decimals); }

std::string shown_uncertainty(Deviation U, const ParameterScale& scale, const Options& options) {
  const double value = U.in_native() * scale.per_native;
  if (value == 0.0) return "0";
  return format_fixed(value, decimals_for(value, options.uncertainty_digits), options.numbers);
}

std::string shown_exact(double x, const Options& options) { return localised(format_exact(x), options); }

std::string with_true_minus(std::string_view text) {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  std::string with;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const bool begins = k == 0 || text[k - 1] == ' ' || text[k - 1] == '(';
    if (begins && text[k] == '-' && k + 1 < text.size() && is_digit(text[k + 1]))
      with += "−";
    else
      with += text[k];
  }
  return with;
}

std::string shown_short(double x, const Options& options, int significant_digits) {
  constexpr double written_out_below = 1e9;
  std::string text = fmt::format("{:.{}g}", x, significant_digits);
  if (text.contains("e+") && std::abs(x) < written_out_below) text = fmt::format("{:.0f}", parse_number(text).value());
  return localised(text, options);
}

std::string shown_vector(Vector3 v, const Options& options, int significant_digits) {
  const std::string_view separator = options.numbers.decimal_mark == ',' ? "; " : ", ";
  const auto number = [&](double x) { return shown_short(x, options, significant_digits); };
  return fmt::format("({}{}{}{}{})", number(v.x), separator, number(v.y), separator, number(v.z));
}

int position_decimals(std::span<const Position> targets) {
  const auto shows = [](double x, int decimals) {
    const double unit = std::pow(10.0, decimals);
    return std::abs(x - std::round(x * unit) / unit) < 0.5e-4;
  };
  int decimals = 0;
  while (decimals < 4 && !std::ranges::all_of(targets, [&](Position p) { return shows(p.in_native(), decimals); }))
    ++decimals;
  return decimals;
}

}  // namespace axiometry::report
