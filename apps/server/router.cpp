// SPDX-License-Identifier: Apache-2.0
#include "router.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>

namespace axiometry::server {
namespace {

constexpr std::size_t light_body_max = std::size_t{256} << 10;
constexpr std::string_view of_all_processors = "\"monte-carlo\"";  // as in the options of an evaluation

std::string method_of(const Request& request) { return request.method == "HEAD" ? "GET" : request.method; }

std::vector<std::string> segments_of(std::string_view path) {
  std::vector<std::string> segments;
  std::size_t from = 1;
  while (from <= path.size()) {
    const std::size_t to = std::min(path.find('/', from), path.size());
    segments.emplace_back(path.substr(from, to - from));
    from = to + 1;
  }
  return segments;
}

/// "report.{extension}" fits "report.pdf"; what stands in the brace, of at least one character, is captured.
bool fits(std::string_view pattern, std::string_view segment, Pairs& captured) {
  const std::size_t open = pattern.find('{');
  if (open == std::string_view::npos) return pattern == segment;
  const std::size_t close = pattern.find('}');
  const std::string_view before = pattern.substr(0, open);
  const std::string_view after = pattern.substr(close + 1);
  if (segment.size() <= before.size() + after.size() || !segment.starts_with(before) || !segment.ends_with(after))
    return false;
  captured.emplace_back(pattern.substr(open + 1, close - open - 1),
                        segment.substr(before.size(), segment.size() - before.size() - after.size()));
  return true;
}

std::optional<Pairs> captured_by(const std::vector<std::string>& pattern, const std::vector<std::string>& segments) {
  if (pattern.size() != segments.size()) return {};
  Pairs captured;
  for (std::size_t i = 0; i < pattern.size(); ++i)
    if (!fits(pattern[i], segments[i], captured)) return {};
  return captured;
}

Response answer_with(const Handler& handler, const Request& request) {
  try {
    auto response = handler(request);
    return response ? *std::move(response) : error_response(response.error(), request.language);
  } catch (const std::exception& exception) {
    fmt::print(stderr, "axiometry: {} {}: {}\n", request.method, request.path, exception.what());
    return refusal(500, "the program failed at this request; nothing was kept", request.language);
  }
}

}  // namespace

void Router::add(std::string_view method, std::string_view pattern, Handler handler, Weight weight) {
  entries_.push_back({std::string(method), std::string(pattern), segments_of(pattern), std::move(handler), weight});
}

Load Router::load_of(const Request& request) const {
  const std::string wanted = method_of(request);
  const auto segments = segments_of(request.path);
  const auto entry = std::ranges::find_if(
      entries_, [&](const Entry& e) { return e.method == wanted && captured_by(e.segments, segments).has_value(); });
  if (entry == entries_.end()) return Load::light;
  switch (entry->weight) {
    case Weight::light: return Load::light;
    case Weight::heavy: return Load::heavy;
    case Weight::by_size: return request.body.size() > light_body_max ? Load::heavy : Load::light;
    case Weight::by_method: return request.body.contains(of_all_processors) ? Load::lone : Load::heavy;
  }
  return Load::light;
}

Response Router::answer(Request request) const {
  const std::string wanted = method_of(request);
  const auto segments = segments_of(request.path);
  std::string allowed;
  for (const Entry& entry : entries_) {
    auto captured = captured_by(entry.segments, segments);
    if (!captured) continue;
    if (entry.method == wanted) {
      request.captured = *std::move(captured);
      return answer_with(entry.handler, request);
    }
    allowed += (allowed.empty() ? "" : ", ") + entry.method;
  }
  const bool is_api = !segments.empty() && segments.front() == "api";
  if (allowed.empty() && !is_api && otherwise_) {
    if (wanted == "GET") return answer_with(otherwise_, request);
    allowed = "GET";
  }
  if (allowed.empty()) return refusal(404, "there is nothing of this name", request.language);
  Response response = refusal(405, fmt::format("found {}, expected {}", request.method, allowed), request.language);
  response.headers.emplace_back("Allow", allowed);
  return response;
}

std::vector<Router::Route> Router::routes() const {
  std::vector<Route> routes;
  for (const Entry& entry : entries_) routes.push_back({entry.method, entry.pattern, entry.weight});
  return routes;
}

}  // namespace axiometry::server
