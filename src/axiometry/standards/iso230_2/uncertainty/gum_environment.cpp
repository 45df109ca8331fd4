// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/uncertainty/gum_environment.h"

#include <algorithm>
#include <cmath>

#include "axiometry/standards/iso230_2/monte_carlo/environment_recording.h"
#include "axiometry/standards/iso230_2/monte_carlo/noise.h"
#include "axiometry/standards/readings/test_course.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double range_per_sd = 3.4641016151377544;  // range over standard deviation of a uniform distribution: √12

double squared_norm(const EnvironmentModes& modes, const WeightedReadings& sum) {
  double squares = 0.0;
  for (std::size_t k = 0; k < modes.count(); ++k) {
    const auto shape = modes.mode(k);
    double along = 0.0;
    for (const auto& [place, weight] : sum.terms) along += weight * shape[place];
    squares += along * along;
  }
  return squares;
}

std::string note_of(const std::vector<EnvironmentKind>& kinds) {
  const bool white = std::ranges::find(kinds, EnvironmentKind::white) != kinds.end();
  if (kinds.size() == 3) return "E_VE may be white noise, a slow drift or a random walk: the largest u counts";
  if (kinds.size() == 2)
    return "E_VE may be a slow drift or a random walk, since the readings refute white noise: the largest u counts";
  if (white) return "";
  return kinds.front() == EnvironmentKind::drift ? "E_VE counts as a slow drift over the test"
                                                 : "E_VE counts as a random walk over the test";
}

}  // namespace

EnvironmentEffect::EnvironmentEffect(const Test& test, const UncertaintyInputs& inputs, double white_sd) {
  const TestCourse course = course_of(test);
  if (const auto recorded = recorded_environment(test.metadata, course)) {
    possibilities_.push_back({recorded->white_sd, modes_of_covariance(recorded->covariance, course.share), 1.0});
    note_ =
        "E_VE counts as the recording at standstill shows it: how its values go together, and white noise beside it";
    return;
  }
  const auto kinds = environment_kinds({test.metadata, test.series, course, inputs});
  for (EnvironmentKind kind : kinds)
    if (kind == EnvironmentKind::white)
      possibilities_.push_back({white_sd, {}, 1.0});
    else
      possibilities_.push_back(
          {0.0, environment_modes(kind, course.share, test.series.run_count()), range_per_sd * white_sd});
  note_ = note_of(kinds);
}

double EnvironmentEffect::of(const WeightedReadings& sum) const {
  double largest = 0.0;
  for (const Possibility& it : possibilities_)
    largest =
        std::max(largest, std::hypot(it.white_sd * sum.independent, it.scale * std::sqrt(squared_norm(it.slow, sum))));
  return largest;
}

}  // namespace axiometry::iso230_2
