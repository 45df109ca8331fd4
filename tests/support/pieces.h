// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstring>
#include <span>
#include <string_view>

#include "axiometry/formats/format.h"

namespace axiometry::testing_support {

/// Gives a text in pieces of at most so many bytes, as files and pipes do.
class Pieces : public formats::ByteReader {
 public:
  Pieces(std::string_view text, std::size_t longest) : text_(text), longest_(longest) {}
  Result<std::size_t> read(std::span<char> buffer) override {
    const std::size_t count = std::min({buffer.size(), text_.size(), longest_});
    std::memcpy(buffer.data(), text_.data(), count);
    text_.remove_prefix(count);
    return count;
  }

 private:
  std::string_view text_;
  std::size_t longest_;
};

}  // namespace axiometry::testing_support
