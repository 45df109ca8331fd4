// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/field/line_prediction.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "axiometry/base/contract.h"
#include "axiometry/numeric/distributions/chi_square.h"
#include "axiometry/numeric/distributions/f_distribution.h"
#include "axiometry/volumetric/field/field_rows.h"

namespace axiometry::volumetric {
namespace {

DenseRow minus(const DenseRow& a, const DenseRow& b) {
  DenseRow result = a;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] -= b[k];
  return result;
}

std::vector<double> equidistant(double from, double to, std::size_t count) {
  std::vector<double> positions;
  for (std::size_t k = 0; k < count; ++k)
    positions.push_back(k + 1 == count ? to
                                       : from + (to - from) * static_cast<double>(k) / static_cast<double>(count - 1));
  return positions;
}

/// Rows of all deviations, less their mean.
std::vector<DenseRow> centred_rows(const ErrorModel& model, const TestedLine& line, bool has_directions) {
  const Vector3 along = unit(line.to_mm - line.from_mm);
  std::vector<DenseRow> rows;
  for (const double sign : {1.0, -1.0}) {
    if (sign < 0.0 && !has_directions) break;
    Approaches approaches{};
    if (has_directions)
      for (std::size_t a = 0; a < axis_count; ++a)
        approaches[a] = std::abs(along[a]) > 1e-9 ? std::copysign(sign, sign * along[a]) : 0.0;
    for (const double position : line.positions_mm)
      add_field(rows.emplace_back(), model, line.from_mm + (position - line.first_mm) * along, line.tool_mm, along,
                approaches);
  }
  DenseRow mean(model.coefficients().raw(), 0.0);
  for (const DenseRow& row : rows)
    for (std::size_t k = 0; k < mean.size(); ++k) mean[k] += row[k] / static_cast<double>(rows.size());
  for (DenseRow& row : rows) row = minus(row, mean);
  return rows;
}

/// Of the straight line through all deviations over their positions, µm per m.
DenseRow slope_row(const std::vector<DenseRow>& rows, const std::vector<double>& positions) {
  const std::size_t m = positions.size();
  const double middle = std::accumulate(positions.begin(), positions.end(), 0.0) / static_cast<double>(m);
  double squares = 0.0;
  for (std::size_t k = 0; k < rows.size(); ++k) squares += std::pow(positions[k % m] - middle, 2);
  DenseRow slope(rows.front().size(), 0.0);
  for (std::size_t k = 0; k < rows.size(); ++k)
    for (std::size_t i = 0; i < slope.size(); ++i)
      slope[i] += 1000.0 * (positions[k % m] - middle) / squares * rows[k][i];
  return slope;
}

/// Lower triangle of a positive definite matrix, in place; forward substitution gives |L⁻¹ d|².
double squares_over(std::vector<double> matrix, std::vector<double> d) {
  const std::size_t n = d.size();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      double sum = matrix[i * n + k];
      for (std::size_t j = 0; j < k; ++j) sum -= matrix[i * n + j] * matrix[k * n + j];
      matrix[i * n + k] = i == k ? std::sqrt(std::max(sum, 1e-12)) : sum / matrix[k * n + k];
    }
    for (std::size_t j = 0; j < i; ++j) d[i] -= matrix[i * n + j] * d[j];
    d[i] /= matrix[i * n + i];
  }
  return std::inner_product(d.begin(), d.end(), d.begin(), 0.0);
}

/// Both ends of a diagonal as shares of the travels: "NPP-PNN", "XY NP-PN", "NP0-PN0".
std::optional<std::pair<Vector3, Vector3>> ends_of(std::string_view name) {
  std::string first = "000", last = "000";
  const bool of_a_face = name.size() == 8 && name[2] == ' ' && name[5] == '-';
  if (of_a_face) {
    if (name[0] < 'X' || name[1] > 'Z' || name[0] >= name[1]) return std::nullopt;
    for (std::size_t k = 0; k < 2; ++k) {
      const auto a = static_cast<std::size_t>(name[k] - 'X');
      first[a] = name[3 + k];
      last[a] = name[6 + k];
    }
  } else if (name.size() == 7 && name[3] == '-') {
    first = name.substr(0, 3);
    last = name.substr(4);
  } else {
    return std::nullopt;
  }
  Vector3 from{0.5, 0.5, 0.5}, to = from;
  std::size_t moving = 0;
  for (std::size_t a = 0; a < axis_count; ++a) {
    if (first[a] == '0' && last[a] == '0') continue;
    const bool up = first[a] == 'N' && last[a] == 'P', down = first[a] == 'P' && last[a] == 'N';
    if (!up && !down) return std::nullopt;
    from[a] = up ? 0.0 : 1.0;
    to[a] = 1.0 - from[a];
    ++moving;
  }
  if (moving < 2) return std::nullopt;
  return std::pair{from, to};
}

