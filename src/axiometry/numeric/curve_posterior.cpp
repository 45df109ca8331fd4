// SPDX-License-Identifier: Apache-2.0
#include "axiometry/numeric/curve_posterior.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/curve_frame.h"
#include "axiometry/numeric/curve_kernel_types.h"
#include "axiometry/numeric/kernels/kernel_table.h"
#include "axiometry/numeric/series/chebyshev.h"

namespace axiometry::numeric {

AXIOMETRY_KERNEL_TABLE(curve_kernel, CurveKernel);

const CurveKernel& curve_kernel_of(VectorTarget target) { return curve_kernel_table.of(target); }

namespace {

constexpr std::size_t axes_places_max = 64;  // with more places a draw by states is faster
constexpr double least_in_noise = 0.05;      // amplitudes from a twentieth of the noise …
constexpr double most_in_seen = 4.0;         // … to four times what was seen beside the trend
constexpr std::size_t grid_size_max = 24;
constexpr std::size_t lengths_max = 4;
constexpr double likely = 1.0 / 2048;         // least weight of a hypothesis whose coordinates are kept
constexpr std::size_t normals_by_states = 5;  // numbers per place: three of the process, its noise, its rough part

/// 0, then octaves from `least` to `most`.
std::vector<double> octaves(double least, double most) {
  std::vector<double> grid = {0.0};
  const double count = std::clamp(std::ceil(std::log2(most / least)) + 1.0, 2.0, double(grid_size_max));
  for (double k = 0.0; k < count; ++k) grid.push_back(least * std::pow(most / least, k / (count - 1.0)));
  return grid;
}

/// Columns of m numbers, filled up with zeros.
std::vector<double> padded(std::span<const double> columns, std::size_t m, std::size_t stride) {
  std::vector<double> wide(m * stride, 0.0);
  for (std::size_t k = 0; k < m; ++k)
    std::copy_n(columns.begin() + static_cast<std::ptrdiff_t>(k * m), m,
                wide.begin() + static_cast<std::ptrdiff_t>(k * stride));
  return wide;
}

std::shared_ptr<const CurveFrame> frame_of(const NoisyCurve& data, std::size_t terms, CurveForm form,
                                           const CurveFrame* alike) {
  auto frame =
      std::make_shared<CurveFrame>(CurveFrame{{data.places.begin(), data.places.end()}, terms, {}, {}, 0, {}, {}});
  if (form == CurveForm::states) {
    frame->trend = trend_columns(data.places, terms);
    if (alike != nullptr && std::ranges::equal(alike->places, data.places)) frame->filters = alike->filters;
    if (frame->filters) return frame;
    std::vector<MaternFilter> filters;
    for (double length : smooth_lengths(data.places)) filters.emplace_back(data.places, length);
    frame->filters = std::make_shared<const std::vector<MaternFilter>>(std::move(filters));
  } else {
    const std::size_t m = data.places.size();
    frame->stride = (m + curve_padding - 1) / curve_padding * curve_padding;
    for (double length : smooth_lengths(data.places)) {
      frame->axes.emplace_back(data.places, terms, length);
      frame->padded_columns.push_back(padded(frame->axes.back().columns, m, frame->stride));
    }
  }
  return frame;
}

bool fits(const CurveFrame& frame, std::span<const double> places, std::size_t terms, CurveForm form) {
  return frame.terms == terms && frame.axes.empty() == (form == CurveForm::states) &&
         std::ranges::equal(frame.places, places);
}

double sum_of_squares(std::span<const double> values) {
  return std::inner_product(values.begin(), values.end(), values.begin(), 0.0);
}

std::vector<double> without_trend(std::vector<double> values, const CurveFrame& frame) {
  const std::size_t m = values.size();
  for (std::size_t k = 0; k < frame.terms; ++k) {
    const auto column = std::span(frame.trend).subspan(k * m, m);
    const double height = std::inner_product(values.begin(), values.end(), column.begin(), 0.0);
    for (std::size_t i = 0; i < m; ++i) values[i] -= height * column[i];
  }
  return values;
}

/// Points in ln λ that tell the logarithm of the determinant and the squares within 1e-10 m: in a strip of 0.9 π to
/// both sides of the interval no term of either is larger than 40.
std::size_t count_of_points(double lower, double upper) {
  constexpr double error = 1e-10, largest = 40.0, strip = 0.9 * 3.141592653589793;
  const double minor = strip / std::max(0.5 * (upper - lower), 1e-3);
  const double rho = minor + std::sqrt(minor * minor + 1.0);
  const double needed = std::log(4.0 * largest / (error * (rho - 1.0))) / std::log(rho);
  return std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(needed)) + 1);
}

}  // namespace

