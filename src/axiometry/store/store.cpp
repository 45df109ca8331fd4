// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/store.h"

#include <algorithm>

#include "axiometry/store/database/clock.h"
#include "axiometry/store/database/migrations.h"
#include "axiometry/store/kept/asset_tables.h"
#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/documents.h"
#include "axiometry/store/kept/folded_text.h"
#include "axiometry/store/kept/test_list.h"
#include "axiometry/store/proof/audit_trail.h"
#include "axiometry/store/store_state.h"

namespace axiometry::store {
namespace {

constexpr std::size_t most_connections = 8;

}  // namespace

Store::Store(std::unique_ptr<State> state) : state_(std::move(state)) {}
Store::~Store() = default;

Result<std::unique_ptr<Store>> Store::open(std::string_view address, const Opening& opening) {
  AXIOMETRY_TRY(std::unique_ptr<Place> place, place_of(address, opening));
  auto state = std::make_unique<State>(std::move(place), most_connections);
  const auto schema = [&]() -> Result<int> {
    AXIOMETRY_TRY(const ConnectionPool::Lease connection, state->pool.lease());
    return state->info.writable && opening.create ? migrate(*connection) : check_schema(*connection);
  }();
  if (!schema) {
    Error error = schema.error();
    error.file = state->info.location;
    return std::unexpected(std::move(error));
  }
  state->info.schema = *schema;
  return std::unique_ptr<Store>(new Store(std::move(state)));
}

Info Store::info() const { return state_->info; }

Result<void> Store::read_within(const std::function<Result<void>(const Transaction&)>& function) const {
  return state_->read([&](Connection& connection) { return function(Transaction(connection)); });
}

Result<void> Store::write_within(const std::function<Result<void>(Transaction&)>& function) {
  return state_->write([&](Connection& connection) {
    Transaction transaction(connection);
    return function(transaction);
  });
}

std::size_t Store::waiting_to_write() const { return state_->turn.waiting(); }

Result<Counts> Store::counts() const {
  return read([](const Transaction& archive) { return archive.counts(); });
}

template <typename Asset>
Result<Versioned<Asset>> Store::add(const Asset& asset, const By& by) {
  return write([&](Transaction& archive) { return archive.add(asset, by); });
}

template <typename Asset>
Result<Versioned<Asset>> Store::change(Id id, int base_version, const Asset& asset, const By& by) {
  return write([&](Transaction& archive) { return archive.change(id, base_version, asset, by); });
}

template <typename Asset>
Result<Versioned<Asset>> Store::get(Id id, std::optional<int> version) const {
  return read([&](const Transaction& archive) { return archive.get<Asset>(id, version); });
}

template <typename Asset>
Result<std::vector<Versioned<Asset>>> Store::all() const {
  AXIOMETRY_TRY(auto assets, state_->read([](Connection& connection) { return all_assets<Asset>(connection); }));
  std::ranges::stable_sort(
      assets, {}, [](const Versioned<Asset>& asset) { return folded(AssetTable<Asset>::called(asset.value)); });
  return assets;
}

template <typename Asset>
Result<std::vector<Versioned<Asset>>> Store::versions(Id id) const {
  return read([&](const Transaction& archive) { return archive.versions<Asset>(id); });
}

#define AXIOMETRY_ASSET(Asset)                                                       \
  template Result<Versioned<Asset>> Store::add(const Asset&, const By&);             \
  template Result<Versioned<Asset>> Store::change(Id, int, const Asset&, const By&); \
  template Result<Versioned<Asset>> Store::get<Asset>(Id, std::optional<int>) const; \
  template Result<std::vector<Versioned<Asset>>> Store::all<Asset>() const;          \
  template Result<std::vector<Versioned<Asset>>> Store::versions<Asset>(Id) const

AXIOMETRY_ASSET(MachineRecord);
AXIOMETRY_ASSET(AxisRecord);
AXIOMETRY_ASSET(InstrumentRecord);
AXIOMETRY_ASSET(PlanRecord);
AXIOMETRY_ASSET(CalibrationRecord);
AXIOMETRY_ASSET(CompensationRecord);

#undef AXIOMETRY_ASSET

Result<std::vector<Id>> Store::receive(const Content& content, std::span<const NewTest> tests, const By& by) {
  return write([&](Transaction& archive) { return archive.receive(content, tests, by); });
}

Result<int> Store::revise(Id test, int base_version, const TestState& state, const By& by) {
  return write([&](Transaction& archive) { return archive.revise(test, base_version, state, by); });
}

Result<void> Store::withdraw(Id test, bool withdrawn, const By& by) {
  return state_->write([&](Connection& connection) { return withdraw_test(connection, test, withdrawn, by); });
}

Result<TestRecord> Store::test(Id id, std::optional<int> version) const {
  return read([&](const Transaction& archive) { return archive.test(id, version); });
}

Result<std::vector<Change>> Store::test_versions(Id id) const {
  return read([&](const Transaction& archive) { return archive.test_versions(id); });
}

Result<TestPage> Store::tests(const TestFilter& filter) const {
  return read([&](const Transaction& archive) { return archive.tests(filter); });
}

Result<std::vector<CompensationRow>> Store::compensations(const CompensationFilter& filter) const {
  return read([&](const Transaction& archive) { return archive.compensations(filter); });
}

Result<CalibrationPage> Store::calibrations(const CalibrationFilter& filter) const {
  return read([&](const Transaction& archive) { return archive.calibrations(filter); });
}

Result<std::vector<MachineTests>> Store::machine_tests(std::optional<Id> machine) const {
  return state_->read([&](Connection& connection) { return find_machine_tests(connection, machine); });
}

Result<std::vector<AxisLatest>> Store::axes_latest(std::optional<Id> machine) const {
  return state_->read([&](Connection& connection) { return find_axes_latest(connection, machine); });
}

Result<std::vector<TrendPoint>> Store::trend(Id axis, std::span<const std::string> parameters,
                                             std::int64_t limit) const {
  return state_->read([&](Connection& connection) { return find_trend(connection, axis, parameters, limit); });
}

Result<std::string> Store::keep(const Content& content, const By& by) {
  return write([&](Transaction& archive) { return archive.keep(content, by); });
}

Result<Content> Store::content(const std::string& sha256) const {
  return read([&](const Transaction& archive) { return archive.content(sha256); });
}

Result<std::int64_t> Store::content_size(const std::string& sha256) const {
  return state_->read([&](Connection& connection) { return store::content_size(connection, sha256); });
}

Result<DocumentRecord> Store::add_document(const DocumentRecord& document, std::string_view bytes, const By& by) {
  return write([&](Transaction& archive) { return archive.add_document(document, bytes, by); });
}

Result<std::vector<DocumentRecord>> Store::documents(Id test) const {
  return read([&](const Transaction& archive) { return archive.documents(test); });
}

Result<DocumentRecord> Store::document(Id id) const {
  return state_->read([&](Connection& connection) { return read_document(connection, id); });
}

Result<std::vector<AuditEntry>> Store::audit(const std::string& subject, std::int64_t before,
                                             std::int64_t limit) const {
  return state_->read([&](Connection& connection) { return entries(connection, subject, before, limit); });
}

}  // namespace axiometry::store
