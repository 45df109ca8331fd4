// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the sources: a straight line where both papers have a constant, so that one more degree of freedom
// is gone; the band of the false alarm probability begins at its longest period, not at infinity.
#include "axiometry/numeric/harmonic_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/numeric/series/fourier.h"

namespace axiometry::numeric {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
// Columns of entries up to 1 that depend on each other to this degree: coefficients would have lost nine digits.
constexpr double dependent = 1e-9;

struct Solution {
  Eigen::VectorXd coefficients;
  Eigen::MatrixXd cofactor;  ///< (JᵀJ)⁻¹
  Eigen::VectorXd residuals;
};

/// Least squares. Nothing when the columns depend on each other.
std::optional<Solution> solve(const Eigen::MatrixXd& columns, const Eigen::VectorXd& values) {
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(columns);
  qr.setThreshold(dependent);
  if (qr.rank() < columns.cols()) return std::nullopt;
  Solution result;
  result.coefficients = qr.solve(values);
  result.residuals = values - columns * result.coefficients;
  result.cofactor = cofactor(qr);
  return result;
}

/// The problem with the line's columns centred and scaled; coefficients are brought back to x₀ at the end.
class Problem {
 public:
  Problem(const HarmonicData& data, std::span<const std::size_t> orders)
      : data_(data), orders_(orders.begin(), orders.end()) {
    AXIOMETRY_CONTRACT(data.places.size() == data.values.size() && data.places.size() >= 2 && !orders.empty());
    origin_ = data.places.front();
    half_ = (data.places.back() - data.places.front()) / 2.0;
    middle_ = origin_ + half_;
    values_ = Eigen::Map<const Eigen::VectorXd>(data.values.data(), static_cast<Eigen::Index>(data.values.size()));
  }

  std::size_t size() const { return data_.places.size(); }
  std::size_t linear_count() const { return 2 + 2 * orders_.size(); }

  std::optional<Solution> solve_at(double period) const { return solve(columns(period), values_); }

  /// The step of the period that the residuals ask for, and the whole solution's cofactors.
  std::optional<Solution> solve_with_period(double period, const Solution& linear) const {
    Eigen::MatrixXd all(static_cast<Eigen::Index>(size()), static_cast<Eigen::Index>(linear_count() + 1));
    all.leftCols(static_cast<Eigen::Index>(linear_count())) = columns(period);
    for (std::size_t k = 0; k < size(); ++k) {
      double derivative = 0.0;
      for (std::size_t h = 0; h < orders_.size(); ++h) {
        const double rate = two_pi * static_cast<double>(orders_[h]) / period;
        const double x = data_.places[k] - origin_;
        const auto at = static_cast<Eigen::Index>(2 + 2 * h);
        derivative -= rate * x / period *
                      (linear.coefficients[at] * std::cos(rate * x) - linear.coefficients[at + 1] * std::sin(rate * x));
      }
      all(static_cast<Eigen::Index>(k), static_cast<Eigen::Index>(linear_count())) = derivative;
    }
    // Its size is that of the amplitude over the period; the others have entries up to 1.
    const auto last = all.cols() - 1;
    const double size = all.col(last).norm();
    if (!(size > 0.0)) return std::nullopt;
    all.col(last) *= std::sqrt(static_cast<double>(this->size())) / size;
    auto solution = solve(all, linear.residuals);
    if (!solution) return std::nullopt;
    const double unit = std::sqrt(static_cast<double>(this->size())) / size;
    solution->coefficients[last] *= unit;
    solution->cofactor.row(last) *= unit;
    solution->cofactor.col(last) *= unit;
    return solution;
  }

  HarmonicFit fit(double period, const Solution& linear, const Solution* with_period) const {
    HarmonicFit result;
    result.origin = origin_;
    result.period = period;
    result.orders = orders_;
    result.period_fitted = with_period != nullptr;
    const std::size_t p = linear_count() + (result.period_fitted ? 1 : 0);
    result.degrees_of_freedom = size() - p;
    result.residuals.assign(linear.residuals.begin(), linear.residuals.end());
    result.sum_of_squares = linear.residuals.squaredNorm();
    // a + b (x − x₀) from a' + b' (x − middle)/half
    Eigen::MatrixXd back = Eigen::MatrixXd::Identity(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(p));
    back(0, 1) = (origin_ - middle_) / half_;
    back(1, 1) = 1.0 / half_;
    Eigen::VectorXd coefficients(static_cast<Eigen::Index>(p));
    coefficients.head(static_cast<Eigen::Index>(linear_count())) = linear.coefficients;
    if (result.period_fitted) coefficients[static_cast<Eigen::Index>(p - 1)] = period;
    coefficients = back * coefficients;
    const double variance = result.sum_of_squares / static_cast<double>(result.degrees_of_freedom);
    const Eigen::MatrixXd& cofactor = result.period_fitted ? with_period->cofactor : linear.cofactor;
    const Eigen::MatrixXd covariance = variance * (back * cofactor * back.transpose());
    result.coefficients.assign(coefficients.begin(), coefficients.end());
    for (Eigen::Index r = 0; r < covariance.rows(); ++r)
      for (Eigen::Index c = 0; c < covariance.cols(); ++c) result.covariance.push_back(covariance(r, c));
    return result;
  }

