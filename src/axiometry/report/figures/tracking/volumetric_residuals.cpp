// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/figures/tracking/volumetric_residuals.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "axiometry/report/figures/parts/axis_measures.h"
#include "axiometry/report/figures/parts/crowd.h"
#include "axiometry/report/figures/parts/ink.h"
#include "axiometry/report/figures/parts/label.h"
#include "axiometry/report/figures/parts/legend.h"
#include "axiometry/report/figures/parts/pane.h"
#include "axiometry/report/figures/parts/plate.h"
#include "axiometry/report/figures/parts/thinned.h"
#include "axiometry/report/translated.h"

namespace axiometry::report {
namespace {

using plot::Pane;
using plot::Range;
using volumetric::Identification;
using volumetric::VolumetricLengths;
namespace ink = plot::ink;

constexpr double residual_height = 88.0;
constexpr double between_panes = 15.0;
constexpr double dot_radius = 0.85;
constexpr double aside_radius = 1.6;
constexpr std::size_t stations_shown_most = 24;
constexpr Colour crowd_band = ink::faint(ink::blue, 0.32);

class ResidualDrawing {
 public:
  ResidualDrawing(const VolumetricLengths& lengths, const Identification& found, const Options& options)
      : lengths_(lengths), found_(found), options_(options), aside_(lengths.readings.size(), false) {
    for (const volumetric::SetAside& s : found.set_aside) aside_[s.reading] = true;
    double most = 0.0;
    for (std::size_t i = 0; i < aside_.size(); ++i)
      if (!aside_[i]) most = std::max(most, std::abs(found.residuals_um[i]));
    const double half = most > 0.0 ? 1.08 * most : 1.0;
    up_ = {-half, half};
  }

  Figure draw() {
    figure_.width = plot::plate_width;
    figure_.title = "Residuals of the lengths";
    figure_.description =
        "What is left of each length, in the order of measurement, over the positions of the axes and by station.";
    double top = plot::draw_legend(figure_.operations, entries(), {plot::header_left, 0.0},
                                   plot::plate_width - plot::header_left) +
                 4.0;
    left_ = plot::figure_edge + plot::title_room + plot::pane_label_width(up_, residual_height, options_.numbers);
    top = draw_order(top);
    top = draw_axes(top);
    figure_.height = draw_stations(top) + 2.0;
    return std::move(figure_);
  }

 private:
  static double right_edge() { return plot::plate_width - 10.0; }
  std::string say(const char* words) const { return translated(words, options_); }

  std::vector<plot::LegendEntry> entries() const {
    std::vector<plot::LegendEntry> entries;
    entries.push_back({.line = std::nullopt,
                       .band = std::nullopt,
                       .mark = Disc{.centre = {}, .radius = 1.4, .fill = ink::blue},
                       .text = {plot::plain(say("readings"))}});
    if (aside_.size() - found_.set_aside.size() > plot::most_points_shown)
      entries.push_back(plot::crowd_entry(crowd_band, {plot::plain(say(plot::crowd_words))}));
    if (!found_.set_aside.empty())
      entries.push_back({.line = std::nullopt,
                         .band = std::nullopt,
                         .mark = Disc{.centre = {}, .radius = 1.8, .fill = ink::vermilion},
                         .text = {plot::plain(say("set aside, at the edge where beyond it"))}});
    entries.push_back({.line = ink::solid(ink::blue, 0.5),
                       .band = ink::faint(ink::blue, 0.22),
                       .mark = std::nullopt,
                       .text = {plot::plain(say("root mean square of a station"))}});
    return entries;
  }

  template <typename Place>
  void draw_all(const Pane& pane, const Place& place) {
    std::vector<Point> used, aside;
    for (std::size_t i = 0; i < aside_.size(); ++i) {
      const double um = found_.residuals_um[i];
      if (aside_[i])
        aside.push_back(pane.at(place(i), std::clamp(um, 0.97 * up_.low, 0.97 * up_.high)));
      else
        used.push_back(pane.at(place(i), um));
    }
    const plot::Crowd shown = plot::crowd(std::move(used));
    plot::draw_stretches(figure_.operations, shown.stretches, crowd_band);
    for (const Point& at : shown.dots)
      figure_.operations.push_back(
          Disc{.centre = at, .radius = dot_radius, .fill = ink::faint(ink::blue, ink::reading_alpha)});
    for (const Point& at : plot::apart(aside, aside_radius))
      figure_.operations.push_back(Disc{.centre = at, .radius = aside_radius, .fill = ink::vermilion});
  }

