// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/simulate/simulate_text.h"

#include <fmt/format.h>

#include "axiometry/app/files/amount_text.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

using simulation::VirtualAxis;
using simulation::VirtualInstrument;
using Texts = std::span<const std::string>;

/// The parts of one value, of which some must and others may be there.
Result<std::vector<std::string_view>> parts_of(std::string_view text, std::size_t fewest, std::size_t most) {
  std::vector<std::string_view> parts = text::split(text, ':');
  if (parts.size() >= fewest && parts.size() <= most) return parts;
  const std::string wanted = fewest == most ? fmt::format("{}", most) : fmt::format("{} to {}", fewest, most);
  return fail(
      fmt::format("found {} of {} parts, expected {}, separated by colons", text::quoted(text), parts.size(), wanted));
}

VirtualAxis& virtual_axis_of(SimulationRequest& r) { return r.simulate.axis; }
VirtualInstrument& virtual_instrument_of(SimulationRequest& r) { return r.simulate.axis.instrument; }
AxisKind kind_of(const SimulationRequest& r) { return r.simulate.plan.axis.kind; }

/// An option that is one deviation.
template <auto Member>
Result<void> axis_deviation(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(virtual_axis_of(r).*Member, parse_deviation(texts.back(), kind_of(r)));
  return {};
}
template <auto Member>
Result<void> instrument_deviation(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(virtual_instrument_of(r).*Member, parse_deviation(texts.back(), kind_of(r)));
  return {};
}

Result<void> pitch(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(virtual_axis_of(r).pitch.slope, parse_slope(texts.back(), kind_of(r)));
  return {};
}

Result<void> polynomial(Texts texts, SimulationRequest& r) {
  virtual_axis_of(r).pitch.polynomial.clear();
  for (const std::string_view part : text::split(texts.back(), ':')) {
    AXIOMETRY_TRY(const Deviation c, parse_deviation(part, kind_of(r)));
    virtual_axis_of(r).pitch.polynomial.push_back(c);
  }
  return {};
}

Result<void> pitch_walk(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 2, 2));
  AXIOMETRY_TRY(const Deviation size, parse_deviation(parts[0], kind_of(r)));
  AXIOMETRY_TRY(const Position length, parse_position(parts[1], kind_of(r)));
  virtual_axis_of(r).pitch.walk = {size, length};
  return {};
}

Result<void> cyclic(Texts texts, SimulationRequest& r) {
  virtual_axis_of(r).cyclic.clear();
  for (const std::string& text : texts) {
    AXIOMETRY_TRY(const auto parts, parts_of(text, 2, 3));
    simulation::CyclicError& error = virtual_axis_of(r).cyclic.emplace_back();
    AXIOMETRY_TRY(error.period, parse_position(parts[0], kind_of(r)));
    AXIOMETRY_TRY(error.amplitude, parse_deviation(parts[1], kind_of(r)));
    if (parts.size() > 2) {
      AXIOMETRY_TRY(error.phase, parse_phase(parts[2]));
    }
  }
  return {};
}

Result<void> backlash(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 1, 4));
  if (parts.size() == 2 || parts.size() == 3)
    return fail(fmt::format("found {}, expected SIZE, or SIZE:WEAR:AT:WIDTH", text::quoted(texts.back())));
  simulation::Backlash b;
  AXIOMETRY_TRY(b.size, parse_deviation(parts[0], kind_of(r)));
  if (parts.size() == 4) {
    AXIOMETRY_TRY(b.wear, parse_deviation(parts[1], kind_of(r)));
    AXIOMETRY_TRY(b.wear_at, parse_position(parts[2], kind_of(r)));
    AXIOMETRY_TRY(b.wear_width, parse_position(parts[3], kind_of(r)));
  }
  virtual_axis_of(r).backlash = b;
  return {};
}

Result<void> lost_motion(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 2, 2));
  AXIOMETRY_TRY(virtual_axis_of(r).lost_motion.size, parse_deviation(parts[0], kind_of(r)));
  AXIOMETRY_TRY(virtual_axis_of(r).lost_motion.distance, parse_position(parts[1], kind_of(r)));
  return {};
}

