// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include "axiometry/app/error_motions/motion_evaluation.h"
#include "axiometry/app/error_motions/motion_tables.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::app {
namespace {

using json::Value;
using report::Align;
using report::plain;

constexpr int change_decimals = 3;  // nm: rotations are known to 0.01 µrad at best, which is 1 nm over 100 mm

std::string titled(std::string_view what, const std::string& name) {
  return name.empty() ? std::string(what) : fmt::format("{} {}", what, name);
}

Value measurement_value(std::string_view kind) {
  Value object = Value::object();
  object.add("result", kind);
  return object;
}

std::vector<std::string> square_remarks(const SquarenessMeasurement& s) {
  std::vector<std::string> remarks = all_remarks({&s.first, &s.second});
  if (!s.square.square_error_arcsec)
    remarks.push_back("no error of the optical square is stated: it counts as 0, and the squareness holds it");
  if (!s.square.square_uncertainty_arcsec)
    remarks.push_back("no uncertainty of the optical square is stated: U does not hold it");
  else if (*s.square.square_uncertainty_arcsec == 0.0)
    remarks.push_back("the uncertainty of the optical square is stated as 0, which no square has: U does not hold it");
  if (!s.square.in_axes)
    remarks.push_back(
        "nothing states which way the readings of both lines are positive, as # positive: +Y in each file does: θ₂ − "
        "θ₁ is their squareness where the optical square turned that way with the beam; where both are positive along "
        "the axes of the machine it is −θ₂ − θ₁");
  for (const auto& [line, other, words] :
       {std::tuple(&s.first, &s.second, "the first line"), std::tuple(&s.second, &s.first, "the second line")})
    if (line->motion.paths.size() == 1 && other->motion.paths.size() > 1)
      remarks.push_back(fmt::format("{} was read in one direction alone: the squareness is that of {}",
                                    line->error ? name_of(*line) : std::string(words),
                                    error_motions::path_mark(s.result.kind_1)));
  if (s.result.kind_1 != s.result.kind_2)
    remarks.push_back(
        fmt::format("the first line was read {} alone, the second {} alone: what directions differ by is in "
                    "the squareness, and not in U",
                    error_motions::path_mark(s.result.kind_1), error_motions::path_mark(s.result.kind_2)));
  if (!s.first.error || !s.second.error)
    remarks.push_back("the files do not both name their error: whether they are of one plane was not checked");
  return remarks;
}

report::Section square_section(const SquarenessMeasurement& s, const report::Options& options) {
  report::Section section{"results", "Results", true, {}};
  report::Table table = estimate_table(
      !s.result.squareness_arcsec.tells_U()
          ? "Of at least one line nothing tells an uncertainty: none is stated of the squareness."
      : s.square.square_uncertainty_arcsec
          ? "U for about 95 %, from both lines, whose tables say what theirs holds, and the optical square."
          : "U for about 95 %, from both lines, whose tables say what theirs holds.");
  const std::string_view course_1 = error_motions::path_mark(s.result.kind_1);
  const std::string_view course_2 = error_motions::path_mark(s.result.kind_2);
  const std::string_view course = course_1 == course_2 ? course_1 : std::string_view();
  table.rows.push_back(estimate_row("Slope of the first line, θ₁", course_1, s.result.theta_1_arcsec, "″", options));
  table.rows.push_back(estimate_row("Slope of the second line, θ₂", course_2, s.result.theta_2_arcsec, "″", options));
  table.rows.push_back({word_cell("Error of the optical square"),
                        word_cell(""),
                        {plain(report::shown_exact(s.square.square_error_arcsec.value_or(0.0), options))},
                        s.square.square_uncertainty_arcsec ? report::TableCell{plain(report::shown_exact(
                                                                 *s.square.square_uncertainty_arcsec, options))}
                                                           : report::TableCell{plain("–"), report::Tone::quiet},
                        word_cell("″")});
  table.rows.push_back(estimate_row(
      s.square.in_axes ? "Squareness, −θ₂ − θ₁ + error of the square" : "Squareness, θ₂ − θ₁ + error of the square",
      course, s.result.squareness_arcsec, "″", options));
  error_motions::MotionEstimate per_m = s.result.squareness_arcsec;
  const double um_per_arcsec = 1.0 / error_motions::slope_arcsec(1.0);
  per_m.value *= um_per_arcsec;
  if (per_m.u) *per_m.u *= um_per_arcsec;
  table.rows.push_back(estimate_row("Squareness over one metre", course, per_m, "µm/m", options));
  if (s.location) {
    table.rows.push_back(
        estimate_row(fmt::format("Location error {}", s.location->name), course, s.location->urad, "µrad", options));
    table.notes.push_back(
        plain("In axes of the machine: squareness is by how much the angle between the positive directions of both "
              "axes is larger than 90°. C0Y turns Y about Z, B0Z turns Z about Y, A0Z turns Z about X, positive by the "
              "right-hand rule."));
  }
  section.blocks.emplace_back(std::move(table));
  return section;
}

Value location_to_json(const std::optional<error_motions::LocationError>& location) {
  if (!location) return {};
  Value object = Value::object();
  object.add("name", location->name);
  object.add("urad", estimate_to_json(location->urad));
  return object;
}

/// Of the largest magnitude, with its sign.
double largest_of(const std::vector<double>& values) {
  return *std::ranges::max_element(values, {}, [](double x) { return std::abs(x); });
}

/// Names of the errors of which nothing states which way their readings are positive, "EBX, ECX".
std::string without_sense(const AnglesMeasurement& a) {
  std::string names;
  for (const MeasuredMotion& m : a.angles)
    if (!m.in_axes()) names += (names.empty() ? "" : ", ") + name_of(m);
  return names;
}

report::Section abbe_section(const AnglesMeasurement& a, const report::Options& options) {
  report::Section section{"abbe", "At another point", true, {}};
  report::Table table;
  table.caption =
      plain(fmt::format("Change of the errors at an offset of {}, {}, {} mm from the measured line",
                        report::shown_exact(a.offset_mm->x, options), report::shown_exact(a.offset_mm->y, options),
                        report::shown_exact(a.offset_mm->z, options)));
  table.columns = {{plain("Error"), Align::start, true},
                   {plain("Course"), Align::centre},
                   {plain("Range of the change, µm"), Align::decimal},
                   {plain("Largest change, µm"), Align::decimal},
                   {plain("Not known without")}};
  for (const AbbeComponent& c : a.abbe) {
    if (c.courses.empty())
      table.rows.push_back(
          {word_cell(c.name), word_cell(""), report::quiet_cell("–"), report::quiet_cell("–"), word_cell(c.missing)});
    for (const AbbeCourse& course : c.courses) {
      const auto [low, high] = std::ranges::minmax(course.change_um);
      table.rows.push_back({word_cell(c.name), word_cell(error_motions::path_mark(course.kind)),
                            number_cell(high - low, change_decimals, options),
                            number_cell(largest_of(course.change_um), change_decimals, options), word_cell("")});
    }
  }
  table.notes = {
      plain(without_sense(a).empty()
                ? "Added to the error at the measured line. Of the moving part, in axes of the machine; where it "
                  "carries the workpiece, the tool sees the opposite sign. No uncertainty of the change is "
                  "stated."
                : "Added to the error at the measured line, as if all readings were positive by the right-hand rule "
                  "about the axes of the machine. Of the moving part; where it carries the workpiece, the tool sees "
                  "the opposite sign. No uncertainty of the change is stated.")};
  if (a.angles.front().motion.reference != error_motions::Reference::none)
    table.notes.push_back(plain("Of the readings as they are: no line is taken from them here."));
  section.blocks.emplace_back(std::move(table));
  return section;
}

std::vector<std::string> angle_remarks(const AnglesMeasurement& a, const std::vector<const MeasuredMotion*>& files) {
  std::vector<std::string> remarks = all_remarks(files);
  if (const std::string names = without_sense(a); a.offset_mm && !names.empty())
    remarks.push_back(
        fmt::format("nothing states which way the readings of {} are positive, as # positive: +B in a file does: what "
                    "they change at another point may have the other sign",
                    names));
  return remarks;
}

/// `change_um` is that of the principal course; that of each direction stands beside it where there are both.
Value abbe_to_json(const AnglesMeasurement& a) {
  Value object = Value::object();
  object.add("offset_mm", numbers_to_json(std::array{a.offset_mm->x, a.offset_mm->y, a.offset_mm->z}));
  Value& changes = object.add("change_um", Value::object());
  for (const AbbeComponent& c : a.abbe)
    changes.add(c.name, c.courses.empty() ? Value() : numbers_to_json(c.courses.back().change_um));
  for (const auto& [key, kind] : {std::pair{"change_up_um", error_motions::PathKind::up},
                                  std::pair{"change_down_um", error_motions::PathKind::down}}) {
    Value of_direction = Value::object();
    for (const AbbeComponent& c : a.abbe)
      for (const AbbeCourse& course : c.courses)
        if (c.courses.size() > 1 && course.kind == kind) of_direction.add(c.name, numbers_to_json(course.change_um));
    if (!of_direction.members().empty()) object.add(key, std::move(of_direction));
  }
  const auto told = std::ranges::find_if(a.abbe, [](const AbbeComponent& c) { return !c.courses.empty(); });
  object.add("course", told == a.abbe.end() ? Value() : Value(course_key(told->courses.back().kind)));
  Value& missing = object.add("missing", Value::object());
  for (const AbbeComponent& c : a.abbe)
    if (!c.missing.empty()) missing.add(c.name, c.missing);
  return object;
}

std::string file_id(std::string_view id, std::size_t number, std::size_t count) {
  return count == 1 ? std::string(id) : fmt::format("{}-{}", id, number + 1);
}

/// Positions and figures of each file, then the method and what all of it comes from.
void add_details(report::Document& document, const std::vector<const MeasuredMotion*>& files,
                 const report::Options& options) {
  report::Section figures{"figures", "Figures", true, {}};
  for (const MeasuredMotion* f : files) add_figures(figures, *f, name_of(*f), options);
  document.sections.push_back(std::move(figures));
  for (std::size_t k = 0; k < files.size(); ++k)
    document.sections.push_back(motion_positions(*files[k], file_id("positions", k, files.size()),
                                                 titled("Positions", name_of(*files[k])), options));
  document.sections.push_back(motion_method(*files.front()));
  document.sections.push_back(motion_provenance(files, document.edition));
}

}  // namespace

