// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/store/calibrations.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/workbench/calibrations/calibrations.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/store/kept/calibration_kinds.h"
#include "axiometry/store/store.h"
#include "cli/failure.h"
#include "cli/flags/store_flags.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/store/store_report.h"

namespace axiometry::cli {
namespace {

using store::CalibrationRecord;

struct CalibrationArguments {
  std::string address;
  std::int64_t id = 0, limit = 50;
  std::int64_t version = 0;  // 0: the latest
  std::string text, kind;
  bool json = false, withdrawn = false;
  std::string report, folder;
};

using SharedCalibration = std::shared_ptr<CalibrationArguments>;

std::string last_part(const std::string& file) { return std::filesystem::path(file).filename().string(); }

/// "A x 10.2 µm", and of numbers without a unit "chi2_per_dof 1.122".
std::string kept_figure_text(std::string_view kind, const store::KeptFigure& figure) {
  const std::string unit = figure.unit == "um"     ? " µm"
                           : figure.unit == "urad" ? " µrad"
                                                   : (figure.unit.empty() ? "" : " ″");
  const bool is_small = app::is_motion_kind(kind);  // straightness is often below 1 µm
  return fmt::format("{}{}{} {}{}", figure.parameter, figure.of.empty() ? "" : " ", report::printable(figure.of),
                     figure.parameter == "chi2_per_dof" ? format_fixed(figure.value, 3)
                     : unit.empty()                     ? format_exact(figure.value)
                                                        : format_fixed(figure.value, is_small ? 2 : 1),
                     unit);
}

void print_line(const store::CalibrationRow& row) {
  const CalibrationRecord& c = row.calibration.value;
  fmt::print("{} {} {} {} {} {}{}\n", left(fmt::format("{}", row.calibration.id), 7),
             left(report::printable(c.measured_on), 11), left(c.kind, 12),
             left(report::printable(row.machine_name), 24), left(c.verdict, 17), report::printable(c.title),
             c.withdrawn ? " (withdrawn)" : "");
}

Result<int> list_kept(const CalibrationArguments& a) {
  AXIOMETRY_TRY(const auto archive, archive_at(a.address, {.create = false}));
  store::CalibrationFilter filter;
  filter.text = a.text;
  filter.kind = a.kind;
  filter.withdrawn = a.withdrawn;
  filter.limit = a.limit;
  AXIOMETRY_TRY(const store::CalibrationPage page, archive->calibrations(filter));
  for (const store::CalibrationRow& row : page.rows) print_line(row);
  fmt::print("{} of {}\n", page.rows.size(), page.total);
  return exit_done;
}

void print_kept(const app::KeptCalibration& kept) {
  const CalibrationRecord& c = kept.calibration.value;
  fmt::print("{}\n", report::printable(c.title));
  const std::pair<const char*, std::string> rows[] = {
      {"kind", c.kind},
      {"version", fmt::format("{} of {}", kept.calibration.version, kept.versions.size())},
      {"machine", kept.machine ? kept.machine->value.name : ""},
      {"measured", c.measured_on},
      {"evaluated by", c.program},
      {"options", c.options},
      {"verdict", c.verdict},
      {"withdrawn", c.withdrawn ? "yes" : ""},
      {"serious findings", c.serious > 0 ? fmt::format("{}", c.serious) : ""},
      {"notes", c.notes}};
  for (const auto& [name, text] : rows)
    if (!text.empty()) fmt::print("  {}{}\n", left(name, 18), report::printable(text));
  for (const store::KeptFile& file : c.files)
    fmt::print("  {}{} {}\n", left(file.role, 18), file.content.substr(0, 12), report::printable(file.name));
  for (const store::KeptFigure& figure : c.figures) fmt::print("    {}\n", kept_figure_text(c.kind, figure));
}

/// The files under their own names, none of which is there. Where the folder cannot be made, writing into it says so.
Result<void> export_files(const store::Store& archive, const app::KeptCalibration& kept, const std::string& folder) {
  if (std::error_code ignored; !std::filesystem::exists(folder, ignored))
    std::filesystem::create_directories(folder, ignored);
  for (const store::KeptFile& file : kept.calibration.value.files) {
    AXIOMETRY_TRY(const app::Rendered bytes, app::calibration_file(archive, kept.calibration.id, file.role));
    const std::string name = (std::filesystem::path(folder) / last_part(file.name)).string();
    if (std::error_code ignored; std::filesystem::exists(name, ignored))
      return fail(fmt::format("found the file {} there already, expected none of its name", text::quoted(name)));
    AXIOMETRY_TRY_VOID(app::write_file(name, bytes.bytes));
    fmt::print("{}\n", report::printable(name));
  }
  return {};
}

Result<int> show(const CalibrationArguments& a) {
  check_report_name(a.report);
  AXIOMETRY_TRY(const auto archive, archive_at(a.address, {.create = false}));
  const auto version = a.version > 0 ? std::optional(static_cast<int>(a.version)) : std::nullopt;
  AXIOMETRY_TRY(const auto kept, app::kept_calibration(*archive, a.id, version));
  AXIOMETRY_TRY_VOID(write_report(a.report, [&](const app::ReportRequest& request) {
    return app::calibration_report(*archive, a.id, version, request);
  }));
  if (!a.folder.empty()) AXIOMETRY_TRY_VOID(export_files(*archive, kept, a.folder));
  if (a.json)
    fmt::print("{}\n", json::dump(kept.result));
  else if (a.folder.empty() && a.report.empty())
    print_kept(kept);
  return exit_done;
}

}  // namespace

void add_store_calibrations(const Verb& store, int& exit_code) {
  add_store_calibrate(store, exit_code);
  add_store_motions(store, exit_code);
  auto made = std::make_shared<CalibrationArguments>();
  Verb listed = store_verb(store, {"calibrations", "List calibrations, the newest first"}, exit_code, made, list_kept);
  listed->add_option("--text", made->text, "Only those with these words in title, notes, files or machine");
  listed->add_option("--kind", made->kind, "Only lines, volumetric, straightness, angles or squareness")
      ->check_among({store::calibration_kinds.begin(), store::calibration_kinds.end()});
  listed->add_flag("--withdrawn", made->withdrawn, "Withdrawn ones, too");
  listed->add_option("--limit", made->limit, "How many (50)")->check_range(1, 1000);
  made = std::make_shared<CalibrationArguments>();
  Verb shown =
      store_verb(store, {"calibration", "Show a calibration, or write its report or its files"}, exit_code, made, show);
  shown->add_option("N", made->id, "Its number")->required();
  shown->add_option("--version", made->version, "Of that version (the latest)")->type_name("N");
  shown->add_flag("--json", made->json, "Print the result as it was kept, as JSON");
  shown->add_option("--report", made->report, "Report to FILE, by its extension html, pdf, svg, png or csv")
      ->type_name("FILE");
  shown->add_option("--files", made->folder, "The files it was evaluated from, as they came, into FOLDER")
      ->type_name("FOLDER");
}

}  // namespace axiometry::cli
