// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/suspicions.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/numeric/moments.h"
#include "axiometry/standards/iso230_2/programme.h"
#include "axiometry/standards/iso230_2/scatter/scatter.h"

namespace axiometry::compensation {
namespace {

constexpr double per_travel_most = 0.01;
constexpr double printed = 1e-3;      // mm or °: what positions in a file may lie beside
constexpr double much_beyond = 0.05;  // much, as a share of the measured travel
constexpr double near_known = 0.02;   // relative, of a slope that has a name

/// Of all means over the targets, position per position: 0.0001 is 0.1 µm in a mm.
double slope_of(const Series& series, AxisKind kind) {
  double weight = 0.0, x_sum = 0.0, y_sum = 0.0;
  std::vector<std::array<double, 2>> points;
  for (const Direction direction : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i) {
      const numeric::Moments m = numeric::moments(series.cell(i, direction));
      if (m.count == 0) continue;
      points.push_back({series.targets()[i].in_native(), m.mean / deviation_per_position(kind)});
      weight += 1.0, x_sum += points.back()[0], y_sum += points.back()[1];
    }
  double xx = 0.0, xy = 0.0;
  for (const auto& [x, y] : points) {
    const double dx = x - x_sum / weight;
    xx += dx * dx, xy += dx * (y - y_sum / weight);
  }
  return xx > 0.0 ? xy / xx : 0.0;
}

std::string deviation_words(double value, AxisKind kind) {
  return fmt::format("{:.1f} {}", value, deviation_unit(kind));
}

std::string place_words(double position, AxisKind kind) {
  return fmt::format("{} {}", format_rounded(position), position_unit(kind));
}

/// Of a programme that tells less of the axis than a table takes from it (5.3, 6.2).
void add_findings_of_programme(const Series& series, AxisKind kind, std::vector<NamedFinding>& findings) {
  if (!tells_scatter(series))
    findings.push_back({"compensation-one-approach", false,
                        "found no target that was approached twice from the same side: what of the deviations is "
                        "scatter nobody can tell, and the table corrects it too"});
  const Position travel = Position::native(series.travel_native());
  const iso230_2::Programme programme = iso230_2::programme_of(kind, travel);
  const std::size_t required = iso230_2::required_targets(programme, travel).count;
  if (series.target_count() < required)
    findings.push_back({"compensation-few-targets", false,
                        fmt::format("found {} targets where a test after ISO 230-2 has {} at least: what the axis does "
                                    "between them nobody measured",
                                    series.target_count(), required)});
}

/// The first target that stands again some whole turns later, and where it does: the same place of the axis.
std::vector<std::size_t> same_place(const Series& series) {
  constexpr double turn = 360.0, same = 1e-6;
  const auto targets = series.targets();
  for (std::size_t i = 0; i < targets.size() && targets.back().in_native() - targets[i].in_native() > turn - same;
       ++i) {
    std::vector<std::size_t> places = {i};
    for (std::size_t k = i + 1; k < targets.size(); ++k)
      if (std::abs(std::remainder(targets[k].in_native() - targets[i].in_native(), turn)) < same) places.push_back(k);
    if (places.size() > 1) return places;
  }
  return {};
}

/// Of an axis that turns: what it shows at one place, whole turns apart.
void add_findings_of_turns(const Series& series, std::vector<NamedFinding>& findings) {
  const std::vector<std::size_t> places = same_place(series);
  if (places.empty()) return;
  for (const Direction direction : {Direction::up, Direction::down}) {
    const numeric::Moments first = numeric::moments(series.cell(places.front(), direction));
    std::optional<double> largest;
    for (const std::size_t k : places) {
      const numeric::Moments again = numeric::moments(series.cell(k, direction));
      if (k == places.front() || first.count < 2 || again.count < 2) continue;
      const double difference = again.mean - first.mean;
      const double u = std::hypot(first.standard_deviation / std::sqrt(static_cast<double>(first.count)),
                                  again.standard_deviation / std::sqrt(static_cast<double>(again.count)));
      if (std::abs(difference) > 3.0 * u && std::abs(difference) > std::abs(largest.value_or(0.0)))
        largest = difference;
    }
    if (largest)
      findings.push_back({"compensation-turn-not-closed", true,
                          fmt::format("found deviations {} that differ by {} a whole turn apart, where the axis "
                                      "stands at the same place: drift, or a slip of the instrument; a table of a "
                                      "turning axis would jump there",
                                      arrow(direction), deviation_words(*largest, AxisKind::rotary))});
  }
}

/// How many positions lie within the targets and have none of them between the positions beside them.
std::size_t nodes_without_target(const Series& series, const std::vector<double>& nodes) {
  const double first = series.targets().front().in_native(), last = series.targets().back().in_native();
  std::size_t bare = 0, next = 0;  // next: the first target above the position before
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double below = k > 0 ? nodes[k - 1] : first - 1.0, above = k + 1 < nodes.size() ? nodes[k + 1] : last + 1.0;
    while (next < series.target_count() && series.targets()[next].in_native() <= below + printed) ++next;
    const bool is_within = nodes[k] >= first - printed && nodes[k] <= last + printed;
    const bool has_target = next < series.target_count() && series.targets()[next].in_native() < above - printed;
    if (is_within && !has_target) ++bare;
  }
  return bare;
}

std::string_view beyond_its_ends(const std::vector<double>& nodes, AxisKind kind, bool rolls_over) {
  if (!rolls_over) return "beyond its ends the control holds the last value";
  if (kind == AxisKind::linear) return "over the targets beyond its ends the file holds the last value";
  if (nodes.back() - nodes.front() > 360.0 - 1e-6)
    return "beyond its ends the control begins the turn anew, and what is foretold there counts on the last value";
  return "over the targets beyond its ends the file holds the last value, or goes on to that of the other end where "
         "the turn closes";
}

}  // namespace

