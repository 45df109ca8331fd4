// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/correction_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/number_text.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {
namespace {

constexpr int digits_of_rate = 3;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// "refractive index of air (Ciddor 1996)"
std::string name_of(const AppliedCorrection& correction) {
  std::string name = correction.title;
  if (!name.empty() && name[0] >= 'A' && name[0] <= 'Z') name[0] = static_cast<char>(name[0] - 'A' + 'a');
  const auto equation = std::ranges::find(correction.details, "Equation", &AppliedCorrection::Detail::name);
  return equation == correction.details.end() ? name : fmt::format("{} ({})", name, equation->value);
}

}  // namespace

std::string correction_statement(std::span<const AppliedCorrection> corrections) {
  std::string text;
  for (const AppliedCorrection& correction : corrections)
    text += (text.empty() ? "Readings corrected by this program: " : ", ") + name_of(correction);
  return text;
}

std::string correction_extent(const AppliedCorrection& correction, AxisKind kind, const Options& options) {
  return fmt::format("{} to {}\u00a0{}", format_fixed(correction.smallest.in_native(), 2, options.numbers),
                     format_fixed(correction.largest.in_native(), 2, options.numbers), deviation_unit(kind));
}

std::string detail_value(const AppliedCorrection::Detail& detail, const Options& options) {
  std::string value = with_true_minus(detail.value);
  for (std::size_t k = 1; k + 1 < value.size(); ++k)
    if (value[k] == '.' && is_digit(value[k - 1]) && is_digit(value[k + 1])) value[k] = options.numbers.decimal_mark;
  return value;
}

std::string drift_statement(const Drift& drift, AxisKind kind, const Options& options) {
  const std::string_view unit = deviation_unit(kind);
  const bool timed = drift.course.duration.has_value();
  const std::string_view per = timed ? "/h" : " per reading";
  const auto shown = [&](Deviation d) {
    const double rate = timed ? *drift.per_hour(d) : drift.per_reading(d);
    return fmt::format("{}\u00a0{}{}", shown_short(rate, options, digits_of_rate), unit, per);
  };
  std::string text = shown(drift.over_test);
  if (drift.u) text += fmt::format(", standard uncertainty {}", shown(*drift.u));
  return text + fmt::format(", that is {}\u00a0{} over the test", shown_deviation(drift.over_test, options), unit);
}

}  // namespace axiometry::report
