// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/database/sqlite_connection.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>

#include "axiometry/base/contract.h"

namespace axiometry::store {
namespace {

constexpr std::size_t statements_kept = 200;
constexpr int patience_ms = 10'000;

ErrorKind kind_of(sqlite3* database) {
  const int system_error = sqlite3_system_errno(database);
  const bool no_room = system_error == ENOSPC || system_error == EDQUOT;
  switch (sqlite3_errcode(database)) {
    case SQLITE_BUSY:
    case SQLITE_LOCKED: return ErrorKind::unavailable;  // the number of the system is that of an earlier failure
    case SQLITE_FULL: return ErrorKind::full;
    case SQLITE_READONLY:
    case SQLITE_PERM: return ErrorKind::read_only;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB: return ErrorKind::damaged;
    case SQLITE_CONSTRAINT: return ErrorKind::bad_input;
    default: return no_room ? ErrorKind::full : ErrorKind::unavailable;
  }
}

std::string message_of(sqlite3* database, ErrorKind kind) {
  const std::string_view said = sqlite3_errmsg(database);
  switch (kind) {
    case ErrorKind::full:
      return fmt::format("found no room left for the store ({}), expected some; nothing of this was kept", said);
    case ErrorKind::read_only: return fmt::format("found a store that can only be read ({}), expected to write", said);
    case ErrorKind::damaged: return fmt::format("found a damaged store: {}", said);
    default: break;
  }
  const int code = sqlite3_errcode(database);
  if (code == SQLITE_BUSY || code == SQLITE_LOCKED)
    return "found the store locked by another program for ten seconds, expected it to be free";
  return fmt::format("the store cannot be used: {}", said);
}

/// "$1" as SQLite has it, "?1".
std::string numbered(std::string_view sql) {
  std::string translated(sql);
  std::ranges::replace(translated, '$', '?');
  return translated;
}

int bind(sqlite3_stmt* statement, int place, const Parameter& parameter) {
  if (const auto* integer = std::get_if<std::int64_t>(&parameter))
    return sqlite3_bind_int64(statement, place, *integer);
  if (const auto* real = std::get_if<double>(&parameter)) return sqlite3_bind_double(statement, place, *real);
  if (const auto* text = std::get_if<std::string_view>(&parameter))
    return sqlite3_bind_text64(statement, place, text->data() != nullptr ? text->data() : "", text->size(),
                               SQLITE_STATIC, SQLITE_UTF8);
  if (const auto* bytes = std::get_if<BytesView>(&parameter))
    return bytes->bytes.empty()
               ? sqlite3_bind_zeroblob(statement, place, 0)
               : sqlite3_bind_blob64(statement, place, bytes->bytes.data(), bytes->bytes.size(), SQLITE_STATIC);
  return sqlite3_bind_null(statement, place);
}

Cell cell_of(sqlite3_stmt* statement, int column) {
  const auto bytes = [&](const void* from) {
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, column));
    return size == 0 ? std::string() : std::string(static_cast<const char*>(from), size);
  };
  switch (sqlite3_column_type(statement, column)) {
    case SQLITE_INTEGER: return std::int64_t{sqlite3_column_int64(statement, column)};
    case SQLITE_FLOAT: return sqlite3_column_double(statement, column);
    case SQLITE_TEXT: return bytes(sqlite3_column_text(statement, column));
    case SQLITE_BLOB: return Bytes{bytes(sqlite3_column_blob(statement, column))};
    default: return {};
  }
}

/// Leaves a statement ready for its next use, whatever happens.
struct Reset {
  sqlite3_stmt* statement;
  ~Reset() {
    sqlite3_reset(statement);
    sqlite3_clear_bindings(statement);
  }
};

}  // namespace

Error sqlite_error(sqlite3* database) {
  const ErrorKind kind = kind_of(database);
  return {message_of(database, kind), {}, {}, kind};
}

std::unexpected<Error> fail_moved() {
  return fail(
      ErrorKind::unavailable,
      "found the store's file removed or replaced while it is in use, expected it in its place; nothing was written: "
      "put it back, or begin again with the one that is there");
}

