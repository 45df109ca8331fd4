// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/error_motions/motion_evaluation.h"
#include "axiometry/app/files/number_list.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/text/document_text.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

using error_motions::InstrumentUncertainty;
using error_motions::MotionOptions;
using error_motions::Reference;

/// What the three verbs share.
struct MotionArguments {
  std::vector<std::string> files;
  MotionOptions options;
  ExperimentArguments outputs;
};

/// "0.4" or "0.4,1.5": a and b of U = a + b·L.
constexpr double largest_uncertainty = 1e6;  // µm, µrad or ″; no instrument has more
constexpr double largest_square = 3600.0;    // ″: a degree

/// Of what an optical square may depart by.
double checked_square(const char* option, double least, double x) {
  if (x >= least && x <= largest_square) return x;
  throw UsageError(option, fmt::format("found {}, expected a number from {:.0f} to {:.0f}", x, least, largest_square));
}

Result<InstrumentUncertainty> instrument_of(const std::string& given) {
  const std::size_t comma = given.find(',');
  const auto a = parse_number(given.substr(0, comma));
  const auto b = comma == std::string::npos ? std::optional(0.0) : parse_number(given.substr(comma + 1));
  if (a && b && *a >= 0.0 && *b >= 0.0 && *a <= largest_uncertainty && *b <= largest_uncertainty)
    return InstrumentUncertainty{*a, *b};
  return fail(
      fmt::format("found {}, expected A or A,B, numbers from 0 to {:.0f}", text::quoted(given), largest_uncertainty));
}

void add_line_flags(const Verb& verb, MotionOptions& options, bool none) {
  add_read(verb,
           {"--reference", "LINE",
            none ? "Line that is removed: none, least-squares or end-points (none)"
                 : "Line that is removed: least-squares or end-points (least-squares)"},
           [&options, none](const std::string& word) -> Result<void> {
             const auto reference = error_motions::parse_reference(word);
             if (!reference || (!none && *reference == Reference::none))
               return fail(fmt::format("found {}, expected {}least-squares or end-points", text::quoted(word),
                                       none ? "none, " : ""));
             options.reference = *reference;
             return {};
           });
  add_read(verb,
           {"--instrument", "A[,B]",
            "Expanded uncertainty (k = 2) of a reading, in the unit of the readings, and for each metre of travel"},
           [&options](const std::string& given) -> Result<void> {
             AXIOMETRY_TRY(options.instrument, instrument_of(given));
             return {};
           });
}

Flag add_error(const Verb& verb, std::optional<MotionName>& error, const std::string& description) {
  return add_read(verb, {"--error", "NAME", description}, [&error](const std::string& name) -> Result<void> {
    AXIOMETRY_TRY(error, motion_name(name));
    return {};
  });
}

/// What a terminal shows of the report.
report::Document short_document(report::Document document) {
  std::erase_if(document.sections, [](const report::Section& s) {
    return s.id == "method" || s.id == "figures" || s.id.starts_with("positions");
  });
  return document;
}

/// Measures, shows, writes; the outputs must not be among the files.
template <typename Measure>
int run_motion(MotionArguments& arguments, const Measure& measure) {
  check_experiment_outputs(arguments.outputs);
  std::vector<app::InputFile> inputs;
  for (const std::string& file : arguments.files) inputs.push_back({file, false});
  app::OutputNames& names = arguments.outputs.outputs;
  names.inputs = app::InputFiles(inputs);
  if (const auto spared = app::check_inputs_spared(names); !spared) return failed(spared.error(), exit_usage);
  const auto measured = measure();
  if (!measured) return failed(measured.error());
  const app::Experiment experiment = app::present(*measured, arguments.outputs.report,
                                                  {.report = !names.reports.empty(), .json = !names.json.empty()});
  if (!arguments.outputs.quiet && names.json != "-")
    fmt::print("{}", document_text(short_document(experiment.document), arguments.outputs.report,
                                   Terminal(ColourChoice::automatic)));
  const auto written = app::write_outputs(experiment, names, arguments.outputs.report);
  return written ? exit_done : failed(written.error());
}

}  // namespace

