// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/verification.h"

#include <fmt/format.h>

#include <map>

#include "axiometry/digest/sha256.h"
#include "axiometry/store/attested.h"
#include "axiometry/store/audit_trail.h"
#include "axiometry/store/documents.h"
#include "axiometry/store/fingerprint.h"
#include "axiometry/store/migrations.h"
#include "axiometry/store/store_state.h"
#include "axiometry/store/test_list.h"
#include "axiometry/store/things.h"

namespace axiometry::store {
namespace {

constexpr Id tests_verified_at_once = 100;
constexpr std::size_t most_problems = 1000;

bool same(const Change& a, const Change& b) { return a.at == b.at && a.actor == b.actor && a.reason == b.reason; }

bool same(const Origin& origin, const TestHead& head) {
  return origin.sha256 == head.sha256 && origin.file_name == head.file_name &&
         origin.name_in_file == head.name_in_file && same(origin.received, head.received);
}

class Verifier {
 public:
  Verifier(Connection& connection, const Expectations& expected) : connection_(connection), expected_(expected) {}

  Result<Verification> run();

 private:
  template <typename... Parts>
  void problem(fmt::format_string<Parts...> text, Parts&&... parts) {
    if (found_.problems.size() < most_problems)
      found_.problems.push_back(fmt::format(text, std::forward<Parts>(parts)...));
  }
  Result<void> everything();
  Result<void> database();
  Result<void> schema();
  Result<void> trail();
  void check_seals(const std::map<std::int64_t, std::string>& sealed_entries);
  void conclude();
  Result<void> contents();
  Result<void> tests();
  Result<void> some_tests(Id first, Id last);
  void check_test(const TestHead& head, std::span<const TestVersion> versions, const Row* listed);
  Result<void> documents();
  Result<void> names();

