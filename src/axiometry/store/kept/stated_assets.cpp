// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/stated_assets.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/identity.h"

namespace axiometry::store {
namespace {

constexpr std::string_view number_taken = "serial number stated by a test";

/// A number or a maker that an earlier version did not say was not another one: it is the one said since.
template <typename Asset>
Asset completed(Asset earlier, const Asset& latest) {
  if constexpr (requires { earlier.serial_number; }) {
    if (!is_given(earlier.serial_number)) earlier.serial_number = latest.serial_number;
    if (!is_given(earlier.manufacturer)) earlier.manufacturer = latest.manufacturer;
  }
  return earlier;
}

/// The first asset whose latest version fits, else the first with any version that does.
template <typename Asset, typename Fits>
Result<std::optional<Versioned<Asset>>> find(Connection& connection, const std::vector<Versioned<Asset>>& assets,
                                             Fits fits) {
  for (const Versioned<Asset>& asset : assets)
    if (fits(asset.value)) return asset;
  for (const Versioned<Asset>& asset : assets) {
    if (asset.version == 1) continue;
    AXIOMETRY_TRY(const std::vector<Versioned<Asset>> versions, asset_versions<Asset>(connection, asset.id));
    for (const Versioned<Asset>& version : versions)
      if (fits(completed(version.value, asset.value))) return asset;
  }
  return std::nullopt;
}

/// Without a serial number only kind and maker tell: the one that has no number either, or the only one.
KnownInstrument unnumbered(const std::vector<Versioned<InstrumentRecord>>& instruments,
                           const InstrumentRecord& stated) {
  std::vector<const Versioned<InstrumentRecord>*> alike;
  for (const Versioned<InstrumentRecord>& instrument : instruments)
    if (same_word(instrument.value.manufacturer, stated.manufacturer) && same_word(instrument.value.type, stated.type))
      alike.push_back(&instrument);
  for (const auto* instrument : alike)
    if (alike.size() == 1 || !is_given(instrument->value.serial_number)) return *instrument;
  return std::nullopt;
}

Result<KnownInstrument> known_among(Connection& connection, const std::vector<Versioned<InstrumentRecord>>& instruments,
                                    const InstrumentRecord& stated) {
  const bool numbered = is_given(stated.serial_number);
  if (!numbered && !is_given(stated.manufacturer) && !is_given(stated.type)) return std::nullopt;
  if (!numbered) return unnumbered(instruments, stated);
  return find(connection, instruments, [&](const InstrumentRecord& instrument) {
    return same_word(instrument.serial_number, stated.serial_number) &&
           same_maker(instrument.manufacturer, stated.manufacturer);
  });
}

/// All that are called so; where none is, those that were.
Result<std::vector<Versioned<MachineRecord>>> machines_called(Connection& connection,
                                                              const std::vector<Versioned<MachineRecord>>& machines,
                                                              std::string_view name) {
  std::vector<Versioned<MachineRecord>> found;
  for (const Versioned<MachineRecord>& machine : machines)
    if (same_word(machine.value.name, name)) found.push_back(machine);
  if (!found.empty()) return found;
  for (const Versioned<MachineRecord>& machine : machines) {
    if (machine.version == 1) continue;
    AXIOMETRY_TRY(const auto versions, asset_versions<MachineRecord>(connection, machine.id));
    if (std::ranges::any_of(versions, [&](const auto& version) { return same_word(version.value.name, name); }))
      found.push_back(machine);
  }
  return found;
}

/// A number that no machine has: that of the only one so called, if it never had another.
Result<MachineMeant> first_of_number(Connection& connection, const std::vector<Versioned<MachineRecord>>& so_called) {
  if (so_called.size() != 1) return MachineMeant{};
  AXIOMETRY_TRY(const auto versions, asset_versions<MachineRecord>(connection, so_called.front().id));
  const bool had_one =
      std::ranges::any_of(versions, [](const auto& version) { return is_given(version.value.serial_number); });
  return had_one ? MachineMeant{} : MachineMeant{.known = so_called.front(), .takes_number = true};
}

/// Without a number only the name tells: the only one so called, else the one that has no number either.
MachineMeant without_number(const std::vector<Versioned<MachineRecord>>& so_called) {
  if (so_called.size() == 1) return {.known = so_called.front()};
  for (const Versioned<MachineRecord>& machine : so_called)
    if (!is_given(machine.value.serial_number)) return {.known = machine, .others = so_called.size() - 1};
  return {.others = so_called.size()};
}

}  // namespace

Result<MachineMeant> machine_meant(Connection& connection, const MachineRecord& stated) {
  const bool numbered = is_given(stated.serial_number);
  if (!numbered && !is_given(stated.name)) return MachineMeant{};
  AXIOMETRY_TRY(const auto machines, all_assets<MachineRecord>(connection));
  if (numbered) {
    AXIOMETRY_TRY(auto found, find(connection, machines, [&](const MachineRecord& machine) {
                    return same_word(machine.serial_number, stated.serial_number) &&
                           same_maker(machine.manufacturer, stated.manufacturer);
                  }));
    if (found) return MachineMeant{.known = std::move(found)};
  }
  if (!is_given(stated.name)) return MachineMeant{};
  AXIOMETRY_TRY(const auto so_called, machines_called(connection, machines, stated.name));
  return numbered ? first_of_number(connection, so_called) : without_number(so_called);
}

Result<KnownMachine> known_machine(Connection& connection, const MachineRecord& stated) {
  AXIOMETRY_TRY(MachineMeant meant, machine_meant(connection, stated));
  return std::move(meant.known);
}

Result<KnownAxis> known_axis(Connection& connection, Id machine, const AxisRecord& stated) {
  if (!is_given(stated.name)) return std::nullopt;
  AXIOMETRY_TRY(const auto axes, axes_of(connection, machine));
  for (const Versioned<AxisRecord>& axis : axes)  // archives of earlier versions hold "X" beside "x"
    if (axis.value.kind == stated.kind && axis.value.name == stated.name) return axis;
  return find(connection, axes,
              [&](const AxisRecord& axis) { return axis.kind == stated.kind && same_word(axis.name, stated.name); });
}

Result<bool> stays_linked(Connection& connection, Id linked, const MachineRecord& stated) {
  if (is_given(stated.serial_number) || !is_given(stated.name)) return false;
  AXIOMETRY_TRY(const auto versions, asset_versions<MachineRecord>(connection, linked));
  return std::ranges::any_of(versions, [&](const auto& version) { return same_word(version.value.name, stated.name); });
}

Result<KnownAxis> known_axis(Connection& connection, const StatedAxis& stated) {
  if (stated.linked) {
    AXIOMETRY_TRY(const bool stays, stays_linked(connection, *stated.linked, stated.machine));
    if (stays) return known_axis(connection, *stated.linked, stated.axis);
  }
  AXIOMETRY_TRY(const KnownMachine machine, known_machine(connection, stated.machine));
  if (!machine) return std::nullopt;
  return known_axis(connection, machine->id, stated.axis);
}

Result<KnownInstrument> known_instrument(Connection& connection, const InstrumentRecord& stated) {
  AXIOMETRY_TRY(const auto instruments, all_assets<InstrumentRecord>(connection));
  return known_among(connection, instruments, stated);
}

Result<Id> StatedAssets::found_or_added(const MachineRecord& stated) {
  AXIOMETRY_TRY(const MachineMeant meant, machine_meant(connection_, stated));
  if (meant.known && !meant.takes_number) return meant.known->id;
  machines_.clear();  // what a name alone means may be another one now
  if (meant.known) {
    Versioned<MachineRecord> numbered = *meant.known;
    ++numbered.version;
    numbered.value.serial_number = stated.serial_number;
    numbered.change = change_;
    numbered.change.reason =
        change_.reason.empty() ? std::string(number_taken) : fmt::format("{} ({})", number_taken, change_.reason);
    AXIOMETRY_TRY(numbered, change_asset(connection_, numbered));
    return numbered.id;
  }
  MachineRecord added = stated;
  if (!is_given(added.name)) added.name = is_given(added.type) ? added.type : added.serial_number;
  AXIOMETRY_TRY(const Versioned<MachineRecord> machine, add_asset(connection_, added, change_));
  return machine.id;
}

Result<std::optional<Id>> StatedAssets::machine(const MachineRecord& stated) {
  if (!is_given(stated.serial_number) && !is_given(stated.name)) return std::nullopt;
  if (linked_) {
    AXIOMETRY_TRY(const bool stays, stays_linked(connection_, *linked_, stated));
    if (stays) return linked_;
  }
  const Names names{stated.serial_number, stated.manufacturer, stated.name};
  if (const auto looked_for = machines_.find(names); looked_for != machines_.end()) return looked_for->second;
  AXIOMETRY_TRY(const Id id, found_or_added(stated));
  return machines_[names] = id;
}

Result<std::optional<Id>> StatedAssets::axis(Id machine, const AxisRecord& stated) {
  if (!is_given(stated.name)) return std::nullopt;
  const std::pair<Id, Names> names{machine, {stated.kind, stated.name}};
  if (const auto looked_for = axes_.find(names); looked_for != axes_.end()) return looked_for->second;
  AXIOMETRY_TRY(const KnownAxis known, known_axis(connection_, machine, stated));
  if (known) return axes_[names] = known->id;
  AxisRecord added = stated;
  added.machine = machine;
  AXIOMETRY_TRY(const Versioned<AxisRecord> axis, add_asset(connection_, added, change_));
  return axes_[names] = axis.id;
}

Result<InstrumentUse> StatedAssets::found_or_added(const InstrumentRecord& stated) {
  if (!instruments_) {
    AXIOMETRY_TRY(instruments_, all_assets<InstrumentRecord>(connection_));
  }
  AXIOMETRY_TRY(const KnownInstrument known, known_among(connection_, *instruments_, stated));
  if (known) return InstrumentUse{known->id, known->version};
  AXIOMETRY_TRY(const Versioned<InstrumentRecord> added, add_asset(connection_, stated, change_));
  instruments_->push_back(added);
  return InstrumentUse{added.id, added.version};
}

Result<std::optional<InstrumentUse>> StatedAssets::instrument(const InstrumentRecord& stated) {
  if (!is_given(stated.serial_number) && !is_given(stated.manufacturer) && !is_given(stated.type)) return std::nullopt;
  const Names names{stated.serial_number, stated.manufacturer, stated.type};
  if (const auto looked_for = uses_.find(names); looked_for != uses_.end()) return looked_for->second;
  AXIOMETRY_TRY(const InstrumentUse use, found_or_added(stated));
  uses_[names] = use;
  return use;
}

}  // namespace axiometry::store
