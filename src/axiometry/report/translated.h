// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "axiometry/language/language.h"
#include "axiometry/report/document.h"
#include "axiometry/report/report.h"

/// Composed English texts in the language of the reader (Options::language). Writers of documents call it once, on
/// all that compose() or another composer made; figures, which must measure their words, ask for single labels.
namespace axiometry::report {

std::string translated(std::string_view text, const Options& options);

/// What stands between a title and what is said of it: ": ", with a no-break space before it in French.
std::string_view colon(const Options& options);
std::string_view semicolon(const Options& options);  ///< "; ", likewise

/// Symbols and other runs of a style of their own keep it and go where the other language puts them; what the user
/// wrote stays.
RichText translated(const RichText& text, const Options& options);

/// Everything but the words in its drawings, which figures set themselves.
Document translated(Document document, const Options& options);

/// A figure's title and description.
Figure with_words_translated(Figure figure, const Options& options);

/// The text as a phrase book sees it: symbols as in "U_EVE" where that sets them again; else runs with a style of their
/// own, and what the user wrote, are arguments between its words.
struct TextWithArguments {
  language::TextPieces pieces;
  std::vector<RichText> arguments;  ///< arguments by number
};
TextWithArguments with_arguments(const RichText& text);

}  // namespace axiometry::report
