// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/stated_things.h"

#include "axiometry/base/text.h"
#include "axiometry/store/folded_text.h"
#include "axiometry/store/things.h"

namespace axiometry::store {
namespace {

bool same(std::string_view a, std::string_view b) { return folded(text::trim(a)) == folded(text::trim(b)); }
bool given(std::string_view text) { return !text::trim(text).empty(); }

/// The first thing whose latest version fits, else the first with any version that does.
template <typename Thing, typename Fits>
Result<std::optional<Versioned<Thing>>> find(Connection& connection, const std::vector<Versioned<Thing>>& things,
                                             Fits fits) {
  for (const Versioned<Thing>& thing : things)
    if (fits(thing.value)) return thing;
  for (const Versioned<Thing>& thing : things) {
    if (thing.version == 1) continue;
    AXIOMETRY_TRY(const std::vector<Versioned<Thing>> versions, thing_versions<Thing>(connection, thing.id));
    for (const Versioned<Thing>& version : versions)
      if (fits(version.value)) return thing;
  }
  return std::nullopt;
}

}  // namespace

Result<std::optional<Id>> machine_of(Connection& connection, const Machine& stated, const Change& change) {
  const bool numbered = given(stated.serial_number);
  if (!numbered && !given(stated.name)) return std::nullopt;
  AXIOMETRY_TRY(const auto machines, all_things<Machine>(connection));
  if (numbered) {
    AXIOMETRY_TRY(const auto found, find(connection, machines, [&](const Machine& machine) {
                    return same(machine.serial_number, stated.serial_number) &&
                           (!given(machine.manufacturer) || !given(stated.manufacturer) ||
                            same(machine.manufacturer, stated.manufacturer));
                  }));
    if (found) return found->id;
  }
  if (given(stated.name)) {
    AXIOMETRY_TRY(const auto found, find(connection, machines, [&](const Machine& machine) {
                    return same(machine.name, stated.name) && (!numbered || !given(machine.serial_number));
                  }));
    if (found) return found->id;
  }
  Machine added = stated;
  if (!given(added.name)) added.name = given(added.type) ? added.type : added.serial_number;
  AXIOMETRY_TRY(const Versioned<Machine> machine, add_thing(connection, added, change));
  return machine.id;
}

Result<std::optional<Id>> axis_of(Connection& connection, Id machine, const Axis& stated, const Change& change) {
  if (!given(stated.name)) return std::nullopt;
  AXIOMETRY_TRY(const auto axes, axes_of(connection, machine));
  AXIOMETRY_TRY(const auto found, find(connection, axes, [&](const Axis& axis) {
                  return axis.kind == stated.kind && same(axis.name, stated.name);
                }));
  if (found) return found->id;
  Axis added = stated;
  added.machine = machine;
  AXIOMETRY_TRY(const Versioned<Axis> axis, add_thing(connection, added, change));
  return axis.id;
}

Result<std::optional<InstrumentUse>> instrument_of(Connection& connection, const Instrument& stated,
                                                   const Change& change) {
  const bool numbered = given(stated.serial_number);
  if (!numbered && !given(stated.manufacturer) && !given(stated.type)) return std::nullopt;
  AXIOMETRY_TRY(const auto instruments, all_things<Instrument>(connection));
  std::vector<const Versioned<Instrument>*> candidates;
  for (const Versioned<Instrument>& instrument : instruments) {
    const Instrument& known = instrument.value;
    const bool alike = same(known.manufacturer, stated.manufacturer) && same(known.type, stated.type);
    const bool fits = numbered ? same(known.serial_number, stated.serial_number) &&
                                     (alike || !given(known.manufacturer) || !given(stated.manufacturer) ||
                                      same(known.manufacturer, stated.manufacturer))
                               : alike;
    if (fits) candidates.push_back(&instrument);
  }
  for (const auto* candidate : candidates)
    if (numbered || candidates.size() == 1 || !given(candidate->value.serial_number))
      return InstrumentUse{candidate->id, candidate->version};
  AXIOMETRY_TRY(const Versioned<Instrument> added, add_thing(connection, stated, change));
  return InstrumentUse{added.id, added.version};
}

}  // namespace axiometry::store
