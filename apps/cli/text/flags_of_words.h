// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace axiometry::cli {

/// The flags by which the command line gives what a sentence of the library speaks of, such as "--rest-window,
/// --rest-threshold": the library is used by the API and its page too, and knows no flag. Empty where there is none.
std::string flags_of_words(std::string_view sentence);

/// `said`, the sentence in the reader's language, with those flags behind it: "… taken for 1 µm (--resolution)".
std::string with_flags(std::string said, std::string_view sentence);

}  // namespace axiometry::cli
