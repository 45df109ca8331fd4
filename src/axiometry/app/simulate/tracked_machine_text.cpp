// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/simulate/tracked_machine_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "axiometry/app/files/amount_text.h"
#include "axiometry/app/files/number_list.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

Result<Length> parse_length(std::string_view text) {
  AXIOMETRY_TRY(const Deviation d, parse_deviation(text, AxisKind::linear));
  return Length::um(d.in_native());
}

/// "C0Y=20urad": the parts on both sides.
Result<std::pair<std::string_view, std::string_view>> name_and_value(std::string_view text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string_view::npos) return fail(fmt::format("found {}, expected NAME=VALUE", text::quoted(text)));
  return std::pair{text::trim(text.substr(0, equals)), text::trim(text.substr(equals + 1))};
}

template <typename T, auto Parse>
Result<void> put_on_axis(std::string_view text, std::array<T, 3>& target) {
  AXIOMETRY_TRY(const auto parts, name_and_value(text));
  AXIOMETRY_TRY(const std::size_t axis, parse_axis(parts.first));
  AXIOMETRY_TRY(target[axis], Parse(parts.second));
  return {};
}

Result<void> scale(std::string_view text, TrackedTruth& t) {
  return put_on_axis<RelativeLength, parse_relative>(text, t.machine.scale);
}
Result<void> warming(std::string_view text, TrackedTruth& t) {
  return put_on_axis<RelativeLength, parse_relative>(text, t.machine.warming);
}
Result<void> growth(std::string_view text, TrackedTruth& t) {
  return put_on_axis<Length, parse_length>(text, t.machine.growth);
}
Result<void> machine_backlash(std::string_view text, TrackedTruth& t) {
  return put_on_axis<Length, parse_length>(text, t.machine.backlash);
}

/// "0.5um" of all axes, or "x=0.5um" of one.
Result<void> repeatability(std::string_view text, TrackedTruth& t) {
  if (text.find('=') != std::string_view::npos) return put_on_axis<Length, parse_length>(text, t.machine.repeatability);
  AXIOMETRY_TRY(const Length size, parse_length(text));
  t.machine.repeatability.fill(size);
  return {};
}

Result<void> origin(std::string_view text, TrackedTruth& t) {
  AXIOMETRY_TRY(t.machine.origin_mm, parse_vector(text));
  return {};
}

Result<void> offset(std::string_view text, TrackedTruth& t) {
  AXIOMETRY_TRY(t.machine.offset_mm, parse_vector(text));
  return {};
}

/// Angles of squareness: µrad is µm/m.
Result<RelativeLength> parse_square(std::string_view text) {
  struct Unit {
    std::string_view name;
    double urad;
  };
  constexpr Unit units[] = {{"mrad", 1e3}, {"urad", 1.0}, {"µrad", 1.0},
                            {"um/m", 1.0}, {"µm/m", 1.0}, {"arcsec", 4.848136811095360},
                            {"rad", 1e6}};
  for (const Unit& unit : units) {
    if (!text.ends_with(unit.name)) continue;
    if (const auto x = parse_number(text::trim(text.substr(0, text.size() - unit.name.size()))))
      return RelativeLength::um_per_m(*x * unit.urad);
  }
  return fail(fmt::format("found {}, expected an angle in urad, mrad, rad, um/m, arcsec", text::quoted(text)));
}

Result<void> squareness(std::string_view text, TrackedTruth& t) {
  AXIOMETRY_TRY(const auto parts, name_and_value(text));
  RelativeLength* const target = parts.first == "C0Y"   ? &t.machine.C0Y
                                 : parts.first == "B0Z" ? &t.machine.B0Z
                                 : parts.first == "A0Z" ? &t.machine.A0Z
                                                        : nullptr;
  if (target == nullptr)
    return fail(fmt::format("found the squareness {}, expected C0Y, B0Z or A0Z", text::quoted(parts.first)));
  AXIOMETRY_TRY(*target, parse_square(parts.second));
  return {};
}

/// y/x:40mm:2um[:30deg]
Result<void> wave(std::string_view text, TrackedTruth& t) {
  const auto parts = text::split(text, ':');
  const auto axes = text::split(parts.front(), '/');
  if (parts.size() < 3 || parts.size() > 4 || axes.size() != 2)
    return fail(fmt::format("found {}, expected DISPLACED/MOVED:PERIOD:AMPLITUDE[:PHASE]", text::quoted(text)));
  simulation::MotionWave w;
  AXIOMETRY_TRY(w.displaced, parse_axis(axes[0]));
  AXIOMETRY_TRY(w.moved, parse_axis(axes[1]));
  AXIOMETRY_TRY(const Position period, parse_position(parts[1], AxisKind::linear));
  w.period_mm = period.in_native();
  AXIOMETRY_TRY(w.amplitude, parse_length(parts[2]));
  if (parts.size() == 4) {
    AXIOMETRY_TRY(w.phase, parse_phase(parts[3]));
  }
  t.machine.waves.push_back(w);
  return {};
}

Result<void> growth_time(std::string_view text, TrackedTruth& t) {
  AXIOMETRY_TRY(t.machine.growth_time, parse_duration(text));
  return {};
}

