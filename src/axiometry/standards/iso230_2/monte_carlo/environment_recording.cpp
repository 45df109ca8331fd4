// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/monte_carlo/environment_recording.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <span>

namespace axiometry {
namespace {

constexpr std::size_t lags = 65;
constexpr std::size_t windows_per_length = 4;
constexpr std::size_t most_in_spectrum = 4096;

double range_of(std::span<const double> values) {
  const auto [least, most] = std::ranges::minmax(values);
  return most - least;
}

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// The interval of a recording that has enough values and one.
std::optional<double> usable_step_s(const GumInputs& given) {
  const bool usable = given.drift_recording.size() >= least_recorded_values && given.drift_interval &&
                      given.drift_interval->in_s() > 0.0;
  return usable ? std::optional(given.drift_interval->in_s()) : std::nullopt;
}

/// Divided by the number of all values at every lag, so that it is that of some process.
double covariance_at(std::span<const double> values, double mean, std::size_t lag) {
  double sum = 0.0;
  for (std::size_t k = lag; k < values.size(); ++k) sum += (values[k] - mean) * (values[k - lag] - mean);
  return sum / double(values.size());
}

}  // namespace

std::optional<RecordedEnvironment> recorded_environment(const Metadata& metadata, const TestCourse& course) {
  const std::span<const double> values = metadata.gum.drift_recording;
  const auto usable = usable_step_s(metadata.gum);
  if (!usable) return std::nullopt;
  const double step_s = *usable;
  const double test_s = course.duration ? course.duration->in_s() : step_s * double(values.size());
  RecordedEnvironment found;
  const double steps = std::min(double(values.size() - 1), std::ceil(test_s / step_s));
  const std::size_t length = std::max<std::size_t>(2, static_cast<std::size_t>(steps) + 1);
  found.whole = length == values.size();
  found.length_s = step_s * double(length - 1);
  const std::size_t stride = std::max<std::size_t>(1, length / windows_per_length);
  for (std::size_t begin = 0; begin + length <= values.size(); begin += stride, ++found.windows) {
    const double range = range_of(values.subspan(begin, length));
    if (range > found.range) found.widest_from_s = step_s * double(begin);
    found.range = std::max(found.range, range);
  }
  const double mean = mean_of(values);
  double squares = 0.0;
  for (std::size_t k = 1; k < values.size(); ++k) squares += (values[k] - values[k - 1]) * (values[k] - values[k - 1]);
  const double all = covariance_at(values, mean, 0);
  const double white = std::min(all, 0.5 * squares / double(values.size() - 1));
  found.white_sd = std::sqrt(white);
  for (std::size_t lag = 0; lag < lags; ++lag) {
    const double place = double(length - 1) * double(lag) / double(lags - 1);
    const auto left = static_cast<std::size_t>(place);
    const double part = place - double(left);
    const auto at = [&](std::size_t k) {
      return k == 0 ? all - white : k < values.size() ? covariance_at(values, mean, k) : 0.0;
    };
    found.covariance.push_back((1.0 - part) * at(left) + part * at(left + 1));
  }
  return found;
}

std::vector<RecordedSinusoid> recorded_spectrum(const Metadata& metadata) {
  const auto usable = usable_step_s(metadata.gum);
  if (!usable) return {};
  const auto& all = metadata.gum.drift_recording;
  const std::size_t stride = 1 + (all.size() - 1) / most_in_spectrum;
  std::vector<double> values;
  for (std::size_t k = 0; k < all.size(); k += stride) values.push_back(all[k]);
  const double step_s = *usable * double(stride);
  const auto count = double(values.size());
  const double mean = mean_of(values);
  std::vector<RecordedSinusoid> sinusoids;
  for (std::size_t periods = 1; 2 * periods <= values.size(); ++periods) {
    const std::complex<double> turn = std::polar(1.0, 2.0 * std::numbers::pi * double(periods) / count);
    std::complex<double> phase = 1.0, sum = 0.0;
    for (double x : values) {
      sum += (x - mean) * phase;
      phase *= turn;
    }
    // Of the shortest period, of two steps, one value is high and the next low: cosine alone, counted once.
    const double scale = 2 * periods == values.size() ? std::numbers::sqrt2 : 2.0;
    sinusoids.push_back({step_s * count / double(periods), scale * std::abs(sum) / count});
  }
  return sinusoids;
}

}  // namespace axiometry
