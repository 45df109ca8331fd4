// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/text/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace axiometry {

std::optional<double> parse_number(std::string_view text) {
  if (text.starts_with('+')) {
    text.remove_prefix(1);
    if (text.starts_with('-') || text.starts_with('+')) return std::nullopt;
  }
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::optional<unsigned long long> parse_count(std::string_view text) {
  unsigned long long value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::string format_exact(double x) {
  char buffer[32];
  const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, x);
  return std::string(buffer, end);
}

std::string format_shortest(double x) { return (x < 0.0 ? "\u2212" : "") + format_exact(std::abs(x)); }

std::string format_fixed(double x, int decimals, NumberStyle style) {
  const double unit = std::pow(10.0, std::max(0, -decimals));
  std::string digits =
      fmt::format("{:.{}f}", decimals < 0 ? std::round(std::abs(x) / unit) * unit : std::abs(x), std::max(0, decimals));
  const bool zero = digits.find_first_of("123456789") == std::string::npos;
  std::ranges::replace(digits, '.', style.decimal_mark);
  return x < 0 && !zero ? "\u2212" + digits : digits;
}

int decimals_for(double uncertainty, int digits) {
  if (!(uncertainty > 0.0)) return 0;
  const auto decimals = [&](double x) { return digits - 1 - static_cast<int>(std::floor(std::log10(x))); };
  const int first = std::clamp(decimals(uncertainty), -9, 9);
  // 0.0996 rounds to 0.100 with two digits: what is shown decides, so 0.10.
  const double shown = std::round(uncertainty * std::pow(10.0, first)) / std::pow(10.0, first);
  return shown > 0.0 ? std::clamp(decimals(shown * (1.0 + 1e-12)), -9, first) : first;
}

}  // namespace axiometry
