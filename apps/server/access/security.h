// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "server/http/http.h"

namespace axiometry::server {

/// What every response carries, the letters of XML among it, so that a browser runs nothing but the page's own program,
/// and shows none of it to others. A route's own Content-Security-Policy replaces the page's where it is that of a
/// sandbox without programs (document_policy); any other comes beside it, and browsers obey both.
void add_security_headers(Response& response, bool tls);

}  // namespace axiometry::server
