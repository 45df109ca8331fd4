// SPDX-License-Identifier: Apache-2.0
#include "axiometry/capture/dynamics/motion_spectrum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/numeric/median.h"
#include "axiometry/numeric/series/fourier.h"

namespace axiometry::capture {
namespace {

constexpr double recordings_of_false_peak = 100.0;
constexpr double floor_sigmas = 1.8;         // of the floor's own uncertainty, by which a threshold is higher
constexpr double rounding = 1e-13;           // of the largest value: what sums of equal ones leave is no vibration
constexpr double lines_of_resolution = 2.0;  // half the main lobe of Hann's window, in 1/T
constexpr std::size_t values_least = 16;
constexpr std::size_t judged_per_shown = 10;  // so that many peaks take no time beyond measure
constexpr int refinements = 16;               // of a golden section: 5·10⁻⁴ of the interval
constexpr std::size_t turns_at_once = 256;    // of a phase that is turned on, before it is computed anew

/// Values less their mean in Hann's window, so that nothing is left at 0 Hz, times that window; and what divides the
/// sums.
struct Windowed {
  std::vector<double> values;
  double scale = 0.0;  // 2/Σ w
};

Windowed windowed(std::span<const double> values) {
  const auto n = static_cast<double>(values.size());
  Windowed result;
  double sum = 0.0, mean = 0.0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double w = 0.5 - 0.5 * std::cos(2.0 * std::numbers::pi * (static_cast<double>(k) + 0.5) / n);
    sum += w;
    mean += w * values[k];
    result.values.push_back(w);
  }
  mean /= sum;
  for (std::size_t k = 0; k < values.size(); ++k) result.values[k] *= values[k] - mean;
  result.scale = 2.0 / sum;
  return result;
}

/// At any frequency, in cycles a sample: a direct sum.
double amplitude_at(const Windowed& w, double cycles) {
  std::complex<double> sum, phase;
  const std::complex<double> turn = std::polar(1.0, -2.0 * std::numbers::pi * cycles);
  for (std::size_t k = 0; k < w.values.size(); ++k) {
    phase = k % turns_at_once == 0
                ? std::polar(1.0, -2.0 * std::numbers::pi * std::fmod(cycles * static_cast<double>(k), 1.0))
                : phase * turn;
    sum += w.values[k] * phase;
  }
  return w.scale * std::abs(sum);
}

/// The highest amplitude between two frequencies with one peak between them: a golden section.
SpectrumPeak highest_between(const Windowed& w, double low, double high) {
  constexpr double golden = 1.0 / std::numbers::phi;
  double a = high - golden * (high - low), b = low + golden * (high - low);
  double at_a = amplitude_at(w, a), at_b = amplitude_at(w, b);
  for (int k = 0; k < refinements; ++k) {
    if (at_a > at_b) {
      high = b;
      b = a, at_b = at_a;
      a = high - golden * (high - low), at_a = amplitude_at(w, a);
    } else {
      low = a;
      a = b, at_a = at_b;
      b = low + golden * (high - low), at_b = amplitude_at(w, b);
    }
  }
  return at_a > at_b ? SpectrumPeak{a, at_a} : SpectrumPeak{b, at_b};
}

/// What a peak at most leaves d steps of 1/T beside it, as a share of itself: |sin(π d)/(π d (1 − d²))| of Hann's
/// window.
double share_beside(double d) { return 1.0 / (std::numbers::pi * d * (d * d - 1.0)); }

/// And of what is slower than the resolution, a drift or a bend, by 1/d³ as of a ramp: found to lie below this share.
double share_of_drift(double d) { return 2.0 / (d * d * d); }

/// The level of the noise in a band.
struct Band {
  double log_frequency = 0.0;  // of its middle, in lines
  double log_power = 0.0;      // of the mean square: median/ln 2, squares of amplitudes of noise being exponential
  double sigma = 0.0;          // of log_power
};

Band band_between(const MotionSpectrum& s, std::size_t low, std::size_t high) {
  // The median of m lines of 1/T knows the logarithm to 1.7/√m: 1.44/√m of independent ones, Hann's being not.
  constexpr double sigma_of_one = 1.7;
  const auto begin = s.amplitudes.begin() + static_cast<std::ptrdiff_t>(low);
  const auto width = static_cast<std::ptrdiff_t>(high - low);
  const double median =
      std::max(numeric::upper_median(std::vector<double>(begin, begin + width)), std::numeric_limits<double>::min());
  const double lines = lines_of_resolution * s.step_hz * static_cast<double>(width) / s.resolution_hz;
  return {std::log(0.5 * static_cast<double>(low + high)), 2.0 * std::log(median) - std::log(std::numbers::ln2),
          sigma_of_one / std::sqrt(lines)};
}

/// Whether their levels differ by more than what they are known to.
bool differ(std::span<const Band> bands) {
  constexpr double chance = 0.001;
  if (bands.size() < 2) return false;
  double mean = 0.0, squares = 0.0;
  for (const Band& band : bands) mean += band.log_power / static_cast<double>(bands.size());
  for (const Band& band : bands) squares += std::pow((band.log_power - mean) / band.sigma, 2);
  return squares > numeric::chi_square_quantile(1.0 - chance, static_cast<double>(bands.size() - 1));
}

/// As wide as a quarter of their lower end, which tells the level best, or 16/T each where the parts of any differ:
/// what was averaged or held has gaps in its spectrum, and the median of a band that holds one is not the level beside
/// it.
std::vector<Band> noise_bands(const MotionSpectrum& s) {
  constexpr double band_resolutions = 8.0, band_ratio = 1.25;
  const std::size_t count = s.amplitudes.size();
  const double resolution = s.resolution_hz / s.step_hz;
  const auto least = static_cast<std::size_t>(std::ceil(band_resolutions * resolution));
  std::vector<Band> wide, narrow;
  bool has_gaps = false;
  for (auto low = static_cast<std::size_t>(std::ceil(resolution)); low < count;) {
    std::size_t high = std::max(low + least, static_cast<std::size_t>(band_ratio * static_cast<double>(low)) + 1);
    if (high + least > count) high = count;
    const std::size_t parts = std::max<std::size_t>((high - low) / least, 1), before = narrow.size();
    for (std::size_t k = 0; k < parts; ++k)
      narrow.push_back(band_between(s, low + (high - low) * k / parts, low + (high - low) * (k + 1) / parts));
    has_gaps = has_gaps || differ(std::span(narrow).subspan(before));
    wide.push_back(band_between(s, low, high));
    low = high;
  }
  return has_gaps ? narrow : wide;
}

/// Floors and thresholds: straight lines of log power over log frequency between the bands; below the first they go on,
/// where that rises, for what drifts has its most there, and are known the worse.
void find_noise(MotionSpectrum& s, double least) {
  const std::vector<Band> bands = noise_bands(s);
  // Exceeded by one line of a mean square 1 with the probability 1/(100 N); z: what the floor may be wrong by.
  const double power = std::log(recordings_of_false_peak * static_cast<double>(s.amplitudes.size()));
  std::size_t at = 0;
  for (std::size_t k = 0; k < s.amplitudes.size(); ++k) {
    const double x = std::log(std::max<double>(1.0, static_cast<double>(k)));
    while (at + 2 < bands.size() && x > bands[at + 1].log_frequency) ++at;
    Band here = bands[at];
    if (bands.size() > 1) {
      const Band& next = bands[at + 1];
      const double across = next.log_frequency - here.log_frequency;
      const double off = (x - here.log_frequency) / across;
      const double rise = next.log_power - here.log_power;
      if (off < 0.0) {
        here.log_power += off * std::min(rise, 0.0);
        here.sigma = std::hypot(here.sigma, off * std::hypot(here.sigma, next.sigma));
      } else {
        here.log_power += std::min(off, 1.0) * rise;
        here.sigma += std::min(off, 1.0) * (next.sigma - here.sigma);
      }
    }
    s.floors.push_back(std::exp(0.5 * here.log_power));
    s.thresholds.push_back(
        std::max(least, std::sqrt(power) * std::exp(0.5 * (here.log_power + floor_sigmas * here.sigma))));
  }
}

struct PeakPlaces {
  std::vector<std::size_t> kept;  // numbers of amplitudes
  std::size_t beside = 0;
};

/// The amplitudes that are the highest within the resolution about them, highest first.
PeakPlaces places_of_peaks(const MotionSpectrum& s, std::size_t most) {
  const std::span<const double> a = s.amplitudes;
  const auto apart = static_cast<std::size_t>(std::ceil(s.resolution_hz / s.step_hz));
  std::vector<std::size_t> places;
  for (std::size_t k = apart; k + 1 < a.size(); ++k)
    if (a[k] > s.thresholds[k] && a[k] >= a[k - 1] && a[k] > a[k + 1]) places.push_back(k);
  std::ranges::stable_sort(places, [&](std::size_t i, std::size_t k) { return a[i] > a[k]; });
  const double drift = std::ranges::max(a.first(std::min(apart, a.size())));
  PeakPlaces found;
  std::vector<std::size_t>& kept = found.kept;
  for (const std::size_t k : places) {
    if (kept.size() == most) break;
    const double steps_per_line = lines_of_resolution * s.step_hz / s.resolution_hz;
    double left_of_others = drift * share_of_drift(steps_per_line * static_cast<double>(k));
    bool beside = false;
    for (const std::size_t other : kept) {
      const std::size_t steps = k > other ? k - other : other - k;
      beside = beside || steps < apart;
      if (!beside) left_of_others += a[other] * share_beside(steps_per_line * static_cast<double>(steps));
    }
    if (beside) continue;
    if (a[k] > 2.0 * left_of_others)
      kept.push_back(k);
    else
      ++found.beside;
  }
  return found;
}

}  // namespace