bool are_told(const ErrorModel& model, const std::vector<DenseRow>& rows) {
  return std::ranges::all_of(rows, [&](const DenseRow& row) { return is_told(model, row); });
}

/// Errors whose directions are in what is not told of the rows.
std::vector<std::size_t> untold_reversals(const ErrorModel& model, const std::vector<DenseRow>& rows) {
  const Coefficients& c = model.coefficients();
  std::vector<bool> touched(axis_count * motion_count, false);
  for (const auto& direction : model.parts().unseen) {
    std::vector<std::size_t> open;  // coefficients of errors that no row has touched yet
    for (std::size_t k = c.half(0); k < c.raw(); ++k)
      if (std::abs(direction[k]) > told_most && !touched[c.error_of(k)]) open.push_back(k);
    for (auto row = rows.begin(); row != rows.end() && !open.empty(); ++row) {
      if (std::abs(std::inner_product(row->begin(), row->end(), direction.begin(), 0.0)) <= told_most) continue;
      for (const std::size_t k : open)
        if ((*row)[k] != 0.0) touched[c.error_of(k)] = true;
      std::erase_if(open, [&](std::size_t k) { return touched[c.error_of(k)]; });
    }
  }
  std::vector<std::size_t> errors;
  for (std::size_t e = 0; e < touched.size(); ++e)
    if (touched[e]) errors.push_back(e);
  return errors;
}

/// As if there were no other, less its own mean.
PredictedLine of_direction(const PredictedLine& both, Direction direction) {
  PredictedLine one{.line = both.line};
  one.up = direction == Direction::up ? both.up : both.down;
  const std::size_t m = one.up.size(), first = direction == Direction::up ? 0 : m;
  const double share = 1.0 / static_cast<double>(m);
  double mean = 0.0, mean_covariance = 0.0;
  std::vector<double> of_mean(m, 0.0);  // covariance of the mean with each target
  for (std::size_t i = 0; i < m; ++i) {
    mean += share * one.up[i].value;
    for (std::size_t k = 0; k < m; ++k) of_mean[i] += share * both.covariance_um2[(first + i) * 2 * m + first + k];
    mean_covariance += share * of_mean[i];
  }
  for (Estimate& e : one.up) e.value -= mean;
  one.down = one.up;
  for (std::size_t i = 0; i < m; ++i)
    for (std::size_t k = 0; k < m; ++k)
      one.covariance_um2.push_back(both.covariance_um2[(first + i) * 2 * m + first + k] - of_mean[i] - of_mean[k] +
                                   mean_covariance);
  return one;
}

/// That χ² is as large or larger, where `share` of the variance is known with so many degrees of freedom alone and the
/// rest exactly (Welch and Satterthwaite).
double probability_of(double chi_squared, double freedom, double share, double degrees) {
  if (std::isinf(degrees) || !(share > 0.0)) return 1.0 - numeric::chi_square_probability(chi_squared, freedom);
  return numeric::f_tail(chi_squared / freedom, {freedom, degrees / (share * share)});
}

UntoldReversal untold_reversal(const MeasuredMeans& measured) {
  constexpr double rounding_um2 = 1e-6;  // (1 nm)²: readings are printed to that
  UntoldReversal reversal;
  double least = measured.up_um.front(), most = least;
  for (std::size_t k = 0; k < measured.up_um.size(); ++k) {
    const double up = measured.up_um[k], down = measured.down_um[k];
    least = std::min({least, up, down});
    most = std::max({most, up, down});
    if (std::abs(up - down) > reversal.largest_um) {
      reversal.largest_um = std::abs(up - down);
      reversal.target = k;
    }
    const double variance = std::pow(measured.up_u_um[k], 2) + std::pow(measured.down_u_um[k], 2);
    reversal.chi_squared += (up - down) * (up - down) / (variance + rounding_um2);
  }
  reversal.systematic_um = most - least;
  reversal.degrees_of_freedom = measured.up_um.size();
  reversal.probability = probability_of(reversal.chi_squared, static_cast<double>(reversal.degrees_of_freedom), 1.0,
                                        measured.degrees_of_freedom);
  return reversal;
}

}  // namespace

