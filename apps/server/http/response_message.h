// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/beast/http/message.hpp>
#include <boost/beast/http/span_body.hpp>

#include "server/http/http.h"

namespace axiometry::server {

/// Its body is that of a Response, which must outlive it.
using ResponseMessage = boost::beast::http::response<boost::beast::http::span_body<const char>>;

struct MessageOptions {
  unsigned version = 11;  ///< version of HTTP: 10 or 11
  bool head_only = false;
  bool keeps_alive = false;
  bool is_of_api = false;  ///< the answer to a path below "/api/"
};

/// As it goes out; what is no character of a header field becomes a blank. JSON of the API that says nothing else is
/// the file api.json: no browser shows it, or keeps it by a name that its address chose.
ResponseMessage message_of(const Response& response, const MessageOptions& options);

}  // namespace axiometry::server
