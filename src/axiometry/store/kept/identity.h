// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/records.h"

/// By what a machine, an axis or an instrument is known: letters' case and blanks around do not matter.
namespace axiometry::store {

bool same_word(std::string_view a, std::string_view b);
bool is_given(std::string_view text);

/// Where only one of them says who made it, they may be the same.
bool same_maker(std::string_view a, std::string_view b);

/// Refuses what no test could tell from another one of the archive but `own`: a serial number of the same maker twice;
/// without numbers the same name (machines), maker and type (instruments); the same kind and name of one machine's
/// axes.
Result<void> expect_only_one(Connection& connection, const MachineRecord& machine, Id own);
Result<void> expect_only_one(Connection& connection, const AxisRecord& axis, Id own);
Result<void> expect_only_one(Connection& connection, const InstrumentRecord& instrument, Id own);

/// Whether both are known by the same: what was there twice may still be given a remark.
bool same_identity(const MachineRecord& a, const MachineRecord& b);
bool same_identity(const AxisRecord& a, const AxisRecord& b);
bool same_identity(const InstrumentRecord& a, const InstrumentRecord& b);

}  // namespace axiometry::store
