// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/singles/single_errors.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/numeric/dense/dense.h"
#include "axiometry/volumetric/singles/measured_square.h"
#include "axiometry/volumetric/singles/single_bases.h"
#include "axiometry/volumetric/singles/single_inputs.h"
#include "axiometry/volumetric/singles/single_places.h"

namespace axiometry::volumetric {
namespace {

constexpr double lever_least_mm = 1e-6;  // µrad at this lever move by 1e-9 µm

/// Every coefficient as a sum of readings, and how it comes to its value.
class SingleAssembly {
 public:
  SingleAssembly(MachineModel machine, const SingleErrors& errors) : machine_(std::move(machine)), errors_(errors) {
    for (std::size_t k = 0; k < errors.motions.size(); ++k) of_error_[index(errors.motions[k].error)] = k;
  }

  Result<SingleModel> carry_out() {
    if (errors_.motions.empty() && errors_.squareness.empty()) return fail("found no errors, expected one or more");
    AXIOMETRY_TRY(SingleBases chosen, bases_of_singles(machine_.travel, errors_));
    AXIOMETRY_TRY_VOID(check_single_places(machine_, errors_));
    observed_ = chosen.ranges();
    bases_ = std::move(chosen.bases);
    cut_ = chosen.cut;
    findings_ = std::move(chosen.findings);
    inputs_.emplace(errors_, bases_);
    const bool by_direction =
        errors_.reversal != Reversal::none &&
        std::ranges::any_of(errors_.motions, [](const SingleMotion& m) { return m.reversal.has_value(); });
    const Coefficients coefficients({bases_[0], bases_[1], bases_[2]},
                                    by_direction ? Reversal::curves : Reversal::none);
    rows_ = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(coefficients.raw()),
                                  static_cast<Eigen::Index>(inputs_->count()));
    told_.assign(21, false);
    for (const std::size_t m :
         std::array<std::size_t, motion_count>{3, 4, 5, 0, 1, 2})  // displacements contain rotations
      for (std::size_t a = 0; a < axis_count; ++a) {
        put_motion(coefficients, {a, m});
        put_half(coefficients, {a, m});
      }
    for (std::size_t k = 0; k < errors_.squareness.size(); ++k) put_squareness(coefficients, k);
    return finish(coefficients);
  }

 private:
  static std::size_t index(ErrorMotion e) { return e.axis * motion_count + e.motion; }

  /// Of curves or halves of an axis that begin at `first`.
  static Eigen::Index place(std::size_t first, ErrorMotion e, std::size_t node) {
    return static_cast<Eigen::Index>(first + node * motion_count + e.motion);
  }

  Vector3 lever_mm(std::size_t axis, std::size_t node) const {
    const SinglePlace& at = *errors_.places[axis];
    Vector3 axes = at.axes_mm;
    axes[axis] = inputs_->node_mm(axis, node);
    return machine_.levers_mm(axes, at.tool_mm)[axis];
  }

  /// The two rotations that move along a direction, with the lever of each and its sign: [ω × r]_m = ω_{m+1} r_{m+2} −
  /// ω_{m+2} r_{m+1}.
  struct LeverTerm {
    ErrorMotion rotation;
    std::size_t lever;
    double sign;
  };
  static std::array<LeverTerm, 2> lever_terms(ErrorMotion e) {
    const std::size_t next = (e.motion + 1) % 3, last = (e.motion + 2) % 3;
    return {LeverTerm{{e.axis, first_rotation + next}, last, 1.0},
            LeverTerm{{e.axis, first_rotation + last}, next, -1.0}};
  }

  /// The longest lever of a rotation over the nodes, mm.
  double longest_lever(std::size_t axis, const LeverTerm& term) const {
    double longest = 0.0;
    for (std::size_t n = 0; n < bases_[axis].functions(); ++n)
      longest = std::max(longest, std::abs(lever_mm(axis, n)[term.lever]));
    return longest;
  }

