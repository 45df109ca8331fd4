// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/calibrations/calibration_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <utility>

#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/tracking/evaluate_options.h"
#include "axiometry/app/tracking/tracking_request.h"
#include "axiometry/app/volumetric/identify_options.h"
#include "axiometry/app/volumetric/volumetric_request.h"
#include "axiometry/app/workbench/test_state.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/time/iso_date.h"
#include "axiometry/base/version.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"
#include "axiometry/store/kept/calibration_kinds.h"
#include "axiometry/volumetric/field/tool_fields.h"
#include "axiometry/volumetric/field/volume_statistics.h"

namespace axiometry::app {
namespace {

using json::Value;
using store::KeptFigure;

std::string numbered_role(std::string_view role, std::size_t number) {
  return number == 1 ? std::string(role) : fmt::format("{}-{}", role, number);
}

/// Whether it is "lengths-2", "lengths-3", …, the second and further files of lengths of the 21 errors.
bool is_further_lengths(std::string_view role) {
  constexpr std::string_view further = "lengths-";
  const auto number = role.starts_with(further) ? parse_count(role.substr(further.size())) : std::nullopt;
  return number && *number >= 2 && *number <= files_of_lengths_most && role == lengths_role(*number);
}

/// The files by what they are for.
class Sources {
 public:
  enum class Lengths { one, several };

  static Result<Sources> of(std::span<const CalibrationSource> files, std::span<const std::string_view> roles,
                            Lengths lengths) {
    Sources sources;
    std::size_t further = 0;
    for (const CalibrationSource& file : files) {
      const bool is_further = lengths == Lengths::several && is_further_lengths(file.role);
      if (is_further) ++further;
      if (!is_further && std::ranges::find(roles, file.role) == roles.end())
        return fail(fmt::format("found the file {} as {}, expected {}", text::quoted(file.name),
                                text::quoted(file.role), listed(roles)));
      if (sources.find(file.role)) return fail(fmt::format("found two files {}, expected one", file.role));
      sources.files_.push_back({file.role, {file.name, file.bytes}});
    }
    if (further > 0 && sources.lengths().size() != further + 1)
      return fail("found files lengths that are not numbered one after another, expected lengths, lengths-2, …");
    return sources;
  }

  std::optional<GivenFile> find(std::string_view role) const {
    for (const auto& [own, file] : files_)
      if (own == role) return file;
    return std::nullopt;
  }

  /// "lengths", "lengths-2", …, in that order.
  std::vector<GivenFile> lengths() const {
    std::vector<GivenFile> files;
    for (std::size_t k = 1; const auto file = find(lengths_role(k)); ++k) files.push_back(*file);
    return files;
  }

  Result<GivenFile> required(std::string_view role) const {
    if (auto file = find(role)) return *std::move(file);
    return fail(fmt::format("found no file {}, expected one", role));
  }

 private:
  static std::string listed(std::span<const std::string_view> roles) {
    std::string text;
    for (const std::string_view role : roles) text += fmt::format("{}{}", text.empty() ? "" : ", ", role);
    return text;
  }

