// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/model/axis.h"
#include "axiometry/standards/iso230_2/rules/claims.h"

/// What a result may be called, in the words that stand beside it everywhere.
namespace axiometry::report {

/// "Tested in accordance with ISO 230-2:2014", "Computed after clause 3 of ISO 230-2:2014; not a test in accordance
/// with it", "Formulas of ISO 230-2:2014 only". Without full stop.
std::string standing_text(const iso230_2::Claims& claims, const Axis& axis);

/// The same where a name has to do: "ISO 230-2:2014", "Computed after clause 3 of ISO 230-2:2014", "Formulas of …".
std::string standing_name(const iso230_2::Claims& claims, const Axis& axis);

/// Whether something known contradicts that the test was made after the standard, not only something left unsaid.
bool is_contradicted(const iso230_2::Claim& claim);

}  // namespace axiometry::report
