// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

/// Private to this folder: what verify() finds wrong, a sentence for each.
namespace axiometry::store {

inline constexpr std::size_t most_problems = 1000;  ///< nobody reads more

template <typename... Parts>
void add_problem(std::vector<std::string>& problems, fmt::format_string<Parts...> text, Parts&&... parts) {
  if (problems.size() < most_problems) problems.push_back(fmt::format(text, std::forward<Parts>(parts)...));
}

}  // namespace axiometry::store
