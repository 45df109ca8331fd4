// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/beast/http/fields.hpp>
#include <boost/beast/http/message.hpp>
#include <cstddef>
#include <cstdint>
#include <expected>
#include <optional>
#include <string>

#include "server/http/http.h"

namespace axiometry::server {

/// What the head of a request says beside the Request: how its body comes.
struct RequestHead {
  Request request;
  std::optional<std::uint64_t> length;  ///< Content-Length
  bool expects_continue = false;
};

/// A request of which only the head has come; or the refusal: 400 for a target that is none, for fields that must be
/// there once and are not, for two lengths; 415, 417, 501 and 505 for what is not done here.
std::expected<RequestHead, Response> read_head(const boost::beast::http::request_header<>& header, std::string peer);

/// 413 and 503: of a body that is larger than it may be, or for which there is no memory beside others.
Response body_too_large(const Request& request, std::size_t most);
Response too_many_bodies(const Request& request);

/// Of what the parser found wrong: 431 for what is too long, else 400.
Response refusal_of(const boost::beast::error_code& code);

}  // namespace axiometry::server
