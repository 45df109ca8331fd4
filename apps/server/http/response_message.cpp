// SPDX-License-Identifier: Apache-2.0
#include "server/http/response_message.h"

#include <algorithm>
#include <string>
#include <string_view>

namespace axiometry::server {
namespace {

namespace http = boost::beast::http;

/// Nothing of ours holds line ends; what came from elsewhere must not begin a header of its own.
std::string header_value(std::string_view value) {
  std::string safe(value);
  std::ranges::replace_if(
      safe, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7F; }, ' ');
  return safe;
}

}  // namespace

ResponseMessage message_of(const Response& response, const MessageOptions& options) {
  ResponseMessage message;
  message.version(options.version);
  message.result(static_cast<unsigned>(response.status));
  for (const auto& [name, value] : response.headers) message.insert(name, header_value(value));
  const bool has_no_body = response.status == 204 || response.status == 304;
  if (!has_no_body) {
    const bool is_named = message.count(http::field::content_disposition) > 0;
    if (options.is_of_api && !is_named && response.content_type == "application/json")
      message.set(http::field::content_disposition, "attachment; filename=\"api.json\"");
    message.set(http::field::content_type, header_value(response.content_type));
    message.content_length(response.body.size());
    if (!options.head_only) message.body() = {response.body.data(), response.body.size()};
  }
  message.keep_alive(options.keeps_alive);
  return message;
}

}  // namespace axiometry::server