void add_straightness(const Verb& program, int& exit_code) {
  struct Arguments : MotionArguments {
    std::string file;
    std::optional<MotionName> error;
  };
  Verb verb = program.add_subcommand("straightness", "How far an axis strays across its way, about a reference line");
  auto a = std::make_shared<Arguments>();
  verb->add_option("FILE", a->file, "Readings as CSV, or - for the standard input")->required();
  add_line_flags(*verb, a->options, false);
  add_error(*verb, a->error, "The error, such as EYX: straightness of X in the direction of Y (as the file says)");
  add_experiment_flags(*verb, a->outputs);
  verb->callback([a, &exit_code] {
    a->files = {a->file};
    exit_code = run_motion(*a, [&] { return app::measure_straightness({a->file, a->error, a->options}); });
  });
  verb->footer(R"(The columns are position_mm,run,direction,straightness_um; # error: EYX above them names the error.
Examples:
  axiometry straightness x-in-y.csv
  axiometry straightness x-in-y.csv --reference end-points --instrument 0.4,0.5 --report x.pdf)");
}

void add_squareness(const Verb& program, int& exit_code) {
  struct Arguments : MotionArguments {
    app::SquarenessRequest request;
  };
  Verb verb = program.add_subcommand("squareness", "Squareness of two axes from the straightness of each");
  auto a = std::make_shared<Arguments>();
  verb->add_option("FIRST", a->request.first, "Straightness of the first axis as CSV")->required();
  verb->add_option("SECOND", a->request.second, "Straightness of the second axis as CSV")->required();
  add_line_flags(*verb, a->options, false);
  auto& square = a->request.square;
  add_number(
      *verb, {"--square-error", "ARCSEC", "Error of the optical square in ″, which is added"},
      [&square](double x) { square.square_error_arcsec = checked_square("--square-error", -largest_square, x); });
  add_number(*verb, {"--square-uncertainty", "ARCSEC", "Its expanded uncertainty (k = 2) in ″"}, [&square](double x) {
    square.square_uncertainty_arcsec = checked_square("--square-uncertainty", 0.0, x);
  });
  add_experiment_flags(*verb, a->outputs);
  verb->callback([a, &exit_code] {
    if (a->request.first == "-" && a->request.second == "-")
      throw UsageError("SECOND", "found the standard input twice, expected a file for one of them");
    a->files = {a->request.first, a->request.second};
    a->request.options = a->options;
    exit_code = run_motion(*a, [&] { return app::measure_squareness(a->request); });
  });
  verb->footer(
      R"(The squareness is the slope of the second line less that of the first, plus the error of the optical square.
Examples:
  axiometry squareness x-in-y.csv y-in-x.csv --square-error 0.4 --square-uncertainty 0.3
  axiometry squareness x-in-y.csv y-in-x.csv --reference end-points --json -)");
}

void add_angles(const Verb& program, int& exit_code) {
  struct Arguments : MotionArguments {
    std::optional<MotionName> error;
    std::optional<Vector3> offset_mm;
  };
  Verb verb = program.add_subcommand("angles", "Roll, pitch and yaw of an axis, and what they do at another point");
  auto a = std::make_shared<Arguments>();
  a->options.reference = Reference::none;
  verb->add_option("FILE", a->files, "Readings as CSV, one file for each rotation")->required();
  add_line_flags(*verb, a->options, true);
  add_error(*verb, a->error, "The error of a single file, such as EAX: rotation of X about X (as the file says)");
  add_read(*verb, {"--offset", "DX,DY,DZ", "From the measured line to another point of the moving part, mm"},
           [a](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(a->offset_mm, app::parse_vector(text));
             return {};
           });
  add_experiment_flags(*verb, a->outputs);
  verb->callback([a, &exit_code] {
    if (a->error && a->files.size() > 1)
      throw UsageError("--error", "found it with several files, expected one file, or # error: EAX in each");
    if (std::ranges::count(a->files, "-") > 1)
      throw UsageError("FILE", "found the standard input twice, expected it once");
    app::AnglesRequest request{.files = {}, .offset_mm = a->offset_mm};
    for (const std::string& file : a->files) request.files.push_back({file, a->error, a->options});
    exit_code = run_motion(*a, [&] { return app::measure_angles(request); });
  });
  verb->footer(
      R"(The columns are position_mm,run,direction,angle_urad (or angle_arcsec). An offset needs the names of the
errors; of the moving part its changes are EB·dz − EC·dy along X, EC·dx − EA·dz along Y, EA·dy − EB·dx along Z.
Examples:
  axiometry angles pitch.csv --error EBX
  axiometry angles roll.csv pitch.csv yaw.csv --offset 0,0,250 --report angles.pdf)");
}

}  // namespace axiometry::cli
