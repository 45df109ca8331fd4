// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/motion_listener.h"

#include <fmt/format.h>

#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/motions/motion_csv.h"
#include "axiometry/formats/motions/motion_units.h"
#include "axiometry/formats/text/name_words.h"

namespace axiometry::app {
namespace {

using capture::StopSign;

constexpr double smallest_um = 1.0, smallest_arcsec = 1.0, smallest_urad = 5.0;  // 1″ is 4.85 µrad

double smallest_of(MotionUnit unit) {
  return unit == MotionUnit::um ? smallest_um : unit == MotionUnit::arcsec ? smallest_arcsec : smallest_urad;
}

bool needs_column(StopSign sign) { return sign == StopSign::trigger || sign == StopSign::position; }

Result<MotionName> error_of(const Plan& plan, const std::optional<MotionName>& stated) {
  std::vector<MotionName> possible;
  for (const MotionName& error : plan.errors)
    if (error.rotation() || error.straightness()) possible.push_back(error);
  if (!stated && possible.size() != 1)
    return fail(fmt::format("found a plan made for {}, expected the error that is read",
                            plan.errors.empty() ? std::string("positions") : errors_text(plan)));
  const MotionName error = stated.value_or(possible.empty() ? MotionName{} : possible.front());
  if (!error.rotation() && !error.straightness())
    return fail(
        fmt::format("found the error {}, whose readings are positions and show the stops themselves; expected a "
                    "straightness or a rotation, or that nothing else tells the stops",
                    error.text()));
  AXIOMETRY_TRY_VOID(formats::check_error_of_plan(error, error.rotation() ? MotionUnit::urad : MotionUnit::um, plan));
  return error;
}

Result<void> check_unit(const MotionName& error, const formats::Unit& unit) {
  if ((unit.kind == AxisKind::rotary) == error.rotation()) return {};
  return fail(fmt::format("found {} in {}, expected {}", error.text(), unit.symbol,
                          error.rotation() ? "readings of an angle" : "readings of a length"));
}

/// Another error by its name of ISO 230-1, or a word that means one of another kind. Which of two rotations is the
/// pitch depends on how the axis lies.
Result<void> check_called(const MotionName& error, std::string_view called) {
  const auto name = motion_name(called);
  const auto has = [&](std::string_view word) { return formats::has_word(called, {word, formats::WordPlace::front}); };
  const bool another = name                         ? *name != error
                       : has("roll")                ? !error.roll()
                       : has("pitch") || has("yaw") ? !error.rotation() || error.roll()
                       : has("straight")            ? error.rotation()
                                                    : false;
  if (!another) return {};
  return fail(fmt::format("found readings that the stream calls {}, expected {}", text::quoted(called), error.text()));
}

Result<void> check_statement(const MotionStatement& stated, const MotionName& error) {
  if (stated.unit != nullptr) AXIOMETRY_TRY_VOID(check_unit(error, *stated.unit));
  if (stated.sense && stated.sense->coordinate != error.coordinate)
    return fail(fmt::format("found readings positive towards {}, expected +{} or -{} as {} is", stated.sense->text(),
                            error.coordinate, error.coordinate, error.text()));
  if (needs_column(stated.sign) && !stated.stop_column)
    return fail(fmt::format("found no column of the {}, expected its number among those beside the time",
                            stated.sign == StopSign::trigger ? "trigger" : "position"));
  if (!needs_column(stated.sign) && stated.stop_column)
    return fail("found a column of the stops, expected one only where a trigger or a position tells the stops");
  if (stated.window && (stated.sign == StopSign::readings || stated.sign == StopSign::position))
    return fail("found a window of the readings, expected one only where a key or a trigger tells the stops");
  if (stated.still && stated.sign == StopSign::readings)
    return fail("found how still readings must be, expected it where more than one is taken at a stop");
  return {};
}

}  // namespace

Result<MotionListener> MotionListener::make(Plan plan, const MotionStatement& stated,
                                            const capture::StandstillOptions& rest,
                                            const capture::MatcherOptions& matcher) {
  if (plan.axis.kind != AxisKind::linear || !plan.axis.line_direction.empty())
    return fail("found a plan of a rotary axis or of a line in space, expected one of a linear axis");
  if (!plan.further.empty()) return fail("found a plan with further plans, expected one alone");
  AXIOMETRY_TRY(const MotionName error, error_of(plan, stated.error));
  AXIOMETRY_TRY_VOID(check_statement(stated, error));
  const bool of_positions = stated.sign == StopSign::position;
  if (!of_positions && (matcher.window || matcher.reversed || matcher.datum != Position{}))
    return fail(
        "found a target window, a datum or a reversed direction, expected them only where a position tells the stops");
  capture::ValueOptions options{.sign = stated.sign, .still = {}, .rest = rest, .matcher = matcher};
  options.matcher.shortest = rest.shortest;
  options.window = stated.window.value_or(capture::value_window(plan));
  AXIOMETRY_TRY(capture::ValueListener listener, capture::ValueListener::make(std::move(plan), options));
  for (const StopMark& mark : stated.marks) listener.press_at(mark.key, mark.time_s);
  return MotionListener(std::move(listener), stated, error);
}

Result<void> MotionListener::check_layout(const formats::Recording& layout) const {
  if (!layout.of_any_quantity)
    return fail(
        fmt::format("found a stream of the layout {}, whose numbers are positions, expected one of readings: "
                    "time-position or camonitor-stream",
                    layout.id));
  if (needs_column(stated_.sign) && !layout.channels_share_time)
    return fail(
        fmt::format("found a stream of the layout {}, expected time-position: the stops are told by a column "
                    "of the same line",
                    layout.id));
  return {};
}

std::optional<formats::RecordingOptions> MotionListener::beside(formats::RecordingOptions recording) const {
  if (!stated_.stop_column) return std::nullopt;
  recording.axis = *stated_.stop_column;
  recording.axis_stated = true;
  recording.meaning = beside_comes_first() ? formats::ChannelMeaning::number : formats::ChannelMeaning::position;
  return recording;
}

Result<void> MotionListener::settle_unit(const formats::Unit* named, std::string_view called) {
  if (unit_ != nullptr) return {};
  if (named == nullptr && stated_.unit == nullptr)
    return fail(
        "found readings without a unit, expected the unit of the stream, as the instrument sends them: um, mm, urad, "
        "arcsec, mrad or deg");
  if (named != nullptr && stated_.unit != nullptr && named != stated_.unit)
    return fail(fmt::format("found readings in {} by the stream's header, expected {} as stated", named->symbol,
                            stated_.unit->symbol));
  AXIOMETRY_TRY_VOID(check_called(error_, called));
  unit_ = named != nullptr ? named : stated_.unit;
  AXIOMETRY_TRY_VOID(check_unit(error_, *unit_));
  listener_.judge_by({.smallest = smallest_of(unit()), .threshold = stated_.still, .unit = motion_unit_symbol(unit())});
  return {};
}

Result<void> MotionListener::push(std::span<const Sample> samples, const formats::Unit* named,
                                  std::string_view called) {
  AXIOMETRY_TRY_VOID(settle_unit(named, called));
  converted_.assign(samples.begin(), samples.end());
  for (Sample& sample : converted_) sample.position = formats::motion_value(*unit_, sample.position);
  listener_.push(converted_);
  return {};
}

MotionUnit MotionListener::unit() const {
  if (unit_ != nullptr) return formats::motion_unit_of(*unit_);
  return error_.rotation() ? MotionUnit::urad : MotionUnit::um;
}

}  // namespace axiometry::app
