// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace axiometry::formats {

/// Text that comes piece by piece, cut anywhere, as UTF-8. Programs of Windows write UTF-16 with a byte order mark in
/// front; all else is handed on as it is, for its reader to judge. decoded_text() does the same of a whole text.
class StreamedText {
 public:
  /// What is whole of it so far and was not handed on before, valid until the next call. Half of a pair of surrogates
  /// becomes U+FFFD.
  std::string_view decoded(std::string_view bytes);

  /// Bytes are missing here: what comes next begins with a whole character.
  void interrupted();

  /// Bytes of a character whose end has not come.
  std::size_t unfinished() const { return begun_.size(); }
  bool is_utf16() const { return order_ == Order::low_first || order_ == Order::high_first; }

 private:
  enum class Order { not_known, no_matter, low_first, high_first };
  void put(char16_t unit);

  Order order_ = Order::not_known;
  std::string begun_, text_;
  char16_t high_ = 0;  // first half of a pair; 0 for none
};

}  // namespace axiometry::formats
