// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/standards/iso230_2/parameters.h"

namespace axiometry::report {

/// The targets that have a row in the tables of a report: all of up to 1000. Of more, which would be hundreds of pages,
/// about 500 at equal steps, the first, the last, and each at which a result of clause 3 is the lowest or highest of
/// all targets, so that every value that a parameter is made of stands there.
struct ShownTargets {
  std::vector<std::size_t> places;  ///< ascending, from 0
  std::optional<std::string> note;  ///< what is left out and where it is; nothing where all are there
};

ShownTargets shown_targets(const iso230_2::Evaluation& evaluation);

}  // namespace axiometry::report