Result<void> stick_slip(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 1, 2));
  AXIOMETRY_TRY(virtual_axis_of(r).stick_slip.up, parse_deviation(parts.front(), kind_of(r)));
  AXIOMETRY_TRY(virtual_axis_of(r).stick_slip.down, parse_deviation(parts.back(), kind_of(r)));
  return {};
}

Result<void> thermal(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 2, 3));
  simulation::ThermalGrowth growth;
  AXIOMETRY_TRY(growth.growth, parse_deviation(parts[0], kind_of(r)));
  AXIOMETRY_TRY(growth.time_constant, parse_duration(parts[1]));
  growth.everywhere = parts.size() > 2 && parts[2] == "everywhere";
  if (parts.size() > 2 && !growth.everywhere) {
    AXIOMETRY_TRY(growth.fixed_point, parse_position(parts[2], kind_of(r)));
  }
  virtual_axis_of(r).thermal = growth;
  return {};
}

Result<void> servo(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 1, 2));
  simulation::Servo servo;
  AXIOMETRY_TRY(servo.period, parse_period(parts[0]));
  if (parts.size() > 1) {
    AXIOMETRY_TRY(servo.damping, parse_bare(parts[1]));
  }
  virtual_axis_of(r).servo = servo;
  return {};
}

Result<void> hunting(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 2, 2));
  AXIOMETRY_TRY(virtual_axis_of(r).hunting.amplitude, parse_deviation(parts[0], kind_of(r)));
  AXIOMETRY_TRY(virtual_axis_of(r).hunting.period, parse_period(parts[1]));
  return {};
}

Result<void> acceleration(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(virtual_axis_of(r).acceleration, parse_bare(texts.back()));
  return {};
}

/// PROBABILITY:SIZE
template <auto Probability, auto Size>
Result<void> now_and_then(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 2, 2));
  AXIOMETRY_TRY(virtual_instrument_of(r).*Probability, parse_probability(parts[0]));
  AXIOMETRY_TRY(virtual_instrument_of(r).*Size, parse_deviation(parts[1], kind_of(r)));
  return {};
}

Result<void> vibration(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 2, 2));
  AXIOMETRY_TRY(virtual_instrument_of(r).vibration, parse_deviation(parts[0], kind_of(r)));
  AXIOMETRY_TRY(virtual_instrument_of(r).vibration_period, parse_period(parts[1]));
  return {};
}

Result<void> air(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 1, 5));
  VirtualInstrument::Air air;
  AXIOMETRY_TRY(air.slow, parse_slope(parts[0], kind_of(r)));
  if (parts.size() > 1) {
    AXIOMETRY_TRY(air.slow_period, parse_duration(parts[1]));
  }
  if (parts.size() > 2) {
    AXIOMETRY_TRY(air.random, parse_slope(parts[2], kind_of(r)));
  }
  if (parts.size() > 3) {
    AXIOMETRY_TRY(air.random_time, parse_duration(parts[3]));
  }
  if (parts.size() > 4) {
    AXIOMETRY_TRY(air.dead_path, parse_position(parts[4], kind_of(r)));
  }
  virtual_instrument_of(r).air = air;
  return {};
}

Result<void> expansion(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const auto parts, parts_of(texts.back(), 3, 3));
  VirtualInstrument::Expansion e;
  AXIOMETRY_TRY(e.machine, parse_temperature(parts[0]));
  AXIOMETRY_TRY(e.machine_expansion, parse_expansion(parts[1]));
  AXIOMETRY_TRY(e.assumed_expansion, parse_expansion(parts[2]));
  virtual_instrument_of(r).expansion = e;
  return {};
}

/// A number that counts from 1, as an index.
Result<std::size_t> index_from(std::string_view text) {
  const auto number = parse_count(text::trim(text));
  if (!number || *number == 0) return fail(fmt::format("found {}, expected a number from 1", text::quoted(text)));
  return static_cast<std::size_t>(*number - 1);
}

