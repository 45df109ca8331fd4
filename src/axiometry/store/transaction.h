// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/store/kept/calibration_list.h"
#include "axiometry/store/kept/compensation_list.h"
#include "axiometry/store/kept/test_records.h"
#include "axiometry/store/records.h"

/// What belongs together in the archive: read as of one moment, or written as a whole or not at all.
namespace axiometry::store {

class Connection;

struct Counts {
  std::int64_t machines = 0;
  std::int64_t axes = 0;
  std::int64_t instruments = 0;
  std::int64_t plans = 0;
  std::int64_t tests = 0;
  std::int64_t documents = 0;
  std::int64_t calibrations = 0;
  std::int64_t compensations = 0;
  std::int64_t content_bytes = 0;
};

/// Lent by Store::read() and Store::write() for as long as these last, to one thread. Calls that the Store has, too, do
/// the same; what was written is seen by what is read after it.
class Transaction {
 public:
  explicit Transaction(Connection& connection) : connection_(connection) {}
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  Result<Counts> counts() const;
  template <typename Asset>
  Result<Versioned<Asset>> get(Id id, std::optional<int> version = {}) const;
  template <typename Asset>
  Result<std::vector<Versioned<Asset>>> versions(Id id) const;

  /// Which machine, axis or instrument of the archive receive() and revise() would take for what a test states: by the
  /// one rule of stated_assets.h. Nothing where they would add one. `linked`: the machine of a test that is kept.
  Result<std::optional<Versioned<MachineRecord>>> known(const MachineRecord& stated) const;
  Result<MachineMeant> meant(const MachineRecord& stated) const;
  Result<std::optional<Versioned<AxisRecord>>> known(const MachineRecord& stated, const AxisRecord& axis,
                                                     std::optional<Id> linked = {}) const;
  Result<std::optional<Versioned<InstrumentRecord>>> known(const InstrumentRecord& stated) const;

  Result<TestRecord> test(Id id, std::optional<int> version = {}) const;
  Result<std::vector<Change>> test_versions(Id id) const;
  Result<TestPage> tests(const TestFilter& filter) const;
  Result<std::vector<DocumentRecord>> documents(Id test) const;
  Result<CalibrationPage> calibrations(const CalibrationFilter& filter) const;
  Result<std::vector<CompensationRow>> compensations(const CompensationFilter& filter) const;
  Result<Content> content(const std::string& sha256) const;
  /// SHA-256 of those of one format, in the order in which they came.
  Result<std::vector<std::string>> contents(std::string_view format) const;

  template <typename Asset>
  Result<Versioned<Asset>> add(const Asset& asset, const By& by);
  template <typename Asset>
  Result<Versioned<Asset>> change(Id id, int base_version, const Asset& asset, const By& by);
  Result<std::vector<Id>> receive(const Content& content, std::span<const NewTest> tests, const By& by);
  Result<int> revise(Id test, int base_version, const TestState& state, const By& by);
  Result<std::string> keep(const Content& content, const By& by);
  Result<DocumentRecord> add_document(const DocumentRecord& document, std::string_view bytes, const By& by);

 private:
  Connection& connection_;
};

}  // namespace axiometry::store
