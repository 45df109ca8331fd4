// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axiometry::server {

/// Which names the query of each operation may have, by openapi.json. What a route never asks for would be passed over
/// in silence: a misspelt "tolerence" is no tolerance.
class QueryNames {
 public:
  /// Contract: a sound description.
  explicit QueryNames(std::string_view openapi);

  /// In the order of the description. Nothing for an operation that is not described.
  const std::vector<std::string>* of(std::string_view method, std::string_view pattern) const;

 private:
  std::map<std::pair<std::string, std::string>, std::vector<std::string>, std::less<>> names_;
};

}  // namespace axiometry::server
