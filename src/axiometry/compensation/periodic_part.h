// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/model/series.h"
#include "axiometry/numeric/sine_beside_curve.h"

/// The periodic error of a screw or scale in the readings of a whole axis, which a table may take along or leave
/// (docs/theory/compensation.md). A test of its own for it is Annex C (standards/iso230_2/periodic).
namespace axiometry::compensation {

enum class Periodic {
  keep,   ///< the table follows the readings with all that is in them
  leave,  ///< the periodic part is taken out of the readings that make the table; it stays in what is predicted
};

/// Targets on even steps above half the period: sinusoids of two periods pass through the same readings.
struct Ambiguity {
  double step = 0.0;          ///< step between the targets, mm or °
  double other_period = 0.0;  ///< mm or °
  double amplitude = 0.0;     ///< amplitude of either sinusoid, µm or ″, the larger one of both directions
};

/// The fundamental of a known period in the means of each direction, beside a smooth curve
/// (numeric/sine_beside_curve.h).
struct PeriodicPart {
  double period = 0.0;                                                  ///< λ, mm or °
  std::array<std::optional<numeric::SineBesideCurve>, 2> directions{};  ///< sinusoids in ↑ and ↓, where told
  double widest_of_targets = 0.0;                                       ///< gap between two of them, mm or °
  std::optional<Ambiguity> ambiguity{};                                 ///< why it is not told, where it would be large

  /// Whether noise alone would make it as large in less than 1 % of tests.
  bool is_significant(Direction direction) const;
  bool is_significant() const { return is_significant(Direction::up) || is_significant(Direction::down); }
  bool is_told() const { return directions[0] || directions[1]; }
  /// µm or ″, of a direction in which it is significant; else 0.
  double at(double position, Direction direction) const;
};

/// Contract: a period above 0.
PeriodicPart periodic_part(const Series& series, double period);

/// The readings without it, where it is significant.
Result<Series> without_periodic(const Series& series, const PeriodicPart& part);

/// What a table with these positions does with the periodic part. Serious where it is in the readings, is kept, and the
/// positions, or the targets from which finer ones are filled in, lie further apart than half the period: then the
/// table holds what the targets happened to meet of it, and is wrong between them by up to twice its amplitude. So it
/// is where it may be in the readings (Ambiguity). Of a table to leave it: what was left out, or that nothing was.
std::vector<NamedFinding> findings_of_periodic(const PeriodicPart& part, Periodic choice, std::span<const double> nodes,
                                               AxisKind kind);

}  // namespace axiometry::compensation
