// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

#include "server/routing/router.h"

namespace axiometry::server {

/// Adds routes of which every handler takes the same thing first: the archive, the workbench, the captures, which must
/// outlive the router. To be called with method, pattern, handler and, as Router::add() has them, weight and terms.
template <typename Subject>
auto adder(Router& router, Subject& subject) {
  return [&router, &subject](std::string_view method, std::string_view pattern, auto handler,
                             Weight weight = Weight::light, const Terms& terms = {}) {
    router.add(
        method, pattern, [&subject, handler](const Request& request) { return handler(subject, request); }, weight,
        terms);
  };
}

}  // namespace axiometry::server
