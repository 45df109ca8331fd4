// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/approaches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "axiometry/base/number_text.h"
#include "axiometry/formats/series_order.h"
#include "axiometry/formats/target_index.h"

namespace axiometry::formats {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// The earliest of the times; nothing when none is known.
std::optional<double> earliest(std::span<const double> times_s) {
  std::optional<double> first;
  for (double t : times_s)
    if (!std::isnan(t) && !(first && *first <= t)) first = t;
  return first;
}

/// The grid may have many more places than there are readings, so it keeps no more of each than must be.
class ReadingGrid {
 public:
  ReadingGrid(std::size_t targets, std::size_t runs, bool timed)
      : targets_(targets),
        runs_(runs),
        deviations_(2 * targets * runs, missing),
        times_s_(timed ? deviations_.size() : 0, missing) {}

  /// False where there is a reading already.
  bool enter(const Approach& a, std::size_t target) {
    const std::size_t place = (static_cast<std::size_t>(a.direction) * targets_ + target) * runs_ + a.run - 1;
    if (!std::isnan(deviations_[place])) return false;
    deviations_[place] = a.deviation.in_native();
    if (!times_s_.empty()) times_s_[place] = a.time_s;
    return true;
  }

  Result<GatheredSeries> result(std::vector<Position> targets) && {
    AXIOMETRY_TRY(Series series, Series::make_dense(std::move(targets), runs_, std::move(deviations_)));
    const auto begin = earliest(times_s_);
    if (!begin) return GatheredSeries{std::move(series), {}};
    for (double& t : times_s_) t -= *begin;
    return GatheredSeries{std::move(series), std::move(times_s_)};
  }

 private:
  std::size_t targets_;
  std::size_t runs_;
  std::vector<double> deviations_;
  std::vector<double> times_s_;
};

}  // namespace

Result<GatheredSeries> gathered(std::span<const Approach> approaches) {
  TargetIndex index;
  std::vector<std::uint32_t> numbers;
  std::size_t runs = 0;
  numbers.reserve(approaches.size());
  for (const Approach& a : approaches) {
    numbers.push_back(index.number(a.target.in_native()));
    runs = std::max(runs, a.run);
  }
  const std::size_t m = index.targets().size();
  AXIOMETRY_TRY_VOID(check_grid({.targets = m, .runs = runs, .readings = approaches.size()}));
  const std::span<const std::uint32_t> ranks = index.ranks();
  std::vector<Position> targets(m);
  for (std::size_t k = 0; k < m; ++k) targets[ranks[k]] = Position::native(index.targets()[k]);
  ReadingGrid grid(m, runs, std::ranges::any_of(approaches, [](const Approach& a) { return !std::isnan(a.time_s); }));
  for (std::size_t k = 0; k < approaches.size(); ++k) {
    const Approach& a = approaches[k];
    if (grid.enter(a, ranks[numbers[k]])) continue;
    std::size_t first = 0;
    while (numbers[first] != numbers[k] || approaches[first].direction != a.direction || approaches[first].run != a.run)
      ++first;
    return fail(fmt::format("found a second reading of target {}{} run {}, expected only that on line {}",
                            format_exact(a.target.in_native()), arrow(a.direction), a.run, approaches[first].at.line),
                a.at);
  }
  return std::move(grid).result(std::move(targets));
}

}  // namespace axiometry::formats
