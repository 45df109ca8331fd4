// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/text.h"
#include "axiometry/store/kept/asset_tables.h"
#include "axiometry/store/kept/kept_lists.h"

namespace axiometry::store {
namespace {

Result<void> check_compensation(const CompensationRecord& c) {
  if (text::trim(c.control).empty()) return fail("found a compensation without a control, expected one");
  if (c.retest.has_value() != c.retest_version.has_value())
    return fail("found a re-test without its version, expected both or none");
  if (c.retest == c.test)
    return fail(fmt::format("found test {} as its own re-test, expected one with the table active", c.test));
  if (std::ranges::count(c.files, "table", &KeptFile::role) != 1)
    return fail("found a compensation without its table, expected one");
  AXIOMETRY_TRY_VOID(check_options(c.options));
  return check_figures(c.figures);
}

Result<void> check_test(Connection& connection, Id test, int version) {
  AXIOMETRY_TRY(const Rows rows,
                connection.query("SELECT test FROM test_version WHERE test = $1 AND version = $2", {test, version}));
  if (!rows.empty()) return {};
  return fail(ErrorKind::not_found, fmt::format("found no test {} in version {}, expected one", test, version));
}

std::optional<int> optional_number(const Row& row, std::size_t column) {
  return row.null(column) ? std::optional<int>() : std::optional<int>(row.number(column));
}

}  // namespace

std::vector<Cell> AssetTable<CompensationRecord>::cells(const CompensationRecord& c) {
  const std::optional<std::int64_t> retest_version = c.retest_version;
  return {c.test,
          std::int64_t{c.test_version},
          cell(c.retest),
          cell(retest_version),
          cell(c.axis),
          c.control,
          c.notes,
          std::int64_t{c.withdrawn},
          files_text(c.files),
          c.program,
          c.options,
          c.result,
          std::int64_t{c.serious},
          figures_text(c.figures)};
}

Result<CompensationRecord> AssetTable<CompensationRecord>::asset(const Row& row, std::size_t first) {
  AXIOMETRY_TRY(auto files, kept_files(row.text(first + 8), "compensation"));
  AXIOMETRY_TRY(auto figures, kept_figures(row.text(first + 13), "compensation"));
  return CompensationRecord{.test = row.integer(first),
                            .test_version = row.number(first + 1),
                            .retest = row.optional_integer(first + 2),
                            .retest_version = optional_number(row, first + 3),
                            .axis = row.optional_integer(first + 4),
                            .control = row.text(first + 5),
                            .notes = row.text(first + 6),
                            .withdrawn = row.flag(first + 7),
                            .files = std::move(files),
                            .program = row.text(first + 9),
                            .options = row.text(first + 10),
                            .result = row.text(first + 11),
                            .serious = row.number(first + 12),
                            .figures = std::move(figures)};
}

Result<void> AssetTable<CompensationRecord>::check(Connection& connection, const CompensationRecord& c) {
  AXIOMETRY_TRY_VOID(check_compensation(c));
  AXIOMETRY_TRY_VOID(check_test(connection, c.test, c.test_version));
  if (c.retest) AXIOMETRY_TRY_VOID(check_test(connection, *c.retest, *c.retest_version));
  if (c.axis) AXIOMETRY_TRY_VOID(check_exists(connection, "axis", *c.axis));
  AXIOMETRY_TRY_VOID(check_files(connection, c.files));
  return check_content(connection, c.result, "those of the result");
}

std::string AssetTable<CompensationRecord>::called(const CompensationRecord& c) {
  return fmt::format("{} {:010}", c.control, c.test);
}

}  // namespace axiometry::store
