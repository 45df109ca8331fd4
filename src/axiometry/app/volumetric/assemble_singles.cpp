// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/assemble_singles.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "axiometry/app/error_motions/motion_evaluation.h"
#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/app/volumetric/result_model.h"
#include "axiometry/base/number_text.h"
#include "axiometry/base/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/formats/volumetric/machine_json.h"
#include "axiometry/formats/volumetric/volumetric_result_json.h"
#include "axiometry/report/figures/error_motions.h"
#include "axiometry/report/translated.h"

namespace axiometry::app {
namespace {

using json::Value;
using report::Align;
using report::plain;
using volumetric::ErrorMotion;
using volumetric::SingleMotion;

/// As measured motions remark it, to which no instrument is told here.
constexpr std::string_view no_instrument_remark = "no uncertainty of the instrument is stated: U does not hold it";
constexpr double single_urad_per_arcsec = std::numbers::pi / 180.0 / 3600.0 * 1e6;

std::optional<volumetric::Squareness> squareness_named(std::string_view name) {
  const auto found = std::ranges::find(volumetric::squareness_names, name);
  if (found == volumetric::squareness_names.end()) return std::nullopt;
  return static_cast<volumetric::Squareness>(found - volumetric::squareness_names.begin());
}

/// Standard uncertainty of a mean: the scatter of n runs in each direction there is, and the instrument's.
std::optional<double> mean_u(const std::optional<double>& s_up, const std::optional<double>& s_down, std::size_t n_up,
                             std::size_t n_down, double instrument) {
  double variance = 0.0;
  int directions = 0;
  for (const auto& [s, n] : {std::pair{s_up, n_up}, std::pair{s_down, n_down}}) {
    if (n == 0) continue;
    ++directions;
    if (!s && instrument == 0.0) return std::nullopt;
    if (s) variance += *s * *s / static_cast<double>(n);
  }
  const double both = static_cast<double>(directions * directions);
  return std::sqrt(variance / both + instrument * instrument);
}

struct ReadSingle {
  SingleMotion motion;
  AssembledItem item;
  std::vector<std::string> remarks;
};

Error no_uncertainty(std::string_view name) {
  return Error{fmt::format("found one run of {} and no uncertainty of its instrument, expected more runs or that "
                           "uncertainty: nothing tells how well it is known",
                           name),
               {},
               {}};
}

Result<ReadSingle> read_positioning(const SingleItem& item, ErrorMotion error) {
  AXIOMETRY_TRY(Test test, read_test(item.file));
  const Metadata& metadata = test.metadata;
  if (metadata.axis.kind != AxisKind::linear)
    return std::unexpected(in_file(Error{"found a rotary axis, expected a test of a linear one", {}, {}}, item.file));
  const char letter = static_cast<char>('X' + error.axis);
  if (!metadata.axis.name.empty() && metadata.axis.name != std::string(1, letter))
    return std::unexpected(in_file(Error{fmt::format("found a test of axis {}, expected one of {} as {} is",
                                                     text::quoted(metadata.axis.name), letter, item.name),
                                         {},
                                         {}},
                                   item.file));
  ReadSingle read{{error, {}, {}, {}}, {item.name, item.file, test.provenance.sha256, test.series.run_count()}, {}};
  const iso230_2::Evaluation evaluation = iso230_2::evaluate(test.series);
  const auto number = [](const std::optional<Deviation>& d) {
    return d ? std::optional(d->in_native()) : std::optional<double>();
  };
  if (!item.instrument) read.remarks.emplace_back(no_instrument_remark);
  const bool both = test.series.has(Direction::up) && test.series.has(Direction::down);
  const double first = evaluation.positions.front().target.in_native();
  for (const iso230_2::PositionResult& p : evaluation.positions) {
    if (!p.mean_up && !p.mean_down) continue;
    const double at = p.target.in_native();
    if (both && !(p.mean_up && p.mean_down))
      return std::unexpected(in_file(
          Error{fmt::format("found {} mm approached from one side alone, expected both as at the other targets", at),
                {},
                {}},
          item.file));
    const double instrument = item.instrument ? item.instrument->standard(std::abs(at - first)) : 0.0;
    const auto u = mean_u(number(p.s_up), number(p.s_down), p.count_up, p.count_down, instrument);
    if (!u) return std::unexpected(in_file(no_uncertainty(item.name), item.file));
    read.motion.positions_mm.push_back(at);
    read.motion.values.push_back((p.mean ? *p.mean : p.mean_up ? *p.mean_up : *p.mean_down).in_native());
    read.motion.u.push_back(*u);
  }
  return read;
}

Result<ReadSingle> read_other(const SingleItem& item, ErrorMotion error) {
  MotionRequest request;
  request.file = item.file;
  AXIOMETRY_TRY(request.error, motion_name(item.name));
  AXIOMETRY_TRY(const MeasuredMotion measured,
                error.is_rotation() ? measure_angle(request) : measure_straightness(request));
  const double factor = measured.motion.unit == MotionUnit::arcsec ? single_urad_per_arcsec : 1.0;
  ReadSingle read{{error, {}, {}, {}}, {item.name, item.file, measured.sha256, measured.motion.runs}, {}};
  const auto& path = measured.motion.principal();
  const bool both = measured.motion.paths.size() > 1;
  const std::size_t n = measured.motion.runs;
  const double first = measured.motion.positions.front().position_mm;
  for (std::size_t i = 0; i < measured.motion.positions.size(); ++i) {
    const error_motions::MotionPosition& p = measured.motion.positions[i];
    const double instrument = item.instrument ? item.instrument->standard(std::abs(p.position_mm - first)) : 0.0;
    const auto scaled = [&](const std::optional<double>& s) {
      return s ? std::optional(factor * *s) : std::optional<double>();
    };
    const bool up = both || path.kind == error_motions::PathKind::up;
    const bool down = both || path.kind == error_motions::PathKind::down;
    const auto u = mean_u(scaled(p.s_up), scaled(p.s_down), up ? n : 0, down ? n : 0, instrument);
    if (!u) return std::unexpected(in_file(no_uncertainty(item.name), item.file));
    read.motion.positions_mm.push_back(p.position_mm);
    read.motion.values.push_back(factor * path.means[i]);
    read.motion.u.push_back(*u);
  }
  read.remarks = measured.remarks;
  if (item.instrument) std::erase(read.remarks, no_instrument_remark);
  return read;
}

/// Positions ascend; a test in the order of its targets may descend.
Result<void> put_in_order(SingleMotion& motion, const SingleItem& item) {
  if (motion.positions_mm.size() < 2)
    return std::unexpected(in_file(Error{"found one position, expected two or more", {}, {}}, item.file));
  std::vector<std::size_t> order(motion.positions_mm.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::sort(order, {}, [&](std::size_t k) { return motion.positions_mm[k]; });
  SingleMotion sorted{motion.error, {}, {}, {}};
  for (const std::size_t k : order) {
    sorted.positions_mm.push_back(motion.positions_mm[k]);
    sorted.values.push_back(motion.values[k]);
    sorted.u.push_back(motion.u[k]);
  }
  motion = std::move(sorted);
  return {};
}

Value instrument_to_json(const std::optional<error_motions::InstrumentUncertainty>& instrument) {
  if (!instrument) return {};
  Value object = Value::object();
  object.add("U_constant", instrument->a);
  object.add("U_per_m", instrument->b_per_m);
  return object;
}

/// Where the axes stood while each of them was measured.
Value stands_to_json(const std::array<std::optional<SingleStand>, 3>& stands) {
  Value object = Value::object();
  for (std::size_t a = 0; a < stands.size(); ++a) {
    if (!stands[a]) continue;
    Value& stand = object.add(std::string(1, static_cast<char>('X' + a)), Value::object());
    Value& axes = stand.add("axes_mm", Value::array());
    for (const double mm : {stands[a]->axes_mm.x, stands[a]->axes_mm.y, stands[a]->axes_mm.z}) axes.push(mm);
    stand.add("tool", stands[a]->tool.empty() ? Value() : Value(stands[a]->tool));
  }
  return object;
}

Value singles_to_json(const Assembled& a) {
  Value object = Value::object();
  object.add("result", "volumetric-assembled");
  Value& errors = object.add("errors", Value::array());
  for (std::size_t k = 0; k < a.items.size(); ++k) {
    const AssembledItem& item = a.items[k];
    Value& value = errors.push(Value::object());
    value.add("name", item.name);
    value.add("file", item.file.empty() ? Value() : Value(item.file));
    value.add("sha256", item.sha256.empty() ? Value() : Value(item.sha256));
    value.add("runs", item.runs > 0 ? Value(item.runs) : Value());
    value.add("u_largest", item.u_largest);
    value.add("instrument", instrument_to_json(a.request.items[k].instrument));
  }
  object.add("at", stands_to_json(a.request.stands));
  Value& findings = object.add("findings", Value::array());
  for (const std::string& finding : a.made.findings) findings.push(finding);
  Value& remarks = object.add("remarks", Value::array());
  for (const std::string& remark : a.remarks) remarks.push(remark);
  Value& machine = object.add("machine_source", Value::object());
  machine.add("file", a.request.machine);
  machine.add("sha256", a.machine_sha256);
  object.add("model", formats::error_model_value(a.made.model));
  object.add("program", program_to_json());
  return object;
}

/// Range of a curve and the largest uncertainty along it, from its nodes; absent where it has no number.
std::optional<std::pair<double, double>> extent_of(const volumetric::ErrorModel& model, ErrorMotion error) {
  const volumetric::CurveBasis& basis = model.coefficients().basis(error.axis);
  double lowest = 0.0, highest = 0.0, u = 0.0;
  for (std::size_t n = 0; n <= basis.size(); ++n) {
    const double share = static_cast<double>(n) / static_cast<double>(basis.size());
    const auto value = model.motion(error, basis.lower_mm() + share * (basis.upper_mm() - basis.lower_mm()));
    if (!value) return std::nullopt;
    lowest = n == 0 ? value->value : std::min(lowest, value->value);
    highest = n == 0 ? value->value : std::max(highest, value->value);
    u = std::max(u, value->u);
  }
  return std::pair{highest - lowest, u};
}

report::Table singles_table(const Assembled& a, const report::Options& options) {
  report::Table table;
  table.columns = {{plain("Error"), Align::start, true},
                   {plain("Range or value"), Align::decimal},
                   {plain("largest u"), Align::decimal},
                   {plain("Unit")},
                   {plain("File")}};
  for (const AssembledItem& item : a.items) {
    auto& row = table.rows.emplace_back();
    row.push_back({report::verbatim(item.name)});
    const auto error = volumetric::error_motion_named(item.name);
    std::optional<std::pair<double, double>> shown;
    if (error) {
      shown = extent_of(a.made.model, *error);
    } else if (const auto value = a.made.model.squareness(*squareness_named(item.name))) {
      shown = std::pair{value->value, value->u};
    }
    for (const auto& number :
         {shown ? std::optional(shown->first) : std::nullopt, shown ? std::optional(shown->second) : std::nullopt})
      row.push_back(number ? number_cell(*number, 2, options) : report::TableCell{plain("–"), report::Tone::quiet});
    row.push_back(word_cell(error && !error->is_rotation() ? "µm" : "µrad"));
    row.push_back({report::verbatim(item.file)});
  }
  table.notes = {
      plain("In the axes of the machine, without constants and without the slope of straightness, rotations "
            "taken out of displacements by their levers. Uncertainties (k = 1): scatter of the means and, "
            "where it was stated, the instrument, independent from one position to the next.")};
  return table;
}

/// Of every axis of which an error was measured.
report::Section curves_section(const Assembled& a, const report::Options& options) {
  report::Section section{"curves", "Error motions over the travel", false, {}};
  for (std::size_t axis = 0; axis < 3; ++axis)
    if (std::ranges::any_of(a.items, [&](const AssembledItem& item) {
          const auto error = volumetric::error_motion_named(item.name);
          return error && error->axis == axis;
        }))
      section.blocks.emplace_back(report::error_motion_figure(a.made.model, axis, options));
  return section;
}

}  // namespace

Result<SingleItem> parse_single(std::string_view text) {
  const std::size_t mark = text.find('=');
  const auto unknown = [&] {
    return fail(
        fmt::format("found {}, expected NAME=FILE such as EYX=straightness.csv, or squareness in µrad such as "
                    "C0Y=-12.5,1.2",
                    text::quoted(text)));
  };
  if (mark == std::string_view::npos || mark + 1 == text.size()) return unknown();
  SingleItem item;
  item.name = std::string(text.substr(0, mark));
  const std::string_view rest = text.substr(mark + 1);
  if (squareness_named(item.name)) {
    const std::size_t comma = rest.find(',');
    if (comma == std::string_view::npos) return unknown();
    const auto value = parse_number(rest.substr(0, comma)), U = parse_number(rest.substr(comma + 1));
    if (!value || !U || !(*U > 0.0) || !(std::abs(*value) <= 1e5) || !(*U <= 1e5)) return unknown();
    item.urad = *value;
    item.U_urad = *U;
    return item;
  }
  if (!volumetric::error_motion_named(item.name)) return unknown();
  item.file = std::string(rest);
  return item;
}

Result<Assembled> assemble_singles(const AssembleRequest& request) {
  AXIOMETRY_TRY(const std::string bytes, whole_file(request.machine));
  AXIOMETRY_TRY(formats::MachineFile machine, in_file(formats::read_machine(bytes), request.machine));
  std::vector<std::string> remarks = machine.remarks;
  std::vector<AssembledItem> items;
  volumetric::SingleErrors errors;
  for (const SingleItem& item : request.items) {
    if (std::ranges::find(items, item.name, &AssembledItem::name) != items.end())
      return fail(fmt::format("found {} twice, expected each error once", item.name));
    if (const auto which = squareness_named(item.name)) {
      errors.squareness.push_back({*which, item.urad, 0.5 * item.U_urad});
      items.push_back({item.name, {}, {}, 0, 0.5 * item.U_urad});
      continue;
    }
    const ErrorMotion error = *volumetric::error_motion_named(item.name);
    AXIOMETRY_TRY(ReadSingle read, error.is_positioning() ? read_positioning(item, error) : read_other(item, error));
    AXIOMETRY_TRY_VOID(put_in_order(read.motion, item));
    read.item.u_largest = *std::ranges::max_element(read.motion.u);
    for (const std::string& remark : read.remarks) remarks.push_back(fmt::format("{}: {}", item.name, remark));
    errors.motions.push_back(std::move(read.motion));
    items.push_back(std::move(read.item));
  }
  for (std::size_t a = 0; a < 3; ++a) {
    if (!request.stands[a]) continue;
    const auto& tools = machine.machine.tools;
    const auto tool = request.stands[a]->tool.empty() && tools.size() == 1
                          ? std::optional<std::size_t>(0)
                          : machine.machine.tool_named(request.stands[a]->tool);
    if (!tool)
      return fail(
          fmt::format("found the tool {}, expected one of the machine's", text::quoted(request.stands[a]->tool)));
    errors.places[a] = volumetric::SinglePlace{request.stands[a]->axes_mm, tools[*tool].offset_mm};
  }
  AXIOMETRY_TRY(volumetric::SingleModel made, volumetric::model_of_singles(std::move(machine.machine), errors));
  return Assembled{request, sha256(bytes), std::move(items), std::move(remarks), std::move(made)};
}

Experiment present(const Assembled& a, const report::Options& options) {
  Experiment experiment{experiment_document("Errors of a machine measured singly", "ISO 230-1, names of errors"),
                        singles_to_json(a)};
  report::Document& document = experiment.document;
  document.kind = "Measurement";
  document.running_head = report::translated(document.title, options);
  document.running_status = document.edition;
  document.identity = {{plain("Machine"), {report::verbatim(a.request.machine)}}};
  report::Section section{"errors", "Errors", true, {}};
  section.blocks.emplace_back(singles_table(a, options));
  document.sections.push_back(std::move(section));
  document.sections.push_back(curves_section(a, options));
  if (a.made.findings.empty() && a.remarks.empty()) return experiment;
  report::Section findings{"findings", "Findings", false, {}};
  for (const auto* list : {&a.made.findings, &a.remarks})
    for (const std::string& text : *list) findings.blocks.emplace_back(report::Paragraph{report::sentence(text)});
  document.sections.push_back(std::move(findings));
  return experiment;
}

}  // namespace axiometry::app
