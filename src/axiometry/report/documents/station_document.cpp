// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/report/sections/sections.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/tracking.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using tracking::LinearFit;
using tracking::RefinedFit;
using tracking::StationLocation;

constexpr char axis_names[] = {'X', 'Y', 'Z'};
constexpr std::size_t most_points_shown = 500;
constexpr std::size_t most_beams_shown = 20;

TableCell number(double x, int decimals, const Options& options) {
  return text_cell(format_fixed(x, decimals, options.numbers));
}

/// A computed number to a few digits, with powers of ten where it needs them.
std::string few_digits(double x, const Options& options) {
  if (x != 0.0 && (std::abs(x) < 1e-3 || std::abs(x) >= 1e6)) {
    std::string text = fmt::format("{:.1e}", x);
    std::ranges::replace(text, '.', options.numbers.decimal_mark);
    return text;
  }
  return shown_short(x, options, 4);
}

double u_um(const Matrix3& covariance, std::size_t k) { return 1000.0 * std::sqrt(covariance[k][k]); }

/// An uncertainty in µm, "undetermined" where it says nothing.
TableCell uncertainty_cell(double um, const Options& options) {
  if (!(um < 1e6)) return quiet_cell("undetermined");
  return number(um, decimals_for(um, 2), options);
}

Table estimator_table(const StationLocation& location, const Options& options) {
  const RefinedFit& refined = location.refined;
  const bool both = location.has_linear();
  Table table;
  table.columns = {{plain("Coordinate"), Align::start, true},
                   {plain("Refined / mm"), Align::decimal},
                   {joined({italic("u"), plain(" / µm")}), Align::decimal},
                   {plain("Linear, eq. 14 / mm"), Align::decimal, false, false, true},
                   {joined({italic("u"), plain(" / µm")}), Align::decimal},
                   {plain("Refined − linear / µm"), Align::decimal, false, false, true},
                   {joined({italic("u"), plain(" / µm")}), Align::decimal}};
  for (std::size_t k = 0; k < 3; ++k) {
    auto& row = table.rows.emplace_back();
    row = {text_cell(std::string_view(&axis_names[k], 1)), number(refined.station_mm[k], 4, options),
           uncertainty_cell(u_um(refined.covariance_mm2, k), options)};
    if (both) {
      row.push_back(number(location.linear->station_mm[k], 4, options));
      row.push_back(uncertainty_cell(u_um(location.linear->covariance_mm2, k), options));
      row.push_back(number(1000.0 * location.difference_mm[k], 2, options));
      row.push_back(uncertainty_cell(1000.0 * location.difference_u_mm[k], options));
    } else {
      row.insert(row.end(), 4, quiet_cell("–"));
    }
  }
  auto& zero = table.rows.emplace_back();
  zero = {{symbol("L_0")},
          number(refined.L0_mm, 4, options),
          uncertainty_cell(1000.0 * std::sqrt(refined.L0_variance_mm2), options)};
  zero.push_back(both ? number(location.linear->L0_mm, 4, options) : quiet_cell("–"));
  zero.insert(zero.end(), 3, quiet_cell("–"));
  table.notes.push_back(joined(
      {italic("u"), plain(": standard uncertainty. Of the refined station it holds what the residuals demand; of the "
                          "linear one and of the difference it follows from the uncertainties stated.")}));
  if (!both && location.linear)
    table.notes.push_back(
        plain(fmt::format("Eq. 14 has no unique solution for these points (rank {} of 5).", location.linear->rank)));
  return table;
}

