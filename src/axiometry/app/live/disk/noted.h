// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "axiometry/base/json/json.h"

/// Members of what a capture has noted on the disk, which an archive of another program may have brought along.
namespace axiometry::app {

/// Empty where there is no such text.
inline std::string noted_text(const json::Value& value, std::string_view name) {
  const json::Value* member = value.find(name);
  return member != nullptr && member->is(json::Kind::text) ? member->text() : std::string();
}

/// 0 where there is no such number, or none from 0 to 1e9.
inline std::size_t noted_count(const json::Value& value, std::string_view name) {
  constexpr double most = 1e9;
  const json::Value* member = value.find(name);
  const bool counts = member != nullptr && member->is(json::Kind::number) && member->number() >= 0.0;
  return counts && member->number() <= most ? static_cast<std::size_t>(member->number()) : 0;
}

}  // namespace axiometry::app
