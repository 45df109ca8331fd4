// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/length_flags.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "axiometry/app/recordings/capture_text.h"
#include "axiometry/app/volumetric/identify_options.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "cli/flags/option_text.h"
#include "cli/flags/reading_flags.h"

namespace axiometry::cli {
namespace {

using volumetric::IdentifyOptions;

void add_break_threshold(const Verb& verb, app::TrackingEvaluateOptions& options) {
  constexpr const char* group = "Input";
  add_number(verb,
             {"--break-threshold", "MM",
              "A jump of the lengths above it is a break of the beam (20 µm, more where "
              "the readings scatter)"},
             [&options](double x) {
               if (!(x > 0.0 && x <= 1e6))
                 throw UsageError("--break-threshold",
                                  fmt::format("found {}, expected a length above 0 mm", format_exact(x)));
               options.break_threshold_mm = x;
             })
      ->group(group);
}

void add_line_tolerances(const Verb& verb, app::TrackingEvaluateOptions& options, std::string& table) {
  constexpr const char* group = "Tolerances";
  verb.add_option_function<std::vector<std::string>>(
          "--tolerance",
          [&options](const std::vector<std::string>& texts) {
            for (const std::string& text : texts)
              if (auto added = app::add_tolerance(text, options); !added)
                throw UsageError("--tolerance", added.error().message);
          },
          "Limit of a parameter of all lines, A=10um, or of one, xy:E=20um; exit code 3 when a line does not conform; "
          "may be repeated")
      ->type_name("[LINE:]PARAMETER=LIMIT")
      ->one_at_a_time()
      ->group(group);
  verb.add_option("--tolerance-table", table, "Limits by travel from a CSV file, as evaluate has it")
      ->check(fault_of_empty_name)
      ->type_name("FILE[:NAME]")
      ->group(group);
  add_read(verb, {"--rule", "RULE", "How the uncertainty counts: simple, iso14253-1 or guard-band=WIDTH"},
           [&options](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(options.tolerance.rule, app::parse_rule(text));
             return {};
           })
      ->group(group);
}

void add_model(const Verb& verb, IdentifyOptions& options) {
  constexpr const char* group = "Model";
  add_read(verb, {"--curves", "KIND", "What error motions are made of: b-spline, legendre or nodes (b-spline)"},
           [&options](const std::string& word) -> Result<void> {
             AXIOMETRY_TRY(options.curves, app::parse_curves(word));
             return {};
           })
      ->group(group);
  add_read(verb, {"--spans", "N|X,Y,Z", "Spans of the curves, or their degree (as many as the lengths support)"},
           [&options](const std::string& text) -> Result<void> {
             AXIOMETRY_TRY(options.sizes, app::parse_spans(text));
             return {};
           })
      ->group(group);
  add_read(verb, {"--reversal", "MODEL", "How the directions of an axis differ: none, constant or curves (none)"},
           [&options](const std::string& word) -> Result<void> {
             AXIOMETRY_TRY(options.reversal, app::parse_reversal(word));
             return {};
           })
      ->group(group);
  add_read(
      verb,
      {"--smoothness", "none|auto|UM[,URAD]",
       "By how much slopes of curves change over an axis, standard deviation of displacements and rotations; auto: "
       "as the lengths of all let it appear (none)"},
      [&options](const std::string& text) -> Result<void> {
        AXIOMETRY_TRY(options.smoothness, app::parse_smoothness(text));
        return {};
      })
      ->group(group);
  add_read(verb,
           {"--drift", "MODEL", "Drift of the dead paths: auto (where residuals demand it), none or linear (auto)"},
           [&options](const std::string& word) -> Result<void> {
             AXIOMETRY_TRY(options.drift, app::parse_drift(word));
             return {};
           })
      ->group(group);
  verb.add_flag_callback(
          "--no-outliers", [&options] { options.find_outliers = false; },
          "Set no reading aside, however far it lies from what the others predict")
      ->group(group);
  verb.add_flag_callback(
          "--no-part-scales", [&options] { options.find_part_scales = false; },
          "Take all stations and tools for measured at one temperature, whatever the lengths show")
      ->group(group);
}

}  // namespace

void add_length_switches(const Verb& verb, const std::function<void()>& reversed,
                         const std::function<void()>& no_breaks) {
  constexpr const char* group = "Input";
  verb.add_flag_callback("--reversed", reversed, "The lengths shown fall where the reflector recedes")->group(group);
  verb.add_flag_callback("--no-breaks", no_breaks,
                         "Look for no breaks of the beam but those that the column segment states")
      ->group(group);
}

void add_lines_flags(const Verb& verb, app::TrackingEvaluateOptions& options, std::string& table) {
  add_metadata_flag(verb, options.metadata,
                    "Metadata of all lines over what the file says, such as machine.name='Mill 5'");
  add_break_threshold(verb, options);
  add_line_tolerances(verb, options, table);
}

void add_identify_flags(const Verb& verb, app::IdentifyChoices& choices) {
  add_read(verb, {"--parts", "N,N,…", "Part of the plan that each recording is, in their order, or 1-4 of several"},
           [&choices](const std::string& text) -> Result<void> {
             for (const std::string_view part : text::split(text, ',')) {
               AXIOMETRY_TRY(const app::PartRange parts, app::parse_part_range(part));
               choices.parts.push_back(parts);
             }
             return {};
           })
      ->group("Input");
  add_model(verb, choices.model);
}

app::RecordingTexts given_recording_texts(const Verb& verb) {
  app::RecordingTexts texts;
  for (const app::CaptureOption& option : app::capture_options()) {
    const auto flag = verb.find_option(std::string(option.name));
    if (!flag || flag->count() == 0) continue;
    texts.emplace_back(option.name.substr(2), option.values.empty() ? "1" : flag->results().back());
  }
  return texts;
}

}  // namespace axiometry::cli
