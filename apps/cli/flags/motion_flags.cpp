// SPDX-License-Identifier: Apache-2.0
#include "cli/flags/motion_flags.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/app/files/number_list.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/plan/plan.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "cli/flags/option_text.h"

namespace axiometry::cli {
namespace {

using app::MotionChoices;
using error_motions::InstrumentUncertainty;
using error_motions::Reference;

/// Of what an optical square may depart by.
double checked_square(const char* option, double least, double x) {
  if (x >= least && x <= app::largest_square_arcsec) return x;
  throw UsageError(
      option, fmt::format("found {}, expected a number from {:.0f} to {:.0f}", x, least, app::largest_square_arcsec));
}

/// "0.4" or "0.4,1.5": a and b of U = a + b·L.
Result<InstrumentUncertainty> instrument_of(const std::string& given) {
  constexpr double largest = app::largest_motion_uncertainty;
  const std::size_t comma = given.find(',');
  const auto a = parse_number(given.substr(0, comma));
  const auto b = comma == std::string::npos ? std::optional(0.0) : parse_number(given.substr(comma + 1));
  if (a && b && *a >= 0.0 && *b >= 0.0 && *a <= largest && *b <= largest) return InstrumentUncertainty{*a, *b};
  return fail(fmt::format("found {}, expected A or A,B, numbers from 0 to {:.0f}", text::quoted(given), largest));
}

void add_line_flags(const Verb& verb, MotionChoices& choices, bool none) {
  add_read(verb,
           {"--reference", "LINE",
            none ? "Line that is removed: none, least-squares or end-points (none)"
                 : "Line that is removed: least-squares or end-points (least-squares)"},
           [&choices, none](const std::string& word) -> Result<void> {
             const auto reference = error_motions::parse_reference(word);
             if (!reference || (!none && *reference == Reference::none))
               return fail(fmt::format("found {}, expected {}least-squares or end-points", text::quoted(word),
                                       none ? "none, " : ""));
             choices.reference = *reference;
             return {};
           });
  add_read(verb,
           {"--instrument", "A[,B]",
            "Expanded uncertainty (k = 2) of a reading, in the unit of the results (um, urad or arcsec), and for each "
            "metre of travel"},
           [&choices](const std::string& given) -> Result<void> {
             AXIOMETRY_TRY(choices.instrument, instrument_of(given));
             return {};
           });
}

void add_error(const Verb& verb, MotionChoices& choices, const std::string& description) {
  add_read(verb, {"--error", "NAME", description}, [&choices](const std::string& name) -> Result<void> {
    AXIOMETRY_TRY(choices.error, motion_name(name));
    return {};
  });
}

void add_positive(const Verb& verb, MotionChoices& choices, const std::string& description) {
  add_read(verb, {"--positive", "SENSES", description}, [&choices](const std::string& given) -> Result<void> {
    choices.positive.clear();
    for (std::size_t begin = 0; begin <= given.size();) {
      const std::size_t end = std::min(given.find(',', begin), given.size());
      AXIOMETRY_TRY(const ReadingSense sense, reading_sense(given.substr(begin, end - begin)));
      choices.positive.push_back(sense);
      begin = end + 1;
    }
    return {};
  });
}

void add_square_flags(const Verb& verb, error_motions::SquarenessOptions& square) {
  add_number(verb, {"--square-error", "ARCSEC", "Error of the optical square in ″, which is added"},
             [&square](double x) {
               square.square_error_arcsec = checked_square("--square-error", -app::largest_square_arcsec, x);
             });
  add_number(verb, {"--square-uncertainty", "ARCSEC", "Its expanded uncertainty (k = 2) in ″"}, [&square](double x) {
    square.square_uncertainty_arcsec = checked_square("--square-uncertainty", 0.0, x);
  });
}

}  // namespace

void add_motion_flags(const Verb& verb, std::string_view kind, MotionFiles& given, MotionChoices& choices) {
  verb->add_option("--plan", given.plans,
                   kind == "squareness"
                       ? "The plans after which readings alone were taken, in their order (axiometry plan); twice, for "
                         "the first line and for the second"
                       : "The plan after which readings alone were taken, in its order (axiometry plan)")
      ->check(fault_of_empty_name)
      ->type_name("FILE")
      ->one_at_a_time();
  std::vector<std::string>& files = given.readings;
  if (kind == "straightness") {
    files.resize(1);
    verb->add_option("FILE", files[0], "Readings as CSV, or - for the standard input")->required();
    add_line_flags(verb, choices, false);
    add_error(verb, choices, "The error, such as EYX: straightness of X in the direction of Y (as the file says)");
    add_positive(verb, choices, "Which way the readings are positive, +Y or -Y (as the file says)");
  } else if (kind == "squareness") {
    files.resize(2);
    verb->add_option("FIRST", files[0], "Straightness of the first axis as CSV")->required();
    verb->add_option("SECOND", files[1], "Straightness of the second axis as CSV")->required();
    add_line_flags(verb, choices, false);
    add_positive(verb, choices, "Which way the readings of both lines are positive, such as +Y,-X (as the files say)");
    add_square_flags(verb, choices.square);
  } else {
    verb->add_option("FILE", files, "Readings as CSV, one file for each rotation")->required();
    add_line_flags(verb, choices, true);
    add_error(verb, choices, "The error of a single file, such as EAX: rotation of X about X (as the file says)");
    add_positive(verb, choices, "Which way the readings of each file are positive, such as +A,-B (as the files say)");
    add_read(verb, {"--offset", "DX,DY,DZ", "From the measured line to another point of the moving part, mm"},
             [&choices](const std::string& text) -> Result<void> {
               AXIOMETRY_TRY(choices.offset_mm, app::parse_vector(text));
               return app::check_offset(*choices.offset_mm);
             });
  }
}

void check_motion_flags(std::string_view kind, const MotionFiles& given, const MotionChoices& choices) {
  const auto& [files, plans] = given;
  if (choices.error && files.size() > 1)
    throw UsageError("--error", "found it with several files, expected one file, or # error: EAX in each");
  if (std::ranges::count(files, "-") > 1) {
    if (kind == "squareness")
      throw UsageError("SECOND", "found the standard input twice, expected a file for one of them");
    throw UsageError("FILE", "found the standard input twice, expected it once");
  }
  const std::size_t plans_expected = kind == "squareness" ? 2 : 1;
  if (!plans.empty() && plans.size() != plans_expected)
    throw UsageError("--plan", fmt::format("found {}, expected {}", plans.size(),
                                           plans_expected == 2 ? "2: for the first line and for the second" : "1"));
  if (std::ranges::count(plans, "-") + std::ranges::count(files, "-") > 1)
    throw UsageError("--plan", "found the standard input twice, expected it once");
  const auto& senses = choices.positive;
  if (senses.empty()) return;
  if (senses.size() != files.size())
    throw UsageError("--positive", fmt::format("found {}, expected {}: one for each file, separated by commas",
                                               senses.size(), files.size()));
  if (kind == "squareness" &&
      (senses[0].coordinate < 'X' || senses[1].coordinate < 'X' || senses[0].coordinate == senses[1].coordinate))
    throw UsageError("--positive", fmt::format("found {},{}, expected two different directions such as +Y,-X",
                                               senses[0].text(), senses[1].text()));
}

Result<std::vector<Plan>> plans_of_motion(const std::vector<std::string>& files) {
  std::vector<Plan> plans;
  for (const std::string& file : files) {
    AXIOMETRY_TRY(plans.emplace_back(), app::read_plan_file(file));
  }
  return plans;
}

Result<app::EvaluatedMotion> evaluated_motion(std::string_view kind, const std::vector<std::string>& files,
                                              const MotionChoices& choices) {
  std::vector<std::string> bytes;
  bytes.reserve(files.size());
  std::vector<app::GivenFile> given;
  for (const std::string& file : files) {
    AXIOMETRY_TRY(std::string read, app::file_bytes(file));
    bytes.push_back(std::move(read));
    given.push_back({file, bytes.back()});
  }
  return app::evaluate_motion(kind, given, choices);
}

}  // namespace axiometry::cli
