// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/store/kept/test_records.h"
#include "axiometry/store/proof/seal.h"
#include "axiometry/store/records.h"
#include "axiometry/store/transaction.h"

/// The archive of machines, axes, instruments, plans, tests, calibrations and compensations: SQLite in one file, or
/// PostgreSQL for a team, behind one interface. Nothing measured can be changed or lost: rows of data, versions,
/// documents and the audit trail are only ever added, which triggers in the database itself enforce; an edit makes a
/// new version. Every call is one transaction that is on the disk when the call returns, or has left no trace.
namespace axiometry::store {

struct Opening {
  bool create = true;      ///< whether a store is made where there is none yet
  bool read_only = false;  ///< also taken when the place turns out to be read-only (Info::writable)
  bool damaged_log =
      false;  ///< whether a file is opened of whose log (-wal) SQLite passes over more than a crash leaves
};

struct Info {
  std::string kind;      ///< "sqlite" or "postgresql"
  std::string location;  ///< file or address, never with a password
  int schema = 0;        ///< number of the last migration
  bool writable = true;
  std::string why_not;     ///< why a store cannot be written: "the file system is mounted read-only"
  std::string obstacle{};  ///< likewise, however it is opened; empty where it could be written
};

/// What verify() looked at and what is wrong; nothing is when `problems` is empty.
struct Verification {
  std::int64_t contents = 0;  ///< contents whose bytes have the hash they are called by
  std::int64_t tests = 0;     ///< tests whose versions are complete
  std::int64_t entries = 0;   ///< entries of the audit trail, chained
  std::int64_t parts = 0;     ///< sound parts of the schema: tables, constraints, triggers …; 0: not compared
  Head head;
  bool last_change_is_lost = false;  ///< by a crash, or altered, which one of `notes` says
  std::vector<std::string> problems;
  std::vector<std::string> missing_indexes;  ///< problems that cost time alone, and on which no row depends
  std::vector<std::string> notes;            ///< nothing wrong by themselves, but worth to be known
  std::vector<std::string> extras;    ///< parts of the schema that are somebody's own, and guard or change nothing
  std::vector<std::string> proved;    ///< sentences, of what nothing speaks against
  std::vector<std::string> unproved;  ///< what nothing that was looked at can prove
};

/// What restore() has filled.
struct Restored {
  Counts counts;
  std::vector<std::string> left_behind;  ///< a sentence for each part of the backup's schema that is somebody's own
};

/// May be used from many threads at once. Errors have the kinds not_found, conflict (a version that is no longer the
/// latest), read_only, full, unavailable (busy for longer than ten seconds, server gone) and damaged.
class Store {
 public:
  /// `address` is a file or "postgresql://…". Applies what migrations are missing. Fails on a store of a newer program
  /// (naming both versions), on a file that is no store, where none can be made, and with `damaged` on one whose log
  /// was altered, unless `opening` allows it.
  static Result<std::unique_ptr<Store>> open(std::string_view address, const Opening& opening = {});
  ~Store();
  Store(const Store&) = delete;
  Store& operator=(const Store&) = delete;

  Info info() const;

  /// All that `function(const Transaction&)` reads is of one moment. Where the connection is lost it is called again.
  template <typename Function>
  auto read(Function function) const -> std::invoke_result_t<Function, const Transaction&> {
    std::optional<std::invoke_result_t<Function, const Transaction&>> answer;
    AXIOMETRY_TRY_VOID(
        read_within([&](const Transaction& archive) { return done(answer.emplace(function(archive))); }));
    return *std::move(answer);
  }
  /// All that `function(Transaction&)` writes is kept, or nothing when it fails. Nobody else writes meanwhile.
  template <typename Function>
  auto write(Function function) -> std::invoke_result_t<Function, Transaction&> {
    std::optional<std::invoke_result_t<Function, Transaction&>> answer;
    AXIOMETRY_TRY_VOID(write_within([&](Transaction& archive) { return done(answer.emplace(function(archive))); }));
    return *std::move(answer);
  }

  /// How many threads wait until another has written.
  std::size_t waiting_to_write() const;

  Result<Counts> counts() const;

  /// Asset is MachineRecord, AxisRecord, InstrumentRecord, PlanRecord, CalibrationRecord or CompensationRecord.
  template <typename Asset>
  Result<Versioned<Asset>> add(const Asset& asset, const By& by);
  template <typename Asset>
  Result<Versioned<Asset>> change(Id id, int base_version, const Asset& asset, const By& by);
  template <typename Asset>
  Result<Versioned<Asset>> get(Id id, std::optional<int> version = {}) const;
  template <typename Asset>
  Result<std::vector<Versioned<Asset>>> all() const;  ///< latest versions, by name
  template <typename Asset>
  Result<std::vector<Versioned<Asset>>> versions(Id id) const;  ///< oldest first

