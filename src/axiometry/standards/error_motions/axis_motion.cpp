// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/error_motions/axis_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/numeric/moments.h"

namespace axiometry::error_motions {
namespace {

/// Σ c y of the readings of one run: for each direction its coefficients, one for each position, or none.
struct Functional {
  std::vector<std::vector<double>> by_direction;
};

class MotionEvaluation {
 public:
  MotionEvaluation(const MotionSeries& series, const MotionOptions& options)
      : series_(series),
        options_(options),
        weights_(slope_weights(series.positions_mm(), options.reference)),
        m_(series.positions_mm().size()),
        noise_(noise_within_runs()) {}

  AxisMotion evaluate() const {
    AxisMotion motion{.unit = series_.unit(), .reference = options_.reference, .runs = series_.runs()};
    const bool both = series_.directions().size() == 2;
    for (std::size_t d = 0; d < series_.directions().size(); ++d)
      motion.paths.push_back(path(series_.directions()[d] == Direction::up ? PathKind::up : PathKind::down, {d}));
    if (both) motion.paths.push_back(path(PathKind::mean, {0, 1}));
    for (std::size_t i = 0; i < m_; ++i) motion.positions.push_back(position(motion, i));
    put_maxima(motion);
    if (both) put_both(motion);
    return motion;
  }

 private:
  Functional nothing() const { return {std::vector<std::vector<double>>(series_.directions().size())}; }

  MotionPath path(PathKind kind, const std::vector<std::size_t>& directions) const {
    MotionPath path{.kind = kind};
    for (std::size_t i = 0; i < m_; ++i) {
      double sum = 0.0;
      for (const std::size_t d : directions) sum += direction_mean(d, i) / static_cast<double>(directions.size());
      path.means.push_back(sum);
    }
    const auto& x = series_.positions_mm();
    path.line = fit_line(x, path.means, options_.reference);
    path.residuals = line_residuals(x, path.means, options_.reference);
    const auto [low, high] = std::ranges::minmax_element(path.residuals);
    path.lowest = static_cast<std::size_t>(low - path.residuals.begin());
    path.highest = static_cast<std::size_t>(high - path.residuals.begin());
    path.range = estimate(*high - *low, spread(residual_difference(path.highest, path.lowest), directions));
    if (options_.reference == Reference::none) return path;

    std::vector<double> slope = weights_;
    for (double& w : slope) w *= 1e3;
    path.slope_per_m = line_figure(1e3 * path.line.slope_per_mm, slope, directions, path);
    path.intercept = line_figure(path.line.intercept, intercept_weights(), directions, path);
    return path;
  }

  double direction_mean(std::size_t d, std::size_t i) const {
    std::vector<double> values(series_.runs());
    for (std::size_t r = 0; r < values.size(); ++r) values[r] = series_.value(d, r, i);
    return numeric::moments(values).mean;
  }

  /// 0 where a mean of all readings is nothing but what doubles left of it. Of a sum of n terms up to y in size the
  /// roundings are at most n − 1 halves of ε n y, so those of both means and their difference, divided by their counts,
  /// stay below (runs + positions + 4) ε y (Higham, Accuracy and Stability of Numerical Algorithms, 4.2).
  double without_roundings(double mean) const {
    double largest = 0.0;
    for (std::size_t d = 0; d < series_.directions().size(); ++d)
      for (std::size_t r = 0; r < series_.runs(); ++r)
        for (std::size_t i = 0; i < m_; ++i) largest = std::max(largest, std::abs(series_.value(d, r, i)));
    const double bound =
        static_cast<double>(series_.runs() + m_ + 4) * std::numeric_limits<double>::epsilon() * largest;
    return std::abs(mean) <= bound ? 0.0 : mean;
  }

  /// Coefficients of e_p − e_q: δ_ip − δ_iq − (x_p − x_q) w_i.
  std::vector<double> residual_difference(std::size_t p, std::size_t q) const {
    const double between = series_.positions_mm()[p] - series_.positions_mm()[q];
    std::vector<double> c(m_);
    for (std::size_t i = 0; i < m_; ++i) c[i] = -between * weights_[i];
    c[p] += 1.0;
    c[q] -= 1.0;
    return c;
  }