Result<SqliteDatabase> open_sqlite(const std::string& name, int flags) {
  sqlite3* opened = nullptr;
  const int code = sqlite3_open_v2(name.c_str(), &opened, flags | SQLITE_OPEN_NOMUTEX, nullptr);
  SqliteDatabase database(opened);
  if (!database) return fail(ErrorKind::unavailable, "the store cannot be opened: out of memory");
  if (code != SQLITE_OK) return std::unexpected(sqlite_error(database.get()));
  sqlite3_extended_result_codes(database.get(), 0);
  sqlite3_busy_timeout(database.get(), patience_ms);
  sqlite3_db_config(database.get(), SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database.get(), SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  return database;
}

Result<sqlite3_stmt*> SqliteConnection::prepared(std::string_view sql) {
  if (const auto known = statements_.find(sql); known != statements_.end()) return known->second.get();
  if (statements_.size() >= statements_kept) statements_.clear();
  const std::string translated = numbered(sql);
  sqlite3_stmt* statement = nullptr;
  if (sqlite3_prepare_v2(database_.get(), translated.c_str(), static_cast<int>(translated.size()) + 1, &statement,
                         nullptr) != SQLITE_OK)
    return std::unexpected(sqlite_error(database_.get()));
  statements_.emplace(sql, statement);
  return statement;
}

Result<Rows> SqliteConnection::execute(std::string_view sql, std::span<const Parameter> parameters) {
  AXIOMETRY_TRY(sqlite3_stmt* const statement, prepared(sql));
  const Reset reset{statement};
  for (std::size_t k = 0; k < parameters.size(); ++k)
    if (bind(statement, static_cast<int>(k) + 1, parameters[k]) != SQLITE_OK)
      return std::unexpected(sqlite_error(database_.get()));
  Rows rows;
  int code = SQLITE_ROW;
  while ((code = sqlite3_step(statement)) == SQLITE_ROW) {
    std::vector<Cell> cells;
    const int columns = sqlite3_column_count(statement);
    cells.reserve(static_cast<std::size_t>(columns));
    for (int column = 0; column < columns; ++column) cells.push_back(cell_of(statement, column));
    rows.emplace_back(std::move(cells));
  }
  if (code != SQLITE_DONE) return std::unexpected(sqlite_error(database_.get()));
  return rows;
}

Result<void> SqliteConnection::script(const std::string& sql) {
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK)
    return std::unexpected(sqlite_error(database_.get()));
  return {};
}

/// SQLite goes on with a file that has no name any more: what is written into it is gone with this program, and what
/// another file of its name has in its log is taken for changes of this one.
bool SqliteConnection::has_moved() const {
  int moved = 0;
  return sqlite3_file_control(database_.get(), "main", SQLITE_FCNTL_HAS_MOVED, &moved) == SQLITE_OK && moved != 0;
}

bool SqliteConnection::is_replaced() const {
  return has_moved() && file_stamp(sqlite3_db_filename(database_.get(), "main"));
}

Result<void> SqliteConnection::begin_read() {
  if (is_replaced()) return fail_moved();
  if (expected_ && file_stamp(expected_->path) != expected_->stamp) {
    stale_ = true;
    return fail(ErrorKind::unavailable, "found the store changed by another program, expected it unchanged");
  }
  return run("BEGIN");
}

Result<void> SqliteConnection::begin_write() {
  AXIOMETRY_TRY_VOID(run("BEGIN IMMEDIATE"));
  if (!has_moved()) return {};
  rollback();
  return fail_moved();
}

/// What was written goes on into the file itself at once, unless somebody reads or the disk is full: a log that is left
/// beside it would be taken for that of a file which comes to stand in its place.
Result<void> SqliteConnection::commit() {
  AXIOMETRY_TRY_VOID(run("COMMIT"));
  sqlite3_busy_timeout(database_.get(), 0);
  static_cast<void>(sqlite3_wal_checkpoint_v2(database_.get(), "main", SQLITE_CHECKPOINT_TRUNCATE, nullptr, nullptr));
  sqlite3_busy_timeout(database_.get(), patience_ms);
  return {};
}

void SqliteConnection::rollback() {
  // A failure may have rolled back already; then there is nothing to end.
  if (sqlite3_get_autocommit(database_.get()) == 0) static_cast<void>(run("ROLLBACK"));
}

}  // namespace axiometry::store
