// SPDX-License-Identifier: Apache-2.0
#include "server/routing/router.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <optional>
#include <ranges>
#include <stop_token>

#include "axiometry/base/text/text.h"
#include "axiometry/language/language.h"
#include "server/log.h"

namespace axiometry::server {
namespace {

constexpr std::size_t light_body_max = std::size_t{64} << 10;

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

/// What `work` gives; of whatever it throws a fault of the program alone, and of this request alone.
template <typename Work>
auto guarded(const Request& request, bool keeps, const Work& work,
             const std::function<decltype(work())(Response)>& failed) -> decltype(work()) {
  std::string what = "an exception of no known kind";
  try {
    return work();
  } catch (const std::exception& exception) {
    what = exception.what();
  } catch (...) {  // NOLINT(bugprone-empty-catch): told below
  }
  log_line(fmt::format("axiometry: {} {}: {}", log_text(request.method), log_text(request.path), what));
  return failed(failure(keeps, request.language));
}

Response answered(const Handler& handler, const Request& request, bool keeps) {
  const auto answer = [&] {
    auto response = handler(request);
    return response ? *std::move(response) : error_response(response.error(), request.language);
  };
  return guarded(request, keeps, answer, [](Response failed) { return failed; });
}

Job job_of(const std::shared_ptr<Request>& request, ReadRequest reading, bool keeps = false) {
  return {.load = reading.load,
          .key = std::move(reading.key),
          .answer = [request, keeps, handler = std::move(reading.answer)](const std::stop_token& stop) {
            request->stop = stop;
            return answered(handler, *request, keeps);
          }};
}

Job ready(Response response) {
  return {.answer = [response = std::move(response)](const std::stop_token&) { return response; }};
}

bool has_body(const Request& head) {
  return head.header("transfer-encoding") || head.header("content-length").value_or("0") != "0";
}

/// "application/json", also "; charset=utf-8".
bool is_json(std::string_view type) {
  const std::size_t end = type.find(';');
  if (!text::equal_ignoring_case(text::trim(type.substr(0, end)), "application/json")) return false;
  if (end == std::string_view::npos) return true;
  const std::string_view more = text::trim(type.substr(end + 1));
  return text::equal_ignoring_case(more, "charset=utf-8") || text::equal_ignoring_case(more, "charset=\"utf-8\"");
}

Load load_by_size(const Request& request) { return request.body.size() > light_body_max ? Load::heavy : Load::light; }

/// Of a route that needs no reading.
RouteReader without_reading(Handler handler, Weight weight) {
  return [handler = std::move(handler), weight](const Request& request) -> Result<ReadRequest> {
    ReadRequest reading{.answer = handler};
    if (weight == Weight::edit) reading.load = Load::edit;
    if (weight == Weight::heavy) reading.load = Load::heavy;
    if (weight == Weight::by_size) reading.load = load_by_size(request);
    return reading;
  };
}

}  // namespace

void Router::add(std::string_view method, std::string_view pattern, Handler handler, Weight weight,
                 const Terms& terms) {
  entries_.push_back({std::string(method), std::string(pattern), segments_of(pattern),
                      without_reading(std::move(handler), weight), weight, terms});
}

void Router::add_read(std::string_view method, std::string_view pattern, RouteReader reader, const Terms& terms) {
  entries_.push_back(
      {std::string(method), std::string(pattern), segments_of(pattern), std::move(reader), Weight::by_value, terms});
}

void Router::expect(const QueryNames& names) {
  for (Entry& entry : entries_)
    if (const auto* query = names.of(entry.method, entry.pattern)) entry.query_names = *query;
}

std::optional<Response> Router::refused_query(const Entry& entry, const Request& request) {
  if (!entry.query_names) return {};
  const auto refused = [&](const std::string& message) { return refusal(422, message, request.language); };
  const auto& names = *entry.query_names;
  const auto is_file_name = [&](const std::string& name) {
    return entry.terms.sent == Sent::files && (name == "name" || name == "filename");
  };
  for (const auto& [name, value] : request.query) {
    const std::string found = text::quoted(name);
    if (std::ranges::count(request.query, name, [](const auto& pair) { return pair.first; }) > 1)
      return refused(fmt::format("found the query parameter {} more than once, expected it once", found));
    if (name == "language")
      if (const auto language = language::chosen_language(value); !language) return refused(language.error().message);
    if (name == "language" || is_file_name(name)) continue;
    const auto known = std::ranges::find(names, name, &QueryName::name);
    if (known == names.end())
      return refused(names.empty() ? fmt::format("found the query parameter {}, expected none", found)
                                   : fmt::format("found the query parameter {}, expected one of {}", found,
                                                 fmt::join(names | std::views::transform(&QueryName::name), ", ")));
    if (!value.empty() && !known->words.empty() && std::ranges::find(known->words, value) == known->words.end())
      return refused(
          fmt::format("found {}={}, expected one of {}", name, text::quoted(value), fmt::join(known->words, ", ")));
  }
  return {};
}

bool Router::may_keep(const Entry& entry) { return entry.method != "GET" && !entry.terms.only_looks; }

const Router::Entry* Router::entry_of(const Request& request) const {
  const std::string wanted = method_of(request);
  const auto segments = segments_of(request.path);
  const auto entry = std::ranges::find_if(
      entries_, [&](const Entry& e) { return e.method == wanted && captured_by(e.segments, segments).has_value(); });
  return entry == entries_.end() ? nullptr : &*entry;
}

bool Router::keeps(const Request& request) const {
  const Entry* entry = entry_of(request);
  return entry != nullptr && may_keep(*entry);
}

std::optional<Response> Router::refused(const Request& head) const {
  const Entry* entry = entry_of(head);
  if (entry == nullptr || entry->terms.sent != Sent::json || !has_body(head)) return {};
  const auto type = head.header("content-type");
  if (type && is_json(*type)) return {};
  Response response = refusal(415,
                              fmt::format("found a body of the type {}, expected application/json",
                                          type ? text::quoted(*type) : std::string("none")),
                              head.language);
  response.headers.emplace_back("Accept", "application/json");
  return response;
}

std::size_t Router::body_max(const Request& request) const {
  const Entry* entry = entry_of(request);
  return entry == nullptr ? Terms{}.body_max : entry->terms.body_max;
}

Load Router::queue_of(const Request& request) const {
  const Entry* entry = entry_of(request);
  if (entry == nullptr) return Load::light;
  if (entry->weight == Weight::heavy) return Load::heavy;
  const Load by_size = load_by_size(request);
  if (entry->weight == Weight::edit && by_size == Load::light) return Load::edit;
  return by_size;
}

Job Router::find_and_read(const std::shared_ptr<Request>& request) const {
  const std::string wanted = method_of(*request);
  const auto segments = segments_of(request->path);
  std::string allowed;
  for (const Entry& entry : entries_) {
    auto captured = captured_by(entry.segments, segments);
    if (!captured) continue;
    if (entry.method == wanted) {
      if (auto refused = refused_query(entry, *request)) return ready(*std::move(refused));
      request->captured = *std::move(captured);
      auto reading = entry.reader(*request);
      return reading ? job_of(request, *std::move(reading), may_keep(entry))
                     : ready(error_response(reading.error(), request->language));
    }
    allowed += (allowed.empty() ? "" : ", ") + entry.method;
  }
  const bool is_api = !segments.empty() && segments.front() == "api";
  if (allowed.empty() && !is_api && otherwise_) {
    if (wanted == "GET") return job_of(request, {.answer = otherwise_});
    allowed = "GET";
  }
  if (allowed.empty()) return ready(refusal(404, "there is nothing of this name", request->language));
  Response response = refusal(405, fmt::format("found {}, expected {}", request->method, allowed), request->language);
  response.headers.emplace_back("Allow", allowed);
  return ready(std::move(response));
}

Job Router::read(std::shared_ptr<Request> request) const {
  return guarded(
      *request, false, [&] { return find_and_read(request); }, ready);
}

Response Router::answer(Request request) const {
  const std::stop_token stop = request.stop;
  return read(std::make_shared<Request>(std::move(request))).answer(stop);
}

std::vector<Router::Route> Router::routes() const {
  std::vector<Route> routes;
  for (const Entry& entry : entries_) routes.push_back({entry.method, entry.pattern, entry.weight});
  return routes;
}

}  // namespace axiometry::server