  /// Of a = ȳ − b x̄, or y_1 − b x_1.
  std::vector<double> intercept_weights() const {
    const auto& x = series_.positions_mm();
    const bool ends = options_.reference == Reference::end_points;
    const double at = ends ? x.front() : numeric::moments(x).mean;
    std::vector<double> c(m_);
    for (std::size_t i = 0; i < m_; ++i) c[i] = (ends ? 0.0 : 1.0 / static_cast<double>(m_)) - at * weights_[i];
    if (ends) c.front() += 1.0;
    return c;
  }

  /// The same coefficients in each of the directions, which share them.
  Functional spread(const std::vector<double>& c, const std::vector<std::size_t>& directions) const {
    Functional f = nothing();
    for (const std::size_t d : directions) {
      f.by_direction[d] = c;
      for (double& x : f.by_direction[d]) x /= static_cast<double>(directions.size());
    }
    return f;
  }

  double of_run(const Functional& f, std::size_t run) const {
    double sum = 0.0;
    for (std::size_t d = 0; d < f.by_direction.size(); ++d)
      for (std::size_t i = 0; i < f.by_direction[d].size(); ++i) sum += f.by_direction[d][i] * series_.value(d, run, i);
    return sum;
  }

  MotionEstimate with_instrument(MotionEstimate e, const Functional& f) const {
    if (!options_.instrument) return e;
    const auto& x = series_.positions_mm();
    double bound = 0.0;
    for (const auto& c : f.by_direction)
      for (std::size_t i = 0; i < c.size(); ++i)
        bound += std::abs(c[i]) * options_.instrument->standard(x[i] - x.front());
    e.instrument_u = bound;
    return e;
  }

  /// What is left of each run when its own line (or mean) and the mean of what is left at its place are taken away.
  ScatterPart noise_within_runs() const {
    const std::size_t n = series_.runs(), d = series_.directions().size();
    const bool line = options_.reference != Reference::none;
    const std::size_t parameters = line ? 2 : 1;
    if (n < 2 || m_ <= parameters) return {};
    double squares = 0.0;
    for (std::size_t direction = 0; direction < d; ++direction) {
      std::vector<std::vector<double>> rests;
      for (std::size_t r = 0; r < n; ++r) {
        std::vector<double> values(m_);
        for (std::size_t i = 0; i < m_; ++i) values[i] = series_.value(direction, r, i);
        const double mean = numeric::moments(values).mean;
        if (line)
          values = line_residuals(series_.positions_mm(), values, Reference::least_squares);
        else
          for (double& x : values) x -= mean;
        rests.push_back(std::move(values));
      }
      for (std::size_t i = 0; i < m_; ++i) {
        std::vector<double> at_position(n);
        for (std::size_t r = 0; r < n; ++r) at_position[r] = rests[r][i];
        const double s = numeric::moments(at_position).standard_deviation;
        squares += s * s * static_cast<double>(n - 1);
      }
    }
    const auto degrees = static_cast<double>(d * (n - 1) * (m_ - parameters));
    return {std::sqrt(squares / degrees), degrees};
  }

  /// Of the runs' own figures, or of the noise within them, whichever has the larger U.
  void put_scatter(MotionEstimate& e, const Functional& f, const std::vector<double>& of_runs) const {
    const auto n = static_cast<double>(of_runs.size());
    const ScatterPart runs{numeric::moments(of_runs).standard_deviation / std::sqrt(n), n - 1.0};
    double weights = 0.0;
    for (const auto& c : f.by_direction)
      for (const double w : c) weights += w * w;
    const ScatterPart noise{noise_.u * std::sqrt(weights / n), noise_.degrees};
    const bool noisy = coverage_of(noise.degrees) * noise.u > coverage_of(runs.degrees) * runs.u;
    e.scatter = noisy ? MotionEstimate::Scatter::noise : MotionEstimate::Scatter::runs;
    e.scatter_u = noisy ? noise.u : runs.u;
    e.scatter_degrees = noisy ? noise.degrees : runs.degrees;
  }

  MotionEstimate estimate(double value, const Functional& f) const {
    MotionEstimate e{.value = value};
    if (series_.runs() >= 2) {
      std::vector<double> values;
      for (std::size_t r = 0; r < series_.runs(); ++r) values.push_back(of_run(f, r));
      put_scatter(e, f, values);
    }
    return combined(with_instrument(e, f));
  }

