// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/error_motions/motion_choices.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/app/files/request_members.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"

namespace axiometry::app {
namespace {

using error_motions::Reference;
using formats::JsonMembers;
using json::Value;

constexpr std::size_t most_angles = 18;  // as many as errors of a machine

Result<double> number_within(const Value& value, std::string_view name, double least, double most) {
  AXIOMETRY_TRY(const double number, formats::number_in(value, name));
  if (number >= least && number <= most) return number;
  return fail(fmt::format("{}: found {}, expected a number from {} to {}", name, format_exact(number),
                          format_exact(least), format_exact(most)),
              value.at());
}

Result<void> take_instrument(JsonMembers& members, MotionChoices& choices) {
  const Value* value = members.optional("instrument");
  if (value == nullptr) return {};
  AXIOMETRY_TRY(const std::vector<Value>* parts, formats::items_in(*value, "instrument"));
  if (parts->empty() || parts->size() > 2)
    return fail(fmt::format("instrument: found {} numbers, expected A, or A and B", parts->size()), value->at());
  std::array<double, 2> stated{};
  for (std::size_t k = 0; k < parts->size(); ++k) {
    AXIOMETRY_TRY(stated[k], number_within((*parts)[k], "instrument", 0.0, largest_motion_uncertainty));
  }
  choices.instrument = error_motions::InstrumentUncertainty{stated[0], stated[1]};
  return {};
}

Result<void> take_senses(JsonMembers& members, MotionChoices& choices) {
  const Value* value = members.optional("positive");
  if (value == nullptr) return {};
  AXIOMETRY_TRY(const std::vector<Value>* list, formats::items_in(*value, "positive"));
  for (const Value& item : *list) {
    AXIOMETRY_TRY(const std::string text, formats::text_in(item, "positive"));
    AXIOMETRY_TRY(const ReadingSense sense, reading_sense(text));
    choices.positive.push_back(sense);
  }
  return {};
}

Result<void> take_names(JsonMembers& members, MotionChoices& choices) {
  if (const Value* value = members.optional("reference")) {
    AXIOMETRY_TRY(const std::string word, formats::text_in(*value, "reference"));
    choices.reference = error_motions::parse_reference(word);
    if (!choices.reference)
      return fail(fmt::format("reference: found {}, expected least-squares, end-points or none", text::quoted(word)),
                  value->at());
  }
  if (const Value* value = members.optional("error")) {
    AXIOMETRY_TRY(const std::string name, formats::text_in(*value, "error"));
    AXIOMETRY_TRY(choices.error, motion_name(name));
  }
  return {};
}

/// Of squareness the lines are of two axes, each with its own plan; the angles of an axis are read at the same stops.
Result<void> check_plans(bool square, const std::vector<Plan>& plans) {
  if (plans.empty()) return {};
  if (!square && plans.size() > 1) return fail(fmt::format("found {} plans, expected one", plans.size()));
  if (!square) return {};
  if (plans.size() != 2)
    return fail(fmt::format("plans for squareness: found {}, expected 2, one for each line", plans.size()));
  if (!plans[0].axis.name.empty() && plans[0].axis.name == plans[1].axis.name)
    return fail(
        fmt::format("found two plans of the axis {}, expected one of each axis", text::quoted(plans[0].axis.name)));
  return {};
}

/// A choice that a kind has no use for is refused, not passed over.
Result<void> check_choices(std::string_view kind, std::size_t files, const MotionChoices& c) {
  const auto refuse = [&](std::string_view what) {
    return fail(fmt::format("found {}, which {} has no use for; expected it to be left out", what, kind));
  };
  const bool square = kind == "squareness", angles = kind == "angles";
  if (c.offset_mm && !angles) return refuse("offset_mm");
  if (c.square.square_error_arcsec && !square) return refuse("square_error_arcsec");
  if (c.square.square_uncertainty_arcsec && !square) return refuse("square_uncertainty_arcsec");
  AXIOMETRY_TRY_VOID(check_plans(square, c.plans));
  if (c.error && files > 1) return fail("found error with several files, expected one file, or # error: in each");
  if (c.reference == Reference::none && !angles) return refuse("the reference none");
  if (!c.positive.empty() && c.positive.size() != files)
    return fail(fmt::format("found {} in positive, expected {}: one for each file", counted(c.positive.size(), "sense"),
                            files));
  if (square && !c.positive.empty()) {
    const char one = c.positive[0].coordinate, two = c.positive[1].coordinate;
    if (one < 'X' || two < 'X' || one == two)
      return fail(fmt::format("found {},{}, expected two different directions such as +Y,-X", c.positive[0].text(),
                              c.positive[1].text()));
  }
  return {};
}

Result<EvaluatedMotion> evaluated_square(std::span<const GivenFile> files, const MotionChoices& choices,
                                         const error_motions::MotionOptions& options) {
  SquarenessRequest request{.first = files[0].name, .second = files[1].name, .options = options};
  request.bytes = {files[0].bytes, files[1].bytes};
  if (!choices.plans.empty()) request.plans = {choices.plans[0], choices.plans[1]};
  request.square = choices.square;
  if (!choices.positive.empty()) request.senses = {choices.positive[0], choices.positive[1]};
  AXIOMETRY_TRY(SquarenessMeasurement measured, measure_squareness(request));
  return EvaluatedMotion(std::move(measured));
}

}  // namespace

Result<void> check_offset(Vector3 offset_mm) {
  for (std::size_t k = 0; k < 3; ++k)
    if (!(std::abs(offset_mm[k]) <= largest_offset_mm))
      return fail(fmt::format("found {:.12g} mm in the offset, expected {:.12g} mm at most: no machine is larger",
                              offset_mm[k], largest_offset_mm));
  return {};
}

Result<MotionChoices> motion_choices_from(const Value& options) {
  MotionChoices choices;
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(options, "options"));
  AXIOMETRY_TRY_VOID(take_names(members, choices));
  AXIOMETRY_TRY_VOID(take_instrument(members, choices));
  AXIOMETRY_TRY_VOID(take_senses(members, choices));
  if (const Value* value = members.optional("offset_mm")) {
    AXIOMETRY_TRY(choices.offset_mm, formats::vector_in(*value, "offset_mm"));
    if (auto possible = check_offset(*choices.offset_mm); !possible)
      return fail(fmt::format("offset_mm: {}", possible.error().message), value->at());
  }
  if (const Value* value = members.optional("square_error_arcsec")) {
    AXIOMETRY_TRY(choices.square.square_error_arcsec,
                  number_within(*value, "square_error_arcsec", -largest_square_arcsec, largest_square_arcsec));
  }
  if (const Value* value = members.optional("square_uncertainty_arcsec")) {
    AXIOMETRY_TRY(choices.square.square_uncertainty_arcsec,
                  number_within(*value, "square_uncertainty_arcsec", 0.0, largest_square_arcsec));
  }
  AXIOMETRY_TRY_VOID(members.finish());
  return choices;
}