  /// [ω × r]_m at each node as sums of readings, of the curves or halves of the axis that begin at `first`.
  Eigen::MatrixXd lever_effect(std::size_t first, ErrorMotion e) const {
    const std::size_t nodes = bases_[e.axis].functions();
    Eigen::MatrixXd effect = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(nodes), rows_.cols());
    for (const LeverTerm& term : lever_terms(e))
      for (std::size_t n = 0; n < nodes; ++n)  // µrad × mm = 1e-3 µm
        effect.row(static_cast<Eigen::Index>(n)) +=
            1e-3 * term.sign * lever_mm(e.axis, n)[term.lever] * rows_.row(place(first, term.rotation, n));
    return effect;
  }

  /// Rotations with a lever at the line of an error that are not `told`, behind those that are named already.
  void add_lacking(ErrorMotion e, const auto& told, std::string& lacks) const {
    for (const LeverTerm& term : lever_terms(e))
      if (const double longest = longest_lever(e.axis, term); longest > lever_least_mm && !told[index(term.rotation)])
        lacks += fmt::format("{}{} (lever {:.1f} mm)", lacks.empty() ? "" : ", ", error_name(term.rotation), longest);
  }

  /// What a rotation has beside its mean where its axis stood while `moved` did: half of what its directions differ by,
  /// with the sign of that in which the axis came to rest there. Where nothing says it, with one of which nothing is
  /// known: it is 0 with a standard uncertainty of that half.
  Eigen::RowVectorXd by_approach(std::size_t moved, ErrorMotion rotation, const ActiveFunctions& f) const {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(rows_.cols());
    const std::size_t item = *of_error_[index(rotation)];
    if (!errors_.motions[item].reversal) return sum;
    const Eigen::MatrixXd halves = inputs_->halves_at_nodes(item);
    for (std::size_t k = 0; k < f.count; ++k) sum += f.values[k] * halves.row(static_cast<Eigen::Index>(f.first + k));
    if (const double approach = errors_.places[moved]->approaches[rotation.axis]; approach != 0.0)
      return approach * sum;
    const double half_urad = sum.dot(inputs_->values());
    sum.setZero();
    sum[inputs_->approach(moved, rotation.axis)] = half_urad;
    return sum;
  }

  /// What the rotations of the other axes, where these stood, make of the slope of a line: those before it in the chain
  /// turn its direction, Σ_b [ω_b(q_b) × ∂r_b/∂q_a]_m, µrad, ω_b of the direction in which b came to rest.
  Eigen::RowVectorXd turned_by_others(const Coefficients& c, ErrorMotion line, std::string& lacks) const {
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(rows_.cols());
    const SinglePlace& at = *errors_.places[line.axis];
    Vector3 further = at.axes_mm;
    further[line.axis] += 1.0;
    const auto here = machine_.levers_mm(at.axes_mm, at.tool_mm), there = machine_.levers_mm(further, at.tool_mm);
    for (std::size_t b = 0; b < axis_count; ++b) {
      if (b == line.axis) continue;
      for (const LeverTerm& term : lever_terms({b, line.motion})) {
        const double per_mm = there[b][term.lever] - here[b][term.lever];
        if (std::abs(per_mm) < 1e-9) continue;
        if (!told_[index(term.rotation)]) {
          lacks += fmt::format("{}{}", lacks.empty() ? "" : ", ", error_name(term.rotation));
          continue;
        }
        const double stood_mm = at.axes_mm[b];
        if (stood_mm < bases_[b].lower_mm() - single_travel_slack_mm ||
            stood_mm > bases_[b].upper_mm() + single_travel_slack_mm) {
          lacks +=
              fmt::format("{}rotation {} at {} mm", lacks.empty() ? "" : ", ", error_name(term.rotation), stood_mm);
          continue;
        }
        const ActiveFunctions f = bases_[b].at(stood_mm);
        for (std::size_t k = 0; k < f.count; ++k)
          sum += term.sign * per_mm * f.values[k] * rows_.row(place(c.curve(b), term.rotation, f.first + k));
        sum += term.sign * per_mm * by_approach(line.axis, term.rotation, f);
      }
    }
    return sum;
  }