Facts quality_facts(const StationLocation& location, const Options& options) {
  Facts facts{"Quality", {}};
  const auto add = [&](RichText name, std::string_view value) {
    facts.facts.push_back({std::move(name), text_cell(value)});
  };
  if (location.linear) {
    const LinearFit& fit = *location.linear;
    add(plain("Rank and condition of eq. 14"),
        fmt::format("{} of 5, {}", fit.rank, fit.condition < 1e15 ? few_digits(fit.condition, options) : "infinite"));
    if (location.has_linear()) {
      add(plain("Redundant residual of eq. 14"), few_digits(fit.redundant_residual_mm2, options) + " mm²");
      add(plain("Misclosure of ψ"),
          fmt::format("{} mm², standard uncertainty {} mm²", few_digits(fit.misclosure_mm2, options),
                      few_digits(fit.misclosure_u_mm2, options)));
    }
  }
  const RefinedFit& fit = location.refined;
  add(plain("Condition of the refined problem"),
      fit.condition < 1e15 ? few_digits(fit.condition, options) : std::string("infinite"));
  add(plain("χ² of the residuals"),
      fit.degrees_of_freedom == 0 ? std::string("none: no redundant length")
                                  : fmt::format("{} with {} degree{} of freedom", few_digits(fit.chi_squared, options),
                                                fit.degrees_of_freedom, fit.degrees_of_freedom == 1 ? "" : "s"));
  std::string surface(tracking::critical_surface_name(location.surface));
  if (location.eccentricity)
    surface += fmt::format(", eccentricity {}", format_fixed(*location.eccentricity, 3, options.numbers));
  add(plain("Critical surface"), surface);
  if (fit.mirror_mm)
    add(plain("Other station that fits"),
        fmt::format("{}, {}, {} mm", format_fixed(fit.mirror_mm->x, 3, options.numbers),
                    format_fixed(fit.mirror_mm->y, 3, options.numbers),
                    format_fixed(fit.mirror_mm->z, 3, options.numbers)));
  return facts;
}

Table residual_table(const StationSubject& subject, const Options& options) {
  const StationLocation& location = subject.location;
  const RefinedFit& fit = location.refined;
  Table table;
  table.columns = {
      {italic("i"), Align::start, true},       {plain("X / mm"), Align::decimal},
      {plain("Y / mm"), Align::decimal},       {plain("Z / mm"), Align::decimal},
      {plain("ΔL / mm"), Align::decimal},      {plain("Residual, linear / µm"), Align::decimal, false, false, true},
      {plain("refined / µm"), Align::decimal}, {plain("σ / µm"), Align::decimal},
      {plain("refined / σ"), Align::decimal}};
  for (std::size_t i = 0; i < std::min(subject.points.size(), most_points_shown); ++i) {
    const LocationPoint& p = subject.points[i];
    table.rows.push_back(
        {text_cell(fmt::format("{}", i + 1)), number(p.at_mm.x, 3, options), number(p.at_mm.y, 3, options),
         number(p.at_mm.z, 3, options), number(p.length_difference_mm, 4, options),
         location.has_linear() ? number(1000.0 * location.linear->residuals_mm[i], 2, options) : quiet_cell("–"),
         number(1000.0 * fit.residuals_mm[i], 2, options), number(1000.0 * fit.sigma_mm[i], 2, options),
         number(fit.residuals_mm[i] / fit.sigma_mm[i], 1, options)});
  }
  if (subject.points.size() > most_points_shown)
    table.notes.push_back(
        plain(fmt::format("… and {} more; all of them stand in the JSON.", subject.points.size() - most_points_shown)));
  table.notes.push_back(
      plain("Residual: the distance from the station found, less L0 and the length shown. Positive: the length shown "
            "is too small for the point."));
  table.dense = subject.points.size() > 12;
  return table;
}

Table covariance_table(const Matrix3& covariance, const Options& options) {
  Table table;
  table.caption = plain("Covariance of the refined station in µm²");
  table.columns = {{plain(""), Align::start, true}};
  for (char axis : axis_names) table.columns.push_back({plain(std::string_view(&axis, 1)), Align::decimal});
  for (std::size_t i = 0; i < 3; ++i) {
    auto& row = table.rows.emplace_back();
    row.push_back(text_cell(std::string_view(&axis_names[i], 1)));
    for (std::size_t k = 0; k < 3; ++k) row.push_back(text_cell(few_digits(1e6 * covariance[i][k], options)));
  }
  return table;
}

Layout station_layout(const StationSubject& subject) {
  Layout layout;
  layout.stations_mm = {subject.location.refined.station_mm};
  for (const LocationPoint& p : subject.points) {
    layout.points_mm.push_back(p.at_mm);
    if (subject.points.size() <= most_beams_shown)
      layout.lines.push_back(
          {.begin_mm = subject.location.refined.station_mm, .end_mm = p.at_mm, .label = "", .beam = true});
  }
  layout.title = "The station and the points from which it was found";
  layout.description =
      "The points of the reflector in space, the station and the beams to them, in a parallel projection and three "
      "views.";
  return layout;
}

