// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "axiometry/base/json/json.h"
#include "axiometry/base/text/text.h"
#include "axiometry/store/kept/asset_tables.h"
#include "axiometry/store/kept/calibration_kinds.h"
#include "axiometry/store/kept/kept_lists.h"

namespace axiometry::store {
namespace {

constexpr std::size_t longest_measured_on = 200;  // as long as that of a test may be

Result<void> check_values(const CalibrationRecord& c) {
  if (!is_calibration_kind(c.kind))
    return fail(
        fmt::format("found the kind of calibration {}, expected {}", text::quoted(c.kind), calibration_kinds_text));
  if (text::trim(c.title).empty()) return fail("found a calibration without a title, expected one");
  if (c.measured_on.size() > longest_measured_on)
    return fail(
        fmt::format("found a date of {} bytes, expected at most {}", c.measured_on.size(), longest_measured_on));
  if (c.instrument.has_value() != c.instrument_version.has_value())
    return fail("found an instrument without its version, expected both or none");
  if (c.files.empty()) return fail("found a calibration without files, expected what it was evaluated from");
  AXIOMETRY_TRY_VOID(check_options(c.options));
  return check_figures(c.figures);
}

}  // namespace

std::vector<Cell> AssetTable<CalibrationRecord>::cells(const CalibrationRecord& c) {
  const std::optional<std::int64_t> known_as = c.instrument_version;
  return {c.kind,
          c.title,
          cell(c.machine),
          cell(c.instrument),
          cell(known_as),
          c.measured_on,
          c.notes,
          std::int64_t{c.withdrawn},
          files_text(c.files),
          c.program,
          c.options,
          c.result,
          c.verdict,
          std::int64_t{c.serious},
          figures_text(c.figures)};
}

Result<CalibrationRecord> AssetTable<CalibrationRecord>::asset(const Row& row, std::size_t first) {
  AXIOMETRY_TRY(auto files, kept_files(row.text(first + 8), "calibration"));
  AXIOMETRY_TRY(auto figures, kept_figures(row.text(first + 14), "calibration"));
  return CalibrationRecord{
      .kind = row.text(first),
      .title = row.text(first + 1),
      .machine = row.optional_integer(first + 2),
      .instrument = row.optional_integer(first + 3),
      .instrument_version = row.null(first + 4) ? std::optional<int>() : std::optional<int>(row.number(first + 4)),
      .measured_on = row.text(first + 5),
      .notes = row.text(first + 6),
      .withdrawn = row.flag(first + 7),
      .files = std::move(files),
      .program = row.text(first + 9),
      .options = row.text(first + 10),
      .result = row.text(first + 11),
      .verdict = row.text(first + 12),
      .serious = row.number(first + 13),
      .figures = std::move(figures)};
}

Result<void> AssetTable<CalibrationRecord>::check(Connection& connection, const CalibrationRecord& c) {
  AXIOMETRY_TRY_VOID(check_values(c));
  if (c.machine) AXIOMETRY_TRY_VOID(check_exists(connection, "machine", *c.machine));
  if (c.instrument) AXIOMETRY_TRY_VOID(check_exists(connection, "instrument", *c.instrument));
  AXIOMETRY_TRY_VOID(check_files(connection, c.files));
  return check_content(connection, c.result, "those of the result");
}

std::string AssetTable<CalibrationRecord>::called(const CalibrationRecord& c) { return c.title; }

}  // namespace axiometry::store