  /// Removes the mean and returns the slope over x from −1 to 1, as sums of readings; with `level` the slope goes too.
  Eigen::RowVectorXd to_gauge(std::size_t axis, Eigen::MatrixXd& nodes, bool level) const {
    const std::vector<double> means = bases_[axis].means(), slopes = bases_[axis].slopes();
    Eigen::RowVectorXd mean = Eigen::RowVectorXd::Zero(nodes.cols()), slope = mean;
    for (Eigen::Index n = 0; n < nodes.rows(); ++n) {
      mean += means[static_cast<std::size_t>(n)] * nodes.row(n);
      slope += 3.0 * slopes[static_cast<std::size_t>(n)] * nodes.row(n);  // ∫ x² is 1/3
    }
    for (Eigen::Index n = 0; n < nodes.rows(); ++n) {
      const double x = 2.0 * static_cast<double>(n) / static_cast<double>(nodes.rows() - 1) - 1.0;
      nodes.row(n) -= mean;
      if (level) nodes.row(n) -= x * slope;
    }
    return slope;
  }

  void put_motion(const Coefficients& c, ErrorMotion e) {
    const auto item = of_error_[index(e)];
    if (!item) return;
    tell_misfit(errors_.motions[*item]);
    Eigen::MatrixXd curve = inputs_->means_at_nodes(*item);
    if (!e.is_rotation()) {
      std::string lacks;
      add_lacking(e, told_, lacks);
      if (!lacks.empty()) {
        findings_.push_back(
            {"single-rotation-lacking", false,
             fmt::format("{} has no number: at its line it holds {}, not measured", error_name(e), lacks)});
        return;
      }
      curve -= lever_effect(c.curve(e.axis), e);
    }
    to_gauge(e.axis, curve, e.is_straightness());
    put_rows(c.curve(e.axis), e, curve);
    told_[index(e)] = true;
  }

  void put_rows(std::size_t first, ErrorMotion e, const Eigen::MatrixXd& at_nodes) {
    for (Eigen::Index n = 0; n < at_nodes.rows(); ++n)
      rows_.row(place(first, e, static_cast<std::size_t>(n))) = at_nodes.row(n);
  }

  /// Half of what the directions differ by. It stays as it was read, without a gauge: both were read from one zero.
  void put_half(const Coefficients& c, ErrorMotion e) {
    if (c.reversal() == Reversal::none || !told_[index(e)] || !errors_.motions[*of_error_[index(e)]].reversal) return;
    Eigen::MatrixXd half = inputs_->halves_at_nodes(*of_error_[index(e)]);
    if (!e.is_rotation()) {
      half -= lever_effect(c.half(e.axis), e);
      std::string lacks;
      add_lacking(e, told_halves_, lacks);
      if (!lacks.empty())
        findings_.push_back({"single-directions-lacking", false,
                             fmt::format("what the directions of {} differ by is told only at the line where it was "
                                         "read: there it holds {}, not read in both directions",
                                         error_name(e), lacks)});
    }
    put_rows(c.half(e.axis), e, half);
    told_halves_[index(e)] = true;
  }

