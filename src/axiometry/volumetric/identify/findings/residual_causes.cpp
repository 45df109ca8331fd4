// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/findings/residual_causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/numeric/dense/dense.h"
#include "axiometry/volumetric/identify/equations/thinned_problem.h"
#include "axiometry/volumetric/identify/findings/reversal_causes.h"
#include "axiometry/volumetric/identify/findings/tried_fit.h"
#include "axiometry/volumetric/identify/strain_system.h"
#include "axiometry/volumetric/machine/error_motion.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr double strain_serious_ratio = 4.0;  // χ²/ν, the limit that holds for all scatter
constexpr std::size_t strain_readings_least = 20;
constexpr std::size_t strained_stretches_most = 60;

using Order = std::array<std::size_t, axis_count>;

std::string letters_of(const Order& order, std::string_view between) {
  std::string text;
  for (const std::size_t axis : order) text += (text.empty() ? "" : std::string(between)) + "XYZ"[axis];
  return text;
}

std::optional<VolumetricFinding> other_order(const Identifier& done, const MachineModel& machine,
                                             std::span<const std::size_t> kept, const FitQuality& own) {
  const Problem whole = done.problem();
  std::optional<TriedFit> best;
  Order best_order{}, order{0, 1, 2};
  do {
    if (order == machine.chain.order()) continue;
    MachineModel other = whole.machine;
    other.chain = *KinematicChain::make("F" + letters_of(order, ""));
    const ThinnedProblem few({other, whole.coefficients, whole.unknowns, whole.readings, whole.tools_mm,
                              whole.approaches, whole.weights, whole.threads},
                             kept);
    auto tried = fitted_to(few.problem(), done);
    if (!tried || (best && tried->quality.ratio() >= best->quality.ratio())) continue;
    best = std::move(tried);
    best_order = order;
  } while (std::ranges::next_permutation(order).found);
  if (!best || !explains(best->quality, own)) return std::nullopt;
  return VolumetricFinding{
      "volumetric-chain-order", true,
      fmt::format("the lengths fit axes in the order {} from the workpiece to the tool (χ²/ν = {:.2f}), not {} as the "
                  "chain {} has it (χ²/ν = {:.2f})",
                  letters_of(best_order, ", "), best->quality.ratio(), letters_of(machine.chain.order(), ", "),
                  machine.chain.text(), own.ratio())};
}

/// How much less χ² were if each of some stretches had axes of its own, and what each has of that.
struct StrainGain {
  double chi_squared = 0.0;
  std::size_t unknowns = 0;
  std::size_t worst_stretch = 0;
};

/// Of rising stretches: g (SᵀWS − SᵀWJ N⁻¹ JᵀWS)⁻¹ gᵀ, g = SᵀWv, with S the strains of every stretch and J what was
/// fitted. What all have in common is in the curves, and is no gain.
StrainGain strain_gain(const Problem& some, const Fit& fit, Vector3 middle_mm, std::span<const std::size_t> stretches) {
  constexpr double told_least = 1e-6;  // smallest eigenvalue of the scaled matrix that counts as told
  std::vector<ReadingGroup> groups(stretches.size());
  for (std::size_t i = 0; i < some.readings.size(); ++i) {
    const auto found = std::ranges::lower_bound(stretches, some.unknowns.stretch_of[i]);
    if (found != stretches.end() && *found == some.unknowns.stretch_of[i])
      groups[static_cast<std::size_t>(found - stretches.begin())].push_back(i);
  }
  std::vector<Strains> modes;
  for (int k = 0; k < strain_count; ++k) modes.push_back(Strains::Unit(k));
  const auto& [matrix, right, whole, steps] = strain_system(some, fit, groups, modes, middle_mm);
  const Eigen::Index columns = right.size();
  const Eigen::VectorXd scale = whole.cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * matrix * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solved(scaled);
  const Eigen::VectorXd scaled_right = scale.cwiseProduct(right);
  Eigen::VectorXd along = solved.eigenvectors().transpose() * scaled_right;
  StrainGain gain;
  for (Eigen::Index k = 0; k < columns; ++k) {
    const bool is_told = solved.eigenvalues()[k] > told_least;
    gain.chi_squared += is_told ? along[k] * along[k] / solved.eigenvalues()[k] : 0.0;
    gain.unknowns += is_told ? 1u : 0u;
    along[k] = is_told ? along[k] / solved.eigenvalues()[k] : 0.0;
  }
  const Eigen::VectorXd strain = solved.eigenvectors() * along;
  double most = 0.0;
  for (std::size_t j = 0; j < stretches.size(); ++j) {
    const auto first = static_cast<Eigen::Index>(strain_count * j);
    const double own = strain.segment(first, strain_count).dot(scaled_right.segment(first, strain_count));
    if (own <= most) continue;
    most = own;
    gain.worst_stretch = stretches[j];
  }
  return gain;
}