std::optional<PredictedLine> predict_line(const ErrorModel& model, TestedLine line) {
  AXIOMETRY_CONTRACT(line.positions_mm.size() >= 2 && norm(line.to_mm - line.from_mm) > 0.0);
  bool has_directions = model.coefficients().reversal() != Reversal::none;
  std::vector<DenseRow> rows = centred_rows(model, line, has_directions);
  std::vector<std::size_t> untold;
  if (has_directions && !are_told(model, rows)) {
    untold = untold_reversals(model, rows);
    has_directions = false;
    rows = centred_rows(model, line, has_directions);
  }
  if (!are_told(model, rows)) return std::nullopt;
  const std::size_t m = line.positions_mm.size(), n = rows.size();
  PredictedLine predicted{
      .line = std::move(line), .has_directions = has_directions, .untold_reversals = std::move(untold)};
  predicted.covariance_um2.resize(n * n);
  std::vector<Estimate> all;
  for (std::size_t i = 0; i < n; ++i) {
    const DenseRow with = covariance_times(model, rows[i]);
    for (std::size_t k = 0; k < n; ++k)
      predicted.covariance_um2[i * n + k] = std::inner_product(with.begin(), with.end(), rows[k].begin(), 0.0);
    all.push_back(estimate_of(model, rows[i]));
  }
  predicted.up.assign(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(m));
  predicted.down.assign(all.end() - static_cast<std::ptrdiff_t>(m), all.end());
  const auto [least, largest] = std::ranges::minmax_element(all, {}, &Estimate::value);
  predicted.systematic = estimate_of(model, minus(rows[static_cast<std::size_t>(largest - all.begin())],
                                                  rows[static_cast<std::size_t>(least - all.begin())]));
  for (std::size_t k = 0; k < m; ++k)
    predicted.reversal_um = std::max(predicted.reversal_um, std::abs(predicted.up[k].value - predicted.down[k].value));
  predicted.slope_um_per_m = estimate_of(model, slope_row(rows, predicted.line.positions_mm));
  return predicted;
}

TestedLine axis_line(const ErrorModel& model, std::size_t axis, Vector3 through_mm, Vector3 tool_mm,
                     std::size_t targets) {
  const TravelBox& box = model.observed();
  TestedLine line{.name = std::string(1, "XYZ"[axis]), .from_mm = through_mm, .to_mm = through_mm, .tool_mm = tool_mm};
  line.from_mm[axis] = line.first_mm = box.lowest_mm[axis];
  line.to_mm[axis] = box.highest_mm[axis];
  line.positions_mm = equidistant(box.lowest_mm[axis], box.highest_mm[axis], targets);
  return line;
}

const std::vector<std::string>& diagonal_names() {
  static const std::vector<std::string> names = {"PPP-NNN",  "NPP-PNN",  "PNP-NPN",  "PPN-NNP",  "XY PP-NN",
                                                 "XY NP-PN", "XZ PP-NN", "XZ NP-PN", "YZ PP-NN", "YZ NP-PN"};
  return names;
}

std::optional<TestedLine> diagonal_line(const ErrorModel& model, std::string_view name, Vector3 tool_mm,
                                        std::size_t targets) {
  const auto ends = ends_of(name);
  if (!ends) return std::nullopt;
  const auto& [from, to] = *ends;
  TestedLine line{.name = std::string(name),
                  .from_mm = place_in(model.observed(), from),
                  .to_mm = place_in(model.observed(), to),
                  .tool_mm = tool_mm};
  line.positions_mm = equidistant(0.0, norm(line.to_mm - line.from_mm), targets);
  return line;
}

