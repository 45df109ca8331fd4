// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace axiometry::store {

/// Text as it is looked for and ordered: small letters of the Latin, Greek and Cyrillic scripts for capital ones, the
/// rest as it is. The same everywhere, whatever a database knows of letters. At most `largest` bytes, cut between
/// letters: an index has no room for more.
std::string folded(std::string_view utf8, std::size_t largest = 400);

}  // namespace axiometry::store