  /// A figure of the line: of a single run its scatter is that about the least-squares line, s √Σ c², which of the
  /// slope is s/√Σ (x_i − x̄)² by least squares and √2 s/(x_m − x_1) by end points.
  MotionEstimate line_figure(double value, const std::vector<double>& c, const std::vector<std::size_t>& directions,
                             const MotionPath& path) const {
    const Functional f = spread(c, directions);
    if (series_.runs() >= 2 || m_ < 3) return estimate(value, f);
    double squares = 0.0, weights = 0.0;
    for (const double e : line_residuals(series_.positions_mm(), path.means, Reference::least_squares))
      squares += e * e;
    for (const double w : c) weights += w * w;
    const auto degrees = static_cast<double>(m_ - 2);
    return combined(with_instrument({.value = value,
                                     .scatter = MotionEstimate::Scatter::residuals,
                                     .scatter_u = std::sqrt(squares / degrees * weights),
                                     .scatter_degrees = degrees},
                                    f));
  }

  MotionPosition position(const AxisMotion& motion, std::size_t i) const {
    MotionPosition p{.position_mm = series_.positions_mm()[i]};
    const bool both = series_.directions().size() == 2;
    if (both) p.reversal = motion.paths[0].means[i] - motion.paths[1].means[i];
    if (series_.runs() < 2) return p;
    std::vector<double> values(series_.runs());
    for (std::size_t d = 0; d < series_.directions().size(); ++d) {
      for (std::size_t r = 0; r < values.size(); ++r) values[r] = series_.value(d, r, i);
      const bool up = series_.directions()[d] == Direction::up;
      (up ? p.s_up : p.s_down) = numeric::moments(values).standard_deviation;
      (up ? p.repeatability_up : p.repeatability_down) = 4.0 * numeric::moments(values).standard_deviation;
    }
    if (both)
      p.repeatability = std::max(
          {2.0 * *p.s_up + 2.0 * *p.s_down + std::abs(*p.reversal), *p.repeatability_up, *p.repeatability_down});
    return p;
  }

  static void put_maxima(AxisMotion& motion) {
    const auto raise = [](std::optional<double>& most, const std::optional<double>& x) {
      if (x && (!most || *x > *most)) most = x;
    };
    for (const MotionPosition& p : motion.positions) {
      raise(motion.repeatability_up, p.repeatability_up);
      raise(motion.repeatability_down, p.repeatability_down);
      raise(motion.repeatability, p.repeatability);
    }
  }

  void put_both(AxisMotion& motion) const {
    const MotionPath& mean = motion.principal();
    std::size_t largest = 0, high_d = 0, high_i = 0, low_d = 0, low_i = 0;
    std::vector<double> reversals;
    const auto rest = [&](std::size_t d, std::size_t i) {
      return mean.residuals[i] + (motion.paths[d].means[i] - mean.means[i]);
    };
    for (std::size_t i = 0; i < m_; ++i) {
      reversals.push_back(*motion.positions[i].reversal);
      if (std::abs(reversals[i]) > std::abs(reversals[largest])) largest = i;
      for (const std::size_t d : {std::size_t{0}, std::size_t{1}}) {
        if (rest(d, i) > rest(high_d, high_i)) high_d = d, high_i = i;
        if (rest(d, i) < rest(low_d, low_i)) low_d = d, low_i = i;
      }
    }
    Functional reversal = nothing();
    for (auto& c : reversal.by_direction) c.assign(m_, 0.0);
    reversal.by_direction[0][largest] = 1.0;
    reversal.by_direction[1][largest] = -1.0;
    motion.reversal = estimate(reversals[largest], reversal);
    motion.reversal_mean = without_roundings(numeric::moments(reversals).mean);

    Functional range = nothing();
    const double between = series_.positions_mm()[high_i] - series_.positions_mm()[low_i];
    for (auto& c : range.by_direction)
      for (const double w : weights_) c.push_back(-between * w / 2.0);
    range.by_direction[high_d][high_i] += 1.0;
    range.by_direction[low_d][low_i] -= 1.0;
    motion.range_both = estimate(rest(high_d, high_i) - rest(low_d, low_i), range);
  }

  const MotionSeries& series_;
  const MotionOptions& options_;
  std::vector<double> weights_;
  std::size_t m_;
  ScatterPart noise_;  // s_w of one reading
};

}  // namespace

std::string_view path_mark(PathKind kind) { return kind == PathKind::up ? "↑" : kind == PathKind::down ? "↓" : "mean"; }

AxisMotion axis_motion(const MotionSeries& series, const MotionOptions& options) {
  return MotionEvaluation(series, options).evaluate();
}

}  // namespace axiometry::error_motions