std::vector<double> smooth_lengths(std::span<const double> places) {
  const double range = places.back() - places.front();
  if (places.size() <= 2) return {1.0};  // there is nothing but the trend
  const double spacing = range / static_cast<double>(places.size() - 1);
  std::vector<double> found;
  for (double length = 0.6 * range; length > 1.4 * spacing && found.size() < lengths_max; length /= 2)
    found.push_back(length);
  if (found.empty()) found.push_back(0.6 * range);
  return found;
}

/// Logarithm of the determinant of λK + 1 and squares weighed by its inverse, both beside the trend, of every λ that a
/// hypothesis has.
class CurvePosterior::StatesLikelihood {
 public:
  StatesLikelihood(const CurveFrame& frame, std::span<const double> beside_trend, double least_ratio, double most_ratio)
      : freedom_(double(beside_trend.size() - frame.terms)),
        squares_(sum_of_squares(beside_trend)),
        points_(std::log(least_ratio), std::log(most_ratio),
                count_of_points(std::log(least_ratio), std::log(most_ratio))) {
    const auto points = points_.points();
    for (const MaternFilter& filter : *frame.filters) {
      OfLength& own = of_lengths_.emplace_back();
      for (std::size_t begin = 0; begin < points.size(); begin += MaternFilter::lanes) {
        MaternFilter::Ratios ratios;
        for (std::size_t k = 0; k < ratios.size(); ++k)
          ratios[k] = std::exp(points[std::min(begin + k, points.size() - 1)]);
        const auto found = filter.beside_trend(beside_trend, frame.filter_trend(), ratios);
        for (std::size_t k = 0; k < ratios.size() && begin + k < points.size(); ++k) {
          own.log_determinants.push_back(found[k].log_determinant);
          own.squares.push_back(found[k].squares);
        }
      }
    }
  }

  /// Up to a constant; `variance` is r.
  double of(std::size_t length, double smooth_variance, double variance) const {
    double log_determinant = 0.0, squares = squares_;
    if (smooth_variance > 0.0) {
      const double x = std::log(smooth_variance / variance);
      log_determinant = points_.interpolated(of_lengths_[length].log_determinants, x);
      squares = points_.interpolated(of_lengths_[length].squares, x);
    }
    return -0.5 * (log_determinant + freedom_ * std::log(variance) + squares / variance);
  }

 private:
  struct OfLength {
    std::vector<double> log_determinants, squares;
  };
  double freedom_;
  double squares_;
  ChebyshevPoints points_;
  std::vector<OfLength> of_lengths_;
};

CurvePosterior::CurvePosterior(const NoisyCurve& data, const CurvePosterior* alike)
    : values_(data.values.begin(), data.values.end()), noise_variance_(data.noise_variance) {
  AXIOMETRY_CONTRACT(data.places.size() == data.values.size() && !data.values.empty());
  AXIOMETRY_CONTRACT(noise_variance_ >= 0.0);
  trend_terms_ = std::min(data.trend_terms, size());
  form_ = data.form.value_or(size() > axes_places_max ? CurveForm::states : CurveForm::axes);
  AXIOMETRY_CONTRACT(form_ == CurveForm::axes || size() > trend_terms_);
  if (noise_variance_ == 0.0) return;
  const CurveFrame* const other = alike != nullptr ? alike->frame_.get() : nullptr;
  frame_ = other != nullptr && fits(*other, data.places, trend_terms_, form_)
               ? alike->frame_
               : frame_of(data, trend_terms_, form_, other);
  double squares = 0.0;
  if (form_ == CurveForm::axes) {
    for (const CurveAxes& axes : frame_->axes) coordinates_.push_back(axes.coordinates(values_));
    squares = sum_of_squares(std::span(coordinates_.front()).subspan(trend_terms_));
  } else {
    beside_trend_ = without_trend(without_trend(values_, *frame_), *frame_);
    squares = sum_of_squares(beside_trend_);
  }
  const std::size_t count = std::max<std::size_t>(1, size() - std::min(size(), trend_terms_));
  const double noise = std::sqrt(noise_variance_);
  const double seen = std::max(std::sqrt(squares / static_cast<double>(count)), 3.0 * noise);
  consider_hypotheses(octaves(least_in_noise * noise, most_in_seen * seen));
}

