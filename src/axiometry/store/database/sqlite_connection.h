// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <sqlite3.h>

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/database/sqlite_file.h"

namespace axiometry::store {

struct SqliteCloser {
  void operator()(sqlite3* database) const { sqlite3_close_v2(database); }
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using SqliteDatabase = std::unique_ptr<sqlite3, SqliteCloser>;
using SqliteStatement = std::unique_ptr<sqlite3_stmt, SqliteCloser>;

/// What SQLite says about its last failure, with the kind that store.h promises.
Error sqlite_error(sqlite3* database);

/// The file of the archive is not where it was, or another one is.
std::unexpected<Error> fail_moved();

/// `name` may be a URI ("file:…?immutable=1").
Result<SqliteDatabase> open_sqlite(const std::string& name, int flags);

class SqliteConnection final : public Connection {
 public:
  explicit SqliteConnection(SqliteDatabase database) : database_(std::move(database)) {}

  Result<void> script(const std::string& sql) override;
  Result<void> begin_read() override;
  Result<void> begin_write() override;
  Result<void> commit() override;
  void rollback() override;
  bool alive() const override { return !stale_; }
  bool is_sqlite() const override { return true; }
  sqlite3* database() const { return database_.get(); }

  /// The database was opened as one that nobody changes. When its file has changed all the same, the connection is of
  /// no use any more.
  void expect_unchanged(std::string path, const FileStamp& stamp) { expected_ = {std::move(path), stamp}; }

 private:
  Result<Rows> execute(std::string_view sql, std::span<const Parameter> parameters) override;
  Result<sqlite3_stmt*> prepared(std::string_view sql);
  bool has_moved() const;    ///< whether the file has another name or none
  bool is_replaced() const;  ///< whether another one has its name

  struct Expected {
    std::string path;
    FileStamp stamp;
  };

  SqliteDatabase database_;
  std::map<std::string, SqliteStatement, std::less<>> statements_;  // by their SQL; end before the database is closed
  std::optional<Expected> expected_;
  bool stale_ = false;
};

}  // namespace axiometry::store