 private:
  Eigen::MatrixXd columns(double period) const {
    Eigen::MatrixXd all(static_cast<Eigen::Index>(size()), static_cast<Eigen::Index>(linear_count()));
    for (std::size_t k = 0; k < size(); ++k) {
      const auto row = static_cast<Eigen::Index>(k);
      all(row, 0) = 1.0;
      all(row, 1) = (data_.places[k] - middle_) / half_;
      for (std::size_t h = 0; h < orders_.size(); ++h) {
        const double angle = two_pi * static_cast<double>(orders_[h]) * (data_.places[k] - origin_) / period;
        all(row, static_cast<Eigen::Index>(2 + 2 * h)) = std::sin(angle);
        all(row, static_cast<Eigen::Index>(3 + 2 * h)) = std::cos(angle);
      }
    }
    return all;
  }

  HarmonicData data_;
  std::vector<std::size_t> orders_;
  double origin_ = 0.0;
  double middle_ = 0.0;
  double half_ = 1.0;
  Eigen::VectorXd values_;
};

/// Sums that one frequency needs, with the line projected out.
class LineSpectrum {
 public:
  explicit LineSpectrum(const HarmonicData& data) : places_(data.places) {
    const std::size_t n = data.places.size();
    AXIOMETRY_CONTRACT(n == data.values.size() && n >= 5);
    const double count = static_cast<double>(n);
    double mean_x = 0.0, mean_y = 0.0;
    for (std::size_t k = 0; k < n; ++k) mean_x += places_[k] / count, mean_y += data.values[k] / count;
    double xx = 0.0, xy = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      centred_.push_back(places_[k] - mean_x);
      xx += centred_[k] * centred_[k];
      xy += centred_[k] * (data.values[k] - mean_y);
    }
    variance_ = xx / count;
    constant_ = 1.0 / std::sqrt(count);
    double total = 0.0;
    for (std::size_t k = 0; k < n; ++k) {
      ramp_.push_back(centred_[k] / std::sqrt(xx));
      rest_.push_back(data.values[k] - mean_y - xy / xx * centred_[k]);
      squares_ += rest_[k] * rest_[k];
      total += data.values[k] * data.values[k];
    }
    // Below what rounding leaves of values on a straight line there is nothing to find.
    const double rounding = std::numeric_limits<double>::epsilon();
    if (squares_ <= 16.0 * rounding * rounding * total * count) squares_ = 0.0;
  }

  double sum_of_squares() const { return squares_; }
  double variance_of_places() const { return variance_; }

  SpectralLine at(double frequency) const { return of(frequency, turns(frequency)); }

  /// Of every frequency, from the longest period on: one by one for few places, which gives the same bits as at().
  std::vector<SpectralLine> of(const FrequencyGrid& grid) const {
    return centred_.size() < places_by_transform ? one_by_one(grid) : by_transform(grid);
  }

 private:
  static constexpr std::size_t places_by_transform = 256;  // where sums one by one take longer

  /// Of cosine c and sine s at the places: products with each other, and with constant, ramp and rest.
  struct Sums {
    double cc = 0, ss = 0, cs = 0, c0 = 0, s0 = 0, c1 = 0, s1 = 0, cr = 0, sr = 0;
  };

  std::vector<std::complex<double>> turns(double frequency) const {
    std::vector<std::complex<double>> result;
    for (double x : centred_) result.push_back(std::polar(1.0, two_pi * frequency * x));
    return result;
  }

  std::vector<SpectralLine> one_by_one(const FrequencyGrid& grid) const {
    std::vector<SpectralLine> lines;
    lines.reserve(grid.count);
    const std::vector<std::complex<double>> further = turns(grid.step);
    std::vector<std::complex<double>> turned;
    for (std::size_t k = 0; k < grid.count; ++k) {
      constexpr std::size_t drift_limit = 256;  // rounding of the products grows with their number
      const double frequency = grid.first + grid.step * static_cast<double>(k);
      if (k % drift_limit == 0)
        turned = turns(frequency);
      else
        for (std::size_t i = 0; i < turned.size(); ++i) turned[i] *= further[i];
      lines.push_back(of(frequency, turned));
    }
    return lines;
  }