MotionSpectrum motion_spectrum(std::span<const double> values, const SpectrumOptions& options) {
  const double rate_hz = options.rate_hz;
  AXIOMETRY_CONTRACT(values.size() >= values_least && rate_hz > 0.0);
  const Windowed w = windowed(values);
  const std::size_t size = std::bit_ceil(2 * values.size());
  std::vector<std::complex<double>> sums(w.values.begin(), w.values.end());
  sums.resize(size);
  numeric::FourierTransform{size}(sums);
  MotionSpectrum spectrum;
  spectrum.step_hz = rate_hz / static_cast<double>(size);
  spectrum.resolution_hz = lines_of_resolution * rate_hz / static_cast<double>(values.size());
  for (std::size_t k = 0; k <= size / 2; ++k) spectrum.amplitudes.push_back(w.scale * std::abs(sums[k]));
  double largest = 0.0;
  for (const double x : values) largest = std::max(largest, std::abs(x));
  find_noise(spectrum, std::max(rounding * largest, options.least));
  const auto first = static_cast<std::ptrdiff_t>(std::ceil(spectrum.resolution_hz / spectrum.step_hz));
  spectrum.floor = *std::min_element(spectrum.floors.begin() + first, spectrum.floors.end());
  spectrum.threshold = *std::min_element(spectrum.thresholds.begin() + first, spectrum.thresholds.end());
  const PeakPlaces places = places_of_peaks(spectrum, judged_per_shown * options.most_peaks);
  const std::size_t shown = std::min(places.kept.size(), options.most_peaks);
  spectrum.peaks_more = places.kept.size() - shown;
  spectrum.peaks_beside = places.beside;
  const double line = 1.0 / static_cast<double>(size);
  for (const std::size_t k : std::span(places.kept).first(shown)) {
    const double at = static_cast<double>(k) * line;
    SpectrumPeak peak = highest_between(w, at - line, at + line);
    peak.frequency_hz *= rate_hz;
    spectrum.peaks.push_back(peak);
  }
  std::ranges::stable_sort(spectrum.peaks, std::greater{}, &SpectrumPeak::amplitude);
  return spectrum;
}

}  // namespace axiometry::capture
