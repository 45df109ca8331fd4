// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/capture/captured_conditions.h"

namespace axiometry::capture {
namespace {

constexpr double share_to_tell = 0.5;   // of the scatter between the runs
constexpr double least_to_tell = 0.05;  // µm or ″

/// s of the readings of one target from one direction, over all of them; nothing where no approach came twice.
std::optional<double> scatter_between_runs(const CaptureResult& result) {
  struct Cell {
    double count = 0.0, sum = 0.0, squares = 0.0;
  };
  std::map<std::pair<std::size_t, Direction>, Cell> cells;
  for (const CapturedReading& r : result.readings) {
    Cell& cell = cells[{r.approach.target, r.approach.direction}];
    const double x = r.deviation.in_native();
    cell.count += 1.0;
    cell.sum += x;
    cell.squares += x * x;
  }
  double squares = 0.0, freedom = 0.0;
  for (const auto& [approach, cell] : cells) {
    squares += std::max(0.0, cell.squares - cell.sum * cell.sum / cell.count);
    freedom += cell.count - 1.0;
  }
  if (freedom < 1.0) return std::nullopt;
  return std::sqrt(squares / freedom);
}

/// What the samples leave in a reading, in µm or ″.
struct LeftInReading {
  double samples = 0.0;  ///< s of the samples
  double noise = 0.0;    ///< s of a mean of them
  double step = 0.0;     ///< q
  double rounding = 0.0;
};

/// Samples are taken as independent where too few cells tell how alike they are. Rounding to steps of q leaves q/√12
/// where nothing moves the samples; noise of σ takes exp(−2 π² σ²/q²) of that away, the first harmonic of the rounding.
LeftInReading left_in_reading(const CaptureResult& result, AxisKind kind) {
  double samples = 0.0, alone = 0.0, rounding = 0.0, cells = 0.0;
  RestScatter scatter;
  const double q = result.readings.back().standstill.step.in_native();  // of all that was seen
  for (const CapturedReading& r : result.readings) {
    const double s = r.standstill.spread.in_native();
    samples += s * s;
    if (r.standstill.count > 0) alone += s * s / static_cast<double>(r.standstill.count);
    scatter += r.standstill.scatter;
    cells += static_cast<double>(r.standstill.scatter.cells);
    if (!(q > 0.0)) continue;
    const double dither = std::max(0.0, s * s / (q * q) - 1.0 / 12.0);
    const double left = q / std::sqrt(12.0) * std::exp(-2.0 * std::numbers::pi * std::numbers::pi * dither);
    rounding += left * left;
  }
  const auto readings = static_cast<double>(result.readings.size());
  const double scale = deviation_per_position(kind);
  const double of_cells = deviation_of_mean(scatter, cells / readings);
  return {scale * std::sqrt(samples / readings), scale * std::max(of_cells, std::sqrt(alone / readings)), scale * q,
          scale * std::sqrt(rounding / readings)};
}

std::optional<SourceRemark> overshoot_remark(const Plan& plan, const CaptureResult& result) {
  double most = 0.0;
  std::size_t count = 0;
  for (const CapturedReading& r : result.readings) {
    if (r.standstill.beyond <= r.standstill.threshold) continue;
    ++count;
    most = std::max(most, r.standstill.beyond.in_native());
  }
  if (count == 0) return std::nullopt;
  return SourceRemark{
      false, fmt::format("at {} of {} approaches the axis went beyond where it came to rest, by {} {} at most: they "
                         "count in the direction of the way there",
                         count, result.readings.size(), format_fixed(most * deviation_per_position(plan.axis.kind), 1),
                         deviation_unit(plan.axis.kind))};
}

}  // namespace

std::vector<SourceRemark> rest_remarks(const Plan& plan, const CaptureResult& result) {
  std::vector<SourceRemark> remarks;
  if (result.readings.empty()) return remarks;
  if (auto overshoot = overshoot_remark(plan, result)) remarks.push_back(std::move(*overshoot));
  const auto between_runs = scatter_between_runs(result);
  if (!between_runs) return remarks;
  const LeftInReading left = left_in_reading(result, plan.axis.kind);
  const std::string_view unit = deviation_unit(plan.axis.kind);
  const double least = std::max(share_to_tell * *between_runs, least_to_tell);
  if (left.rounding >= least)
    remarks.push_back({false, fmt::format("the samples come in steps of {1:.3g} {0}, which leaves {2:.3g} {0} in a "
                                          "reading, beside a scatter between runs of {3:.3g} {0}: R and A hold what "
                                          "was rounded",
                                          unit, left.step, left.rounding, *between_runs)});
  if (left.noise >= least && left.noise > left.rounding)
    remarks.push_back(
        {false, fmt::format("samples at rest scatter by s = {1:.3g} {0}, which leaves {2:.3g} {0} in a reading of a "
                            "scatter between runs of {3:.3g} {0}: R and A hold the noise of the recording",
                            unit, left.samples, left.noise, *between_runs)});
  return remarks;
}

}  // namespace axiometry::capture
