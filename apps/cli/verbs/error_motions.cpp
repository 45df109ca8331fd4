// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/motion_flags.h"
#include "cli/text/document_text.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

struct MotionArguments {
  std::string kind;
  MotionFiles files;
  app::MotionChoices choices;
  ExperimentArguments outputs;
};

/// What a terminal shows of the report.
report::Document short_document(report::Document document) {
  std::erase_if(document.sections, [](const report::Section& s) {
    return s.id == "method" || s.id == "figures" || s.id == "provenance" || s.id.starts_with("positions");
  });
  return document;
}

/// Measures, shows, writes; the outputs must not be among the files.
int run_motion(MotionArguments& arguments) {
  check_motion_flags(arguments.kind, arguments.files, arguments.choices);
  check_experiment_outputs(arguments.outputs);
  std::vector<app::InputFile> inputs;
  for (const auto* list : {&arguments.files.readings, &arguments.files.plans})
    for (const std::string& file : *list) inputs.push_back({file, false});
  app::OutputNames& names = arguments.outputs.outputs;
  names.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(names); !spared) return failed(spared.error(), exit_usage);
  auto plans = plans_of_motion(arguments.files.plans);
  if (!plans) return failed(plans.error());
  arguments.choices.plans = *std::move(plans);
  const auto measured = evaluated_motion(arguments.kind, arguments.files.readings, arguments.choices);
  if (!measured) return failed(measured.error());
  const app::Experiment experiment = app::present_motion(
      *measured, arguments.outputs.report, {.report = !names.reports.empty(), .json = !names.json.empty()});
  if (!arguments.outputs.quiet && names.json != "-")
    fmt::print("{}", document_text(short_document(experiment.document), arguments.outputs.report,
                                   Terminal(ColourChoice::automatic)));
  const auto written = app::write_outputs(experiment, names, arguments.outputs.report);
  return written ? exit_done : failed(written.error());
}

void add_motion_verb(const Verb& program, const std::string& kind, const std::string& description,
                     const std::string& footer, int& exit_code) {
  Verb verb = program.add_subcommand(kind, description);
  auto a = std::make_shared<MotionArguments>();
  a->kind = kind;
  add_motion_flags(*verb, kind, a->files, a->choices);
  add_experiment_flags(*verb, a->outputs);
  verb->callback([a, &exit_code] { exit_code = run_motion(*a); });
  verb->footer(footer);
}

}  // namespace

void add_straightness(const Verb& program, int& exit_code) {
  add_motion_verb(program, "straightness", "How far an axis strays across its way, about a reference line",
                  R"(The columns are position_mm,run,direction,straightness_um; # error: EYX above them names the error.
With --plan they are straightness_um alone, a row for each approach of axiometry plan, in its order.
Examples:
  axiometry straightness readings.csv --plan plan.json --error EYX
  axiometry straightness x-in-y.csv
  axiometry straightness x-in-y.csv --reference end-points --instrument 0.4,0.5 --report x.pdf)",
                  exit_code);
}

void add_squareness(const Verb& program, int& exit_code) {
  add_motion_verb(
      program, "squareness", "Squareness of two axes from the straightness of each",
      R"(The squareness is the slope of the second line less that of the first, plus the error of the optical square.
With --positive, or # positive: +Y above the columns of each file, it is that of the machine's axes, with its location
error C0Y, B0Z or A0Z, which axiometry volumetric assemble takes as C0Y=square.json.
With --plan, once for each line, the columns are straightness_um alone, a row for each approach in its order.
Examples:
  axiometry squareness x.csv y.csv --plan x.plan.json --plan y.plan.json --positive +Y,-X
  axiometry squareness x-in-y.csv y-in-x.csv --positive +Y,-X --json square.json
  axiometry squareness x-in-y.csv y-in-x.csv --square-error 0.4 --square-uncertainty 0.3
  axiometry squareness x-in-y.csv y-in-x.csv --reference end-points --json -)",
      exit_code);
}

void add_angles(const Verb& program, int& exit_code) {
  add_motion_verb(
      program, "angles", "Roll, pitch and yaw of an axis, and what they do at another point",
      R"(The columns are position_mm,run,direction,angle_urad (or angle_arcsec). An offset needs the names of the
errors; of the moving part its changes are EB·dz − EC·dy along X, EC·dx − EA·dz along Y, EA·dy − EB·dx along Z.
Examples:
  axiometry angles pitch.csv --error EBX
  axiometry angles roll.csv pitch.csv yaw.csv --offset 0,0,250 --report angles.pdf)",
      exit_code);
}

}  // namespace axiometry::cli
