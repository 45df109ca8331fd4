// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/error_motions/motion_evaluation.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/unit_sizes.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/model/simulated.h"
#include "axiometry/standards/error_motions/abbe_offset.h"

namespace axiometry::app {
namespace {

using error_motions::PathKind;

Result<void> put_name(MeasuredMotion& measured, const MotionRequest& request, bool angle) {
  const std::optional<MotionName>& stated = request.error;
  if (stated && measured.error && *stated != *measured.error)
    return fail(fmt::format("found the error {} in the file, expected {} {}", measured.error->text(), stated->text(),
                            request.error_by_senses ? "by the senses of both lines" : "as given"));
  if (stated) measured.error = stated;
  if (!measured.error) return {};
  const MotionName& error = *measured.error;
  if (angle ? error.rotation() : error.straightness()) return {};
  return fail(fmt::format("found the error {}, expected {}", error.text(),
                          angle ? "a rotation such as EAX" : "a straightness such as EYX"));
}

/// The sense of the readings, and those of a negative one turned.
Result<void> put_sense(MeasuredMotion& measured, const std::optional<ReadingSense>& stated, formats::MotionFile& file) {
  if (stated && file.sense && *stated != *file.sense)
    return fail(fmt::format("found readings positive towards {} in the file, expected {} as given", file.sense->text(),
                            stated->text()));
  measured.sense = stated ? stated : file.sense;
  if (!measured.sense) return {};
  const char along = measured.sense->coordinate;
  if (measured.error ? along != measured.error->coordinate : (along <= 'C') != is_angle(file.unit))
    return fail(fmt::format(
        "found readings positive towards {}, expected {}", measured.sense->text(),
        measured.error ? fmt::format("+{0} or -{0} as {1} is", measured.error->coordinate, measured.error->text())
        : is_angle(file.unit) ? "a rotation such as +A, as angles are"
                              : "a direction such as +Y, as lengths are"));
  if (!measured.sense->negative) return {};
  for (MotionReading& reading : file.readings) reading.value = 0.0 - reading.value;  // 0 keeps its sign
  measured.remarks.push_back(
      fmt::format("the readings are positive towards {}: their signs are turned", measured.sense->text()));
  return {};
}

/// Whether a name begins with the letter of another axis, "Z" or "z 1" for X. What is called by no letter is not
/// judged.
bool is_of_other_axis(std::string_view name, char axis) {
  const std::string said = text::to_lower(text::trim(name));
  const bool by_letter = !said.empty() && (said.size() == 1 || std::string_view(" -_.0123456789").contains(said[1]));
  return by_letter && said[0] >= 'x' && said[0] <= 'z' && said[0] - 'x' != axis - 'X';
}

Result<void> check_axis(const MeasuredMotion& measured) {
  const std::string& name = measured.metadata.axis.name;
  if (!measured.error || !is_of_other_axis(name, measured.error->axis)) return {};
  return fail(fmt::format("found readings of {} in a file of the axis {}, expected one of {}", measured.error->text(),
                          text::quoted(name), measured.error->axis));
}

/// What a file says that would make other figures of its readings, and what nobody takes into account here.
Result<void> check_statements(const MeasuredMotion& measured, bool may_be_positions) {
  AXIOMETRY_TRY_VOID(check_axis(measured));
  const InstrumentSettings& instrument = measured.metadata.instrument;
  if (instrument.gain && *instrument.gain != 1.0)
    return fail(
        fmt::format("found instrument.gain: {}, which is not applied to straightness and angles; expected "
                    "readings that hold it, and a file without it",
                    format_exact(*instrument.gain)));
  if (instrument.sign_reversed == true)
    return fail(
        "found instrument.sign_reversed: yes, which is not applied to straightness and angles; expected "
        "# positive: -Y, or the direction that holds, in its place");
  if (may_be_positions && !measured.error && !measured.sense)
    return fail(
        "found deviations of an error that nobody names, which may be those of positions; expected # error: EYX or the "
        "column straightness_um, or the error stated beside the file");
  return {};
}

/// Which of both is pitch and which is yaw depends on how the machine stands; which is roll does not.
Result<void> check_turn(const std::optional<MotionName>& error, std::string_view turn) {
  if (!error || turn.empty() || (turn == "roll") == error->roll()) return {};
  const auto about = [&](int places) {
    return MotionName{static_cast<char>('A' + (error->axis - 'X' + places) % 3), error->axis}.text();
  };
  return fail(turn == "roll" ? fmt::format("found a column of roll for {}, expected {}", error->text(), about(0))
                             : fmt::format("found a column of {} for {}, which is the roll; expected {} or {}", turn,
                                           error->text(), std::min(about(1), about(2)), std::max(about(1), about(2))));
}

/// Of two statements; nothing where one of them is missing.
std::optional<bool> are_alike(std::string_view a, std::string_view b) {
  const std::string_view one = text::trim(a), two = text::trim(b);
  if (one.empty() || two.empty()) return std::nullopt;
  return text::equal_ignoring_case(one, two);
}

/// Figures of several files are of one machine: that of one serial number, however it is called; without both numbers
/// the names tell.
Result<void> check_one_machine(const MeasuredMotion& a, const MeasuredMotion& b) {
  const Machine &one = a.metadata.machine, &two = b.metadata.machine;
  if (const auto numbers = are_alike(one.serial_number, two.serial_number)) {
    if (*numbers) return {};
    return fail(fmt::format("found the serial numbers {} and {}, expected files of one machine",
                            text::quoted(one.serial_number), text::quoted(two.serial_number)));
  }
  if (are_alike(one.name, two.name).value_or(true)) return {};
  return fail(fmt::format("found the machines {} and {}, expected files of one", text::quoted(one.name),
                          text::quoted(two.name)));
}

/// No instrument measures without error: 0 is none that is known, and makes no U of 0.
bool states_nothing(const std::optional<error_motions::InstrumentUncertainty>& stated) {
  return !stated || (stated->a == 0.0 && stated->b_per_m == 0.0);
}

void add_gaps(MeasuredMotion& measured, bool stated_as_0) {
  if (measured.motion.runs == 1)
    measured.remarks.push_back(
        "one run: what does not repeat cannot be told from the shape, and there is no repeatability");
  if (measured.motion.repeats_without_U())
    measured.remarks.push_back(
        "the runs agree to the last digit: they tell nothing of how far they are from the truth");
  if (!measured.instrument) measured.remarks.emplace_back(stated_as_0 ? zero_instrument_remark : no_instrument_remark);
  if (auto why = simulated_by_purpose(measured.metadata.conditions.purpose))
    measured.remarks.push_back(*std::move(why));
}

Result<MeasuredMotion> evaluated(const MotionRequest& request, formats::MotionFile file, bool angle) {
  if (is_angle(file.unit) != angle)
    return fail(angle ? "found readings of a length, expected an angle, such as angle_urad"
                      : "found readings of an angle, expected a length, such as straightness_um");
  MeasuredMotion measured{.file = request.file, .error = file.error, .metadata = std::move(file.metadata)};
  if (!measured.error && !request.error && request.plan && request.alone_with_plan)
    measured.error = formats::error_of_plan(*request.plan, file.unit);
  AXIOMETRY_TRY_VOID(put_name(measured, request, angle));
  if (request.plan) AXIOMETRY_TRY_VOID(formats::check_error_of_plan(measured.error, file.unit, *request.plan));
  for (const SourceRemark& remark : file.remarks) measured.remarks.push_back(remark.message);
  if (request.plan && request.plan->errors.empty())
    measured.remarks.emplace_back("the plan names no error: it was made for positions");
  AXIOMETRY_TRY_VOID(put_sense(measured, request.sense, file));
  AXIOMETRY_TRY_VOID(check_statements(measured, file.may_be_positions));
  AXIOMETRY_TRY_VOID(check_turn(measured.error, file.turn));
  AXIOMETRY_TRY(const MotionSeries series, MotionSeries::make(std::move(file.readings), file.unit, angle ? 2 : 3));
  error_motions::MotionOptions options = request.options;
  if (states_nothing(options.instrument)) options.instrument.reset();
  measured.motion = error_motions::axis_motion(series, options);
  measured.instrument = options.instrument;
  if (measured.instrument && !file.unit_in_file.empty())
    measured.remarks.push_back(fmt::format(
        "the readings of the file are in {}: the uncertainty of the instrument was taken as stated in {}, as "
        "the figures are",
        file.unit_in_file, motion_unit_symbol(file.unit)));
  add_gaps(measured, request.options.instrument.has_value());
  return measured;
}

Result<MeasuredMotion> measure(const MotionRequest& request, std::string_view bytes, bool angle) {
  AXIOMETRY_TRY(formats::MotionFile file, in_file(request.plan ? formats::read_planned_motion(bytes, *request.plan)
                                                               : formats::read_motion_csv(bytes),
                                                  request.file));
  AXIOMETRY_TRY(MeasuredMotion measured, in_file(evaluated(request, std::move(file), angle), request.file));
  measured.sha256 = sha256(bytes);
  return measured;
}

Result<MeasuredMotion> measure(const MotionRequest& request, bool angle) {
  if (request.bytes) return measure(request, *request.bytes, angle);
  AXIOMETRY_TRY(const std::string bytes, file_bytes(request.file));
  return measure(request, bytes, angle);
}

/// Where one line's readings were turned into the axes and the other's were not, no formula holds for them.
Result<void> name_by_senses(SquarenessMeasurement& s) {
  if (s.first.sense.has_value() != s.second.sense.has_value())
    return fail("found the sense of the readings of one line only, expected that of both or of neither");
  if (!s.first.sense) return {};
  const char one = s.first.sense->coordinate, two = s.second.sense->coordinate;
  if (!s.first.error) s.first.error = MotionName{one, two};
  if (!s.second.error) s.second.error = MotionName{two, one};
  AXIOMETRY_TRY_VOID(in_file(check_axis(s.first), s.first.file));
  return in_file(check_axis(s.second), s.second.file);
}

/// Whether they may be put together: each rotation of one axis once, at the same positions.
Result<void> check_angles(const std::vector<MeasuredMotion>& list) {
  const MeasuredMotion& first = list.front();
  std::string coordinates;
  for (const MeasuredMotion& m : list) {
    if (!m.error)
      return in_file(
          Result<void>(fail("found no name of the error, expected # error: EAX, EBX or ECX, or one stated beside the "
                            "file")),
          m.file);
    if (m.error->axis != first.error->axis)
      return fail(fmt::format("found {} and {}, expected rotations of one axis", first.error->text(), m.error->text()));
    if (coordinates.contains(m.error->coordinate))
      return fail(fmt::format("found {} twice, expected each rotation once", m.error->text()));
    coordinates += m.error->coordinate;
    if (!std::ranges::equal(m.motion.positions, first.motion.positions, {}, &error_motions::MotionPosition::position_mm,
                            &error_motions::MotionPosition::position_mm))
      return fail(fmt::format("found {} and {} at different positions, expected the same", first.error->text(),
                              m.error->text()));
  }
  return {};
}

const error_motions::MotionPath* path_of(const MeasuredMotion& m, PathKind kind) {
  const auto path = std::ranges::find(m.motion.paths, kind, &error_motions::MotionPath::kind);
  return path == m.motion.paths.end() ? nullptr : &*path;
}

/// ε of each angle at each position, µrad; nothing where not all files have that course.
std::optional<error_motions::AxisAngles> angles_of(const std::vector<MeasuredMotion>& list, PathKind kind) {
  error_motions::AxisAngles angles;
  for (const MeasuredMotion& m : list) {
    const error_motions::MotionPath* path = path_of(m, kind);
    if (path == nullptr) return std::nullopt;
    auto& place = angles.urad[static_cast<std::size_t>(m.error->coordinate - 'A')];
    place = path->means;
    if (m.motion.unit == MotionUnit::arcsec)
      for (double& x : *place) x *= urad_per_arcsec;
  }
  return angles;
}

/// ↑, ↓ and the mean of both, as far as all files have them.
Result<std::vector<AbbeComponent>> at_offset(const std::vector<MeasuredMotion>& list, const Vector3& offset_mm) {
  AXIOMETRY_TRY_VOID(check_angles(list));
  const char axis = list.front().error->axis;
  std::vector<AbbeComponent> components;
  for (std::size_t c = 0; c < 3; ++c)
    components.push_back({.name = {'E', static_cast<char>('X' + c), axis}, .courses = {}, .missing = {}});
  bool any = false;
  for (const PathKind kind : {PathKind::up, PathKind::down, PathKind::mean}) {
    const auto angles = angles_of(list, kind);
    if (!angles) continue;
    const auto changes = error_motions::abbe_displacement(*angles, offset_mm);
    for (std::size_t c = 0; c < components.size(); ++c) {
      if (changes[c]) components[c].courses.push_back({kind, *changes[c]});
      if (!any)
        for (const char angle : error_motions::missing_angles(*angles, offset_mm, c))
          components[c].missing += fmt::format("{}E{}{}", components[c].missing.empty() ? "" : ", ", angle, axis);
    }
    any = true;
  }
  if (!any)
    return fail("found angles of one direction beside ones of the other, expected a direction that all of them have");
  return components;
}

}  // namespace

Result<MeasuredMotion> measure_straightness(const MotionRequest& request) { return measure(request, false); }
Result<MeasuredMotion> measure_angle(const MotionRequest& request) { return measure(request, true); }

Result<SquarenessMeasurement> measure_squareness(const SquarenessRequest& request) {
  SquarenessMeasurement s;
  MotionRequest first{.file = request.first, .options = request.options}, second = first;
  second.file = request.second;
  first.bytes = request.bytes[0];
  second.bytes = request.bytes[1];
  first.plan = request.plans[0];
  second.plan = request.plans[1];
  if (request.senses) {
    const auto& [one, two] = *request.senses;
    first.sense = one;
    second.sense = two;
    AXIOMETRY_TRY_VOID(
        error_motions::check_square_pair({one.coordinate, two.coordinate}, {two.coordinate, one.coordinate}));
    first.error = MotionName{one.coordinate, two.coordinate};
    second.error = MotionName{two.coordinate, one.coordinate};
    first.error_by_senses = second.error_by_senses = true;
  }
  AXIOMETRY_TRY(s.first, measure_straightness(first));
  AXIOMETRY_TRY(s.second, measure_straightness(second));
  AXIOMETRY_TRY_VOID(name_by_senses(s));
  for (const auto& [line, plan] : {std::pair{&s.first, &request.plans[0]}, std::pair{&s.second, &request.plans[1]}})
    if (*plan)
      AXIOMETRY_TRY_VOID(in_file(formats::check_error_of_plan(line->error, MotionUnit::um, **plan), line->file));
  if (s.first.error && s.second.error)
    AXIOMETRY_TRY_VOID(error_motions::check_square_pair(*s.first.error, *s.second.error));
  AXIOMETRY_TRY_VOID(check_one_machine(s.first, s.second));
  s.square = request.square;
  s.square.in_axes = s.first.in_axes() && s.second.in_axes();
  AXIOMETRY_TRY(s.result, error_motions::measured_squareness(s.first.motion, s.second.motion, s.square));
  if (s.square.in_axes) s.location = error_motions::location_error(*s.first.error, s.result);
  return s;
}

Result<AnglesMeasurement> measure_angles(const AnglesRequest& request) {
  AnglesMeasurement measurement{.angles = {}, .offset_mm = request.offset_mm, .abbe = {}};
  for (const MotionRequest& file : request.files) {
    AXIOMETRY_TRY(MeasuredMotion angle, measure_angle(file));
    if (!measurement.angles.empty()) AXIOMETRY_TRY_VOID(check_one_machine(measurement.angles.front(), angle));
    measurement.angles.push_back(std::move(angle));
  }
  if (!request.offset_mm) return measurement;
  AXIOMETRY_TRY(measurement.abbe, at_offset(measurement.angles, *request.offset_mm));
  return measurement;
}

}  // namespace axiometry::app
