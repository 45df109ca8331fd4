// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/error_motions/motion_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/base/contract.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/model/fields.h"
#include "axiometry/report/figures/axis_motion.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"

namespace axiometry::app {
namespace {

using error_motions::AxisMotion;
using error_motions::MotionEstimate;
using error_motions::MotionPath;
using error_motions::PathKind;
using error_motions::Reference;
using report::Align;
using report::plain;
using report::verbatim;

constexpr int digits_alone = 3;  // significant digits of a value without U
constexpr int residual_decimals = 3;

using error_motions::rounding;

std::string unit_per_m(MotionUnit unit) { return fmt::format("{}/m", motion_unit_symbol(unit)); }

std::string_view course_of(PathKind kind) { return error_motions::path_mark(kind); }

std::string range_name(const AxisMotion& motion) {
  if (!is_angle(motion.unit)) return "Straightness, range of the residuals";
  return motion.reference == Reference::none ? "Range of the angle" : "Range of the residuals";
}

std::vector<report::TableCell> value_row(std::string_view quantity, std::string_view course, double value,
                                         std::string_view unit, const report::Options& options) {
  return {word_cell(quantity),
          word_cell(course),
          {plain(report::shown_short(std::abs(value) < rounding ? 0.0 : value, options, digits_alone))},
          {plain("–"), report::Tone::quiet},
          word_cell(unit)};
}

void add_path(report::Table& table, const AxisMotion& motion, const MotionPath& path, const report::Options& options) {
  const std::string_view unit = motion_unit_symbol(motion.unit), course = course_of(path.kind);
  table.rows.push_back(estimate_row(range_name(motion), course, path.range, unit, options));
  if (motion.reference == Reference::none) return;
  table.rows.push_back(estimate_row("Slope of the line", course, path.slope_per_m, unit_per_m(motion.unit), options));
  if (!is_angle(motion.unit))
    table.rows.push_back(
        estimate_row("Angle of the line, θ", course, error_motions::slope_angle(path.slope_per_m), "″", options));
  table.rows.push_back(estimate_row("Line at position 0", course, path.intercept, unit, options));
}

void add_both(report::Table& table, const AxisMotion& motion, const report::Options& options) {
  const std::string_view unit = motion_unit_symbol(motion.unit);
  if (motion.range_both)
    table.rows.push_back(estimate_row(motion.reference == Reference::none
                                          ? "Range over both directions"
                                          : "Range over both directions, about one line",
                                      "↑↓", *motion.range_both, unit, options));
  if (motion.reversal)
    table.rows.push_back(estimate_row("Largest reversal, ↑ less ↓", "↑↓", *motion.reversal, unit, options));
  if (motion.reversal_mean)
    table.rows.push_back(value_row("Mean reversal", "↑↓", *motion.reversal_mean, unit, options));
  const auto repeatability = [&](std::string_view course, const std::optional<double>& value) {
    if (value) table.rows.push_back(value_row("Repeatability, largest", course, *value, unit, options));
  };
  repeatability("↑", motion.repeatability_up);
  repeatability("↓", motion.repeatability_down);
  repeatability("↑↓", motion.repeatability);
}

/// What U of these figures holds.
std::string_view uncertainty_note(const MeasuredMotion& measured) {
  const bool instrument = measured.instrument.has_value();
  if (measured.motion.repeats_without_U()) return "Nothing tells an uncertainty.";
  if (measured.motion.runs > 1 && measured.motion.reversal)
    return instrument
               ? "U for about 95 %, from runs and instrument; of ranges and the largest reversal without the bias that "
                 "noise gives them."
               : "U for about 95 %, from the runs alone; of ranges and the largest reversal without the bias that "
                 "noise gives them.";
  if (measured.motion.runs > 1)
    return instrument ? "U for about 95 %, from runs and instrument; of a range without the bias noise gives it."
                      : "U for about 95 %, from the runs alone; of a range without the bias that noise gives it.";
  if (measured.motion.principal().slope_per_m.scatter == MotionEstimate::Scatter::residuals)
    return instrument ? "U for about 95 %, of a line from its residuals and the instrument, of a range from the "
                        "instrument alone."
                      : "U for about 95 %, of a line from its residuals alone; a range has none.";
  return instrument ? "U for about 95 %, from the instrument alone." : "Nothing tells an uncertainty.";
}

/// What the files say of the test, where they do.
constexpr std::pair<std::string_view, std::string_view> identity_fields[] = {{"Machine", "machine.name"},
                                                                             {"Serial number", "machine.serial_number"},
                                                                             {"Axis", "axis.name"},
                                                                             {"Date of test", "test.date"},
                                                                             {"Inspector", "test.inspector"}};

std::string statement(const MeasuredMotion& measured, std::string_view key) {
  const Field* field = find_field(key);
  AXIOMETRY_CONTRACT(field != nullptr);
  return field_text(*field, field->get(measured.metadata));
}

/// In all files, each text once: "2026-11-25, 2026-11-26".
std::string said_in(const std::vector<const MeasuredMotion*>& files, std::string_view key) {
  std::vector<std::string> said;
  for (const MeasuredMotion* f : files)
    if (std::string text = statement(*f, key); !text.empty() && std::ranges::find(said, text) == said.end())
      said.push_back(std::move(text));
  return fmt::format("{}", fmt::join(said, ", "));
}

}  // namespace

std::string name_of(const MeasuredMotion& measured) { return measured.error ? measured.error->text() : ""; }

report::Document motion_document(std::string_view kind, const std::string& title,
                                 const std::vector<const MeasuredMotion*>& files, const report::Options& options) {
  report::Document document = experiment_document(title, "");
  document.kind = std::string(kind);
  document.running_head = report::translated(title, options);
  document.running_status = "Formulas not checked against the text of ISO 230-1";
  document.edition = document.running_status;
  for (const MeasuredMotion* f : files) {
    document.identity.push_back({plain("File"), {verbatim(base_name(f->file))}});
    document.identity.push_back(
        {plain("Reference line"), word_cell(error_motions::reference_name(f->motion.reference))});
  }
  if (files.size() > 1)
    std::erase_if(document.identity, [&](const report::Fact& fact) {
      return report::plain_text(fact.name) == "Reference line" && &fact != &document.identity.back();
    });
  for (const auto& [name, key] : identity_fields)
    if (std::string said = said_in(files, key); !said.empty())
      document.identity.push_back({plain(name), {verbatim(said)}});
  document.date = said_in(files, "test.date");
  return document;
}

std::vector<report::TableCell> estimate_row(std::string_view quantity, std::string_view course, const MotionEstimate& e,
                                            std::string_view unit, const report::Options& options) {
  if (!e.u || e.U_is_rounding()) {
    auto row = value_row(quantity, course, e.value, unit, options);
    if (e.tells_U()) row[3] = {plain("0")};
    return row;
  }
  const int decimals = decimals_for(e.U(), options.uncertainty_digits);
  return {word_cell(quantity), word_cell(course), number_cell(e.value, decimals, options),
          number_cell(e.U(), decimals, options), word_cell(unit)};
}

report::Table estimate_table(std::string_view note) {
  report::Table table;
  table.columns = {{plain("Quantity"), Align::start, true, true},
                   {plain("Course"), Align::centre},
                   {plain("Value"), Align::decimal},
                   {report::italic("U"), Align::decimal},
                   {plain("Unit")}};
  table.notes = {plain(note)};
  return table;
}

report::Section motion_results(const MeasuredMotion& measured, const std::string& id, const std::string& title,
                               const report::Options& options) {
  report::Section section{id, title, true, {}};
  report::Table table = estimate_table(uncertainty_note(measured));
  if (measured.error)
    table.caption = plain(measured.error->text());
  else if (title != "Results")
    table.caption = plain(title);
  for (const MotionPath& path : measured.motion.paths) add_path(table, measured.motion, path, options);
  add_both(table, measured.motion, options);
  section.blocks.emplace_back(std::move(table));
  return section;
}

report::Section motion_positions(const MeasuredMotion& measured, const std::string& id, const std::string& title,
                                 const report::Options& options) {
  const AxisMotion& motion = measured.motion;
  report::Table table;
  table.dense = true;
  const std::string_view unit = motion_unit_symbol(motion.unit);
  table.columns = {{plain("Position, mm"), Align::decimal, true}};
  for (const MotionPath& path : motion.paths) {
    table.columns.push_back(
        {plain(fmt::format("{} in {}", course_of(path.kind), unit)), Align::decimal, false, false, true});
    if (motion.reference != Reference::none)
      table.columns.push_back({plain(fmt::format("{} less its line", course_of(path.kind))), Align::decimal});
  }
  const bool both = motion.paths.size() > 1, repeats = motion.runs > 1;
  if (both) table.columns.push_back({report::symbol("B_i"), Align::decimal, false, false, true});
  if (motion.repeatability_up) table.columns.push_back({report::symbol("s_i↑"), Align::decimal});
  if (motion.repeatability_down) table.columns.push_back({report::symbol("s_i↓"), Align::decimal});
  for (std::size_t i = 0; i < motion.positions.size(); ++i) {
    const auto& p = motion.positions[i];
    auto& row = table.rows.emplace_back();
    row.push_back({plain(report::shown_exact(p.position_mm, options))});
    for (const MotionPath& path : motion.paths) {
      row.push_back(number_cell(path.means[i], residual_decimals, options));
      if (motion.reference != Reference::none)
        row.push_back(number_cell(path.residuals[i], residual_decimals, options));
    }
    if (both) row.push_back(number_cell(p.reversal.value_or(0.0), residual_decimals, options));
    if (repeats && p.s_up) row.push_back(number_cell(*p.s_up, residual_decimals, options));
    if (repeats && p.s_down) row.push_back(number_cell(*p.s_down, residual_decimals, options));
  }
  report::Section section{id, title, true, {}};
  section.blocks.emplace_back(std::move(table));
  return section;
}

void add_figures(report::Section& section, const MeasuredMotion& measured, const std::string& name,
                 const report::Options& options) {
  const std::string end = name.empty() ? "" : ": " + name;
  section.blocks.emplace_back(report::motion_figure(measured.motion, "Readings over the position" + end, options));
  const std::string line =
      measured.motion.paths.size() > 1 ? "Readings less the line of the mean" : "Readings less the line";
  if (measured.motion.reference != Reference::none)
    section.blocks.emplace_back(report::motion_residual_figure(measured.motion, line + end, options));
}

std::vector<std::string> all_remarks(const std::vector<const MeasuredMotion*>& files) {
  const auto stands_in = [](const MeasuredMotion& f, const std::string& remark) {
    return std::ranges::find(f.remarks, remark) != f.remarks.end();
  };
  const auto called = [](const MeasuredMotion& f) { return name_of(f).empty() ? base_name(f.file) : name_of(f); };
  std::vector<std::string> list;
  for (const MeasuredMotion* f : files) {
    const auto alike = std::ranges::count_if(files, [&](const auto* other) { return called(*other) == called(*f); });
    const std::string name = alike > 1 ? f->file : called(*f);
    for (const std::string& remark : f->remarks) {
      const bool of_all = std::ranges::all_of(files, [&](const auto* other) { return stands_in(*other, remark); });
      const std::string told = of_all ? remark : fmt::format("{}: {}", name, remark);
      if (std::ranges::find(list, told) == list.end()) list.push_back(told);
    }
  }
  return list;
}

void add_remarks(report::Document& document, const std::vector<std::string>& remarks) {
  if (remarks.empty()) return;
  report::Notice notice{report::Tone::caution, plain("To be known with these figures"), {}};
  for (const std::string& remark : remarks) notice.lines.push_back(report::sentence(remark));
  document.status.push_back(std::move(notice));
}

report::Section motion_provenance(const std::vector<const MeasuredMotion*>& files, std::string_view edition) {
  report::Table table;
  table.columns = {{plain("Source"), Align::start, true}, {plain("Value"), Align::start, false, true}};
  for (const MeasuredMotion* f : files) {
    table.rows.push_back({word_cell("File"), {verbatim(base_name(f->file))}});
    table.rows.push_back({word_cell("SHA-256 of the file"), {verbatim(f->sha256)}});
    if (const std::string date = statement(*f, "test.date"); !date.empty())
      table.rows.push_back({word_cell("Date of test"), {verbatim(date)}});
  }
  table.rows.push_back({word_cell("Program"), {verbatim(report::program_text())}});
  table.rows.push_back({word_cell("Edition of the standard"), word_cell(edition)});
  report::Section section{"provenance", "Provenance", false, {}};
  section.blocks.emplace_back(std::move(table));
  return section;
}

report::Section motion_method(const MeasuredMotion& measured) {
  std::string text =
      measured.motion.runs > 1
          ? "Means over the runs at each position; the mean of both directions where there are two. U of a slope and "
            "of "
            "a range is from the same figure of each run, as a mean of independent runs, or from the noise within the "
            "runs where that is larger; the instrument’s part holds for every correlation between positions and falls "
            "neither with positions nor with runs. The position of the highest and the lowest residual is taken as "
            "known."
          : "One run: the mean of both directions where there are two. U of a line is from what it leaves, in which "
            "the "
            "shape of the way is too, and a range has none of this kind; the instrument’s part holds for every "
            "correlation between positions and does not fall with positions. The position of the highest and the "
            "lowest "
            "residual is taken as known.";
  if (measured.motion.reference == Reference::none)
    text += " No line is removed from angles: their slope is a bend or a twist of the way.";
  return {"method", "Method", false, {report::Paragraph{plain(text)}}};
}

}  // namespace axiometry::app
