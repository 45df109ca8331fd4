// SPDX-License-Identifier: Apache-2.0
// Signing in and out.
#include "server/routes/routes.h"

namespace axiometry::server {
namespace {

constexpr std::size_t login_bytes_max = 4096;  // of JSON with a token of 512, each byte of which may be spelt \u00XX

}  // namespace

void add_session_routes(Router& router, TokenGate& token) {
  router.add("POST", "/api/login", [&token](const Request& request) { return token.login(request); }, Weight::light,
             {.body_max = login_bytes_max});
  router.add("POST", "/api/logout",
             [&token](const Request& request) -> Result<Response> { return token.logout(request); });
}

}  // namespace axiometry::server