LineComparison compare(const PredictedLine& predicted, const MeasuredMeans& measured) {
  const std::size_t m = predicted.up.size();
  AXIOMETRY_CONTRACT(measured.up_um.size() == m && measured.down_um.size() == m);
  if (predicted.has_directions && !measured.both_directions) {
    const PredictedLine alone = of_direction(predicted, measured.direction);
    LineComparison one = compare(alone, measured);
    one.direction = measured.direction;
    const double mean =
        (measured.direction == Direction::up ? predicted.up : predicted.down).front().value - alone.up.front().value;
    for (std::vector<double>* values : {&one.measured_um, &one.predicted_um})
      for (double& value : *values) value += mean;
    return one;
  }
  LineComparison comparison;
  comparison.by_direction = predicted.has_directions;
  if (!comparison.by_direction && measured.both_directions) comparison.reversal = untold_reversal(measured);
  std::vector<double> variances;
  const auto take = [&](double value, double variance, double expected) {
    comparison.measured_um.push_back(value);
    variances.push_back(variance);
    comparison.predicted_um.push_back(expected);
  };
  const auto square = [](double x) { return x * x; };
  if (comparison.by_direction) {
    for (std::size_t k = 0; k < m; ++k) take(measured.up_um[k], square(measured.up_u_um[k]), predicted.up[k].value);
    for (std::size_t k = 0; k < m; ++k)
      take(measured.down_um[k], square(measured.down_u_um[k]), predicted.down[k].value);
  } else {
    for (std::size_t k = 0; k < m; ++k)
      take(0.5 * (measured.up_um[k] + measured.down_um[k]),
           0.25 * (square(measured.up_u_um[k]) + square(measured.down_u_um[k])), predicted.up[k].value);
  }
  const std::size_t n = comparison.measured_um.size();
  const double count = static_cast<double>(n);
  const double mean = std::accumulate(comparison.measured_um.begin(), comparison.measured_um.end(), 0.0) / count;
  const double mean_variance = std::accumulate(variances.begin(), variances.end(), 0.0) / count;
  std::vector<double> difference, covariance = predicted.covariance_um2;
  const std::vector<double>& positions_mm = predicted.line.positions_mm;
  const double middle_mm = std::accumulate(positions_mm.begin(), positions_mm.end(), 0.0) / static_cast<double>(m);
  std::vector<double> levers_mm;
  for (std::size_t i = 0; i < n; ++i) levers_mm.push_back(positions_mm[i % m] - middle_mm);
  for (std::size_t i = 0; i < n; ++i) {
    comparison.measured_um[i] -= mean;
    difference.push_back(comparison.measured_um[i] - comparison.predicted_um[i]);
    // Of values less their mean: v_i δ_ik − (v_i + v_k)/n + v̄/n; and of a slope.
    for (std::size_t k = 0; k < n; ++k)
      covariance[i * n + k] += (i == k ? variances[i] : 0.0) - (variances[i] + variances[k]) / count +
                               mean_variance / count + square(measured.slope_u_um_per_mm) * levers_mm[i] * levers_mm[k];
    comparison.normalised.push_back(difference[i] / std::sqrt(std::max(covariance[i * n + i], 1e-12)));
  }
  // Differences have no mean, so that what is added along the mean changes nothing but the rank; what is added to the
  // diagonal, (1 nm)², keeps the factorisation away from rounding.
  double trace = 0.0;
  for (std::size_t i = 0; i < n; ++i) trace += covariance[i * n + i];
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) covariance[i * n + k] += trace / (count * count) + (i == k ? 1e-6 : 0.0);
  const double levers_squared = std::inner_product(levers_mm.begin(), levers_mm.end(), levers_mm.begin(), 0.0);
  const double of_slope = square(measured.slope_u_um_per_mm) * levers_squared;
  const double share =
      std::min(1.0, mean_variance * (count - 1.0) / (trace - of_slope));  // of scatter, in what is no slope
  comparison.chi_squared = squares_over(covariance, difference);
  comparison.degrees_of_freedom = n - 1;
  comparison.probability = probability_of(comparison.chi_squared, count - 1.0, share, measured.degrees_of_freedom);
  if (of_slope > 0.0) {  // what is across the slope is known by more runs than what is along it: each by itself
    const double free = 1e6 * trace / levers_squared;
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) covariance[i * n + k] += free * levers_mm[i] * levers_mm[k];
    const double across = squares_over(std::move(covariance), std::move(difference));
    const double along = std::max(0.0, comparison.chi_squared - across);
    comparison.probability = std::min(
        1.0, 2.0 * std::min(n > 2 ? probability_of(across, count - 2.0, share, measured.degrees_of_freedom) : 1.0,
                            numeric::f_tail(along, {1.0, measured.slope_degrees_of_freedom})));
  }
  return comparison;
}

}  // namespace axiometry::volumetric
