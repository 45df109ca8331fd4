// SPDX-License-Identifier: Apache-2.0
#include "axiometry/compensation/retest_findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"

namespace axiometry::compensation {
namespace {

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
              context.is_part
                  ? fmt::format("the table does what it should where it was measured again: the re-test shows {} of it",
                                share)
                  : fmt::format("the table does what it should: the re-test shows {} of it", share)};
    if (!context.above_expected && context.above_95)
      return {
          "retest-little-more-left", false,
          fmt::format("the re-test shows {} of the table; a little more is left than 95 % of re-tests would show, as "
                      "of one in twenty by chance",
                      share)};
    if (!context.above_expected)
      return {"retest-as-predicted", false,
              context.is_part
                  ? fmt::format("no more is left where it was measured again than the table lets expect; the re-test "
                                "shows {} of it",
                                share)
                  : fmt::format("no more is left than the table lets expect; the re-test shows {} of it", share)};
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

}  // namespace

std::optional<NamedFinding> finding_of_part(const RetestEffect& effect, const Series& before, AxisKind kind) {
  constexpr double most_of_travel = 0.9, most_of_targets = 0.5;
  const double travel = before.travel_native();
  const auto targets = static_cast<double>(before.target_count());
  if (effect.last - effect.first >= most_of_travel * travel &&
      static_cast<double>(effect.targets) >= most_of_targets * targets)
    return std::nullopt;
  return NamedFinding{
      "retest-part-of-table", false,
      fmt::format("found {} of the {} targets of the test in the re-test, from {} to {}: of the rest of the table it "
                  "tells nothing",
                  effect.targets, before.target_count(),
                  fmt::format("{} {}", format_rounded(effect.first), position_unit(kind)),
                  fmt::format("{} {}", format_rounded(effect.last), position_unit(kind)))};
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
