// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/distribution.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <type_traits>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::uncertainty {
namespace {

template <typename Form>
constexpr bool has_limits = requires(Form f) {
  f.lower;
};

double middle(double lower, double upper) { return lower + (upper - lower) / 2; }

/// Every form but the empirical one is symmetric about this.
template <typename Form>
double centre(const Form& f) {
  if constexpr (has_limits<Form>) {
    return middle(f.lower, f.upper);
  } else if constexpr (std::is_same_v<Form, Constant>) {
    return f.value;
  } else if constexpr (std::is_same_v<Form, Normal>) {
    return f.mean;
  } else if constexpr (std::is_same_v<Form, StudentT>) {
    return f.location;
  } else {
    static_assert(std::is_same_v<Form, Empirical>);
    double sum = 0.0;
    for (const double x : f.values) sum += x / static_cast<double>(f.values.size());
    return sum;
  }
}

// Distance from the centre at which the upper tail is q, 0 < q <= 1/2.

double offset(const Constant&, double) { return 0.0; }
double offset(const Normal& f, double q) { return -f.sd * numeric::normal_quantile(q); }
double offset(const StudentT& f, double q) { return -f.scale * numeric::student_t_quantile(q, f.degrees_of_freedom); }
double offset(const Uniform& f, double q) { return (f.upper - f.lower) * (0.5 - q); }
double offset(const Arcsine& f, double q) { return (f.upper - f.lower) / 2 * std::cos(std::numbers::pi * q); }

double offset(const Trapezoidal& f, double q) {
  const double half = (f.upper - f.lower) / 2;
  const double slope_tail = (1 - f.beta) / (1 + f.beta) / 2;  // q where the top ends and the slope begins
  if (q > slope_tail) return half * (1 + f.beta) * (0.5 - q);
  return half * (1 - std::sqrt(2 * q * (1 - f.beta * f.beta)));
}

double offset(const Triangular& f, double q) { return offset(Trapezoidal{f.lower, f.upper, 0.0}, q); }

/// With the half width w uniform from inner to outer, the tail beyond x is the mean of (1 − x/w)/2 over w > x.
double offset(const CurvilinearTrapezoid& f, double q) {
  const double outer = (f.upper - f.lower) / 2 + f.d;
  const double inner = std::max((f.upper - f.lower) / 2 - f.d, 0.0);
  if (f.d == 0.0) return 2 * outer * (0.5 - q);
  const double scaled = 4 * f.d * q;
  const double log_ratio = std::log(outer / inner);
  const double tail_at_inner = outer - inner - (inner > 0.0 ? inner * log_ratio : 0.0);
  if (scaled >= tail_at_inner) return inner > 0.0 ? (outer - inner - scaled) / log_ratio : 0.0;
  // g(x) = outer − x − x ln(outer/x) falls and is convex, so Newton steps from the left never pass the root.
  double x = inner > 0.0 ? inner : outer * 1e-18;
  for (int i = 0; i < 200; ++i) {
    const double step = (outer - x - x * std::log(outer / x) - scaled) / std::log(outer / x);
    if (!(step > x * 1e-16)) break;
    x += step;
  }
  return std::min(x, outer);
}

double empirical_quantile(const Empirical& f, double p) {
  const auto n = static_cast<double>(f.values.size());
  return f.values[static_cast<std::size_t>(std::min(p * n, n - 1.0))];
}

/// Numbers in pairs, so that a draw does not depend on how many follow it.
std::vector<double> uniform_pairs(numeric::RandomKey key, std::size_t draws) {
  std::vector<double> numbers(2 * draws);
  numeric::fill_uniform(key, numbers);
  return numbers;
}

template <typename Form>
void draw(const Form& f, numeric::RandomKey key, std::span<double> draws) {
  numeric::fill_uniform(key, draws);
  const double c = centre(f);
  for (double& x : draws) x = x < 0.5 ? c - offset(f, x) : c + offset(f, 1.0 - x);
}

void draw(const Constant& f, numeric::RandomKey, std::span<double> draws) { std::ranges::fill(draws, f.value); }

/// What the template gives, to the last bit, since x − ½ is exact: but which half x is in is as good as a coin, on
/// which a branch would wait.
void draw(const Uniform& f, numeric::RandomKey key, std::span<double> draws) {
  numeric::fill_uniform(key, draws);
  const double c = centre(f), width = f.upper - f.lower;
  for (double& x : draws) x = c + width * (x - 0.5);
}

void draw(const Normal& f, numeric::RandomKey key, std::span<double> draws) {
  numeric::fill_normal(key, draws);
  for (double& x : draws) x = f.mean + f.sd * x;
}

void draw(const StudentT& f, numeric::RandomKey key, std::span<double> draws) {
  const std::vector<double> u = uniform_pairs(key, draws.size());
  const double nu = f.degrees_of_freedom;
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const double radius = std::sqrt(nu * std::expm1(-2.0 / nu * std::log(u[2 * i])));
    draws[i] = f.location + f.scale * radius * std::cos(2.0 * std::numbers::pi * u[2 * i + 1]);
  }
}

