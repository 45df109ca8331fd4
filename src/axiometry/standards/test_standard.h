// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/model/axis.h"

/// Which standard a test of this axis may claim. One axis alone is tested after ISO 230-2; several that move at once
/// along a diagonal after ISO 230-6, whose parameters are those of ISO 230-2 (is_diagonal()). All that names a
/// standard beside a result asks here.
namespace axiometry {

/// "ISO 230-2" or "ISO 230-6".
std::string_view standard_of(const Axis& axis);

/// "ISO 230-2:2014", or "ISO 230-6:2002, parameters as in ISO 230-2:2014".
std::string edition_of(const Axis& axis);

/// What the reader must know of the edition, a sentence without full stop: the amendment of ISO 230-2 that was not
/// read, and that the text of ISO 230-6 was not at hand.
std::string edition_remark(const Axis& axis);

/// "axis" or "diagonal".
std::string_view word_for(const Axis& axis);

/// "Axis X", "Diagonal xyz"; without a name the word alone.
std::string title_of(const Axis& axis);

/// "X (linear axis)", "C (rotary axis)", "xyz (diagonal of X, Y and Z)"; without a name what stands in brackets.
std::string description_of(const Axis& axis);

/// Which axes of the machine move and where they go as position grows: "+X +Y −Z". Empty without a line in space.
std::string octant_of(const Axis& axis);

}  // namespace axiometry