void CurvePosterior::consider_hypotheses(const std::vector<double>& amplitudes) {
  std::optional<StatesLikelihood> by_states;
  if (form_ == CurveForm::states) {
    const double least = amplitudes[1] * amplitudes[1], most = amplitudes.back() * amplitudes.back();
    by_states.emplace(*frame_, beside_trend_, least / (most + noise_variance_), most / noise_variance_);
  }
  const std::size_t lengths = by_states ? frame_->filters->size() : frame_->axes.size();
  std::vector<double> log_weights;
  for (std::size_t length = 0; length < lengths; ++length) {
    for (double smooth : amplitudes) {
      if (smooth == 0.0 && length > 0) continue;  // without a smooth part its length means nothing
      const double log_prior = smooth == 0.0 ? 0.0 : -std::log(static_cast<double>(lengths));
      for (double rough : amplitudes) {
        const Hypothesis hypothesis{length, smooth * smooth, rough * rough};
        log_weights.push_back(log_prior + (by_states ? by_states->of(length, hypothesis.smooth_variance,
                                                                     hypothesis.rough_variance + noise_variance_)
                                                     : log_likelihood(hypothesis)));
        hypotheses_.push_back(hypothesis);
      }
    }
  }
  choice_ = WeightedChoice::from_log_weights(log_weights);
  if (by_states) return;
  kept_.assign(hypotheses_.size(), not_kept);
  for (std::size_t h = 0; h < hypotheses_.size(); ++h) {
    if (choice_.probability(h) < likely) continue;
    kept_[h] = static_cast<std::uint32_t>(kept_coordinates_.size() / (2 * size()));
    append_coordinates(hypotheses_[h], kept_coordinates_);
  }
}

void CurvePosterior::append_coordinates(const Hypothesis& hypothesis, std::vector<double>& numbers) const {
  const std::size_t m = size(), begin = numbers.size();
  numbers.resize(begin + 2 * m);
  const CurveAxes& axes = frame_->axes[hypothesis.length];
  for (std::size_t k = 0; k < m; ++k) {
    const double prior = hypothesis.smooth_variance * axes.smooth[k] + hypothesis.rough_variance;
    const double shrink = k < trend_terms_ ? 1.0 : prior / (prior + noise_variance_);
    numbers[begin + k] = shrink * coordinates_[hypothesis.length][k];
    numbers[begin + m + k] = std::sqrt(shrink * noise_variance_);
  }
}

/// Of the coordinates beside the trend, up to a constant.
double CurvePosterior::log_likelihood(const Hypothesis& hypothesis) const {
  const CurveAxes& axes = frame_->axes[hypothesis.length];
  const std::vector<double>& coordinates = coordinates_[hypothesis.length];
  double sum = 0.0;
  for (std::size_t k = trend_terms_; k < size(); ++k) {
    const double variance = hypothesis.smooth_variance * axes.smooth[k] + hypothesis.rough_variance + noise_variance_;
    sum -= 0.5 * (std::log(variance) + coordinates[k] * coordinates[k] / variance);
  }
  return sum;
}

std::size_t CurvePosterior::normals_each() const {
  return form_ == CurveForm::states ? normals_by_states * size() : size();
}

void CurvePosterior::draw(const Numbers& numbers, Rows<double> curves) const {
  const std::size_t count = numbers.choices.size();
  AXIOMETRY_CONTRACT(curves.hold(size(), count) && numbers.stride >= normals_each());
  if (noise_variance_ == 0.0) {
    for (std::size_t i = 0; i < size(); ++i) std::ranges::fill(curves.row(i, count), values_[i]);
  } else if (form_ == CurveForm::axes) {
    draw_by_axes(numbers, curves);
  } else {
    draw_by_states(numbers, curves);
  }
}