  Connection& connection_;
  const Expectations& expected_;
  Verification found_;
  Attested attested_;
  std::map<Id, Machine> machines_;
  std::map<Id, Axis> axes_;
};

Result<Verification> Verifier::run() {
  Result<void> read;
  try {
    read = everything();
  } catch (const DamagedCell&) {
    read = fail(ErrorKind::damaged, "found a value of another type than was written");
  }
  if (!read && read.error().kind != ErrorKind::damaged) return std::unexpected(read.error());
  if (!read) problem("{}; the rest was not looked at", read.error().message);
  conclude();
  return std::move(found_);
}

Result<void> Verifier::everything() {
  AXIOMETRY_TRY_VOID(database());
  AXIOMETRY_TRY_VOID(schema());
  AXIOMETRY_TRY_VOID(trail());
  AXIOMETRY_TRY_VOID(contents());
  AXIOMETRY_TRY_VOID(verify_things<Machine>(connection_, attested_, found_.problems));
  AXIOMETRY_TRY_VOID(verify_things<Axis>(connection_, attested_, found_.problems));
  AXIOMETRY_TRY_VOID(verify_things<Instrument>(connection_, attested_, found_.problems));
  AXIOMETRY_TRY_VOID(verify_things<PlanRecord>(connection_, attested_, found_.problems));
  AXIOMETRY_TRY_VOID(names());
  AXIOMETRY_TRY_VOID(tests());
  return documents();
}

/// PostgreSQL checks references when they are written and its pages when they are read, where it was told to.
Result<void> Verifier::database() {
  if (!connection_.is_sqlite()) return {};
  AXIOMETRY_TRY(const Rows integrity, connection_.query("PRAGMA integrity_check"));
  for (const Row& row : integrity)
    if (row.text(0) != "ok") problem("file: {}", row.text(0));
  AXIOMETRY_TRY(const Rows references, connection_.query("PRAGMA foreign_key_check"));
  for (const Row& row : references)
    problem("{}: found a row that refers to a row of {} that does not exist", row.text(0), row.text(2));
  return {};
}

/// Without its triggers an archive only says that it cannot be changed.
Result<void> Verifier::schema() {
  if (!expected_.schema) {
    found_.unproved.push_back(
        fmt::format("that tables, constraints and triggers are those of schema {}: they were not compared ({})",
                    newest_schema(), expected_.schema.error().message));
    return {};
  }
  AXIOMETRY_TRY(const SchemaParts parts, schema_parts(connection_));
  for (const std::string& difference : differences(parts, *expected_.schema)) problem("{}", difference);
  found_.parts = static_cast<std::int64_t>(expected_.schema->size());
  return {};
}

/// A clock may be set; that times do not follow each other is nobody's fault, but worth to be known.
Result<void> Verifier::trail() {
  std::map<std::int64_t, std::string> sealed_entries;
  for (const Seal& seal : expected_.seals) sealed_entries[seal.head.entries] = "";
  std::string before;
  const auto visit = [&](const AuditEntry& entry) {
    attested_.learn(entry);
    if (entry.change.at < before && found_.notes.size() < most_problems)
      found_.notes.push_back(
          fmt::format("audit trail: the clock went back between the entries {} and {}, from {} to {}", entry.id - 1,
                      entry.id, before, entry.change.at));
    before = entry.change.at;
    found_.head = {entry.id, entry.sha256, entry.change.at};
    if (const auto sealed = sealed_entries.find(entry.id); sealed != sealed_entries.end())
      sealed->second = entry.sha256;
  };
  AXIOMETRY_TRY(found_.entries, verify_chain(connection_, found_.problems, visit));
  check_seals(sealed_entries);
  return {};
}

void Verifier::check_seals(const std::map<std::int64_t, std::string>& sealed_entries) {
  for (const Seal& seal : expected_.seals) {
    const std::string& hash = sealed_entries.at(seal.head.entries);
    if (seal.head.entries > found_.entries)
      problem("audit trail: found {} entries, expected at least the {} that were sealed at {}: its end is missing",
              found_.entries, seal.head.entries, seal.at);
    else if (hash != seal.head.sha256)
      problem("audit trail: found entry {} with the hash {}, expected {} as it was sealed at {}", seal.head.entries,
              hash, seal.head.sha256, seal.at);
    else
      found_.proved.push_back(
          fmt::format("the audit trail goes on from the seal of {} (entry {}), {} entries longer now", seal.at,
                      seal.head.entries, found_.entries - seal.head.entries));
  }
}

/// What follows where nothing is wrong, and what does not even then.
void Verifier::conclude() {
  if (found_.problems.empty()) {
    found_.proved.insert(
        found_.proved.begin(),
        {fmt::format("each of the {} entries of the audit trail follows from all in front of it", found_.entries),
         fmt::format("each of the {} files has the bytes that the trail tells of", found_.contents),
         fmt::format("{} tests in all their versions, machines, axes, instruments, plans and documents are those that "
                     "the trail tells of, none more and none less",
                     found_.tests)});
    if (found_.parts > 0)
      found_.proved.push_back(
          fmt::format("the {} tables, constraints, indexes and triggers of the database are those of schema {}",
                      found_.parts, newest_schema()));
  }
  if (expected_.seals.empty())
    found_.unproved.push_back(
        "that no entries are missing at the end of the audit trail with all that they tell of: only a seal from before "
        "can show that");
  else
    found_.unproved.push_back("that nothing was taken away again which came after the latest of the seals");
  found_.unproved.push_back("that times and names are true: they are what clocks and people said");
}

Result<void> Verifier::contents() {
  AXIOMETRY_TRY(const Rows last, connection_.query("SELECT coalesce(max(id), 0), count(*) FROM content"));
  for (Id id = 1; id <= last[0].integer(0); ++id) {
    AXIOMETRY_TRY(const Rows rows,
                  connection_.query("SELECT sha256, size, bytes, at, actor, reason FROM content WHERE id = $1", {id}));
    if (rows.empty()) {
      problem("content {}: found none, expected all from 1 to {}", id, last[0].integer(0));
      continue;
    }
    const std::string& bytes = rows[0].text(2);
    const std::string hash = sha256(bytes);
    if (hash != rows[0].text(0) || rows[0].integer(1) != static_cast<std::int64_t>(bytes.size()))
      problem("content {}: found {} bytes with the SHA-256 {}, expected {} with {}", id, bytes.size(), hash,
              rows[0].integer(1), rows[0].text(0));
    else if (!attested_.knows(fmt::format("content {}", id), 0, hash))
      problem("content {}: found bytes that the audit trail does not know", id);
    else if (const Change* kept = attested_.kept(fmt::format("content {}", id));
             kept == nullptr || !same(*kept, {rows[0].text(3), rows[0].text(4), rows[0].text(5)}))
      problem("content {}: found another time, name or reason than in the audit trail", id);
    ++found_.contents;
  }
  if (attested_.count("content") != last[0].integer(1))
    problem("content: found {}, expected the {} of the audit trail", last[0].integer(1), attested_.count("content"));
  return {};
}

Result<void> Verifier::names() {
  AXIOMETRY_TRY(const auto machines, all_things<Machine>(connection_));
  for (const auto& machine : machines) machines_[machine.id] = machine.value;
  AXIOMETRY_TRY(const auto axes, all_things<Axis>(connection_));
  for (const auto& axis : axes) axes_[axis.id] = axis.value;
  return {};
}

void Verifier::check_test(const TestHead& head, std::span<const TestVersion> versions, const Row* listed) {
  const std::string subject = fmt::format("test {}", head.id);
  int expected = 0;
  for (const TestVersion& version : versions) {
    if (version.version != ++expected) problem("{}: found version {}, expected {}", subject, version.version, expected);
    const std::string hash = fingerprint(version);
    if (hash != version.sha256 || !attested_.knows(subject, version.version, hash))
      problem("{}: found version {} changed after it was kept", subject, version.version);
  }
  if (expected != head.latest || versions.empty()) {
    problem("{}: found {} versions, expected {}", subject, expected, head.latest);
    return;
  }
  if (head.withdrawn != attested_.withdrawn(subject))
    problem("{}: found it {}withdrawn, expected what the audit trail says", subject, head.withdrawn ? "" : "not ");
  const Origin* origin = attested_.origin(subject);
  if (origin == nullptr || !same(*origin, head))
    problem("{}: found another file, receipt or name in the file than in the audit trail", subject);
  const TestVersion& latest = versions.back();
  const std::string machine = latest.machine ? machines_[*latest.machine].name : "";
  const std::string axis = latest.axis ? axes_[*latest.axis].name : latest.axis_name;
  const std::string kind = latest.axis ? axes_[*latest.axis].kind : latest.axis_kind;
  Fingerprint is;
  Fingerprint shall;
  if (listed == nullptr ||
      is.add(listed->cells()).finish() != shall.add(list_cells(head, latest, machine, axis, kind)).finish())
    problem("{}: found another line in the lists than its latest version gives", subject);
}

Result<void> Verifier::some_tests(Id first, Id last) {
  AXIOMETRY_TRY(const std::vector<TestHead> heads, read_heads(connection_, first, last));
  AXIOMETRY_TRY(const std::vector<TestVersion> versions, read_versions(connection_, first, last));
  AXIOMETRY_TRY(const Rows lists, listed(connection_, first, last));
  auto version = versions.begin();
  auto list = lists.begin();
  Id expected = first;
  for (const TestHead& head : heads) {
    for (; expected < head.id; ++expected) problem("test {}: found none, expected all without gaps", expected);
    expected = head.id + 1;
    const auto begin = version;
    while (version != versions.end() && version->test == head.id) ++version;
    while (list != lists.end() && list->integer(0) < head.id) ++list;
    const bool is_listed = list != lists.end() && list->integer(0) == head.id;
    check_test(head, {begin, version}, is_listed ? &*list : nullptr);
    ++found_.tests;
  }
  return {};
}

Result<void> Verifier::tests() {
  AXIOMETRY_TRY(const Rows last, connection_.query("SELECT coalesce(max(id), 0) FROM test"));
  for (Id first = 1; first <= last[0].integer(0); first += tests_verified_at_once)
    AXIOMETRY_TRY_VOID(some_tests(first, std::min(first + tests_verified_at_once - 1, last[0].integer(0))));
  AXIOMETRY_TRY(const Rows versions, connection_.query("SELECT count(*) FROM test_version"));
  if (attested_.count("test") != versions[0].integer(0))
    problem("test: found {} versions, expected the {} of the audit trail", versions[0].integer(0),
            attested_.count("test"));
  return {};
}

Result<void> Verifier::documents() {
  AXIOMETRY_TRY(const Rows last, connection_.query("SELECT coalesce(max(id), 0), count(*) FROM document"));
  for (Id id = 1; id <= last[0].integer(0); ++id) {
    const auto document = read_document(connection_, id);
    if (!document && document.error().kind != ErrorKind::not_found) return std::unexpected(document.error());
    if (!document)
      problem("document {}: found none, expected all from 1 to {}", id, last[0].integer(0));
    else if (!attested_.knows(fmt::format("document {}", id), 0, fingerprint(*document)))
      problem("document {}: found it changed after it was kept", id);
  }
  if (attested_.count("document") != last[0].integer(1))
    problem("document: found {}, expected the {} of the audit trail", last[0].integer(1), attested_.count("document"));
  return {};
}

}  // namespace

Result<Expectations> expectations(const Place& place) {
  const Expectations expected{.schema = expected_schema_parts(place)};
  if (!expected.schema && expected.schema.error().kind != ErrorKind::read_only)
    return std::unexpected(expected.schema.error());
  return expected;
}

Result<Verification> verify_archive(Connection& connection, const Expectations& expected) {
  return Verifier(connection, expected).run();
}

Result<Verification> Store::verify(std::span<const Seal> seals) const {
  AXIOMETRY_TRY(Expectations expected, expectations(state_->pool.place()));
  expected.seals = seals;
  return state_->read([&](Connection& connection) { return verify_archive(connection, expected); });
}

Result<Seal> Store::seal(const SigningKey& key, const std::optional<Seal>& earlier) const {
  return state_->read([&](Connection& connection) -> Result<Seal> {
    AXIOMETRY_TRY(const Rows last, connection.query("SELECT id, sha256, at FROM audit ORDER BY id DESC LIMIT 1"));
    if (last.empty()) return fail("found an archive in which nothing was ever kept, expected one to seal");
    const Head head{last[0].integer(0), last[0].text(1), last[0].text(2)};
    if (earlier) {
      AXIOMETRY_TRY(const Rows then,
                    connection.query("SELECT sha256 FROM audit WHERE id = $1", {earlier->head.entries}));
      if (then.empty() || then[0].text(0) != earlier->head.sha256)
        return fail(ErrorKind::damaged,
                    fmt::format("found an audit trail of {} entries that does not go on from entry {} as it was sealed "
                                "at {}, expected it to: verify says more",
                                head.entries, earlier->head.entries, earlier->at));
    }
    return sealed(head, key);
  });
}

}  // namespace axiometry::store
