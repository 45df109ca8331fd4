// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/database/postgresql_connection.h"

#include <fmt/format.h>

#include <charconv>
#include <cstring>

#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::store {
namespace {

// Types by their number in pg_type, which never changes; a domain comes as what it is made of.
constexpr Oid type_boolean = 16, type_bytes = 17, type_int8 = 20, type_int2 = 21, type_int4 = 23, type_float4 = 700,
              type_float8 = 701, type_numeric = 1700;

/// By the class of SQLSTATE (PostgreSQL's manual, appendix A).
ErrorKind kind_of(std::string_view state) {
  if (state == "53100") return ErrorKind::full;
  if (state == "25006" || state == "42501") return ErrorKind::read_only;
  if (state.starts_with("XX")) return ErrorKind::damaged;
  for (const std::string_view mistake : {"21", "22", "23", "P0"})
    if (state.starts_with(mistake)) return ErrorKind::bad_input;
  return ErrorKind::unavailable;
}

std::string message_of(std::string_view state, std::string_view said, ErrorKind kind) {
  if (state == "55P03") return "found the store locked by another program for ten seconds, expected it to be free";
  switch (kind) {
    case ErrorKind::full:
      return fmt::format("found no room left for the store ({}), expected some; nothing of this was kept", said);
    case ErrorKind::read_only: return fmt::format("found a store that can only be read ({}), expected to write", said);
    case ErrorKind::damaged: return fmt::format("found a damaged store: {}", said);
    default: return fmt::format("the store cannot be used: {}", said);
  }
}

bool server_is_leaving(std::string_view state) { return state.starts_with("08") || state.starts_with("57P"); }

int digit(char c) { return c <= '9' ? c - '0' : c - 'a' + 10; }

/// bytea as text: "\x" and two digits for each byte.
std::string bytes_of(std::string_view hexadecimal) {
  AXIOMETRY_CONTRACT(hexadecimal.starts_with("\\x"));
  hexadecimal.remove_prefix(2);
  std::string bytes(hexadecimal.size() / 2, '\0');
  for (std::size_t k = 0; k < bytes.size(); ++k)
    bytes[k] = static_cast<char>(digit(hexadecimal[2 * k]) * 16 + digit(hexadecimal[2 * k + 1]));
  return bytes;
}

Cell cell_of(const PGresult* result, int row, int column) {
  if (PQgetisnull(result, row, column) != 0) return {};
  const std::string_view text(PQgetvalue(result, row, column),
                              static_cast<std::size_t>(PQgetlength(result, row, column)));
  switch (PQftype(result, column)) {
    case type_boolean: return std::int64_t{text == "t"};
    case type_int2:
    case type_int4:
    case type_int8: {
      std::int64_t value = 0;
      std::from_chars(text.data(), text.data() + text.size(), value);
      return value;
    }
    case type_numeric: {  // sums of integers
      std::int64_t value = 0;
      const auto read = std::from_chars(text.data(), text.data() + text.size(), value);
      if (read.ptr == text.data() + text.size()) return value;
      [[fallthrough]];
    }
    case type_float4:
    case type_float8: return parse_number(text).value_or(0.0);
    case type_bytes: return Bytes{bytes_of(text)};
    default: return std::string(text);
  }
}

/// Parameters as libpq wants them: parallel arrays of pointers, lengths and formats.
class Bound {
 public:
  explicit Bound(std::span<const Parameter> parameters) {
    texts_.reserve(parameters.size());  // pointers into them must stay
    for (const Parameter& parameter : parameters) add(parameter);
  }

  int size() const { return static_cast<int>(values.size()); }

  std::vector<const char*> values;
  std::vector<int> lengths;
  std::vector<int> formats;  // 1: binary

 private:
  void add(const Parameter& parameter) {
    if (std::holds_alternative<std::monostate>(parameter)) return push(nullptr, 0, 0);
    if (const auto* bytes = std::get_if<BytesView>(&parameter))
      return push(bytes->bytes.empty() ? "" : bytes->bytes.data(), static_cast<int>(bytes->bytes.size()), 1);
    if (const auto* integer = std::get_if<std::int64_t>(&parameter)) texts_.push_back(fmt::format("{}", *integer));
    if (const auto* real = std::get_if<double>(&parameter)) texts_.push_back(format_exact(*real));
    if (const auto* text = std::get_if<std::string_view>(&parameter)) texts_.emplace_back(*text);
    push(texts_.back().c_str(), 0, 0);
  }

  void push(const char* value, int length, int format) {
    values.push_back(value);
    lengths.push_back(length);
    formats.push_back(format);
  }

  std::vector<std::string> texts_;
};

}  // namespace

PostgresqlConnection::PostgresqlConnection(PostgresqlSession session, PostgresqlSettings settings)
    : session_(std::move(session)), settings_(std::move(settings)) {
  PQsetnonblocking(session_.get(), 1);
}

