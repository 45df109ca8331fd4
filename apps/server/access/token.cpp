// SPDX-License-Identifier: Apache-2.0
#include "server/access/token.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"

namespace axiometry::server {
namespace {

using namespace std::chrono_literals;

constexpr auto first_delay = 500ms;
constexpr auto longest_delay = 8s;
constexpr auto forgotten_after = 5min;
constexpr auto trusted_for = 1h;
constexpr std::size_t addresses_max = 4096;

/// Of the hashes, so that neither length nor content shows in the time.
bool same_secret(std::string_view a, std::string_view b) {
  const std::string first = sha256(a);
  const std::string second = sha256(b);
  unsigned difference = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    difference |= static_cast<unsigned char>(first[i]) ^ static_cast<unsigned char>(second[i]);
  return difference == 0;
}

std::optional<std::string_view> bearer(const Request& request) {
  const auto header = request.header("authorization");
  if (!header || header->size() < 7 || !text::equal_ignoring_case(header->substr(0, 7), "bearer ")) return {};
  return text::trim(header->substr(7));
}

/// Whether it is answered to those alone who show the token or a session. Health says more to who shows the token, and
/// a wrong one is a wrong one there too; what login looks at is its body.
bool is_asked_for(const Request& request) {
  const bool is_api = request.path == "/api" || request.path.starts_with("/api/");
  if (request.path == "/api/health") return bearer(request).has_value();
  return is_api && request.path != "/api/login";
}

bool came_over_tls_from_a_proxy(const Request& request) {
  return request.header("origin").value_or("").starts_with("https://");
}

std::optional<std::string_view> cookie_of(const Request& request, std::string_view name) {
  for (const auto& [header, value] : request.headers) {
    if (header != "cookie") continue;
    for (const std::string_view part : text::split(value, ';')) {
      const std::string_view pair = text::trim(part);
      if (pair.size() > name.size() && pair.starts_with(name) && pair[name.size()] == '=')
        return pair.substr(name.size() + 1);
    }
  }
  return {};
}

Response too_many(const Request& request, std::chrono::milliseconds delay = {}) {
  Response response = refusal(429, "found too many wrong tokens from this address, expected a pause", request.language);
  response.headers.emplace_back("Retry-After", "10");
  response.delay = delay;
  return with_event(std::move(response), SecurityEvent::token_refused);
}

constexpr std::string_view wrong_token = "found a wrong token, expected the one that the server was started with";

Response unauthorised(const Request& request, std::string_view message, std::chrono::milliseconds delay = {}) {
  Response response = refusal(401, message, request.language);
  response.headers.emplace_back("WWW-Authenticate", "Bearer realm=\"Axiometry\"");
  response.delay = delay;
  return with_event(std::move(response), SecurityEvent::token_refused);
}

}  // namespace

TokenGate::TokenGate(TokenOptions options)
    : options_(std::move(options)),
      cookie_name_(fmt::format("axiometry-{}", options_.port)),
      cookie_name_of_tls_("__Host-" + cookie_name_) {}

bool TokenGate::knows(const Request& request, Clock::time_point now) {
  if (!wanted()) return true;
  if (const auto shown = bearer(request)) {
    if (!same_secret(*shown, options_.token)) return false;
    showed_the_right_one(request, now);
    return true;
  }
  return session_of(request, now).has_value();
}

std::optional<std::string_view> TokenGate::session_of(const Request& request, Clock::time_point now) {
  for (const std::string_view name : {std::string_view(cookie_name_of_tls_), std::string_view(cookie_name_)}) {
    if (options_.tls && name == cookie_name_) continue;
    const auto shown = cookie_of(request, name);
    if (shown && sessions_.knows(*shown, now)) return shown;
  }
  return {};
}

bool TokenGate::shows_a_session(const Request& request) const {
  return cookie_of(request, cookie_name_of_tls_) || cookie_of(request, cookie_name_);
}

std::string TokenGate::peer_of(const Request& request, Clock::time_point now) {
  if (!wanted()) return request.peer;
  if (const auto shown = bearer(request); shown && is_asked_for(request))
    return same_secret(*shown, options_.token) ? request.peer + " with the token" : request.peer;
  const auto session = session_of(request, now);
  return session ? sha256(*session) : request.peer;
}

std::optional<Response> TokenGate::refused(const Request& request, Clock::time_point now) {
  if (!wanted() || !is_asked_for(request)) return {};
  const auto shown = bearer(request);
  if (shown && is_busy(request, now)) return too_many(request);
  if (knows(request, now)) return {};
  if (shown) return failed(request, now);
  return with_event(unauthorised(request, "found no token, expected one: sign in first"),
                    shows_a_session(request) ? SecurityEvent::session_refused : SecurityEvent::token_missing);
}

Result<Response> TokenGate::login(const Request& request, Clock::time_point now) {
  AXIOMETRY_TRY(const json::Value body, json_body(request));
  const json::Value* token = body.find("token");
  if (token == nullptr || !token->is(json::Kind::text)) return fail("found no \"token\", expected a text");
  if (!wanted()) return Response{.status = 204};
  if (is_busy(request, now)) return with_event(too_many(request), SecurityEvent::sign_in_refused);
  if (!same_secret(token->text(), options_.token))
    return with_event(failed(request, now), SecurityEvent::sign_in_refused);
  showed_the_right_one(request, now);
  const bool tls = options_.tls || came_over_tls_from_a_proxy(request);
  const auto [session, ends_another] = sessions_.begin(now);
  return Response{.status = 204,
                  .headers = {{"Set-Cookie", cookie(session, tls, "; Max-Age=2592000")}},
                  .event = ends_another ? SecurityEvent::signed_in_ending_another : SecurityEvent::signed_in};
}

Response TokenGate::logout(const Request& request) {
  Response response{.status = 204};
  for (const std::string_view name : {std::string_view(cookie_name_of_tls_), std::string_view(cookie_name_)})
    if (const auto shown = cookie_of(request, name); shown && sessions_.end(*shown))
      response.event = SecurityEvent::signed_out;
  for (const bool tls : {true, false}) response.headers.emplace_back("Set-Cookie", cookie("", tls, "; Max-Age=0"));
  return response;
}

std::string TokenGate::cookie(std::string_view value, bool tls, std::string_view more) const {
  return fmt::format("{}={}; Path=/; HttpOnly; SameSite=Strict{}{}", tls ? cookie_name_of_tls_ : cookie_name_, value,
                     tls ? "; Secure" : "", more);
}

bool TokenGate::is_busy(const Request& request, Clock::time_point now) {
  const std::scoped_lock lock(mutex_);
  if (const auto right = right_.find(request.peer); right != right_.end() && now - right->second < trusted_for)
    return false;
  const auto found = attempts_.find(request.peer);
  return found != attempts_.end() && found->second.busy_until > now + 2 * longest_delay;
}

void TokenGate::showed_the_right_one(const Request& request, Clock::time_point now) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(right_, [&](const auto& entry) { return now - entry.second >= trusted_for; });
  if (right_.size() < addresses_max || right_.contains(request.peer)) right_[request.peer] = now;
}

Response TokenGate::failed(const Request& request, Clock::time_point now) {
  const std::scoped_lock lock(mutex_);
  std::erase_if(attempts_, [&](const auto& entry) { return now - entry.second.last > forgotten_after; });
  if (attempts_.size() >= addresses_max && !attempts_.contains(request.peer))
    return unauthorised(request, wrong_token, longest_delay);
  Attempts& attempts = attempts_[request.peer];
  if (attempts.busy_until > now + 2 * longest_delay) return too_many(request, longest_delay);
  const std::chrono::milliseconds own =
      std::min<std::chrono::milliseconds>(first_delay * (1U << std::min(attempts.failures, 4U)), longest_delay);
  ++attempts.failures;
  attempts.last = now;
  attempts.busy_until = std::max(attempts.busy_until, now) + own;
  return unauthorised(request, wrong_token,
                      std::chrono::duration_cast<std::chrono::milliseconds>(attempts.busy_until - now));
}

}  // namespace axiometry::server
