// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: Annex A has U of the parameters only; what is composed here of its contributors is not
// printed there.
#include "axiometry/standards/iso230_2/uncertainty/annex_a_positions.h"
#include "axiometry/base/unit_sizes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiometry::iso230_2 {
namespace {

/// l_i, m. An L that is stated above the measured travel makes every length larger in that proportion.
double length_at(Position target, Position datum, double L_m, const Evaluation& evaluation) {
  const auto& positions = evaluation.positions;
  const double travel_m = (positions.back().target.in_native() - positions.front().target.in_native()) / mm_per_m;
  const double stretch = travel_m > 0.0 ? std::max(1.0, L_m / travel_m) : 1.0;
  return std::abs(target.in_native() - datum.in_native()) / mm_per_m * stretch;
}

/// A contributor of the budget for the length l in place of L. (A.4) is 0.3 R² l/L², in proportion to l like the
/// others.
double contribution_at(const Contributor& row, double l_m, const MeasuredLength& of_budget) {
  const double U = row.U->in_native();
  if (row.key == "probing" || row.key == "station" || of_budget.kind == AxisKind::rotary) return U;
  if (row.key == "device" && row.formula != "A.3") return of_budget.calibration.at(l_m);
  return of_budget.L_m > 0.0 ? U * (l_m / of_budget.L_m) : U;
}

/// `share`: of U_EVE² in the mean, 1/n or 1/2n.
AnnexAMean mean_with(double squares, const std::optional<Deviation>& U_eve, double share) {
  AnnexAMean mean;
  const double environment = U_eve ? U_eve->in_native() * std::sqrt(share) : 0.0;
  if (U_eve) mean.environment = Deviation::native(environment);
  mean.U = Deviation::native(std::sqrt(squares + environment * environment));
  return mean;
}

}  // namespace

std::vector<AnnexAPosition> annex_a_positions(const AnnexA& annex, const MeasuredLength& length,
                                              const Evaluation& evaluation) {
  const auto eve = std::ranges::find(annex.budget, "eve", &Contributor::key);
  const std::optional<Deviation> U_eve = eve == annex.budget.end() ? std::nullopt : eve->U;
  std::vector<AnnexAPosition> positions;
  positions.reserve(evaluation.positions.size());
  for (const PositionResult& p : evaluation.positions) {
    AnnexAPosition& row = positions.emplace_back();
    row.target = p.target;
    const double l_m = length_at(p.target, annex.datum, length.L_m, evaluation);
    if (length.kind == AxisKind::linear) row.length_m = l_m;
    double squares = 0.0;
    for (const Contributor& contributor : annex.budget) {
      auto& own = row.contributions.emplace_back();
      if (!contributor.U || contributor.key == "eve") continue;
      const double U = contribution_at(contributor, l_m, length);
      own = Deviation::native(U);
      squares += U * U;
    }
    const auto up = static_cast<double>(p.count_up), down = static_cast<double>(p.count_down);
    if (p.mean_up) row.up = mean_with(squares, U_eve, 1.0 / up);                       // A.15, A.17
    if (p.mean_down) row.down = mean_with(squares, U_eve, 1.0 / down);                 // A.15, A.17
    if (p.mean) row.mean = mean_with(squares, U_eve, 0.25 * (1.0 / up + 1.0 / down));  // A.16, A.18
  }
  return positions;
}

std::size_t smallest_count(const Series& series) {
  std::size_t smallest = std::numeric_limits<std::size_t>::max();
  for (std::size_t i = 0; i < series.target_count(); ++i)
    for (Direction direction : {Direction::up, Direction::down})
      if (const std::size_t n = series.count(i, direction); n > 0) smallest = std::min(smallest, n);
  return smallest;
}

std::vector<std::string_view> missing_contributors(std::span<const Contributor> budget, AxisKind kind) {
  const auto known = [&](std::string_view key) {
    return std::ranges::any_of(budget, [&](const Contributor& row) { return row.key == key && row.U; });
  };
  const bool linear = kind == AxisKind::linear;
  std::vector<std::string_view> missing;
  if (!known("device")) missing.emplace_back("device");
  // The beam of a tracking interferometer follows: what counts is where it starts.
  if (linear && !known("misalignment") && !known("station")) missing.emplace_back("misalignment");
  if (linear && !known("m_machine")) missing.emplace_back("m_machine");
  if (linear && !known("e_machine")) missing.emplace_back("e_machine");
  if (!known("eve")) missing.emplace_back("eve");
  return missing;
}

}  // namespace axiometry::iso230_2