  std::vector<std::pair<std::string, GivenFile>> files_;
};

Result<EvaluatedCalibration> evaluated_lines(std::span<const CalibrationSource> files, const Value& options) {
  constexpr std::array<std::string_view, 4> roles = {"lengths", "plan", "station", "tolerances"};
  AXIOMETRY_TRY(const Sources sources, Sources::of(files, roles, Sources::Lengths::one));
  AXIOMETRY_TRY(const GivenFile lengths, sources.required("lengths"));
  AXIOMETRY_TRY(const GivenFile plan, sources.required("plan"));
  AXIOMETRY_TRY(TrackingEvaluateOptions asked, evaluate_options_from(options));
  AXIOMETRY_TRY_VOID(take_tolerances(sources.find("tolerances"), asked.tolerance));
  AXIOMETRY_TRY(EvaluatedLines lines, evaluate_presentable({lengths, plan, sources.find("station")}, asked));
  return EvaluatedCalibration(std::move(lines));
}

Result<EvaluatedCalibration> identified_machine(std::span<const CalibrationSource> files, const Value& options,
                                                const std::stop_token& stop) {
  constexpr std::array<std::string_view, 3> roles = {"lengths", "machine", "plan"};
  AXIOMETRY_TRY(const Sources sources, Sources::of(files, roles, Sources::Lengths::several));
  IdentifyFiles given{
      .lengths = sources.lengths(), .machine = sources.find("machine"), .plan = sources.find("plan"), .stop = stop};
  if (given.lengths.empty()) return fail("found no file lengths, expected one");
  if (!given.machine && !given.plan) return fail("found neither a file machine nor a file plan, expected one of them");
  AXIOMETRY_TRY(const IdentifyChoices asked, identify_choices_from(options));
  AXIOMETRY_TRY(IdentifiedMachine found, identify_presentable(given, asked));
  return EvaluatedCalibration(std::move(found));
}

/// "plan" and, of a squareness, "plan-2".
std::vector<const CalibrationSource*> plans_among(std::span<const CalibrationSource> files) {
  std::vector<const CalibrationSource*> plans;
  for (std::size_t k = 1; k <= 2; ++k) {
    const auto plan = std::ranges::find(files, plan_role(k), &CalibrationSource::role);
    if (plan != files.end()) plans.push_back(&*plan);
  }
  return plans;
}

Result<EvaluatedCalibration> evaluated_motion(std::string_view kind, std::span<const CalibrationSource> files,
                                              const Value& options) {
  std::vector<GivenFile> given;
  const std::vector<const CalibrationSource*> plans = plans_among(files);
  const std::size_t readings = files.size() - plans.size();
  for (std::size_t k = 1; k <= readings; ++k) {
    const auto file = std::ranges::find(files, readings_role(k), &CalibrationSource::role);
    if (file == files.end())
      return fail(
          fmt::format("found no file {}, expected readings, and of several readings-2 and so on", readings_role(k)));
    given.push_back({file->name, file->bytes});
  }
  AXIOMETRY_TRY(MotionChoices choices, motion_choices_from(options));
  for (const CalibrationSource* plan : plans) {
    AXIOMETRY_TRY(choices.plans.emplace_back(), in_file(formats::read_plan(plan->bytes), plan->name));
  }
  AXIOMETRY_TRY(EvaluatedMotion evaluated, evaluate_motion(kind, given, choices));
  return EvaluatedCalibration(std::move(evaluated));
}

/// A figure with the unit's key.
void add_estimate(std::vector<KeptFigure>& figures, std::string parameter, const std::string& of,
                  const error_motions::MotionEstimate& estimate, std::string_view unit) {
  figures.push_back({std::move(parameter), of, estimate.value, estimate.u, std::string(unit)});
}

/// Ranges about different references are different figures. Usual: least squares of straightness, none of angles.
std::string about_reference(const error_motions::AxisMotion& motion) {
  using error_motions::Reference;
  if (motion.reference == (is_angle(motion.unit) ? Reference::none : Reference::least_squares)) return "";
  return motion.reference == Reference::end_points ? "_end_points" : "_least_squares";
}

void add_motion_figures(std::vector<KeptFigure>& figures, const MeasuredMotion& measured) {
  const error_motions::AxisMotion& motion = measured.motion;
  const std::string of = measured.error ? measured.error->text() : std::string();
  const std::string range = (is_angle(motion.unit) ? "angle_range" : "straightness") + about_reference(motion);
  const std::string_view unit = motion_unit_name(motion.unit);
  add_estimate(figures, range, of, motion.principal().range, unit);
  if (motion.range_both) add_estimate(figures, range + "_both", of, *motion.range_both, unit);
  if (motion.reversal) add_estimate(figures, "motion_reversal", of, *motion.reversal, unit);
  const auto repeatability = motion.repeatability      ? motion.repeatability
                             : motion.repeatability_up ? motion.repeatability_up
                                                       : motion.repeatability_down;
  if (repeatability) figures.push_back({"motion_repeatability", of, *repeatability, {}, std::string(unit)});
}

std::vector<KeptFigure> motion_figures(const EvaluatedMotion& evaluated) {
  std::vector<KeptFigure> figures;
  if (const auto* square = std::get_if<SquarenessMeasurement>(&evaluated)) {
    const std::string about = about_reference(square->first.motion);
    if (square->location)
      add_estimate(figures, std::string(square->location->name) + about, "", square->location->urad, "urad");
    add_estimate(figures, (square->square.in_axes ? "squareness_in_axes" : "squareness") + about, "",
                 square->result.squareness_arcsec, "arcsec");
  }
  for (const MeasuredMotion* measured : measured_files(evaluated)) add_motion_figures(figures, *measured);
  return figures;
}

std::string names_of(const EvaluatedMotion& evaluated) {
  std::string names;
  for (const MeasuredMotion* measured : measured_files(evaluated))
    if (measured->error) names += (names.empty() ? "" : ", ") + measured->error->text();
  return names;
}

std::vector<KeptFigure> line_figures(const EvaluatedLines& lines) {
  constexpr std::array<std::string_view, 4> shown = {"A", "E", "R", "B"};
  std::vector<KeptFigure> figures;
  for (const Evaluated& line : lines.tests)
    for (const store::FigureRecord& figure : figures_of(line)) {
      if (std::ranges::find(shown, figure.parameter) == shown.end()) continue;
      const std::string unit(deviation_unit_key(line.test.metadata.axis.kind));
      figures.push_back({figure.parameter, line.name, figure.value, {}, unit});
    }
  return figures;
}

std::vector<KeptFigure> volume_figures(const IdentifiedMachine& found) {
  const volumetric::Identification& identification = found.identification;
  const auto& tools = found.machine.tools;
  std::vector<KeptFigure> figures;
  for (const volumetric::Tool& tool : tools) {
    const auto sizes = volumetric::volume_statistics(identification.model, tool.offset_mm, volumetric::field_nodes)
                           .without_rigid_motion;
    if (!sizes) continue;
    figures.push_back({"volume_largest", tool.name, sizes->largest.value, sizes->largest.u, "um"});
    figures.push_back({"volume_percent_95", tool.name, sizes->percent_95, {}, "um"});
    figures.push_back({"volume_mean", tool.name, sizes->mean, {}, "um"});
  }
  const auto add_number = [&](std::string parameter, double value) {
    figures.push_back({std::move(parameter), "", value, {}, ""});
  };
  if (identification.degrees_of_freedom > 0) add_number("chi2_per_dof", identification.chi_squared_per_dof());
  const volumetric::VolumetricRank& rank = identification.rank;
  add_number("rank", static_cast<double>(rank.unknowns - rank.null_directions));
  add_number("unknowns", static_cast<double>(rank.unknowns));
  add_number("unseen_errors", static_cast<double>(identification.model.unseen_errors().size()));
  add_number("readings", static_cast<double>(found.lengths.readings.size()));
  return figures;
}

std::string stem_of(const std::string& file) { return std::filesystem::path(file).stem().string(); }

std::string verdict_of(const EvaluatedLines& lines) {
  std::vector<iso230_2::Judgement> of_all;
  for (const Evaluated& line : lines.tests) of_all.insert(of_all.end(), line.judgements.begin(), line.judgements.end());
  return kept_verdict(of_all);
}

template <typename Findings>
int serious_among(const Findings& findings) {
  return static_cast<int>(std::ranges::count_if(findings, [](const auto& finding) { return finding.serious; }));
}

}  // namespace

std::string lengths_role(std::size_t number) { return numbered_role("lengths", number); }
std::string motion_kind_of_files(std::span<const CalibrationSource> files) {
  const auto first = std::ranges::find(files, readings_role(1), &CalibrationSource::role);
  const std::vector<const CalibrationSource*> plans = plans_among(files);
  if (first == files.end()) return "straightness";
  std::optional<Plan> plan;
  if (!plans.empty())
    if (auto read = formats::read_plan(plans.front()->bytes)) plan = *std::move(read);
  const auto readings =
      plan ? formats::read_planned_motion(first->bytes, *plan) : formats::read_motion_csv(first->bytes);
  if (readings && is_angle(readings->unit)) return "angles";
  return files.size() - plans.size() == 2 ? "squareness" : "straightness";
}

std::string plan_role(std::size_t number) { return numbered_role("plan", number); }
std::string readings_role(std::size_t number) { return numbered_role("readings", number); }

Result<EvaluatedCalibration> evaluate_calibration(std::string_view kind, std::span<const CalibrationSource> files,
                                                  const Value& options, const std::stop_token& stop) {
  if (kind == "lines") return evaluated_lines(files, options);
  if (kind == "volumetric") return identified_machine(files, options, stop);
  if (is_motion_kind(kind)) return evaluated_motion(kind, files, options);
  return fail(
      fmt::format("found the kind of calibration {}, expected {}", text::quoted(kind), store::calibration_kinds_text));
}

Value result_of(const EvaluatedCalibration& evaluated) {
  if (const auto* lines = std::get_if<EvaluatedLines>(&evaluated)) return to_json(*lines);
  if (const auto* motion = std::get_if<EvaluatedMotion>(&evaluated)) {
    return present_motion(*motion, {}, {.report = false, .json = true}).json;
  }
  return to_json(std::get<IdentifiedMachine>(evaluated));
}

report::Document document_of(const EvaluatedCalibration& evaluated, const report::Options& options) {
  if (const auto* lines = std::get_if<EvaluatedLines>(&evaluated)) return lines_document(*lines, options);
  if (const auto* motion = std::get_if<EvaluatedMotion>(&evaluated)) {
    return present_motion(*motion, options, {.report = true, .json = false}).document;
  }
  return present(std::get<IdentifiedMachine>(evaluated), options).document;
}

std::vector<KeptFigure> figures_of(const EvaluatedCalibration& evaluated) {
  if (const auto* lines = std::get_if<EvaluatedLines>(&evaluated)) return line_figures(*lines);
  if (const auto* motion = std::get_if<EvaluatedMotion>(&evaluated)) return motion_figures(*motion);
  return volume_figures(std::get<IdentifiedMachine>(evaluated));
}

SuggestedText suggested(const EvaluatedCalibration& evaluated) {
  if (const auto* lines = std::get_if<EvaluatedLines>(&evaluated)) {
    const std::string date = lines->tests.empty() ? "" : lines->tests[0].test.metadata.conditions.date;
    const std::string& title = lines->plan.title;
    return {title.empty() ? stem_of(lines->lengths.file) : title, lines->plan.machine, iso_date(date)};
  }
  if (const auto* motion = std::get_if<EvaluatedMotion>(&evaluated)) {
    const MeasuredMotion& first = *measured_files(*motion).front();
    const std::string names = names_of(*motion);
    return {names.empty() ? stem_of(first.file) : names, first.metadata.machine.name,
            iso_date(first.metadata.conditions.date)};
  }
  const auto& found = std::get<IdentifiedMachine>(evaluated);
  return {stem_of(found.request.lengths.files.front()), found.machine.name, ""};
}

store::CalibrationRecord calibration_of(std::string_view kind, const EvaluatedCalibration& evaluated) {
  store::CalibrationRecord calibration;
  calibration.kind = kind;
  calibration.program = fmt::format("axiometry {}", version);
  calibration.figures = figures_of(evaluated);
  if (const auto* lines = std::get_if<EvaluatedLines>(&evaluated)) {
    calibration.verdict = verdict_of(*lines);
    calibration.serious = serious_among(lines->evaluation.findings);
  } else if (const auto* found = std::get_if<IdentifiedMachine>(&evaluated)) {
    calibration.serious = serious_among(found->identification.findings);
  }
  return calibration;
}

}  // namespace axiometry::app
