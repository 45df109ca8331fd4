// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include "http.h"

namespace axiometry::server {

struct TokenOptions {
  std::string token;  ///< at least 16 characters; empty: none is asked for
  bool tls = false;   ///< then the cookie goes over TLS only; so does one for a page that came over TLS from a proxy
  unsigned port = 0;  ///< part of the cookie's name, since cookies do not know ports
};

/// Who knows the token may use the API: by "Authorization: Bearer", or by the cookie that POST /api/login sets. Both
/// are compared in a time that does not depend on where they differ. A wrong one is answered late, the later the more
/// came from that address, and while many of an address wait none of its further ones is looked at. May be used from
/// many threads.
class TokenGate {
 public:
  using Clock = std::chrono::steady_clock;

  explicit TokenGate(TokenOptions options);

  bool wanted() const { return !options_.token.empty(); }
  /// Whether the request shows the token, or none is wanted.
  bool knows(const Request& request) const;
  /// 401 or 429 for a request to the API that does not show it; health and login are answered without.
  std::optional<Response> refused(const Request& request, Clock::time_point now = Clock::now());

  /// POST /api/login {"token"}: 204 with the cookie, or 401.
  Result<Response> login(const Request& request, Clock::time_point now = Clock::now());
  /// POST /api/logout: takes the cookie away.
  Response logout() const;

 private:
  struct Attempts {
    unsigned failures = 0;
    Clock::time_point last;
    Clock::time_point busy_until;  ///< when the last of the answers that are held back goes out
  };
  Response failed(const Request& request, Clock::time_point now);
  bool is_busy(const Request& request, Clock::time_point now);
  std::string cookie(std::string_view value, bool tls, std::string_view more) const;

  TokenOptions options_;
  std::string session_;  ///< what the cookie holds: says that its owner knew the token, without saying the token
  std::string cookie_name_;
  std::mutex mutex_;
  std::map<std::string, Attempts> attempts_;  ///< by address
};

}  // namespace axiometry::server