  /// cos² and sin² are what the cosine of twice the angle tells.
  std::vector<SpectralLine> by_transform(const FrequencyGrid& grid) const {
    const std::vector<double> ones(centred_.size(), 1.0);
    const std::array<std::span<const double>, 3> columns = {ones, ramp_, rest_};
    FourierSums of_angle(centred_, columns), of_twice_the_angle(centred_, std::span(columns).first(1));
    const double n = static_cast<double>(centred_.size());
    std::vector<SpectralLine> lines;
    lines.reserve(grid.count);
    while (lines.size() < grid.count) {
      const double first = grid.first + grid.step * static_cast<double>(lines.size());
      const std::size_t count = std::min(FourierSums::most_at_once, grid.count - lines.size());
      const auto once = of_angle({first, grid.step, count});
      const auto twice = of_twice_the_angle({2 * first, 2 * grid.step, count});
      for (std::size_t k = 0; k < count; ++k) {
        const std::complex<double> one = once[0][k], ramp = once[1][k], rest = once[2][k], both = twice[0][k];
        lines.push_back(of(first + grid.step * static_cast<double>(k),
                           Sums{0.5 * (n + both.real()), 0.5 * (n - both.real()), 0.5 * both.imag(), one.real(),
                                one.imag(), ramp.real(), ramp.imag(), rest.real(), rest.imag()}));
      }
    }
    return lines;
  }

  SpectralLine of(double frequency, std::span<const std::complex<double>> turned) const {
    Sums sums;
    for (std::size_t k = 0; k < turned.size(); ++k) {
      const double c = turned[k].real(), s = turned[k].imag();
      sums.cc += c * c, sums.ss += s * s, sums.cs += c * s;
      sums.c0 += c, sums.s0 += s;
      sums.c1 += c * ramp_[k], sums.s1 += s * ramp_[k];
      sums.cr += c * rest_[k], sums.sr += s * rest_[k];
    }
    return of(frequency, sums);
  }

  SpectralLine of(double frequency, const Sums& sums) const {
    const auto& [cc, ss, cs, without0, without1, c1, s1, cr, sr] = sums;
    const double c0 = without0 * constant_, s0 = without1 * constant_;
    const double CC = cc - c0 * c0 - c1 * c1, SS = ss - s0 * s0 - s1 * s1, CS = cs - c0 * s0 - c1 * s1;
    SpectralLine line{1.0 / frequency, 0.0, 0.0};
    if (squares_ == 0.0) return line;
    const double determinant = CC * SS - CS * CS;
    double by_cosine = 0.0, by_sine = 0.0;
    if (determinant > dependent * cc * ss) {
      by_cosine = (cr * SS - sr * CS) / determinant;
      by_sine = (sr * CC - cr * CS) / determinant;
    } else if (std::max(CC, SS) > dependent * static_cast<double>(centred_.size())) {
      // Only one of both can be seen: as at every half period.
      by_cosine = CC >= SS ? cr / CC : 0.0;
      by_sine = CC >= SS ? 0.0 : sr / SS;
    }
    line.amplitude = std::hypot(by_cosine, by_sine);
    line.reduction = std::clamp((by_cosine * cr + by_sine * sr) / squares_, 0.0, 1.0);
    return line;
  }

  std::span<const double> places_;
  std::vector<double> centred_;
  std::vector<double> ramp_;  ///< of length 1
  std::vector<double> rest_;  ///< values less their line
  double constant_ = 1.0;
  double squares_ = 0.0;
  double variance_ = 0.0;
};

constexpr double lines_per_resolution = 10.0;

double extent(const HarmonicData& data) { return data.places.back() - data.places.front(); }

/// The frequency of the greatest reduction between two around a maximum.
SpectralLine golden_section(const LineSpectrum& sums, double low, double high) {
  constexpr double golden = 0.6180339887498949;
  double a = low, b = high;
  SpectralLine left = sums.at(b - golden * (b - a));
  SpectralLine right = sums.at(a + golden * (b - a));
  for (int k = 0; k < 60 && b - a > 1e-10 * b; ++k) {
    if (left.reduction >= right.reduction) {
      b = 1.0 / right.period;
      right = left;
      left = sums.at(b - golden * (b - a));
    } else {
      a = 1.0 / left.period;
      left = right;
      right = sums.at(a + golden * (b - a));
    }
  }
  return left.reduction >= right.reduction ? left : right;
}

}  // namespace

std::size_t HarmonicFit::place_of(std::size_t order) const {
  const auto found = std::ranges::find(orders, order);
  AXIOMETRY_CONTRACT(found != orders.end());
  return 2 + 2 * static_cast<std::size_t>(found - orders.begin());
}

