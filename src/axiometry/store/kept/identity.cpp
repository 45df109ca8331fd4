// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/kept/identity.h"

#include <fmt/format.h>

#include "axiometry/base/text/text.h"
#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/folded_text.h"

namespace axiometry::store {
namespace {

std::string identity_word(std::string_view text) { return folded(text::trim(text), text.size()); }

/// Whether both have one and the same number; the makers that they state may not differ.
template <typename Numbered>
bool have_one_number(const Numbered& a, const Numbered& b) {
  return is_given(a.serial_number) && same_word(a.serial_number, b.serial_number) &&
         same_maker(a.manufacturer, b.manufacturer);
}

template <typename Numbered>
bool both_unnumbered(const Numbered& a, const Numbered& b) {
  return !is_given(a.serial_number) && !is_given(b.serial_number);
}

}  // namespace

bool same_word(std::string_view a, std::string_view b) { return identity_word(a) == identity_word(b); }
bool is_given(std::string_view text) { return !text::trim(text).empty(); }
bool same_maker(std::string_view a, std::string_view b) { return !is_given(a) || !is_given(b) || same_word(a, b); }

Result<void> expect_only_one(Connection& connection, const MachineRecord& machine, Id own) {
  AXIOMETRY_TRY(const auto machines, all_assets<MachineRecord>(connection));
  for (const auto& [id, version, change, other] : machines) {
    if (id == own) continue;
    if (have_one_number(other, machine))
      return fail(fmt::format("found machine {} of the same serial number {}, expected each number once", id,
                              text::quoted(other.serial_number)));
    if (both_unnumbered(other, machine) && same_word(other.name, machine.name))
      return fail(
          fmt::format("found machine {} called {} too, and neither has a serial number, expected another name "
                      "or a number that tells them apart",
                      id, text::quoted(other.name)));
  }
  return {};
}

Result<void> expect_only_one(Connection& connection, const AxisRecord& axis, Id own) {
  AXIOMETRY_TRY(const auto axes, axes_of(connection, axis.machine));
  for (const auto& [id, version, change, other] : axes)
    if (id != own && other.kind == axis.kind && same_word(other.name, axis.name))
      return fail(fmt::format("found axis {} of this machine called {} too, expected each name once", id,
                              text::quoted(other.name)));
  return {};
}

Result<void> expect_only_one(Connection& connection, const InstrumentRecord& instrument, Id own) {
  AXIOMETRY_TRY(const auto instruments, all_assets<InstrumentRecord>(connection));
  for (const auto& [id, version, change, other] : instruments) {
    if (id == own) continue;
    if (have_one_number(other, instrument))
      return fail(fmt::format("found instrument {} of the same serial number {}, expected each number once", id,
                              text::quoted(other.serial_number)));
    if (both_unnumbered(other, instrument) && same_word(other.manufacturer, instrument.manufacturer) &&
        same_word(other.type, instrument.type))
      return fail(
          fmt::format("found instrument {} of the same manufacturer and type, and neither has a serial number, "
                      "expected a number that tells them apart",
                      id));
  }
  return {};
}

bool same_identity(const MachineRecord& a, const MachineRecord& b) {
  return same_word(a.name, b.name) && same_word(a.serial_number, b.serial_number) &&
         same_word(a.manufacturer, b.manufacturer);
}

bool same_identity(const AxisRecord& a, const AxisRecord& b) {
  return a.machine == b.machine && a.kind == b.kind && same_word(a.name, b.name);
}

bool same_identity(const InstrumentRecord& a, const InstrumentRecord& b) {
  return same_word(a.serial_number, b.serial_number) && same_word(a.manufacturer, b.manufacturer) &&
         same_word(a.type, b.type);
}

}  // namespace axiometry::store
