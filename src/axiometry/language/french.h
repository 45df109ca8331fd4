// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/language/phrase_book.h"

/// What writing French does to the texts of fr.txt, whose words are those of NF ISO 230-2 and of the VIM.
namespace axiometry::language {

/// With no-break spaces where French has a space before a colon, semicolon, question or exclamation mark, percent sign
/// or closing guillemet, and after an opening one: a translator writes plain ones.
std::string with_french_spaces(std::string_view text);

/// Appends with elision and contraction: "de" + "écart" → "d’écart", "de" + "le parcours" → "du parcours", "à" + "les
/// cibles" → "aux cibles", "de" + "ISO 230-2" → "de l’ISO 230-2", "avant" + "ligne 3" → "avant la ligne 3". Symbols and
/// capital letters are left: "de A", "de Siemens".
void append_in_french(std::string& text, std::string_view content);

extern const Grammar french_grammar;

}  // namespace axiometry::language
