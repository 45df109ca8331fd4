// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/http/http.h"

/// Whom the server answers. A page of somebody else in the same browser can send requests here, and can have its own
/// name lead to this machine; neither may read or change anything.
namespace axiometry::server {

/// Where a proxy that ends TLS offers this server to browsers.
struct PublicAddress {
  std::string origin;              ///< as browsers say it: "https://calibration.example", "https://door.example:8443"
  std::vector<std::string> hosts;  ///< as in the header Host: "calibration.example", "calibration.example:443"
  bool is_local = false;           ///< leads to the user's own computer: "http://localhost:9000", a tunnel
};

/// Reads "https://NAME" or "https://NAME:PORT". Fails on anything else: a path, a user, a wildcard, and http unless the
/// name is localhost, 127.0.0.1 or [::1].
Result<PublicAddress> parse_public_address(std::string_view text);

/// By which names this server is reached.
struct Site {
  std::string scheme;              ///< "http" or "https"
  std::vector<std::string> hosts;  ///< as in the header Host, in lower case: "localhost:8230"
  std::vector<PublicAddress> public_addresses{};
};

struct SiteOptions {
  bool tls = false;
  std::string listen{};              ///< address: "127.0.0.1", "::1", "0.0.0.0"
  unsigned port = 0;                 ///< port that is listened to
  std::vector<std::string> names{};  ///< more, each with or without a port
  std::vector<PublicAddress> public_addresses{};
};

/// 127.0.0.1, localhost, [::1], the address that is listened to unless that means all of them, and the names given,
/// with the port; also without it where it is that of the scheme.
Site make_site(const SiteOptions& options);

/// 405 for a method that is none of ours, 421 for a foreign Host, 403 for what another page has the browser ask: any
/// method but GET and HEAD with a foreign Origin or a Sec-Fetch-Site other than same-origin and none, and of the API
/// also what another page embeds. Nothing when the request is one of ours. A public address counts by its own origin
/// alone, whether or not the proxy hands on its name as Host; what else a proxy says in headers counts nothing.
std::optional<Response> refused_by_guard(const Request& request, const Site& site);

}  // namespace axiometry::server
