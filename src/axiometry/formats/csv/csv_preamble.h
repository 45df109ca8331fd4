// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/formats/csv/csv_columns.h"
#include "axiometry/formats/text/csv_cells.h"
#include "axiometry/model/metadata.h"
#include "axiometry/model/test.h"

/// What stands above the readings of a CSV file: `# key: value` lines and the header.
namespace axiometry::formats {

/// A remark of the reader that took the readings out of another file, kept where they are written again.
inline constexpr std::string_view source_remark_key = "source_remark";
/// What such a remark begins with when it is told again: it speaks of that other file.
inline constexpr std::string_view first_read = "told when the readings were first read: ";

struct MetadataLine {
  std::string key;  ///< key of a field
  std::string value;
  TextPosition at;
};

/// Lines above a table of which nothing is kept.
struct LinesPassedOver {
  std::size_t count = 0;
  std::string first;

  void add(std::string_view line);
  std::optional<SourceRemark> remark() const;  ///< nothing where there are none
};

struct Preamble {
  std::vector<MetadataLine> metadata;
  std::vector<SourceRemark> remarks;  ///< `# source_remark: …`: what was told when the readings were first read
  LinesPassedOver passed_over;        ///< but comments that name nothing
  DefaultUnits default_units;         ///< `# unit: um`, `# target unit: mm`
  char delimiter = ',';
  std::vector<Column> columns;  ///< columns of the header; empty when there is none
  std::size_t header_line = 0;
  std::size_t size = 0;  ///< bytes up to and with the line break of the header
};

/// Reads up to and with the header: the first line that names a target and what is measured there, or else
/// the first that is neither blank nor begins with # (nor is a spreadsheet's `sep=;`). Lines that begin with
/// # and hold a known key and a colon are metadata, other ones are comments; a key with a dot that is not
/// known, or one that nearly is, is refused. Other lines above the header are metadata where they hold a known
/// key ("Machine;Mill 5"), and passed over otherwise. Fails where readings stand without a header.
Result<Preamble> read_preamble(std::string_view text);

/// The columns of the header alone, without a look at the lines above it: for recognition. None when there
/// is no header.
std::vector<Column> header_columns(std::string_view text);

/// Whether read_preamble() can tell what is wrong with a header that names no columns.
bool has_faulty_header(std::string_view text);

/// Whether a line begins with # and holds metadata, whose place is above the header.
Result<bool> is_metadata_line(std::string_view line, std::size_t line_number);

/// A key may be shortened in CSV files: "inspector" for "test.inspector".
struct KeyAlias {
  std::string_view alias;
  std::string_view key;
};
std::span<const KeyAlias> key_aliases();

/// The metadata of a file whose units say `kind`. Numbers may have the decimal mark of the file. Fails when
/// a value does not fit its field, a key that takes one value is given twice, or axis.kind disagrees.
Result<Metadata> metadata_of(const Preamble& preamble, AxisKind kind, char decimal_mark);

}  // namespace axiometry::formats
