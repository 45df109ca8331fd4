// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/plan/targets.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "axiometry/base/text/number_text.h"
#include "axiometry/numeric/random/random.h"
#include "axiometry/standards/iso230_2/programme.h"

namespace axiometry::iso230_2 {
namespace {

constexpr std::size_t attempts = 64;      // a place of which a part f is free is missed with (1 − f)⁶⁴
constexpr double steps_per_interval = 8;  // 0.4 p between neighbours are three steps then
constexpr double beside_principal = 0.1;  // share of p: a principal position may be 0.2 p from that of its neighbour
constexpr std::uint64_t segment_draws = std::uint64_t{1} << 32;  // streams of targets added for a segment

struct Window {
  double low = 0.0;
  double high = 0.0;
};

/// k/1000, not k·0.001, is the double that "12.345" reads as.
double rounded(double x, double step) {
  const double per_unit = std::round(1.0 / step);
  const bool decimal = per_unit >= 1.0 && std::abs(per_unit * step - 1.0) < 1e-9;
  return decimal ? std::round(x * per_unit) / per_unit : std::round(x / step) * step;
}

double rounded_into(const Window& window, double x, double step) {
  const double nearest = rounded(x, step);
  const double slack = 1e-9 * step;
  if (nearest > window.high + slack) return rounded(x - 0.5 * step, step);
  return nearest < window.low - slack ? rounded(x + 0.5 * step, step) : nearest;
}

class Drawing {
 public:
  Drawing(const TargetGrid& grid, std::span<const double> points, std::uint64_t seed, std::uint64_t stream)
      : grid_(grid), points_(points.begin(), points.end()), seed_(seed), stream_(stream) {
    std::ranges::sort(points_);
  }

  std::vector<Position> draw() {
    const std::vector<std::optional<double>> fixed = principals();
    for (std::size_t i = 0; i < grid_.count; ++i)
      targets_.push_back(fixed[i] ? principal(*fixed[i], i) : drawn(window(i), i));
    if (grid_.segment > 0.0) fill_segments();
    std::vector<Position> positions;
    for (double x : targets_) positions.push_back(Position::native(x));
    return positions;
  }

 private:
  Window window(std::size_t i) const {
    const double at = grid_.at(i);
    if (grid_.without_end || (i > 0 && i + 1 < grid_.count)) return {at - grid_.shift, at + grid_.shift};
    return i == 0 ? Window{at, at + grid_.shift_inwards} : Window{at - grid_.shift_inwards, at};
  }

  /// Farther than `distance` from every sampling point of the compensation.
  bool free(double x, double distance) const {
    const auto above = std::ranges::lower_bound(points_, x);
    return (above == points_.end() || *above - x > distance) &&
           (above == points_.begin() || x - *std::prev(above) > distance);
  }

  double drawn(const Window& window, std::uint64_t target) const {
    double x = 0.0;
    std::uint64_t block = 0;
    for (double distance : {(window.high - window.low) / 40.0, same_position.in_native()})
      for (std::size_t attempt = 0; attempt < attempts; ++attempt) {
        double u = 0.0;
        numeric::fill_uniform({seed_, (stream_ << 40) + target, block++}, {&u, 1});
        x = rounded_into(window, window.low + u * (window.high - window.low), grid_.step);
        if (free(x, std::max(distance, same_position.in_native()))) return x;
      }
    return x;
  }

  double principal(double x, std::uint64_t target) const {
    if (free(x, same_position.in_native())) return x;
    const double aside = std::min(at_principal.in_native(), beside_principal * grid_.interval);
    const double low = grid_.without_end || x - aside >= grid_.first ? aside : 0.0;
    const double high = grid_.without_end || x + aside <= grid_.last() ? aside : 0.0;
    return drawn({x - low, x + high}, target);
  }

  /// Which targets are multiples of 90°: for each of these the nearest target, unless another took it.
  std::vector<std::optional<double>> principals() const {
    std::vector<std::optional<double>> fixed(grid_.count);
    if (!grid_.principal_positions) return fixed;
    const double end = grid_.last() + (grid_.without_end ? 0.5 * grid_.interval : 0.0);
    for (double x = std::ceil(grid_.first / 90.0) * 90.0; x <= end; x += 90.0) {
      const double index = std::round((x - grid_.first) / grid_.interval);
      const auto i = std::min(static_cast<std::size_t>(std::max(index, 0.0)), grid_.count - 1);
      const auto farther = [&](double other) { return std::abs(other - grid_.at(i)) > std::abs(x - grid_.at(i)); };
      if (!fixed[i] || farther(*fixed[i])) fixed[i] = x;
    }
    return fixed;
  }

  /// One target more, in the middle of what the measurement travel has of it, for each segment without one.
  void fill_segments() {
    const double first = grid_.first, last = grid_.last();
    const std::vector<double> before = targets_;
    for (double k = std::floor((first - grid_.segments_from) / grid_.segment);; ++k) {
      const Window segment{std::max(first, grid_.segments_from + k * grid_.segment),
                           std::min(last, grid_.segments_from + (k + 1.0) * grid_.segment)};
      if (segment.low >= last) break;
      const auto inside = std::ranges::lower_bound(before, segment.low);
      const bool has_one = inside != before.end() && *inside < segment.high;
      const double margin = 0.2 * (segment.high - segment.low);
      if (has_one || margin < grid_.step) continue;
      targets_.push_back(
          drawn({segment.low + margin, segment.high - margin}, segment_draws + static_cast<std::uint64_t>(k + 0x1p20)));
    }
    std::ranges::sort(targets_);
  }

  const TargetGrid& grid_;
  std::vector<double> points_;
  std::uint64_t seed_;
  std::uint64_t stream_;
  std::vector<double> targets_;
};

}  // namespace

Result<std::vector<Position>> draw_targets(const TargetGrid& grid, std::span<const double> compensation_points,
                                           std::uint64_t seed, std::uint64_t stream) {
  if (grid.count > 1 && grid.interval < steps_per_interval * grid.step)
    return fail(fmt::format("found room for {} targets every {}, expected an interval of at least {} (eight steps)",
                            grid.count, format_exact(grid.interval), format_exact(steps_per_interval * grid.step)));
  return Drawing(grid, compensation_points, seed, stream).draw();
}

}  // namespace axiometry::iso230_2
