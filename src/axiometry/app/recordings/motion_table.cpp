// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/motion_table.h"

#include <fmt/format.h>

#include <cmath>

#include "axiometry/base/text/number_text.h"
#include "axiometry/capture/capture_result.h"
#include "axiometry/model/simulated.h"

namespace axiometry::app {
namespace {

using capture::PlannedValue;
using capture::StopSign;

constexpr double decimals = 1e6;  // of a mean: a picometre, far below any noise

std::string figure(double x) { return format_exact(std::round(x * decimals) / decimals + 0.0); }

/// Of a single sample nothing is rounded: it is what the instrument said.
std::string reading(const PlannedValue& value) {
  return value.still.count == 1 ? format_exact(value.still.value) : figure(value.still.value);
}

std::string_view sign_text(StopSign sign) {
  switch (sign) {
    case StopSign::keys: return "a person";
    case StopSign::trigger: return "a trigger in the stream";
    case StopSign::readings: return "the instrument, which sent one reading at each";
    case StopSign::position: return "the position in the stream";
  }
  return "";
}

/// A name from outside stays in its line.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

/// Lines "# key: value" that the reader of the table knows.
std::string statements(const CaptureSession& session, const MotionOrigin& origin) {
  const MotionListener& motion = *session.motion();
  const std::string simulated =
      origin.simulated.empty() && session.simulated() ? std::string(simulated_note) : origin.simulated;
  const Plan& plan = motion.values().plan();
  std::string text = fmt::format("# error: {}\n", motion.error().text());
  if (motion.stated().sense) text += fmt::format("# positive: {}\n", motion.stated().sense->text());
  if (!plan.axis.name.empty()) text += fmt::format("# axis.name: {}\n", one_line(plan.axis.name));
  const std::string machine = simulated.empty() ? plan.machine : simulated_machine(plan.machine);
  if (!machine.empty()) text += fmt::format("# machine.name: {}\n", one_line(machine));
  if (!origin.date.empty()) text += fmt::format("# test.date: {}\n", origin.date);
  if (!simulated.empty())
    text += fmt::format("# test.purpose: {}\n# test.comment: {}\n", simulation_purpose, simulated);
  for (const std::string& part : motion.stated().equipment) text += fmt::format("# equipment: {}\n", one_line(part));
  return text;
}

/// Lines for people. "captured" and no colon behind a word that might be a key.
std::string notes(const CaptureSession& session, const MotionOrigin& origin) {
  const MotionListener& motion = *session.motion();
  std::string text =
      fmt::format("# captured from {}, layout {}, {} samples{}\n", one_line(origin.from), session.layout(),
                  session.samples(), session.lost() > 0 ? fmt::format(", {} lost", session.lost()) : "");
  if (!origin.raw.empty()) text += fmt::format("# all that came is in {}\n", one_line(origin.raw));
  text += fmt::format("# the stops were told by {}; {} of {} readings of the plan\n",
                      sign_text(motion.values().options().sign), session.taken(), session.expected());
  if (motion.unit_of_stream() != nullptr && motion.unit_of_stream()->symbol != motion_unit_symbol(motion.unit()))
    text += fmt::format("# sent in {}, written in {}\n", motion.unit_of_stream()->symbol,
                        motion_unit_symbol(motion.unit()));
  for (const capture::CaptureEvent& event : motion.values().events())
    text += fmt::format("# at {} s, {}, {}\n", format_fixed(event.time_s, 2), capture::event_name(event.kind),
                        event.message);
  for (const PlannedValue& value : motion.values().values())
    for (const std::string& remark : value.remarks)
      text += fmt::format("# {}, {}\n", capture::approach_name(value.approach), remark);
  for (const std::string& remark : session.remarks()) text += fmt::format("# {}\n", remark);
  return text;
}

}  // namespace

Result<std::string> motion_table(const CaptureSession& session, const MotionOrigin& origin) {
  const MotionListener& motion = *session.motion();
  const std::vector<PlannedValue> values = motion.values().values();
  if (values.empty()) return fail(fmt::format("found no reading for any of the {} approaches", session.expected()));
  AXIOMETRY_TRY_VOID(motion.values().check_positions());
  const std::string_view unit = motion_unit_name(motion.unit());
  std::string text = statements(session, origin) + notes(session, origin);
  text += fmt::format("position_mm,run,direction,{}_{},time_s,scatter_{},drift_{},samples\n", motion.error().text(),
                      unit, unit, unit);
  for (const PlannedValue& value : values) {
    const capture::StillValue& still = value.still;
    const bool many = still.count > 1;
    text += fmt::format("{},{},{},{},{},{},{},{}\n",
                        format_exact(motion.values().plan().targets[value.approach.target].in_native()),
                        value.approach.run + 1, value.approach.direction == Direction::up ? "up" : "down",
                        reading(value), figure(0.5 * (still.from_s + still.to_s)), many ? figure(still.spread) : "",
                        many ? figure(still.drift) : "", still.count);
  }
  return text;
}

std::string value_text(const PlannedValue& value, const MotionListener& motion) {
  const std::string_view unit = motion_unit_symbol(motion.unit());
  const capture::StillValue& still = value.still;
  std::string text =
      fmt::format("{} mm  {} {}", format_fixed(motion.values().plan().targets[value.approach.target].in_native(), 4),
                  format_fixed(still.value, 2), unit);
  if (still.count > 1) text += fmt::format("  s {}  {} samples", format_fixed(still.spread, 2), still.count);
  return text;
}

}  // namespace axiometry::app
