// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/dynamics/uniform_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "axiometry/numeric/median.h"

namespace axiometry::capture {
namespace {

constexpr std::size_t windows_of_stretch = 10;
constexpr double noises_of_motion = 10.0;
constexpr double slid_off = 1e-6;  // of the highest velocity: sums that slid off a fast motion leave less

/// Lowest, highest, and the sum of squares about zero.
struct Extent {
  double low = std::numeric_limits<double>::infinity(), high = -low, squares = 0.0;
  void see(double x) {
    low = std::min(low, x);
    high = std::max(high, x);
    squares += x * x;
  }
  double range() const { return high - low; }
};

/// x = a + b i about the middle, so that a long way costs no digits.
void fit_line(std::span<const double> x, double rate, UniformStretch& stretch) {
  const auto n = static_cast<double>(x.size());
  const double middle = (n - 1.0) / 2.0;
  double sum = 0.0, linear = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum += x[i] - x[0];
    linear += (static_cast<double>(i) - middle) * (x[i] - x[0]);
  }
  const double per_sample = x.size() < 2 ? 0.0 : linear / (n * (n * n - 1.0) / 12.0);
  stretch.velocity = per_sample * rate;
  stretch.intercept = x[0] + sum / n - middle * per_sample;
}

void describe(const MotionRecord& record, const MotionCourse& course, UniformStretch& stretch) {
  const auto n = static_cast<double>(stretch.count());
  fit_line(std::span(record.positions).subspan(stretch.first, stretch.count()), record.rate_hz, stretch);
  Extent deviation, velocity, acceleration;
  for (const double e : residuals_of(record, stretch)) deviation.see(e);
  double mean = 0.0;
  for (std::size_t k = stretch.first; k <= stretch.last; ++k) mean += course.velocity[k] / n;
  for (std::size_t k = stretch.first; k <= stretch.last; ++k) {
    velocity.see(course.velocity[k] - mean);
    acceleration.see(course.acceleration[k]);
  }
  stretch.deviation_range = deviation.range();
  stretch.deviation_rms = std::sqrt(deviation.squares / n);
  stretch.velocity_range = velocity.range();
  stretch.velocity_deviation = std::sqrt(velocity.squares / (n - 1.0));
  stretch.acceleration_rms = std::sqrt(acceleration.squares / n);
}

/// Without the ends where it still gathers speed, or brakes already: from where it first has the median to where it
/// last has it, and half a window less, into which its smoothed velocity reaches.
void cut_ends(std::span<const double> velocity, double median, std::size_t half_window, UniformStretch& stretch) {
  const auto slower = [&](std::size_t k) { return std::abs(velocity[k]) < std::abs(median); };
  while (stretch.first < stretch.last && slower(stretch.first)) ++stretch.first;
  while (stretch.last > stretch.first && slower(stretch.last)) --stretch.last;
  const std::size_t cut = std::min(half_window, (stretch.last - stretch.first) / 2);
  stretch.first += cut;
  stretch.last -= cut;
}

/// Of samples begin … end − 1, all in one direction, the longest part near their median.
UniformStretch longest_part(const MotionCourse& course, std::size_t begin, std::size_t end, double share) {
  const std::span<const double> velocity = course.velocity;
  const double median = numeric::upper_median(std::vector<double>(velocity.begin() + static_cast<std::ptrdiff_t>(begin),
                                                                  velocity.begin() + static_cast<std::ptrdiff_t>(end)));
  UniformStretch longest{.first = begin, .last = begin};
  for (std::size_t k = begin; k < end;) {
    std::size_t stop = k;
    while (stop < end && std::abs(velocity[stop] - median) <= share * std::abs(median)) ++stop;
    if (stop > k + longest.last - longest.first + 1) longest = {.first = k, .last = stop - 1};
    k = stop + 1;
  }
  cut_ends(velocity, median, course.half_window, longest);
  return longest;
}

}  // namespace

std::vector<double> residuals_of(const MotionRecord& record, const UniformStretch& stretch) {
  std::vector<double> residuals;
  const double per_sample = stretch.velocity / record.rate_hz;
  for (std::size_t i = 0; i < stretch.count(); ++i)
    residuals.push_back(record.positions[stretch.first + i] - stretch.intercept - static_cast<double>(i) * per_sample);
  return residuals;
}

UniformStretch whole_stretch(const MotionRecord& record) {
  UniformStretch whole{.first = 0, .last = record.positions.size() - 1};
  fit_line(record.positions, record.rate_hz, whole);
  return whole;
}

std::vector<UniformStretch> uniform_stretches(const MotionRecord& record, const MotionCourse& course,
                                              const UniformOptions& options) {
  const std::span<const double> v = course.velocity;
  double fastest = 0.0;
  for (const double x : v) fastest = std::max(fastest, std::abs(x));
  const double slowest = std::max(slid_off * fastest, noises_of_motion * course.velocity_noise);
  const std::size_t shortest = windows_of_stretch * (2 * course.half_window + 1);
  std::vector<UniformStretch> stretches;
  for (std::size_t k = 0; k < v.size();) {
    std::size_t end = k;
    while (end < v.size() && std::abs(v[end]) > slowest && (v[end] > 0.0) == (v[k] > 0.0)) ++end;
    if (end - k >= shortest) {
      UniformStretch stretch = longest_part(course, k, end, options.share);
      if (stretch.count() >= shortest) {
        describe(record, course, stretch);
        stretches.push_back(stretch);
      }
    }
    k = std::max(end, k + 1);
  }
  return stretches;
}

}  // namespace axiometry::capture