/// First all choices: they are searched for by guesses, which would hold up what is between them.
void CurvePosterior::draw_by_axes(const Numbers& numbers, Rows<double> curves) const {
  const std::size_t m = size(), stride = frame_->stride, count = numbers.choices.size();
  std::vector<CurveView> views(count);
  std::vector<double> rare;
  const UnsetNumbers<double> drawn(count * stride);
  double* const values = drawn.all().data();
  for (std::size_t t = 0; t < count; ++t) {
    const std::size_t chosen = choice_(numbers.choices[t]);
    const double* own = nullptr;
    if (kept_[chosen] == not_kept) {
      rare.reserve(count * 2 * m);  // so that growing moves no coordinates
      append_coordinates(hypotheses_[chosen], rare);
      own = rare.data() + rare.size() - 2 * m;
    } else {
      own = kept_coordinates_.data() + kept_[chosen] * 2 * m;
    }
    views[t] = {own, own + m, frame_->padded_columns[hypotheses_[chosen].length].data(), m, stride};
  }
  curve_kernel_of(best_vector_target())
      .draw({views.data(), count, numbers.normals.data(), numbers.stride, values, stride});
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t t = 0; t < count; ++t) curves.values[i * curves.stride + t] = values[t * stride + i];
}

/// Curves of one length together, as many as a filter follows at once; the last group is filled up with its first.
void CurvePosterior::draw_by_states(const Numbers& numbers, Rows<double> curves) const {
  constexpr std::size_t lanes = MaternFilter::lanes;
  const std::size_t m = size(), count = numbers.choices.size();
  std::vector<std::pair<std::size_t, std::size_t>> order(count);  // hypothesis, curve
  for (std::size_t t = 0; t < count; ++t) order[t] = {choice_(numbers.choices[t]), t};
  std::ranges::sort(order);
  std::vector<double> process(3 * m * lanes), values(m * lanes);
  MaternFilter::Workspace workspace;
  for (std::size_t begin = 0; begin < count;) {
    const std::size_t length = hypotheses_[order[begin].first].length;
    std::size_t end = begin;
    while (end < count && end < begin + lanes && hypotheses_[order[end].first].length == length) ++end;
    std::array<std::size_t, lanes> trial;
    std::array<double, lanes> ratio, smooth, noise, rough, share;
    for (std::size_t l = 0; l < lanes; ++l) {
      const auto& [hypothesis, t] = order[begin + l < end ? begin + l : begin];
      const Hypothesis& own = hypotheses_[hypothesis];
      const double variance = own.rough_variance + noise_variance_;
      trial[l] = t;
      ratio[l] = own.smooth_variance / variance;
      smooth[l] = std::sqrt(own.smooth_variance);
      noise[l] = std::sqrt(variance);
      share[l] = noise_variance_ / variance;
      rough[l] = std::sqrt(share[l] * own.rough_variance);
    }
    const auto normal = [&](std::size_t l, std::size_t i, std::size_t k) {
      return numbers.normals[trial[l] * numbers.stride + normals_by_states * i + k];
    };
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        for (std::size_t l = 0; l < lanes; ++l) process[(3 * i + k) * lanes + l] = normal(l, i, k);
    const MaternFilter& filter = (*frame_->filters)[length];
    filter.simulate(process, values);
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t l = 0; l < lanes; ++l)
        values[i * lanes + l] = beside_trend_[i] - smooth[l] * values[i * lanes + l] - noise[l] * normal(l, i, 3);
    filter.weigh(frame_->filter_trend(), ratio, values, workspace);
    for (std::size_t i = 0; i < m; ++i)
      for (std::size_t l = 0; l < end - begin; ++l)
        curves.values[i * curves.stride + trial[l]] =
            values_[i] - share[l] * (noise[l] * normal(l, i, 3) + values[i * lanes + l]) - rough[l] * normal(l, i, 4);
    begin = end;
  }
}

}  // namespace axiometry::numeric
