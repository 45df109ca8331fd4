// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace axiometry::report {

/// Capital letters, whatever the locale: of the Latin letters that the languages of the program have (Unicode's Basic
/// Latin, Latin-1 and œ; ß becomes SS, as it does where a browser raises it). All else stays: the µ of a unit, Greek
/// letters of symbols, bytes that are no UTF-8.
std::string upper_case(std::string_view text);

}  // namespace axiometry::report
