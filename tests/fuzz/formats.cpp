// SPDX-License-Identifier: Apache-2.0
//
// Any bytes, through recognition and through every reader, in one piece and in many. What is read must be
// evaluable, must survive being written and read again, and must not depend on the way it was read.
#include <fmt/format.h>

#include <string>

#include "axiometry/formats/csv/csv_long_rows.h"
#include "axiometry/formats/format.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "described.h"
#include "tests/support/pieces.h"

namespace {

using namespace axiometry;
using fuzzing::check_error;
using fuzzing::described;
using testing_support::Pieces;

/// Whether an input has a check made that most go without: it takes longer than reading.
bool one_in(std::size_t n, std::string_view bytes) { return std::hash<std::string_view>{}(bytes) % n == 0; }

void check_written(const Test& test) {
  const formats::Format& json = *formats::find_format("json");
  const auto again = json.read(json.write(test));
  AXIOMETRY_CONTRACT(again.has_value());
  AXIOMETRY_CONTRACT(described(again->series) == described(test.series));
  AXIOMETRY_CONTRACT(described(again->metadata) == described(test.metadata));
}

std::string by_pieces(const formats::Format& format, std::string_view bytes, std::size_t longest) {
  Pieces pieces(bytes, longest);
  std::string result;
  const auto done = format.read_many(pieces, [&](formats::NamedTest&& test) -> Result<void> {
    iso230_2::evaluate(test.series);
    result += fmt::format("{} {}: {}\n", test.name, test.line, described(test.series));
    return {};
  });
  if (done) return result;
  check_error(done.error());
  return result + done.error().to_string();
}

/// Plain rows and all others must give the same: the rows of a long CSV file, by one path.
std::string by_rows(std::string_view text, formats::LongRows::Path path) {
  auto preamble = formats::read_preamble(text);
  if (!preamble || preamble->columns.empty()) return {};
  const std::string_view below = text.substr(preamble->size);
  const auto layout = formats::long_layout(*preamble);
  if (!layout) return {};
  std::string result;
  const auto describe = [&](formats::NamedTest&& test) -> Result<void> {
    result += described(test.series);
    return {};
  };
  formats::LongRows rows(*std::move(preamble), *layout, describe, path);
  auto done = rows.take(below, text.data() + text.size());
  if (done) done = rows.finish();
  return done ? result : result + done.error().to_string();
}

void read_by(const formats::Format& format, std::string_view bytes) {
  if (format.id == "csv-long" && one_in(2, bytes))
    AXIOMETRY_CONTRACT(by_rows(bytes, formats::LongRows::Path::fast) ==
                       by_rows(bytes, formats::LongRows::Path::general_only));
  if (const auto test = format.read(bytes); test) {
    iso230_2::evaluate(test->series);
    if (one_in(4, bytes)) check_written(*test);
  } else {
    check_error(test.error());
  }
  if (format.read_many == nullptr || !format.holds_many(bytes)) return;
  AXIOMETRY_CONTRACT(by_pieces(format, bytes, 3) == by_pieces(format, bytes, bytes.size() + 1));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzzing::as_text(data, size);
  const auto found = formats::recognise(bytes);
  if (found)
    read_by(**found, bytes);
  else
    check_error(found.error());
  // Some are also read by what they are not like, which mostly says no.
  const auto table = formats::format_table();
  if (one_in(8, bytes)) read_by(*table[std::hash<std::string_view>{}(bytes) / 8 % table.size()], bytes);
  if (!one_in(16, bytes)) return 0;
  for (const formats::Format* format : table) {
    const int score = format->recognise(bytes);
    AXIOMETRY_CONTRACT(score >= 0 && score <= 100);
  }
  return 0;
}
