// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/sqlite_pages.h"

#include <cstdint>
#include <filesystem>
#include <system_error>

#include "axiometry/base/counted.h"
#include "axiometry/store/database/sqlite_log.h"
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

Result<void> verify_sqlite_log(Connection& connection, Verification& found) {
  AXIOMETRY_TRY(const Rows databases, connection.query("PRAGMA database_list"));
  const LogState state = log_beside(databases[0].text(2));
  const std::string behind =
      state.behind > 0
          ? fmt::format(", and {} behind it", counted(static_cast<std::size_t>(state.behind), "finished change"))
          : "";
  if (state.altered_head)
    add_problem(found.problems,
                "file: found the head of the log beside it (-wal) altered, expected it as it was written: the changes "
                "in the log are passed over");
  else if (state.is_damaged())
    add_problem(found.problems,
                "file: found page {} of the log beside it (-wal) altered, expected it as it was written: the change "
                "that begins with page {} is passed over{}",
                state.pages + 1, state.kept + 1, behind);
  found.last_change_is_lost = state.is_undecided();
  if (found.last_change_is_lost) found.notes.push_back(note_of_log(state));
  return {};
}

}  // namespace axiometry::store
