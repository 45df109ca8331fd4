// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/store.h"

#include <algorithm>

#include "axiometry/store/audit_trail.h"
#include "axiometry/store/clock.h"
#include "axiometry/store/documents.h"
#include "axiometry/store/folded_text.h"
#include "axiometry/store/migrations.h"
#include "axiometry/store/stated_things.h"
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

Result<Counts> Store::counts() const {
  return state_->read([](Connection& connection) -> Result<Counts> {
    // Ids have no gaps: the largest is the number.
    AXIOMETRY_TRY(const Rows rows,
                  connection.query("SELECT (SELECT coalesce(max(id), 0) FROM machine), (SELECT coalesce(max(id), 0) "
                                   "FROM axis), (SELECT coalesce(max(id), 0) FROM instrument), (SELECT "
                                   "coalesce(max(id), 0) FROM plan), (SELECT coalesce(max(id), 0) FROM test), (SELECT "
                                   "coalesce(max(id), 0) FROM document), (SELECT coalesce(sum(size), 0) FROM "
                                   "content)"));
    const Row& row = rows[0];
    return Counts{.machines = row.integer(0),
                  .axes = row.integer(1),
                  .instruments = row.integer(2),
                  .plans = row.integer(3),
                  .tests = row.integer(4),
                  .documents = row.integer(5),
                  .content_bytes = row.integer(6)};
  });
}

template <typename Thing>
Result<Versioned<Thing>> Store::add(const Thing& thing, const By& by) {
  return state_->write([&](Connection& connection) { return add_thing(connection, thing, change_now(by)); });
}

template <typename Thing>
Result<Versioned<Thing>> Store::change(Id id, int base_version, const Thing& thing, const By& by) {
  const Versioned<Thing> changed{id, base_version + 1, change_now(by), thing};
  return state_->write([&](Connection& connection) { return change_thing(connection, changed); });
}

template <typename Thing>
Result<Versioned<Thing>> Store::get(Id id, std::optional<int> version) const {
  return state_->read([&](Connection& connection) { return get_thing<Thing>(connection, id, version); });
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
  return state_->read([&](Connection& connection) { return thing_versions<Thing>(connection, id); });
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

Result<std::optional<Versioned<Machine>>> Store::known(const Machine& stated) const {
  return state_->read([&](Connection& connection) { return known_machine(connection, stated); });
}

Result<std::optional<Versioned<Axis>>> Store::known(const Machine& stated, const Axis& axis) const {
  return state_->read([&](Connection& connection) -> Result<KnownAxis> {
    AXIOMETRY_TRY(const KnownMachine machine, known_machine(connection, stated));
    if (!machine) return std::nullopt;
    return known_axis(connection, machine->id, axis);
  });
}

Result<std::optional<Versioned<Instrument>>> Store::known(const Instrument& stated) const {
  return state_->read([&](Connection& connection) { return known_instrument(connection, stated); });
}

Result<std::vector<Id>> Store::receive(const Content& content, std::span<const NewTest> tests, const By& by) {
  return state_->write([&](Connection& connection) { return receive_tests(connection, content, tests, by); });
}

Result<std::vector<Id>> Store::receive(std::span<const NewFile> files, const By& by) {
  return state_->write([&](Connection& connection) -> Result<std::vector<Id>> {
    std::vector<Id> all;
    for (const NewFile& file : files) {
      AXIOMETRY_TRY(const auto ids, receive_tests(connection, file.content, file.tests, by));
      all.insert(all.end(), ids.begin(), ids.end());
    }
    return all;
  });
}

Result<int> Store::revise(Id test, int base_version, const TestState& state, const By& by) {
  return state_->write([&](Connection& connection) { return revise_test(connection, test, base_version, state, by); });
}

Result<void> Store::withdraw(Id test, bool withdrawn, const By& by) {
  return state_->write([&](Connection& connection) { return withdraw_test(connection, test, withdrawn, by); });
}

Result<TestRecord> Store::test(Id id, std::optional<int> version) const {
  return state_->read([&](Connection& connection) { return read_test(connection, id, version); });
}

Result<std::vector<Change>> Store::test_versions(Id id) const {
  return state_->read([&](Connection& connection) -> Result<std::vector<Change>> {
    AXIOMETRY_TRY(const TestHead head, read_head(connection, id));
    AXIOMETRY_TRY(
        const Rows rows,
        connection.query("SELECT at, actor, reason FROM test_version WHERE test = $1 ORDER BY version", {head.id}));
    std::vector<Change> changes;
    for (const Row& row : rows) changes.push_back({row.text(0), row.text(1), row.text(2)});
    return changes;
  });
}

Result<TestPage> Store::tests(const TestFilter& filter) const {
  return state_->read([&](Connection& connection) { return find_tests(connection, filter); });
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
  return state_->write([&](Connection& connection) { return write_document(connection, document, bytes, by); });
}

Result<std::vector<Document>> Store::documents(Id test) const {
  return state_->read([&](Connection& connection) { return documents_of(connection, test); });
}

Result<Document> Store::document(Id id) const {
  return state_->read([&](Connection& connection) { return read_document(connection, id); });
}

Result<std::vector<AuditEntry>> Store::audit(const std::string& subject, std::int64_t before,
                                             std::int64_t limit) const {
  return state_->read([&](Connection& connection) { return entries(connection, subject, before, limit); });
}

}  // namespace axiometry::store
