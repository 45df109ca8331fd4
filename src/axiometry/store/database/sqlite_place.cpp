// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>

#include "axiometry/store/database/sqlite_connection.h"
#include "axiometry/store/database/sqlite_file.h"
#include "axiometry/store/database/sqlite_log.h"
#include "axiometry/store/place.h"

namespace axiometry::store {
namespace {

namespace files = std::filesystem;

constexpr std::int64_t application_id = 0x4178'696F;  // "Axio", in bytes 68 to 71 of the file

/// An archive gets its mark with its first page.
constexpr std::uintmax_t largest_unmarked = 4096;

using OpenedSqlite = std::unique_ptr<SqliteConnection>;

Error in_store(Error error, const std::string& file) {
  if (error.file.empty()) error.file = file;
  return error;
}

std::unexpected<Error> fail_at(const std::string& file, ErrorKind kind, std::string message) {
  return std::unexpected(Error{std::move(message), file, {}, kind});
}

Result<OpenedSqlite> opened(const std::string& name, int flags) {
  AXIOMETRY_TRY(SqliteDatabase database, open_sqlite(name, flags));
  return std::make_unique<SqliteConnection>(std::move(database));
}

/// As SQLite's URI, where '?', '#' and '%' have a meaning.
std::string immutable_uri(const std::string& path) {
  std::string uri = "file:";
  for (const char c : path)
    uri += c == '?' || c == '#' || c == '%' ? fmt::format("%{:02X}", static_cast<unsigned char>(c)) : std::string(1, c);
  return uri + "?immutable=1";
}

/// Whether it is an archive, or else an empty database, which may become one. All is read at one moment, that of the
/// connection's transaction: another program may just be making the archive.
Result<bool> is_archive(SqliteConnection& connection) {
  AXIOMETRY_TRY(const Rows id, connection.query("PRAGMA application_id"));
  AXIOMETRY_TRY(const Rows tables, connection.query("SELECT count(*) FROM sqlite_master"));
  if (id[0].integer(0) == application_id) return true;
  if (id[0].integer(0) == 0 && tables[0].integer(0) == 0) return false;
  return fail(ErrorKind::bad_input,
              fmt::format("found a SQLite database of another program (application id {:#x}), expected a store",
                          id[0].integer(0)));
}

/// Likewise of a file that may be anything. Nothing is written.
Result<bool> look_for_archive(SqliteConnection& connection, const std::string& path) {
  AXIOMETRY_TRY_VOID(connection.begin_read());
  const Rollback rollback(connection);
  auto archive = is_archive(connection);
  if (archive || archive.error().kind != ErrorKind::damaged) return archive;
  if (begins_as_database(path))
    return fail(ErrorKind::damaged,
                "found a damaged SQLite database, cut off or overwritten in part, expected a whole one: leave it as it "
                "is and restore a backup into a new file");
  return fail(ErrorKind::bad_input, "found a file that is no SQLite database, expected a store");
}

/// Likewise where it may be written. What a program that was killed has begun to write into an archive, or into a file
/// so small that it may become one, only a connection that may write can take back.
Result<bool> look_before_writing(const std::string& path) {
  AXIOMETRY_TRY(const OpenedSqlite reading, opened(path, SQLITE_OPEN_READONLY));
  auto archive = look_for_archive(*reading, path);
  if (archive || archive.error().kind != ErrorKind::read_only) return archive;
  const bool ours = application_mark(path) == application_id || files::file_size(path) <= largest_unmarked;
  if (!ours) return archive;
  AXIOMETRY_TRY(const OpenedSqlite writing, opened(path, SQLITE_OPEN_READWRITE));
  return look_for_archive(*writing, path);
}

/// Of a change that is still to be taken back, which who only reads cannot do.
bool has_journal(const std::string& path) {
  std::error_code none;
  const std::uintmax_t size = files::file_size(path + "-journal", none);
  return !none && size > 0;
}

/// Beside others who may write. Where SQLite's own files can neither be found nor made beside it, the file as it is
/// now: the connection knows when it has changed.
Result<OpenedSqlite> opened_for_reading(const std::string& path) {
  AXIOMETRY_TRY(OpenedSqlite connection, opened(path, SQLITE_OPEN_READONLY));
  if (const auto read = connection->query("SELECT count(*) FROM sqlite_master"); !read) {
    const int code = sqlite3_errcode(connection->database());
    if (code == SQLITE_CORRUPT || code == SQLITE_NOTADB) return connection;  // look_for_archive() tells which
    if (code != SQLITE_CANTOPEN && code != SQLITE_READONLY) return std::unexpected(read.error());
  } else {
    return connection;
  }
  const auto stamp = file_stamp(path);
  if (!stamp) return fail(ErrorKind::not_found, "found no such file, expected a store");
  if (has_journal(path))
    return fail(ErrorKind::unavailable,
                "found a change that was begun and never finished, with a file beside it (-journal) to take it back, "
                "expected it taken back first: open the store once where it can be written");
  if (stamp->size_of_log > 0)
    return fail(ErrorKind::unavailable,
                "found changes in the file beside it (-wal) that cannot be merged where nothing can be written, "
                "expected a copy of both files in a place that can be written");
  AXIOMETRY_TRY(connection, opened(immutable_uri(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI));
  connection->expect_unchanged(path, *stamp);
  return connection;
}

/// Changing the journal does not wait for others by itself.
Result<void> write_ahead(SqliteConnection& connection) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(10);
  while (true) {
    const auto mode = connection.query("PRAGMA journal_mode = WAL");
    if (mode && (*mode)[0].text(0) == "wal") return {};
    if (mode)
      return fail(ErrorKind::unavailable,
                  "found a file system without shared memory, expected one where several "
                  "programs can use a SQLite file");
    if (mode.error().kind != ErrorKind::unavailable || std::chrono::steady_clock::now() > deadline)
      return std::unexpected(mode.error());
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

/// Only an empty database gets our mark, and only one program gives it.
Result<void> mark(SqliteConnection& connection) {
  AXIOMETRY_TRY_VOID(connection.begin_write());
  Rollback rollback(connection);
  AXIOMETRY_TRY(const bool marked, is_archive(connection));
  if (marked) return {};
  AXIOMETRY_TRY_VOID(connection.script(fmt::format("PRAGMA application_id = {}", application_id)));
  AXIOMETRY_TRY_VOID(connection.commit());
  rollback.release();
  return {};
}

class SqlitePlace final : public Place {
 public:
  /// `why_not` it can be written; empty where it can.
  SqlitePlace(std::string file, std::string path, std::string why_not)
      : file_(std::move(file)), path_(std::move(path)), why_not_(std::move(why_not)) {}

  Result<std::unique_ptr<Connection>> connect() const override {
    auto connection = connected();
    if (!connection) return std::unexpected(in_store(std::move(connection).error(), file_));
    return *std::move(connection);
  }
  Info info() const override {
    return {.kind = "sqlite",
            .location = file_,
            .schema = 0,
            .writable = writable(),
            .why_not = why_not_,
            .obstacle = obstacle_to_writing(path_)};
  }

  /// Finds an archive in the file, or makes an empty one where that is allowed.
  Result<void> prepare(bool create);

 private:
  bool writable() const { return why_not_.empty(); }
  Result<OpenedSqlite> connected() const;
  /// Another file that took the name later would be opened with what is still to be written into the first one.
  Result<void> is_in_place() const;

  std::string file_;
  std::string path_;  // absolute
  std::string why_not_;
  std::optional<FileStamp> first_;  // as it was when it was prepared
};

Result<void> SqlitePlace::prepare(bool create) {
  AXIOMETRY_TRY(const bool archive, [&]() -> Result<bool> {
    if (writable()) return look_before_writing(path_);
    AXIOMETRY_TRY(const OpenedSqlite connection, opened_for_reading(path_));
    return look_for_archive(*connection, path_);
  }());
  if (!archive && !(writable() && create)) return fail(ErrorKind::not_found, "found an empty file, expected a store");
  if (writable()) {
    AXIOMETRY_TRY(const OpenedSqlite connection, opened(path_, SQLITE_OPEN_READWRITE));
    if (!archive) AXIOMETRY_TRY_VOID(mark(*connection));
    AXIOMETRY_TRY_VOID(write_ahead(*connection));
  }
  first_ = file_stamp(path_);
  return {};
}

Result<void> SqlitePlace::is_in_place() const {
  const auto now = file_stamp(path_);
  return now && first_ && now->is_same_file(*first_) ? Result<void>() : fail_moved();
}

Result<OpenedSqlite> SqlitePlace::connected() const {
  AXIOMETRY_TRY_VOID(is_in_place());
  AXIOMETRY_TRY(OpenedSqlite connection, writable() ? opened(path_, SQLITE_OPEN_READWRITE) : opened_for_reading(path_));
  // EXTRA is FULL with a log ahead. Where a file system fault has kept the file without one, a commit is the removal of
  // the journal, and only EXTRA has that on the disk: a power cut would bring the journal back, and undo what was kept.
  AXIOMETRY_TRY_VOID(connection->script(
      "PRAGMA foreign_keys = ON; PRAGMA synchronous = EXTRA; PRAGMA cache_size = -32000; PRAGMA temp_store = MEMORY; "
      "PRAGMA journal_size_limit = 67108864"));
  AXIOMETRY_TRY_VOID(is_in_place());
  return connection;
}

}  // namespace

Result<std::unique_ptr<Place>> sqlite_place(const std::string& file, const Opening& opening) {
  std::error_code error;
  const std::string path = files::absolute(file, error).string();
  if (file.empty() || error) return fail("found no name of a file, expected that of a store");
  const auto status = files::status(path, error);
  if (files::is_directory(status)) return fail_at(file, ErrorKind::bad_input, "found a folder, expected a store");
  if (!files::exists(status)) {
    if (!opening.create || opening.read_only)
      return fail_at(file, ErrorKind::not_found, "found no such file, expected a store");
    AXIOMETRY_TRY_VOID(make_file(file, path));
  } else if (!files::is_regular_file(status)) {
    return fail_at(file, ErrorKind::bad_input, "found something that is no file, expected a store");
  } else if (!opening.damaged_log && application_mark(path) == application_id) {
    if (const auto whole = check_log_beside(path); !whole) return std::unexpected(in_store(whole.error(), file));
  }
  auto place = std::make_unique<SqlitePlace>(
      file, path, opening.read_only ? "it was opened for reading only" : obstacle_to_writing(path));
  if (const auto prepared = place->prepare(opening.create); !prepared)
    return std::unexpected(in_store(prepared.error(), file));
  return place;
}

}  // namespace axiometry::store
