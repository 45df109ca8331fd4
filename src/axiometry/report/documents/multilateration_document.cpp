// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/report/figures/residuals.h"
#include "axiometry/report/sections/fact.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/sections/source_files.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/tracking.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using tracking::MultilaterationFit;
using tracking::ScaleModel;

constexpr std::size_t most_points_listed = 20;

std::string name_of(std::span<const std::string> names, std::size_t k) {
  return k < names.size() ? names[k] : fmt::format("{}", k + 1);
}

class Composition {
 public:
  Composition(const MultilaterationSubject& subject, const Options& options)
      : s_(subject), fit_(subject.fit), options_(options) {}

  Document compose() const {
    Document document;
    document.kind = "Multilateration";
    document.title = "Points and stations from lengths";
    document.edition = "Lee et al., Sensors 16 (2016) 482, eq. 2";
    document.running_head = translated(document.title, options_);
    document.running_status = document.edition;
    document.identity = {file_fact("Measured lengths")};
    document.status = {status()};
    document.sections = {result_section(), findings_section(), station_section(), point_section(), figure_section()};
    document.sections.push_back(method());
    document.sections.push_back(source());
    return document;
  }

 private:
  std::string number(double x, int decimals) const { return format_fixed(x, decimals, options_.numbers); }
  TableCell cell(double x, int decimals) const { return text_cell(number(x, decimals)); }
  std::string um(double mm) const { return shown_short(1000.0 * mm, options_, 3) + "\u00a0µm"; }

  Fact file_fact(std::string_view name) const { return {plain(name), file_cell(s_.file)}; }

  Notice status() const {
    const bool serious = std::ranges::any_of(fit_.findings, &tracking::Finding::serious);
    return {serious ? Tone::caution : Tone::good,
            plain(fmt::format("{} points and {} stations from {} lengths", fit_.points_mm.size(),
                              fit_.stations_mm.size(), fit_.residuals_mm.size())),
            serious ? std::vector<RichText>{plain("Read the findings before the result is used.")}
                    : std::vector<RichText>{}};
  }

