// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "http.h"
#include "load.h"

namespace axiometry::server {

/// May be called from many threads at once, and may take its time.
using Handler = std::function<Result<Response>(const Request&)>;

/// How the load of a request is known.
enum class Weight {
  light,
  heavy,
  by_size,    ///< heavy with a body of more than 256 kB
  by_method,  ///< heavy; lone with a body that names the Monte Carlo method
};

/// Which handler answers which request. Patterns are literal but for whole segments in braces: "/api/tests/{id}", and
/// "/api/tests/{id}/report.{extension}", where the brace takes the rest of a segment.
class Router {
 public:
  void add(std::string_view method, std::string_view pattern, Handler handler, Weight weight = Weight::light);

  /// What answers GET and HEAD of a path that no pattern fits and that is not below "/api".
  void add_otherwise(Handler handler) { otherwise_ = std::move(handler); }

  /// The handler's response, or its error as a response; 404 for an unknown path, 405 with Allow for a known path with
  /// another method. HEAD is answered as GET without its body. Exceptions do not pass: 500, logged.
  Response answer(Request request) const;

  /// By its route, of a request with its body; light where there is none.
  Load load_of(const Request& request) const;

  struct Route {
    std::string method;
    std::string pattern;
    Weight weight = Weight::light;
  };
  std::vector<Route> routes() const;  ///< in the order in which they were added

 private:
  struct Entry {
    std::string method;
    std::string pattern;
    std::vector<std::string> segments;
    Handler handler;
    Weight weight = Weight::light;
  };
  std::vector<Entry> entries_;
  Handler otherwise_;
};

}  // namespace axiometry::server