  void draw_titles(const Pane& pane, const std::string& below) {
    if (pane.y_labels)
      plot::draw_upright_title(figure_.operations, {plot::plain(say("Residual") + " / µm")},
                               {9.5, (pane.top + pane.bottom) / 2.0});
    figure_.operations.push_back(plot::label({plot::plain(below)},
                                             {(pane.left + pane.right) / 2.0, pane.bottom + plot::pane_axis_room - 1.5},
                                             ink::text_size, Anchor::middle));
  }

  double draw_order(double top) {
    const Pane pane{left_, right_edge(), top, top + residual_height, {0.0, static_cast<double>(aside_.size()) + 1.0},
                    up_,   true,         true};
    plot::draw_pane(figure_.operations, pane, options_.numbers);
    draw_all(pane, [](std::size_t i) { return static_cast<double>(i) + 1.0; });
    draw_titles(pane, say("Reading, in the order of measurement"));
    return pane.bottom + plot::pane_axis_room + 8.0;
  }

  double draw_axes(double top) {
    const double width = (right_edge() - left_ - 2.0 * between_panes) / 3.0;
    for (std::size_t a = 0; a < volumetric::axis_count; ++a) {
      const double left = left_ + static_cast<double>(a) * (width + between_panes);
      Range across{found_.model.observed().lowest_mm[a], found_.model.observed().highest_mm[a]};
      across = {across.low - 0.02 * across.size(), across.high + 0.02 * across.size()};
      const Pane pane{left, left + width, top, top + residual_height, across, up_, true, a == 0};
      plot::draw_pane(figure_.operations, pane, options_.numbers);
      draw_all(pane, [&](std::size_t i) { return lengths_.readings[i].axes_mm[a]; });
      draw_titles(pane, fmt::format("{} / mm", "XYZ"[a]));
    }
    return top + residual_height + plot::pane_axis_room + 8.0;
  }

  /// One upright line for each station with each tool; beyond two dozen those with the largest residuals.
  double draw_stations(double top) {
    std::vector<std::size_t> shown(found_.stations.size());
    for (std::size_t v = 0; v < shown.size(); ++v) shown[v] = v;
    if (shown.size() > stations_shown_most) {
      std::ranges::sort(shown, std::ranges::greater{}, [&](std::size_t v) { return found_.stations[v].rms_um; });
      shown.resize(stations_shown_most);
      std::ranges::sort(shown);
    }
    const Range across{0.0, static_cast<double>(shown.size())};
    const Pane pane{left_, right_edge(), top, top + residual_height, across, up_, false, true, false};
    plot::draw_pane(figure_.operations, pane, options_.numbers);
    const double pitch = (pane.right - pane.left) / across.high;
    for (std::size_t k = 0; k < shown.size(); ++k) draw_station(pane, shown[k], static_cast<double>(k) + 0.5, pitch);
    draw_titles(pane, say("Station and tool"));
    return pane.bottom + plot::pane_axis_room;
  }

  void draw_station(const Pane& pane, std::size_t v, double across, double pitch) {
    const volumetric::IdentifiedStation& station = found_.stations[v];
    Range range;
    for (std::size_t i = 0; i < aside_.size(); ++i) {
      const auto& r = lengths_.readings[i];
      if (!aside_[i] && r.station == station.station && r.tool == station.tool) range.see(found_.residuals_um[i]);
    }
    const double x = pane.x(across), half = std::min(0.32 * pitch, 9.0);
    if (range.any())
      figure_.operations.push_back(
          plot::line(pane.at(across, range.low), pane.at(across, range.high), ink::solid(ink::blue, 0.9)));
    const double high = pane.y(station.rms_um), low = pane.y(-station.rms_um);
    figure_.operations.push_back(Path{.points = {{x - half, high}, {x + half, high}, {x + half, low}, {x - half, low}},
                                      .closed = true,
                                      .stroke = ink::solid(ink::blue, 0.5),
                                      .fill = ink::faint(ink::blue, 0.22)});
    const std::string name = plot::shortened(lengths_.stations[station.station] + " " + lengths_.tools[station.tool],
                                             pitch - 3.0, ink::tick_text_size);
    TextRun run = plot::plain(name);
    run.verbatim = true;
    figure_.operations.push_back(
        plot::label({run}, {x, pane.bottom + plot::tick_length + 8.0}, ink::tick_text_size, Anchor::middle));
  }

  const VolumetricLengths& lengths_;
  const Identification& found_;
  const Options& options_;
  std::vector<bool> aside_;
  Range up_;
  double left_ = 0.0;
  Figure figure_;
};

}  // namespace

Figure volumetric_residual_figure(const VolumetricLengths& lengths, const Identification& found,
                                  const Options& options) {
  return ResidualDrawing(lengths, found, options).draw();
}

}  // namespace axiometry::report
