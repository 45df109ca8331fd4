// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/test_of_file.h"

#include <algorithm>

namespace axiometry::app {

Result<std::optional<store::Id>> test_of_file(const store::Transaction& archive, const KnownFile& file) {
  for (const std::string& sha256 : file.sha256s) {
    store::TestFilter filter;
    filter.sha256 = sha256;
    filter.withdrawn = true;
    filter.limit = 1000;
    AXIOMETRY_TRY(const store::TestPage page, archive.tests(filter));
    const auto row = std::ranges::find(page.rows, file.name, &store::TestRow::file_name);
    if (row != page.rows.end()) return std::optional(row->id);
  }
  return std::optional<store::Id>();
}

}  // namespace axiometry::app
