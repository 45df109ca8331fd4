// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/report/figures/figures.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// Tests to draw: the worked example of ISO 230-2:2014, Table 2, and the cases in which plots get crowded.
namespace axiometry::report::testing {

/// A test with its assessment, so that a Subject can point into it.
struct Drawn {
  Test test;
  iso230_2::Assessment assessment;
  Options options;

  Subject subject() const { return {test, assessment, {}}; }
  std::vector<Figure> draw() const { return figures(subject(), options); }
};

inline Drawn drawn(const std::vector<double>& targets, const std::vector<Reading>& readings,
                   AxisKind kind = AxisKind::linear) {
  std::vector<Position> positions;
  for (const double target : targets) positions.push_back(Position::native(target));
  Series series = Series::make(std::move(positions), readings).value();
  iso230_2::Assessment assessment;
  assessment.evaluation = iso230_2::evaluate(series);
  Metadata metadata;
  metadata.axis.name.assign(1, kind == AxisKind::linear ? 'X' : 'C');
  metadata.axis.kind = kind;
  return {Test{std::move(metadata), std::move(series), {}}, std::move(assessment), {}};
}

/// Deviations from a function of target index, direction and run; NaN for a missing one.
template <typename Deviations>
Drawn drawn_from(const std::vector<double>& targets, std::size_t runs, Deviations deviations,
                 AxisKind kind = AxisKind::linear) {
  std::vector<Reading> readings;
  for (std::size_t i = 0; i < targets.size(); ++i) {
    for (const Direction direction : {Direction::up, Direction::down}) {
      for (std::size_t j = 0; j < runs; ++j) {
        const double deviation = deviations(i, direction, j);
        if (!std::isnan(deviation)) readings.push_back({i, direction, j, Deviation::native(deviation)});
      }
    }
  }
  return drawn(targets, readings, kind);
}

inline std::vector<double> evenly(double first, double last, std::size_t count) {
  std::vector<double> targets;
  for (std::size_t i = 0; i < count; ++i) {
    targets.push_back(first + (last - first) * static_cast<double>(i) / static_cast<double>(count - 1));
  }
  return targets;
}

/// Scatter without a random number: −1 to 1, the same on every machine.
inline double scatter(std::size_t i, Direction direction, std::size_t j) {
  const std::size_t mixed = (i * 7919 + static_cast<std::size_t>(direction) * 104729 + j * 1299709) % 101;
  return (static_cast<double>(mixed) - 50.0) / 50.0;
}

/// ISO 230-2:2014, Table 2: linear axis, 11 targets, 5 approaches from each direction.
inline Drawn table_2() {
  const std::vector<double> targets = {6.711,   175.077,  353.834,  525.668,  704.175, 881.868,
                                       1055.89, 1234.304, 1408.462, 1580.269, 1750.92};
  static constexpr std::array<std::array<double, 10>, 11> deviations = {{
      // five from below, five from above
      {-1.2, -1.7, -1.9, -1.3, -1.9, 2.3, 2.1, 1.9, 2.8, 2.2},
      {-0.5, -0.9, -1.1, -0.2, -0.8, 3.6, 3.5, 3.1, 3.7, 3.2},
      {0.2, -0.6, -0.7, 0.1, -0.7, 3.5, 3.3, 3.0, 3.8, 3.5},
      {-0.6, -1.2, -1.3, -0.3, -1.3, 3.0, 2.7, 2.4, 3.2, 2.6},
      {-1.9, -2.3, -2.9, -1.4, -2.3, 1.7, 1.5, 1.0, 1.9, 1.1},
      {-3.0, -3.5, -3.7, -2.8, -3.7, 0.4, 0.2, -0.2, 0.9, -0.1},
      {-3.7, -4.3, -4.6, -3.6, -4.5, -0.4, -0.7, -1.0, 0.0, -0.9},
      {-3.7, -4.4, -5.1, -3.6, -4.6, -0.2, -0.6, -1.0, -0.2, -1.1},
      {-3.5, -4.3, -5.0, -3.2, -4.5, 0.2, -0.2, -1.0, 0.5, -0.5},
      {-3.2, -3.8, -4.7, -2.8, -4.1, 0.3, -0.1, -0.9, 0.5, -0.4},
      {-3.6, -4.0, -4.5, -3.2, -4.5, -0.1, -0.6, -1.2, 0.4, -0.9},
  }};
  return drawn_from(targets, 5, [](std::size_t i, Direction direction, std::size_t j) {
    return deviations[i][static_cast<std::size_t>(direction) * 5 + j];
  });
}

struct Case {
  std::string name;
  Drawn drawn;
};

/// What crowds a plot: many targets, outliers, slopes, clusters, gaps, nothing at all.
inline std::vector<Case> crowded_cases() {
  const auto lost = [](std::size_t i) { return 0.4 * static_cast<double>(i % 17) - 0.2 * static_cast<double>(i % 23); };
  const auto plain = [=](std::size_t i, Direction direction, std::size_t j) {
    return lost(i) + (direction == Direction::up ? -1.5 : 1.5) + scatter(i, direction, j);
  };
  std::vector<Case> cases;
  cases.push_back({"targets_101", drawn_from(evenly(0, 1000, 101), 5, plain)});
  cases.push_back({"outlier", drawn_from(evenly(0, 1000, 11), 5, [&](auto i, Direction direction, auto j) {
                     const bool is_outlier = i == 4 && j == 2 && direction == Direction::up;
                     return plain(i, direction, j) + (is_outlier ? 50.0 : 0.0);
                   })});
  cases.push_back({"slope", drawn_from(evenly(0, 1000, 11), 5, [&](auto i, Direction direction, auto j) {
                     return 100.0 * static_cast<double>(i) - 500.0 + scatter(i, direction, j);
                   })});
  cases.push_back({"single_run", drawn_from(evenly(12, 4010, 17), 1, plain)});
  cases.push_back({"up_only", drawn_from(evenly(0, 500, 6), 5, [&](auto i, Direction direction, auto j) {
                     return direction == Direction::up ? plain(i, direction, j) : std::nan("");
                   })});
  cases.push_back({"rotary", drawn_from(evenly(0, 360, 9), 5, plain, AxisKind::rotary)});
  cases.push_back({"nanometres", drawn_from(evenly(0, 100, 6), 5, [&](auto i, Direction direction, auto j) {
                     return 0.002 * plain(i, direction, j);
                   })});
  cases.push_back({"all_equal", drawn_from(evenly(0, 100, 6), 5, [](auto, Direction, auto) { return 7.0; })});
  cases.push_back({"all_zero", drawn_from(evenly(0, 100, 6), 5, [](auto, Direction, auto) { return 0.0; })});
  cases.push_back({"clustered", drawn_from({0, 1, 2, 3, 50, 51, 51.5, 52, 400, 401, 990, 1000}, 5, plain)});
  cases.push_back({"negative_targets", drawn_from(evenly(-1250.5, -3, 11), 5, plain)});
  cases.push_back({"missing", drawn_from(evenly(0, 1000, 11), 5, [&](auto i, Direction direction, auto j) {
                     const bool up = direction == Direction::up;
                     const bool is_missing = (i == 3 && up) || (i == 7 && j > 0) || (i == 9 && !up && j < 4);
                     return is_missing ? std::nan("") : plain(i, direction, j);
                   })});
  cases.push_back({"two_targets", drawn_from({0, 1000}, 5, plain)});
  cases.push_back({"huge", drawn_from({-1e9, 0, 1e9}, 5, [&](auto i, Direction direction, auto j) {
                     return 1e9 * scatter(i, direction, j);
                   })});
  cases.push_back({"long_name", drawn_from(evenly(0, 1000, 11), 5, plain)});
  cases.back().drawn.test.metadata.axis.name = "<b>\"X\" & Y</b> " + std::string(300, 'W');
  cases.back().drawn.assessment.label = "step cycle (Annex B), not for acceptance " + std::string(300, 'w');
  return cases;
}

}  // namespace axiometry::report::testing