Experiment present(const MeasuredMotion& m, const report::Options& options, MotionOutputs outputs) {
  Experiment experiment;
  experiment.document = motion_document("Straightness", titled("Straightness", name_of(m)), {&m}, options);
  experiment.document.sections.push_back(motion_results(m, "results", "Results", options));
  if (outputs.report) add_details(experiment.document, {&m}, options);
  add_remarks(experiment.document, m.remarks);
  if (!outputs.json) return experiment;
  experiment.json = measurement_value("straightness");
  experiment.json.add("straightness", motion_to_json(m));
  experiment.json.add("program", program_to_json());
  return experiment;
}

Experiment present(const SquarenessMeasurement& s, const report::Options& options, MotionOutputs outputs) {
  const std::vector<const MeasuredMotion*> files = {&s.first, &s.second};
  const bool named = s.first.error && s.second.error;
  Experiment experiment;
  experiment.document = motion_document(
      "Squareness", titled("Squareness of two axes", named ? name_of(s.first) + ", " + name_of(s.second) : ""), files,
      options);
  experiment.document.sections.push_back(square_section(s, options));
  experiment.document.sections.push_back(motion_results(s.first, "line-1", "First line", options));
  experiment.document.sections.push_back(motion_results(s.second, "line-2", "Second line", options));
  if (outputs.report) add_details(experiment.document, files, options);
  const std::vector<std::string> remarks = square_remarks(s);
  add_remarks(experiment.document, remarks);
  if (!outputs.json) return experiment;
  Value& json = experiment.json = measurement_value("squareness");
  json.add("theta_1_arcsec", estimate_to_json(s.result.theta_1_arcsec));
  json.add("theta_2_arcsec", estimate_to_json(s.result.theta_2_arcsec));
  json.add("square_error_arcsec", s.square.square_error_arcsec ? Value(*s.square.square_error_arcsec) : Value());
  json.add("square_uncertainty_arcsec",
           s.square.square_uncertainty_arcsec ? Value(*s.square.square_uncertainty_arcsec) : Value());
  json.add("squareness_arcsec", estimate_to_json(s.result.squareness_arcsec));
  Value& courses = json.add("courses", Value::array());
  for (const error_motions::PathKind kind : {s.result.kind_1, s.result.kind_2}) courses.push(course_key(kind));
  json.add("in_axes", s.square.in_axes);
  json.add("location_error", location_to_json(s.location));
  json.add("remarks", texts_to_json(remarks));
  Value& lines = json.add("lines", Value::array());
  for (const MeasuredMotion* f : files) lines.push(motion_to_json(*f));
  json.add("program", program_to_json());
  return experiment;
}

