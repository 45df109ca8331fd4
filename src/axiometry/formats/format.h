// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"

/// Files of measured deviations. One .cpp in this folder per format, each with one `const Format
/// <stem>_format = {…}`; the build collects them (docs/howto/add-a-format.md). Readers are pure: bytes
/// in, tests out; they never open a file and never change a reading.
namespace axiometry::formats {

/// Bytes that arrive piece by piece, for files larger than memory.
class ByteReader {
 public:
  virtual ~ByteReader() = default;
  /// Fills the front of `buffer`, returns how many bytes were read; 0 at the end.
  virtual Result<std::size_t> read(std::span<char> buffer) = 0;
};

/// One test of a file that holds many.
struct NamedTest {
  std::string name;      ///< value of the `test` column
  std::size_t line = 0;  ///< line of the file where its first reading stands
  Metadata metadata;
  Series series;
  std::vector<SourceRemark> remarks{};
};

using NamedTestSink = std::function<Result<void>(NamedTest&&)>;

struct Format {
  std::string_view id;          ///< "csv-long", for --format
  std::string_view title;       ///< "CSV, one reading per line"
  std::string_view extensions;  ///< ".csv .txt", a hint for people; recognition goes by content
  std::string_view manual;      ///< Markdown: grammar, units, what is refused, an example

  /// How well the beginning of a file (at most 64 KiB, cut anywhere) fits: 0 not at all, 100 surely.
  int (*recognise)(std::string_view head);

  /// Reads one test; `provenance` stays for the caller to fill. Errors carry line and column.
  Result<Test> (*read)(std::string_view bytes);

  /// Whether a file with this beginning holds many tests, which read_many() then reads in bounded
  /// memory. Both null for formats that never do.
  bool (*holds_many)(std::string_view head) = nullptr;
  Result<void> (*read_many)(ByteReader& bytes, const NamedTestSink& sink) = nullptr;

  /// Writes a test so that read(write(x)) == x in series and metadata; null for input-only formats.
  std::string (*write)(const Test& test) = nullptr;
};

/// Every format, in alphabetical order of the source files (generated).
std::span<const Format* const> format_table();

/// nullptr when there is none of that id.
const Format* find_format(std::string_view id);

/// The format that fits best. Fails on empty input, on binary content and on text that no format
/// recognises; the message says what was found at the beginning and lists what is read.
Result<const Format*> recognise(std::string_view head);

}  // namespace axiometry::formats
