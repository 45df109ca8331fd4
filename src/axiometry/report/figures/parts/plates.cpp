// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/parts/plates.h"

#include <algorithm>
#include <cmath>

#include "axiometry/base/contract.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::report::plot {
namespace {

constexpr double smallest_in_um = 0.1;  // below, a figure reads better in nm

bool shows_zero(std::string_view text) { return text.find_first_of("123456789") == std::string_view::npos; }

/// Whether a label of the figure says it better than the number of the tables.
bool wants_finer_unit(double native, AxisKind kind, const std::string& number, const Options& options) {
  if (native == 0.0) return false;
  const bool tiny =
      kind == AxisKind::linear && options.unit == DisplayUnit::native && std::abs(native) < smallest_in_um;
  return tiny || shows_zero(number);
}

/// ″ and ° follow the number directly, other units after a space.
std::string with_unit(const std::string& number, std::string_view unit) {
  const bool is_angle = unit == "″" || unit == "°";
  return number + (is_angle ? "" : "\u00A0") + std::string(unit);
}

}  // namespace

std::string axis_phrase(const Subject& subject) {
  constexpr double longest_name = 150.0;
  const std::string& name = subject.test.metadata.axis.name;
  const std::string word(word_for(subject.test.metadata.axis));
  return name.empty() ? "the " + word : word + " " + shortened(name, longest_name, 8.0);
}

const iso230_2::ParameterInfo& info(Parameter parameter) {
  const auto* found = std::ranges::find(iso230_2::parameters, parameter, &iso230_2::ParameterInfo::member);
  AXIOMETRY_CONTRACT(found != std::end(iso230_2::parameters));
  return *found;
}

std::string shown_deviation(double native, AxisKind kind, const Options& options) {
  if (const ParameterScale scale = parameter_scale(kind, options.unit); scale.unit != deviation_unit(kind)) {
    const int decimals = std::max(0, *options.deviation_decimals + scale.further_decimals);
    return with_unit(format_fixed(native * scale.per_native, decimals, options.numbers), scale.unit);
  }
  const std::string number = format_fixed(native, *options.deviation_decimals, options.numbers);
  if (!wants_finer_unit(native, kind, number, options)) return with_unit(number, deviation_unit(kind));
  constexpr int significant_digits = 2;
  constexpr double nm_per_um = 1000.0;
  const bool linear = kind == AxisKind::linear;
  const double value = linear ? nm_per_um * native : native;
  const int decimals = std::max(0, decimals_for(std::abs(value), significant_digits));
  return with_unit(format_fixed(value, decimals, options.numbers), linear ? "nm" : deviation_unit(kind));
}

std::string shown_value(Parameter parameter, const Subject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  const ShownParameter shown = show(info(parameter), subject.assessment, kind, options);
  const double native = (subject.assessment.evaluation.parameters.*parameter)->in_native();
  const bool finer = shown.U.empty() && wants_finer_unit(native, kind, shown.value, options);
  return " = " + (finer ? shown_deviation(native, kind, options) : with_unit(shown.value, shown.unit));
}

void add_at_margin(Plate& plate, Parameter parameter, const Subject& subject, const Options& options) {
  if (const auto span = extent(subject.assessment.evaluation, parameter)) {
    plate.at_margin.push_back(
        {*span, joined(symbol(info(parameter)), {plain(shown_value(parameter, subject, options))})});
  }
}

}  // namespace axiometry::report::plot
