// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include "axiometry/numeric/series/fourier.h"

/// Which period a sinusoid beside a straight line may have, through values at places that may lie unevenly.
///
/// The spectrum is that of Lomb and Scargle in its generalised form, with the line in place of the constant (M.
/// Zechmeister, M. Kürster, Astron. Astrophys. 496 (2009) 577: "floating mean"): for each period the part of the sum of
/// squares about the line that a sinusoid takes away. The chance that noise alone has such a peak somewhere in the band
/// follows R. V. Baluev, Mon. Not. R. Astron. Soc. 385 (2008) 1279, eqs. 5 and 24, an upper bound that is close where
/// it is small.
///
/// Derivation: docs/theory/periodic-error.md. Independent figures: tests/periodic_oracle.py.
namespace axiometry::numeric {

/// Periods searched, both ends included; 0 < shortest < longest.
struct PeriodBand {
  double shortest = 0.0;
  double longest = 0.0;
};

struct SpectralLine {
  double period = 0.0;
  double amplitude = 0.0;  ///< amplitude of the sinusoid of this period alone, beside a line
  double reduction = 0.0;  ///< 0 to 1: of the sum of squares about the line, the part that it takes away
};

struct Spectrum {
  std::vector<SpectralLine> lines;  ///< lines from the longest period to the shortest, equally spaced in 1/P
  SpectralLine highest;             ///< highest peak, found between the lines by golden section
  bool at_end = false;              ///< the highest stands at an end of the band: there may be a higher one outside
};

/// How many periods of the band are looked at: ten per 1/T, T from the first place to the last.
double spectral_lines(std::span<const double> places, PeriodBand band);

/// The search for a period in one band and at one set of places, which values may share. In time proportional to places
/// and lines: of many places the sums come from Fourier transforms (fourier.h), as many digits as one by one, other
/// roundings; those that the values have no part in are kept of the first 2²⁰ lines.
class PeriodSearch {
 public:
  /// Contract: at least five places, ascending, all different; a valid band with at most 1e7 lines.
  PeriodSearch(std::span<const double> places, PeriodBand band);

  /// Contract: a value for each place. Values on a line without any rest have no reduction anywhere.
  Spectrum spectrum(std::span<const double> values) const;

  /// Probability that white noise alone has a peak of at least this reduction at some period of the band.
  double false_alarm_probability(double reduction) const;

 private:
  /// Sums of products of the cosine c and the sine s of one frequency: with themselves, and with the line taken out.
  struct Waves {
    double cc = 0.0, ss = 0.0;
    double cc_rest = 0.0, ss_rest = 0.0, cs_rest = 0.0;
  };

  /// The values less their line.
  struct Rest {
    std::vector<double> values;
    double squares = 0.0;  ///< 0 where only rounding is left
  };

  using Turns = std::vector<std::complex<double>>;  ///< e^{2πi f x} at every place

  FrequencyGrid piece(std::size_t begin) const;
  Turns turns(double frequency) const;
  Waves waves(const Turns& turned) const;
  Waves waves(double cc, double ss, double cs, std::complex<double> constant, std::complex<double> ramp) const;
  std::vector<Waves> waves_by_transform(const FrequencyGrid& grid) const;
  Rest rest_of(std::span<const double> values) const;
  SpectralLine line(double frequency, const Waves& waves, std::complex<double> rest, double squares) const;
  SpectralLine line_at(double frequency, const Turns& turned, const Rest& rest) const;
  std::vector<SpectralLine> one_by_one(const Rest& rest) const;
  std::vector<SpectralLine> by_transform(const Rest& rest) const;
  SpectralLine golden_section(const Rest& rest, double low, double high) const;

  std::vector<double> places_;  ///< places about their mean
  std::vector<double> ramp_;    ///< the places scaled to length 1
  double spread_ = 0.0;         ///< Σ x², of places about their mean
  PeriodBand band_;
  FrequencyGrid grid_;       ///< frequencies of all lines
  std::vector<Waves> kept_;  ///< sums of the first lines, where there are many places
};

}  // namespace axiometry::numeric
