// SPDX-License-Identifier: Apache-2.0
#include "server/http/http.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "axiometry/base/contract.h"

namespace axiometry::server {
namespace {

std::optional<std::string_view> find(const Pairs& pairs, std::string_view name) {
  const auto found = std::ranges::find(pairs, name, &std::pair<std::string, std::string>::first);
  if (found == pairs.end()) return {};
  return found->second;
}

struct KindRow {
  ErrorKind kind;
  std::string_view name;
  int status;
};
constexpr std::array kinds = {
    KindRow{ErrorKind::bad_input, "bad_input", 422}, KindRow{ErrorKind::not_found, "not_found", 404},
    KindRow{ErrorKind::conflict, "conflict", 409},   KindRow{ErrorKind::read_only, "read_only", 403},
    KindRow{ErrorKind::full, "full", 507},           KindRow{ErrorKind::unavailable, "unavailable", 503},
    KindRow{ErrorKind::damaged, "damaged", 500},
};

json::Value count_or_null(std::size_t count) { return count == 0 ? json::Value() : json::Value(count); }

/// RFC 8187: everything but letters, digits and a few signs as %XX.
std::string percent_encoded(std::string_view text) {
  std::string encoded;
  for (const char c : text) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("!#$&+-.^_`|~").contains(c);
    if (plain)
      encoded += c;
    else
      encoded += fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return encoded;
}

}  // namespace

std::optional<std::string_view> Request::header(std::string_view name) const { return find(headers, name); }

std::optional<std::string_view> Request::parameter(std::string_view name) const { return find(query, name); }

std::string_view Request::segment(std::string_view name) const {
  const auto found = find(captured, name);
  AXIOMETRY_CONTRACT(found.has_value());
  return *found;
}

Response json_response(const json::Value& value, int status) {
  return {.status = status, .body = json::dump(value, 0), .headers = {{"Cache-Control", "no-store"}}};
}

Response kept_response(const json::Value& value, const Kept& kept, int status) {
  Response response = json_response(value, status);
  response.kept = kept;
  return response;
}

Response error_response(const Error& error, language::Language language) {
  const auto row = std::ranges::find(kinds, error.kind, &KindRow::kind);
  AXIOMETRY_CONTRACT(row != kinds.end());
  json::Value inner = json::Value::object();
  inner.add("kind", row->name);
  inner.add("message", language::translated(error.message, language));
  inner.add("file", error.file.empty() ? json::Value() : json::Value(error.file));
  inner.add("line", count_or_null(error.at.line));
  inner.add("column", count_or_null(error.at.column));
  json::Value value = json::Value::object();
  value.add("error", std::move(inner));
  return json_response(value, row->status);
}

Response refusal(int status, std::string_view message, language::Language language) {
  json::Value inner = json::Value::object();
  inner.add("kind", status == 404   ? "not_found"
                    : status == 422 ? "bad_input"
                    : status == 503 ? "unavailable"
                                    : "refused");
  inner.add("message", language::translated(message, language));
  for (const char* place : {"file", "line", "column"}) inner.add(place, {});
  json::Value value = json::Value::object();
  value.add("error", std::move(inner));
  return json_response(value, status);
}

Response with_event(Response response, SecurityEvent event) {
  response.event = event;
  return response;
}

Response failure(bool may_have_kept, language::Language language) {
  return refusal(500,
                 may_have_kept ? "the program failed at this request; whether anything was kept is not known: look "
                                 "before it is sent again"
                               : "the program failed at this request; nothing was kept",
                 language);
}

Response busy(std::string_view message, std::chrono::seconds retry_after, language::Language language) {
  Response response = refusal(503, message, language);
  response.headers.emplace_back("Retry-After", fmt::format("{}", retry_after.count()));
  return response;
}

Response receipt_of(const Response& whole, language::Language language) {
  constexpr std::string_view message = "it was kept, but the server has no memory left to show it: read it again";
  json::Value value = json::Value::object();
  value.add("kept", true);
  value.add("id", whole.kept.id ? json::Value(static_cast<double>(*whole.kept.id)) : json::Value());
  value.add("version", whole.kept.version ? json::Value(*whole.kept.version) : json::Value());
  value.add("message", language::translated(message, language));
  return {.status = whole.status,
          .body = json::dump(value, 0),
          .headers = whole.headers,
          .is_receipt = true,
          .kept = whole.kept};
}

Response download(std::string body, std::string_view content_type, std::string_view file_name) {
  std::string safe(file_name);
  std::ranges::replace_if(
      safe, [](char c) { return (c >= 0 && c < ' ') || c == 0x7F || std::string_view("<>:\"/\\|?*").contains(c); },
      '_');
  std::string plain = safe;
  std::ranges::replace_if(
      plain, [](char c) { return static_cast<unsigned char>(c) > 0x7E; }, '_');
  return {.content_type = std::string(content_type),
          .body = std::move(body),
          .headers = {{"Content-Disposition",
                       fmt::format("attachment; filename=\"{}\"; filename*=UTF-8''{}", plain, percent_encoded(safe))},
                      {"Cache-Control", "no-store"}}};
}

Result<json::Value> json_body(const Request& request) {
  constexpr json::ParseLimits limits{.bytes = std::size_t{8} << 20, .depth = 64, .values = 1'000'000};
  AXIOMETRY_TRY(json::Value value, json::parse(request.body, limits));
  if (!value.is(json::Kind::object))
    return fail(fmt::format("found {}, expected an object", json::kind_name(value.kind())), value.at());
  return value;
}

}  // namespace axiometry::server