  double rms_residual() const {
    double squares = 0.0;
    for (double w : fit_.residuals_mm) squares += w * w;
    return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(fit_.residuals_mm.size(), 1)));
  }

  std::string scale_text() const {
    const double prior = s_.options.scale_prior;
    const std::string known = prior > 0.0 ? fmt::format("1 ± {} (k = 1)", shown_short(prior, options_, 3)) : "unknown";
    switch (s_.options.scale) {
      case ScaleModel::fixed: return "known";
      case ScaleModel::common: return fmt::format("{}, the same for all stations", known);
      case ScaleModel::free: return fmt::format("{}, one for each station", known);
    }
    return "";
  }

  Section result_section() const {
    const auto& rank = fit_.rank;
    Facts facts{"", {}};
    facts.facts = {
        fact("Scale", scale_text()),
        fact("Equations",
             fmt::format("{} for {} unknowns beside {} of the gauge", rank.equations, rank.unknowns, rank.gauge)),
        fact("Residuals, root mean square", um(rms_residual())),
        fact("χ²/ν", fit_.degrees_of_freedom == 0
                         ? std::string("no redundancy")
                         : fmt::format("{} with ν = {}",
                                       number(fit_.chi_squared / static_cast<double>(fit_.degrees_of_freedom), 3),
                                       fit_.degrees_of_freedom)),
        fact("Condition of the reduced system", shown_short(rank.condition, options_, 3)),
        fact("Station known worst, along its weakest direction", um(rank.weakest_mm)),
        fact("Stations off their common plane by up to",
             shown_short(rank.stations_off_plane_mm, options_, 4) + "\u00a0mm"),
        fact("Least number of points for so many stations", fmt::format("{}", rank.points_least)),
        fact("Iterations", fmt::format("{}", fit_.iterations))};
    return {"result", "Result", true, {std::move(facts)}};
  }

  Section station_section() const {
    std::vector<std::size_t> readings(fit_.stations_mm.size(), 0);
    std::vector<double> squares(fit_.stations_mm.size(), 0.0);
    for (std::size_t k = 0; k < s_.readings.size(); ++k) {
      ++readings[s_.readings[k].station];
      squares[s_.readings[k].station] += fit_.residuals_mm[k] * fit_.residuals_mm[k];
    }
    Table table;
    table.groups = {{{}, 1}, {plain("Place / mm"), 3}, {joined({italic("u"), plain(" / µm")}), 3}, {{}, 2}};
    table.columns = {{plain("Station"), Align::start, true}};
    for (const char* axis : {"X", "Y", "Z"}) table.columns.push_back({plain(axis), Align::decimal});
    for (const char* axis : {"X", "Y", "Z"}) table.columns.push_back({plain(axis), Align::decimal});
    table.columns.push_back({plain("Readings"), Align::decimal});
    table.columns.push_back({plain("rms / µm"), Align::decimal});
    for (std::size_t j = 0; j < fit_.stations_mm.size(); ++j) {
      auto& row = table.rows.emplace_back();
      row.push_back(verbatim_cell(name_of(s_.options.station_names, j)));
      for (std::size_t c = 0; c < 3; ++c) row.push_back(cell(fit_.stations_mm[j][c], 4));
      for (std::size_t c = 0; c < 3; ++c)
        row.push_back(cell(1000.0 * std::sqrt(fit_.station_covariances_mm2[j][c][c]), 2));
      row.push_back(text_cell(fmt::format("{}", readings[j])));
      row.push_back(
          cell(1000.0 * std::sqrt(squares[j] / static_cast<double>(std::max<std::size_t>(readings[j], 1))), 3));
    }
    table.notes = {
        plain("Standard uncertainties (k = 1) relative to the points as a whole, which lie on the nominal "
              "ones by least squares.")};
    return {"stations", "Stations", true, {std::move(table), dead_path_table()}};
  }

  Table dead_path_table() const {
    const bool scales = s_.options.scale != ScaleModel::fixed;
    Table table;
    table.columns = {{plain("Station"), Align::start, true},
                     {plain("Segment"), Align::decimal},
                     {joined({symbol("l_0"), plain(" / mm")}), Align::decimal},
                     {joined({italic("u"), plain(" / µm")}), Align::decimal}};
    if (scales) {
      table.columns.push_back({joined({italic("κ"), plain(" − 1 / 10⁻⁶")}), Align::decimal});
      table.columns.push_back({joined({italic("u"), plain(" / 10⁻⁶")}), Align::decimal});
    }
    for (std::size_t j = 0; j < fit_.dead_paths_mm.size(); ++j)
      for (std::size_t k = 0; k < fit_.dead_paths_mm[j].size(); ++k) {
        auto& row = table.rows.emplace_back();
        row = {verbatim_cell(name_of(s_.options.station_names, j)), text_cell(fmt::format("{}", k + 1)),
               cell(fit_.dead_paths_mm[j][k], 4), cell(1000.0 * fit_.dead_path_sigmas_mm[j][k], 2)};
        if (!scales) continue;
        row.push_back(cell(1e6 * (fit_.scales[j] - 1.0), 3));
        row.push_back(cell(1e6 * fit_.scale_sigmas[j], 3));
      }
    table.caption = plain(scales ? "Dead paths and scales" : "Dead paths");
    table.dense = table.rows.size() > 12;
    return table;
  }

  /// Statistics of all points, and those farthest from nominal.
  Section point_section() const {
    Section section{"points", "Points", true, {}};
    const std::size_t n = fit_.points_mm.size();
    std::vector<double> off(n), u(n, 0.0);
    for (std::size_t i = 0; i < n; ++i) {
      off[i] = 1000.0 * distance(fit_.points_mm[i], s_.nominal_mm[i]);
      if (fit_.point_covariances_mm2.empty()) continue;
      const Matrix3& c = fit_.point_covariances_mm2[i];
      u[i] = 1000.0 * std::sqrt((c[0][0] + c[1][1] + c[2][2]) / 3.0);
    }
    Table table;
    table.columns = {{plain("Over all points, in µm"), Align::start, true},
                     {plain("Median"), Align::decimal},
                     {plain("95 % below"), Align::decimal},
                     {plain("Largest"), Align::decimal}};
    const auto add = [&](std::string_view name, std::vector<double> values) {
      std::ranges::sort(values);
      const auto at = [&](double share) {
        return values[static_cast<std::size_t>(share * static_cast<double>(n - 1))];
      };
      table.rows.push_back({text_cell(name), cell(at(0.5), 2), cell(at(0.95), 2), cell(at(1.0), 2)});
    };
    add("Distance from nominal", off);
    if (!fit_.point_covariances_mm2.empty()) add("Standard uncertainty per axis", u);
    section.blocks.emplace_back(std::move(table));
    section.blocks.emplace_back(point_table(off));
    return section;
  }

  Table point_table(const std::vector<double>& off) const {
    std::vector<std::size_t> order(off.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    const bool all = order.size() <= most_points_listed;
    if (!all) std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return off[a] > off[b]; });
    order.resize(std::min(order.size(), most_points_listed));
    const bool with_u = !fit_.point_covariances_mm2.empty();
    Table table;
    table.caption = plain(all ? "All points" : fmt::format("The {} points farthest from nominal", order.size()));
    table.groups = {{{}, 1}, {plain("Place / mm"), 3}, {plain("Off nominal / µm"), 3}};
    if (with_u) table.groups.push_back({joined({italic("u"), plain(" / µm")}), 3});
    table.columns = {{plain("Point"), Align::start, true}};
    for (int group = 0; group < (with_u ? 3 : 2); ++group)
      for (const char* axis : {"X", "Y", "Z"}) table.columns.push_back({plain(axis), Align::decimal});
    for (const std::size_t i : order) {
      auto& row = table.rows.emplace_back();
      row.push_back(verbatim_cell(name_of(s_.options.point_names, i)));
      const Vector3 d = 1000.0 * (fit_.points_mm[i] - s_.nominal_mm[i]);
      for (std::size_t c = 0; c < 3; ++c) row.push_back(cell(fit_.points_mm[i][c], 4));
      for (std::size_t c = 0; c < 3; ++c) row.push_back(cell(d[c], 2));
      for (std::size_t c = 0; with_u && c < 3; ++c)
        row.push_back(cell(1000.0 * std::sqrt(fit_.point_covariances_mm2[i][c][c]), 2));
    }
    table.dense = true;
    return table;
  }

  Section figure_section() const {
    Section section{"figures", "Figures", true, {}};
    Layout layout;
    layout.title = "Stations and points";
    layout.description = "A parallel projection of the stations and the points, with three views along the axes.";
    layout.stations_mm = fit_.stations_mm;
    for (std::size_t k = 0; k < fit_.points_mm.size(); ++k) {
      layout.points_mm.push_back(fit_.points_mm[k]);
      layout.point_names.push_back(name_of(s_.options.point_names, k));
    }
    for (std::size_t j = 0; j < fit_.stations_mm.size(); ++j)
      layout.station_names.push_back(name_of(s_.options.station_names, j));
    // This one fits below the points, the layout does not.
    if (auto figure = residual_figure(fit_.normalised_residuals, options_))
      section.blocks.emplace_back(*std::move(figure));
    section.blocks.emplace_back(layout_figure(layout, options_));
    return section;
  }

  Section findings_section() const {
    Section section{"findings", "Findings", false, {}};
    if (fit_.findings.empty()) {
      section.blocks.emplace_back(Paragraph{plain("No findings: nothing speaks against the result.")});
      return section;
    }
    Table table;
    table.columns = {{plain("Kind"), Align::start, true}, {plain("Finding"), Align::start, false, true}};
    for (const auto& f : fit_.findings)
      table.rows.push_back({f.serious ? TableCell{strong("Serious"), Tone::bad} : TableCell{plain("Note"), Tone::quiet},
                            TableCell{sentence(f.message)}});
    section.blocks.emplace_back(std::move(table));
    return section;
  }

  Section method() const {
    const auto& ranging = s_.options.ranging;
    std::string text = fmt::format(
        "Points, stations and dead paths are those that minimise the weighted squares of the residuals of all lengths "
        "(Gauss–Newton, points eliminated). Weights follow U = {} µm + {} µm/m · L (k = 2)",
        shown_short(ranging.constant.in_um(), options_), shown_short(ranging.per_length.in_um_per_m(), options_));
    if (s_.options.repeatability_sigma_mm > 0.0)
      text += fmt::format(" and a repeatability of the machine of {} µm (k = 1)",
                          shown_short(1000.0 * s_.options.repeatability_sigma_mm, options_));
    text +=
        ". Lengths tell neither position nor orientation: the result was moved onto the nominal points by least "
        "squares, and covariances are those of the same inner constraints, multiplied by χ²/ν where that is above 1.";
    return {"method", "Method", false, {Paragraph{plain(text)}}};
  }

  Section source() const {
    std::vector<SourceFile> files = {{"Measured lengths", s_.file, s_.sha256}};
    if (!s_.points_file.empty()) files.push_back({"Nominal points", s_.points_file, s_.points_sha256});
    return provenance_of_files(files);
  }

  const MultilaterationSubject& s_;
  const MultilaterationFit& fit_;
  const Options& options_;
};

}  // namespace

Document compose(const MultilaterationSubject& subject, const Options& options) {
  return Composition(subject, options).compose();
}

}  // namespace axiometry::report
