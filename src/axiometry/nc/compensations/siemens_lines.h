// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/nc/axis_table.h"
#include "axiometry/nc/table_text.h"

/// What the tables of SINUMERIK have in common: INI files of assignments, points N = 0 … k at one spacing.
namespace axiometry::nc::siemens {

/// _STEP, _MIN and _MAX as they are written.
struct Grid {
  std::string step, first, last;
};
/// Contract: check_limits() of a table of even spacing.
Grid grid_of_table(const AxisCorrection& correction, const AxisTableOptions& options);

/// Lines of assignments, without heads and comments, up to M17. Fails on a line behind it, and where it is missing.
Result<std::vector<TableLine>> assignments(std::string_view text);

/// The values by their N, in any order.
class Values {
 public:
  Result<void> put(std::string_view index, double value, const TableLine& line);
  /// Fails unless they are exactly 0 … count − 1: in a gap an old value would stay.
  Result<std::vector<double>> all(std::size_t count) const;

 private:
  std::map<long long, double> values_;
};

struct Frame {
  std::optional<double> step, min, max, is_modulo;

  /// By the end of a name in small letters, "step"; false where there is none such, or it was said before.
  bool put(std::string_view name, double value);
  /// (MAX − MIN)/STEP + 1. Fails where one is missing or they do not fit together, or a modulo is no whole turn.
  Result<std::size_t> points(const AxisTableOptions& options) const;
};

}  // namespace axiometry::nc::siemens
