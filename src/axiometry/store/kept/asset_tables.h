// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/records.h"

/// How machines, axes, instruments, plans, calibrations and compensations lie in their tables: the one place that knows
/// their columns.
namespace axiometry::store {

template <typename Asset>
struct AssetTable;

/// Cells in the order of `columns`; asset() reads them from `first` on and fails with `damaged` where JSON is none;
/// check() says what an asset lacks to be kept; called() is what lists are ordered by.
#define AXIOMETRY_ASSET_TABLE(Asset, table, names)                         \
  template <>                                                              \
  struct AssetTable<Asset> {                                               \
    static constexpr std::string_view name = table;                        \
    static constexpr std::string_view columns = names;                     \
    static std::vector<Cell> cells(const Asset& asset);                    \
    static Result<Asset> asset(const Row& row, std::size_t first);         \
    static Result<void> check(Connection& connection, const Asset& asset); \
    static std::string called(const Asset& asset);                         \
  }

AXIOMETRY_ASSET_TABLE(MachineRecord, "machine", "name, manufacturer, type, serial_number, controller, location, notes");
AXIOMETRY_ASSET_TABLE(AxisRecord, "axis", "machine, name, kind, limits, notes");
AXIOMETRY_ASSET_TABLE(InstrumentRecord, "instrument",
                      "role, manufacturer, type, serial_number, certificate, calibrated_on, calibration_due, inputs, "
                      "notes");
AXIOMETRY_ASSET_TABLE(PlanRecord, "plan", "title, axis, content");
AXIOMETRY_ASSET_TABLE(CalibrationRecord, "calibration",
                      "kind, title, machine, instrument, instrument_version, measured_on, notes, withdrawn, files, "
                      "program, options, result, verdict, serious, figures");
AXIOMETRY_ASSET_TABLE(CompensationRecord, "compensation",
                      "test, test_version, retest, retest_version, axis, control, notes, withdrawn, files, program, "
                      "options, result, serious, figures");

#undef AXIOMETRY_ASSET_TABLE

/// Whether there is a row of that number. Fails with not_found.
Result<void> check_exists(Connection& connection, std::string_view table, Id id);

/// Whether there are bytes with that hash, called so in the message. Fails with not_found.
Result<void> check_content(Connection& connection, const std::string& sha256, std::string_view whose);

}  // namespace axiometry::store
