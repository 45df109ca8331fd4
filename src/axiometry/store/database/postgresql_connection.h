// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/database/postgresql_wait.h"

namespace axiometry::store {

/// SQL for the first name of the search path, quoted: the schema to make where none of the path exists.
inline constexpr const char* first_schema_of_path =
    "quote_ident(trim(BOTH ' \"' FROM split_part(current_setting('search_path'), ',', 1)))";

class PostgresqlConnection final : public Connection {
 public:
  /// By the settings the server is asked once more when it is silent.
  PostgresqlConnection(PostgresqlSession session, PostgresqlSettings settings);

  Result<void> script(const std::string& sql) override;
  Result<void> begin_read() override;
  Result<void> begin_write() override;
  Result<void> commit() override;
  void rollback() override;
  bool alive() const override { return !lost_; }
  bool silent() const override { return silent_; }
  bool is_sqlite() const override { return false; }
  PGconn* session() const { return session_.get(); }

 private:
  Result<Rows> execute(std::string_view sql, std::span<const Parameter> parameters) override;
  /// What came of a statement: the last of its results, or the first that is an error.
  Result<PostgresqlAnswer> answered(int sent);
  Result<void> wait();
  Result<PostgresqlAnswer> checked(PostgresqlAnswer answer);

  PostgresqlSession session_;
  PostgresqlSettings settings_;
  bool lost_ = false;
  bool silent_ = false;
};

}  // namespace axiometry::store