  /// Keeps a file and all its tests, or nothing. Bytes that are there already are kept once. The tests' ids in order.
  Result<std::vector<Id>> receive(const Content& content, std::span<const NewTest> tests, const By& by);
  /// A new version. Fails with `conflict` when base_version is not the latest, saying who made that one and when.
  Result<int> revise(Id test, int base_version, const TestState& state, const By& by);
  Result<void> withdraw(Id test, bool withdrawn, const By& by);

  Result<TestRecord> test(Id id, std::optional<int> version = {}) const;
  Result<std::vector<Change>> test_versions(Id id) const;  ///< the first is version 1
  Result<TestPage> tests(const TestFilter& filter) const;
  Result<CalibrationPage> calibrations(const CalibrationFilter& filter) const;
  Result<std::vector<CompensationRow>> compensations(const CompensationFilter& filter) const;
  /// Of every machine that has any, or of one, by its id.
  Result<std::vector<MachineTests>> machine_tests(std::optional<Id> machine = {}) const;
  /// Of every axis that has a test, or of those of one machine, by machine and axis.
  Result<std::vector<AxisLatest>> axes_latest(std::optional<Id> machine = {}) const;
  /// By the date of measurement, then of arrival; the newest `limit`. Of the same bytes kept twice one counts.
  Result<std::vector<TrendPoint>> trend(Id axis, std::span<const std::string> parameters, std::int64_t limit) const;

  /// Bytes without a test: a plan's JSON, a raw recording. Gives the SHA-256.
  Result<std::string> keep(const Content& content, const By& by);
  /// Fails with `damaged` when the bytes no longer have that hash.
  Result<Content> content(const std::string& sha256) const;
  Result<std::int64_t> content_size(const std::string& sha256) const;  ///< bytes, to be asked for before they are read

  Result<DocumentRecord> add_document(const DocumentRecord& document, std::string_view bytes, const By& by);
  Result<std::vector<DocumentRecord>> documents(Id test) const;
  Result<DocumentRecord> document(Id id) const;  ///< without its bytes, which content(sha256) gives

  Result<std::vector<AuditEntry>> audit(const std::string& subject, std::int64_t before, std::int64_t limit) const;

  /// Reads once what searches, lists and courses are made of, the newest tests first, until `stop` is asked: the pages
  /// lie all over a large file, and whoever asks first would wait for the disk. Does nothing where the archive is a
  /// server's.
  Result<void> warm_up(const std::stop_token& stop) const;

  /// Reads everything: hashes, chain, references, the schema with its triggers, and what the database itself can check;
  /// and whether the audit trail goes on from these seals and these heads, whose hashes may be cut short.
  Result<Verification> verify(std::span<const Seal> seals = {}, std::span<const Head> heads = {}) const;
  /// The end of the audit trail as it is now; not looked at.
  Result<Head> head() const;
  /// Signs the end of the audit trail. Fails without any entry, with `damaged` where the trail does not follow from its
  /// beginning or go on from an earlier seal, with `conflict` where another key has signed that; looks at nothing else.
  Result<Seal> seal(const SigningKey& key, const Sealing& sealing = {}) const;
  /// A consistent copy as a new SQLite file, whatever this store is, while others go on writing, which is verified
  /// before it gets its name: what was found there. A missing index of our own is told and no more; what is somebody's
  /// own in PostgreSQL is told and left behind. What else is wrong with the tables and triggers there stands in
  /// `notes`, for the backup has its own, and so does why they could not be compared. Fails when the file exists, and
  /// with `damaged` where the copy is not whole.
  Result<Verification> backup(const std::string& file) const;
  /// Fills an empty or not yet existing store at `address` from a backup, after verifying it, with all indexes of our
  /// own and nothing of somebody else's. Fails on a store that holds anything.
  static Result<Restored> restore(const std::string& backup_file, std::string_view address);

 private:
  struct State;
  explicit Store(std::unique_ptr<State> state);

  template <typename T>
  static Result<void> done(const Result<T>& answer) {
    return answer ? Result<void>() : std::unexpected(answer.error());
  }
  Result<void> read_within(const std::function<Result<void>(const Transaction&)>& function) const;
  Result<void> write_within(const std::function<Result<void>(Transaction&)>& function);

  std::unique_ptr<State> state_;
};

}  // namespace axiometry::store
