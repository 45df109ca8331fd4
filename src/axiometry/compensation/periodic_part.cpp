// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/periodic_part.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "axiometry/base/rounded_text.h"
#include "axiometry/compensation/prediction.h"
#include "axiometry/numeric/moments.h"

namespace axiometry::compensation {
namespace {

constexpr double chance_most = 0.01;

std::size_t index_of(Direction direction) { return static_cast<std::size_t>(direction); }

/// "1.52 µm ↑ and 1.48 µm ↓", of the directions in which it is significant.
std::string amplitudes(const PeriodicPart& part, AxisKind kind) {
  std::string text;
  for (const Direction direction : {Direction::up, Direction::down})
    if (part.is_significant(direction))
      text += fmt::format("{}{:.2f} {} {}", text.empty() ? "" : " and ",
                          part.directions[index_of(direction)]->amplitude, deviation_unit(kind), arrow(direction));
  return text;
}

double widest_spacing(std::span<const double> nodes) {
  double widest = 0.0;
  for (std::size_t k = 1; k < nodes.size(); ++k) widest = std::max(widest, nodes[k] - nodes[k - 1]);
  return widest;
}

}  // namespace

bool PeriodicPart::is_significant(Direction direction) const {
  const auto& fit = directions[index_of(direction)];
  return fit && fit->chance < chance_most;
}

double PeriodicPart::at(double position, Direction direction) const {
  return is_significant(direction) ? directions[index_of(direction)]->at(position) : 0.0;
}

PeriodicPart periodic_part(const Series& series, double period) {
  PeriodicPart part{period};
  for (const Direction direction : {Direction::up, Direction::down}) {
    std::vector<double> places, means;
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const numeric::Moments m = numeric::moments(series.cell(i, direction));
      if (m.count == 0) continue;
      places.push_back(series.targets()[i].in_native());
      means.push_back(m.mean);
    }
    part.directions[index_of(direction)] = numeric::fit_sine_beside_curve({places, means}, period);
  }
  return part;
}

Result<Series> without_periodic(const Series& series, const PeriodicPart& part) {
  return shifted_series(series, [&](double position, Direction direction) { return -part.at(position, direction); });
}

std::vector<NamedFinding> findings_of_periodic(const PeriodicPart& part, Periodic choice, std::span<const double> nodes,
                                               AxisKind kind) {
  const std::string period = fmt::format("{} {}", format_rounded(part.period), position_unit(kind));
  if (choice == Periodic::leave) {
    if (part.is_significant())
      return {
          {"compensation-periodic-left", false,
           fmt::format("the periodic part with a period of {}, of an amplitude of {}, is not in the table: it stays, "
                       "and is in what is predicted",
                       period, amplitudes(part, kind))}};
    return {{"compensation-nothing-periodic", false,
             part.is_told() ? fmt::format("found no periodic part with a period of {} in the readings that noise would "
                                          "not make in one test of a hundred: nothing was left out",
                                          period)
                            : fmt::format("the targets do not tell a periodic part with a period of {}: nothing was "
                                          "left out",
                                          period)}};
  }
  const double spacing = widest_spacing(nodes);
  if (nodes.size() < 3 || spacing <= 0.5 * part.period || !part.is_significant()) return {};
  return {
      {"compensation-periodic-aliased", true,
       fmt::format("found a periodic part with a period of {}, of an amplitude of {}, in the readings, and positions "
                   "of the table up to {} {} apart, above half the period: the table holds what the targets happened "
                   "to meet of it, and is wrong between them; --periodic leave leaves it out",
                   period, amplitudes(part, kind), format_rounded(spacing), position_unit(kind))}};
}

}  // namespace axiometry::compensation
