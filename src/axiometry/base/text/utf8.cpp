// SPDX-License-Identifier: Apache-2.0
#include "axiometry/base/text/utf8.h"

#include "axiometry/base/contract.h"

namespace axiometry {

Character character_at(std::string_view text, std::size_t at) {
  AXIOMETRY_CONTRACT(at < text.size());
  constexpr Character invalid{0xfffd, 1};
  const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(text[k]); };
  const unsigned lead = byte(at);
  if (lead < 0x80) return {lead, 1};
  const std::size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4 || at + length > text.size()) return invalid;
  char32_t code = lead & (0x7fu >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(at + k) & 0xc0u) != 0x80u) return invalid;
    code = (code << 6) | (byte(at + k) & 0x3fu);
  }
  constexpr char32_t smallest[] = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xd800 && code <= 0xdfff;
  return code < smallest[length] || code > 0x10ffff || surrogate ? invalid : Character{code, length};
}

}  // namespace axiometry
