// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/http/http.h"
#include "server/routing/query_names.h"
#include "server/work/job.h"
#include "server/work/load.h"

namespace axiometry::server {

/// May be called from many threads at once, and may take its time. Where that is long it looks at Request::stop.
using Handler = std::function<Result<Response>(const Request&)>;

/// A request that was read: what it costs by its values, and what answers it.
struct ReadRequest {
  Load load = Load::light;
  std::string key{};  ///< as Job::key
  Handler answer;     ///< given the same request
};
/// Reads a request, which is all that it should cost.
using RouteReader = std::function<Result<ReadRequest>(const Request&)>;

/// How the load of a request is known.
enum class Weight {
  light,
  edit,
  heavy,
  by_size,   ///< heavy with a body of more than 64 kB
  by_value,  ///< as its RouteReader says
};

/// What the body of a request is.
enum class Sent {
  json,   ///< application/json in UTF-8, if there is any
  files,  ///< bytes of whatever type they say, or a form with files
};

/// What holds for every request of a route, and is known with its head.
struct Terms {
  Sent sent = Sent::json;
  bool only_looks = false;                                         ///< keeps nothing though it is a POST
  std::size_t body_max = std::numeric_limits<std::size_t>::max();  ///< bytes; where less than anybody may send
};

/// Which handler answers which request. Patterns are literal but for whole segments in braces: "/api/tests/{id}", and
/// "/api/tests/{id}/report.{extension}", where the brace takes the rest of a segment.
class Router {
 public:
  void add(std::string_view method, std::string_view pattern, Handler handler, Weight weight = Weight::light,
           const Terms& terms = {});
  void add_read(std::string_view method, std::string_view pattern, RouteReader reader, const Terms& terms = {});

  /// What answers GET and HEAD of a path that no pattern fits and that is not below "/api".
  void add_otherwise(Handler handler) { otherwise_ = std::move(handler); }

  /// 422 from now on for a query with another name than these, `language`, which every answer has, and those by which a
  /// file that is sent may be named (sent_name()), with one name twice, or with another word than those of its name; of
  /// routes that are described.
  void expect(const QueryNames& names);

  /// In which queue a request with its body waits to be read: light where there is no route for it, and of a route by
  /// value unless the body has more than 64 kB.
  Load queue_of(const Request& request) const;

  /// Whether a request may keep something: not where there is no route for it.
  bool keeps(const Request& request) const;

  /// 415 for a body of another type than its route takes, or of none; by the head alone.
  std::optional<Response> refused(const Request& head) const;

  /// Bytes that its body may have by the terms of its route.
  std::size_t body_max(const Request& request) const;

  /// What it costs and what answers it: the handler's response, or its error as a response; 404 for an unknown path,
  /// 405 with Allow for a known path with another method. HEAD is answered as GET without its body. Exceptions do not
  /// pass, memory that is not there among them: 500, logged.
  Job read(std::shared_ptr<Request> request) const;

  /// Both at once.
  Response answer(Request request) const;

  struct Route {
    std::string method;
    std::string pattern;
    Weight weight = Weight::light;
  };
  std::vector<Route> routes() const;  ///< routes in the order in which they were added

 private:
  struct Entry {
    std::string method;
    std::string pattern;
    std::vector<std::string> segments;
    RouteReader reader;
    Weight weight = Weight::light;
    Terms terms{};
    std::optional<std::vector<QueryName>> query_names{};  ///< what its query may have
  };
  static bool may_keep(const Entry& entry);
  static std::optional<Response> refused_query(const Entry& entry, const Request& request);
  const Entry* entry_of(const Request& request) const;
  Job find_and_read(const std::shared_ptr<Request>& request) const;

  std::vector<Entry> entries_;
  Handler otherwise_;
};

}  // namespace axiometry::server
