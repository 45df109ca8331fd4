// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

/// What people write where a statement is asked for and they have none, in every language of the program. Capital
/// letters, blanks, hyphens, and brackets or marks about the whole make no difference.
namespace axiometry::text {

/// Whether a text is no statement: empty, dashes and marks alone, "n/a", "unknown", "not stated", "k. A.", "inconnu",
/// and what the program itself shows where nothing is stated.
bool says_nothing(std::string_view s);

/// Whether it says that there is none of the thing: "none", "nil", "keine", "aucun", "not used", "nicht gemacht". An
/// answer about what need not be; of what must be there it says as little as says_nothing().
bool says_none(std::string_view s);

/// As says_none(), and "no", "off", "nein", "aus", "non", "0", which may be names where one is asked for.
bool says_no(std::string_view s);

/// Whether what is said of a warm-up is that there was none: as says_no(), "no warm-up", "kalt", "sans préchauffage",
/// "0 min".
bool says_no_warm_up(std::string_view s);

}  // namespace axiometry::text
