// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/singles/single_means.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "axiometry/base/text/number_text.h"

namespace axiometry::app {
namespace {

using volumetric::SingleMotion;

bool is_one_sided(const PositionMeans& p) { return !p.up || !p.down; }

/// Takes one-sided positions off both ends; what was taken, or where one is left between others.
Result<std::vector<double>> without_one_sided_ends(std::vector<PositionMeans>& positions) {
  const auto first = std::ranges::find_if_not(positions, is_one_sided);
  auto last = positions.end();
  while (last != first && is_one_sided(*(last - 1))) --last;
  if (const auto between = std::find_if(first, last, is_one_sided); between != last)
    return fail(fmt::format("found {} mm approached from one side alone, expected both as at the other targets",
                            between->at_mm));
  std::vector<double> left_out;
  for (auto p = positions.begin(); p != positions.end(); ++p)
    if (p < first || p >= last) left_out.push_back(p->at_mm);
  positions = std::vector<PositionMeans>(first, last);
  return left_out;
}

void add_both(SingleMotion& motion, const DirectionMean& up, const DirectionMean& down, double instrument_u,
              const std::array<MeanScatter, 2>& scatter) {
  const double common = instrument_u * instrument_u;
  const double of_up = scatter[0].variance, of_down = scatter[1].variance;
  const double unknown = (up.s ? 0.0 : common) + (down.s ? 0.0 : common);
  motion.values.push_back(0.5 * (up.mean + down.mean));
  motion.u.push_back(std::sqrt(0.25 * (of_up + of_down) + common));
  motion.reversal->halves.push_back(0.5 * (up.mean - down.mean));
  motion.reversal->u.push_back(std::sqrt(0.25 * (of_up + of_down + unknown)));
  motion.reversal->covariances.push_back(0.25 * (of_up - of_down));
}

/// Which means have another s than all, as far as that is no chance.
void tell_scatter(const RunScatter& scatter, volumetric::ErrorMotion error, SingleMeans& read) {
  if (scatter.by_direction)
    read.remarks.push_back(fmt::format(
        "runs moving up scatter by {} {unit} (standard deviation), those moving down by {} {unit}: "
        "each direction has the uncertainty of its own runs",
        format_significant((*scatter.by_direction)[0], 2), format_significant((*scatter.by_direction)[1], 2),
        fmt::arg("unit", error.is_rotation() ? "µrad" : "µm")));
  std::string list;
  for (std::size_t i = 0; i < scatter.means.size(); ++i)
    for (const std::size_t direction : {0u, 1u})
      if (scatter.means[i][direction].stands_out)
        list += fmt::format("{}{} mm {}", list.empty() ? "" : ", ", format_exact(read.motion.positions_mm[i]),
                            direction == 0 ? "↑" : "↓");
  if (!list.empty())
    read.remarks.push_back(
        "runs scatter more here than elsewhere, as a wrong reading makes them too; each of these means has the "
        "scatter of its own runs alone in its uncertainty: " +
        list);
}

}  // namespace

Error no_uncertainty_of(std::string_view name) {
  return Error{fmt::format("found one run of {} and no uncertainty of its instrument, expected more runs or that "
                           "uncertainty: nothing tells how well it is known",
                           name),
               {},
               {}};
}

Error no_uncertainty_of_equal_runs(std::string_view name) {
  return Error{fmt::format("found runs of {} that agree to the last digit and no uncertainty of its instrument, "
                           "expected runs that differ or that uncertainty: nothing tells how well it is known",
                           name),
               {},
               {}};
}

Result<SingleMeans> single_means(volumetric::ErrorMotion error, std::vector<PositionMeans> positions,
                                 const std::optional<error_motions::InstrumentUncertainty>& instrument) {
  std::ranges::sort(positions, {}, &PositionMeans::at_mm);
  const bool up = std::ranges::any_of(positions, [](const PositionMeans& p) { return p.up.has_value(); });
  const bool both = up && std::ranges::any_of(positions, [](const PositionMeans& p) { return p.down.has_value(); });
  SingleMeans read{{error, {}, {}, {}, {}}, both ? "both" : up ? "up" : "down", 0.0, {}};
  const double lowest = positions.empty() ? 0.0 : positions.front().at_mm;
  if (both) {
    AXIOMETRY_TRY(const std::vector<double> left_out, without_one_sided_ends(positions));
    std::string list;
    for (const double at : left_out) list += fmt::format("{}{} mm", list.empty() ? "" : ", ", format_exact(at));
    if (!list.empty())
      read.remarks.push_back("positions at the ends that were approached from one side alone are left out: " + list);
    read.motion.reversal.emplace();
  }
  if (positions.size() < 2)
    return fail(both ? "found fewer than two positions approached from both sides, expected two or more"
                     : "found one position, expected two or more");
  bool is_one_run = false;
  const RunScatter scatter = run_scatter(positions);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const PositionMeans& p = positions[i];
    const double instrument_u = instrument ? instrument->standard(p.at_mm - lowest) : 0.0;
    for (const std::size_t direction : {0u, 1u}) {
      const auto& mean = direction == 0 ? p.up : p.down;
      if (mean && mean->s && scatter.means[i][direction].variance == 0.0 && instrument_u == 0.0)
        return instrument
                   ? fail(fmt::format("found runs of {} that agree to the last digit and 0 as uncertainty of its "
                                      "instrument at {} mm, expected runs that differ or an uncertainty above 0 "
                                      "there: nothing tells how well it is known",
                                      volumetric::error_name(error), format_shortest(p.at_mm)))
                   : std::unexpected(no_uncertainty_of_equal_runs(volumetric::error_name(error)));
      if (!mean || mean->s) continue;
      is_one_run = true;
      if (!instrument) return std::unexpected(no_uncertainty_of(volumetric::error_name(error)));
      if (instrument_u == 0.0)
        return fail(
            fmt::format("found one run of {} and 0 as uncertainty of its instrument at {} mm, expected more runs or an "
                        "uncertainty above 0 there: nothing tells how well it is known",
                        volumetric::error_name(error), format_shortest(p.at_mm)));
    }
    read.motion.positions_mm.push_back(p.at_mm);
    if (both) {
      add_both(read.motion, *p.up, *p.down, instrument_u, scatter.means[i]);
      read.reversal = std::max(read.reversal, std::abs(p.up->mean - p.down->mean));
    } else {
      const DirectionMean& one = up ? *p.up : *p.down;
      read.motion.values.push_back(one.mean);
      read.motion.u.push_back(std::sqrt(scatter.means[i][up ? 0 : 1].variance + instrument_u * instrument_u));
    }
  }
  tell_scatter(scatter, error, read);
  if (read.motion.reversal && is_one_run)
    read.remarks.emplace_back(
        "of one run of each direction, what these differ by is taken to be as uncertain as readings of the instrument "
        "that have nothing in common");
  return read;
}

}  // namespace axiometry::app
