// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/sqlite_pages.h"

#include <cstdint>
#include <filesystem>
#include <system_error>

#include "axiometry/store/proof/problems.h"

namespace axiometry::store {
namespace {

/// Pages that are not in the file yet stand in the log beside it.
bool has_log(const std::string& file) {
  std::error_code none;
  const auto size = std::filesystem::file_size(file + "-wal", none);
  return !none && size > 0;
}

Result<void> verify_size(Connection& connection, std::vector<std::string>& problems) {
  AXIOMETRY_TRY(const Rows databases, connection.query("PRAGMA database_list"));
  const std::string file = databases[0].text(2);
  std::error_code unknown;
  const auto size = static_cast<std::int64_t>(std::filesystem::file_size(file, unknown));
  if (unknown) return {};  // in memory alone
  AXIOMETRY_TRY(const Rows pages, connection.query("PRAGMA page_count"));
  AXIOMETRY_TRY(const Rows page, connection.query("PRAGMA page_size"));
  const std::int64_t each = page[0].integer(0), wanted = pages[0].integer(0) * each;
  if (has_log(file) ? size % each == 0 : size == wanted) return {};
  add_problem(problems, "file: found {} bytes, expected {} pages of {} bytes", size, pages[0].integer(0), each);
  return {};
}

}  // namespace

Result<void> verify_sqlite_pages(Connection& connection, std::vector<std::string>& problems) {
  AXIOMETRY_TRY(const Rows integrity, connection.query("PRAGMA integrity_check"));
  for (const Row& row : integrity)
    if (row.text(0) != "ok") add_problem(problems, "file: {}", row.text(0));
  AXIOMETRY_TRY(const Rows references, connection.query("PRAGMA foreign_key_check"));
  for (const Row& row : references)
    add_problem(problems, "{}: found a row that refers to a row of {} that does not exist", row.text(0), row.text(2));
  return verify_size(connection, problems);
}

}  // namespace axiometry::store
