// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/evaluate/tolerance_table.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/tracking/evaluate_options.h"
#include "axiometry/app/volumetric/plan_volume.h"
#include "axiometry/app/workbench/calibrations/calibrations.h"
#include "axiometry/base/counted.h"
#include "cli/failure.h"
#include "cli/flags/about_flags.h"
#include "cli/flags/capture_flags.h"
#include "cli/flags/length_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/store_flags.h"
#include "cli/flags/uncertainty_flags.h"
#include "cli/flags/verb.h"
#include "cli/verbs/commands.h"
#include "cli/verbs/store/calibrations.h"

namespace axiometry::cli {
namespace {

constexpr const char* calibrate_footer =
    R"(How lengths are evaluated is said as 'tracking evaluate' (of lines, with --plan) and 'volumetric identify' (of
the 21 errors, with --machine or the plan of 'volumetric plan') have it, or as JSON in --options; it is kept with them.
Exit code 3: a finding is serious, or a line does not conform; it is kept all the same.
Examples:
  axiometry store calibrate lengths.csv --plan seven.json --station located.json --tolerance E=20um
  axiometry store calibrate lengths.csv --machine machine.json --spans 8 --reversal constant
  axiometry store calibrate run1.csv run2.csv --plan plan.json --parts 1,2)";

struct CalibrateArguments {
  std::string address;
  std::vector<std::string> lengths;
  std::string plan, station, machine, tolerance_table, options;  // files
  AboutCalibration about;
  app::TrackingEvaluateOptions lines;
  app::IdentifyChoices volume;
  std::optional<Verb> verb;                      ///< this one, whose flags were given
  std::vector<std::string> of_lines, of_volume;  ///< flags of one kind alone
};

/// "lines" or "volumetric". Fails where the files do not say which.
Result<std::string> kind_of_calibration(const CalibrateArguments& a) {
  if (a.plan.empty() && a.machine.empty())
    return fail("found neither --plan nor --machine, expected --plan of lines or --machine of the 21 errors");
  if (a.plan.empty()) return std::string("volumetric");
  AXIOMETRY_TRY(const bool of_volume, app::is_volumetric_plan_file(a.plan));
  if (!of_volume && !a.machine.empty())
    return fail("found both --plan and --machine, expected --plan of lines or --machine of the 21 errors");
  return std::string(of_volume ? "volumetric" : "lines");
}

/// A flag that the other kind of calibration has is refused, not passed over.
Result<void> check_flags_of(const std::string& kind, const CalibrateArguments& a) {
  const bool of_lines = kind == "lines";
  for (const std::string& name : of_lines ? a.of_volume : a.of_lines)
    if (const auto flag = a.verb->find_option(name); flag && flag->count() > 0)
      return fail(fmt::format("found {}, which {} has no use for; expected it to be left out", name,
                              of_lines ? "a calibration of lines" : "a calibration of the 21 errors"));
  if (of_lines && a.lengths.size() > 1)
    return fail(fmt::format("found {} files of lengths for lines, expected one", a.lengths.size()));
  return {};
}

/// What flags say, or the file of options; never both, since one would be passed over.
Result<json::Value> options_of(const std::string& kind, const CalibrateArguments& a) {
  const app::RecordingTexts recording = given_recording_texts(*a.verb);
  const json::Value said = kind == "lines" ? app::to_json(a.lines, recording) : app::to_json(a.volume, recording);
  if (a.options.empty()) return said;
  for (const auto* names : {&a.of_lines, &a.of_volume})
    for (const std::string& name : *names)
      if (const auto flag = a.verb->find_option(name);
          flag && flag->count() > 0 && name != "--tolerance-table" && name != "--station" && name != "--machine")
        return fail(fmt::format("found {} beside --options, expected one of them", name));
  if (!said.members().empty())
    return fail(fmt::format("found {} beside --options, expected it in one of them", said.members().front().first));
  AXIOMETRY_TRY(const std::string text, app::whole_file(a.options));
  return app::in_file(json::parse(text), a.options);
}

struct NamedPart {
  std::string role, file;
};

std::vector<NamedPart> parts_of_calibration(const CalibrateArguments& a, const std::string& tolerances) {
  std::vector<NamedPart> parts;
  for (const std::string& file : a.lengths) parts.push_back({app::lengths_role(parts.size() + 1), file});
  for (const auto& [role, file] : {std::pair{"plan", &a.plan}, std::pair{"station", &a.station},
                                   std::pair{"machine", &a.machine}, std::pair{"tolerances", &tolerances}})
    if (!file->empty()) parts.push_back({role, *file});
  return parts;
}

