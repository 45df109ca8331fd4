// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

/// Text of people in part programs, where a wrong character ends a comment or begins a block.
namespace axiometry::nc {

/// Capital letters A to Z, digits, blanks and the characters of `allowed`, nothing else: accents are taken off Latin
/// letters ("Ä" is "AE"), round brackets become square ones, a line break a blank, anything that is left a hyphen.
std::string safe_text(std::string_view utf8, std::string_view allowed);

/// Parts of at most `width` bytes, parted at blanks; a longer word is cut. At least one part. `width` is above 0.
std::vector<std::string> wrapped(std::string_view text, std::size_t width);

}  // namespace axiometry::nc
