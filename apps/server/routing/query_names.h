// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace axiometry::server {

/// What a query may have.
struct QueryName {
  std::string name;
  std::vector<std::string> words;  ///< those that its value may be, where they are enumerated; else none
};

/// Which names the query of each operation may have, by openapi.json, and which words where they are enumerated. What a
/// route never asks for would be passed over in silence: a misspelt "tolerence" is no tolerance, and what no test can
/// have is found in none.
class QueryNames {
 public:
  /// Contract: a sound description.
  explicit QueryNames(std::string_view openapi);

  /// In the order of the description. Nothing for an operation that is not described.
  const std::vector<QueryName>* of(std::string_view method, std::string_view pattern) const;

 private:
  std::map<std::pair<std::string, std::string>, std::vector<QueryName>, std::less<>> names_;
};

}  // namespace axiometry::server
