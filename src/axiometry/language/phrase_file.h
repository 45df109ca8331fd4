// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/language/language.h"

/// A language as one file of pairs, as fr.txt is one. For each phrase (Phrase in language.h) two lines, the English one
/// and the other, then a blank one. A line that begins with # is a comment; the first of several begins a subject,
/// whose pairs are sorted by the bytes of the English line.
namespace axiometry::language {

struct PhrasePair {
  std::string english;
  std::string other;
  std::size_t subject = 0;  ///< how many subjects began before it
};

/// Fails, with the number of the line, where an English line stands alone or a third line follows a pair, and where one
/// begins or ends with a blank.
Result<std::vector<PhrasePair>> read_pairs(std::string_view text);

/// Of pairs that stay where they are.
std::vector<Phrase> phrases_of(std::span<const PhrasePair> pairs);

}  // namespace axiometry::language
