// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/findings/reversal_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/volumetric/field/error_model.h"
#include "axiometry/volumetric/machine/error_motion.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr double usual_lever_m = 0.3;  // lever by which rotations are compared with displacements
constexpr double varies_chance_most = 1e-3;
constexpr double reversal_chance_most = 1e-4;  // low, since every set of lengths is searched unasked
constexpr double worth_a_fit = 1e-2;
constexpr std::size_t half_count = axis_count * motion_count;

std::string_view unit_of(ErrorMotion error) { return error.is_rotation() ? "µrad" : "µm"; }

/// Whether no direction of which the lengths say nothing changes this constant: with one tool a displacement and a
/// rotation of an axis are told apart by nothing.
bool is_told(const Coefficients& both, const Fit& fit, ErrorMotion error) {
  const std::size_t place = both.half(error.axis) + error.motion;
  return std::ranges::none_of(fit.solution.unseen(), [&](const std::vector<double>& direction) {
    return std::abs(direction[place]) > told_most;
  });
}

/// By how much an error differs between its directions, µm or µrad.
struct Difference {
  ErrorMotion error;
  double size = 0.0;
};

/// That which moves the tool point most.
Difference largest_difference(const Coefficients& coefficients, const State& state) {
  Difference largest;
  double farthest_um = -1.0;
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      const double size = 2.0 * std::abs(state.coefficients[coefficients.half(a) + m]);
      const double moved_um = m >= first_rotation ? usual_lever_m * size : size;
      if (moved_um <= farthest_um) continue;
      farthest_um = moved_um;
      largest = {{a, m}, size};
    }
  return largest;
}

/// Those whose directions are told: before the first move of an axis a constant would be one of places, of the first
/// layer of a grid for instance.
std::vector<std::size_t> of_told_directions(std::span<const std::size_t> kept, std::span<const Approaches> approaches) {
  std::vector<std::size_t> told;
  for (const std::size_t i : kept)
    if (!has_unknown_direction(approaches[i])) told.push_back(i);
  return told;
}

/// Where another error, of another axis too, may differ instead.
VolumetricFinding untold_difference() {
  return {"volumetric-reversal", false,
          "residuals go with the direction in which axes came to rest, and these stations and tools do not tell which "
          "error differs between both directions, or of which axis: what is stated of errors is of no direction, and "
          "reversal is to be asked for (constant)"};
}

/// Each constant of reversal in a length, but for what the curves hold of it.
using HalfRow = Eigen::Matrix<double, static_cast<int>(half_count), 1>;

HalfRow half_row(const Problem& problem, std::size_t i, const Approaches& approaches, Vector3 beam) {
  const std::array<Vector3, 3> levers = problem.machine.levers_mm(problem.readings[i].axes_mm, problem.tool_mm(i));
  HalfRow row;
  for (std::size_t a = 0; a < axis_count; ++a) {
    const Vector3 turn = cross(1e-3 * levers[a], beam);
    const std::array<double, motion_count> plucker{beam.x, beam.y, beam.z, turn.x, turn.y, turn.z};
    for (std::size_t m = 0; m < motion_count; ++m)
      row[static_cast<Eigen::Index>(a * motion_count + m)] = approaches[a] * plucker[m];
  }
  return row;
}

/// gᵀ S⁻¹ g, g = Σ w c v, S = Σ w c cᵀ over constants of reversal c: no more than χ² would fall by, for what curves and
/// stations hold of them makes S less. So a chance by this is too large, at the price of no fit.
double least_gain(const Problem& problem, const Fit& fit, std::span<const Approaches> approaches,
                  std::span<const std::size_t> kept) {
  constexpr double told_least = 1e-6;  // smallest eigenvalue of the scaled matrix that counts as told
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(half_count, half_count);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(half_count);
  for (const std::size_t i : kept) {
    if (problem.weights[i] == 0.0) continue;
    const HalfRow row = half_row(problem, i, approaches[i], fit.beams[i]);
    matrix.noalias() += problem.weights[i] * row * row.transpose();
    right += problem.weights[i] * fit.residuals_um[i] * row;
  }
  const Eigen::VectorXd scale = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(scaled);
  const Eigen::VectorXd scaled_right = scale.cwiseProduct(right);
  const Eigen::VectorXd along = solved.eigenvectors().transpose() * scaled_right;
  double gain = 0.0;
  for (Eigen::Index k = 0; k < along.size(); ++k)
    if (solved.eigenvalues()[k] > told_least) gain += along[k] * along[k] / solved.eigenvalues()[k];
  return gain;
}