/// "3:up:2": target, direction, run.
Result<std::vector<Approach>> approaches_from(Texts texts) {
  std::vector<Approach> list;
  for (const std::string& text : texts) {
    AXIOMETRY_TRY(const auto parts, parts_of(text, 3, 3));
    Approach& a = list.emplace_back();
    AXIOMETRY_TRY(a.target, index_from(parts[0]));
    AXIOMETRY_TRY(a.run, index_from(parts[2]));
    if (parts[1] != "up" && parts[1] != "down")
      return fail(fmt::format("found the direction {}, expected up or down", text::quoted(parts[1])));
    a.direction = parts[1] == "up" ? Direction::up : Direction::down;
  }
  return list;
}

Result<void> missed(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(r.simulate.departures.missed, approaches_from(texts));
  return {};
}

Result<void> doubled(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(r.simulate.departures.doubled, approaches_from(texts));
  return {};
}

Result<void> reversed_run(Texts texts, SimulationRequest& r) {
  for (const std::string& text : texts) {
    AXIOMETRY_TRY(const std::size_t run, index_from(text));
    r.simulate.departures.reversed_runs.push_back(run);
  }
  return {};
}

Result<void> gap(Texts texts, SimulationRequest& r) {
  for (const std::string& text : texts) {
    AXIOMETRY_TRY(const auto parts, parts_of(text, 2, 2));
    simulation::Gap& g = r.recording.gaps.emplace_back();
    AXIOMETRY_TRY(g.begin, parse_duration(parts[0]));
    AXIOMETRY_TRY(g.length, parse_duration(parts[1]));
  }
  return {};
}

Result<void> drop_out(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(r.recording.drop_out_probability, parse_probability(texts.back()));
  return {};
}

Result<void> rate(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(r.recording.rate, parse_bare(texts.back()));
  return {};
}

Result<void> wavelength(Texts texts, SimulationRequest& r) {
  AXIOMETRY_TRY(const Deviation length, parse_deviation(texts.back(), AxisKind::linear));
  r.wavelength = Length::um(length.in_native());
  if (r.wavelength.in_nm() >= 10.0 && r.wavelength.in_nm() <= 1e5) return {};
  return fail(fmt::format("found a wavelength of {} nm, expected 10 to 100000", r.wavelength.in_nm()));
}

constexpr std::string_view axis_group = "Faults of the axis";
constexpr std::string_view instrument_group = "Faults of the instrument";
constexpr std::string_view course_group = "A machine that does not follow its plan";

