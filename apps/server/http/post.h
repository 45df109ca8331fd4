// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <chrono>
#include <cstddef>
#include <string>

#include "axiometry/base/result.h"

namespace axiometry::server {

/// What is sent to another server, and how long and how large its answer may be.
struct Post {
  std::string url;   ///< "http://…" or "https://…"
  std::string type;  ///< type of the body
  std::string body;
  std::string answer_type;  ///< type of answer that is taken
  std::chrono::seconds longest{10};
  std::size_t most = std::size_t{1} << 20;  ///< bytes
};

/// The body of the answer. Over https the certificate must be one that the system trusts. Fails on another URL, with
/// the system's reason where the server cannot be reached, on another status than 200, on another type, and when it
/// takes longer or sends more; a name server that is silent has the system's own time. No redirection is followed.
Result<std::string> post(const Post& post);

}  // namespace axiometry::server
