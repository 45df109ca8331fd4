// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <libpq-fe.h>

#include <memory>
#include <string>

#include "axiometry/store/connection.h"

namespace axiometry::store {

struct PostgresqlCloser {
  void operator()(PGconn* connection) const { PQfinish(connection); }
  void operator()(PGresult* result) const { PQclear(result); }
};
using PostgresqlSession = std::unique_ptr<PGconn, PostgresqlCloser>;
using PostgresqlAnswer = std::unique_ptr<PGresult, PostgresqlCloser>;

/// SQL for the first name of the search path, quoted: the schema to make where none of the path exists.
inline constexpr const char* first_schema_of_path =
    "quote_ident(trim(BOTH ' \"' FROM split_part(current_setting('search_path'), ',', 1)))";

class PostgresqlConnection final : public Connection {
 public:
  explicit PostgresqlConnection(PostgresqlSession session) : session_(std::move(session)) {}

  Result<void> script(const std::string& sql) override;
  Result<void> begin_read() override;
  Result<void> begin_write() override;
  Result<void> commit() override;
  void rollback() override;
  bool alive() const override { return !lost_; }
  bool is_sqlite() const override { return false; }
  PGconn* session() const { return session_.get(); }

 private:
  Result<Rows> execute(std::string_view sql, std::span<const Parameter> parameters) override;
  Result<PostgresqlAnswer> checked(PGresult* result);

  PostgresqlSession session_;
  bool lost_ = false;
};

}  // namespace axiometry::store
