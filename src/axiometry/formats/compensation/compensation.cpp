// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/compensation/compensation.h"

#include <fmt/format.h>

#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/volumetric/field/machine_zero.h"
#include "axiometry/volumetric/field/unseen_reasons.h"

namespace axiometry::formats {
namespace {

/// On one line, whatever it holds.
std::string on_one_line(std::string_view name) {
  std::string line;
  for (const char c : name) line += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  return line;
}

}  // namespace

Result<const Compensation*> compensation_named(std::string_view id) {
  std::string known;
  for (const Compensation* compensation : compensation_table()) {
    if (compensation->id == id) return compensation;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", compensation->id);
  }
  return fail(fmt::format("found the table {}, expected one of {}", text::quoted(id), known));
}

Result<std::string> written_table(const Compensation& compensation, const CompensationRequest& request,
                                  std::string_view warning) {
  AXIOMETRY_TRY(std::string text, compensation.write(request));
  if (warning.empty()) return text;
  return fmt::format("{} {}\n{}", compensation.comment, warning, text);
}

Result<void> check_all_told(const volumetric::ErrorModel& model) {
  const auto unseen = model.unseen_means();
  if (unseen.empty()) return {};
  return fail(
      fmt::format("found that the readings do not tell {}, expected all 21 errors: a control would take a number "
                  "that nobody measured",
                  volumetric::error_list(unseen)));
}

Result<volumetric::ErrorModel> errors_for_a_control(const volumetric::ErrorModel& model) {
  AXIOMETRY_TRY_VOID(check_all_told(model));
  return volumetric::at_machine_zero(model);
}

std::string functional_points_text(const volumetric::MachineModel& of_result, std::string_view mark) {
  std::string text =
      fmt::format("{} Functional point of every axis, from which its rotations act: the machine's zero\n", mark);
  if (volumetric::is_at_machine_zero(of_result)) return text;
  text += fmt::format("{} The result states its straightness and squareness at other points, mm:", mark);
  for (std::size_t a = 0; a < volumetric::axis_count; ++a) {
    const Vector3& c = of_result.functional_point_mm[a];
    text += fmt::format("{} {} {} {} {}", a == 0 ? "" : ",", "XYZ"[a], format_exact(c.x), format_exact(c.y),
                        format_exact(c.z));
  }
  return text + '\n';
}

std::string position_text(double position_mm) { return format_exact(std::round(1e6 * position_mm) / 1e6); }

std::string compensation_head(const volumetric::ErrorModel& model, std::string_view mark, TableDirections directions) {
  std::string text;
  const auto line = [&](std::string_view words) { text += fmt::format("{} {}\n", mark, words); };
  if (!model.machine().name.empty()) line("Machine: " + on_one_line(model.machine().name));
  line(fmt::format("Kinematic chain, workpiece to tool, F the foundation: {}", model.machine().chain.text()));
  for (std::size_t a = 0; a < volumetric::axis_count; ++a)
    line(fmt::format("{} was observed from {} to {} mm", "XYZ"[a], position_text(model.observed().lowest_mm[a]),
                     position_text(model.observed().highest_mm[a])));
  if (model.coefficients().reversal() != volumetric::Reversal::none)
    line(directions == TableDirections::means
             ? "The errors differ by direction; these are the means of both."
             : "The errors differ by direction: up is where the axis came to rest moving to larger positions.");
  if (const auto untold = model.unseen_reversals(); !untold.empty())
    line(fmt::format("Nothing tells by what the directions differ of {}.", volumetric::error_list(untold)));
  return text;
}

std::string effect_text(const volumetric::ErrorModel& model, std::string_view mark, const volumetric::Tool& tool,
                        const volumetric::TableEffect& effect, TableDirections directions) {
  const auto sizes = [](const volumetric::FieldSizes& s) {
    return fmt::format("largest {:.2f}, 95 % {:.2f}, mean {:.2f}", s.largest.value, s.percent_95, s.mean);
  };
  std::string text = fmt::format(
      "{0} Error of the tool point without rigid motion, tool {1}, um:\n{0}   before {2}\n"
      "{0}   with these tables, predicted, {3}\n",
      mark, on_one_line(tool.name), sizes(effect.before), sizes(effect.after));
  if (directions != TableDirections::means || model.coefficients().reversal() == volumetric::Reversal::none)
    return text;
  const auto half = volumetric::half_reversal_um(model, tool.offset_mm);
  return text + fmt::format("{}   and half of what the directions differ by, {}\n", mark,
                            half ? fmt::format("up to {:.2f}", *half) : "which is not told of all errors");
}

std::string effects_of_all_errors(const CompensationRequest& request, std::string_view mark,
                                  TableDirections directions) {
  std::string text;
  for (const volumetric::Tool& tool : request.model.machine().tools)
    if (const auto effect = volumetric::effect_of_all_errors(request.model, tool.offset_mm, request.nodes))
      text += effect_text(request.model, mark, tool, *effect, directions);
  return text;
}

}  // namespace axiometry::formats
