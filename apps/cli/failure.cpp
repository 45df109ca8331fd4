// SPDX-License-Identifier: Apache-2.0
#include "cli/failure.h"

#include <fmt/format.h>

#include <cstdio>

#include "axiometry/report/drawing/utf8.h"
#include "cli/text/flags_of_words.h"

namespace axiometry::cli {
namespace {

/// A process is called by one reader, of whom the verbs that fail know nothing.
language::Language& language_of_faults() {
  static language::Language language = language::Language::english;
  return language;
}

std::string in_language_of_faults(std::string_view text) { return language::translated(text, language_of_faults()); }

std::string with_flags_in_language(std::string_view text) { return with_flags(in_language_of_faults(text), text); }

}  // namespace

void tell_faults_in(language::Language language) { language_of_faults() = language; }

language::Language language_asked() { return language_of_faults(); }

std::string told_fault(std::string_view text) {
  const std::size_t colon = text.find(": "), space = text.find(' ');
  const bool names_option = colon != text.npos && colon < space;
  const std::size_t begin = names_option ? colon + 2 : 0;
  return report::printable(std::string(text.substr(0, begin)) + with_flags_in_language(text.substr(begin)));
}

std::string in_language_asked(std::string_view text) { return report::printable(in_language_of_faults(text)); }

std::string in_language_asked(std::string_view what, std::string_view sentence) {
  constexpr std::string_view in_its_place = "0";
  std::string said = in_language_of_faults(fmt::format("{}{}", what, in_its_place));
  said.resize(said.size() - in_its_place.size());
  return report::printable(said + in_language_of_faults(sentence));
}

void tell(const Error& error) {
  Error told = error;
  told.message = with_flags_in_language(error.message);
  fmt::print(stderr, "axiometry: {}\n", report::printable(told.to_string()));
}

void tell(std::string_view sentence) { fmt::print(stderr, "axiometry: {}\n", told_fault(sentence)); }

int failed(const Error& error, ExitCode code) {
  tell(error);
  return code;
}

}  // namespace axiometry::cli
