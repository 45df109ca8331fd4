// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/tables/volume_compensation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <tuple>
#include <utility>

#include "axiometry/app/compensate/control_findings.h"
#include "axiometry/app/compensate/table_positions.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/rounded_text.h"
#include "axiometry/compensation/fit.h"
#include "axiometry/volumetric/field/field_rows.h"
#include "axiometry/volumetric/field/unseen_reasons.h"

namespace axiometry::app {
namespace {

using json::Value;
using volumetric::Approaches;
using volumetric::ErrorModel;

constexpr std::size_t places = 201;  // along the line: between what tables can hold
constexpr std::string_view axis_letters = "XYZ";

/// By direction of approach, or the mean of both; absent where the readings do not tell that of every place.
std::optional<LineOfVolume> line_by(const ErrorModel& model, const VolumeCompensationRequest& request, Vector3 tool_mm,
                                    bool by_direction) {
  LineOfVolume line;
  for (std::size_t k = 0; k < places; ++k) {
    Vector3 shares{0.5, 0.5, 0.5};
    shares[request.along] = static_cast<double>(k) / static_cast<double>(places - 1);
    const Vector3 q = volumetric::place_in(model.observed(), shares);
    line.positions_mm.push_back(q[request.along]);
    for (const auto& [values, u, direction] :
         {std::tuple(&line.up_um, &line.up_u_um, 1.0), std::tuple(&line.down_um, &line.down_u_um, -1.0)}) {
      Approaches approaches{};
      if (by_direction) approaches[request.along] = direction;
      const auto field = model.at(q, tool_mm, approaches);
      const auto& value = field.error_um[request.component];
      if (!value) return std::nullopt;
      values->push_back(*value);
      u->push_back(std::sqrt(field.covariance_um2[request.component][request.component]));
      line.largest_u_um = std::max(line.largest_u_um, u->back());
    }
  }
  return line;
}

Result<LineOfVolume> line_through_middle(const ErrorModel& model, const VolumeCompensationRequest& request,
                                         Vector3 tool_mm) {
  if (auto line = line_by(model, request, tool_mm, true)) return *std::move(line);
  auto line = line_by(model, request, tool_mm, false);
  if (!line)
    return fail(
        "found that the readings do not tell the error of the tool point with this tool, expected all of it: a "
        "control would take a number that nobody measured");
  for (const std::size_t e : model.unseen_reversals())
    if (e / volumetric::motion_count == request.along) line->untold_reversals.push_back(e);
  return *std::move(line);
}

Result<Series> series_of(const LineOfVolume& line) {
  std::vector<Position> targets;
  std::vector<double> deviations;
  for (const double position : line.positions_mm) targets.push_back(Position::native(position));
  deviations.insert(deviations.end(), line.up_um.begin(), line.up_um.end());
  deviations.insert(deviations.end(), line.down_um.begin(), line.down_um.end());
  return Series::make_dense(std::move(targets), 1, std::move(deviations));
}

/// Range of the displacements of both directions, with what a control adds.
double range_with(const LineOfVolume& line, const AxisCorrection* added) {
  double least = 0.0, most = 0.0;
  bool is_first = true;
  for (std::size_t k = 0; k < places; ++k)
    for (const Direction direction : {Direction::up, Direction::down}) {
      const double found = direction == Direction::up ? line.up_um[k] : line.down_um[k];
      const double value = found + (added == nullptr ? 0.0 : added->at(line.positions_mm[k], direction));
      least = is_first ? value : std::min(least, value);
      most = is_first ? value : std::max(most, value);
      is_first = false;
    }
  return most - least;
}

std::string errors_of(std::size_t along, std::size_t component) {
  std::string names = volumetric::error_name({along, component});
  constexpr std::array<std::pair<std::array<std::size_t, 2>, std::string_view>, 3> squares = {
      {{{1, 0}, "C0Y"}, {{2, 0}, "B0Z"}, {{2, 1}, "A0Z"}}};
  for (const auto& [pair, name] : squares)
    if (pair[0] == along && pair[1] == component) names += fmt::format(", {}", name);
  return names;
}

nc::AxisTableOptions table_options(const VolumeCompensationRequest& request) {
  nc::AxisTableOptions options = request.how.table;
  options.kind = AxisKind::linear;
  options.axis = request.how.axis.empty() ? std::string(1, axis_letters[request.along]) : request.how.axis;
  if (request.component != request.along && options.output_axis.empty())
    options.output_axis = std::string(1, axis_letters[request.component]);
  options.step = request.how.grid.step.value_or(0.0);
  return options;
}

Result<void> check_axes(const VolumeCompensationRequest& request, const nc::AxisTable& control) {
  const nc::AxisTableOptions options = table_options(request);
  const bool moves_another = !options.output_axis.empty() && options.output_axis != options.axis;
  if (moves_another != (request.component != request.along))
    return fail(fmt::format("found the axes {} and {} for a table that moves {} by the position of {}, expected {}",
                            options.axis, options.output_axis.empty() ? options.axis : options.output_axis,
                            axis_letters[request.component], axis_letters[request.along],
                            moves_another ? "one axis" : "two axes"));
  if (request.component == request.along || control.uses.output_axis) return {};
  return fail(
      fmt::format("found a table that moves {} by the position of {} for {}, expected one of the axis itself: "
                  "the format takes no other",
                  axis_letters[request.component], axis_letters[request.along], control.title));
}

Result<void> check_no_options_of_a_test(const CompensateRequest& how) {
  if (how.periodic == compensation::Periodic::keep && !how.period && !how.existing_in_inch) return {};
  return fail(
      "found options of a measured test (periodic, period, existing_unit), expected none: the 21 errors have no "
      "such part");
}

/// Where the table and the line that was observed do not end together.
void add_findings_of_ends(const std::vector<double>& nodes, const LineOfVolume& line, bool rolls_over,
                          std::vector<NamedFinding>& findings) {
  constexpr double printed_mm = 1e-3, much_beyond = 0.05;  // as of a measured test (compensation/suspicions.cpp)
  const double first = line.positions_mm.front(), last = line.positions_mm.back();
  const std::string ends =
      fmt::format("the table goes from {} to {} mm, what was observed from {} to {} mm", format_rounded(nodes.front()),
                  format_rounded(nodes.back()), format_rounded(first), format_rounded(last));
  const double beyond = std::max(0.0, nodes.front() - first) + std::max(0.0, last - nodes.back());
  if (beyond > printed_mm)
    findings.push_back({"volume-table-short", beyond > much_beyond * (last - first),
                        ends + (rolls_over ? ": over all of that the file holds the last value beyond its ends"
                                           : ": beyond its ends the control holds the last value")});
  if (nodes.front() < first - printed_mm || nodes.back() > last + printed_mm)
    findings.push_back({"volume-table-ends-held", true,
                        ends + ": there it holds the value at the end of what was observed, which nobody measured"});
}

std::vector<NamedFinding> findings_of(const VolumeCompensation& made, const std::vector<double>& nodes,
                                      bool count_said) {
  std::vector<NamedFinding> findings;
  if (nodes.size() > 1) add_findings_of_ends(nodes, made.line, made.control->limits.rolls_over, findings);
  if (!made.line.untold_reversals.empty())
    findings.push_back(
        {"volume-table-of-means", false,
         fmt::format("nothing tells by what the directions differ of {}: the table holds the mean of both on this "
                     "line, and what they differ by stays beside what remains here",
                     volumetric::error_list(made.line.untold_reversals))});
  if (made.line_before_um < 4.0 * made.line.largest_u_um)
    findings.push_back(
        {"volume-table-of-uncertainty", true,
         fmt::format("the displacements on the line differ by {:.2f} µm, and each is known to ±{:.2f} µm (k = 2): the "
                     "table is mostly what the readings do not tell",
                     made.line_before_um, 2.0 * made.line.largest_u_um)});
  if (made.effect.after.percent_95 > made.effect.before.percent_95)
    findings.push_back(
        {"volume-not-better", true,
         fmt::format("the line through the middle becomes better, and the volume not: 95 % of the tool point's errors "
                     "lie below {:.2f} µm with this table alone, {:.2f} µm without",
                     made.effect.after.percent_95, made.effect.before.percent_95)});
  std::ranges::move(findings_of_control(*made.control, made.options, made.applied, {.said = count_said}),
                    std::back_inserter(findings));
  return findings;
}

Value sizes_value(const volumetric::FieldSizes& sizes) {
  Value value = Value::object();
  value.add("largest", sizes.largest.value);
  value.add("percent_95", sizes.percent_95);
  value.add("mean", sizes.mean);
  return value;
}

}  // namespace

Result<VolumeCompensation> compensate_volume(const VolumeCompensationRequest& request) {
  AXIOMETRY_TRY_VOID(check_request(request.how));
  AXIOMETRY_TRY(const KeptModel kept, kept_model(request.result));
  return in_file(compensate_volume(kept, request), request.result);
}

Result<VolumeCompensation> compensate_volume(const KeptModel& kept, const VolumeCompensationRequest& request) {
  VolumeCompensationRequest warned = request;
  warned.how.table.warning = warning_of(kept.against);
  AXIOMETRY_TRY(VolumeCompensation made, compensate_volume(kept.model, warned));
  const std::string_view begin = std::string_view(warned.how.table.warning).substr(0, 19);
  if (!begin.empty() && !made.text.contains(begin))
    made.findings.push_back(
        {"volume-table-without-warning", false,
         "the file of the table has no comments: it does not say itself that the result it was made "
         "from should not be used"});
  put_first(kept.against, made.findings);
  made.result = request.result;
  made.result_sha256 = kept.sha256;
  return made;
}

Result<VolumeCompensation> compensate_volume(const ErrorModel& model, const VolumeCompensationRequest& request) {
  AXIOMETRY_TRY_VOID(check_request(request.how));
  AXIOMETRY_TRY_VOID(check_no_options_of_a_test(request.how));
  AXIOMETRY_TRY(const nc::AxisTable* control, nc::axis_table_named(request.how.control));
  AXIOMETRY_TRY_VOID(check_axes(request, *control));
  if (control->limits.points == 2 && is_wished(request.how.grid))
    return fail(fmt::format("found positions of a table for {}, expected none: it has one straight line everywhere",
                            control->title));
  AXIOMETRY_TRY(const std::size_t tool, tool_of_model(model, request.tool));
  const Vector3 tool_mm = model.machine().tools[tool].offset_mm;
  const nc::AxisTableOptions options = table_options(request);
  AXIOMETRY_TRY(LineOfVolume line, line_through_middle(model, request, tool_mm));
  AXIOMETRY_TRY(const Series series, series_of(line));
  AXIOMETRY_TRY(const std::vector<double> nodes,
                table_positions(*control, options.reference, request.how.grid, line.positions_mm));
  const TableCurves curves = request.how.curves.value_or(control->curves);
  AXIOMETRY_TRY(compensation::Fit fit, compensation::fit_correction(series, options.kind,
                                                                    {nodes, curves, request.how.method,
                                                                     request.how.smooth, request.how.hold_ends}));
  const double zero = std::clamp(options.reference, nodes.front(), nodes.back());
  AXIOMETRY_TRY(fit.correction,
                compensation::with_zero_at(fit.correction,
                                           control->limits.zero_upwards ? TableCurves::with_backlash : curves, zero));
  AXIOMETRY_TRY(std::string text, write_over_targets(*control, fit.correction, series, options));
  AXIOMETRY_TRY(AxisCorrection applied, in_file(nc::read_table(*control, text, options), "the table that was made"));
  const double before = range_with(line, nullptr), after = range_with(line, &applied);
  if (!(after < before))
    return fail(
        fmt::format("found that the axis would not become better by this table: displacements on the line "
                    "differ by {:.2f} µm with it, by {:.2f} µm without; no table is written",
                    after, before));
  const auto effect = volumetric::table_effect(
      model, tool_mm, std::max<std::size_t>(2, std::min<std::size_t>(nodes.size(), 41)), [&](Vector3 q) {
        Vector3 taken{};
        const double position = q[request.along];
        taken[request.component] = -0.5 * (applied.at(position, Direction::up) + applied.at(position, Direction::down));
        return taken;
      });
  if (!effect)
    return fail(
        "found that the readings do not tell the error of the tool point with this tool, expected all of it: a "
        "control would take a number that nobody measured");
  VolumeCompensation made{control,
                          options,
                          std::move(text),
                          std::move(applied),
                          errors_of(request.along, request.component),
                          model.machine().name,
                          model.machine().tools[tool].name,
                          request.along,
                          request.component,
                          std::move(line),
                          before,
                          after,
                          *effect,
                          {}};
  made.findings = findings_of(made, nodes, request.how.resolution_said);
  return made;
}

Value to_json(const VolumeCompensation& made) {
  Value root = Value::object();
  root.add("control", made.control->id);
  root.add("axis", made.options.axis);
  root.add("output_axis", made.options.output_axis.empty() ? made.options.axis : made.options.output_axis);
  root.add("errors", made.errors);
  root.add("unit", deviation_unit_key(made.options.kind));
  root.add("sign", nc::sign_of(*made.control, made.options));
  root.add("turned_sign", made.options.turned_sign);
  root.add("table", nodes_to_json(made.applied));
  Value& line = root.add("line_range", Value::object());
  line.add("before", made.line_before_um);
  line.add("after", made.line_after_um);
  line.add("u", made.line.largest_u_um);
  Value& volume = root.add("volume", Value::object());
  volume.add("before", sizes_value(made.effect.before));
  volume.add("after", sizes_value(made.effect.after));
  root.add("findings", findings_value(made.findings));
  return root;
}

}  // namespace axiometry::app
