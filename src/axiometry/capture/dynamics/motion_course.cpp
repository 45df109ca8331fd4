// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/dynamics/motion_course.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "axiometry/numeric/median.h"

namespace axiometry::capture {
namespace {

constexpr std::size_t half_least = 2, windows_least = 4;
constexpr double usual_s = 0.01;
constexpr double steps_least = 0.005;  // share of third differences that are not 0
constexpr double per_median = 0.6745;  // of the magnitudes of a normal distribution
// Windows slide by sums that are updated; they are made anew so often that rounding stays below 1e-12 of the sums.
constexpr std::size_t slides_at_once = 1024;

struct WindowSums {
  double constant, linear, square;  // Σ y, Σ j y, Σ j² y
};

WindowSums sums_about(std::span<const double> x, std::size_t at, std::size_t h, double level) {
  WindowSums s{0.0, 0.0, 0.0};
  const auto half = static_cast<double>(h);
  for (std::size_t i = 0; i <= 2 * h; ++i) {
    const double j = static_cast<double>(i) - half, y = x[at - h + i] - level;
    s.constant += y;
    s.linear += j * y;
    s.square += j * j * y;
  }
  return s;
}

/// To the next sample: every place of the window becomes one less.
void slide(WindowSums& s, double out, double in, double h) {
  s.square += -h * h * out - 2.0 * s.linear - 2.0 * h * out + (s.constant - out) + h * h * in;
  s.linear += h * out - (s.constant - out) + h * in;
  s.constant += in - out;
}

/// What third differences tell, which are 0 of a parabola.
struct StepNoise {
  double sd = 0.0;          ///< of white noise they have the variance 20 σ²
  double resolution = 0.0;  ///< of values in steps they are whole multiples of one; 0 where they are not
};

StepNoise step_noise(std::span<const double> x) {
  double largest = 0.0;
  for (const double value : x) largest = std::max(largest, std::abs(value));
  const double rounding = 16.0 * std::numeric_limits<double>::epsilon() * largest;
  std::vector<double> steps;
  for (std::size_t k = 3; k < x.size(); ++k) steps.push_back(std::abs(x[k] - x[k - 3] - 3.0 * (x[k - 1] - x[k - 2])));
  double least = std::numeric_limits<double>::infinity();
  std::size_t some = 0;
  for (const double step : steps)
    if (step > rounding) {
      least = std::min(least, step);
      ++some;
    }
  const auto is_multiple = [&](double step) {
    const double times = std::nearbyint(step / least);
    return std::abs(step - times * least) <= (1.0 + times) * rounding;
  };
  StepNoise noise;
  // The corners of a motion without noise are few.
  if (static_cast<double>(some) >= steps_least * static_cast<double>(steps.size()) && some > 0 &&
      std::ranges::all_of(steps, is_multiple))
    noise.resolution = least;
  if (!steps.empty()) noise.sd = numeric::upper_median(std::move(steps)) / per_median / std::sqrt(20.0);
  return noise;
}

double quarter_of(const MotionRecord& record) {
  return static_cast<double>(record.positions.size()) / static_cast<double>(windows_least);
}

/// Of the odd number of samples that is nearest; of a quarter of the record the next one below it.
std::size_t half_of(const MotionRecord& record, double window_s) {
  constexpr double written_to = 1e-5;  // of a window that was read from a message
  const double samples = window_s * record.rate_hz, quarter = quarter_of(record);
  const double nearest = std::max(0.0, std::nearbyint((samples - 1.0) / 2.0));
  const double most = std::max(0.0, std::floor((quarter - 1.0) / 2.0));
  return static_cast<std::size_t>(samples <= quarter * (1.0 + written_to) ? std::min(nearest, most) : nearest);
}

std::string in_seconds(double s) { return fmt::format("{:.6g}", s); }

}  // namespace

double usual_window_s(const MotionRecord& record) {
  const double least = static_cast<double>(2 * half_least + 1) / record.rate_hz;
  const double most = record.duration_s() / static_cast<double>(windows_least);
  return std::max(least, std::min(usual_s, most));
}

Result<MotionCourse> motion_course(const MotionRecord& record, double window_s) {
  const std::span<const double> x = record.positions;
  const bool counts = window_s > 0.0 && window_s * record.rate_hz < 1e9;
  const std::size_t h = counts ? half_of(record, window_s) : 0, n = 2 * h + 1;
  if (h < half_least || n * windows_least > x.size())
    return fail(fmt::format("found a window of {} s, expected {} s (5 samples) to {} s (a quarter of the recording)",
                            in_seconds(window_s), in_seconds(5.0 / record.rate_hz),
                            in_seconds(quarter_of(record) / record.rate_hz)));
  const auto count = static_cast<double>(n), half = static_cast<double>(h);
  const double s2 = half * (half + 1.0) * count / 3.0;
  const double s4 = s2 * (3.0 * half * half + 3.0 * half - 1.0) / 5.0;
  const double rate = record.rate_hz, spread = s4 - s2 * s2 / count;
  MotionCourse course;
  course.half_window = h;
  course.window_s = count / rate;
  course.velocity.resize(x.size());
  course.acceleration.resize(x.size());
  WindowSums sums{};
  const std::size_t last = x.size() - 1 - h;
  double level = 0.0;
  for (std::size_t k = h; k <= last; ++k) {
    if ((k - h) % slides_at_once == 0) {
      level = x[k];
      sums = sums_about(x, k, h, level);
    } else {
      slide(sums, x[k - 1 - h] - level, x[k + h] - level, half);
    }
    course.velocity[k] = sums.linear / s2 * rate;
    course.acceleration[k] = 2.0 * (sums.square - s2 / count * sums.constant) / spread * rate * rate;
  }
  for (std::size_t k = 0; k < h; ++k) {
    const double before_s = static_cast<double>(h - k) / rate;
    const std::size_t end = x.size() - 1 - k;
    course.acceleration[k] = course.acceleration[h];
    course.velocity[k] = course.velocity[h] - before_s * course.acceleration[h];
    course.acceleration[end] = course.acceleration[last];
    course.velocity[end] = course.velocity[last] + before_s * course.acceleration[last];
  }
  const StepNoise noise = step_noise(x);
  const double of_steps = noise.resolution / std::sqrt(12.0);
  course.noise = std::max(noise.sd, of_steps);
  if (of_steps > noise.sd) course.resolution = noise.resolution;
  course.velocity_noise = course.noise / std::sqrt(s2) * rate;
  course.acceleration_noise = 2.0 * course.noise / std::sqrt(spread) * rate * rate;
  return course;
}

}  // namespace axiometry::capture
