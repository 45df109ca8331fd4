// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/figures/parts/plates.h"

namespace axiometry::report {
namespace {

using iso230_2::AxisParameters;
using plot::axis_phrase;

std::string_view direction_phrase(Direction direction) {
  return direction == Direction::up ? "positive approaches (↑)" : "negative approaches (↓)";
}

/// " A = 9.6 µm, E = 7.8 µm" of the parameters that exist.
std::string parameter_phrase(const Subject& subject, const Options& options,
                             std::initializer_list<plot::Parameter> parameters) {
  std::string phrase;
  for (const plot::Parameter parameter : parameters) {
    if (!(subject.assessment.evaluation.parameters.*parameter)) continue;
    phrase += fmt::format("{}{}{}", phrase.empty() ? ": " : ", ", plot::info(parameter).symbol,
                          plot::shown_value(parameter, subject, options));
  }
  return phrase;
}

std::string description(const Subject& subject, const Options& options, std::string_view approaches,
                        std::initializer_list<plot::Parameter> parameters) {
  const auto targets = subject.test.series.targets();
  return fmt::format("Mean positioning deviations of {} with their repeatability bands at {} target positions, {}{}.",
                     axis_phrase(subject), targets.size(), approaches, parameter_phrase(subject, options, parameters));
}

Figure bidirectional(const Subject& subject, const Options& options) {
  Figure figure = plot::draw(plot::bidirectional_plate(subject, options));
  figure.title =
      fmt::format("Figure 2. Bidirectional positioning errors and repeatability of {}", axis_phrase(subject));
  figure.description =
      description(subject, options, "approached from both directions",
                  {&AxisParameters::A, &AxisParameters::E, &AxisParameters::M, &AxisParameters::R, &AxisParameters::B});
  return figure;
}

Figure unidirectional(const Subject& subject, const Options& options, Direction direction, std::string_view number) {
  Figure figure = plot::draw(plot::unidirectional_plate(subject, options, direction));
  figure.title = fmt::format("Figure {}. Unidirectional positioning errors and repeatability of {}, {}", number,
                             axis_phrase(subject), direction_phrase(direction));
  const bool up = direction == Direction::up;
  figure.description = up ? description(subject, options, direction_phrase(direction),
                                        {&AxisParameters::A_up, &AxisParameters::E_up, &AxisParameters::R_up})
                          : description(subject, options, direction_phrase(direction),
                                        {&AxisParameters::A_down, &AxisParameters::E_down, &AxisParameters::R_down});
  return figure;
}

}  // namespace

std::vector<Figure> figures(const Subject& subject, const Options& asked) {
  const Options options = fitted(asked, subject.assessment.evaluation.parameters);
  const Series& series = subject.test.series;
  const bool both = series.has_both_directions();
  std::vector<Figure> result;
  if (both) result.push_back(bidirectional(subject, options));
  for (const Direction direction : {Direction::up, Direction::down}) {
    if (!series.has(direction)) continue;
    const std::string_view number = !both ? "3" : direction == Direction::up ? "3a" : "3b";
    result.push_back(unidirectional(subject, options, direction, number));
  }
  return result;
}

}  // namespace axiometry::report