Section findings_of(std::span<const tracking::Finding> findings) {
  Section section{"findings", "Findings", false, {}};
  if (findings.empty())
    section.blocks.emplace_back(Paragraph{plain("None: the two estimators and the lengths agree.")});
  for (const tracking::Finding& f : findings)
    section.blocks.emplace_back(Notice{f.serious ? Tone::bad : Tone::caution, sentence(f.message), {}});
  return section;
}

Notice status(const StationLocation& location) {
  if (!location.is_serious())
    return {Tone::good,
            plain("The station was found"),
            {plain("Its covariance belongs to the lengths and points given; see Findings for what else they tell.")}};
  Notice notice{Tone::bad, plain("The station should not be used as it is; see Findings"), {}};
  for (const tracking::Finding& f : location.findings)
    if (f.serious && notice.lines.size() < 3) notice.lines.push_back(sentence(f.message));
  return notice;
}

Section method_section(const StationSubject& subject, const Options& options) {
  const tracking::StationOptions& o = subject.options;
  Section section{"method", "Method", false, {}};
  section.blocks.emplace_back(Paragraph{plain(fmt::format(
      "Changes of the distance between the station and the reflector at known points (Lee et al., Sensors 16 (2016) "
      "482, eqs 11 to 15). Linear: eq. 14 in centred and scaled coordinates. Refined: least squares of the lengths "
      "with the weights 1/σ², from many starts. σ follows from U = {} µm + {} µm/m · L (k = 2) of the instrument{}.",
      shown_short(o.ranging.constant.in_um(), options), shown_short(o.ranging.per_length.in_um_per_m(), options),
      o.machine_sigma_mm > 0.0
          ? fmt::format(" and {} µm of the machine's points", shown_short(1000.0 * o.machine_sigma_mm, options))
          : std::string("; no uncertainty of the machine's points was stated")))});
  return section;
}

std::string place(Vector3 v, const Options& options) {
  return fmt::format("X {}, Y {}, Z {} mm", format_fixed(v.x, 3, options.numbers),
                     format_fixed(v.y, 3, options.numbers), format_fixed(v.z, 3, options.numbers));
}

/// What the points were chosen for: with another tool or another mounting they may be out of reach or sight.
Facts planned_setup(const TrackingSetup& setup, const Options& options) {
  return {"For this set-up",
          {{plain("Station, about"), text_cell(place(setup.station.position_mm, options))},
           {plain("Reflector, from where the axes stand"), text_cell(place(setup.tool_offset_mm, options))},
           {plain("The reflector looks along"),
            text_cell(fmt::format("{}, up to {}° aside", shown_vector(setup.limits.reflector_axis, options, 3),
                                  shown_short(setup.limits.incidence_most_deg, options)))},
           {plain("Safe radius about the station"),
            text_cell(shown_short(setup.limits.safe_radius_mm, options) + "\u00a0mm")}}};
}

Document title_page(std::string_view kind, std::string_view title, const Options& options) {
  Document document;
  document.kind = std::string(kind);
  document.title = std::string(title);
  document.edition = "Lee et al. 2016, eqs 11 to 15";
  document.running_head = translated(title, options);
  return document;
}

}  // namespace