Result<void> check_plausible(const Series& series, AxisKind kind) {
  const double slope = slope_of(series, kind);
  if (std::abs(slope) <= per_travel_most) return {};
  const auto is_near = [&](double known) {
    return std::abs(slope - known) < near_known * std::max(1.0, std::abs(known));
  };
  std::string why = "these are no deviations of an axis";
  if (is_near(-2.0))
    why = "the instrument counts against the axis: turn its sign, or the axis in the test";
  else if (is_near(-1.0))
    why = "the instrument did not see the axis move";
  else if (is_near(24.4))
    why = "the targets are in inches and the readings in mm";
  else if (is_near(1.0 / 25.4 - 1.0))
    why = "the targets are in mm and the readings in inches";
  return fail(fmt::format("found deviations that grow by {:.4g} % of the travel, expected less than {:.0f} %: {}",
                          100.0 * slope, 100.0 * per_travel_most, why));
}

std::vector<NamedFinding> findings_of_readings(const Series& series, AxisKind kind, TableCurves curves) {
  std::vector<NamedFinding> findings;
  const iso230_2::ScatterStudy scatter = iso230_2::scatter_study(series);
  for (const iso230_2::OutlyingReading& outlier : scatter.outliers) {
    const auto count = static_cast<double>(series.count(outlier.target, outlier.direction));
    findings.push_back(
        {"compensation-outlier", true,
         fmt::format("found an outlier at {} {} run {}: it lies {} from what the other readings let expect and moves "
                     "the mean there, and so the table, by {}; look at it before the table is used",
                     place_words(series.targets()[outlier.target].in_native(), kind), arrow(outlier.direction),
                     outlier.run + 1, deviation_words(std::abs(outlier.distance.in_native()), kind),
                     deviation_words(std::abs(outlier.distance.in_native()) / count, kind))});
  }
  if (scatter.uneven)
    findings.push_back(
        {"compensation-uneven-scatter", false,
         "found readings that scatter unevenly: what re-tests will show is reckoned from a scatter that is alike "
         "everywhere, and holds less often"});
  if (scatter.shifts && scatter.shifts->ordered)
    findings.push_back(
        {"compensation-drift", false,
         fmt::format("found readings that drift by {} from the first run to the last: the table corrects "
                     "the axis as it was on the average of the test",
                     deviation_words(std::abs(scatter.shifts->drift.in_native()), kind))});
  for (const Direction direction : {Direction::up, Direction::down})
    if (!series.has(direction))
      findings.push_back({"compensation-one-direction", true,
                          fmt::format("found no reading {}: what the table does to approaches from there nobody "
                                      "measured, and the reversal error stays as it is",
                                      arrow(direction))});
  if (curves == TableCurves::both_ways && series.has_both_directions())
    findings.push_back({"compensation-reversal-stays", false,
                        "the table has one curve for both directions: the reversal error stays as it is"});
  add_findings_of_programme(series, kind, findings);
  if (kind == AxisKind::rotary && series.target_count() > 2 && series.travel_native() < 360.0 - 1e-6) {
    const double left = 360.0 - series.travel_native();
    const double spacing = series.travel_native() / static_cast<double>(series.target_count() - 1);
    if (left < 1.5 * spacing)
      findings.push_back(
          {"compensation-turn-left-open", true,
           fmt::format("found targets over all of a turn but its last {}: there the table holds its last "
                       "value, and jumps where the turn begins anew; measure 360° too",
                       place_words(left, kind))});
  }
  if (kind == AxisKind::rotary) add_findings_of_turns(series, findings);
  return findings;
}

std::vector<NamedFinding> findings_of_table(const Series& series, const AxisCorrection& correction, bool rolls_over) {
  std::vector<NamedFinding> findings;
  const std::vector<double>& nodes = correction.positions();
  const AxisKind kind = correction.kind();
  if (nodes.size() < 2) return findings;
  const double first = series.targets().front().in_native(), last = series.targets().back().in_native();
  const double beyond = std::max(0.0, nodes.front() - first) + std::max(0.0, last - nodes.back());
  if (beyond > printed)
    findings.push_back(
        {"compensation-beyond-ends", beyond > much_beyond * (last - first),
         fmt::format("the table goes from {} to {}, the targets from {} to {}: {}", place_words(nodes.front(), kind),
                     place_words(nodes.back(), kind), place_words(first, kind), place_words(last, kind),
                     beyond_its_ends(nodes, kind, rolls_over))});
  if (nodes.front() < first - printed || nodes.back() > last + printed)
    findings.push_back({"compensation-ends-held", true,
                        fmt::format("the table goes from {} to {}, where {} to {} were measured: beyond them it holds "
                                    "the value of the last target, which nobody measured",
                                    place_words(nodes.front(), kind), place_words(nodes.back(), kind),
                                    place_words(first, kind), place_words(last, kind))});
  if (const std::size_t bare = nodes_without_target(series, nodes); bare > 0)
    findings.push_back(
        {"compensation-between-targets", false,
         fmt::format("found {} of the {} positions of the table without a target between their neighbours: there it "
                     "follows from the targets beside them, and what the axis does between these nobody measured",
                     bare, nodes.size())});
  return findings;
}

}  // namespace axiometry::compensation
