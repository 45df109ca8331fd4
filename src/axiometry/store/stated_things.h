// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "axiometry/store/connection.h"
#include "axiometry/store/records.h"

/// Which machine, axis and instruments of the archive a test means by what it states.
namespace axiometry::store {

/// An instrument as it was known when a version of a test was made.
struct InstrumentUse {
  Id instrument = 0;
  int version = 1;

  friend bool operator==(const InstrumentUse&, const InstrumentUse&) = default;
};

/// The machine with the same serial number; else that of the same name, unless serial numbers differ; now, or as it
/// was called before. Else it is added. Nothing where neither is stated. Letters' case does not matter.
Result<std::optional<Id>> machine_of(Connection& connection, const Machine& stated, const Change& change);

/// The machine's axis of the same kind and name, now or before; else it is added. Nothing without a name.
Result<std::optional<Id>> axis_of(Connection& connection, Id machine, const Axis& stated, const Change& change);

/// The instrument with the same serial number; of one without, that of the same manufacturer and type which has none
/// either, or the only one. Else it is added. Nothing where neither is stated.
Result<std::optional<InstrumentUse>> instrument_of(Connection& connection, const Instrument& stated,
                                                   const Change& change);

}  // namespace axiometry::store
