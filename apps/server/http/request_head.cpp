// SPDX-License-Identifier: Apache-2.0
#include "server/http/request_head.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/beast/http/error.hpp>

#include "axiometry/app/files/given_text.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/store/own_names.h"
#include "server/http/target.h"
#include "server/limits.h"

namespace axiometry::server {
namespace {

namespace http = boost::beast::http;

/// What would mean something else to each reader if it stood twice.
constexpr std::array<std::string_view, 12> only_once = {
    "host",           "content-length",   "transfer-encoding", "content-type", "origin",        "authorization",
    "sec-fetch-site", "content-encoding", "x-file-name",       "x-actor",      "if-none-match", "accept-language"};

constexpr std::size_t actor_bytes_max = 200;

std::string_view view(boost::beast::string_view text) { return {text.data(), text.size()}; }

Result<Pairs> headers_of(const http::request_header<>& header) {
  Pairs headers;
  for (const auto& field : header) headers.emplace_back(text::to_lower(view(field.name_string())), view(field.value()));
  for (const std::string_view name : only_once)
    if (const auto count = std::ranges::count(headers, name, &std::pair<std::string, std::string>::first); count > 1)
      return fail(fmt::format("found {} headers {}, expected one", count, name));
  return headers;
}

language::Language language_of(const Request& request) {
  if (const auto tag = request.parameter("language"))
    if (const auto language = language::language_of(*tag)) return *language;
  return language::best_of(request.header("accept-language").value_or(""));
}

Result<std::string> actor_of(const Request& request) {
  const auto header = request.header("x-actor");
  if (!header) return std::string(store::nobody_named);
  AXIOMETRY_TRY(std::string actor, percent_decoded(*header));
  AXIOMETRY_TRY(actor, app::given_line("X-Actor", actor));
  if (std::ranges::find(store::own_names, text::to_lower(actor)) != store::own_names.end())
    return fail(fmt::format("found the name {} in X-Actor, by which the program calls itself, expected another",
                            text::quoted(actor)));
  if (actor.size() > actor_bytes_max)
    return fail(fmt::format("found a name of {} bytes in X-Actor, expected at most {}", actor.size(), actor_bytes_max));
  return actor.empty() ? std::string(store::nobody_named) : actor;
}

Result<Request> request_of(const http::request_header<>& header, std::string peer) {
  Request request{.method = std::string(view(header.method_string())),
                  .path = {},
                  .query = {},
                  .headers = {},
                  .body = {},
                  .actor = {},
                  .captured = {},
                  .peer = std::move(peer)};
  AXIOMETRY_TRY(Target target, parse_target(view(header.target())));
  request.path = std::move(target.path);
  request.query = std::move(target.query);
  AXIOMETRY_TRY(request.headers, headers_of(header));
  request.language = language_of(request);
  AXIOMETRY_TRY(request.actor, actor_of(request));
  return request;
}

std::unexpected<Response> refused(int status, const Request& request, std::string_view message) {
  return std::unexpected(refusal(status, message, request.language));
}

}  // namespace

std::expected<RequestHead, Response> read_head(const http::request_header<>& header, std::string peer) {
  if (header.version() != 10 && header.version() != 11)
    return std::unexpected(refusal(505, "found another version of HTTP, expected 1.0 or 1.1"));
  auto request = request_of(header, std::move(peer));
  if (!request) return std::unexpected(refusal(400, request.error().message));
  RequestHead head{.request = *std::move(request), .length = {}};
  if (const auto encoding = head.request.header("transfer-encoding")) {
    if (head.request.header("content-length") || header.version() == 10)
      return refused(400, head.request, "found Transfer-Encoding where it must not be, expected Content-Length");
    if (!text::equal_ignoring_case(*encoding, "chunked"))
      return refused(501, head.request,
                     fmt::format("found the transfer encoding {}, expected chunked", text::quoted(*encoding)));
  }
  if (const auto coding = head.request.header("content-encoding");
      coding && !text::equal_ignoring_case(text::trim(*coding), "identity")) {
    Response response = refusal(415, fmt::format("found the content encoding {}, expected none", text::quoted(*coding)),
                                head.request.language);
    response.headers.emplace_back("Accept-Encoding", "identity");
    return std::unexpected(std::move(response));
  }
  if (const auto length = head.request.header("content-length")) {
    head.length = parse_count(*length);
    if (!head.length)
      return refused(400, head.request,
                     fmt::format("found the Content-Length {}, expected a number", text::quoted(*length)));
  }
  if (const auto expectation = head.request.header("expect")) {
    if (!text::equal_ignoring_case(*expectation, "100-continue"))
      return refused(417, head.request,
                     fmt::format("found the expectation {}, expected 100-continue", text::quoted(*expectation)));
    head.expects_continue = header.version() == 11;
  }
  return head;
}

Response body_too_large(const Request& request, std::size_t most) {
  return with_event(
      refusal(413, fmt::format("found a body of more than {} bytes, expected less", most), request.language),
      SecurityEvent::quota_refused);
}

Response too_many_bodies(const Request& request) {
  constexpr std::string_view message = "found more uploads at once than the server has memory for, expected fewer";
  return with_event(busy(message, ask_again_soon, request.language), SecurityEvent::quota_refused);
}

Response refusal_of(const boost::beast::error_code& code) {
  if (code == http::error::header_limit || code == http::error::buffer_overflow)
    return with_event(refusal(431, "found a request head of more than 16 KiB, expected less"),
                      SecurityEvent::quota_refused);
  return refusal(400, fmt::format("found no sound HTTP request ({}), expected one", code.message()));
}

}  // namespace axiometry::server
