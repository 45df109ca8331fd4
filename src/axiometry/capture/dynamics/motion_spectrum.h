// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

/// Vibrations in equally spaced values: amplitudes by frequency.
///
/// The values less their weighted mean are weighted by Hann's window w, filled up with zeros to a power of two and
/// transformed (FFT); the amplitude at a frequency f is 2 |Σ w_k x_k e^{−2πi f k τ}|/Σ w_k, that of a sinusoid in the
/// values. A peak is then sought between the frequencies of the transform, where a sinusoid alone has its amplitude to
/// 10⁻⁴; two that are nearer than 2/T, T the time of the values, are one.
namespace axiometry::capture {

struct SpectrumPeak {
  double frequency_hz = 0.0;
  double amplitude = 0.0;  ///< amplitude in the unit of the values
};

struct MotionSpectrum {
  double step_hz = 0.0;            ///< step between two amplitudes
  double resolution_hz = 0.0;      ///< 2/T: nearer ones cannot be told apart
  std::vector<double> amplitudes;  ///< amplitudes from 0 Hz to half the rate
  double floor = 0.0;              ///< median of the amplitudes above the resolution
  double threshold =
      0.0;  ///< √log₂(100 N) floors, of N amplitudes: white noise is beyond it in 1 of 100; and the least
  /// Highest first: above the threshold, 2/T, and twice what a drift and higher peaks may leave beside themselves.
  std::vector<SpectrumPeak> peaks;
  std::size_t peaks_more = 0;    ///< lower ones; counted up to nine times as many as were asked for
  std::size_t peaks_beside = 0;  ///< peaks above the threshold and 2/T, but not above what others may leave there
};

struct SpectrumOptions {
  double rate_hz = 0.0;
  std::size_t most_peaks = 10;
  double least = 0.0;  ///< what the rounding of the values may make: no peak below it
};

/// Needs 16 values at least and a rate above 0 (contract).
MotionSpectrum motion_spectrum(std::span<const double> values, const SpectrumOptions& options);

}  // namespace axiometry::capture