/// That constant which is farthest from 0 in standard uncertainties.
Difference clearest_difference(const Coefficients& both, const Fit& fit) {
  const std::vector<double> covariance = fit.solution.coefficient_covariance();
  Difference clearest;
  double most = -1.0;
  for (std::size_t a = 0; a < axis_count; ++a)
    for (std::size_t m = 0; m < motion_count; ++m) {
      const std::size_t place = both.half(a) + m;
      const double half = std::abs(fit.state.coefficients[place]);
      const double u = std::sqrt(std::max(0.0, covariance[place * both.raw() + place]));
      if (!(u > 0.0) || half / u <= most) continue;
      most = half / u;
      clearest = {{a, m}, 2.0 * half};
    }
  return clearest;
}

std::optional<VolumetricFinding> reversal_beyond_chance(const Identifier& done, const VolumetricLengths& lengths,
                                                        std::span<const std::size_t> kept) {
  const std::vector<Approaches> approaches = directions_of_rest(lengths.readings);
  const double least = least_gain(done.problem(), done.fit(), approaches, kept);
  const auto unknowns = static_cast<double>(half_count);
  const FitQuality seen = seen_quality(done, kept);
  if (chance_of({least, unknowns}, {seen.chi_squared - least, seen.degrees_of_freedom - unknowns}) > worth_a_fit)
    return std::nullopt;
  const auto own = own_quality(done, kept);
  const Coefficients both = with_reversal(done.coefficients(), Reversal::constant);
  const auto tried = fitted_with(both, done, lengths, kept);
  if (!own || !tried) return std::nullopt;
  const Gained gained{own->chi_squared - tried->quality.chi_squared,
                      own->degrees_of_freedom - tried->quality.degrees_of_freedom};
  if (chance_of(gained, tried->quality) > reversal_chance_most) return std::nullopt;
  const Difference clearest = clearest_difference(both, tried->fit);
  if (!is_told(both, tried->fit, clearest.error)) return untold_difference();
  return VolumetricFinding{
      "volumetric-reversal", false,
      fmt::format("both directions of an axis differ: with a constant of each for each direction χ² falls from {:.0f} "
                  "to {:.0f} for {:.0f} more unknowns, as chance has it once in ten thousand cases at most; most "
                  "clearly {} differs, by {:.1f} {} between both directions of {}; what is stated of errors is of no "
                  "direction, and reversal is to be asked for (constant)",
                  own->chi_squared, tried->quality.chi_squared, gained.unknowns, error_name(clearest.error),
                  clearest.size, unit_of(clearest.error), "XYZ"[clearest.error.axis])};
}

/// What of the halves of all errors changes along their axes: of each error the part of its coefficients that is
/// orthogonal to those of a constant.
class Variations {
 public:
  Variations(const Coefficients& curves, const Fit& fit) : curves_(curves) {
    std::vector<std::vector<double>> rows;  // each row: the raw coefficients of one variation
    for (std::size_t e = 0; e < half_count; ++e) {
      first_.push_back(static_cast<Eigen::Index>(rows.size()));
      for (const std::vector<double>& contrast : contrasts_of(curves.basis(axis_of(e)))) rows.push_back(contrast);
    }
    first_.push_back(static_cast<Eigen::Index>(rows.size()));
    found_ = Eigen::VectorXd::Zero(first_.back());
    covariance_ = Eigen::MatrixXd::Zero(first_.back(), first_.back());
    const std::vector<double> raw = fit.solution.coefficient_covariance();
    for (std::size_t e = 0; e < half_count; ++e)
      for (std::size_t f = 0; f < half_count; ++f) add_errors(raw, rows, e, f);
    for (std::size_t e = 0; e < half_count; ++e)
      for (Eigen::Index i = first_[e]; i < first_[e + 1]; ++i) {
        const std::vector<double>& row = rows[static_cast<std::size_t>(i)];
        for (std::size_t k = 0; k < row.size(); ++k) found_[i] += row[k] * fit.state.coefficients[place(e, k)];
      }
    information_ = inverse(covariance_);
    score_ = information_ * found_;
  }

