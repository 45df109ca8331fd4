// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/report/report.h"

namespace axiometry::report {

/// One output format of a report. One .cpp in writers/ each, with one `const Writer <stem>_writer = {…}`.
struct Writer {
  std::string_view extension;  ///< "html"
  std::string_view title;      ///< "Web page, self-contained, prints on A4"
  Result<std::string> (*write)(const Subject& subject, const Options& options);  ///< the whole file's bytes
};

std::span<const Writer* const> writer_table();  ///< generated

/// By extension without the dot, any case; nullptr when there is none.
const Writer* find_writer(std::string_view extension);

}  // namespace axiometry::report
