// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/transaction.h"

#include "axiometry/store/database/clock.h"
#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/documents.h"
#include "axiometry/store/kept/identity.h"
#include "axiometry/store/kept/stated_assets.h"
#include "axiometry/store/kept/test_list.h"
#include "axiometry/store/kept/test_versions.h"

namespace axiometry::store {

Result<Counts> Transaction::counts() const {
  // Ids have no gaps: the largest is the number.
  AXIOMETRY_TRY(
      const Rows rows,
      connection_.query(
          "SELECT (SELECT coalesce(max(id), 0) FROM machine), (SELECT coalesce(max(id), 0) "
          "FROM axis), (SELECT coalesce(max(id), 0) FROM instrument), (SELECT "
          "coalesce(max(id), 0) FROM plan), (SELECT coalesce(max(id), 0) FROM test), (SELECT "
          "coalesce(max(id), 0) FROM document), (SELECT coalesce(sum(size), 0) FROM "
          "content), (SELECT coalesce(max(id), 0) FROM calibration), (SELECT coalesce(max(id), 0) FROM compensation)"));
  const Row& row = rows[0];
  return Counts{.machines = row.integer(0),
                .axes = row.integer(1),
                .instruments = row.integer(2),
                .plans = row.integer(3),
                .tests = row.integer(4),
                .documents = row.integer(5),
                .calibrations = row.integer(7),
                .compensations = row.integer(8),
                .content_bytes = row.integer(6)};
}

template <typename Asset>
Result<Versioned<Asset>> Transaction::get(Id id, std::optional<int> version) const {
  return get_asset<Asset>(connection_, id, version);
}

template <typename Asset>
Result<std::vector<Versioned<Asset>>> Transaction::versions(Id id) const {
  return asset_versions<Asset>(connection_, id);
}

/// Machines, axes and instruments: two that no test could tell apart would part its history by chance.
template <typename Asset>
constexpr bool is_known_by_what_tests_state = requires(Connection& connection, const Asset& asset) {
  expect_only_one(connection, asset, Id{});
};

template <typename Asset>
Result<Versioned<Asset>> Transaction::add(const Asset& asset, const By& by) {
  AXIOMETRY_TRY(auto added, add_asset(connection_, asset, change_now(by)));
  if constexpr (is_known_by_what_tests_state<Asset>) AXIOMETRY_TRY_VOID(expect_only_one(connection_, asset, added.id));
  return added;
}

template <typename Asset>
Result<Versioned<Asset>> Transaction::change(Id id, int base_version, const Asset& asset, const By& by) {
  AXIOMETRY_TRY(auto changed, change_asset(connection_, Versioned<Asset>{id, base_version + 1, change_now(by), asset}));
  if constexpr (is_known_by_what_tests_state<Asset>) {
    AXIOMETRY_TRY(const auto before, get_asset<Asset>(connection_, id, base_version));
    if (!same_identity(before.value, asset)) AXIOMETRY_TRY_VOID(expect_only_one(connection_, asset, id));
  }
  return changed;
}

#define AXIOMETRY_ASSET(Asset)                                                             \
  template Result<Versioned<Asset>> Transaction::get<Asset>(Id, std::optional<int>) const; \
  template Result<std::vector<Versioned<Asset>>> Transaction::versions<Asset>(Id) const;   \
  template Result<Versioned<Asset>> Transaction::add(const Asset&, const By&);             \
  template Result<Versioned<Asset>> Transaction::change(Id, int, const Asset&, const By&)

AXIOMETRY_ASSET(MachineRecord);
AXIOMETRY_ASSET(AxisRecord);
AXIOMETRY_ASSET(InstrumentRecord);
AXIOMETRY_ASSET(PlanRecord);
AXIOMETRY_ASSET(CalibrationRecord);
AXIOMETRY_ASSET(CompensationRecord);

#undef AXIOMETRY_ASSET

Result<std::optional<Versioned<MachineRecord>>> Transaction::known(const MachineRecord& stated) const {
  return known_machine(connection_, stated);
}

Result<MachineMeant> Transaction::meant(const MachineRecord& stated) const {
  return machine_meant(connection_, stated);
}

Result<std::optional<Versioned<AxisRecord>>> Transaction::known(const MachineRecord& stated, const AxisRecord& axis,
                                                                std::optional<Id> linked) const {
  return known_axis(connection_, StatedAxis{stated, axis, linked});
}

Result<std::optional<Versioned<InstrumentRecord>>> Transaction::known(const InstrumentRecord& stated) const {
  return known_instrument(connection_, stated);
}

Result<TestRecord> Transaction::test(Id id, std::optional<int> version) const {
  return read_test(connection_, id, version);
}

Result<std::vector<Change>> Transaction::test_versions(Id id) const {
  AXIOMETRY_TRY(const TestHead head, read_head(connection_, id));
  AXIOMETRY_TRY(
      const Rows rows,
      connection_.query("SELECT at, actor, reason FROM test_version WHERE test = $1 ORDER BY version", {head.id}));
  std::vector<Change> changes;
  for (const Row& row : rows) changes.push_back({row.text(0), row.text(1), row.text(2)});
  return changes;
}

Result<TestPage> Transaction::tests(const TestFilter& filter) const { return find_tests(connection_, filter); }

Result<std::vector<DocumentRecord>> Transaction::documents(Id test) const { return documents_of(connection_, test); }

Result<CalibrationPage> Transaction::calibrations(const CalibrationFilter& filter) const {
  return find_calibrations(connection_, filter);
}

Result<std::vector<CompensationRow>> Transaction::compensations(const CompensationFilter& filter) const {
  return find_compensations(connection_, filter);
}

Result<Content> Transaction::content(const std::string& sha256) const { return read_content(connection_, sha256); }

Result<std::vector<std::string>> Transaction::contents(std::string_view format) const {
  return list_contents(connection_, format);
}

Result<std::string> Transaction::keep(const Content& content, const By& by) {
  AXIOMETRY_TRY_VOID(keep_content(connection_, content, change_now(by)));
  return content.sha256;
}

Result<std::vector<Id>> Transaction::receive(const Content& content, std::span<const NewTest> tests, const By& by) {
  return receive_tests(connection_, content, tests, by);
}

Result<int> Transaction::revise(Id test, int base_version, const TestState& state, const By& by) {
  return revise_test(connection_, test, base_version, state, by);
}

Result<DocumentRecord> Transaction::add_document(const DocumentRecord& document, std::string_view bytes, const By& by) {
  return write_document(connection_, document, bytes, by);
}

}  // namespace axiometry::store