  /// χ² that falls by what changes along an axis while all others may change too.
  Gained along(std::size_t axis) const {
    const Eigen::Index first = first_[axis * motion_count], count = first_[(axis + 1) * motion_count] - first;
    const Eigen::VectorXd own = found_.segment(first, count);
    return {own.dot(inverse(covariance_.block(first, first, count, count)) * own), static_cast<double>(count)};
  }

  /// χ² that falls where a single error may change and none beside it.
  Gained single(std::size_t error) const {
    const Eigen::Index first = first_[error], count = first_[error + 1] - first;
    const Eigen::VectorXd score = score_.segment(first, count);
    return {score.dot(inverse(information_.block(first, first, count, count)) * score), static_cast<double>(count)};
  }

 private:
  static std::size_t axis_of(std::size_t error) { return error / motion_count; }

  /// All but the first row of the reflection that turns the coefficients of a constant into (1, 0, …).
  static std::vector<std::vector<double>> contrasts_of(const CurveBasis& basis) {
    const std::size_t n = basis.functions();
    std::vector<double> v(n, basis.kind() == CurveKind::legendre ? 0.0 : 1.0 / std::sqrt(static_cast<double>(n)));
    v[0] = basis.kind() == CurveKind::legendre ? 2.0 : v[0] + 1.0;
    double squares = 0.0;
    for (const double x : v) squares += x * x;
    std::vector<std::vector<double>> rows(n - 1, std::vector<double>(n, 0.0));
    for (std::size_t i = 1; i < n; ++i)
      for (std::size_t k = 0; k < n; ++k) rows[i - 1][k] = (i == k ? 1.0 : 0.0) - 2.0 * v[i] * v[k] / squares;
    return rows;
  }

  std::size_t place(std::size_t error, std::size_t function) const {
    return curves_.half(axis_of(error)) + function * motion_count + error % motion_count;
  }

  void add_errors(std::span<const double> raw, const std::vector<std::vector<double>>& rows, std::size_t e,
                  std::size_t f) {
    const std::size_t ne = curves_.basis(axis_of(e)).functions(), nf = curves_.basis(axis_of(f)).functions();
    Eigen::MatrixXd of_functions(ne, nf), left(ne - 1, ne), right(nf - 1, nf);
    for (std::size_t i = 0; i < ne; ++i)
      for (std::size_t k = 0; k < nf; ++k)
        of_functions(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
            raw[place(e, i) * curves_.raw() + place(f, k)];
    for (Eigen::Index i = 0; i < left.rows(); ++i)
      for (Eigen::Index k = 0; k < left.cols(); ++k)
        left(i, k) = rows[static_cast<std::size_t>(first_[e] + i)][static_cast<std::size_t>(k)];
    for (Eigen::Index i = 0; i < right.rows(); ++i)
      for (Eigen::Index k = 0; k < right.cols(); ++k)
        right(i, k) = rows[static_cast<std::size_t>(first_[f] + i)][static_cast<std::size_t>(k)];
    covariance_.block(first_[e], first_[f], left.rows(), right.rows()) = left * of_functions * right.transpose();
  }

  /// Of what is told alone; scaled, as each is known by its own.
  static Eigen::MatrixXd inverse(const Eigen::MatrixXd& matrix) {
    const Eigen::VectorXd scale = matrix.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(scaled);
    constexpr double told_least = 1e-12;  // rounding leaves 1e-15
    Eigen::VectorXd inverted = solved.eigenvalues();
    for (double& x : inverted) x = x > told_least ? 1.0 / x : 0.0;
    const Eigen::MatrixXd vectors = scale.asDiagonal() * solved.eigenvectors();
    return vectors * inverted.asDiagonal() * vectors.transpose();
  }

  const Coefficients& curves_;
  std::vector<Eigen::Index> first_;  ///< first unknown of each error
  Eigen::VectorXd found_, score_;
  Eigen::MatrixXd covariance_, information_;
};

/// Axes along which the difference of both directions changes, "X, Z", and that error of them which alone explains the
/// most of it; where single ones tell it.
struct Varying {
  std::string axes;
  std::optional<ErrorMotion> error;
};

Varying varying(const Coefficients& curves, const TriedFit& tried) {
  const Variations variations(curves, tried.fit);
  Varying found;
  double most = 0.0;
  for (std::size_t a = 0; a < axis_count; ++a) {
    if (chance_of(variations.along(a), tried.quality) > varies_chance_most / static_cast<double>(axis_count)) continue;
    found.axes += (found.axes.empty() ? "" : ", ") + std::string(1, "XYZ"[a]);
    for (std::size_t m = 0; m < motion_count; ++m) {
      const Gained single = variations.single(a * motion_count + m);
      if (single.chi_squared <= most) continue;
      if (chance_of(single, tried.quality) > varies_chance_most / static_cast<double>(half_count)) continue;
      most = single.chi_squared;
      found.error = ErrorMotion{a, m};
    }
  }
  return found;
}

std::optional<VolumetricFinding> varying_reversal(const Identifier& done, const VolumetricLengths& lengths,
                                                  std::span<const std::size_t> kept) {
  const auto own = own_quality(done, kept);
  const Coefficients curves = with_reversal(done.coefficients(), Reversal::curves);
  const auto tried = fitted_with(curves, done, lengths, kept);
  if (!own || !tried) return std::nullopt;
  const Gained gained{own->chi_squared - tried->quality.chi_squared,
                      own->degrees_of_freedom - tried->quality.degrees_of_freedom};
  if (chance_of(gained, tried->quality) > varies_chance_most) return std::nullopt;
  const Varying which = varying(curves, *tried);
  const std::string where = which.axes.empty() ? "an axis"
                            : which.error ? fmt::format("{}, most clearly of {}", which.axes, error_name(*which.error))
                                          : which.axes;
  return VolumetricFinding{
      "volumetric-reversal-varies", false,
      fmt::format(
          "what both directions differ by changes along {}: with curves in place of constants χ² falls from {:.0f} "
          "to {:.0f} for {:.0f} more unknowns, as chance has it once in a thousand cases at most; what is "
          "stated of each direction is too certain, and reversal is to be asked for as curves",
          where, own->chi_squared, tried->quality.chi_squared, gained.unknowns)};
}

}  // namespace

