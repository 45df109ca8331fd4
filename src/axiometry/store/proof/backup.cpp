// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>

#include "axiometry/base/counted.h"
#include "axiometry/base/json/json.h"
#include "axiometry/store/database/clock.h"
#include "axiometry/store/database/migrations.h"
#include "axiometry/store/database/sqlite_connection.h"
#include "axiometry/store/database/sqlite_log.h"
#include "axiometry/store/database/system_error.h"
#include "axiometry/store/own_names.h"
#include "axiometry/store/proof/audit_trail.h"
#include "axiometry/store/proof/copy.h"
#include "axiometry/store/proof/verification.h"
#include "axiometry/store/store_state.h"

namespace axiometry::store {
namespace {

namespace files = std::filesystem;

/// What errno says; a name that was taken meanwhile is a conflict.
std::unexpected<Error> fail_backup(const std::string& file, std::string_view doing) {
  const bool taken = errno == EEXIST;
  Error error = system_error(file, doing);
  if (taken) error.kind = ErrorKind::conflict;
  return std::unexpected(std::move(error));
}

std::unexpected<Error> fail_exists(const std::string& file) {
  return std::unexpected(
      Error{"found a file of this name, expected none: a backup never replaces one", file, {}, ErrorKind::conflict});
}

/// Without ever replacing a file of that name. Where the system cannot promise that, an empty file claims the name
/// first.
bool renamed_to_new(const std::string& from, const std::string& to) {
  if (::renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_NOREPLACE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS) return false;
  const int claimed = ::open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (claimed < 0) return false;
  ::close(claimed);
  if (::rename(from.c_str(), to.c_str()) == 0) return true;
  const int code = errno;
  ::unlink(to.c_str());
  errno = code;
  return false;
}

/// A new neighbour of the file that shall appear whole; gone again unless it gets the name.
class Neighbour {
 public:
  static Result<Neighbour> make(const std::string& file) {
    std::string name = file + ".part-XXXXXX";
    const int descriptor = ::mkostemp(name.data(), O_CLOEXEC);
    if (descriptor < 0) return fail_backup(file, "make a backup there");
    ::close(descriptor);
    return Neighbour(file, name);
  }
  ~Neighbour() {
    if (name_.empty()) return;
    for (const char* rest : {"", "-wal", "-shm", "-journal"}) ::unlink((name_ + rest).c_str());
  }
  Neighbour(Neighbour&& other) noexcept : file_(other.file_), name_(std::exchange(other.name_, "")) {}
  Neighbour& operator=(Neighbour&&) = delete;

  const std::string& name() const { return name_; }

  /// To the disk, then under its name, which nobody may have taken meanwhile.
  Result<void> take_name() const {
    if (!synced(name_, O_RDONLY)) return fail_backup(file_, "write the backup to the disk");
    if (::link(name_.c_str(), file_.c_str()) != 0) {
      if (errno == EEXIST) return fail_exists(file_);
      // A file system without links (FAT).
      if (!renamed_to_new(name_, file_)) {
        if (errno == EEXIST) return fail_exists(file_);
        return fail_backup(file_, "give the backup its name");
      }
    }
    const std::string folder = files::absolute(file_).parent_path().string();
    if (!synced(folder, O_RDONLY | O_DIRECTORY)) return fail_backup(file_, "write the folder of the backup");
    return {};
  }

 private:
  Neighbour(std::string file, std::string name) : file_(std::move(file)), name_(std::move(name)) {}

  static bool synced(const std::string& path, int flags) {
    const int descriptor = ::open(path.c_str(), flags | O_CLOEXEC);
    if (descriptor < 0) return false;
    const bool done = ::fsync(descriptor) == 0 || errno == EINVAL;  // some folders cannot be synced
    ::close(descriptor);
    return done;
  }

