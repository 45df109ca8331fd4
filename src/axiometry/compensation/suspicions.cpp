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

// What a re-test shows.
constexpr double near_enough = 0.05;      // of a table alone, where more is left than it lets expect
constexpr double from_day_to_day = 0.15;  // of a table beside which no more is left than was expected
constexpr double part_most = 0.25;        // of what is a part of the table alone, beside a whole that fits

std::string share_words(const TableShare& found) {
  return fmt::format("{} ± {} (k = 2)", format_fixed(found.share, 2), format_fixed(2.0 * found.u, 2));
}

bool is_about(const TableShare& found, double share, double enough) {
  return std::abs(found.share - share) <= std::max(enough, 3.0 * found.u);
}

/// Within what share_words() says.
bool is_stated_to_be(const TableShare& found, double share) {
  constexpr double of_rounding = 0.005;
  return std::abs(found.share - share) <= std::max(of_rounding, 2.0 * found.u);
}

/// The re-test is the test but for what is small, and no share that matters could hide in it.
bool is_not_active(const RetestEffect& effect) {
  const bool reversal = effect.of_reversal && std::abs(*effect.of_reversal) > std::max(0.5, 3.0 * effect.u_of_reversal);
  return effect.whole.unchanged && !reversal && is_about(effect.whole, 0.0, near_enough) &&
         std::abs(effect.whole.share) + 2.0 * effect.whole.u < 0.5;
}

/// Each direction that tells, apart from the reversal.
bool directions_agree(const RetestEffect& effect, double share) {
  return std::ranges::all_of(effect.directions, [&](const std::optional<TableShare>& way) {
    return !way || (way->is_line && is_about(*way, share, part_most));
  });
}

/// Measured, and within its uncertainty.
bool reversal_may_be(const RetestEffect& effect, double share) {
  return effect.of_reversal && std::abs(*effect.of_reversal - share) <= std::max(part_most, 3.0 * effect.u_of_reversal);
}

/// One that was not measured contradicts nothing, and proves nothing either.
bool reversal_contradicts(const RetestEffect& effect, double share) {
  return effect.of_reversal && !reversal_may_be(effect, share);
}

/// The table has a reversal of which the re-test does not tell whether it is corrected: not measured, or as near to not
/// at all, or to twice.
bool is_reversal_untold(const RetestEffect& effect) {
  if (!effect.of_reversal) return effect.has_reversal;
  return reversal_may_be(effect, 1.0) && (reversal_may_be(effect, 0.0) || reversal_may_be(effect, 2.0));
}

bool acts_as_a_whole(const RetestEffect& effect, double share) {
  return effect.whole.is_line && is_about(effect.whole, share, near_enough) && directions_agree(effect, share) &&
         !reversal_contradicts(effect, share);
}

/// As it should, but perhaps for the reversal: by the whole where that is a line, or by both directions alone, where a
/// reversal that is wrong puts the whole out of line.
bool acts_in_each_direction(const RetestEffect& effect, double enough) {
  if (effect.whole.is_line && is_about(effect.whole, 1.0, enough) && directions_agree(effect, 1.0)) return true;
  return reversal_contradicts(effect, 1.0) && std::ranges::all_of(effect.directions, [enough](const auto& way) {
           return way && way->is_line && is_about(*way, 1.0, enough);
         });
}

NamedFinding finding_of_untold_reversal(const RetestEffect& effect) {
  const std::string share = share_words(effect.whole);
  if (!effect.of_reversal)
    return {"retest-reversal-untold", false,
            fmt::format("the re-test shows {} of the table, and nothing of its reversal: no target has approaches from "
                        "both sides in both tests",
                        share)};
  return {"retest-reversal-untold", false,
          fmt::format("the re-test shows {} of the table; of its reversal {} ± {} (k = 2), too uncertain to tell "
                      "whether it is corrected",
                      share, format_fixed(*effect.of_reversal, 2), format_fixed(2.0 * effect.u_of_reversal, 2))};
}

NamedFinding finding_of_active(const RetestEffect& effect, const RetestContext& context) {
  const std::string share = share_words(effect.whole);
  if (!reversal_contradicts(effect, 1.0)) {
    if (!context.above_expected && is_reversal_untold(effect)) return finding_of_untold_reversal(effect);
    if (!context.above_expected && is_about(effect.whole, 1.0, near_enough) && is_stated_to_be(effect.whole, 1.0))
      return {"retest-as-predicted", false,
              fmt::format("the table does what it should: the re-test shows {} of it", share)};
    if (!context.above_expected)
      return {"retest-as-predicted", false,
              fmt::format("no more is left than the table lets expect; the re-test shows {} of it", share)};
    return {"retest-more-left", true,
            fmt::format("the re-test shows {} of the table, and more is left than it lets expect: did axis or set-up "
                        "change?",
                        share)};
  }
  const std::string reversal = format_fixed(*effect.of_reversal, 2);
  if (reversal_may_be(effect, -1.0) && effect.exchanged)
    return {"retest-directions", true,
            fmt::format("the table's two directions are exchanged: the re-test shows {} of its reversal", reversal)};
  if (reversal_may_be(effect, 2.0))
    return {"retest-reversal-twice", true,
            fmt::format("the reversal is corrected twice, the re-test shows {} of it: is a backlash of the control "
                        "active beside the table?",
                        reversal)};
  if (reversal_may_be(effect, 0.0))
    return {"retest-reversal-not-active", true,
            fmt::format("the reversal is not corrected, the re-test shows {} of it", reversal)};
  return {"retest-reversal-otherwise", true,
          fmt::format("the re-test shows the table but for its reversal, of which it shows {}: is a backlash of the "
                      "control active beside it, or did the reversal change?",
                      reversal)};
}

