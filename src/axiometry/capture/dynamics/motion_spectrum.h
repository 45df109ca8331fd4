// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// Vibrations in equally spaced values: amplitudes by frequency.
///
/// The values less their weighted mean are weighted by Hann's window w, filled up with zeros to a power of two and
/// transformed (FFT); the amplitude at a frequency f is 2 |Σ w_k x_k e^{−2πi f k τ}|/Σ w_k, that of a sinusoid in the
/// values. Noise is told where it is: a random walk has a thousand times the amplitude at 1 Hz that it has at 1 kHz. A
/// peak is then sought between the frequencies of the transform, where a sinusoid alone has its amplitude to 10⁻⁴; two
/// that are nearer than 2/T, T the time of the values, are one.
namespace axiometry::capture {

struct SpectrumPeak {
  double frequency_hz = 0.0;
  double amplitude = 0.0;  ///< amplitude in the unit of the values
};

struct MotionSpectrum {
  double step_hz = 0.0;            ///< step between two amplitudes
  double resolution_hz = 0.0;      ///< 2/T: nearer ones cannot be told apart
  std::vector<double> amplitudes;  ///< amplitudes from 0 Hz to half the rate
  /// Root mean square of the noise about each frequency, from medians of bands as wide as 16/T, or a quarter of
  /// their lower end if that is more and nowhere a gap is seen.
  std::vector<double> floors;
  /// What such noise exceeds anywhere in one recording of twenty at most, white or not; and the least.
  std::vector<double> thresholds;
  double floor = 0.0, threshold = 0.0;  ///< the lowest of each above the resolution
  /// Highest first: above its threshold, 2/T, and twice what a drift and higher peaks may leave beside themselves.
  std::vector<SpectrumPeak> peaks;
  std::size_t peaks_more = 0;    ///< lower ones; counted up to nine times as many as were asked for
  std::size_t peaks_beside = 0;  ///< peaks above their thresholds and 2/T, but not above what others may leave there

  /// Noise that was averaged or held over longer, T/100, has gaps in its spectrum between which no band shows its
  /// level.
  double averaging_told_s() const { return 0.02 / resolution_hz; }
};

struct SpectrumOptions {
  double rate_hz = 0.0;
  std::size_t most_peaks = 10;
  double least = 0.0;  ///< what the rounding of the values may make: no peak below it
};

/// Needs 16 values at least and a rate above 0 (contract).
MotionSpectrum motion_spectrum(std::span<const double> values, const SpectrumOptions& options);

}  // namespace axiometry::capture
