// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <chrono>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/store/database/postgresql_connection.h"
#include "axiometry/store/place.h"

namespace axiometry::store {
namespace {

struct OptionsCloser {
  void operator()(PQconninfoOption* options) const { PQconninfoFree(options); }
  void operator()(char* text) const { PQfreemem(text); }
};

/// What an address says. libpq's own message could show the password, so it is not passed on.
Result<PostgresqlSettings> settings_of(const std::string& uri) {
  char* said = nullptr;
  const std::unique_ptr<PQconninfoOption, OptionsCloser> options(PQconninfoParse(uri.c_str(), &said));
  const std::unique_ptr<char, OptionsCloser> message(said);
  if (!options)
    return fail(
        "found an address of a store that PostgreSQL does not understand, expected "
        "postgresql://user@host:port/database, with special characters as %NN");
  PostgresqlSettings settings;
  for (const PQconninfoOption* option = options.get(); option->keyword != nullptr; ++option)
    if (option->val != nullptr) settings[option->keyword] = option->val;
  return settings;
}

/// No word of it may be shown, whoever says it.
std::string without(std::string message, const std::string& secret) {
  for (std::size_t at = 0; !secret.empty() && (at = message.find(secret, at)) != std::string::npos; at += 3)
    message.replace(at, secret.size(), "***");
  return message;
}

std::string one_line(std::string_view message) {
  std::string line;
  for (const char c : text::trim(message)) line += c == '\n' || c == '\t' ? ' ' : c;
  return line;
}

/// A server that has answered before does so again at once, or somebody waits for nothing.
constexpr std::chrono::milliseconds once_it_has_answered{800};

class PostgresqlPlace final : public Place {
 public:
  explicit PostgresqlPlace(PostgresqlSettings settings) : settings_(std::move(settings)) {}

  Result<std::unique_ptr<Connection>> connect() const override;
  Info info() const override { return info_; }

  /// Makes the schema if need be and finds out what may be done.
  Result<void> look(const Opening& opening);

  void allow_silence(std::chrono::milliseconds silence) { silence_ = silence; }

 private:
  PostgresqlSettings settings_;
  Info info_{.kind = "postgresql", .location = "", .schema = 0, .writable = true, .why_not = ""};
  bool reading_ = false;
  std::chrono::milliseconds silence_{10'000};  // allowed to a server that is asked for a connection
};

Result<std::unique_ptr<Connection>> PostgresqlPlace::connect() const {
  auto made = connect_patiently(settings_, silence_);
  if (!made)
    return fail(ErrorKind::unavailable, fmt::format("found the store's server silent for {} s, expected a connection",
                                                    std::chrono::duration<double>(silence_).count()));
  PostgresqlSession session = *std::move(made);
  if (!session || PQstatus(session.get()) != CONNECTION_OK) {
    const auto password = settings_.find("password");
    return fail(ErrorKind::unavailable,
                without(fmt::format("the store's server cannot be reached: {}",
                                    one_line(session ? PQerrorMessage(session.get()) : "out of memory")),
                        password == settings_.end() ? "" : password->second));
  }
  auto connection = std::make_unique<PostgresqlConnection>(std::move(session), settings_);
  AXIOMETRY_TRY_VOID(connection->script(
      "SET client_min_messages = error; SET synchronous_commit = on; SET lock_timeout = '10s'; "
      "SET statement_timeout = '15min'; SET jit = off; SET bytea_output = hex; SET extra_float_digits = 1; "
      "SET standard_conforming_strings = on"));
  const auto options = settings_.find("options");
  if (options == settings_.end() || options->second.find("search_path") == std::string::npos)
    AXIOMETRY_TRY_VOID(connection->script("SET search_path = axiometry"));
  if (reading_) AXIOMETRY_TRY_VOID(connection->script("SET default_transaction_read_only = on"));
  return connection;
}

/// As the connection has it, without the password.
std::string location_of(PGconn* session) {
  const std::string host = PQhost(session) == nullptr ? "" : PQhost(session);
  const bool socket = host.starts_with('/');
  return fmt::format("postgresql://{}@{}{}/{}{}", PQuser(session), socket ? "" : host,
                     socket ? "" : fmt::format(":{}", PQport(session)), PQdb(session),
                     socket ? fmt::format("?host={}&port={}", host, PQport(session)) : "");
}

Result<void> make_schema(Connection& connection) {
  // Two who do this at once would otherwise meet each other's half-made schema.
  AXIOMETRY_TRY_VOID(connection.begin_write());
  Rollback rollback(connection);
  AXIOMETRY_TRY(const Rows name, connection.query(fmt::format("SELECT {}", first_schema_of_path)));
  AXIOMETRY_TRY_VOID(connection.run(fmt::format("CREATE SCHEMA IF NOT EXISTS {}", name[0].text(0))));
  AXIOMETRY_TRY_VOID(connection.commit());
  rollback.release();
  return {};
}

Result<void> PostgresqlPlace::look(const Opening& opening) {
  AXIOMETRY_TRY(const std::unique_ptr<Connection> connection, connect());
  info_.location = location_of(static_cast<PostgresqlConnection&>(*connection).session());
  AXIOMETRY_TRY(const Rows found,
                connection->query("SELECT current_setting('server_encoding'), current_setting('transaction_read_only'),"
                                  " current_schema() IS NULL"));
  if (found[0].text(0) != "UTF8")
    return fail(fmt::format("found a database with the encoding {}, expected UTF8", found[0].text(0)));
  const bool standby = found[0].text(1) == "on";
  reading_ = opening.read_only || standby;
  if (reading_) {
    info_.writable = false;
    if (standby) info_.obstacle = "its server accepts no changes";
    info_.why_not = opening.read_only ? "it was opened for reading only" : info_.obstacle;
  }
  if (!found[0].flag(2)) return {};
  if (reading_ || !opening.create)
    return fail(ErrorKind::not_found, "found no archive in the database, expected a store");
  return make_schema(*connection);
}

}  // namespace

bool is_postgresql(std::string_view address) {
  return address.starts_with("postgresql://") || address.starts_with("postgres://");
}

Result<std::unique_ptr<Place>> postgresql_place(const std::string& uri, const Opening& opening) {
  AXIOMETRY_TRY(PostgresqlSettings settings, settings_of(uri));
  const auto timeout = settings.find("connect_timeout");
  const auto patience = timeout == settings.end() ? std::nullopt : parse_count(timeout->second);
  for (const auto& [key, value] : {std::pair{"connect_timeout", "10"},
                                   {"application_name", "axiometry"},
                                   {"keepalives_idle", "10"},
                                   {"keepalives_interval", "5"},
                                   {"keepalives_count", "3"},
                                   {"tcp_user_timeout", "15000"}})
    settings.try_emplace(key, value);
  settings["client_encoding"] = "UTF8";
  auto place = std::make_unique<PostgresqlPlace>(std::move(settings));
  if (patience && *patience > 0) place->allow_silence(std::chrono::seconds(*patience));
  AXIOMETRY_TRY_VOID(place->look(opening));
  if (!patience) place->allow_silence(once_it_has_answered);
  return place;
}

Result<std::unique_ptr<Place>> place_of(std::string_view address, const Opening& opening) {
  if (is_postgresql(address)) return postgresql_place(std::string(address), opening);
  if (const auto scheme = address.find("://"); scheme != std::string_view::npos)
    return fail(fmt::format("found the address {}, expected a file or postgresql://…",
                            text::quoted(address.substr(0, scheme + 3))));
  return sqlite_place(std::string(address), opening);
}

}  // namespace axiometry::store