void draw(const CurvilinearTrapezoid& f, numeric::RandomKey key, std::span<double> draws) {
  const std::vector<double> u = uniform_pairs(key, draws.size());
  const double c = centre(f), half = (f.upper - f.lower) / 2;
  for (std::size_t i = 0; i < draws.size(); ++i)
    draws[i] = c + (half + f.d * (2.0 * u[2 * i] - 1.0)) * (2.0 * u[2 * i + 1] - 1.0);
}

void draw(const Empirical& f, numeric::RandomKey key, std::span<double> draws) {
  numeric::fill_uniform(key, draws);
  for (double& x : draws) x = empirical_quantile(f, x);
}

double sd_of(const Constant&) { return 0.0; }
double sd_of(const Normal& f) { return f.sd; }
double sd_of(const StudentT& f) { return f.scale * std::sqrt(f.degrees_of_freedom / (f.degrees_of_freedom - 2.0)); }
double sd_of(const Uniform& f) { return (f.upper - f.lower) / std::sqrt(12.0); }
double sd_of(const Triangular& f) { return (f.upper - f.lower) / std::sqrt(24.0); }
double sd_of(const Trapezoidal& f) { return (f.upper - f.lower) * std::sqrt((1.0 + f.beta * f.beta) / 24.0); }
double sd_of(const Arcsine& f) { return (f.upper - f.lower) / std::sqrt(8.0); }
double sd_of(const CurvilinearTrapezoid& f) {
  const double width = f.upper - f.lower;
  return std::sqrt(width * width / 12.0 + f.d * f.d / 9.0);
}
double sd_of(const Empirical& f) {
  const double mean = centre(f);
  double squares = 0.0;
  for (const double x : f.values) squares += (x - mean) * (x - mean);
  return std::sqrt(squares / static_cast<double>(f.values.size()));
}

}  // namespace

double Distribution::mean() const {
  return std::visit([](const auto& f) { return centre(f); }, form_);
}

std::optional<double> Distribution::standard_deviation() const {
  if (const auto nu = degrees_of_freedom(); nu && *nu <= 2.0) return std::nullopt;
  return std::visit([](const auto& f) { return sd_of(f); }, form_);
}

std::optional<double> Distribution::degrees_of_freedom() const {
  if (const auto* t = std::get_if<StudentT>(&form_)) return t->degrees_of_freedom;
  return std::nullopt;
}

Distribution Distribution::centred() const {
  Distribution result = *this;
  const double c = mean();
  std::visit(
      [c]<typename F>(F& f) {
        if constexpr (has_limits<F>) {
          const double half = (f.upper - f.lower) / 2;
          f.lower = -half;
          f.upper = half;
        } else if constexpr (std::is_same_v<F, Constant>) {
          f.value = 0.0;
        } else if constexpr (std::is_same_v<F, Normal>) {
          f.mean = 0.0;
        } else if constexpr (std::is_same_v<F, StudentT>) {
          f.location = 0.0;
        } else {
          for (double& x : f.values) x -= c;
        }
      },
      result.form_);
  return result;
}

void Distribution::sample(numeric::RandomKey key, std::span<double> draws) const {
  std::visit([&](const auto& f) { draw(f, key, draws); }, form_);
}

double Distribution::quantile(double p) const {
  AXIOMETRY_CONTRACT(p > 0.0 && p < 1.0);
  return std::visit(
      [p]<typename F>(const F& f) {
        if constexpr (std::is_same_v<F, Empirical>)
          return empirical_quantile(f, p);
        else
          return p < 0.5 ? centre(f) - offset(f, p) : centre(f) + offset(f, 1.0 - p);
      },
      form_);
}

double Distribution::from_normal(double z) const {
  return std::visit(
      [z]<typename F>(const F& f) {
        if constexpr (std::is_same_v<F, Normal>) {
          return f.mean + f.sd * z;
        } else if constexpr (std::is_same_v<F, Empirical>) {
          return empirical_quantile(f, numeric::normal_probability(z));
        } else {
          const double distance = offset(f, numeric::normal_probability(-std::abs(z)));
          return z < 0.0 ? centre(f) - distance : centre(f) + distance;
        }
      },
      form_);
}

}  // namespace axiometry::uncertainty
