// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/app/workbench/workbench_json.h"
#include "axiometry/base/json/json.h"
#include "axiometry/store/store.h"

/// Machines, axes, instruments, trends and the audit trail as the API spells them (apps/server/openapi.json).
namespace axiometry::app {

/// A machine in a list: with its axes, how many tests it has, the latest of them and that of each axis.
struct MachineSummary {
  store::Versioned<store::MachineRecord> machine;
  std::vector<store::Versioned<store::AxisRecord>> axes;
  std::optional<store::MachineTests> tests{};  ///< nothing: it has none
  std::vector<store::AxisLatest> of_axes{};    ///< of those that have any
};

json::Value to_json(const MachineSummary& summary);
json::Value to_json(const store::Versioned<store::MachineRecord>& machine);  ///< JSON without what only a list has
json::Value to_json(const store::Versioned<store::AxisRecord>& axis);
json::Value to_json(const store::Versioned<store::InstrumentRecord>& instrument);
json::Value to_json(const store::AuditEntry& entry);

struct AxisTrend {
  store::Versioned<store::AxisRecord> axis;
  std::string machine_name;
  std::vector<store::TrendPoint> points;
};
json::Value to_json(const AxisTrend& trend);

/// What a request says of an asset: its value, and for a change the version it rests on.
template <typename Asset>
struct Edit {
  Asset value;
  std::optional<int> base_version{};
  std::string reason;
};

/// Each fails, with line and column, on unknown members, on members of another kind and on texts as given_line() and
/// given_text() do; a machine on an empty name; an axis without a machine, a name or a kind, and as limits_from(); an
/// instrument without a manufacturer, type, serial number and role, and on inputs that no test could take.
Result<Edit<store::MachineRecord>> machine_from(const json::Value& value);
Result<Edit<store::AxisRecord>> axis_from(const json::Value& value);
Result<Edit<store::InstrumentRecord>> instrument_from(const json::Value& value);

/// {"reason"}; an empty body will do.
Result<std::string> reason_from(const json::Value& value);

}  // namespace axiometry::app
