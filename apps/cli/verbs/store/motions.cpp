// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/workbench/calibrations/calibrations.h"
#include "cli/flags/about_flags.h"
#include "cli/flags/motion_flags.h"
#include "cli/flags/store_flags.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/store/calibrations.h"

namespace axiometry::cli {
namespace {

struct KeptMotionArguments {
  std::string address, kind;
  MotionFiles files;
  app::MotionChoices choices;
  AboutCalibration about;
};

Result<int> keep_motion(const KeptMotionArguments& a) {
  check_motion_flags(a.kind, a.files, a.choices);
  AXIOMETRY_TRY(app::NewCalibration calibration, new_calibration(a.about));
  calibration.kind = a.kind;
  calibration.options = app::to_json(a.choices);
  std::vector<std::string> bytes;
  bytes.reserve(a.files.readings.size() + a.files.plans.size());  // what is kept points into it
  for (const std::string& file : a.files.readings) {
    AXIOMETRY_TRY(std::string read, app::file_bytes(file));
    bytes.push_back(std::move(read));
    calibration.files.push_back({app::readings_role(bytes.size()), app::base_name(file), bytes.back()});
  }
  for (std::size_t k = 0; k < a.files.plans.size(); ++k) {
    AXIOMETRY_TRY(std::string read, app::whole_file(a.files.plans[k]));
    bytes.push_back(std::move(read));
    calibration.files.push_back({app::plan_role(k + 1), app::base_name(a.files.plans[k]), bytes.back()});
  }
  AXIOMETRY_TRY(const auto archive, archive_at(a.address, {}));
  AXIOMETRY_TRY(const auto kept,
                app::keep_calibration(*archive, calibration, {"import", fmt::format("axiometry store {}", a.kind)}));
  print_kept_calibration(kept);
  return exit_done;
}

void add_kept_motion(const Verb& store, const char* kind, const char* description, const char* footer, int& exit_code) {
  const auto made = std::make_shared<KeptMotionArguments>();
  made->kind = kind;
  Verb verb = store_verb(store, {kind, description}, exit_code, made, keep_motion);
  verb->footer(footer);
  add_motion_flags(*verb, kind, made->files, made->choices);
  add_about_flags(*verb, made->about, "--of-instrument");
}

}  // namespace

void add_store_motions(const Verb& store, int& exit_code) {
  add_kept_motion(
      store, "straightness", "Evaluate a straightness and keep its readings with the result",
      R"(What is kept is no test of positions: it is among the calibrations, with its files, options and versions.
Examples:
  axiometry store straightness x-in-y.csv --positive +Y --instrument 0.4,0.5
  axiometry store calibrations --kind straightness)",
      exit_code);
  add_kept_motion(store, "angles", "Evaluate roll, pitch and yaw and keep their readings with the result",
                  R"(Example:
  axiometry store angles roll.csv pitch.csv yaw.csv --offset 0,0,250)",
                  exit_code);
  add_kept_motion(store, "squareness", "Evaluate the squareness of two axes and keep both lines with the result",
                  R"(Example:
  axiometry store squareness x-in-y.csv y-in-x.csv --positive +Y,-X --square-error 0.4)",
                  exit_code);
}

}  // namespace axiometry::cli
