// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"

/// A language as one file of pairs, for the program and for its page: de.txt, fr.txt. For each text two lines, the
/// English one and the other, then a blank one. A line that begins with # is a comment; the first of several begins a
/// subject, whose pairs are sorted by the bytes of the English line. A subject whose comment begins with "# The page"
/// holds texts that the page alone has: their places have names, and a meaning in brackets may follow the English.
namespace axiometry::language {

struct PhrasePair {
  std::string english;
  std::string other;
  std::string subject;         ///< its comment, without "# "
  bool of_page_alone = false;  ///< no phrase of the program (Phrase in language.h)
};

/// Fails, with the number of the line, where an English line stands alone or a third line follows a pair, and where one
/// begins or ends with a blank.
Result<std::vector<PhrasePair>> read_pairs(std::string_view text);

/// The file of that language: "de". Contract: there is one, and it is sound.
std::vector<PhrasePair> pairs_of(std::string_view tag);

}  // namespace axiometry::language
