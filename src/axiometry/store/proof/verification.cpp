// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/verification.h"

#include <fmt/format.h>

#include <map>

#include "axiometry/base/counted.h"
#include "axiometry/digest/ed25519.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/store/database/migrations.h"
#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/documents.h"
#include "axiometry/store/proof/attested.h"
#include "axiometry/store/proof/audit_trail.h"
#include "axiometry/store/proof/id_walk.h"
#include "axiometry/store/proof/problems.h"
#include "axiometry/store/proof/sqlite_pages.h"
#include "axiometry/store/proof/storage_classes.h"
#include "axiometry/store/proof/test_verification.h"
#include "axiometry/store/store_state.h"

namespace axiometry::store {
namespace {

constexpr std::int64_t numbers_at_once = 1000;

std::string number_text(std::int64_t n, std::string_view one, std::string_view many = {}) {
  return counted(static_cast<std::size_t>(n), one, many);
}

std::string entries_text(std::int64_t n) { return number_text(n, "entry", "entries"); }

/// Of each reference who refers to whom, and the question how many rows refer to none.
constexpr std::string_view lost_references_of_postgresql =
    "SELECT c.relname::text, p.relname::text, format('SELECT count(*) FROM %I c WHERE %s AND NOT EXISTS (SELECT 1 FROM "
    "%I p WHERE %s)', c.relname, string_agg(format('c.%I IS NOT NULL', ca.attname), ' AND '), p.relname, "
    "string_agg(format('p.%I = c.%I', pa.attname, ca.attname), ' AND ')) FROM pg_constraint k JOIN pg_class c ON c.oid "
    "= k.conrelid JOIN pg_class p ON p.oid = k.confrelid CROSS JOIN LATERAL unnest(k.conkey, k.confkey) AS u(child, "
    "parent) JOIN pg_attribute ca ON ca.attrelid = c.oid AND ca.attnum = u.child JOIN pg_attribute pa ON pa.attrelid = "
    "p.oid AND pa.attnum = u.parent WHERE k.contype = 'f' AND c.relnamespace = "
    "quote_ident(current_schema())::regnamespace GROUP BY k.oid, c.relname, p.relname ORDER BY 1, 2, k.oid";

class Verifier {
 public:
  Verifier(Connection& connection, const Expectations& expected) : connection_(connection), expected_(expected) {}

  Result<Verification> run();

 private:
  template <typename... Parts>
  void problem(fmt::format_string<Parts...> text, Parts&&... parts) {
    add_problem(found_.problems, text, std::forward<Parts>(parts)...);
  }
  Result<void> everything();
  Result<void> database();
  Result<void> references();
  Result<void> schema();
  Result<void> trail();
  void check_seals();
  void check_heads();
  void conclude();
  void conclude_known(const Head& known, std::string_view called);
  Result<void> contents();
  Result<void> content(Id id);
  void check_keeping(Id id, const Content& content, const Change& kept);
  Result<void> tests();
  Result<void> documents();
  Result<void> check_count(std::string_view table);

