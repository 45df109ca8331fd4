// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/series/approaches.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <string_view>

#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/series/series_order.h"
#include "axiometry/formats/series/target_index.h"

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
  bool enter(const ListedReading& a, std::size_t target) {
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
    if (auto remark = backwards()) return GatheredSeries{std::move(series), {}, std::move(remark)};
    for (double& t : times_s_) t -= *begin;
    return GatheredSeries{std::move(series), std::move(times_s_)};
  }

 private:
  std::optional<SourceRemark> backwards() const {
    if (auto remark = run_before_earlier_run()) return remark;
    return run_in_no_order();
  }

  SourceRemark left_out(std::string_view what) const {
    return {false, fmt::format("found time running backwards: {}; the times of the readings are left out", what)};
  }

  /// The first reading that was taken before that of an earlier run.
  std::optional<SourceRemark> run_before_earlier_run() const {
    for (std::size_t cell = 0; cell < 2 * targets_; ++cell) {
      std::optional<std::size_t> before;
      for (std::size_t j = 0; j < runs_; ++j) {
        const std::size_t place = cell * runs_ + j;
        if (std::isnan(times_s_[place])) continue;
        if (before && times_s_[place] < times_s_[*before])
          return left_out(fmt::format("run {} is {:.4g} s before run {} at the same target", j + 1,
                                      times_s_[*before] - times_s_[place], *before - cell * runs_ + 1));
        before = place;
      }
    }
    return std::nullopt;
  }

  /// The first run in a direction whose times neither only rise nor only fall along the targets.
  std::optional<SourceRemark> run_in_no_order() const {
    for (Direction direction : {Direction::up, Direction::down})
      for (std::size_t j = 0; j < runs_; ++j) {
        std::vector<double> times_s;
        for (std::size_t i = 0; i < targets_; ++i) {
          const double t = times_s_[(static_cast<std::size_t>(direction) * targets_ + i) * runs_ + j];
          if (!std::isnan(t)) times_s.push_back(t);
        }
        if (std::ranges::is_sorted(times_s) || std::ranges::is_sorted(times_s, std::ranges::greater{})) continue;
        return left_out(
            fmt::format("those of run {} {} neither rise nor fall along the targets", j + 1, arrow(direction)));
      }
    return std::nullopt;
  }

  std::size_t targets_;
  std::size_t runs_;
  std::vector<double> deviations_;
  std::vector<double> times_s_;
};

}  // namespace

Result<GatheredSeries> gathered(std::span<const ListedReading> approaches) {
  TargetIndex index;
  std::vector<std::uint32_t> numbers;
  std::size_t runs = 0;
  numbers.reserve(approaches.size());
  for (const ListedReading& a : approaches) {
    numbers.push_back(index.number(a.target.in_native()));
    runs = std::max(runs, a.run);
  }
  const std::size_t m = index.targets().size();
  AXIOMETRY_TRY_VOID(check_grid({.targets = m, .runs = runs, .readings = approaches.size()}));
  const std::span<const std::uint32_t> ranks = index.ranks();
  std::vector<Position> targets(m);
  for (std::size_t k = 0; k < m; ++k) targets[ranks[k]] = Position::native(index.targets()[k]);
  ReadingGrid grid(m, runs,
                   std::ranges::any_of(approaches, [](const ListedReading& a) { return !std::isnan(a.time_s); }));
  for (std::size_t k = 0; k < approaches.size(); ++k) {
    const ListedReading& a = approaches[k];
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
