// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/documents/volumetric_sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

#include "axiometry/report/figures/tracking/field_slices.h"
#include "axiometry/report/sections/sections.h"

namespace axiometry::report {
namespace {

using volumetric::Estimate;
using volumetric::FieldSizes;
using volumetric::ToolField;

TableCell shown_number(double x, int decimals, const Options& options) {
  return text_cell(format_fixed(x, decimals, options.numbers));
}

void add_sizes(Table& table, const std::string& tool, std::string_view kind, const std::optional<FieldSizes>& sizes,
               const Options& options) {
  auto& row = table.rows.emplace_back();
  row = {verbatim_cell(tool), text_cell(kind)};
  if (!sizes) {
    row.push_back(text_cell("not told"));
    for (int k = 0; k < 6; ++k) row.push_back(text_cell("–"));
    return;
  }
  row.push_back(shown_number(sizes->largest.value, 1, options));
  row.push_back(shown_number(sizes->largest.u, 2, options));
  for (std::size_t a = 0; a < 3; ++a) row.push_back(shown_number(sizes->largest_at_mm[a], 0, options));
  row.push_back(shown_number(sizes->mean, 1, options));
  row.push_back(shown_number(sizes->percent_95, 1, options));
}

/// Those that are predicted without directions, "PPP-NNN, XY PP-NN".
std::string diagonals_of_means(std::span<const ToolField> fields) {
  std::string names;
  for (const std::string& name : volumetric::diagonal_names())
    if (std::ranges::any_of(fields, [&](const ToolField& field) {
          return std::ranges::any_of(field.diagonals, [&](const volumetric::DiagonalOfTool& diagonal) {
            return diagonal.name == name && diagonal.predicted && !diagonal.predicted->has_directions;
          });
        }))
      names += (names.empty() ? "" : ", ") + name;
  return names;
}

}  // namespace

Table finding_table(std::span<const volumetric::VolumetricFinding> findings) {
  Table table;
  table.columns = {{plain("Kind"), Align::start, true}, {plain("Finding"), Align::start, false, true}};
  for (const volumetric::VolumetricFinding& f : findings)
    table.rows.push_back({f.serious ? TableCell{strong("Serious"), Tone::bad} : TableCell{plain("Note"), Tone::quiet},
                          TableCell{sentence(f.message)}});
  return table;
}

Section volume_section(const volumetric::ErrorModel& model, std::span<const ToolField> fields, const Options& options) {
  Table table;
  table.groups = {{{}, 2}, {plain("Largest"), 2}, {plain("At / mm"), 3}, {{}, 2}};
  table.columns = {{plain("Tool"), Align::start, true},
                   {plain("Error of the tool point"), Align::start},
                   {joined({plain("|"), italic("δ"), plain("| / µm")}), Align::decimal},
                   {joined({italic("u"), plain(" / µm")}), Align::decimal},
                   {plain("X"), Align::decimal},
                   {plain("Y"), Align::decimal},
                   {plain("Z"), Align::decimal},
                   {plain("Mean / µm"), Align::decimal},
                   {plain("95 % / µm"), Align::decimal}};
  for (const ToolField& field : fields) {
    const std::string& tool = model.machine().tools[field.tool].name;
    add_sizes(table, tool, "as found", field.statistics.as_found, options);
    add_sizes(table, tool, "without rigid motion", field.statistics.without_rigid_motion, options);
  }
  table.notes = {plain("Over a grid of the travel that was observed, the largest between its nodes too. Without rigid "
                       "motion: less the "
                       "displacement and rotation of the "
                       "whole machine that fit best, which the place of a workpiece takes away. 95 % of the grid have "
                       "no more than the "
                       "last column."),
                 plain("Errors that are uncertain seem larger than they are, on average, the largest of many most of "
                       "all: u is without that bias.")};
  table.dense = true;
  Section section{"volume", "The volume", true, {std::move(table)}};
  const auto shown = std::ranges::find_if(fields, [](const ToolField& f) { return f.statistics.as_found.has_value(); });
  if (shown == fields.end()) return section;
  section.blocks.emplace_back(
      Paragraph{joined({plain("The picture is of the tool "), verbatim(model.machine().tools[shown->tool].name),
                        plain(", as found.")})});
  section.blocks.emplace_back(field_slice_figure(model, shown->tool, options));
  return section;
}

Section diagonals_section(const volumetric::ErrorModel& model, std::span<const ToolField> fields,
                          const Options& options) {
  Table table;
  table.columns = {{plain("Tool"), Align::start, true},
                   {plain("Diagonal"), Align::start},
                   {plain("Length / mm"), Align::decimal},
                   {joined({italic("E"), plain(" / µm")}), Align::decimal},
                   {joined({italic("u"), plain(" / µm")}), Align::decimal},
                   {plain("Slope / (µm/m)"), Align::decimal},
                   {joined({italic("u"), plain(" / (µm/m)")}), Align::decimal}};
  for (const ToolField& field : fields)
    for (const volumetric::DiagonalOfTool& diagonal : field.diagonals) {
      auto& row = table.rows.emplace_back();
      row = {verbatim_cell(model.machine().tools[field.tool].name), verbatim_cell(diagonal.name)};
      if (!diagonal.predicted) {
        row.push_back(text_cell("not told"));
        for (int k = 0; k < 4; ++k) row.push_back(text_cell("–"));
        continue;
      }
      const volumetric::PredictedLine& line = *diagonal.predicted;
      row.push_back(shown_number(norm(line.line.to_mm - line.line.from_mm), 0, options));
      for (const Estimate& e : {line.systematic, line.slope_um_per_m}) {
        row.push_back(shown_number(e.value, 2, options));
        row.push_back(shown_number(e.u, 2, options));
      }
    }
  const std::string of_means = diagonals_of_means(fields);
  const bool has_directions = model.coefficients().reversal() != volumetric::Reversal::none;
  table.notes = {
      has_directions
          ? plain(
                "Predicted from the 21 errors, along the diagonals of the travel that was observed: E is the "
                "bidirectional "
                "systematic deviation that ISO 230-6 would show. P and N name the ends of the axes, P the larger; of a "
                "face the third axis stands in the middle.")
          : plain("Predicted from the 21 errors, along the diagonals of the travel that was observed: E is that of the "
                  "mean "
                  "of both directions, and the bidirectional systematic deviation of ISO 230-6 holds reversal beside "
                  "it. P "
                  "and N name the ends of the axes, P the larger; of a face the third axis stands in the middle."),
      plain("Errors can cancel along a diagonal: a small E of one proves little alone.")};
  if (has_directions && !of_means.empty())
    table.notes.push_back(
        plain(fmt::format("Nothing tells by what the directions differ of some errors on {}: E is that of the mean of "
                          "both directions there, without reversal.",
                          of_means)));
  table.dense = true;
  return {"diagonals", "Diagonals, predicted", true, {std::move(table)}};
}

}  // namespace axiometry::report