Experiment present(const AnglesMeasurement& a, const report::Options& options, MotionOutputs outputs) {
  std::vector<const MeasuredMotion*> files;
  std::string names;
  for (const MeasuredMotion& m : a.angles) {
    files.push_back(&m);
    if (m.error) names += (names.empty() ? "" : ", ") + m.error->text();
  }
  Experiment experiment;
  experiment.document = motion_document("Angles", titled("Angular errors", names), files, options);
  for (std::size_t k = 0; k < files.size(); ++k)
    experiment.document.sections.push_back(
        motion_results(*files[k], file_id("results", k, files.size()), "Results", options));
  if (a.offset_mm) experiment.document.sections.push_back(abbe_section(a, options));
  if (outputs.report) add_details(experiment.document, files, options);
  const std::vector<std::string> remarks = angle_remarks(a, files);
  add_remarks(experiment.document, remarks);
  if (!outputs.json) return experiment;
  Value& json = experiment.json = measurement_value("angles");
  Value& list = json.add("angles", Value::array());
  for (const MeasuredMotion* f : files) list.push(motion_to_json(*f));
  json.add("abbe", a.offset_mm ? abbe_to_json(a) : Value());
  json.add("remarks", texts_to_json(remarks));
  json.add("program", program_to_json());
  return experiment;
}

}  // namespace axiometry::app
