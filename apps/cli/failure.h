// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/language/language.h"
#include "cli/exit_code.h"

namespace axiometry::cli {

/// Who calls the program with --language is told in it what is wrong, whichever verb fails; else in English.
void tell_faults_in(language::Language language);

/// What is wrong in that language, without what a terminal would obey. The name of an option before it stays:
/// "--out: found …". Where it speaks of what flags give, they stand behind it (flags_of_words.h).
std::string told_fault(std::string_view text);

/// That language; English where none was asked for.
language::Language language_asked();

/// The same of a sentence of what was done, for the standard output; what a file or a person said in it stays.
std::string in_language_asked(std::string_view text);

/// Likewise with a word in front that says what it is: "noted: ".
std::string in_language_asked(std::string_view what, std::string_view sentence);

/// Says it on the standard error, in that language. The name of a file and the place in it stay.
void tell(const Error& error);

/// Says on the standard error a sentence that is no error: told_fault().
void tell(std::string_view sentence);

/// tell(); returns `code`.
int failed(const Error& error, ExitCode code = exit_bad_input);

}  // namespace axiometry::cli