/// One direction does what it should, and nothing happened to the other.
std::optional<NamedFinding> finding_of_one_direction(const RetestEffect& effect) {
  for (const Direction active : {Direction::up, Direction::down}) {
    const Direction other = active == Direction::up ? Direction::down : Direction::up;
    const auto& acts = effect.directions[static_cast<std::size_t>(active)];
    const auto& rests = effect.directions[static_cast<std::size_t>(other)];
    if (!acts || !rests || !acts->is_line || !is_about(*acts, 1.0, 2.0 * near_enough)) continue;
    if (!rests->unchanged || !is_about(*rests, 0.0, near_enough)) continue;
    return NamedFinding{
        "retest-one-direction", true,
        fmt::format("the table is active {} alone: the re-test shows {} of it {} and {} of it {}", arrow(active),
                    share_words(*acts), arrow(active), share_words(*rests), arrow(other))};
  }
  return std::nullopt;
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
  if (kind == AxisKind::rotary && series.target_count() > 1 && std::abs(series.travel_native() - 360.0) < 1e-6)
    for (const Direction direction : {Direction::up, Direction::down}) {
      const numeric::Moments first = numeric::moments(series.cell(0, direction));
      const numeric::Moments last = numeric::moments(series.cell(series.target_count() - 1, direction));
      if (first.count < 2 || last.count < 2) continue;
      const double difference = last.mean - first.mean;
      const double u = std::hypot(first.standard_deviation / std::sqrt(static_cast<double>(first.count)),
                                  last.standard_deviation / std::sqrt(static_cast<double>(last.count)));
      if (std::abs(difference) > 3.0 * u)
        findings.push_back({"compensation-turn-not-closed", true,
                            fmt::format("found deviations {} that differ by {} a whole turn apart, where the axis "
                                        "stands at the same place: drift, or a slip of the instrument; a table of a "
                                        "turning axis would jump there",
                                        arrow(direction), deviation_words(difference, kind))});
    }
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

NamedFinding finding_of_retest(const RetestEffect& effect, const RetestContext& context) {
  const std::string share = share_words(effect.whole);
  if (effect.u_of_scatter > share_u_most || (effect.whole.is_line && effect.whole.u > share_u_most))
    return {"retest-tells-nothing", false,
            fmt::format("the re-test shows {} of the table: too uncertain to tell whether it is active", share)};
  if (is_not_active(effect))
    return {"retest-not-active", true,
            fmt::format("the table is not active, the re-test shows {} of it: is it loaded, switched on, and the axis "
                        "referenced?",
                        share)};
  if (acts_as_a_whole(effect, -1.0))
    return {
        "retest-sign", true,
        fmt::format("the error has doubled, the re-test shows {} of the table: a sign mistake{}; take it out{}", share,
                    effect.exchanged || effect.mirrored
                        ? ", or directions exchanged or positions mirrored, which would show alike"
                        : "",
                    context.sign_inferred ? ", and make it with the other sign" : "")};
  if (acts_as_a_whole(effect, 2.0))
    return {"retest-twice", true,
            fmt::format("the table is applied twice, the re-test shows {} of it: is an older one still active beside "
                        "it, or was the new one added to one that holds it already?",
                        share)};
  // The scatter of both tests is in the uncertainty of the share, what changed from one day to the next is not.
  if (acts_in_each_direction(effect, context.above_expected ? near_enough : from_day_to_day))
    return finding_of_active(effect, context);
  if (auto one = finding_of_one_direction(effect)) return *std::move(one);
  if (!effect.whole.is_line && effect.exchanged && !effect.mirrored)
    return {"retest-directions", true,
            fmt::format("the table's two directions are exchanged: so the change from test to re-test is explained, "
                        "the table itself shows {} in it",
                        share)};
  if (!effect.whole.is_line && effect.mirrored && !effect.exchanged)
    return {"retest-mirrored", true,
            fmt::format("the table's positions are mirrored, the first value at the last position: so the change from "
                        "test to re-test is explained, the table itself shows {} in it",
                        share)};
  if (effect.whole.is_line && !reversal_contradicts(effect, effect.whole.share))
    return {"retest-otherwise", true,
            fmt::format("the re-test shows {} of the table, everywhere in proportion: is its scale another one in the "
                        "control (unit, count, magnification), or did axis or set-up change?",
                        share)};
  return {"retest-unexplained", true,
          fmt::format("the table explains {} % of the change from test to re-test, which shows {} of it: look whether "
                      "its directions are exchanged, its positions mirrored, one direction alone is active, another "
                      "table is, or axis or set-up changed",
                      format_fixed(100.0 * std::clamp(effect.whole.explained, 0.0, 1.0), 0), share)};
}

}  // namespace axiometry::compensation
