// SPDX-License-Identifier: Apache-2.0
//
// Clauses 3 and 4: what was measured, and under which conditions.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include "axiometry/base/text/text.h"
#include "axiometry/standards/iso230_2/common_reversal.h"
#include "axiometry/standards/iso230_2/inputs/resolved_inputs.h"
#include "axiometry/standards/iso230_2/rules/environment_findings.h"
#include "axiometry/standards/iso230_2/rules/message.h"
#include "axiometry/standards/iso230_2/rules/rules.h"
#include "axiometry/standards/iso230_2/slope.h"

namespace axiometry::iso230_2::rules {
namespace {

constexpr double same_temperature = 0.1 + 1e-9;  // °C: what a display resolves
constexpr double change_worth_a_word = 1.0;      // °C from start to end

struct Thermometer {
  std::string name;
  double start = 0.0;
  double end = 0.0;
  double worst() const { return std::abs(start - 20.0) > std::abs(end - 20.0) ? start : end; }
};

void add(std::vector<Thermometer>& list, std::string name, std::optional<Temperature> start,
         std::optional<Temperature> end) {
  if (!start && !end) return;
  const double first = (start ? *start : *end).in_celsius();
  list.push_back({std::move(name), first, end ? end->in_celsius() : first});
}

std::vector<Thermometer> sensors_of(const Environment& environment, std::string_view role) {
  std::vector<Thermometer> list;
  for (const TemperatureSensor& s : environment.sensors)
    if (text::equal_ignoring_case(s.role, role))
      add(list, fmt::format("the {} sensor{}", role, s.location.empty() ? "" : " (" + s.location + ")"), s.start,
          s.end);
  return list;
}

std::vector<Thermometer> of_the_air(const Environment& environment) {
  std::vector<Thermometer> list = sensors_of(environment, "air");
  add(list, "the air", environment.air_temperature_start, environment.air_temperature_end);
  return list;
}

/// Sensors on material; only without them does the air tell the temperature of the machine.
std::vector<Thermometer> material(const Environment& environment) {
  std::vector<Thermometer> list = sensors_of(environment, "machine");
  for (Thermometer& t : sensors_of(environment, "equipment")) list.push_back(std::move(t));
  return list.empty() ? of_the_air(environment) : list;
}

/// 4.1 allows the correction to happen by itself: one temperature, one expansion coefficient.
bool corrects_itself(const Metadata& metadata) {
  const auto machine = sensors_of(metadata.environment, "machine");
  const auto equipment = sensors_of(metadata.environment, "equipment");
  if (machine.empty() || equipment.empty()) return false;
  if (!metadata.nde.machine_expansion || metadata.nde.machine_expansion != metadata.nde.equipment_expansion)
    return false;
  return std::ranges::all_of(machine, [&](const Thermometer& m) {
    return std::ranges::all_of(equipment, [&](const Thermometer& e) {
      return std::abs(m.start - e.start) <= same_temperature && std::abs(m.end - e.end) <= same_temperature;
    });
  });
}

/// +1 when the readings of a cell only rise from run to run, −1 when they only fall, else 0.
int progression(std::span<const double> cell) {
  if (cell.back() == cell.front()) return 0;
  if (std::ranges::is_sorted(cell)) return 1;
  return std::ranges::is_sorted(cell, std::ranges::greater{}) ? -1 : 0;
}

}  // namespace

std::optional<Finding> both_ends_from_both_sides(const Case& c) {
  if (c.runs.up == 0 || c.runs.down == 0) return std::nullopt;  // directions_of_approach speaks
  std::string ends;
  for (std::size_t i : {std::size_t{0}, c.series.target_count() - 1}) {
    const bool up = c.series.count(i, Direction::up) > 0;
    const bool down = c.series.count(i, Direction::down) > 0;
    if (up && down) continue;
    ends += fmt::format("{}{} from {} only", ends.empty() ? "" : " and ", target_text(c, i), up ? "↑" : "↓");
  }
  if (ends.empty()) return std::nullopt;
  return departure(
      "both-ends-from-both-sides", "3.2",
      fmt::format("found an end of the measurement travel approached from one side, {}, expected both sides", ends));
}

/// Whether the targets would fit into the travel and most of them lie beside it.
bool counts_from_elsewhere(const AxisEnds& ends, double first, double last, double room) {
  if (!ends.lower || !ends.upper) return false;
  const double lower = ends.lower->in_native(), upper = ends.upper->in_native();
  const double inside = std::min(last, upper) - std::max(first, lower);
  return last - first <= upper - lower + room && inside < 0.5 * (last - first);
}

std::optional<Finding> targets_within_axis_travel(const Case& c) {
  const AxisEnds ends = axis_ends(c.metadata.axis);
  const double first = c.target(0), last = c.target(c.series.target_count() - 1);
  const double room = same_position.in_native();
  // 365° is a place of an axis that turns from 0° to 360°, and beyond no end of it.
  const bool turns_on = !c.linear() && ends.length_native().value_or(360.0) >= 360.0 - room;
  std::vector<std::string> outside, at_end;
  const auto look = [&](std::string_view which, double target, double beyond) {
    if (beyond > room && turns_on) return;
    if (beyond > room)
      outside.push_back(fmt::format("the {} target at {}", which, position_text(c, target)));
    else if (beyond >= 0.0)
      at_end.push_back(fmt::format("the {} target at {}", which, position_text(c, target)));
  };
  if (ends.lower) look("first", first, ends.lower->in_native() - first);
  if (ends.upper) look("last", last, last - ends.upper->in_native());
  if (!outside.empty() && counts_from_elsewhere(ends, first, last, room))
    return answered_by(
        {"axis.travel_begin", "axis.travel_end"},
        missing("targets-within-axis-travel", "3.2",
                fmt::format("found {} outside the axis travel, expected all targets within it: do both count from one "
                            "zero?",
                            fmt::join(outside, " and "))));
  if (!outside.empty())
    return departure(
        "targets-within-axis-travel", "3.2",
        fmt::format("found {} outside the axis travel, expected all targets within it", fmt::join(outside, " and ")));
  if (at_end.empty()) return std::nullopt;
  return note("targets-within-axis-travel", "3.2",
              fmt::format("found {} at the end of the axis travel, expected room to approach it from beyond",
                          fmt::join(at_end, " and ")));
}

/// As far as the programme of a test goes on an axis: 5.3.3 has no stretch, but the whole travel.
double programme_reach(Programme programme) {
  switch (programme) {
    case Programme::short_linear: return 2000.0;
    case Programme::long_linear: break;
    case Programme::one_turn: return 360.0;
    case Programme::many_turns: return 1800.0;
  }
  return std::numeric_limits<double>::infinity();
}

std::optional<Finding> part_of_axis_travel(const Case& c) {
  const auto whole = axis_ends(c.metadata.axis).length_native();
  if (!whole) return std::nullopt;
  const double stretch = std::min(*whole, programme_reach(c.programme));
  if (*whole <= 0.0 || c.travel() >= 0.8 * stretch) return std::nullopt;
  return note("part-of-axis-travel", "3.2",
              fmt::format("found {} measured of an axis travel of {}; the results hold for that part only",
                          position_text(c, c.travel()), position_text(c, *whole)));
}

std::optional<Finding> straight_slope(const Case& c) {
  const AxisParameters& p = c.evaluation.parameters;
  const char* symbol = p.E ? "E" : p.E_up ? "E↑" : "E↓";
  const double E = (p.E ? p.E : p.E_up ? p.E_up : p.E_down)->in_native();
  if (!c.linear() || c.series.target_count() < 4 || E <= 0.0) return std::nullopt;
  const auto slope = slope_of_means(c.evaluation.positions);
  if (!slope || slope->remainder.in_native() > 0.3 * E) return std::nullopt;
  return note("straight-slope", "3.24",
              message("found a straight slope of {} µm/m, without which {} would be {} instead of {}; such a slope "
                      "comes from a scale, an expansion{} or a correction, and nothing of it is removed",
                      size_text(1000.0 * slope->per_position_native), symbol,
                      deviation_message(c, slope->remainder.in_native()), deviation_message(c, E),
                      is_diagonal(c.metadata.axis) ? ", a squareness error" : ""));
}

/// No axis that is tested departs by a hundredth of its way, which is a millimetre or a degree at least: positions
/// stand in the place of deviations, or the unit is not that of the readings.
std::optional<Finding> readings_beyond_errors(const Case& c) {
  constexpr double share_of_way = 0.01, least_way = 1.0;  // mm or °
  const AxisParameters& p = c.evaluation.parameters;
  const double E = (p.E ? p.E : p.E_up ? p.E_up : p.E_down)->in_native();
  if (E < std::max(least_way, share_of_way * c.travel()) * deviation_per_position(c.kind())) return std::nullopt;
  return departure(
      "readings-beyond-errors", "3.6",
      message("found deviations that differ by {} over {} of targets, expected less than a hundredth of the "
              "way: are they deviations, and in the unit that is stated?",
              deviation_message(c, E), position_text(c, c.travel())));
}

std::optional<Finding> same_reversal_everywhere(const Case& c) {
  const auto with_both = std::ranges::count_if(
      c.evaluation.positions, [](const PositionResult& position) { return position.reversal.has_value(); });
  if (with_both < 4) return std::nullopt;
  const AxisParameters& p = c.evaluation.parameters;
  if (reversal_remainder(c.evaluation.positions, *p.B_mean).in_native() > 0.3 * p.B->in_native()) return std::nullopt;
  const auto common = common_reversal(c.evaluation.positions);
  const bool repeated = p.R.has_value();
  const double measured = (repeated ? p.R : p.E)->in_native();
  const double without = (repeated ? common->without.R : common->without.E)->in_native();
  if (!(measured > 0.0) || without > 0.75 * measured) return std::nullopt;
  return note("same-reversal-everywhere", "3.17",
              message("found nearly the same reversal error at every target, {} on average, without which "
                      "{} would be {} instead of {}; such a reversal error comes from play or from its "
                      "compensation{}, and nothing of it is removed",
                      deviation_message(c, p.B_mean->in_native()), repeated ? "R" : "E", deviation_message(c, without),
                      deviation_message(c, measured),
                      directions_in_blocks(c) ? ", or from a drift between the two directions" : ""));
}

std::optional<Finding> temperature_without_correction(const Case& c) {
  if (!c.linear() || c.metadata.nde.applied == true) return std::nullopt;
  auto thermometers = material(c.metadata.environment);
  // An artefact's calibrated positions are brought to its temperature; what remains is that of the machine.
  const auto machine = sensors_of(c.metadata.environment, "machine");
  if (!c.metadata.artefact.calibrated_positions.empty() && !machine.empty()) thermometers = machine;
  if (thermometers.empty()) return std::nullopt;
  const auto distance = [](const Thermometer& t) { return std::abs(t.worst() - 20.0); };
  const Thermometer& worst = *std::ranges::max_element(thermometers, {}, distance);
  if (distance(worst) <= same_temperature || corrects_itself(c.metadata)) return std::nullopt;
  const double per_m_K = machine_expansion(c.metadata);
  const std::string found = fmt::format("found {} °C at {}", figure(worst.worst()), worst.name);
  if (!c.metadata.nde.applied)
    return answered_by(
        {"nde.applied"},
        missing("temperature-without-correction", "4.1",
                found + " and no word whether differential expansion was corrected, expected nde.applied"));
  return departure(
      "temperature-without-correction", "4.1",
      message("{} and no correction for differential expansion, expected one off 20 °C: the machine expands by "
              "about {} over {} at {} µm/(m·°C)",
              found, deviation_message(c, std::round(per_m_K * distance(worst) * c.travel() / 100.0) / 10.0),
              position_text(c, c.travel()), figure(per_m_K)));
}

/// From 5500 m to the sea in the heaviest weather. Beyond, a pressure is in another unit, and an index of air by it
/// wrong by 190 µm/m (inches of mercury taken for kPa).
std::optional<Finding> air_pressure_unlikely(const Case& c) {
  constexpr double least_kPa = 50.0, most_kPa = 110.0;
  const Environment& environment = c.metadata.environment;
  for (const auto& pressure : {environment.air_pressure_start, environment.air_pressure_end}) {
    if (!pressure) continue;
    const double kPa = pressure->in_kPa();
    if (kPa >= least_kPa && kPa <= most_kPa) continue;
    return note("air-pressure-unlikely", "8.1",
                fmt::format("found an air pressure of {} kPa, expected 50 to 110 kPa, as where people work{}",
                            format_exact(kPa), kPa >= 25.0 && kPa <= 33.0 ? ": is it inHg?" : ""));
  }
  return std::nullopt;
}

std::optional<Finding> temperature_change(const Case& c) {
  auto thermometers = material(c.metadata.environment);
  std::ranges::move(of_the_air(c.metadata.environment), std::back_inserter(thermometers));
  if (thermometers.empty()) return std::nullopt;
  const auto change = [](const Thermometer& t) { return std::abs(t.end - t.start); };
  const Thermometer& worst = *std::ranges::max_element(thermometers, {}, change);
  if (change(worst) <= change_worth_a_word) return std::nullopt;
  return note(
      "temperature-change", "4.1",
      fmt::format("found {} going from {} °C to {} °C during the test; the permissible gradient is to be agreed",
                  worst.name, figure(worst.start), figure(worst.end)));
}

std::optional<Finding> ordered_progression(const Case& c) {
  constexpr std::size_t runs_needed = 4;  // three readings rise or fall by chance in every third cell
  constexpr double share = 0.3;           // by chance: 8 % of the cells for n = 4, 2 % for n = 5
  std::size_t cells = 0, rising = 0, falling = 0;
  double rise = 0.0, fall = 0.0;
  for (std::size_t i = 0; i < c.series.target_count(); ++i) {
    for (Direction direction : {Direction::up, Direction::down}) {
      const auto cell = c.series.cell(i, direction);
      if (cell.size() < runs_needed || c.series.count(i, direction) < cell.size()) continue;
      ++cells;
      const int sense = progression(cell);
      if (sense > 0) ++rising, rise += cell.back() - cell.front();
      if (sense < 0) ++falling, fall += cell.back() - cell.front();
    }
  }
  const bool up = rising >= falling;
  const std::size_t ordered = std::max(rising, falling);
  if (ordered < 2 || static_cast<double>(ordered) <= share * static_cast<double>(cells)) return std::nullopt;
  return note(
      "ordered-progression", progression_clause,
      message("found {} of {} targets and directions {} from run to run, by {} on average from the first run to "
              "the last, expected no ordered progression: a sign that the machine was not thermally stable",
              ordered, cells, up ? "rising" : "falling",
              deviation_message(c, std::abs(up ? rise : fall) / static_cast<double>(ordered))));
}

}  // namespace axiometry::iso230_2::rules
