// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "server/http/http.h"

namespace axiometry::server {

/// What a request asks for, decoded.
struct Target {
  std::string path;  ///< "/api/tests/12"
  Pairs query;       ///< pairs in order; "+" is a blank
};

/// Fails on anything but the path form ("/…", RFC 9112, 3.2.1), on malformed percent-encoding, on what is not UTF-8, on
/// control characters and backslashes, on an encoded slash, and on the segments "", "." and "..", since no path of ours
/// has them; only the last segment may be empty.
Result<Target> parse_target(std::string_view raw);

/// %XX decoded. Fails on what is no percent-encoding, not UTF-8, or has control characters.
Result<std::string> percent_decoded(std::string_view text);

}  // namespace axiometry::server
