// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/store.h"

#include <algorithm>

#include "axiometry/store/audit_trail.h"
#include "axiometry/store/clock.h"
#include "axiometry/store/documents.h"
#include "axiometry/store/folded_text.h"
#include "axiometry/store/migrations.h"
#include "axiometry/store/store_state.h"
#include "axiometry/store/test_list.h"
#include "axiometry/store/thing_tables.h"
#include "axiometry/store/things.h"

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

template <typename Thing>
Result<Versioned<Thing>> Store::add(const Thing& thing, const By& by) {
  return write([&](Transaction& archive) { return archive.add(thing, by); });
}

template <typename Thing>
Result<Versioned<Thing>> Store::change(Id id, int base_version, const Thing& thing, const By& by) {
  return write([&](Transaction& archive) { return archive.change(id, base_version, thing, by); });
}

template <typename Thing>
Result<Versioned<Thing>> Store::get(Id id, std::optional<int> version) const {
  return read([&](const Transaction& archive) { return archive.get<Thing>(id, version); });
}

template <typename Thing>
Result<std::vector<Versioned<Thing>>> Store::all() const {
  AXIOMETRY_TRY(auto things, state_->read([](Connection& connection) { return all_things<Thing>(connection); }));
  std::ranges::stable_sort(
      things, {}, [](const Versioned<Thing>& thing) { return folded(ThingTable<Thing>::called(thing.value)); });
  return things;
}

template <typename Thing>
Result<std::vector<Versioned<Thing>>> Store::versions(Id id) const {
  return read([&](const Transaction& archive) { return archive.versions<Thing>(id); });
}

#define AXIOMETRY_THING(Thing)                                                       \
  template Result<Versioned<Thing>> Store::add(const Thing&, const By&);             \
  template Result<Versioned<Thing>> Store::change(Id, int, const Thing&, const By&); \
  template Result<Versioned<Thing>> Store::get<Thing>(Id, std::optional<int>) const; \
  template Result<std::vector<Versioned<Thing>>> Store::all<Thing>() const;          \
  template Result<std::vector<Versioned<Thing>>> Store::versions<Thing>(Id) const

AXIOMETRY_THING(Machine);
AXIOMETRY_THING(Axis);
AXIOMETRY_THING(Instrument);
AXIOMETRY_THING(PlanRecord);

#undef AXIOMETRY_THING

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

Result<std::vector<MachineTests>> Store::machine_tests(std::optional<Id> machine) const {
  return state_->read([&](Connection& connection) { return find_machine_tests(connection, machine); });
}

Result<std::vector<TrendPoint>> Store::trend(Id axis, std::span<const std::string> parameters,
                                             std::int64_t limit) const {
  return state_->read([&](Connection& connection) { return find_trend(connection, axis, parameters, limit); });
}

Result<std::string> Store::keep(const Content& content, const By& by) {
  return state_->write([&](Connection& connection) -> Result<std::string> {
    AXIOMETRY_TRY_VOID(keep_content(connection, content, change_now(by)));
    return content.sha256;
  });
}

Result<Content> Store::content(const std::string& sha256) const {
  return state_->read([&](Connection& connection) { return read_content(connection, sha256); });
}

Result<Document> Store::add_document(const Document& document, std::string_view bytes, const By& by) {
  return write([&](Transaction& archive) { return archive.add_document(document, bytes, by); });
}

Result<std::vector<Document>> Store::documents(Id test) const {
  return read([&](const Transaction& archive) { return archive.documents(test); });
}

Result<Document> Store::document(Id id) const {
  return state_->read([&](Connection& connection) { return read_document(connection, id); });
}

Result<std::vector<AuditEntry>> Store::audit(const std::string& subject, std::int64_t before,
                                             std::int64_t limit) const {
  return state_->read([&](Connection& connection) { return entries(connection, subject, before, limit); });
}

}  // namespace axiometry::store
