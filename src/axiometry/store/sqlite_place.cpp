// SPDX-License-Identifier: Apache-2.0
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>
#include <thread>

#include "axiometry/base/text.h"
#include "axiometry/store/place.h"
#include "axiometry/store/sqlite_connection.h"
#include "axiometry/store/system_error.h"

namespace axiometry::store {
namespace {

namespace files = std::filesystem;

constexpr std::int64_t application_id = 0x4178'696F;  // "Axio", in bytes 68 to 71 of the file

enum class Mode {
  writing,
  reading,    // beside others who may write
  immutable,  // nobody can write, and not even SQLite's own files can be made beside it
};

class SqlitePlace final : public Place {
 public:
  SqlitePlace(std::string file, std::string path, Mode mode, std::string why_not)
      : file_(std::move(file)), path_(std::move(path)), mode_(mode), why_not_(std::move(why_not)) {}

  Result<std::unique_ptr<Connection>> connect() const override;
  Info info() const override {
    return {.kind = "sqlite", .location = file_, .schema = 0, .writable = mode_ == Mode::writing, .why_not = why_not_};
  }

 private:
  std::string file_;
  std::string path_;  // absolute
  Mode mode_;
  std::string why_not_;
};

Error in_store(Error error, const std::string& file) {
  error.file = file;
  return error;
}

std::unexpected<Error> fail_at(const std::string& file, ErrorKind kind, std::string message) {
  return std::unexpected(Error{std::move(message), file, {}, kind});
}

/// As SQLite's URI, where '?', '#' and '%' have a meaning.
std::string immutable_uri(const std::string& path) {
  std::string uri = "file:";
  for (const char c : path)
    uri += c == '?' || c == '#' || c == '%' ? fmt::format("%{:02X}", static_cast<unsigned char>(c)) : std::string(1, c);
  return uri + "?immutable=1";
}

Result<SqliteDatabase> opened(const std::string& path, Mode mode) {
  switch (mode) {
    case Mode::writing: return open_sqlite(path, SQLITE_OPEN_READWRITE);
    case Mode::reading: return open_sqlite(path, SQLITE_OPEN_READONLY);
    case Mode::immutable: break;
  }
  return open_sqlite(immutable_uri(path), SQLITE_OPEN_READONLY | SQLITE_OPEN_URI);
}

Result<std::unique_ptr<Connection>> SqlitePlace::connect() const {
  auto database = opened(path_, mode_);
  if (!database) return std::unexpected(in_store(std::move(database).error(), file_));
  auto connection = std::make_unique<SqliteConnection>(*std::move(database));
  const auto set = connection->script(
      "PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL; PRAGMA cache_size = -32000; PRAGMA temp_store = MEMORY; "
      "PRAGMA journal_size_limit = 67108864");
  if (!set) return std::unexpected(in_store(set.error(), file_));
  return connection;
}

/// New for its owner only, in a folder that is made if need be.
Result<void> make_file(const std::string& file, const std::string& path) {
  std::error_code error;
  const files::path folder = files::path(path).parent_path();
  files::create_directories(folder, error);
  if (error) {
    errno = error.value();
    return std::unexpected(system_error(file, fmt::format("make the folder {}", text::quoted(folder.string()))));
  }
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600);
  if (descriptor < 0 && errno != EEXIST) return std::unexpected(system_error(file, "make the store"));
  if (descriptor >= 0) ::close(descriptor);
  return {};
}

/// Why the file cannot be written, or nothing.
std::string obstacle(const std::string& path) {
  const auto said = [](std::string_view what) {
    return errno == EROFS ? std::string("its file system is mounted read-only")
                          : fmt::format("{} cannot be written: {}", what, std::strerror(errno));
  };
  if (::access(path.c_str(), W_OK) != 0) return said("the file");
  if (::access(files::path(path).parent_path().c_str(), W_OK) != 0) return said("its folder");
  return "";
}

/// How it can be read: with SQLite's files beside it where these are or can be made, else as it is, if that is all.
Result<Mode> mode_for_reading(const std::string& file, const std::string& path) {
  AXIOMETRY_TRY(SqliteDatabase database, opened(path, Mode::reading));
  SqliteConnection connection(std::move(database));
  const auto read = connection.query("SELECT count(*) FROM sqlite_master");
  if (read || read.error().kind == ErrorKind::damaged) return Mode::reading;
  std::error_code error;
  const auto waiting = files::file_size(path + "-wal", error);
  if (!error && waiting > 0)
    return fail_at(file, ErrorKind::unavailable,
                   "found changes in the file beside it (-wal) that cannot be merged where nothing can be written, "
                   "expected a copy of both files in a place that can be written");
  return Mode::immutable;
}

/// By its first sixteen bytes, the name of the format.
bool begins_as_database(const std::string& path) {
  constexpr std::string_view magic("SQLite format 3\0", 16);
  std::array<char, magic.size()> head{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), head.size());
  return stream.gcount() == static_cast<std::streamsize>(head.size()) &&
         std::string_view(head.data(), head.size()) == magic;
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
Result<bool> look_for_archive(const std::string& path, Mode mode) {
  AXIOMETRY_TRY(SqliteDatabase database, opened(path, mode == Mode::immutable ? mode : Mode::reading));
  SqliteConnection connection(std::move(database));
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

Result<void> prepare(const std::string& path, bool archive) {
  AXIOMETRY_TRY(SqliteDatabase database, opened(path, Mode::writing));
  SqliteConnection connection(std::move(database));
  if (!archive) AXIOMETRY_TRY_VOID(mark(connection));
  return write_ahead(connection);
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
  }
  const std::string why_not = opening.read_only ? "it was opened for reading only" : obstacle(path);
  Mode mode = Mode::writing;
  if (!why_not.empty()) {
    auto found = mode_for_reading(file, path);
    if (!found) return std::unexpected(in_store(std::move(found).error(), file));
    mode = *found;
  }
  auto archive = look_for_archive(path, mode);
  if (!archive) return std::unexpected(in_store(std::move(archive).error(), file));
  if (!*archive && (mode != Mode::writing || !opening.create))
    return fail_at(file, ErrorKind::not_found, "found an empty file, expected a store");
  if (mode == Mode::writing)
    if (const auto prepared = prepare(path, *archive); !prepared)
      return std::unexpected(in_store(prepared.error(), file));
  return std::make_unique<SqlitePlace>(file, path, mode, why_not);
}

}  // namespace axiometry::store
