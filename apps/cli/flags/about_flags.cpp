// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/about_flags.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "axiometry/app/workbench/calibrations/calibration_json.h"
#include "axiometry/report/drawing/utf8.h"

namespace axiometry::cli {

void add_about_flags(const Verb& verb, AboutCalibration& about, const std::string& instrument_name) {
  verb->add_option("--title", about.title, "Title (as the files say)");
  verb->add_option("--measured-on", about.measured_on, "Date, 2026-01-31 (as the files say)")->type_name("DATE");
  verb->add_option("--notes", about.notes, "Notes");
  verb->add_option("--of-machine", about.machine_id, "Number of the machine in the archive (the one the files name)")
      ->type_name("N");
  verb->add_option(instrument_name, about.instrument_id, "Number of the instrument in the archive")->type_name("N");
}

Result<app::NewCalibration> new_calibration(const AboutCalibration& about) {
  json::Value said = json::Value::object();
  said.add("title", about.title);
  said.add("measured_on", about.measured_on);
  said.add("notes", about.notes);
  if (about.machine_id != 0) said.add("machine", static_cast<double>(about.machine_id));
  if (about.instrument_id != 0) said.add("instrument", static_cast<double>(about.instrument_id));
  return app::new_calibration_from(said);
}

void print_kept_calibration(const app::KeptCalibration& kept) {
  fmt::print("calibration {}: {}\n", kept.calibration.id, report::printable(kept.calibration.value.title));
  if (!kept.same_files->empty())
    fmt::print("the same files are kept as calibration {} already\n", fmt::join(*kept.same_files, ", "));
}

}  // namespace axiometry::cli
