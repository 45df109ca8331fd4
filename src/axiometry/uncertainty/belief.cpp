// SPDX-License-Identifier: Apache-2.0
#include "axiometry/uncertainty/belief.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/distributions/normal_and_student_t.h"

namespace axiometry::uncertainty {
namespace {

Range certain(bool holds) { return holds ? Range{1.0, 1.0} : Range{0.0, 0.0}; }

/// Over all distributions.
template <typename Figure>
Range range_of(const std::vector<Possible>& distributions, const Figure& figure) {
  Range range{figure(distributions.front()), figure(distributions.front())};
  for (const Possible& distribution : distributions) {
    range.least = std::min(range.least, figure(distribution));
    range.most = std::max(range.most, figure(distribution));
  }
  return range;
}

}  // namespace

double Range::cautious() const { return std::clamp(0.5, least, most); }

Belief Belief::normal(double value, double u) {
  AXIOMETRY_CONTRACT(u >= 0.0);
  return {value, u, std::numeric_limits<double>::infinity(), {}};
}

Belief Belief::student_t(double value, double u, double degrees_of_freedom) {
  AXIOMETRY_CONTRACT(u > 0.0 && degrees_of_freedom > 0.0);
  return {value, u, degrees_of_freedom, {}};
}

Belief Belief::sampled(double value, std::vector<Possible> distributions) {
  AXIOMETRY_CONTRACT(!distributions.empty());
  for (const Possible& distribution : distributions)
    AXIOMETRY_CONTRACT(distribution.trials != nullptr && distribution.trials->trials() > 0);
  return {value, 0.0, std::numeric_limits<double>::infinity(), std::move(distributions)};
}

double Belief::about_value(double x) const {
  const double z = (x - value_) / u_;
  return std::isinf(degrees_of_freedom_) ? numeric::normal_probability(z)
                                         : numeric::student_t_probability(z, degrees_of_freedom_);
}

Range Belief::probability_at_most(double x) const {
  if (is_sampled()) return range_of(distributions_, [x](const Possible& d) { return d.probability_below(x); });
  if (u_ == 0.0) return certain(value_ <= x);
  const double p = about_value(x);
  return {p, p};
}

Range Belief::probability_within(double limit, double shift) const {
  AXIOMETRY_CONTRACT(limit >= 0.0);
  const double low = -limit - shift;
  const double high = limit - shift;
  if (is_sampled())
    return range_of(distributions_, [=](const Possible& d) {
      return std::max(0.0, d.probability_below(high) - d.probability_below(low));
    });
  if (u_ == 0.0) return certain(low <= value_ && value_ <= high);
  const double p = about_value(high) - about_value(low);
  return {p, p};
}

Range Belief::quantile(double p) const {
  AXIOMETRY_CONTRACT(p > 0.0 && p < 1.0);
  if (is_sampled()) return range_of(distributions_, [p](const Possible& d) { return d.quantile(p); });
  const double z = std::isinf(degrees_of_freedom_) ? numeric::normal_quantile(p)
                                                   : numeric::student_t_quantile(p, degrees_of_freedom_);
  const double x = u_ == 0.0 ? value_ : value_ + u_ * z;
  return {x, x};
}

}  // namespace axiometry::uncertainty
