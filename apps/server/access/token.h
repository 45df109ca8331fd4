// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "server/access/sessions.h"
#include "server/http/http.h"

namespace axiometry::server {

struct TokenOptions {
  std::string token;  ///< secret of at least 16 characters; empty: none is asked for
  bool tls = false;   ///< then the cookie is __Host-… and goes over TLS only; so is one for a page that a proxy ends
                      ///< TLS for, as its origin says
  unsigned port = 0;  ///< part of the cookie's name, since cookies do not know ports
};

/// Who knows the token may use the API: by "Authorization: Bearer", or by the cookie that POST /api/login sets, which
/// holds a session of its own (sessions.h). Both are compared in a time that does not depend on where they differ. A
/// wrong token that was looked at is always answered late, the later the more came from that address, and while many of
/// an address wait none of its further ones is looked at, unless the right one came from there within the last hour:
/// many people may have one address, and who sends wrong ones slows nobody else. Sessions are never slowed. May be used
/// from many threads.
class TokenGate {
 public:
  using Clock = std::chrono::steady_clock;

  explicit TokenGate(TokenOptions options);

  bool wanted() const { return !options_.token.empty(); }
  /// Whether the request shows the token or a session, or none is wanted.
  bool knows(const Request& request, Clock::time_point now = Clock::now());
  /// Whose share of the server a request takes: that of its session, or of the address that shows the token or nothing.
  std::string peer_of(const Request& request, Clock::time_point now = Clock::now());
  /// 401 or 429 for a request to the API that does not show it; health and login are answered without, health not with
  /// a wrong one.
  std::optional<Response> refused(const Request& request, Clock::time_point now = Clock::now());

  /// POST /api/login {"token"}: 204 with the cookie, or 401.
  Result<Response> login(const Request& request, Clock::time_point now = Clock::now());
  /// POST /api/logout: ends this session and takes its cookies of both names away; other sessions go on.
  Response logout(const Request& request);

 private:
  struct Attempts {
    unsigned failures = 0;
    Clock::time_point last;
    Clock::time_point busy_until;  ///< when the last of the answers that are held back goes out
  };
  std::optional<std::string_view> session_of(const Request& request, Clock::time_point now);
  bool shows_a_session(const Request& request) const;  ///< whatever it is worth
  Response failed(const Request& request, Clock::time_point now);
  bool is_busy(const Request& request, Clock::time_point now);
  void showed_the_right_one(const Request& request, Clock::time_point now);
  std::string cookie(std::string_view value, bool tls, std::string_view more) const;

  TokenOptions options_;
  std::string cookie_name_;
  std::string cookie_name_of_tls_;
  Sessions sessions_;
  std::mutex mutex_;
  std::map<std::string, Attempts> attempts_;        ///< attempts by address
  std::map<std::string, Clock::time_point> right_;  ///< when an address showed the right token the last time
};

}  // namespace axiometry::server
