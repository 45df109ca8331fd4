// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/writer.h"

#include <algorithm>

#include "axiometry/base/text/text.h"

namespace axiometry::report {

const Writer* find_writer(std::string_view extension) {
  const auto table = writer_table();
  const auto found = std::ranges::find_if(
      table, [&](const Writer* writer) { return text::equal_ignoring_case(writer->extension, extension); });
  return found == table.end() ? nullptr : *found;
}

}  // namespace axiometry::report
