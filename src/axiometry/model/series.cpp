// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/series.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "axiometry/base/counted.h"
#include "axiometry/base/reading_limits.h"

namespace axiometry {
namespace {

constexpr std::size_t cell_limit = std::size_t{1} << 28;  // 2 GiB of doubles: a wrong index, not a test

Result<void> check_targets(std::span<const Position> targets) {
  if (targets.size() < 2)
    return fail(fmt::format("found {}, expected at least 2", counted(targets.size(), "target position")));
  for (std::size_t i = 0; i < targets.size(); ++i) {
    if (!(std::abs(targets[i].in_native()) <= largest_stated))
      return fail(fmt::format("found target {} at {}, expected a magnitude up to 1e9", i + 1, targets[i].in_native()));
    if (i > 0 && !(targets[i - 1] < targets[i]))
      return fail(fmt::format("found target {} at {} after target {} at {}, expected ascending positions", i + 1,
                              targets[i].in_native(), i, targets[i - 1].in_native()));
  }
  return {};
}

Result<void> check_readings(std::span<const double> deviations, std::span<const Position> targets, std::size_t runs) {
  const std::size_t m = targets.size();
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    const double x = deviations[k];
    if (std::isnan(x) || std::abs(x) <= largest_stated) continue;
    return fail(fmt::format("found deviation {} at target {}{} run {}, expected a magnitude up to 1e9", x,
                            targets[k / runs % m].in_native(), arrow(static_cast<Direction>(k / runs / m)),
                            k % runs + 1));
  }
  for (std::size_t i = 0; i < m; ++i) {
    bool measured = false;
    for (std::size_t d = 0; d < 2 && !measured; ++d)
      for (std::size_t j = 0; j < runs && !measured; ++j) measured = !std::isnan(deviations[(d * m + i) * runs + j]);
    if (!measured)
      return fail(fmt::format("found no reading at target {}, expected at least one", targets[i].in_native()));
  }
  return {};
}

}  // namespace

std::string_view arrow(Direction direction) { return direction == Direction::up ? "↑" : "↓"; }

Result<Series> Series::make(std::vector<Position> targets, std::span<const Reading> readings) {
  AXIOMETRY_TRY_VOID(check_targets(targets));
  const std::size_t m = targets.size();
  const std::size_t run_limit = cell_limit / (2 * m);
  std::size_t runs = 0;
  for (const Reading& r : readings) {
    if (r.run >= run_limit)
      return fail(fmt::format("found run index {}, expected one below {} for {} targets", r.run, run_limit, m));
    runs = std::max(runs, r.run + 1);
  }
  std::vector<double> deviations(2 * m * runs, std::numeric_limits<double>::quiet_NaN());
  for (const Reading& r : readings) {
    if (r.target >= m)
      return fail(fmt::format("found a reading of target number {}, expected at most {}", r.target + 1, m));
    const auto d = static_cast<std::size_t>(r.direction);
    const double x = r.deviation.in_native();
    if (!std::isfinite(x))
      return fail(fmt::format("found a deviation that is not finite at target {}{} run {}, expected a number",
                              targets[r.target].in_native(), arrow(r.direction), r.run + 1));
    double& slot = deviations[(d * m + r.target) * runs + r.run];
    if (!std::isnan(slot))
      return fail(fmt::format("found a second reading of target {}{} run {}, expected one",
                              targets[r.target].in_native(), arrow(r.direction), r.run + 1));
    slot = x;
  }
  AXIOMETRY_TRY_VOID(check_readings(deviations, targets, runs));
  return Series(std::move(targets), runs, std::move(deviations));
}

Result<Series> Series::make_dense(std::vector<Position> targets, std::size_t runs, std::vector<double> deviations) {
  AXIOMETRY_TRY_VOID(check_targets(targets));
  const std::size_t cells = 2 * targets.size();
  if (deviations.size() % cells != 0 || deviations.size() / cells != runs)
    return fail(fmt::format("found {} deviations, expected 2 directions × {} targets × {} runs", deviations.size(),
                            targets.size(), runs));
  AXIOMETRY_TRY_VOID(check_readings(deviations, targets, runs));
  return Series(std::move(targets), runs, std::move(deviations));
}

std::optional<Deviation> Series::reading(std::size_t target, Direction direction, std::size_t run) const {
  const double x = cell(target, direction)[run];
  if (std::isnan(x)) return std::nullopt;
  return Deviation::native(x);
}

std::size_t Series::count(std::size_t target, Direction direction) const {
  std::size_t n = 0;
  for (double x : cell(target, direction)) n += !std::isnan(x);
  return n;
}

bool Series::has(Direction direction) const {
  for (std::size_t i = 0; i < target_count(); ++i)
    if (count(i, direction) > 0) return true;
  return false;
}

std::size_t Series::reading_count() const {
  std::size_t n = 0;
  for (double x : deviations_) n += !std::isnan(x);
  return n;
}

}  // namespace axiometry
