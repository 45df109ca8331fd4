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

using KnownMachine = std::optional<Versioned<Machine>>;
using KnownAxis = std::optional<Versioned<Axis>>;
using KnownInstrument = std::optional<Versioned<Instrument>>;

/// The machine with the same serial number, unless both say who made it and differ; else that of the same name, unless
/// serial numbers differ; now, or as it was called before, where a number or a maker first said since counts too.
/// Letters' case and blanks around do not matter.
Result<KnownMachine> known_machine(Connection& connection, const Machine& stated);

/// The machine's axis of the same kind and name, now or before.
Result<KnownAxis> known_axis(Connection& connection, Id machine, const Axis& stated);

/// The instrument with the same serial number, now or before, unless both say who made it and differ; of one without,
/// that of the same manufacturer and type which has none either, or the only one.
Result<KnownInstrument> known_instrument(Connection& connection, const Instrument& stated);

/// The known one; else it is added. Nothing where nothing is stated that it could be known by.
Result<std::optional<Id>> machine_of(Connection& connection, const Machine& stated, const Change& change);
Result<std::optional<Id>> axis_of(Connection& connection, Id machine, const Axis& stated, const Change& change);
Result<std::optional<InstrumentUse>> instrument_of(Connection& connection, const Instrument& stated,
                                                   const Change& change);

}  // namespace axiometry::store