Result<void> noise(std::string_view text, TrackedTruth& t) {
  const auto parts = text::split(text, ':');
  if (parts.size() > 2) return fail(fmt::format("found {}, expected A or A:B", text::quoted(text)));
  AXIOMETRY_TRY(t.tracker.noise, parse_length(parts[0]));
  t.tracker.noise_per_length = {};
  if (parts.size() == 2) {
    AXIOMETRY_TRY(t.tracker.noise_per_length, parse_relative(parts[1]));
  }
  return {};
}

Result<void> tracker_scale_error(std::string_view text, TrackedTruth& t) {
  AXIOMETRY_TRY(t.tracker.scale_error, parse_relative(text));
  return {};
}

Result<void> resolution(std::string_view text, TrackedTruth& t) {
  AXIOMETRY_TRY(t.tracker.resolution, parse_length(text));
  return {};
}

Result<void> dead_path(std::string_view text, TrackedTruth& t) {
  AXIOMETRY_TRY(const Position length, parse_position(text, AxisKind::linear));
  t.tracker.dead_path_mm = length.in_native();
  return {};
}

/// 120:3.5mm[:told]; readings count from 1.
Result<void> beam_break(std::string_view text, TrackedTruth& t) {
  const auto parts = text::split(text, ':');
  const auto reading = parse_count(text::trim(parts.front()));
  if (parts.size() < 2 || parts.size() > 3 || !reading || *reading == 0 || (parts.size() == 3 && parts[2] != "told"))
    return fail(fmt::format("found {}, expected READING:JUMP[:told], readings counted from 1", text::quoted(text)));
  AXIOMETRY_TRY(const Position jump, parse_position(parts[1], AxisKind::linear));
  auto& breaks = t.tracker.breaks;
  breaks.push_back({static_cast<std::size_t>(*reading - 1), jump.in_native(), parts.size() == 3});
  std::ranges::sort(breaks, {}, &simulation::TrueBreak::before_reading);
  return {};
}

constexpr std::string_view machine_group = "Errors of the machine", tracker_group = "Errors of the instrument";

constexpr TrackedOption tracked_option_table[] = {
    {"--scale", "AXIS=ERROR", "Scale error: y=1e-4, y=100um/m, y=0.01%", machine_group, scale},
    {"--scale-origin", "X,Y,Z", "Where scales and squareness displace nothing, mm (0,0,0)", machine_group, origin},
    {"--squareness", "NAME=ANGLE", "C0Y, B0Z or A0Z: C0Y=20urad", machine_group, squareness},
    {"--offset", "X,Y,Z", "Constant displacement, mm", machine_group, offset},
    {"--wave", "DISPLACED/MOVED:PERIOD:AMPLITUDE[:PHASE]", "Straightness y/x:800mm:3um, or cyclic error x/x:10mm:1um",
     machine_group, wave},
    {"--backlash", "AXIS=SIZE", "Play: x=3um", machine_group, machine_backlash},
    {"--repeatability", "[AXIS=]SIZE", "Standard deviation of where an axis stops: 0.5um, x=1um", machine_group,
     repeatability},
    {"--growth", "AXIS=SIZE", "Thermal growth of spindle and column: z=20um", machine_group, growth},
    {"--warming", "AXIS=ERROR", "Scale error that comes with warmth: x=10um/m", machine_group, warming},
    {"--growth-time", "TIME", "Time constant of both (3600s)", machine_group, growth_time},
    {"--noise", "A[:B]", "Standard deviation of a length L: A + B L, 0.1um:0.15um/m", tracker_group, noise},
    {"--air", "ERROR", "Scale error of the instrument: 1um/m", tracker_group, tracker_scale_error},
    {"--resolution", "SIZE", "Of what is shown: 1nm", tracker_group, resolution},
    {"--dead-path", "LENGTH", "Distance at which it shows 0 (that of the first point)", tracker_group, dead_path},
    {"--beam-break", "READING:JUMP[:told]",
     "All lengths of lines from this reading on, counted from 1, are off by the jump; told: as another segment",
     tracker_group, beam_break},
};

}  // namespace

std::span<const TrackedOption> tracked_options() { return tracked_option_table; }

Result<RelativeLength> parse_relative(std::string_view text) {
  text = text::trim(text);
  if (const auto bare = parse_number(text)) return RelativeLength::um_per_m(*bare * 1e6);
  if (text.ends_with('%')) {
    if (const auto percent = parse_number(text::trim(text.substr(0, text.size() - 1))))
      return RelativeLength::um_per_m(*percent * 1e4);
  }
  if (auto slope = parse_slope(text, AxisKind::linear)) return slope;
  return fail(fmt::format("found {}, expected a relative length: a number, or in %, ppm, um/m", text::quoted(text)));
}

Result<std::size_t> parse_axis(std::string_view text) {
  text = text::trim(text);
  if (text.size() == 1)
    for (std::size_t a = 0; a < 3; ++a)
      if ((text[0] | 0x20) == static_cast<char>('x' + a)) return a;
  return fail(fmt::format("found the axis {}, expected x, y or z", text::quoted(text)));
}

}  // namespace axiometry::app