Document compose(const StationSubject& subject, const Options& options) {
  const StationLocation& location = subject.location;
  Document document = title_page("Station location", "Station of a tracking interferometer", options);
  document.running_status = location.is_serious() ? "Not to be used as it is" : "Station found";
  document.identity = {{plain("Points"), text_cell(fmt::format("{}", subject.points.size()))},
                       {plain("File"), file_cell(subject.file)}};
  document.status = {status(location)};
  Section results{"station", "Station", true, {}};
  results.blocks.emplace_back(estimator_table(location, options));
  results.blocks.emplace_back(quality_facts(location, options));
  document.sections.push_back(std::move(results));
  document.sections.push_back(findings_of(location.findings));
  Section figures{"figures", "Layout", true, {}};
  figures.blocks.emplace_back(layout_figure(station_layout(subject), options));
  document.sections.push_back(std::move(figures));
  Section residuals{"residuals", "Points and residuals", true, {}};
  residuals.blocks.emplace_back(residual_table(subject, options));
  residuals.blocks.emplace_back(covariance_table(location.refined.covariance_mm2, options));
  document.sections.push_back(std::move(residuals));
  document.sections.push_back(method_section(subject, options));
  Facts source{"", {{plain("File"), verbatim_cell(subject.file)}, {plain("SHA-256"), verbatim_cell(subject.sha256)}}};
  document.sections.push_back({"provenance", "Provenance", false, {std::move(source)}});
  return document;
}

Document compose(const LocationPlanSubject& subject, const Options& options) {
  const tracking::LocationQuality& quality = subject.plan.quality;
  Document document = title_page("Test plan", "Points for the station location", options);
  document.running_status = "Plan, no measurement";
  document.identity = {{plain("Points"), text_cell(fmt::format("{}", subject.plan.points_mm.size()))}};
  Table points;
  points.groups = {{{}, 1}, {plain("Axes / mm"), 3}, {plain("Reflector / mm"), 3}, {{}, 1}};
  points.columns = {{italic("i"), Align::start, true},
                    {plain("X"), Align::decimal, false, false, true},
                    {plain("Y"), Align::decimal},
                    {plain("Z"), Align::decimal},
                    {plain("X"), Align::decimal, false, false, true},
                    {plain("Y"), Align::decimal},
                    {plain("Z"), Align::decimal},
                    {plain("ΔL / mm"), Align::start, false, false, true}};
  for (std::size_t i = 0; i < subject.plan.points_mm.size(); ++i) {
    const Vector3 p = subject.plan.points_mm[i], q = p - subject.setup.tool_offset_mm;
    auto& row = points.rows.emplace_back();
    row.push_back(text_cell(fmt::format("{}", i + 1)));
    for (const Vector3& v : {q, p})
      for (std::size_t k = 0; k < 3; ++k) row.push_back(number(v[k], 3, options));
    row.push_back(quiet_cell("______________"));
  }
  points.notes = {plain("Drive in this order without breaking the beam. Each length is the change since the zero.")};
  Section list{"points", "Points", true, {planned_setup(subject.setup, options), std::move(points)}};
  document.sections.push_back(std::move(list));

  Facts expected{"What they will tell", {}};
  for (std::size_t k = 0; k < 3; ++k)
    expected.facts.push_back({plain(fmt::format("Station in {}", axis_names[k])),
                              text_cell(fmt::format("standard uncertainty {} µm; {} µm for each µm of a length",
                                                    shown_short(u_um(quality.covariance_mm2, k), options, 2),
                                                    format_fixed(quality.amplification[k], 2, options.numbers)))});
  expected.facts.push_back({plain("Condition, refined"), text_cell(few_digits(quality.condition_refined, options))});
  expected.facts.push_back({plain("Condition, eq. 14"), text_cell(few_digits(quality.condition_linear, options))});
  Section outlook{"quality", "Expected quality", true, {std::move(expected)}};
  for (const std::string& remark : subject.plan.remarks)
    outlook.blocks.emplace_back(Notice{Tone::caution, sentence(remark), {}});
  document.sections.push_back(std::move(outlook));

  Layout layout;
  layout.box = TravelBox{subject.setup.travel.lowest_mm + subject.setup.tool_offset_mm,
                         subject.setup.travel.highest_mm + subject.setup.tool_offset_mm};
  layout.stations_mm = {subject.setup.station.position_mm};
  layout.safe_radius_mm = subject.setup.limits.safe_radius_mm;
  layout.points_mm = layout.way_mm = subject.plan.points_mm;
  layout.obstacles = subject.setup.obstacles;
  layout.title = "Points of the station location and the way between them";
  layout.description = "The box is where the reflector can be; the sphere about the station stays free.";
  document.sections.push_back({"layout", "Layout", true, {layout_figure(layout, options)}});
  return document;
}

}  // namespace axiometry::report
