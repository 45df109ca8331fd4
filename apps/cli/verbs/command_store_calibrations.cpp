// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/command_store_calibrations.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/files/output.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/workbench/calibration_json.h"
#include "axiometry/app/workbench/calibrations.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/store/store.h"
#include "cli/failure.h"
#include "cli/flags/store_flags.h"
#include "cli/text/terminal.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/store_report.h"

namespace axiometry::cli {
namespace {

using store::Calibration;

struct CalibrationArguments {
  std::string address;
  std::string lengths, plan, station, machine;  // files
  std::string options, title, measured_on, notes;
  std::int64_t id = 0, machine_id = 0, instrument_id = 0, limit = 50;
  std::int64_t version = 0;  // 0: the latest
  std::string text, kind;
  bool json = false, withdrawn = false;
  std::string report, folder;
};

using SharedCalibration = std::shared_ptr<CalibrationArguments>;

std::string last_part(const std::string& file) { return std::filesystem::path(file).filename().string(); }

/// "A x 10.2 µm", and of numbers without a unit "chi2_per_dof 1.122".
std::string kept_figure_text(const store::KeptFigure& figure) {
  const std::string unit = figure.unit == "um"     ? " µm"
                           : figure.unit == "urad" ? " µrad"
                                                   : (figure.unit.empty() ? "" : " ″");
  return fmt::format("{}{}{} {}{}", figure.parameter, figure.of.empty() ? "" : " ", report::printable(figure.of),
                     figure.parameter == "chi2_per_dof" ? format_fixed(figure.value, 3)
                     : unit.empty()                     ? format_exact(figure.value)
                                                        : format_fixed(figure.value, 1),
                     unit);
}

void print_line(const store::CalibrationRow& row) {
  const Calibration& c = row.calibration.value;
  fmt::print("{} {} {} {} {} {}{}\n", left(fmt::format("{}", row.calibration.id), 7),
             left(report::printable(c.measured_on), 11), left(c.kind, 11),
             left(report::printable(row.machine_name), 24), left(c.verdict, 17), report::printable(c.title),
             c.withdrawn ? " (withdrawn)" : "");
}

/// What is said beside the files, checked as a request would be.
json::Value about(const CalibrationArguments& a) {
  json::Value said = json::Value::object();
  said.add("title", a.title);
  said.add("measured_on", a.measured_on);
  said.add("notes", a.notes);
  if (a.machine_id != 0) said.add("machine", static_cast<double>(a.machine_id));
  if (a.instrument_id != 0) said.add("instrument", static_cast<double>(a.instrument_id));
  return said;
}

Result<int> keep(const CalibrationArguments& a) {
  if (a.plan.empty() == a.machine.empty())
    return fail(fmt::format("found {}, expected --plan of lines or --machine of the 21 errors",
                            a.plan.empty() ? "neither --plan nor --machine" : "both --plan and --machine"));
  if (!a.station.empty() && a.plan.empty()) return fail("found --station without --plan, expected both");
  AXIOMETRY_TRY(app::NewCalibration calibration, app::new_calibration_from(about(a)));
  calibration.kind = a.plan.empty() ? "volumetric" : "lines";
  const std::pair<const char*, const std::string&> named[] = {
      {"lengths", a.lengths}, {"plan", a.plan}, {"station", a.station}, {"machine", a.machine}};
  std::vector<std::string> bytes;
  bytes.reserve(std::size(named));
  for (const auto& [role, file] : named) {
    if (file.empty()) continue;
    AXIOMETRY_TRY(std::string read, app::whole_file(file));
    bytes.push_back(std::move(read));
    calibration.files.push_back({role, last_part(file), bytes.back()});
  }
  if (!a.options.empty()) {
    AXIOMETRY_TRY(const std::string text, app::whole_file(a.options));
    AXIOMETRY_TRY(calibration.options, app::in_file(json::parse(text), a.options));
  }
  AXIOMETRY_TRY(const auto archive, archive_at(a.address, {}));
  AXIOMETRY_TRY(const auto kept, app::keep_calibration(*archive, calibration, {"import", "axiometry store calibrate"}));
  const Calibration& c = kept.calibration.value;
  fmt::print("calibration {}: {}\n", kept.calibration.id, report::printable(c.title));
  if (!kept.same_files->empty())
    fmt::print("the same files are kept as calibration {} already\n", fmt::join(*kept.same_files, ", "));
  if (c.serious > 0) fmt::print("{}: the result should not be used as it is\n", counted(c.serious, "serious finding"));
  return c.serious > 0 || c.verdict == "does not conform" ? exit_exceeded : exit_done;
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
  const Calibration& c = kept.calibration.value;
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
  for (const store::KeptFigure& figure : c.figures) fmt::print("    {}\n", kept_figure_text(figure));
}

/// The files under their own names, none of which is there.
Result<void> export_files(const store::Store& archive, const app::KeptCalibration& kept, const std::string& folder) {
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

void add_calibrate(const Verb& store, int& exit_code) {
  const auto made = std::make_shared<CalibrationArguments>();
  Verb verb =
      store_verb(store, {"calibrate", "Evaluate lengths of a tracking interferometer and keep them with the result"},
                 exit_code, made, keep);
  verb->add_option("LENGTHS", made->lengths, "Lengths, as 'tracking evaluate' or 'volumetric identify' reads them")
      ->required();
  verb->add_option("--plan", made->plan, "Of lines: the plan whose lines were measured")->type_name("FILE");
  verb->add_option("--station", made->station, "Of lines: the station as it was located")->type_name("FILE");
  verb->add_option("--machine", made->machine, "Of the 21 errors: the machine, its tools and the instrument")
      ->type_name("FILE");
  verb->add_option("--options", made->options, "How it is evaluated, as JSON (docs/howto/keep-a-calibration.md)")
      ->type_name("FILE");
  verb->add_option("--title", made->title, "Title (as the files say)");
  verb->add_option("--measured-on", made->measured_on, "Date, 2026-01-31 (as the files say)")->type_name("DATE");
  verb->add_option("--notes", made->notes, "Notes");
  verb->add_option("--of-machine", made->machine_id, "Number of the machine in the archive (the one the files name)")
      ->type_name("N");
  verb->add_option("--instrument", made->instrument_id, "Number of the instrument in the archive")->type_name("N");
}

}  // namespace

void add_store_calibrations(const Verb& store, int& exit_code) {
  add_calibrate(store, exit_code);
  auto made = std::make_shared<CalibrationArguments>();
  Verb listed = store_verb(store, {"calibrations", "List calibrations, the newest first"}, exit_code, made, list_kept);
  listed->add_option("--text", made->text, "Only those with these words in title, notes, files or machine");
  listed->add_option("--kind", made->kind, "Only lines, or volumetric");
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
