// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/shown_targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace axiometry::report {
namespace {

using iso230_2::PositionResult;

constexpr std::size_t most_shown_whole = 1000;
constexpr std::size_t about_shown = 500;

/// What the results of a target are compared by.
template <typename Visit>
void for_each_result(const PositionResult& p, const Visit& visit) {
  std::size_t number = 0;
  const auto add = [&](const std::optional<Deviation>& x) {
    visit(number++, x ? std::optional(x->in_native()) : std::nullopt);
  };
  for (const auto& x : {p.mean_up, p.mean_down, p.mean, p.reversal, p.s_up, p.s_down, p.R_up, p.R_down, p.R}) add(x);
  for (const auto& [mean, s] : {std::pair(p.mean_up, p.s_up), std::pair(p.mean_down, p.s_down)})
    for (double k : {-iso230_2::coverage_factor, iso230_2::coverage_factor})
      add(mean && s ? std::optional(Deviation::native(mean->in_native() + k * s->in_native())) : std::nullopt);
}

struct ExtremePlace {
  std::size_t place = 0;
  double value = 0.0;
};

/// Where every result is lowest and highest.
std::vector<std::size_t> places_of_extremes(const std::vector<PositionResult>& positions) {
  std::vector<std::optional<ExtremePlace>> lowest(13), highest(13);
  for (std::size_t i = 0; i < positions.size(); ++i)
    for_each_result(positions[i], [&](std::size_t k, std::optional<double> x) {
      if (!x) return;
      if (!lowest[k] || *x < lowest[k]->value) lowest[k] = {i, *x};
      if (!highest[k] || *x > highest[k]->value) highest[k] = {i, *x};
    });
  std::vector<std::size_t> places;
  for (const auto* of : {&lowest, &highest})
    for (const auto& extreme : *of)
      if (extreme) places.push_back(extreme->place);
  return places;
}

}  // namespace

ShownTargets shown_targets(const iso230_2::Evaluation& evaluation) {
  const auto& positions = evaluation.positions;
  const std::size_t count = positions.size();
  ShownTargets shown;
  const std::size_t step = count <= most_shown_whole ? 1 : (count + about_shown - 1) / about_shown;
  for (std::size_t i = 0; i < count; i += step) shown.places.push_back(i);
  if (step == 1) return shown;
  const auto extremes = places_of_extremes(positions);
  shown.places.insert(shown.places.end(), extremes.begin(), extremes.end());
  shown.places.push_back(count - 1);
  std::ranges::sort(shown.places);
  const auto doubled = std::ranges::unique(shown.places);
  shown.places.erase(doubled.begin(), doubled.end());
  shown.note = fmt::format(
      "One target in {} of {} stands here, with the first, the last and those at which a result of clause 3 is the "
      "lowest or the highest; CSV and JSON have these results of all targets, the file of the test has all readings",
      step, count);
  return shown;
}

}  // namespace axiometry::report
