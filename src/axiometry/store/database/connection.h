// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "axiometry/base/result.h"

/// A conversation with a database, as narrow as the archive needs it. The SQL above it is written once, in what SQLite
/// and PostgreSQL both understand; parameters are $1, $2, ….
namespace axiometry::store {

/// Bytes that are no text, as a parameter.
struct BytesView {
  std::string_view bytes;
};

/// As a cell.
struct Bytes {
  std::string bytes;
};

using Parameter = std::variant<std::monostate, std::int64_t, double, std::string_view, BytesView>;
using Cell = std::variant<std::monostate, std::int64_t, double, std::string, Bytes>;

/// An absent value is NULL.
template <typename T>
Parameter parameter(const std::optional<T>& value) {
  return value ? Parameter(*value) : Parameter();
}

/// Likewise, to be kept.
template <typename T>
Cell cell(const std::optional<T>& value) {
  return value ? Cell(*value) : Cell();
}

/// A cell as a parameter of the next statement; lives as long as the cell.
Parameter parameter(const Cell& cell);

/// Thrown where a cell holds what was never written into its column, a text for a number or 2 for a flag: somebody else
/// has been at the database, and no reader can go on. Ends the transaction as an Error of the kind damaged
/// (store_state.h).
struct DamagedCell {};

/// One line of an answer. Its cells are asked for as what was written into them.
class Row {
 public:
  explicit Row(std::vector<Cell> cells) : cells_(std::move(cells)) {}

  const std::vector<Cell>& cells() const { return cells_; }
  std::int64_t integer(std::size_t column) const;
  std::optional<std::int64_t> optional_integer(std::size_t column) const;
  int number(std::size_t column) const;
  bool flag(std::size_t column) const;  ///< 0 or 1
  double real(std::size_t column) const;
  std::optional<double> optional_real(std::size_t column) const;
  const std::string& text(std::size_t column) const;  ///< text, or the bytes of a blob
  bool null(std::size_t column) const;

 private:
  std::vector<Cell> cells_;
};

using Rows = std::vector<Row>;

/// Used by one thread at a time. Errors have the kind that store.h promises.
class Connection {
 public:
  virtual ~Connection() = default;
  Connection() = default;
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// One statement. Text that is not UTF-8 or holds a NUL, and a number that is not finite, are refused: one of the
  /// databases would, and both shall keep the same.
  Result<Rows> query(std::string_view sql, std::span<const Parameter> parameters = {});
  Result<Rows> query(std::string_view sql, std::initializer_list<Parameter> parameters) {
    return query(sql, std::span(parameters.begin(), parameters.size()));
  }
  Result<void> run(std::string_view sql, std::initializer_list<Parameter> parameters = {});
  Result<void> run(std::string_view sql, std::span<const Parameter> parameters);

  /// Several statements without parameters.
  virtual Result<void> script(const std::string& sql) = 0;

  /// All that is read until commit() or rollback() is of one moment.
  virtual Result<void> begin_read() = 0;
  /// Waits for up to ten seconds until no one else writes.
  virtual Result<void> begin_write() = 0;
  /// What was written is on the disk afterwards, or on failure nothing of it is kept.
  virtual Result<void> commit() = 0;
  virtual void rollback() = 0;

  /// Whether the connection can be used again; not after it was lost.
  virtual bool alive() const = 0;
  /// Whether it was lost because nobody answers at the other end: another one would be no better.
  virtual bool silent() const { return false; }
  virtual bool is_sqlite() const = 0;

  /// In front of a column that the database shall not look for in an index, because we know better.
  std::string_view unindexed() const { return is_sqlite() ? "+" : ""; }

 protected:
  virtual Result<Rows> execute(std::string_view sql, std::span<const Parameter> parameters) = 0;
};

/// Ends what a function began and did not commit.
class Rollback {
 public:
  explicit Rollback(Connection& connection) : connection_(&connection) {}
  ~Rollback() {
    if (connection_ != nullptr) connection_->rollback();
  }
  Rollback(const Rollback&) = delete;
  Rollback& operator=(const Rollback&) = delete;
  void release() { connection_ = nullptr; }

 private:
  Connection* connection_;
};

}  // namespace axiometry::store