double HarmonicFit::chance_of(std::size_t order) const {
  const std::size_t at = place_of(order);
  const double ss = covariance_of(at, at), cc = covariance_of(at + 1, at + 1), sc = covariance_of(at, at + 1);
  const double s = coefficients[at], c = coefficients[at + 1];
  const double determinant = ss * cc - sc * sc;
  if (!(determinant > 0.0)) return s == 0.0 && c == 0.0 ? 1.0 : 0.0;
  const double F = (s * s * cc - 2.0 * s * c * sc + c * c * ss) / determinant / 2.0;
  const double nu = static_cast<double>(degrees_of_freedom);
  return std::exp(-nu / 2.0 * std::log1p(2.0 * F / nu));
}

std::optional<HarmonicFit> fit_harmonics(const HarmonicData& data, double period, std::span<const std::size_t> orders) {
  AXIOMETRY_CONTRACT(period > 0.0);
  const Problem problem(data, orders);
  if (problem.size() <= problem.linear_count()) return std::nullopt;
  const auto solution = problem.solve_at(period);
  return solution ? std::optional(problem.fit(period, *solution, nullptr)) : std::nullopt;
}

std::optional<HarmonicFit> fit_harmonics_and_period(const HarmonicData& data, double start,
                                                    std::span<const std::size_t> orders) {
  AXIOMETRY_CONTRACT(start > 0.0);
  const Problem problem(data, orders);
  if (problem.size() <= problem.linear_count() + 1) return std::nullopt;
  double period = start;
  auto best = problem.solve_at(period);
  if (!best) return std::nullopt;
  for (int iteration = 0; iteration < 100; ++iteration) {
    const auto whole = problem.solve_with_period(period, *best);
    if (!whole) return std::nullopt;
    double step = whole->coefficients[whole->coefficients.size() - 1];
    bool fell = false;
    for (int halving = 0; halving < 40 && std::abs(step) > 1e-12 * period; ++halving, step /= 2.0) {
      const double next = period + step;
      if (!(next > start / 2.0 && next < 2.0 * start)) continue;
      const auto trial = problem.solve_at(next);
      if (!trial || trial->residuals.squaredNorm() >= best->residuals.squaredNorm()) continue;
      period = next;
      best = trial;
      fell = true;
      break;
    }
    if (!fell) return problem.fit(period, *best, &*whole);
  }
  const auto whole = problem.solve_with_period(period, *best);
  return whole ? std::optional(problem.fit(period, *best, &*whole)) : std::nullopt;
}

double spectral_lines(const HarmonicData& data, PeriodBand band) {
  return std::ceil((1.0 / band.shortest - 1.0 / band.longest) * extent(data) * lines_per_resolution) + 1.0;
}

Spectrum spectrum(const HarmonicData& data, PeriodBand band) {
  AXIOMETRY_CONTRACT(band.shortest > 0.0 && band.shortest < band.longest && spectral_lines(data, band) <= 1e7);
  const LineSpectrum sums(data);
  const auto count = static_cast<std::size_t>(spectral_lines(data, band));
  const double low = 1.0 / band.longest;
  const double step = (1.0 / band.shortest - low) / static_cast<double>(std::max<std::size_t>(count - 1, 1));
  const auto frequency = [&](std::size_t k) { return low + step * static_cast<double>(k); };

  Spectrum result;
  result.lines = sums.of(FrequencyGrid{low, step, count});
  const auto highest = std::ranges::max_element(result.lines, {}, &SpectralLine::reduction);
  const auto at = static_cast<std::size_t>(highest - result.lines.begin());
  result.at_end = at == 0 || at + 1 == count;
  result.highest = *highest;
  if (highest->reduction > 0.0) {
    const SpectralLine between =
        golden_section(sums, frequency(at == 0 ? 0 : at - 1), frequency(std::min(at + 1, count - 1)));
    if (between.reduction > highest->reduction) result.highest = between;
  }
  return result;
}

double false_alarm_probability(const HarmonicData& data, PeriodBand band, double reduction) {
  const LineSpectrum sums(data);
  const double n = static_cast<double>(data.places.size());
  const double without = n - 2.0;  // degrees of freedom about the line
  const double with = n - 4.0;     // and about line and sinusoid
  if (!(reduction > 0.0)) return 1.0;
  if (reduction >= 1.0) return 0.0;
  const double log_rest = std::log1p(-reduction);
  const double single = std::exp(0.5 * with * log_rest);
  const double width =
      (1.0 / band.shortest - 1.0 / band.longest) * std::sqrt(4.0 * std::numbers::pi * sums.variance_of_places());
  const double gamma =
      std::sqrt(2.0 / without) * std::exp(std::lgamma(without / 2.0) - std::lgamma((without - 1.0) / 2.0));
  const double crossings =
      gamma * width * std::exp(0.5 * (with - 1.0) * log_rest) * std::sqrt(0.5 * without * reduction);
  return std::clamp(-std::expm1(std::log1p(-std::min(single, 1.0 - 1e-16)) - crossings), 0.0, 1.0);
}

}  // namespace axiometry::numeric
