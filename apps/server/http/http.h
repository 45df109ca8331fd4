// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/language/language.h"
#include "server/access/security_event.h"

/// Requests and responses as the routes see them: whole, checked and decoded. The transport (connection.h) reads and
/// writes them; no route knows sockets, and the transport knows no route.
namespace axiometry::server {

using Pairs = std::vector<std::pair<std::string, std::string>>;

struct Request {
  std::string method;  ///< "GET"
  std::string path;    ///< decoded once, "/api/tests/12"; never the name of a file
  Pairs query;         ///< decoded
  Pairs headers;       ///< names in lower case
  std::string body;
  std::string actor;  ///< who asks, by the header X-Actor (percent-encoded UTF-8), "workbench" without
  language::Language language = language::Language::english;  ///< that of ?language=, else of Accept-Language
  Pairs captured;                                             ///< values of the route's path: {"id", "12"}
  std::string peer{};                                         ///< who asks, by the address (peer.h): "127.0.0.1"
  std::stop_token stop{};                                     ///< nobody waits for the answer any more

  std::optional<std::string_view> header(std::string_view name) const;
  std::optional<std::string_view> parameter(std::string_view name) const;  ///< value in the query
  std::string_view segment(std::string_view name) const;                   ///< contract: the route has it
};

/// A version of something in the archive.
struct Kept {
  std::optional<std::int64_t> id{};
  std::optional<int> version{};
};

struct Response {
  int status = 200;
  std::string content_type = "application/json";
  std::string body{};
  Pairs headers{};                            ///< a policy here only tightens the one of the page (security.h)
  std::chrono::milliseconds delay{0};         ///< held back that long, so that guessing is slow
  bool is_receipt = false;                    ///< may tell of what was kept: then at least receipt_of() is given
  Kept kept{};                                ///< what it tells of, so far as it is known
  SecurityEvent event = SecurityEvent::none;  ///< event that the log tells
};

/// Content-Security-Policy of a document that the program made and that is only looked at: a report, a figure. It runs
/// nothing and fetches nothing, but may hold its own styles and pictures.
inline constexpr std::string_view document_policy =
    "sandbox allow-same-origin allow-modals; default-src 'none'; style-src 'unsafe-inline'; img-src data:; "
    "font-src data:; base-uri 'none'; form-action 'none'; frame-ancestors 'self'";

Response json_response(const json::Value& value, int status = 200);

/// The same of what was kept, which a receipt in its place names too.
Response kept_response(const json::Value& value, const Kept& kept, int status = 200);

/// {"error": {"kind", "message", "file", "line", "column"}} with the status that fits the kind: bad_input 422,
/// not_found 404, conflict 409, read_only 403, full 507, unavailable 503, damaged 500. The message in the reader's
/// language.
Response error_response(const Error& error, language::Language language);

/// The same for what is wrong with the request itself: 400, 405, 413, 415, …
Response refusal(int status, std::string_view message, language::Language language = language::Language::english);

/// The same answer, which the log tells of.
Response with_event(Response response, SecurityEvent event);

/// 500 for a fault of the program at a request, which may have kept something before or not.
Response failure(bool may_have_kept, language::Language language);

/// 503 with Retry-After: whoever asks again then may be lucky.
Response busy(std::string_view message, std::chrono::seconds retry_after, language::Language language);

/// In place of what is too large to be given: {"kept": true, "id", "version", "message"} with the same status and
/// headers. Where id or version are not known they are null.
Response receipt_of(const Response& whole, language::Language language);

/// As a file to keep: Content-Disposition with a name that is safe everywhere (RFC 6266, RFC 8187).
Response download(std::string body, std::string_view content_type, std::string_view file_name);

/// The body as a JSON object. Fails, with line and column, also on more than 8 MiB or a million values: no plan and no
/// edit has as many.
Result<json::Value> json_body(const Request& request);

}  // namespace axiometry::server
