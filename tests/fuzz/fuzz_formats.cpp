// SPDX-License-Identifier: Apache-2.0
//
// Any bytes, through recognition and through every reader, in one piece and in many. What is read must be
// evaluable, must survive being written and read again, and must not depend on the way it was read.
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string>

#include "axiometry/base/contract.h"
#include "axiometry/formats/csv_long_rows.h"
#include "axiometry/formats/format.h"
#include "axiometry/model/fields.h"
#include "axiometry/standards/iso230_2.h"
#include "tests/support/pieces.h"

namespace {

using namespace axiometry;
using testing_support::Pieces;

std::string described(const Series& series) {
  std::string text;
  for (Position p : series.targets()) text += fmt::format("{} ", p.in_native());
  for (Direction d : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i)
      for (double x : series.cell(i, d)) text += fmt::format("{:x} ", std::bit_cast<std::uint64_t>(x));
  return text;
}

std::string described(const Metadata& metadata) {
  std::string text;
  for (const Field& field : metadata_fields())
    text += fmt::format("{}={}\n", field.key, field_text(field, field.get(metadata)));
  return text;
}

void check_error(const Error& error) {
  AXIOMETRY_CONTRACT(error.message.starts_with("found "));
  AXIOMETRY_CONTRACT(error.at.column == 0 || error.at.line > 0);
}

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

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes(reinterpret_cast<const char*>(data), size);
  if (const auto found = formats::recognise(bytes); !found) check_error(found.error());
  AXIOMETRY_CONTRACT(by_rows(bytes, formats::LongRows::Path::fast) ==
                     by_rows(bytes, formats::LongRows::Path::general_only));
  for (const formats::Format* format : formats::format_table()) {
    const int score = format->recognise(bytes);
    AXIOMETRY_CONTRACT(score >= 0 && score <= 100);
    const auto test = format->read(bytes);
    if (test) {
      iso230_2::evaluate(test->series);
      check_written(*test);
    } else {
      check_error(test.error());
    }
    if (format->read_many == nullptr || !format->holds_many(bytes)) continue;
    AXIOMETRY_CONTRACT(by_pieces(*format, bytes, 3) == by_pieces(*format, bytes, size + 1));
  }
  return 0;
}