  std::string file_;
  std::string name_;
};

/// Pages of one moment, while others go on writing.
Result<void> copy_pages(sqlite3* from, const std::string& file) {
  AXIOMETRY_TRY(const SqliteDatabase to, open_sqlite(file, SQLITE_OPEN_READWRITE));
  sqlite3_backup* backup = sqlite3_backup_init(to.get(), "main", from, "main");
  if (backup == nullptr) return std::unexpected(sqlite_error(to.get()));
  const int copied = sqlite3_backup_step(backup, -1);
  if (sqlite3_backup_finish(backup) != SQLITE_OK) return std::unexpected(sqlite_error(to.get()));
  // A store that is locked for longer than we wait is no error to SQLite, but then nothing was copied.
  if (copied != SQLITE_DONE)
    return fail(ErrorKind::unavailable,
                "found the store locked by another program for ten seconds, expected it to be free");
  return {};
}

/// One file, without others beside it; closed when this returns.
Result<void> make_single(const std::string& file) {
  AXIOMETRY_TRY(SqliteDatabase database, open_sqlite(file, SQLITE_OPEN_READWRITE));
  SqliteConnection connection(std::move(database));
  return connection.script("PRAGMA journal_mode = DELETE");
}

/// What rows that are copied leave behind of the archive that they come from.
struct LeftBehind {
  SchemaDifferences schema{};
  std::string not_compared{};  ///< why only names were looked at
};

Result<LeftBehind> left_by_rows(Connection& from, const Place& place) {
  AXIOMETRY_TRY(const SchemaParts found, schema_parts(from));
  const auto expected = expected_schema_parts(place);
  if (!expected) return LeftBehind{differences_by_name(found, from.is_sqlite()), expected.error().message};
  return LeftBehind{differences(found, *expected), ""};
}

/// Of what the copy does not have, and its archive does.
void tell_left_behind(LeftBehind left, Verification& of_copy) {
  const auto& missing = left.schema.missing_indexes;
  for (const std::string& problem : left.schema.problems)
    if (std::ranges::find(missing, problem) == missing.end())
      of_copy.notes.push_back(fmt::format("in the archive, not in the backup: {}", problem));
  if (!left.not_compared.empty())
    of_copy.notes.push_back(
        fmt::format("tables, constraints and triggers of the archive, which the backup has its own of, were not "
                    "compared with those of schema {}, but for their names ({})",
                    newest_schema(), left.not_compared));
  std::ranges::move(left.schema.extras, std::back_inserter(of_copy.extras));
  std::ranges::move(left.schema.missing_indexes, std::back_inserter(of_copy.missing_indexes));
}

Result<void> copy_to_sqlite(Connection& from, const std::string& file) {
  AXIOMETRY_TRY(const std::unique_ptr<Place> place, sqlite_place(file, {}));
  AXIOMETRY_TRY(const std::unique_ptr<Connection> to, place->connect());
  AXIOMETRY_TRY(const int schema, migrate(*to));
  static_cast<void>(schema);
  AXIOMETRY_TRY_VOID(to->begin_write());
  Rollback rollback(*to);
  AXIOMETRY_TRY_VOID(copy_rows(from, *to));
  AXIOMETRY_TRY_VOID(to->commit());
  rollback.release();
  return {};
}

Result<void> check_empty(Connection& connection) {
  AXIOMETRY_TRY(const Rows rows, connection.query("SELECT (SELECT count(*) FROM audit), (SELECT count(*) FROM test)"));
  if (rows[0].integer(0) != 0)
    return fail(ErrorKind::conflict, fmt::format("found a store with {} and {} of audit trail, expected an empty one",
                                                 counted(static_cast<std::size_t>(rows[0].integer(1)), "test"),
                                                 counted(static_cast<std::size_t>(rows[0].integer(0)), "line")));
  return {};
}

/// A missing index takes nothing away from the rows, and who restores them makes it anew.
Result<void> check_whole(const Verification& verification, const std::string& backup_file) {
  std::vector<std::string> damage = verification.problems;
  std::erase_if(damage, [&](const std::string& problem) {
    return std::ranges::find(verification.missing_indexes, problem) != verification.missing_indexes.end();
  });
  if (damage.empty()) return {};
  return std::unexpected(Error{fmt::format("found a damaged backup ({}; the first: {}), expected one that is whole",
                                           counted(damage.size(), "problem"), damage[0]),
                               backup_file,
                               {},
                               ErrorKind::damaged});
}

/// A copy that nobody has read is a hope, not a backup.
Result<Verification> check_copy(const std::string& copy, const std::string& file) {
  AXIOMETRY_TRY(const std::unique_ptr<Store> store, Store::open(copy, {.create = false, .read_only = true}));
  AXIOMETRY_TRY(Verification verification, store->verify());
  AXIOMETRY_TRY_VOID(check_whole(verification, file));
  return verification;
}

Error in_file(Error error, const std::string& file) {
  if (error.file.empty() || error.file.starts_with(file + ".part-")) error.file = file;
  return error;
}

}  // namespace

Result<Verification> Store::backup(const std::string& file) const {
  std::error_code error;
  if (files::exists(files::symlink_status(file, error))) return fail_exists(file);
  AXIOMETRY_TRY(const Neighbour neighbour, Neighbour::make(file));
  LeftBehind left;
  LogState log;
  auto copied = [&]() -> Result<Verification> {
    if (state_->info.kind == "sqlite") {
      log = log_beside(state_->info.location);
      AXIOMETRY_TRY(const ConnectionPool::Lease connection, state_->pool.lease());
      AXIOMETRY_TRY_VOID(copy_pages(static_cast<SqliteConnection&>(*connection).database(), neighbour.name()));
    } else {
      AXIOMETRY_TRY_VOID(state_->read([&](Connection& connection) -> Result<void> {
        AXIOMETRY_TRY(left, left_by_rows(connection, state_->pool.place()));
        return copy_to_sqlite(connection, neighbour.name());
      }));
    }
    AXIOMETRY_TRY_VOID(make_single(neighbour.name()));
    return check_copy(neighbour.name(), file);
  }();
  if (!copied) return std::unexpected(in_file(copied.error(), file));
  AXIOMETRY_TRY_VOID(neighbour.take_name());
  tell_left_behind(std::move(left), *copied);
  if (log.is_undecided()) copied->notes.push_back(note_of_log(log));
  return copied;
}

Result<Restored> Store::restore(const std::string& backup_file, std::string_view address) {
  if (is_postgresql(backup_file)) return fail("found the address of a server as a backup, expected a file");
  AXIOMETRY_TRY(const std::unique_ptr<Store> from, open(backup_file, {.create = false, .read_only = true}));
  return from->state_->read([&](Connection& source) -> Result<Restored> {
    AXIOMETRY_TRY(const Expectations expected, expectations(from->state_->pool.place()));
    AXIOMETRY_TRY(const Verification verification, verify_archive(source, expected));
    AXIOMETRY_TRY_VOID(check_whole(verification, backup_file));
    AXIOMETRY_TRY(const std::unique_ptr<Store> to, open(address));
    const auto filled = to->state_->write([&](Connection& target) -> Result<void> {
      AXIOMETRY_TRY_VOID(check_empty(target));
      AXIOMETRY_TRY_VOID(copy_rows(source, target));
      json::Value detail = json::Value::object();
      detail.add("file", files::path(backup_file).filename().string());
      detail.add("tests", static_cast<double>(verification.tests));
      detail.add("entries", static_cast<double>(verification.entries));
      AXIOMETRY_TRY_VOID(record(target, change_now({std::string(restorer), ""}), {"store.restored", "store", detail}));
      return target.run("ANALYZE");
    });
    if (!filled) return std::unexpected(in_file(filled.error(), to->state_->info.location));
    AXIOMETRY_TRY(const Counts counts, to->counts());
    return Restored{counts, verification.extras};
  });
}

}  // namespace axiometry::store
