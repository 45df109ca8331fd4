// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/database/postgresql_wait.h"

#include <fmt/format.h>
#include <poll.h>

#include <cerrno>
#include <string_view>
#include <vector>

namespace axiometry::store {
namespace {

/// Whether anything happened to the socket within that time.
bool heard(PGconn* session, short events, std::chrono::milliseconds silence) {
  pollfd waited{.fd = PQsocket(session), .events = events, .revents = 0};
  const auto until = std::chrono::steady_clock::now() + silence;
  while (true) {
    const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now()).count();
    const int ready = ::poll(&waited, 1, left > 0 ? static_cast<int>(left) : 0);
    if (ready >= 0 || errno != EINTR) return ready != 0;
  }
}

/// libpq goes on to the next of several hosts only when it waits itself.
bool names_several_hosts(const PostgresqlSettings& settings) {
  for (const char* key : {"host", "hostaddr"})
    if (const auto named = settings.find(key); named != settings.end() && named->second.contains(',')) return true;
  return false;
}

}  // namespace

std::optional<PostgresqlSession> connect_patiently(const PostgresqlSettings& settings,
                                                   std::chrono::milliseconds silence) {
  std::vector<const char*> keys;
  std::vector<const char*> values;
  for (const auto& [key, value] : settings) {
    keys.push_back(key.c_str());
    values.push_back(value.c_str());
  }
  keys.push_back(nullptr);
  values.push_back(nullptr);
  if (names_several_hosts(settings)) return PostgresqlSession(PQconnectdbParams(keys.data(), values.data(), 0));
  PostgresqlSession session(PQconnectStartParams(keys.data(), values.data(), 0));
  if (!session || PQstatus(session.get()) == CONNECTION_BAD) return session;
  PostgresPollingStatusType wanted = PGRES_POLLING_WRITING;
  while (wanted == PGRES_POLLING_READING || wanted == PGRES_POLLING_WRITING) {
    if (!heard(session.get(), wanted == PGRES_POLLING_READING ? POLLIN : POLLOUT, silence)) return std::nullopt;
    wanted = PQconnectPoll(session.get());
  }
  return session;
}

Waited wait_for_result(PGconn* session, std::chrono::milliseconds silence) {
  while (true) {
    const int left = PQflush(session);
    if (left < 0 || (left == 0 && PQisBusy(session) == 0)) return Waited::answered;
    if (!heard(session, left > 0 ? POLLIN | POLLOUT : POLLIN, silence)) return Waited::silent;
    if (PQconsumeInput(session) == 0) return Waited::answered;  // the session then states the reason
  }
}

PostgresqlWatch::Found PostgresqlWatch::look() {
  if (!session_) {
    auto session = connect_patiently(settings_, answer_allowed);
    if (!session) return Found::silent;
    if (!*session || PQstatus(session->get()) != CONNECTION_OK) return Found::working;  // it refused, so it lives
    session_ = *std::move(session);
    PQsetnonblocking(session_.get(), 1);
  }
  const std::string asked = fmt::format("SELECT state FROM pg_stat_activity WHERE pid = {}", backend_);
  if (PQsendQuery(session_.get(), asked.c_str()) != 1) return Found::working;
  std::string state;
  while (true) {
    if (wait_for_result(session_.get(), answer_allowed) == Waited::silent) return Found::silent;
    const PostgresqlAnswer answer(PQgetResult(session_.get()));
    if (!answer) break;
    if (PQntuples(answer.get()) == 1) state = PQgetvalue(answer.get(), 0, 0);
  }
  return state.starts_with("idle") ? Found::idle : Found::working;
}

}  // namespace axiometry::store