Result<int> keep_lengths(const CalibrateArguments& given) {
  CalibrateArguments a = given;
  AXIOMETRY_TRY(const std::string kind, kind_of_calibration(a));
  if (!a.station.empty() && a.plan.empty()) return fail("found --station without --plan, expected both");
  AXIOMETRY_TRY_VOID(check_flags_of(kind, a));
  check_method_flags(*a.verb, a.lines.uncertainty);
  std::string tolerances;
  if (!a.tolerance_table.empty()) {
    auto table = app::parse_table_name(a.tolerance_table);
    tolerances = std::move(table.file);
    a.lines.tolerance.table_name = std::move(table.name);
  }
  AXIOMETRY_TRY(app::NewCalibration calibration, new_calibration(a.about));
  calibration.kind = kind;
  AXIOMETRY_TRY(calibration.options, options_of(kind, a));
  const std::vector<NamedPart> parts = parts_of_calibration(a, tolerances);
  std::vector<std::string> bytes;
  bytes.reserve(parts.size());
  for (const auto& [role, file] : parts) {
    AXIOMETRY_TRY(std::string read, app::whole_file(file));
    bytes.push_back(std::move(read));
    calibration.files.push_back({role, std::filesystem::path(file).filename().string(), bytes.back()});
  }
  AXIOMETRY_TRY(const auto archive, archive_at(a.address, {}));
  AXIOMETRY_TRY(const auto kept, app::keep_calibration(*archive, calibration, {"import", "axiometry store calibrate"}));
  const store::CalibrationRecord& c = kept.calibration.value;
  print_kept_calibration(kept);
  if (c.serious > 0) fmt::print("{}: the result should not be used as it is\n", counted(c.serious, "serious finding"));
  return c.serious > 0 || c.verdict == "does not conform" ? exit_exceeded
         : c.verdict == "undecided"                       ? exit_undecided
                                                          : exit_done;
}

/// The names that `add` adds to a verb.
template <typename Add>
std::vector<std::string> added_names(const Verb& verb, const Add& add) {
  const std::vector<std::string> before = option_names(verb);
  add();
  std::vector<std::string> names = option_names(verb);
  std::erase_if(names, [&](const std::string& name) { return std::ranges::find(before, name) != before.end(); });
  return names;
}

}  // namespace

void add_store_calibrate(const Verb& store, int& exit_code) {
  const auto made = std::make_shared<CalibrateArguments>();
  Verb verb =
      store_verb(store, {"calibrate", "Evaluate lengths of a tracking interferometer and keep them with the result"},
                 exit_code, made, keep_lengths);
  made->verb = verb;
  verb->footer(calibrate_footer);
  verb->add_option("LENGTHS", made->lengths, "Lengths, as 'tracking evaluate' or 'volumetric identify' reads them")
      ->required();
  verb->add_option("--plan", made->plan, "The plan whose lines were measured, or that of 'volumetric plan'")
      ->check(fault_of_empty_name)
      ->type_name("FILE");
  add_about_flags(*verb, made->about, "--instrument");
  verb->add_option("--options", made->options,
                   "How it is evaluated, as JSON in place of the flags below (docs/howto/keep-a-calibration.md)")
      ->check(fault_of_empty_name)
      ->type_name("FILE");
  made->of_lines = added_names(*verb, [&] {
    verb->add_option("--station", made->station, "Of lines: the station as it was located")
        ->check(fault_of_empty_name)
        ->type_name("FILE")
        ->group("Input");
    add_lines_flags(*verb, made->lines, made->tolerance_table);
    add_kept_method_flags(*verb, made->lines.uncertainty);
  });
  made->of_volume = added_names(*verb, [&] {
    verb->add_option("--machine", made->machine,
                     "Of the 21 errors: the machine, its tools and the instrument (those of the plan)")
        ->check(fault_of_empty_name)
        ->type_name("FILE")
        ->group("Input");
    add_identify_flags(*verb, made->volume);
  });
  add_length_switches(
      *verb, [raw = made.get()] { raw->lines.reversed = raw->volume.recording.matcher.reversed = true; },
      [raw = made.get()] { raw->lines.find_breaks = raw->volume.model.find_breaks = false; });
  add_length_recording_flags(*verb, made->volume.recording);
}

}  // namespace axiometry::cli
