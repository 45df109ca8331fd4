// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "axiometry/formats/text/units.h"
#include "axiometry/model/series.h"

/// What the name of a column, or the label of a row, means in the languages of the shop floor: English, German, French,
/// Italian, Spanish, Chinese, Japanese. Private to the generic importer.
namespace axiometry::formats::generic {

enum class HeadRole {
  unknown,
  target,
  deviation,
  measured,
  position,  ///< "position" alone: the target, or beside one the measured position
  direction,
  run,
  time,
  index,    ///< a running number of rows or points
  ignored,  ///< temperatures, comments, and what is computed from readings
};

struct Head {
  HeadRole role = HeadRole::unknown;
  const Unit* unit = nullptr;          ///< stated in the name
  std::optional<Direction> direction;  ///< stated in the name
  std::optional<std::size_t> run;      ///< the only number in the name
  bool target_minus_actual = false;    ///< "Soll - Ist": a deviation of the other sign
  bool sign_open = false;              ///< "Korrektur", "-Error", "Soll-Ist-Abweichung": it may be of the other sign
};

Head head_of(std::string_view name);

/// The unit that a cell of a line of units holds: "[mm]", "(µm)", "°"; null for other text.
const Unit* unit_in(std::string_view cell);

/// The direction that a cell in a column of directions says: the words of csv_cells.h and those of the languages above.
std::optional<Direction> direction_word(std::string_view cell);

}  // namespace axiometry::formats::generic
