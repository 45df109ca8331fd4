// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "axiometry/base/contract.h"
#include "axiometry/base/result.h"
#include "axiometry/model/fields.h"
#include "axiometry/model/series.h"

/// What every target of fuzzing needs: results as text, so that two ways of reading can be compared bit by bit, and
/// what is true of every error.
namespace axiometry::fuzzing {

inline std::string described(const Series& series) {
  std::string text;
  for (Position p : series.targets()) text += fmt::format("{} ", p.in_native());
  for (Direction d : {Direction::up, Direction::down})
    for (std::size_t i = 0; i < series.target_count(); ++i)
      for (double x : series.cell(i, d)) text += fmt::format("{:x} ", std::bit_cast<std::uint64_t>(x));
  return text;
}

inline std::string described(const Metadata& metadata) {
  std::string text;
  for (const Field& field : metadata_fields())
    text += fmt::format("{}={}\n", field.key, field_text(field, field.get(metadata)));
  return text;
}

/// It says what was found, in a line of UTF-8, and has a column only where it has a line.
void check_error(const Error& error);

/// The part of an input before its first line break, and the rest.
struct HeadAndBody {
  std::string_view head;
  std::string_view body;
};
inline HeadAndBody parted(std::string_view bytes) {
  const std::size_t end = bytes.find('\n');
  if (end == bytes.npos) return {bytes, {}};
  return {bytes.substr(0, end), bytes.substr(end + 1)};
}

inline std::string_view as_text(const std::uint8_t* data, std::size_t size) {
  return {reinterpret_cast<const char*>(data), size};
}

}  // namespace axiometry::fuzzing
