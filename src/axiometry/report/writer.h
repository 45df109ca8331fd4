// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/report/document.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// One output format of a report. One .cpp in writers/ each, with one `const Writer <stem>_writer = {…}`.
struct Writer {
  std::string_view extension;  ///< "html"
  std::string_view title;      ///< "Web page, self-contained, prints on A4"
  Result<std::string> (*write)(const Subject& subject, const Options& options);  ///< the whole file's bytes

  /// The same of a document that is not the report of a test: a plan's sheet, a periodic error. Pages are set whole;
  /// pictures show the document's figures; CSV holds its tables, each with its head, separated by blank lines, and
  /// where there is a label with a column `remark` for it.
  Result<std::string> (*set)(const Document& document, const Options& options);
};

std::span<const Writer* const> writer_table();  ///< generated

/// By extension without the dot, any case; nullptr when there is none.
const Writer* find_writer(std::string_view extension);

}  // namespace axiometry::report
