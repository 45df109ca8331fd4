// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>
#include "cli/flags/verb.h"

#include "axiometry/base/result.h"
#include "axiometry/report/report.h"

/// Options whose text the program understands itself: CLI11's own numbers follow the locale.
namespace axiometry::cli {

/// What an option says.
struct OptionText {
  std::string name;         ///< "--feed"
  std::string type;         ///< type of the value, in the help: "NUMBER"
  std::string description;  ///< sentence in the help
};

/// An option whose text `read` understands; its error becomes one of the command line.
Flag add_read(const Verb& verb, const OptionText& text, std::function<Result<void>(const std::string&)> read);

/// A number with a decimal point, whatever the locale.
Flag add_number(const Verb& verb, const OptionText& text, std::function<void(double)> put);

/// A whole number of 0 or more.
Flag add_count(const Verb& verb, const OptionText& text, std::function<void(unsigned long long)> put);

/// --seed: a whole number that JSON can carry.
Flag add_seed(const Verb& verb, const std::string& description, std::function<void(unsigned long long)> put);

/// --decimal: the mark becomes '.' or ','.
Flag add_decimal(const Verb& verb, char& mark, const std::string& description = "Decimal mark: point or comma");

/// --language: of reports and sheets; also the decimal mark that its readers expect, unless `decimal` is given.
Flag add_language(const Verb& verb, report::Options& options, Flag decimal);

/// --language of a verb that writes no report: of what it tells in the terminal, for which main() looks at all words.
Flag add_language(const Verb& verb);

/// For check(): what is wrong with the name of a file that is read; "" when nothing is.
std::string fault_of_empty_name(const std::string& name);

/// For check(): what is wrong with the name of an output, which may be "-"; "" when nothing is.
std::string fault_of_name(const std::string& name);

}  // namespace axiometry::cli
