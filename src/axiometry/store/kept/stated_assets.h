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

using KnownMachine = std::optional<Versioned<MachineRecord>>;
using KnownAxis = std::optional<Versioned<AxisRecord>>;
using KnownInstrument = std::optional<Versioned<InstrumentRecord>>;

/// The machine with the same serial number, now or before, unless both say who made it and differ. Else by its name,
/// now, or where none is called so as it was called before: of a test with a number the only one so called, if that
/// never had one, which it then takes over; of a test without one the only one so called, or the one that has none
/// either. Letters' case and blanks around do not matter.
Result<MachineMeant> machine_meant(Connection& connection, const MachineRecord& stated);
Result<KnownMachine> known_machine(Connection& connection, const MachineRecord& stated);

/// Whether a test that states no number stays with the machine that it was linked with: as long as that is or was
/// called so.
Result<bool> stays_linked(Connection& connection, Id linked, const MachineRecord& stated);

/// The machine's axis of the same kind and name, now or before.
Result<KnownAxis> known_axis(Connection& connection, Id machine, const AxisRecord& stated);

/// What a test states, and the machine that it is linked with where the archive has the test.
struct StatedAxis {
  const MachineRecord& machine;
  const AxisRecord& axis;
  std::optional<Id> linked{};
};
/// That axis of the machine that the test stays with, else of the one that it means.
Result<KnownAxis> known_axis(Connection& connection, const StatedAxis& stated);

/// The instrument with the same serial number, now or before, unless both say who made it and differ; of one without,
/// that of the same manufacturer and type which has none either, or the only one.
Result<KnownInstrument> known_instrument(Connection& connection, const InstrumentRecord& stated);

/// What the tests of one transaction state, which is mostly the same again and again: looked for once. The known one;
/// else it is added. Nothing where nothing is stated that it could be known by. A machine that takes over the number of
/// a test has a new version, which says so.
class StatedAssets {
 public:
  /// `linked`: the machine that the test to be revised is linked with, and stays with unless it states another one.
  StatedAssets(Connection& connection, Change change, std::optional<Id> linked = {})
      : connection_(connection), change_(std::move(change)), linked_(linked) {}

  Result<std::optional<Id>> machine(const MachineRecord& stated);
  Result<std::optional<Id>> axis(Id machine, const AxisRecord& stated);
  Result<std::optional<InstrumentUse>> instrument(const InstrumentRecord& stated);

 private:
  using Names = std::array<std::string, 3>;

  Result<Id> found_or_added(const MachineRecord& stated);
  Result<InstrumentUse> found_or_added(const InstrumentRecord& stated);

  Connection& connection_;
  Change change_;
  std::optional<Id> linked_;
  std::map<Names, std::optional<Id>> machines_;
  std::map<std::pair<Id, Names>, std::optional<Id>> axes_;
  std::map<Names, InstrumentUse> uses_;
  std::optional<std::vector<Versioned<InstrumentRecord>>> instruments_;  // all of the archive
};

}  // namespace axiometry::store