  Connection& connection_;
  const Expectations& expected_;
  Verification found_;
  Attested attested_;
  bool trail_is_read_ = false;                         // whether the trail was read to its head
  bool trail_is_sound_ = false;                        // whether the trail is sound from its first entry to its head
  std::map<std::int64_t, std::string> known_entries_;  // hashes of entries that something outside of the trail knows
  std::int64_t contents_without_name_ = 0;             // contents the trail tells without a name: older than names
  std::int64_t tests_without_format_ = 0;
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
  if (connection_.is_sqlite()) AXIOMETRY_TRY_VOID(verify_sqlite_log(connection_, found_));
  AXIOMETRY_TRY_VOID(schema());
  AXIOMETRY_TRY_VOID(database());
  if (expected_.schema) AXIOMETRY_TRY_VOID(verify_storage_classes(connection_, *expected_.schema, found_.problems));
  AXIOMETRY_TRY_VOID(trail());
  AXIOMETRY_TRY_VOID(contents());
  AXIOMETRY_TRY_VOID(verify_assets<MachineRecord>(connection_, attested_, found_.problems));
  AXIOMETRY_TRY_VOID(verify_assets<AxisRecord>(connection_, attested_, found_.problems));
  AXIOMETRY_TRY_VOID(verify_assets<InstrumentRecord>(connection_, attested_, found_.problems));
  AXIOMETRY_TRY_VOID(verify_assets<PlanRecord>(connection_, attested_, found_.problems));
  AXIOMETRY_TRY_VOID(verify_assets<CalibrationRecord>(connection_, attested_, found_.problems));
  AXIOMETRY_TRY_VOID(verify_assets<CompensationRecord>(connection_, attested_, found_.problems));
  AXIOMETRY_TRY_VOID(tests());
  return documents();
}

/// PostgreSQL checks its pages when they are read, where it was told to.
Result<void> Verifier::database() {
  if (!connection_.is_sqlite()) return references();
  return verify_sqlite_pages(connection_, found_.problems);
}

/// PostgreSQL checks references when they are written, which who takes the triggers away can prevent.
Result<void> Verifier::references() {
  AXIOMETRY_TRY(const Rows references, connection_.query(lost_references_of_postgresql));
  for (const Row& reference : references) {
    AXIOMETRY_TRY(const Rows lost, connection_.query(reference.text(2)));
    if (lost[0].integer(0) == 1)
      problem("{}: found a row that refers to a row of {} that does not exist", reference.text(0), reference.text(1));
    else if (lost[0].integer(0) > 1)
      problem("{}: found {} rows that refer to rows of {} that do not exist", reference.text(0), lost[0].integer(0),
              reference.text(1));
  }
  return {};
}

/// Without its triggers an archive only says that it cannot be changed. What stands in the place of a table, an endless
/// view it may be, is not read.
Result<void> Verifier::schema() {
  AXIOMETRY_TRY(const SchemaParts parts, schema_parts(connection_));
  const SchemaDifferences different =
      expected_.schema ? differences(parts, *expected_.schema) : differences_by_name(parts, connection_.is_sqlite());
  for (const std::string& difference : different.problems) problem("{}", difference);
  found_.missing_indexes = different.missing_indexes;
  found_.extras = different.extras;
  if (expected_.schema)
    found_.parts = static_cast<std::int64_t>(expected_.schema->size());
  else
    found_.unproved.push_back(
        fmt::format("that tables, constraints and triggers do what those of schema {} do: only that they are there and "
                    "switched on was looked at ({})",
                    newest_schema(), expected_.schema.error().message));
  if (different.of_tables)
    return fail(ErrorKind::damaged, fmt::format("found other tables, expected those of schema {}", newest_schema()));
  AXIOMETRY_TRY(const std::vector<std::string> migrations, other_migrations(connection_));
  for (const std::string& migration : migrations) problem("{}", migration);
  return {};
}

/// A clock may be set; that times do not follow each other is nobody's fault, but worth to be known.
Result<void> Verifier::trail() {
  for (const Seal& seal : expected_.seals) known_entries_[seal.head.entries] = "";
  for (const Head& head : expected_.heads) known_entries_[head.entries] = "";
  const std::size_t problems_before = found_.problems.size();
  std::string before;
  const auto visit = [&](const AuditEntry& entry) {
    attested_.add(entry);
    if (entry.change.at < before && found_.notes.size() < most_problems)
      found_.notes.push_back(
          fmt::format("audit trail: the clock went back between the entries {} and {}, from {} to {}", entry.id - 1,
                      entry.id, before, entry.change.at));
    before = entry.change.at;
    found_.head = {entry.id, entry.sha256, entry.change.at};
    if (const auto known = known_entries_.find(entry.id); known != known_entries_.end()) known->second = entry.sha256;
  };
  AXIOMETRY_TRY(found_.entries, verify_chain(connection_, found_.problems, visit));
  trail_is_read_ = true;
  trail_is_sound_ = found_.problems.size() == problems_before;
  check_seals();
  check_heads();
  return {};
}

void Verifier::check_seals() {
  for (const Seal& seal : expected_.seals) {
    const std::string& hash = known_entries_.at(seal.head.entries);
    if (seal.head.entries > found_.entries)
      problem("audit trail: found {}, expected at least the {} that were sealed at {}: its end is missing",
              entries_text(found_.entries), seal.head.entries, seal.at);
    else if (hash != seal.head.sha256)
      problem("audit trail: found entry {} with the hash {}, expected {} as it was sealed at {}", seal.head.entries,
              hash, seal.head.sha256, seal.at);
  }
}

void Verifier::check_heads() {
  for (const Head& head : expected_.heads) {
    const std::string& hash = known_entries_.at(head.entries);
    if (head.entries > found_.entries)
      problem("audit trail: found {}, expected at least the {} of the head {}:{}: its end is missing",
              entries_text(found_.entries), head.entries, head.entries, head.sha256);
    else if (!hash.starts_with(head.sha256))
      problem("audit trail: found entry {} with the hash {}, expected one that begins with {}", head.entries, hash,
              head.sha256);
  }
}

/// A seal is followed only by a trail that is sound to its head. Of one that was read to its end and does not fit the
/// problems tell.
void Verifier::conclude_known(const Head& known, std::string_view called) {
  const auto found = known_entries_.find(known.entries);
  const std::string hash = found == known_entries_.end() ? "" : found->second;
  if (trail_is_read_ && !hash.starts_with(known.sha256)) return;
  if (trail_is_sound_)
    found_.proved.push_back(found_.entries == known.entries
                                ? fmt::format("the audit trail ends as the {} has it", called)
                                : fmt::format("the audit trail goes on from the {}, {} longer now", called,
                                              entries_text(found_.entries - known.entries)));
  else
    found_.unproved.push_back(fmt::format("that the audit trail goes on from the {}: {}", called,
                                          hash.empty() ? "it was not reached" : "it is broken"));
}

/// What follows where nothing is wrong, and what does not even then.
void Verifier::conclude() {
  if (found_.problems.empty()) {
    found_.proved.insert(
        found_.proved.begin(),
        {found_.entries == 1
             ? "the 1 entry of the audit trail has the hash that follows from it"
             : fmt::format("each of the {} entries of the audit trail follows from all in front of it", found_.entries),
         found_.contents == 1
             ? "the 1 file has the bytes that the trail tells of"
             : fmt::format("each of the {} files has the bytes that the trail tells of", found_.contents),
         fmt::format("{} in all {} versions, machines, axes, instruments, plans, calibrations, "
                     "compensations and documents are those that the trail tells of, none more and none less",
                     number_text(found_.tests, "test"), found_.tests == 1 ? "its" : "their")});
    if (found_.parts > 0)
      found_.proved.push_back(
          fmt::format("the {} tables, constraints, indexes and triggers of the database are those of schema {}",
                      found_.parts, newest_schema()));
  }
  for (const Seal& seal : expected_.seals)
    conclude_known(seal.head, fmt::format("seal of {} (entry {})", seal.at, seal.head.entries));
  for (const Head& head : expected_.heads) conclude_known(head, fmt::format("head {}:{}", head.entries, head.sha256));
  if (contents_without_name_ > 0)
    found_.unproved.push_back(
        fmt::format("file name and format of {} (content.file_name, content.format): kept by a program whose entries "
                    "did not tell them",
                    number_text(contents_without_name_, "file")));
  if (tests_without_format_ > 0)
    found_.unproved.push_back(
        fmt::format("the format of the files of {} (test.format): received by a program whose entries did not tell it",
                    number_text(tests_without_format_, "test")));
  found_.unproved.push_back("when the archive was given its tables (migration.at): no entry tells it");
  found_.unproved.push_back("that kept figures follow from the kept files: nothing is evaluated again here");
  if (expected_.seals.empty() && expected_.heads.empty())
    found_.unproved.insert(
        found_.unproved.end(),
        {"that no entries are missing at the end of the audit trail with all that they tell of: only a seal from "
         "before can show that",
         "that nobody who may write the archive has made all of it anew, figures and trail together: only a seal or a "
         "report that lies elsewhere can show that"});
  else
    found_.unproved.push_back("that nothing was taken away again which came after the latest of the seals and heads");
  found_.unproved.push_back("that times and names are true: they are what clocks and people said");
}

Result<void> Verifier::contents() {
  IdCount count("content");
  AXIOMETRY_TRY_VOID(
      walk(connection_, {"content", "id", numbers_at_once}, [&](std::span<const Id> ids) -> Result<void> {
        for (const Id id : ids) {
          count.next(id, found_.problems);
          AXIOMETRY_TRY_VOID(content(id));
        }
        return {};
      }));
  return check_count("content");
}

Result<void> Verifier::content(Id id) {
  AXIOMETRY_TRY(
      const Rows rows,
      connection_.query("SELECT sha256, file_name, format, bytes, size, at, actor, reason FROM content WHERE id = $1",
                        {id}));
  if (rows.empty()) return {};
  const Row& row = rows[0];
  const Content content{row.text(0), row.text(1), row.text(2), row.text(3)};
  const std::string hash = sha256(content.bytes);
  if (hash != content.sha256 || row.integer(4) != static_cast<std::int64_t>(content.bytes.size()))
    problem("content {}: found {} bytes with the SHA-256 {}, expected {} with {}", id, content.bytes.size(), hash,
            row.integer(4), content.sha256);
  else if (!attested_.knows(fmt::format("content {}", id), 0, hash))
    problem("content {}: found bytes that the audit trail does not know", id);
  else
    check_keeping(id, content, {row.text(5), row.text(6), row.text(7)});
  ++found_.contents;
  return {};
}

void Verifier::check_keeping(Id id, const Content& content, const Change& kept) {
  const Keeping* told = attested_.kept(fmt::format("content {}", id));
  if (told == nullptr || told->change != kept)
    problem("content {}: found another time, name or reason than in the audit trail", id);
  else if (told->file_name.value_or(content.file_name) != content.file_name ||
           told->format.value_or(content.format) != content.format)
    problem("content {}: found another file name or format than in the audit trail", id);
  if (told != nullptr && !(told->file_name && told->format)) ++contents_without_name_;
}

Result<void> Verifier::tests() {
  AXIOMETRY_TRY(const VerifiedTests verified, verify_tests(connection_, attested_, found_.problems));
  found_.tests = verified.tests;
  tests_without_format_ = verified.without_format;
  return {};
}

Result<void> Verifier::documents() {
  IdCount count("document");
  const auto check = [&](Id id) -> Result<void> {
    count.next(id, found_.problems);
    AXIOMETRY_TRY(const DocumentRecord document, read_document(connection_, id));
    if (!attested_.knows(fmt::format("document {}", id), 0, fingerprint(document)))
      problem("document {}: found it changed after it was kept", id);
    return {};
  };
  AXIOMETRY_TRY_VOID(
      walk(connection_, {"document", "id", numbers_at_once}, [&](std::span<const Id> ids) -> Result<void> {
        for (const Id id : ids) AXIOMETRY_TRY_VOID(check(id));
        return {};
      }));
  return check_count("document");
}

Result<void> Verifier::check_count(std::string_view table) {
  AXIOMETRY_TRY(const Rows rows, connection_.query(fmt::format("SELECT count(*) FROM {}", table)));
  if (attested_.count(table) != rows[0].integer(0))
    problem("{}: found {}, expected the {} of the audit trail", table, rows[0].integer(0), attested_.count(table));
  return {};
}

/// The end of a trail that follows from its beginning, by way of an earlier seal.
Result<Head> sound_head(Connection& connection, const std::optional<Seal>& earlier) {
  Head head;
  std::string then;
  std::vector<std::string> problems;
  const auto visit = [&](const AuditEntry& entry) {
    head = {entry.id, entry.sha256, entry.change.at};
    if (earlier && entry.id == earlier->head.entries) then = entry.sha256;
  };
  AXIOMETRY_TRY(const std::int64_t entries, verify_chain(connection, problems, visit));
  if (!problems.empty())
    return fail(ErrorKind::damaged, fmt::format("{}; expected a trail that is whole, to seal it", problems.front()));
  if (earlier && then != earlier->head.sha256)
    return fail(ErrorKind::damaged,
                fmt::format("found an audit trail of {} entries that does not go on from entry {} as it was sealed "
                            "at {}, expected it to: verify says more",
                            entries, earlier->head.entries, earlier->at));
  return head;
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

Result<Verification> Store::verify(std::span<const Seal> seals, std::span<const Head> heads) const {
  AXIOMETRY_TRY(Expectations expected, expectations(state_->pool.place()));
  expected.seals = seals;
  expected.heads = heads;
  return state_->read([&](Connection& connection) { return verify_archive(connection, expected); });
}

Result<Head> Store::head() const {
  return state_->read([](Connection& connection) -> Result<Head> {
    AXIOMETRY_TRY(const Rows last, connection.query("SELECT id, sha256, at FROM audit ORDER BY id DESC LIMIT 1"));
    if (last.empty()) return Head{};
    return Head{last[0].integer(0), last[0].text(1), last[0].text(2)};
  });
}

Result<Seal> Store::seal(const SigningKey& key, const Sealing& sealing) const {
  return state_->read([&](Connection& connection) -> Result<Seal> {
    AXIOMETRY_TRY(const Head head, sound_head(connection, sealing.earlier));
    if (head.entries == 0) return fail("found an archive in which nothing was ever kept, expected one to seal");
    const auto& earlier = sealing.earlier;
    if (earlier && earlier->public_key != key.public_key() && !sealing.change_key)
      return fail(ErrorKind::conflict,
                  fmt::format("found a seal of the key {}, expected one of the key {} to go on from: another key is "
                              "taken only where that is asked for",
                              earlier->public_key, key.public_key()));
    return sealed(head, key);
  });
}

}  // namespace axiometry::store
