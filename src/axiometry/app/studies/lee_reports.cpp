// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/studies/lee_reports.h"

#include <fmt/format.h>

#include "axiometry/app/results/result_json.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/text/json_members.h"

namespace axiometry::app::lee {
namespace {

using formats::vector_value;
using json::Value;
using report::Align;
using report::plain;
using report::Tone;

constexpr std::string_view paper = "Lee et al., Sensors 16 (2016) 482, {}";

Value points_value(const std::vector<Vector3>& points) {
  Value array = Value::array();
  for (const Vector3 p : points) array.push(vector_value(p));
  return array;
}

Value located_value(const BothEstimates& located) {
  Value object = Value::object();
  object.add("linear_mm", vector_value(located.linear_mm));
  object.add("refined_mm", vector_value(located.refined_mm));
  object.add("largest_residual_mm", located.largest_residual_mm);
  return object;
}

Value set_value(const Set& set) {
  Value object = Value::object();
  object.add("station_mm", vector_value(set.station_mm));
  object.add("points_mm", points_value(set.points_mm));
  object.add("noise_um", set.noise.in_um());
  object.add("seed", static_cast<double>(set.seed));
  return object;
}

Value shifts_value(const std::vector<Shift>& shifts) {
  Value list = Value::array();
  for (const Shift& s : shifts) {
    Value& row = list.push(Value::object());
    row.add("row", s.name);
    row.add("printed_mm", vector_value(s.printed_mm));
    row.add("linear_mm", vector_value(s.linear_mm));
    row.add("refined_mm", vector_value(s.refined_mm));
    row.add("largest_residual_mm", s.largest_residual_mm);
  }
  return list;
}

/// A size that is 0 but for rounding is not told by its digits, which differ from one processor to another.
std::string size_text(double mm, const report::Options& options) {
  if (mm < 1e-9) return "below 1e-9 mm";
  if (mm < 0.1) return format_fixed(mm * 1e3, mm < 1e-3 ? 4 : 2, options.numbers) + " µm";
  return format_fixed(mm, 3, options.numbers) + " mm";
}

std::string vector_text(Vector3 v, const report::Options& options) {
  return fmt::format("{}, {}, {} mm", format_fixed(v.x, 4, options.numbers), format_fixed(v.y, 4, options.numbers),
                     format_fixed(v.z, 4, options.numbers));
}

std::vector<report::Fact> identity(const Set& set, const report::Options& options) {
  return {
      {plain("True station"), word_cell(vector_text(set.station_mm, options))},
      {plain("Points"), word_cell(fmt::format("{}", set.points_mm.size()))},
      {plain("Noise of a length"),
       word_cell(set.noise.in_um() == 0.0
                     ? std::string("none")
                     : fmt::format("{} µm, seed {}", format_fixed(set.noise.in_um(), 3, options.numbers), set.seed))}};
}

/// Row, then x, y, z of each estimate.
report::Table shift_table(const std::vector<Shift>& shifts, const report::Options& options) {
  report::Table table;
  table.groups = {{{}, 1}, {plain("printed, mm"), 3}, {plain("eq. 14, mm"), 3}, {plain("refined, mm"), 3}};
  table.columns = {{plain("Error of"), Align::start, true}};
  for (int group = 0; group < 3; ++group)
    for (const std::string_view axis : {"x", "y", "z"})
      table.columns.push_back({report::italic(axis), Align::decimal, false, false, axis == "x"});
  for (const Shift& s : shifts) {
    auto& row = table.rows.emplace_back();
    row.push_back(word_cell(s.name));
    for (std::size_t a = 0; a < 3; ++a) row.push_back(number_cell(s.printed_mm[a], 2, options, Tone::quiet));
    for (std::size_t a = 0; a < 3; ++a) row.push_back(number_cell(s.linear_mm[a], 4, options));
    for (std::size_t a = 0; a < 3; ++a) row.push_back(number_cell(s.refined_mm[a], 4, options));
  }
  table.dense = true;
  return table;
}

/// The summary of a fixture.
std::vector<report::RichText> judgements(const ProportionalError& r, const report::Options& options) {
  const auto size = [&](double mm) { return size_text(mm, options); };
  return {
      plain(fmt::format("{} against the printed table (misprint corrected): rms {}, largest {}.",
                        r.fixture.refined ? "Refined" : "eq. 14", size(r.rms_mm), size(r.largest_mm))),
      plain(fmt::format("Printed 0.40 in the row z, −, a misprint for 0.04; found {}.",
                        format_fixed(r.misprinted_mm, 4, options.numbers))),
      plain(fmt::format("Odd within {}, additive within {}.", size(r.oddness_mm), size(r.additivity_mm))),
      plain(fmt::format("The two estimators are up to {} apart.", size(r.estimators_apart_mm))),
  };
}

Value fixture_value(const ProportionalError& r) {
  Value object = Value::object();
  object.add("name", r.fixture.name);
  object.add("error", r.fixture.error);
  object.add("station_mm", vector_value(r.fixture.station_mm));
  object.add("scale_origin_mm", vector_value(r.fixture.origin_mm));
  object.add("estimator", r.fixture.refined ? "refined" : "linear");
  object.add("points_mm", points_value(r.fixture.points_mm));
  object.add("rows", shifts_value(r.shifts));
  object.add("rms_mm", r.rms_mm);
  object.add("largest_mm", r.largest_mm);
  object.add("misprint_found_mm", r.misprinted_mm);
  object.add("oddness_mm", r.oddness_mm);
  object.add("additivity_mm", r.additivity_mm);
  object.add("estimators_apart_mm", r.estimators_apart_mm);
  return object;
}

Value slopes_value(const Slopes& r) {
  Value object = Value::object();
  object.add("result", "slope");
  object.add("set", set_value(r.request.set));
  object.add("axis", std::string(1, static_cast<char>('x' + r.request.axis)));
  object.add("base_um_per_m", r.request.base.in_um_per_m());
  object.add("added_um_per_m", r.request.added.in_um_per_m());
  object.add("scale_origin_mm", vector_value(r.request.origin_mm));
  object.add("offset_mm", vector_value(r.request.offset_mm));
  Value& distances = object.add("distances_mm", Value::array());
  for (const double d : r.request.distances_mm) distances.push(d);
  object.add("station_before", located_value(r.before));
  object.add("station_after", located_value(r.after));
  Value& lines = object.add("lines", Value::array());
  for (const LineSlopes& line : r.lines) {
    Value& row = lines.push(Value::object());
    row.add("id", line.id);
    row.add("direction", vector_value(line.direction));
    row.add("before_um_per_m", line.before_um_per_m);
    row.add("after_um_per_m", line.after_um_per_m);
    row.add("change_um_per_m", line.after_um_per_m - line.before_um_per_m);
    row.add("expected_change_um_per_m", line.expected_change_um_per_m);
  }
  object.add("program", program_to_json());
  return object;
}

}  // namespace

Experiment present(const CoordinateOffset& r, const report::Options& options) {
  Experiment experiment{experiment_document("Coordinate offset", fmt::format(fmt::runtime(paper), "2.2, Table 2")),
                        Value::object()};
  report::Document& document = experiment.document;
  document.identity = identity(r.set, options);
  document.identity.push_back({plain("Offset"), word_cell(format_fixed(r.offset_mm, 3, options.numbers) + " mm")});
  report::Section section{"shifts", "By how much the station is found elsewhere", true, {}};
  section.blocks.emplace_back(shift_table(r.shifts, options));
  document.sections.push_back(std::move(section));
  document.status.push_back({Tone::normal,
                             plain("Largest departure of a coordinate from minus the offset"),
                             {plain(fmt::format("eq. 14: {}; refined: {}", size_text(r.worst_linear_mm, options),
                                                size_text(r.worst_refined_mm, options))),
                              plain(fmt::format("printed, for 1 mm: {}, of which 5 µm are rounding",
                                                size_text(r.worst_printed_mm, options)))}});

  Value& json = experiment.json;
  json.add("result", "coordinate-offset");
  json.add("set", set_value(r.set));
  json.add("offset_mm", r.offset_mm);
  json.add("baseline", located_value(r.baseline));
  json.add("rows", shifts_value(r.shifts));
  json.add("worst_linear_mm", r.worst_linear_mm);
  json.add("worst_refined_mm", r.worst_refined_mm);
  json.add("program", program_to_json());
  return experiment;
}

Experiment present(std::span<const ProportionalError> results, const report::Options& options) {
  Experiment experiment{experiment_document("Proportional error", fmt::format(fmt::runtime(paper), "2.3, Table 3")),
                        Value::object()};
  if (!results.empty())
    experiment.document.identity = {
        {plain("True station"), word_cell(vector_text(results.front().fixture.station_mm, options))},
        {plain("Points"), word_cell(fmt::format("{}", results.front().fixture.points_mm.size()))}};
  experiment.json.add("result", "proportional-error");
  Value& list = experiment.json.add("fixtures", Value::array());
  for (const ProportionalError& r : results) {
    const Fixture& f = r.fixture;
    report::Section section{"fixture-" + f.name, "Fixture " + f.name, true, {}};
    report::Table table = shift_table(r.shifts, options);
    table.caption = plain(fmt::format("{}: scale error {} %, about {}; {}", f.name,
                                      format_fixed(f.error * 100.0, 3, options.numbers),
                                      f.origin_mm == f.station_mm ? "the station" : vector_text(f.origin_mm, options),
                                      f.refined ? "refined estimator" : "eq. 14"));
    table.notes = judgements(r, options);
    section.blocks.emplace_back(std::move(table));
    experiment.document.sections.push_back(std::move(section));
    list.push(fixture_value(r));
  }
  experiment.json.add("program", program_to_json());
  return experiment;
}

Experiment present(const Slopes& r, const report::Options& options) {
  Experiment experiment{experiment_document("Slope of seven lines", fmt::format(fmt::runtime(paper), "2.4, Fig. 6")),
                        slopes_value(r)};
  report::Document& document = experiment.document;
  const auto percent = [&](double um_per_m) { return format_fixed(um_per_m * 1e-4, 6, options.numbers) + " %"; };
  document.identity = identity(r.request.set, options);
  document.identity.push_back(
      {plain(fmt::format("Scale error of {}", static_cast<char>('x' + r.request.axis))),
       word_cell(fmt::format("{}, then {} more, about {}", percent(r.request.base.in_um_per_m()),
                             percent(r.request.added.in_um_per_m()), vector_text(r.request.origin_mm, options)))});
  if (r.request.offset_mm != Vector3{})
    document.identity.push_back({plain("Offset given with it"), word_cell(vector_text(r.request.offset_mm, options))});
  document.identity.push_back({plain("Station found before"), word_cell(vector_text(r.before.refined_mm, options))});
  document.identity.push_back({plain("Station found after"), word_cell(vector_text(r.after.refined_mm, options))});

  report::Table table;
  table.groups = {{{}, 1}, {plain("Slope in %"), 3}, {{}, 1}};
  table.columns = {{plain("Line"), Align::start, true},
                   {plain("before"), Align::decimal},
                   {plain("after"), Align::decimal},
                   {plain("change"), Align::decimal},
                   {report::joined({report::italic("e u"), plain("²")}), Align::decimal, false, false, true}};
  for (const LineSlopes& line : r.lines)
    table.rows.push_back({word_cell(line.id), number_cell(line.before_um_per_m * 1e-4, 6, options),
                          number_cell(line.after_um_per_m * 1e-4, 6, options),
                          number_cell((line.after_um_per_m - line.before_um_per_m) * 1e-4, 6, options),
                          number_cell(line.expected_change_um_per_m * 1e-4, 6, options, Tone::quiet)});
  table.notes = {
      plain("Slope of length shown − nominal distance from the station that was found; u: the part of the "
            "direction along the axis. Printed for y: −0.003 % before, +0.007 % after.")};
  report::Section section{"slopes", "Slopes", true, {}};
  section.blocks.emplace_back(std::move(table));
  document.sections.push_back(std::move(section));
  return experiment;
}

}  // namespace axiometry::app::lee
