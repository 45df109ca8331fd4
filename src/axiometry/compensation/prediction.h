// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>

#include "axiometry/base/result.h"
#include "axiometry/model/axis_correction.h"
#include "axiometry/model/series.h"

/// What a table would do to a test, and what no table can.
namespace axiometry::compensation {

/// The same series with something more at every target and direction.
Result<Series> shifted_series(const Series& series, const std::function<double(double, Direction)>& added);

/// The readings of the same test with `added` in the control in place of `removed` (none: with no table). A command
/// to P then moves to P + c(P): the deviation there is that of P but for its slope over c, of some µm, which is left
/// out.
Result<Series> corrected_series(const Series& series, const AxisCorrection& added,
                                const AxisCorrection* removed = nullptr);

/// Without the mean deviation of every target and direction: what the best table leaves, since it is the scatter.
Result<Series> scatter_alone(const Series& series);

/// Whether any target was approached twice from one side: without, nobody knows the scatter.
bool tells_scatter(const Series& series);

/// Standard uncertainty of a share that tells anything: shares that have a name, −1, 0, 1 and 2, lie 1 apart, and three
/// of it reach less than half way to the next.
inline constexpr double share_u_most = 0.15;

/// γ of x̄_retest − x̄_before = γ·c + a, by least squares.
struct TableShare {
  double share = 0.0;      ///< γ: 1 the table did what it should, 0 nothing, −1 the opposite, 2 twice
  double u = 0.0;          ///< standard uncertainty of γ, of the scatter of both tests and of what the line leaves
  double explained = 0.0;  ///< R² of that line
  bool is_line = true;     ///< what the line leaves is scatter, or less than a tenth of the change
  bool unchanged = false;  ///< the change is scatter, or less than a fifth of what the table should have made
};

/// How a re-test relates to what the table should have done, over all targets and directions; a for what a new zero of
/// the instrument does.
struct RetestEffect {
  TableShare whole;
  double u_of_scatter = 0.0;  ///< the part of u that the scatter of both tests makes
  /// γ of x̄↑ − x̄↓ alone, which no new zero and no shape of the axis can hide: −1 where directions are exchanged, 2
  /// where a backlash acts beside the table. Nothing where the table has none, or no target was approached from both
  /// sides in both tests.
  std::optional<double> of_reversal{};
  double u_of_reversal = 0.0;
  /// Of ↑ and of ↓ alone, each with an a of its own, so that the reversal has no part in it. Nothing where it does not
  /// tell.
  std::array<std::optional<TableShare>, 2> directions{};
  /// Whether the change is explained, as by a line, by all of the table with its directions exchanged, or with its
  /// positions mirrored from end to end.
  bool exchanged = false, mirrored = false;
  bool has_reversal = false;  ///< the table changes the reversal, by more than what rounding makes
  std::size_t compared = 0;   ///< targets and directions that both tests have
  std::size_t targets = 0;    ///< targets that both have, and the first and last of them
  double first = 0.0, last = 0.0;
};

/// `change` is what is added now less what was added in the first test. Nothing where fewer than three targets, or all
/// of a test of fewer, are in both tests (within `same_target_native`), or the change is the same at all of them.
std::optional<RetestEffect> effect_of_table(const Series& before, const Series& after, const AxisCorrection& added,
                                            const AxisCorrection* removed, double same_target_native);

}  // namespace axiometry::compensation
