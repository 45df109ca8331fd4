// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <libpq-fe.h>

#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <string>

/// Waiting for a server that may have been stopped. Such a one takes connections and what is sent to it (its system
/// does) and never answers, so that libpq's own calls would wait for ever, and its timeouts, which the server keeps,
/// never come.
namespace axiometry::store {

struct PostgresqlCloser {
  void operator()(PGconn* connection) const { PQfinish(connection); }
  void operator()(PGresult* result) const { PQclear(result); }
};
using PostgresqlSession = std::unique_ptr<PGconn, PostgresqlCloser>;
using PostgresqlAnswer = std::unique_ptr<PGresult, PostgresqlCloser>;

/// Of libpq, by keyword.
using PostgresqlSettings = std::map<std::string, std::string>;

/// So long a statement may be silent before the server is asked whether it lives, and so long that may take: together,
/// and with a connection in vain (0.8 s), little enough for an answer within two seconds. A live server may take any
/// time for a statement.
inline constexpr std::chrono::milliseconds silence_allowed{400};
inline constexpr std::chrono::milliseconds answer_allowed{600};

/// Beyond this no statement is waited for, whatever the server says. It gives up a little earlier itself.
inline constexpr std::chrono::minutes longest_statement{16};

/// Connects; nothing when the server is silent for that long. A session that could not be made says why itself.
std::optional<PostgresqlSession> connect_patiently(const PostgresqlSettings& settings,
                                                   std::chrono::milliseconds silence);

enum class Waited { answered, silent };

/// Until all that was sent is out and PQgetResult() will not block, or nothing was heard for that long.
Waited wait_for_result(PGconn* session, std::chrono::milliseconds silence);

/// Asks a server about one of its sessions, over another one that is kept for as long as this.
class PostgresqlWatch {
 public:
  PostgresqlWatch(const PostgresqlSettings& settings, int backend) : settings_(settings), backend_(backend) {}

  enum class Found {
    working,  ///< it works, or nothing is known against it
    idle,     ///< as if it had not heard what was sent
    silent,   ///< the server as a whole does not answer
  };
  Found look();

 private:
  const PostgresqlSettings& settings_;
  int backend_;
  PostgresqlSession session_;
};

}  // namespace axiometry::store
