// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as an import profile; with a blank line between, a profile and the table to read after it. A profile that
// is read is written and read again as the same; a guess about a table never reads other numbers than its own profile.
#include "axiometry/formats/table/generic_delimited.h"
#include "axiometry/formats/table/import_profile.h"
#include "described.h"

using namespace axiometry;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzzing::as_text(data, size);
  const std::size_t blank = bytes.find("\n\n");
  const std::string_view table = blank == bytes.npos ? bytes : bytes.substr(blank + 2);
  if (const auto profile = formats::read_profile(bytes.substr(0, blank)); profile) {
    const std::string written = formats::write_profile(*profile);
    const auto again = formats::read_profile(written);
    AXIOMETRY_CONTRACT(again && formats::write_profile(*again) == written);
    if (const auto test = formats::read_with(*profile, table); !test) fuzzing::check_error(test.error());
  } else {
    fuzzing::check_error(profile.error());
  }
  const auto guess = formats::guess(table);
  if (!guess) {
    fuzzing::check_error(guess.error());
    return 0;
  }
  const auto guessed = formats::read_guessed(table);
  if (!guess->questions.empty()) {
    AXIOMETRY_CONTRACT(!guessed);
    return 0;
  }
  const auto read = formats::read_with(guess->profile, table);
  AXIOMETRY_CONTRACT(read.has_value() == guessed.has_value());
  if (read) AXIOMETRY_CONTRACT(fuzzing::described(read->series) == fuzzing::described(guessed->series));
  return 0;
}