constexpr SimulationOption simulation_option_table[] = {
    {"--pitch", "SLOPE", "Slope of the scale, such as 5um/m or 0.2arcsec/deg", axis_group, false, pitch},
    {"--polynomial", "C1[:C2…]", "Bent scale: C1·u + C2·u² + …, u from 0 at the first to 1 at the last target",
     axis_group, false, polynomial},
    {"--pitch-walk", "SIZE:LENGTH", "Random curve of this standard deviation and correlation length, such as 1um:50mm",
     axis_group, false, pitch_walk},
    {"--cyclic", "PERIOD:AMPLITUDE[:PHASE]", "Periodic error, such as 10mm:1.5um; may be repeated", axis_group, true,
     cyclic},
    {"--backlash", "SIZE[:WEAR:AT:WIDTH]", "Play, and how much more of it around a place, such as 2um:5um:200mm:60mm",
     axis_group, false, backlash},
    {"--lost-motion", "SIZE:WAY", "Elastic reversal error that needs this way to turn round, such as 4um:30mm",
     axis_group, false, lost_motion},
    {"--stick-slip", "SIZE[:DOWN]", "Random stop short of the target; of its own size from above", axis_group, false,
     stick_slip},
    {"--thermal", "GROWTH:TIME[:FIXED]",
     "Growth of the measurement travel and its time constant, such as 12um:3600s; from a fixed point other than the "
     "first target, or of the whole axis with 'everywhere'",
     axis_group, false, thermal},
    {"--servo", "FREQUENCY[:DAMPING]", "Following error and settling of the control loop, such as 20Hz:0.3", axis_group,
     false, servo},
    {"--hunting", "AMPLITUDE:FREQUENCY", "Oscillation at rest, such as 1um:8Hz", axis_group, false, hunting},
    {"--axis-resolution", "SIZE", "Resolution of the axis's own scale", axis_group, false,
     axis_deviation<&VirtualAxis::resolution>},
    {"--acceleration", "NUMBER", "Of every move, mm/s² or °/s² (500)", axis_group, false, acceleration},
    {"--noise", "SIZE", "Standard deviation of a reading, and of a sample of a recording", instrument_group, false,
     instrument_deviation<&VirtualInstrument::noise>},
    {"--drift", "SIZE", "Wandering zero: its standard deviation after an hour", instrument_group, false,
     instrument_deviation<&VirtualInstrument::drift_per_root_hour>},
    {"--resolution", "SIZE", "Resolution of what is shown", instrument_group, false,
     instrument_deviation<&VirtualInstrument::resolution>},
    {"--outliers", "PROBABILITY:SIZE", "Single wrong readings, such as 2%:20um", instrument_group, false,
     now_and_then<&VirtualInstrument::outlier_probability, &VirtualInstrument::outlier_size>},
    {"--slips", "PROBABILITY:SIZE", "Shifts of the zero that stay, in some of the moves, such as 5%:3um",
     instrument_group, false, now_and_then<&VirtualInstrument::slip_probability, &VirtualInstrument::slip_size>},
    {"--vibration", "AMPLITUDE:FREQUENCY", "Between instrument and table, such as 0.3um:50Hz", instrument_group, false,
     vibration},
    {"--air", "SLOW[:PERIOD[:RANDOM[:TIME[:DEAD-PATH]]]]",
     "Variation of the refractive index: a slow wave and a random part, such as 1um/m:15min:0.3um/m:30s:200mm",
     instrument_group, false, air},
    {"--expansion", "TEMPERATURE:TRUE:ASSUMED", "Wrong correction of a warm machine, such as 25C:11.5:8 (in µm/m/°C)",
     instrument_group, false, expansion},
    {"--missed", "TARGET:DIRECTION:RUN", "Leaves an approach out, such as 3:up:2; may be repeated", course_group, true,
     missed},
    {"--doubled", "TARGET:DIRECTION:RUN", "Makes an approach twice; may be repeated", course_group, true, doubled},
    {"--reversed-run", "RUN", "Begins a run at the last target; may be repeated", course_group, true, reversed_run},
    {"--rate", "NUMBER", "Samples a second (1000)", recording_group, false, rate},
    {"--gap", "BEGIN:LENGTH", "Loses all samples for a time, such as 120s:5s; may be repeated", recording_group, true,
     gap},
    {"--drop-out", "PROBABILITY", "Loses single samples, such as 0.1%", recording_group, false, drop_out},
    {"--wavelength", "LENGTH", "In air, of the counts of a .umd recording (632.991nm; a count is half of it)",
     recording_group, false, wavelength},
};

}  // namespace

std::span<const SimulationOption> simulation_options() { return simulation_option_table; }

Result<std::vector<simulation::PitchError::Node>> parse_pitch_table(std::string_view text) {
  std::vector<simulation::PitchError::Node> nodes;
  std::size_t number = 0;
  for (std::string_view line : text::split(text, '\n')) {
    ++number;
    line = text::trim(line);
    if (line.empty() || line.starts_with('#')) continue;
    std::string blank(line);
    for (char& c : blank)
      if (c == ',' || c == ';') c = ' ';
    const auto words = text::words(blank);
    const auto at = words.size() == 2 ? parse_number(words[0]) : std::nullopt;
    const auto deviation = words.size() == 2 ? parse_number(words[1]) : std::nullopt;
    if (!at || !deviation)
      return fail(fmt::format("found {}, expected a position and a deviation", text::quoted(line)), {number, 1});
    nodes.push_back({Position::native(*at), Deviation::native(*deviation)});
  }
  if (nodes.empty()) return fail("found no line, expected positions with deviations");
  return nodes;
}

}  // namespace axiometry::app
