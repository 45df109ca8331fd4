// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/counted.h"
#include "axiometry/model/aligned.h"
#include "axiometry/report/documents/plan_sheet.h"
#include "axiometry/report/sections/fact.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/tracking.h"
#include "axiometry/report/translated.h"
#include "axiometry/tracking/lines/seven_lines.h"

namespace axiometry::report {
namespace {

constexpr int place_decimals = 3;  // decimals of coordinates in mm
constexpr std::size_t most_targets_of_line = 200;

/// What the tables and the picture are made of.
struct Sheet {
  const TrackingPlan& plan;
  const Options& options;

  std::string number(double x, int decimals) const { return format_fixed(x, decimals, options.numbers); }
  std::string mm(double x) const { return shown_short(x, options) + "\u00a0mm"; }
  std::string degrees(double x) const { return shown_short(x, options) + "°"; }
  std::string place(Vector3 v) const {
    return fmt::format("X {}, Y {}, Z {}", number(v.x, place_decimals), number(v.y, place_decimals),
                       number(v.z, place_decimals));
  }
  Vector3 reflector(Vector3 axes) const { return axes + plan.setup.tool_offset_mm; }
};

Facts set_up_facts(const Sheet& sheet) {
  const TrackingSetup& setup = sheet.plan.setup;
  Facts facts{"Machine and station", {}};
  for (std::size_t k = 0; k < 3; ++k)
    facts.facts.push_back(fact(fmt::format("Travel of {}", "XYZ"[k]),
                               fmt::format("{} to {}", shown_short(setup.travel.lowest_mm[k], sheet.options),
                                           sheet.mm(setup.travel.highest_mm[k]))));
  facts.facts.push_back(fact("Reflector, from where the axes stand", sheet.place(setup.tool_offset_mm) + " mm"));
  if (is_aligned(setup)) {
    facts.facts.push_back(fact("Interferometer", "aligned with each line in turn"));
    return facts;
  }
  facts.facts.push_back(
      fact("Station, in the reflector's coordinates", sheet.place(setup.station.position_mm) + " mm"));
  if (const auto& covariance = setup.station.covariance_mm2) {
    const auto u = [&](std::size_t k) {
      return shown_short(2000.0 * std::sqrt((*covariance)[k][k]), sheet.options, 2);
    };
    facts.facts.push_back(fact("Its expanded uncertainty (k = 2)", fmt::format("{}, {}, {} µm", u(0), u(1), u(2))));
  } else {
    facts.facts.push_back({plain("Its uncertainty"), quiet_cell("not stated: locate the station")});
  }
  return facts;
}

std::string obstacle_text(const Sheet& sheet, const BoxObstacle& box) {
  return fmt::format("box, {} to {} mm", sheet.place(box.lowest_mm), sheet.place(box.highest_mm));
}
std::string obstacle_text(const Sheet& sheet, const SphereObstacle& sphere) {
  return fmt::format("sphere about {} mm, radius {}", sheet.place(sphere.centre_mm), sheet.mm(sphere.radius_mm));
}
std::string obstacle_text(const Sheet& sheet, const CylinderObstacle& cylinder) {
  return fmt::format("upright cylinder on {} mm, radius {}, height {}", sheet.place(cylinder.base_mm),
                     sheet.mm(cylinder.radius_mm), sheet.mm(cylinder.height_mm));
}

void append_limits(Facts& facts, const Sheet& sheet) {
  const TrackerLimits& limits = sheet.plan.setup.limits;
  facts.facts.push_back(fact("Range", fmt::format("{} to {}", shown_short(limits.range_least_mm, sheet.options),
                                                  sheet.mm(limits.range_most_mm))));
  facts.facts.push_back(
      fact("Elevation of the beam", fmt::format("{} to {}", sheet.degrees(limits.elevation_lowest_deg),
                                                sheet.degrees(limits.elevation_highest_deg))));
  facts.facts.push_back(fact("The reflector looks along", shown_vector(limits.reflector_axis, sheet.options, 3)));
  facts.facts.push_back(fact("Largest incidence", sheet.degrees(limits.incidence_most_deg)));
  facts.facts.push_back(fact("Safe radius about the station", sheet.mm(limits.safe_radius_mm)));
  facts.facts.push_back(fact("Least length of a line", sheet.mm(limits.line_least_mm)));
}

Facts limit_facts(const Sheet& sheet) {
  Facts facts{is_aligned(sheet.plan.setup) ? "Obstacles" : "Limits of instrument and reflector", {}};
  if (!is_aligned(sheet.plan.setup)) append_limits(facts, sheet);
  for (const Obstacle& obstacle : sheet.plan.setup.obstacles)
    facts.facts.push_back(
        fact(obstacle.name.empty() ? "Obstacle" : "Obstacle: " + obstacle.name,
             std::visit([&](const auto& shape) { return obstacle_text(sheet, shape); }, obstacle.shape)));
  return facts;
}

/// Where a lost line would have gone: as far as the smallest travel, into the half of the travels with more room.
Layout::Item lost_item(const TrackingSetup& setup, const std::string& id) {
  const Vector3 station = setup.station.position_mm;
  const Vector3 low = setup.travel.lowest_mm + setup.tool_offset_mm,
                high = setup.travel.highest_mm + setup.tool_offset_mm;
  Vector3 direction;
  double length = norm(high - low);
  for (std::size_t k = 0; k < 3; ++k) {
    length = std::min(length, 0.5 * (high[k] - low[k]));
    if (id.find("xyz"[k]) != std::string::npos) direction[k] = high[k] - station[k] >= station[k] - low[k] ? 1.0 : -1.0;
  }
  return {station, station + length * unit(direction), id, true};
}

/// Ways as they are driven: over the way points and along the lines.
std::vector<Vector3> whole_way(const Sheet& sheet) {
  std::vector<Vector3> way;
  for (const TrackingLine& line : sheet.plan.lines) {
    for (const Vector3& over : line.plan.way_in_mm) way.push_back(sheet.reflector(over));
    const SpatialLine along = *spatial_line(line.plan.axis);
    const Reach ends = reach(line.plan);
    for (Position at : {ends.lowest, ends.highest, ends.lowest}) way.push_back(sheet.reflector(along.at(at)));
    for (const Vector3& over : line.plan.way_out_mm) way.push_back(sheet.reflector(over));
  }
  return way;
}

Figure layout_of(const Sheet& sheet) {
  const TrackingSetup& setup = sheet.plan.setup;
  Layout layout;
  layout.box = TravelBox{sheet.reflector(setup.travel.lowest_mm), sheet.reflector(setup.travel.highest_mm)};
  if (!is_aligned(setup)) {
    layout.stations_mm = {setup.station.position_mm};
    layout.safe_radius_mm = setup.limits.safe_radius_mm;
  }
  for (const TrackingLine& line : sheet.plan.lines) {
    const SpatialLine along = *spatial_line(line.plan.axis);
    layout.lines.push_back({sheet.reflector(along.at(line.plan.targets.front())),
                            sheet.reflector(along.at(line.plan.targets.back())), line.id});
  }
  for (const LostLine& lost : sheet.plan.lost)
    if (std::ranges::find(tracking::seven_lines, lost.id) != tracking::seven_lines.end())
      layout.lines.push_back(lost_item(setup, lost.id));
  layout.way_mm = whole_way(sheet);
  layout.obstacles = setup.obstacles;
  layout.title = "Layout of the test";
  layout.description = fmt::format("Reach of the reflector, station and {}.", counted(sheet.plan.lines.size(), "line"));
  return layout_figure(layout, sheet.options);
}

Table line_table(const Sheet& sheet) {
  Table table;
  table.columns = {{plain("Line"), Align::start, true},
                   {plain("Standard")},
                   {plain("Octant")},
                   {plain("From / mm"), Align::decimal},
                   {plain("To / mm"), Align::decimal},
                   {plain("Ends at"), Align::start, false, true},
                   {plain("Targets"), Align::decimal},
                   {plain("Runs"), Align::decimal}};
  for (const TrackingLine& line : sheet.plan.lines) {
    const auto interval = tracking::interval_of(sheet.plan.setup, line);
    const auto dash = quiet_cell("–");
    table.rows.push_back(
        {verbatim_cell(line.id), text_cell(line.plan.standard), interval ? text_cell(interval->octant) : dash,
         interval ? text_cell(sheet.number(interval->begin_mm, 1)) : dash,
         interval ? text_cell(sheet.number(interval->end_mm, 1)) : dash,
         interval ? text_cell(fmt::format("{}; {}", translated(interval->limited_by_begin, sheet.options),
                                          translated(interval->limited_by_end, sheet.options)))
                  : dash,
         text_cell(fmt::format("{}", line.plan.targets.size())), text_cell(fmt::format("{}", line.plan.runs))});
  }
  if (is_aligned(sheet.plan.setup))
    table.notes.push_back(plain(
        "Each diagonal is driven over the full travels, in both directions. Align the interferometer with it before "
        "its first run, and set it to zero."));
  else
    table.notes.push_back(plain(
        "From and to are distances from the station between which the reflector can be driven and seen; overruns lie "
        "within. Octant: which way X, Y and Z go, away from the station."));
  return table;
}

Table lost_table(const Sheet& sheet) {
  Table table;
  table.columns = {{plain("Line"), Align::start, true}, {plain("Reason"), Align::start, false, true}};
  for (const LostLine& lost : sheet.plan.lost) table.rows.push_back({verbatim_cell(lost.id), text_cell(lost.reason)});
  return table;
}

Table way_table(const Sheet& sheet) {
  Table table;
  table.columns = {{plain("Way"), Align::start, true},
                   {plain("X / mm"), Align::decimal},
                   {plain("Y / mm"), Align::decimal},
                   {plain("Z / mm"), Align::decimal}};
  const auto row = [&](const std::string& name, Vector3 at) {
    table.rows.push_back({text_cell(name), text_cell(sheet.number(at.x, place_decimals)),
                          text_cell(sheet.number(at.y, place_decimals)),
                          text_cell(sheet.number(at.z, place_decimals))});
  };
  std::string from = "above";
  for (const TrackingLine& line : sheet.plan.lines) {
    for (const Vector3& over : line.plan.way_in_mm) row(fmt::format("{} → {}", from, line.id), over);
    row(fmt::format("beginning and end of {}", line.id), spatial_line(line.plan.axis)->at(reach(line.plan).lowest));
    for (const Vector3& over : line.plan.way_out_mm) row(fmt::format("{} → above", line.id), over);
    from = line.id;
  }
  table.notes.push_back(plain("Where the axes stand. Drive Z to its upper end before the program is started."));
  table.dense = table.rows.size() > 12;
  return table;
}

Table target_table(const Sheet& sheet, const TrackingLine& line) {
  const SpatialLine along = *spatial_line(line.plan.axis);
  Table table;
  table.columns = {{italic("i"), Align::start, true},
                   {joined({symbol("P_i"), plain(" / mm")}), Align::decimal},
                   {plain("X / mm"), Align::decimal},
                   {plain("Y / mm"), Align::decimal},
                   {plain("Z / mm"), Align::decimal}};
  const bool aligned = is_aligned(sheet.plan.setup);
  if (!aligned) table.columns.push_back({plain("From station / mm"), Align::decimal});
  const auto& targets = line.plan.targets;
  for (std::size_t i = 0; i < std::min(targets.size(), most_targets_of_line); ++i) {
    const Vector3 at = along.at(targets[i]);
    table.rows.push_back({text_cell(fmt::format("{}", i + 1)),
                          text_cell(sheet.number(targets[i].in_native(), place_decimals)),
                          text_cell(sheet.number(at.x, place_decimals)), text_cell(sheet.number(at.y, place_decimals)),
                          text_cell(sheet.number(at.z, place_decimals))});
    if (!aligned)
      table.rows.back().push_back(
          text_cell(sheet.number(distance(sheet.reflector(at), sheet.plan.setup.station.position_mm), place_decimals)));
  }
  if (targets.size() > most_targets_of_line)
    table.notes.push_back(
        plain(fmt::format("… and {} more; all of them stand in the plan.", targets.size() - most_targets_of_line)));
  table.dense = true;
  return table;
}

RichText programme_text(const Sheet& sheet, const TrackingLine& line) {
  const Plan& plan = line.plan;
  return joined({strong_verbatim(line.id),
                 plain(fmt::format(": {} in each direction, feed {}/min, dwell {} s, overrun {}{}",
                                   plan.runs == 1 ? "once" : fmt::format("{} times", plan.runs), sheet.mm(plan.feed),
                                   shown_short(plan.dwell.in_s(), sheet.options), sheet.mm(plan.overrun.in_native()),
                                   plan.seed ? fmt::format(", seed {}", *plan.seed) : ""))});
}

Section target_section(const Sheet& sheet) {
  Section section{"targets", "Target positions", false, {}};
  for (const TrackingLine& line : sheet.plan.lines) {
    Table table = target_table(sheet, line);
    table.caption = programme_text(sheet, line);
    section.blocks.emplace_back(std::move(table));
  }
  return section;
}

Notice status(const TrackingPlan& plan) {
  if (plan.lost.empty()) {
    const std::size_t lines = plan.lines.size();
    return {Tone::good,
            plain(lines == 1 ? std::string("The line can be measured")
                             : fmt::format("All {} lines can be measured", lines)),
            {}};
  }
  Notice notice{Tone::caution,
                plain(fmt::format("{} of {} can be measured", plan.lines.size(),
                                  counted(plan.lines.size() + plan.lost.size(), "line"))),
                {}};
  std::string lost;
  for (const LostLine& line : plan.lost) lost += (lost.empty() ? "" : ", ") + line.id;
  notice.lines.push_back(plain("Lost: " + lost + "."));
  return notice;
}

/// As a sentence; what is said of one line, "xy: …", keeps the name of the line as it is.
RichText remark_text(const TrackingPlan& plan, const std::string& remark) {
  for (const TrackingLine& line : plan.lines)
    if (remark.starts_with(line.id + ": ")) return {TextRun{.text = remark + "."}};
  return sentence(remark);
}

Section remark_section(const TrackingPlan& plan) {
  Section section{"remarks", "Remarks", false, {}};
  for (const std::string& remark : plan.remarks) section.blocks.emplace_back(Paragraph{remark_text(plan, remark)});
  return section;
}

Document title_page(const TrackingPlan& plan, Duration duration, const Options& options) {
  Document document;
  document.kind = "Test plan";
  document.title = !plan.title.empty()      ? plan.title
                   : is_aligned(plan.setup) ? "Diagonals by an aligned interferometer"
                                            : "Lines from a tracking interferometer";
  document.edition = is_aligned(plan.setup) ? "ISO 230-6:2002" : "ISO 230-2:2014, ISO 230-6:2002";
  document.identity = {
      {plain("Machine"), plan.machine.empty() ? quiet_cell("not stated") : verbatim_cell(plan.machine)},
      {plain("Date of plan"), plan.date.empty() ? quiet_cell("not stated") : verbatim_cell(plan.date)},
      {plain("Duration, about"), text_cell(duration_text(duration))}};
  document.status.push_back(status(plan));
  document.running_head = (plan.machine.empty() ? "" : plan.machine + " · ") + translated(document.title, options);
  document.running_status = "Test plan · " + document.edition;
  document.date = plan.date;
  return document;
}

}  // namespace

Document tracking_sheet(const TrackingPlan& plan, Duration duration, const Options& options) {
  const Sheet sheet{plan, options};
  Document document = title_page(plan, duration, options);
  document.sections.push_back({"lines", "Lines", false, {line_table(sheet)}});
  if (!plan.lost.empty())
    document.sections.push_back({"lost", "Lines that cannot be measured", false, {lost_table(sheet)}});
  if (!plan.remarks.empty()) document.sections.push_back(remark_section(plan));
  Section setup{"setup", "Set-up", false, {}};
  setup.blocks.emplace_back(set_up_facts(sheet));
  if (Facts limits = limit_facts(sheet); !limits.facts.empty()) setup.blocks.emplace_back(std::move(limits));
  setup.blocks.emplace_back(layout_of(sheet));
  document.sections.push_back(std::move(setup));
  document.sections.push_back({"ways", "Ways", false, {way_table(sheet)}});
  document.sections.push_back(target_section(sheet));
  return document;
}

}  // namespace axiometry::report
