// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <stop_token>
#include <string>

#include "server/http/http.h"
#include "server/work/load.h"

namespace axiometry::server {

/// What a request turned out to be once it was read: what it costs follows from its values, not from its bytes.
struct Job {
  Load load = Load::light;
  /// Of requests that ask for one and the same, so that it is made once for all who ask while it is made: the route,
  /// its options and the state of the archive. Empty: of nobody else.
  std::string key{};
  /// On one of several threads; takes its time, but ends soon once it is told to stop. Does not throw.
  std::function<Response(const std::stop_token&)> answer;
};

}  // namespace axiometry::server