/// Those that tell axes of their own.
std::vector<std::size_t> stretches_to_strain(const Problem& some) {
  std::vector<std::size_t> counts(some.unknowns.stretches.size(), 0), stretches;
  for (std::size_t i = 0; i < some.readings.size(); ++i)
    if (some.weights[i] > 0.0) ++counts[some.unknowns.stretch_of[i]];
  for (std::size_t j = 0; j < counts.size(); ++j)
    if (counts[j] >= strain_readings_least) stretches.push_back(j);
  return stretches;
}

std::optional<VolumetricFinding> changed_axes(const Identifier& done, const VolumetricLengths& lengths,
                                              const Problem& some, const TriedFit& tried) {
  const FitQuality& own = tried.quality;
  const std::vector<std::size_t> stretches = stretches_to_strain(some);
  if (stretches.size() < 2 || stretches.size() > strained_stretches_most) return std::nullopt;
  const Vector3 middle_mm = done.middle_mm();
  const StrainGain gain = strain_gain(some, tried.fit, middle_mm, stretches);
  const double left = own.degrees_of_freedom - static_cast<double>(gain.unknowns);
  if (left < 1.0 || !explains({own.chi_squared - gain.chi_squared, left}, own)) return std::nullopt;
  const BeamStretch& stretch = some.unknowns.stretches[gain.worst_stretch];
  const VirtualStation& station = some.unknowns.stations[stretch.virtual_station];
  return VolumetricFinding{
      "volumetric-axes-changed", own.ratio() > strain_serious_ratio,
      fmt::format("the axes seem longer, shorter or less square for some of the lengths than for others, most of all "
                  "for station {} with tool {} in segment {}: machine or air were warmer or colder then, or lengths of "
                  "two days are mixed",
                  text::quoted(lengths.stations[station.station]), text::quoted(lengths.tools[station.tool]),
                  text::quoted(lengths.segments[stretch.segment]))};
}

}  // namespace

void add_residual_causes(const Identifier& done, const MachineModel& machine, const VolumetricLengths& lengths,
                         bool in_rows, std::vector<VolumetricFinding>& findings) {
  if (std::ranges::find(findings, "volumetric-scatter", &VolumetricFinding::id) == findings.end()) return;
  if (is_told_otherwise(findings)) return;
  const std::vector<std::size_t> kept = readings_to_try(done);
  const ThinnedProblem few(done.problem(), kept);
  const Problem some = few.problem();
  const auto own = fitted_to(some, done);
  if (!own || own->quality.excess() < gain_least) return;
  auto cause = other_order(done, machine, kept, own->quality);
  if (!cause && !in_rows) cause = reversal_that_explains(done, lengths, kept);
  if (!cause) cause = changed_axes(done, lengths, some, *own);
  if (cause) findings.push_back(*std::move(cause));
}

}  // namespace axiometry::volumetric::detail
