// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string_view>

namespace axiometry {

/// One character of a text and the bytes it takes. Bytes that are not UTF-8 (overlong forms and
/// surrogates among them) read as U+FFFD, one each; the real U+FFFD takes three.
struct Character {
  char32_t code = 0;
  std::size_t length = 1;

  bool valid() const { return code != 0xFFFD || length == 3; }
};

/// The character that begins at byte `at` (contract: at < text.size()).
Character character_at(std::string_view text, std::size_t at);

}  // namespace axiometry