Value to_json(const MotionChoices& c) {
  Value object = Value::object();
  if (c.reference) object.add("reference", error_motions::reference_key(*c.reference));
  if (c.instrument) object.add("instrument", Value::array({Value(c.instrument->a), Value(c.instrument->b_per_m)}));
  if (c.error) object.add("error", c.error->text());
  if (!c.positive.empty()) {
    Value& list = object.add("positive", Value::array());
    for (const ReadingSense& sense : c.positive) list.push(sense.text());
  }
  if (c.offset_mm) object.add("offset_mm", formats::vector_value(*c.offset_mm));
  if (c.square.square_error_arcsec) object.add("square_error_arcsec", *c.square.square_error_arcsec);
  if (c.square.square_uncertainty_arcsec) object.add("square_uncertainty_arcsec", *c.square.square_uncertainty_arcsec);
  return object;
}

bool is_motion_kind(std::string_view kind) {
  return kind == "straightness" || kind == "angles" || kind == "squareness";
}

Result<EvaluatedMotion> evaluate_motion(std::string_view kind, std::span<const GivenFile> files,
                                        const MotionChoices& choices) {
  if (!is_motion_kind(kind))
    return fail(fmt::format("found the kind {}, expected straightness, angles or squareness", text::quoted(kind)));
  const std::size_t least = kind == "squareness" ? 2 : 1;
  const std::size_t most = kind == "angles" ? most_angles : least;
  if (files.size() < least || files.size() > most)
    return fail(fmt::format("found {} for {}, expected {}",
                            counted(files.size(), "file of readings", "files of readings"), kind,
                            least == most ? fmt::format("{}", least) : fmt::format("{} to {}", least, most)));
  AXIOMETRY_TRY_VOID(check_choices(kind, files.size(), choices));
  const Reference usual = kind == "angles" ? Reference::none : Reference::least_squares;
  const error_motions::MotionOptions options{choices.reference.value_or(usual), choices.instrument};
  if (kind == "squareness") return evaluated_square(files, choices, options);
  AnglesRequest request{.files = {}, .offset_mm = choices.offset_mm};
  for (std::size_t k = 0; k < files.size(); ++k) {
    MotionRequest one{.file = files[k].name, .error = choices.error, .options = options};
    if (!choices.positive.empty()) one.sense = choices.positive[k];
    if (!choices.plans.empty()) one.plan = choices.plans.front();
    one.alone_with_plan = files.size() == 1;
    one.bytes = files[k].bytes;
    request.files.push_back(std::move(one));
  }
  if (kind == "straightness") {
    AXIOMETRY_TRY(MeasuredMotion measured, measure_straightness(request.files.front()));
    return EvaluatedMotion(std::move(measured));
  }
  AXIOMETRY_TRY(AnglesMeasurement measured, measure_angles(request));
  return EvaluatedMotion(std::move(measured));
}

Experiment present_motion(const EvaluatedMotion& evaluated, const report::Options& options, MotionOutputs outputs) {
  return std::visit([&](const auto& each) { return present(each, options, outputs); }, evaluated);
}

std::vector<const MeasuredMotion*> measured_files(const EvaluatedMotion& evaluated) {
  if (const auto* one = std::get_if<MeasuredMotion>(&evaluated)) return {one};
  if (const auto* square = std::get_if<SquarenessMeasurement>(&evaluated)) return {&square->first, &square->second};
  std::vector<const MeasuredMotion*> files;
  for (const MeasuredMotion& each : std::get<AnglesMeasurement>(evaluated).angles) files.push_back(&each);
  return files;
}

}  // namespace axiometry::app
