// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/store/database/connection.h"
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

/// What the tests of one transaction state, which is mostly the same again and again: looked for once. The known one;
/// else it is added. Nothing where nothing is stated that it could be known by.
class StatedAssets {
 public:
  StatedAssets(Connection& connection, Change change) : connection_(connection), change_(std::move(change)) {}

  Result<std::optional<Id>> machine(const Machine& stated);
  Result<std::optional<Id>> axis(Id machine, const Axis& stated);
  Result<std::optional<InstrumentUse>> instrument(const Instrument& stated);

 private:
  using Names = std::array<std::string, 3>;

  Result<InstrumentUse> found_or_added(const Instrument& stated);

  Connection& connection_;
  Change change_;
  std::map<Names, std::optional<Id>> machines_;
  std::map<std::pair<Id, Names>, std::optional<Id>> axes_;
  std::map<Names, InstrumentUse> uses_;
  std::optional<std::vector<Versioned<Instrument>>> instruments_;  // all of the archive
};

}  // namespace axiometry::store