Result<PostgresqlAnswer> PostgresqlConnection::checked(PostgresqlAnswer answer) {
  const PGresult* result = answer.get();
  const ExecStatusType status = PQresultStatus(result);
  if (status == PGRES_TUPLES_OK || status == PGRES_COMMAND_OK) return answer;
  const char* found = result == nullptr ? nullptr : PQresultErrorField(result, PG_DIAG_SQLSTATE);
  const std::string_view state = found == nullptr ? "" : found;
  lost_ = lost_ || PQstatus(session_.get()) != CONNECTION_OK || server_is_leaving(state);
  if (lost_) return fail(ErrorKind::unavailable, "the connection to the store's server was lost, expected it to stay");
  const char* primary = PQresultErrorField(result, PG_DIAG_MESSAGE_PRIMARY);
  const ErrorKind kind = kind_of(state);
  return fail(kind, message_of(state, text::trim(primary == nullptr ? PQerrorMessage(session_.get()) : primary), kind));
}

/// A server that works is waited for, however long it takes; one that does not answer to anybody, or a session that has
/// not even heard the question, is given up. What another session sees of this one may be of a moment before.
Result<void> PostgresqlConnection::wait() {
  PostgresqlWatch watch(settings_, PQbackendPID(session_.get()));
  const auto until = std::chrono::steady_clock::now() + longest_statement;
  for (int times_idle = 0; wait_for_result(session_.get(), silence_allowed) == Waited::silent;) {
    const auto found = watch.look();
    times_idle = found == PostgresqlWatch::Found::idle ? times_idle + 1 : 0;
    silent_ = found == PostgresqlWatch::Found::silent;
    lost_ = silent_ || times_idle > 2 || std::chrono::steady_clock::now() > until;
    if (silent_)
      return fail(ErrorKind::unavailable,
                  "found the store's server silent, neither to this nor to a new connection, expected an answer: it is "
                  "stopped or out of reach");
    if (lost_)
      return fail(ErrorKind::unavailable, "the connection to the store's server fell silent, expected an answer");
  }
  return {};
}

Result<PostgresqlAnswer> PostgresqlConnection::answered(int sent) {
  PostgresqlAnswer last;
  while (sent == 1) {
    AXIOMETRY_TRY_VOID(wait());
    PostgresqlAnswer next(PQgetResult(session_.get()));
    if (!next) break;
    const bool failed = PQresultStatus(last.get()) == PGRES_FATAL_ERROR && last != nullptr;
    if (!failed) last = std::move(next);
  }
  return checked(std::move(last));
}

Result<Rows> PostgresqlConnection::execute(std::string_view sql, std::span<const Parameter> parameters) {
  const Bound bound(parameters);
  AXIOMETRY_TRY(const PostgresqlAnswer answer,
                answered(PQsendQueryParams(session_.get(), std::string(sql).c_str(), bound.size(), nullptr,
                                           bound.values.data(), bound.lengths.data(), bound.formats.data(), 0)));
  Rows rows;
  const int columns = PQnfields(answer.get());
  rows.reserve(static_cast<std::size_t>(PQntuples(answer.get())));
  for (int row = 0; row < PQntuples(answer.get()); ++row) {
    std::vector<Cell> cells;
    cells.reserve(static_cast<std::size_t>(columns));
    for (int column = 0; column < columns; ++column) cells.push_back(cell_of(answer.get(), row, column));
    rows.emplace_back(std::move(cells));
  }
  return rows;
}

Result<void> PostgresqlConnection::script(const std::string& sql) {
  AXIOMETRY_TRY(const PostgresqlAnswer answer, answered(PQsendQuery(session_.get(), sql.c_str())));
  return {};
}

Result<void> PostgresqlConnection::begin_read() { return script("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY"); }

Result<void> PostgresqlConnection::begin_write() {
  AXIOMETRY_TRY_VOID(script("BEGIN ISOLATION LEVEL READ COMMITTED READ WRITE"));
  // One writer at a time per schema, however its path is spelt, so that ids have no gaps. Given up with the
  // transaction.
  const auto locked =
      run(fmt::format("SELECT pg_advisory_xact_lock(1098410351, hashtext(coalesce(quote_ident(current_schema()), {})))",
                      first_schema_of_path));
  if (!locked) rollback();
  return locked;
}

Result<void> PostgresqlConnection::commit() {
  AXIOMETRY_TRY(const PostgresqlAnswer answer, answered(PQsendQuery(session_.get(), "COMMIT")));
  // COMMIT of a transaction that failed before answers ROLLBACK.
  if (std::strcmp(PQcmdStatus(answer.get()), "COMMIT") != 0)
    return fail(ErrorKind::unavailable, "found a transaction that had failed before, expected to save it");
  return {};
}

void PostgresqlConnection::rollback() {
  if (!lost_ && PQtransactionStatus(session_.get()) != PQTRANS_IDLE) static_cast<void>(script("ROLLBACK"));
}

}  // namespace axiometry::store