  /// What is not told of the directions, as it stands in ErrorModel::Parts. A rotation that was not read in both is in
  /// what displacements differ by: their sum is told at the line where these were read, and nowhere else.
  void add_untold_halves(const Coefficients& c, std::vector<std::vector<double>>& unseen) const {
    for (std::size_t axis = 0; axis < axis_count; ++axis)
      for (std::size_t n = 0; n < c.half_functions(axis); ++n)
        for (std::size_t m = 0; m < motion_count; ++m) {
          const ErrorMotion untold{axis, m};
          if (told_halves_[index(untold)]) continue;
          Eigen::VectorXd direction = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(c.raw()));
          direction[place(c.half(axis), untold, n)] = 1.0;
          for (std::size_t d = 0; untold.is_rotation() && d < first_rotation; ++d)
            for (const LeverTerm& term : lever_terms({axis, d}))
              if (told_halves_[index({axis, d})] && term.rotation == untold)
                direction[place(c.half(axis), {axis, d}, n)] = -1e-3 * term.sign * lever_mm(axis, n)[term.lever];
          direction.normalize();
          unseen.emplace_back(direction.begin(), direction.end());
        }
  }

  /// How far readings between the nodes lie from the straight lines.
  void tell_misfit(const SingleMotion& m) {
    const CurveBasis& basis = bases_[m.error.axis];
    const bool has_halves = m.reversal && errors_.reversal != Reversal::none;
    const auto apart = [&](const std::vector<double>& numbers, std::size_t k) {
      const ActiveFunctions f = basis.at(m.positions_mm[k]);
      double shown = 0.0;
      for (std::size_t i = 0; i < f.count; ++i)
        shown += f.values[i] * inputs_->share_of(m, f.first + i).between(numbers);
      return shown - numbers[k];
    };
    double worst = 0.0;
    for (std::size_t k = 0; k < m.values.size(); ++k) {
      if (m.positions_mm[k] < basis.lower_mm() || m.positions_mm[k] > basis.upper_mm()) continue;
      // Of both directions the farther one: |mean| + |half|.
      const double of_half = has_halves ? std::abs(apart(m.reversal->halves, k)) : 0.0;
      worst = std::max(worst, std::abs(apart(m.values, k)) + of_half);
    }
    if (worst > 0.005)
      findings_.push_back(
          {"single-between-nodes", false,
           fmt::format("{}: readings between the {} nodes lie up to {:.2f} {} from the straight lines",
                       error_name(m.error), basis.functions(), worst, m.error.is_rotation() ? "µrad" : "µm")});
  }

  double urad_per_um(std::size_t axis) const {
    return 1e3 / (0.5 * (bases_[axis].upper_mm() - bases_[axis].lower_mm()));
  }

  /// By how much the slope of a line within the range of its curve is above that of the line as it was read, µrad. The
  /// measured squareness belongs to that one.
  Eigen::RowVectorXd slope_gained_by_cut(std::size_t item) const {
    const SingleMotion& m = errors_.motions[item];
    if (!inputs_->is_longer(m)) return Eigen::RowVectorXd::Zero(rows_.cols());
    Eigen::MatrixXd curve = inputs_->means_at_nodes(item);
    Eigen::RowVectorXd gained = urad_per_um(m.error.axis) * to_gauge(m.error.axis, curve, false);
    const std::vector<double> weights = curve_slope_weights(m.positions_mm);
    for (std::size_t k = 0; k < weights.size(); ++k) gained[inputs_->reading(item, k)] -= 1e3 * weights[k];
    return gained;
  }

  /// Of a line whose straightness is not given, and the errors of whose axis have different ranges.
  bool is_of_unknown_range(ErrorMotion line) const { return cut_[line.axis] && !of_error_[index(line)]; }

  /// By how much the slope of a line in the one direction in which it was read is above that of the mean of both, µrad;
  /// 0 where the straightness was not read in both: it is taken for the mean.
  Eigen::RowVectorXd slope_gained_by_direction(ErrorMotion line, double direction) const {
    const auto given = of_error_[index(line)];
    if (direction == 0.0 || !given || !errors_.motions[*given].reversal) return Eigen::RowVectorXd::Zero(rows_.cols());
    Eigen::MatrixXd half = inputs_->halves_at_nodes(*given);
    return direction * urad_per_um(line.axis) * to_gauge(line.axis, half, false);
  }

  void put_squareness(const Coefficients& c, std::size_t item) {
    const SingleSquareness& measured = errors_.squareness[item];
    const auto k = static_cast<std::size_t>(measured.which);
    const std::array<ErrorMotion, 2> lines = {square_lines[k].first, square_lines[k].second};
    std::string lacks;
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(rows_.cols());
    sum[inputs_->square(item)] = 1.0;
    for (std::size_t l = 0; l < lines.size(); ++l) {
      const ErrorMotion line = lines[l];
      if (!measured.over_common_range && is_of_unknown_range(line)) {
        findings_.push_back(
            {"single-squareness-range", false,
             fmt::format("{} has no number: the errors of {} were read over different ranges, and without {} nothing "
                         "tells over which the squareness was",
                         squareness_names[k], single_axis_letters[line.axis], error_name(line))});
        return;
      }
      add_lacking(line, told_, lacks);
      Eigen::MatrixXd effect = lever_effect(c.curve(line.axis), line);
      sum -= square_lines[k].sign *
             (urad_per_um(line.axis) * to_gauge(line.axis, effect, false) + turned_by_others(c, line, lacks) +
              slope_gained_by_direction(line, measured.directions[l]));
      if (const auto given = of_error_[index(line)]; given && !measured.over_common_range)
        sum += square_lines[k].sign * slope_gained_by_cut(*given);
    }
    if (!lacks.empty()) {
      findings_.push_back(
          {"single-squareness-lacking", false,
           fmt::format("{} has no number: its lines hold {}, not measured", squareness_names[k], lacks)});
      return;
    }
    tell_unknown_approaches(k, sum);
    rows_.row(static_cast<Eigen::Index>(c.squareness() + k)) = sum;
    told_[18 + k] = true;
  }

  /// Where it makes more than a third of everything else: that is 5 % of the uncertainty.
  void tell_unknown_approaches(std::size_t k, const Eigen::RowVectorXd& sum) {
    double variance = 0.0;
    std::string which;
    for (std::size_t moved = 0; moved < axis_count; ++moved)
      for (std::size_t stood = 0; stood < axis_count; ++stood) {
        const double urad = sum[inputs_->approach(moved, stood)];
        variance += urad * urad;
        if (urad != 0.0)
          which += fmt::format("{}{} while {} moved", which.empty() ? "" : ", ", single_axis_letters[stood],
                               single_axis_letters[moved]);
      }
    const double all = inputs_->covariance(sum)(0, 0);
    if (9.0 * variance <= all - variance) return;
    findings_.push_back(
        {"single-squareness-approach", false,
         fmt::format("{} is uncertain by {:.2f} µrad, with everything else by {:.2f} µrad, because nothing states in "
                     "which direction an axis came to rest that has other rotations in each: {}",
                     squareness_names[k], std::sqrt(variance), std::sqrt(all), which)});
  }

  Result<SingleModel> finish(const Coefficients& c) {
    const Eigen::VectorXd found = rows_ * inputs_->values();
    const Eigen::MatrixXd covariance = inputs_->covariance(rows_);
    ErrorModel::Parts parts{machine_, c, {}, {}, {}, observed_};
    parts.values.assign(found.data(), found.data() + found.size());
    parts.covariance.assign(covariance.data(), covariance.data() + covariance.size());  // symmetric
    std::string missing;
    const auto names = error_names();
    for (std::size_t k = 0; k < names.size(); ++k) {
      const bool given =
          k < 18 ? of_error_[k].has_value() : std::ranges::any_of(errors_.squareness, [&](const SingleSquareness& s) {
            return static_cast<std::size_t>(s.which) == k - 18;
          });
      if (!given) missing += (missing.empty() ? "" : ", ") + names[k];
    }
    if (!missing.empty())
      findings_.push_back(
          {"single-not-measured", false, fmt::format("not measured: {}; what depends on them has no number", missing)});
    for (std::size_t raw = 0; raw < c.half(0); ++raw) {
      if (told_[c.error_of(raw)]) continue;
      parts.unseen.emplace_back(c.raw(), 0.0).at(raw) = 1.0;
    }
    add_untold_halves(c, parts.unseen);
    return SingleModel{ErrorModel(std::move(parts)), std::move(findings_)};
  }

  MachineModel machine_;
  const SingleErrors& errors_;
  std::array<std::optional<std::size_t>, axis_count * motion_count> of_error_{};
  std::vector<CurveBasis> bases_;
  std::array<bool, axis_count> cut_{};  ///< whether some errors of an axis were read beyond its curves
  TravelBox observed_;
  std::optional<SingleInputs> inputs_;
  Eigen::MatrixXd rows_;
  std::vector<bool> told_;                                     ///< by error, in the order of error_names()
  std::array<bool, axis_count * motion_count> told_halves_{};  ///< likewise of reversal
  std::vector<NamedFinding> findings_;
};

}  // namespace

Result<SingleModel> model_of_singles(MachineModel machine, const SingleErrors& errors) {
  return SingleAssembly(std::move(machine), errors).carry_out();
}

}  // namespace axiometry::volumetric
