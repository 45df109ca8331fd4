// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the sources: a straight line where both papers have a constant, so that one more degree of freedom
// is gone; the band of the false alarm probability begins at its longest period, not at infinity.
#include "axiometry/numeric/series/period_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "axiometry/base/contract.h"

namespace axiometry::numeric {
namespace {

constexpr double two_pi_of_search = 2.0 * std::numbers::pi;
// Columns of entries up to 1 that depend on each other to this degree: coefficients would have lost nine digits.
constexpr double dependent_waves = 1e-9;
constexpr double lines_per_resolution = 10.0;
constexpr std::size_t places_by_transform = 256;  // where sums one by one take longer
constexpr std::size_t most_kept = std::size_t{1} << 20;

}  // namespace

double spectral_lines(std::span<const double> places, PeriodBand band) {
  const double extent = places.back() - places.front();
  return std::ceil((1.0 / band.shortest - 1.0 / band.longest) * extent * lines_per_resolution) + 1.0;
}

PeriodSearch::PeriodSearch(std::span<const double> places, PeriodBand band) : band_(band) {
  AXIOMETRY_CONTRACT(places.size() >= 5 && band.shortest > 0.0 && band.shortest < band.longest);
  AXIOMETRY_CONTRACT(spectral_lines(places, band) <= 1e7);
  double mean = 0.0;
  for (const double x : places) mean += x / static_cast<double>(places.size());
  for (const double x : places) {
    places_.push_back(x - mean);
    spread_ += places_.back() * places_.back();
  }
  for (const double x : places_) ramp_.push_back(x / std::sqrt(spread_));
  grid_.count = static_cast<std::size_t>(spectral_lines(places, band));
  grid_.first = 1.0 / band.longest;
  grid_.step = (1.0 / band.shortest - grid_.first) / static_cast<double>(std::max<std::size_t>(grid_.count - 1, 1));
  if (places_.size() < places_by_transform) return;
  while (kept_.size() < std::min(grid_.count, most_kept)) {
    const std::vector<Waves> further = waves_by_transform(piece(kept_.size()));
    kept_.insert(kept_.end(), further.begin(), further.end());
  }
}

/// As many lines from that one on as are transformed at once.
FrequencyGrid PeriodSearch::piece(std::size_t begin) const {
  return {grid_.first + grid_.step * static_cast<double>(begin), grid_.step,
          std::min(FourierSums::most_at_once, grid_.count - begin)};
}

PeriodSearch::Turns PeriodSearch::turns(double frequency) const {
  Turns result;
  result.reserve(places_.size());
  for (const double x : places_) result.push_back(std::polar(1.0, two_pi_of_search * frequency * x));
  return result;
}

PeriodSearch::Waves PeriodSearch::waves(const Turns& turned) const {
  double cc = 0.0, ss = 0.0, cs = 0.0;
  std::complex<double> constant, ramp;
  for (std::size_t k = 0; k < turned.size(); ++k) {
    const double c = turned[k].real(), s = turned[k].imag();
    cc += c * c, ss += s * s, cs += c * s;
    constant += turned[k];
    ramp += turned[k] * ramp_[k];
  }
  return waves(cc, ss, cs, constant, ramp);
}

/// The line's two columns, of length 1, are at right angles to each other.
PeriodSearch::Waves PeriodSearch::waves(double cc, double ss, double cs, std::complex<double> constant,
                                        std::complex<double> ramp) const {
  constant *= 1.0 / std::sqrt(static_cast<double>(places_.size()));
  const double c0 = constant.real(), s0 = constant.imag(), c1 = ramp.real(), s1 = ramp.imag();
  return {cc, ss, cc - c0 * c0 - c1 * c1, ss - s0 * s0 - s1 * s1, cs - c0 * s0 - c1 * s1};
}

/// cos² and sin² are what the cosine of twice the angle tells.
std::vector<PeriodSearch::Waves> PeriodSearch::waves_by_transform(const FrequencyGrid& grid) const {
  const std::vector<double> ones(places_.size(), 1.0);
  const std::array<std::span<const double>, 2> columns = {ones, ramp_};
  FourierSums of_angle(places_, columns), of_twice_the_angle(places_, std::span(columns).first(1));
  const auto once = of_angle(grid);
  const auto twice = of_twice_the_angle({2 * grid.first, 2 * grid.step, grid.count});
  const double n = static_cast<double>(places_.size());
  std::vector<Waves> result;
  result.reserve(grid.count);
  for (std::size_t k = 0; k < grid.count; ++k) {
    const std::complex<double> both = twice[0][k];
    result.push_back(
        waves(0.5 * (n + both.real()), 0.5 * (n - both.real()), 0.5 * both.imag(), once[0][k], once[1][k]));
  }
  return result;
}

PeriodSearch::Rest PeriodSearch::rest_of(std::span<const double> values) const {
  AXIOMETRY_CONTRACT(values.size() == places_.size());
  const double count = static_cast<double>(values.size());
  double mean = 0.0, xy = 0.0, total = 0.0;
  for (const double y : values) mean += y / count;
  for (std::size_t k = 0; k < values.size(); ++k) xy += places_[k] * (values[k] - mean);
  Rest rest;
  for (std::size_t k = 0; k < values.size(); ++k) {
    rest.values.push_back(values[k] - mean - xy / spread_ * places_[k]);
    rest.squares += rest.values[k] * rest.values[k];
    total += values[k] * values[k];
  }
  // Below what rounding leaves of values on a straight line there is nothing to find.
  constexpr double rounding = std::numeric_limits<double>::epsilon();
  if (rest.squares <= 16.0 * rounding * rounding * total * count) rest.squares = 0.0;
  return rest;
}

SpectralLine PeriodSearch::line(double frequency, const Waves& waves, std::complex<double> rest, double squares) const {
  const auto& [cc, ss, CC, SS, CS] = waves;
  const double cr = rest.real(), sr = rest.imag();
  SpectralLine line{1.0 / frequency, 0.0, 0.0};
  if (squares == 0.0) return line;
  const double determinant = CC * SS - CS * CS;
  double by_cosine = 0.0, by_sine = 0.0;
  if (determinant > dependent_waves * cc * ss) {
    by_cosine = (cr * SS - sr * CS) / determinant;
    by_sine = (sr * CC - cr * CS) / determinant;
  } else if (std::max(CC, SS) > dependent_waves * static_cast<double>(places_.size())) {
    // Only one of both can be seen: as at every half period.
    by_cosine = CC >= SS ? cr / CC : 0.0;
    by_sine = CC >= SS ? 0.0 : sr / SS;
  }
  line.amplitude = std::hypot(by_cosine, by_sine);
  line.reduction = std::clamp((by_cosine * cr + by_sine * sr) / squares, 0.0, 1.0);
  return line;
}

SpectralLine PeriodSearch::line_at(double frequency, const Turns& turned, const Rest& rest) const {
  std::complex<double> sum;
  for (std::size_t k = 0; k < turned.size(); ++k) sum += turned[k] * rest.values[k];
  return line(frequency, waves(turned), sum, rest.squares);
}

std::vector<SpectralLine> PeriodSearch::one_by_one(const Rest& rest) const {
  std::vector<SpectralLine> lines;
  lines.reserve(grid_.count);
  const Turns further = turns(grid_.step);
  Turns turned;
  for (std::size_t k = 0; k < grid_.count; ++k) {
    constexpr std::size_t drift_limit = 256;  // rounding of the products grows with their number
    const double frequency = grid_.first + grid_.step * static_cast<double>(k);
    if (k % drift_limit == 0)
      turned = turns(frequency);
    else
      for (std::size_t i = 0; i < turned.size(); ++i) turned[i] *= further[i];
    lines.push_back(line_at(frequency, turned, rest));
  }
  return lines;
}

std::vector<SpectralLine> PeriodSearch::by_transform(const Rest& rest) const {
  const std::array<std::span<const double>, 1> columns = {rest.values};
  FourierSums sums_of(places_, columns);
  std::vector<SpectralLine> lines;
  lines.reserve(grid_.count);
  while (lines.size() < grid_.count) {
    const std::size_t begin = lines.size();
    const FrequencyGrid grid = piece(begin);
    const auto sums = sums_of(grid);
    const std::vector<Waves> others = begin < kept_.size() ? std::vector<Waves>{} : waves_by_transform(grid);
    const Waves* const waves = others.empty() ? &kept_[begin] : others.data();
    for (std::size_t k = 0; k < grid.count; ++k)
      lines.push_back(line(grid.first + grid.step * static_cast<double>(k), waves[k], sums[0][k], rest.squares));
  }
  return lines;
}

/// The frequency of the greatest reduction between two around a maximum.
SpectralLine PeriodSearch::golden_section(const Rest& rest, double low, double high) const {
  constexpr double golden = 0.6180339887498949;
  const auto at = [&](double frequency) { return line_at(frequency, turns(frequency), rest); };
  double a = low, b = high;
  SpectralLine left = at(b - golden * (b - a));
  SpectralLine right = at(a + golden * (b - a));
  for (int k = 0; k < 60 && b - a > 1e-10 * b; ++k) {
    if (left.reduction >= right.reduction) {
      b = 1.0 / right.period;
      right = left;
      left = at(b - golden * (b - a));
    } else {
      a = 1.0 / left.period;
      left = right;
      right = at(a + golden * (b - a));
    }
  }
  return left.reduction >= right.reduction ? left : right;
}

Spectrum PeriodSearch::spectrum(std::span<const double> values) const {
  const Rest rest = rest_of(values);
  Spectrum result;
  result.lines = places_.size() < places_by_transform ? one_by_one(rest) : by_transform(rest);
  const auto highest = std::ranges::max_element(result.lines, {}, &SpectralLine::reduction);
  const auto at = static_cast<std::size_t>(highest - result.lines.begin());
  result.at_end = at == 0 || at + 1 == grid_.count;
  result.highest = *highest;
  if (highest->reduction > 0.0) {
    const auto frequency = [&](std::size_t k) { return grid_.first + grid_.step * static_cast<double>(k); };
    const SpectralLine between =
        golden_section(rest, frequency(at == 0 ? 0 : at - 1), frequency(std::min(at + 1, grid_.count - 1)));
    if (between.reduction > highest->reduction) result.highest = between;
  }
  return result;
}

double PeriodSearch::false_alarm_probability(double reduction) const {
  const double n = static_cast<double>(places_.size());
  const double without = n - 2.0;  // degrees of freedom about the line
  const double with = n - 4.0;     // and about line and sinusoid
  if (!(reduction > 0.0)) return 1.0;
  if (reduction >= 1.0) return 0.0;
  const double log_rest = std::log1p(-reduction);
  const double single = std::exp(0.5 * with * log_rest);
  const double width = (1.0 / band_.shortest - 1.0 / band_.longest) * std::sqrt(4.0 * std::numbers::pi * spread_ / n);
  const double gamma =
      std::sqrt(2.0 / without) * std::exp(std::lgamma(without / 2.0) - std::lgamma((without - 1.0) / 2.0));
  const double crossings =
      gamma * width * std::exp(0.5 * (with - 1.0) * log_rest) * std::sqrt(0.5 * without * reduction);
  return std::clamp(-std::expm1(std::log1p(-std::min(single, 1.0 - 1e-16)) - crossings), 0.0, 1.0);
}

}  // namespace axiometry::numeric
