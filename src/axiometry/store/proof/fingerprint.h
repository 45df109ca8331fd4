// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "axiometry/digest/sha256.h"
#include "axiometry/store/database/connection.h"

namespace axiometry::store {

/// SHA-256 of fields in their order. Each goes in with its type and length, so that none can lend a letter to its
/// neighbour; numbers as the shortest text that reads back the same.
class Fingerprint {
 public:
  Fingerprint& add(std::string_view text);
  Fingerprint& add_cell(const Cell& cell);
  Fingerprint& add(std::span<const Cell> cells);
  std::string finish() { return hash_.finish(); }

 private:
  void put(char type, std::string_view text);
  Sha256 hash_;
};

}  // namespace axiometry::store
