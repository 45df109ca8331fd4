// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

/// What of a text is language, and what is number, symbol or unit.
namespace axiometry::language {

/// Whether a text is the same in every language but for its decimal mark: numbers, units ("µm/(m·°C)"), symbols
/// ("U_EVE", "x̄", single letters), standards ("ISO 230-2:2014") and signs; an argument of a packed
/// text is one.
bool has_no_words(std::string_view text);

/// The numbers with that decimal mark: "12.5 µm" → "12,5 µm", but neither "5.3.2" nor "A.2" nor "v1.5". Where the mark
/// is a comma, coordinates in brackets are separated by semicolons: "(0.5, 1, 2)" → "(0,5; 1; 2)".
std::string with_decimal_mark(std::string_view text, char mark);

/// 'as the user gave it' or "…", all of it.
bool is_quoted(std::string_view text);

/// With a capital first letter, those with accents too.
std::string capitalised(std::string text);

/// With a small first letter, but for what begins with a symbol, an abbreviation or another mixture of capitals.
std::string without_capital(std::string text);

}  // namespace axiometry::language