std::optional<VolumetricFinding> reversal_that_explains(const Identifier& done, const VolumetricLengths& lengths,
                                                        std::span<const std::size_t> kept) {
  if (done.coefficients().reversal() != Reversal::none) return std::nullopt;
  const std::vector<std::size_t> told = of_told_directions(kept, directions_of_rest(lengths.readings));
  if (told.empty()) return std::nullopt;
  const auto own = own_quality(done, told);
  const Coefficients both = with_reversal(done.coefficients(), Reversal::constant);
  const auto tried = fitted_with(both, done, lengths, told);
  if (!own || !tried || !explains(tried->quality, *own)) return std::nullopt;
  const Difference most = largest_difference(both, tried->fit.state);
  if (!is_told(both, tried->fit, most.error)) return untold_difference();
  return VolumetricFinding{
      "volumetric-reversal", false,
      fmt::format(
          "what residuals have too much goes with the direction in which axes came to rest: {} differs most, by "
          "{:.1f} {} between both directions of {}; where reversal is asked for (constant), errors hold it",
          error_name(most.error), most.size, unit_of(most.error), "XYZ"[most.error.axis])};
}

void add_reversal_beyond_chance(const Identifier& done, const VolumetricLengths& lengths,
                                std::vector<VolumetricFinding>& findings) {
  const Reversal asked = done.coefficients().reversal();
  if (asked == Reversal::curves || is_told_otherwise(findings)) return;
  const auto is_told = [&](const char* id) {
    return std::ranges::find(findings, id, &VolumetricFinding::id) != findings.end();
  };
  if (is_told("volumetric-reversal") || is_told("volumetric-chain-order")) return;
  const std::vector<std::size_t> kept = of_told_directions(readings_to_try(done), directions_of_rest(lengths.readings));
  if (kept.empty()) return;
  auto found =
      asked == Reversal::none ? reversal_beyond_chance(done, lengths, kept) : varying_reversal(done, lengths, kept);
  if (found) findings.push_back(*std::move(found));
}

}  // namespace axiometry::volumetric::detail
