// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/single_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "axiometry/app/error_motions/motion_evaluation.h"
#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/base/text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/motions/motion_result.h"
#include "axiometry/standards/error_motions/reference_line.h"

namespace axiometry::app {
namespace {

using formats::MotionResult;
using volumetric::ErrorMotion;
using volumetric::SingleMotion;

constexpr double reversal_told = 0.005;  // µm or µrad: what is printed
constexpr double single_urad_per_arcsec = std::numbers::pi / 180.0 / 3600.0 * 1e6;

/// What means of both directions differ by the most, and of which error.
struct LostReversal {
  double size = 0.0;
  std::string of;
};

/// Standard uncertainty of a mean: the scatter of n runs in each direction there is, and the instrument's.
std::optional<double> mean_u(const std::optional<double>& s_up, const std::optional<double>& s_down, std::size_t n_up,
                             std::size_t n_down, double instrument) {
  double variance = 0.0;
  int directions = 0;
  for (const auto& [s, n] : {std::pair{s_up, n_up}, std::pair{s_down, n_down}}) {
    if (n == 0) continue;
    ++directions;
    if (!s && instrument == 0.0) return std::nullopt;
    if (s) variance += *s * *s / static_cast<double>(n);
  }
  const double both = static_cast<double>(directions * directions);
  return std::sqrt(variance / both + instrument * instrument);
}

/// "Acme LI-1 1234; Acme optics", as far as named.
std::string equipment_text(const std::vector<Equipment>& equipment) {
  std::string all;
  for (const Equipment& component : equipment) {
    std::string one;
    for (const std::string* part : {&component.manufacturer, &component.type, &component.serial_number})
      if (!part->empty()) one += (one.empty() ? "" : " ") + *part;
    if (!one.empty()) all += (all.empty() ? "" : "; ") + one;
  }
  return all;
}

Error no_uncertainty(std::string_view name) {
  return Error{fmt::format("found one run of {} and no uncertainty of its instrument, expected more runs or that "
                           "uncertainty: nothing tells how well it is known",
                           name),
               {},
               {}};
}

Result<ReadSingle> read_positioning(const SingleItem& item, ErrorMotion error) {
  AXIOMETRY_TRY(Test test, read_test(item.file));
  const Metadata& metadata = test.metadata;
  if (metadata.axis.kind != AxisKind::linear)
    return std::unexpected(in_file(Error{"found a rotary axis, expected a test of a linear one", {}, {}}, item.file));
  const char letter = static_cast<char>('X' + error.axis);
  if (!metadata.axis.name.empty() && metadata.axis.name != std::string(1, letter))
    return std::unexpected(in_file(Error{fmt::format("found a test of axis {}, expected one of {} as {} is",
                                                     text::quoted(metadata.axis.name), letter, item.name),
                                         {},
                                         {}},
                                   item.file));
  ReadSingle read{{error, {}, {}, {}}, {item.name, item.file, test.provenance.sha256, test.series.run_count()}, {}};
  const iso230_2::Evaluation evaluation = iso230_2::evaluate(test.series);
  const auto number = [](const std::optional<Deviation>& d) {
    return d ? std::optional(d->in_native()) : std::optional<double>();
  };
  read.item.instrument = item.instrument;
  read.item.equipment = equipment_text(metadata.equipment);
  if (!item.instrument) read.remarks.emplace_back(no_instrument_remark);
  const bool both = test.series.has(Direction::up) && test.series.has(Direction::down);
  const double first = evaluation.positions.front().target.in_native();
  for (const iso230_2::PositionResult& p : evaluation.positions) {
    if (!p.mean_up && !p.mean_down) continue;
    const double at = p.target.in_native();
    if (both && !(p.mean_up && p.mean_down))
      return std::unexpected(in_file(
          Error{fmt::format("found {} mm approached from one side alone, expected both as at the other targets", at),
                {},
                {}},
          item.file));
    const double instrument = item.instrument ? item.instrument->standard(std::abs(at - first)) : 0.0;
    const auto u = mean_u(number(p.s_up), number(p.s_down), p.count_up, p.count_down, instrument);
    if (!u) return std::unexpected(in_file(no_uncertainty(item.name), item.file));
    read.motion.positions_mm.push_back(at);
    read.motion.values.push_back((p.mean ? *p.mean : p.mean_up ? *p.mean_up : *p.mean_down).in_native());
    read.motion.u.push_back(*u);
    if (both) read.reversal = std::max(read.reversal, std::abs(p.mean_up->in_native() - p.mean_down->in_native()));
  }
  return read;
}

/// A file of readings, in the form that results are read in.
MotionResult as_result(const MeasuredMotion& measured) {
  const error_motions::AxisMotion& motion = measured.motion;
  const auto& path = motion.principal();
  const bool both = motion.paths.size() > 1;
  MotionResult result{.error = measured.error, .sense = measured.sense, .unit = motion.unit, .runs = motion.runs};
  result.reference = error_motions::reference_key(motion.reference);
  result.has_up = both || path.kind == error_motions::PathKind::up;
  result.has_down = both || path.kind == error_motions::PathKind::down;
  result.means = path.means;
  for (const error_motions::MotionPosition& p : motion.positions) {
    result.positions_mm.push_back(p.position_mm);
    result.reversal = std::max(result.reversal, std::abs(p.reversal.value_or(0.0)));
    if (p.s_up) result.s_up.push_back(*p.s_up);
    if (p.s_down) result.s_down.push_back(*p.s_down);
  }
  result.remarks = measured.remarks;
  result.equipment = measured.metadata.equipment;
  return result;
}

/// The one of an error among those of a file.
Result<MotionResult> result_of(const std::string& bytes, const SingleItem& item, MotionName error) {
  AXIOMETRY_TRY(const formats::MotionResults results, formats::read_motion_result(bytes));
  std::string held;
  const MotionResult* found = nullptr;
  for (const MotionResult& motion : results.motions) {
    if (motion.error == error && found != nullptr)
      return fail(fmt::format("found {} twice in this result, expected it once", item.name));
    if (motion.error == error) found = &motion;
    held += (held.empty() ? "" : ", ") + (motion.error ? motion.error->text() : std::string("an error without a name"));
  }
  if (found != nullptr) return *found;
  return fail(fmt::format("found {} in this result, expected {} as given", held, item.name));
}

/// What is stated of the instrument, by the file or with the item, in µm or µrad.
Result<std::optional<error_motions::InstrumentUncertainty>> instrument_of(const SingleItem& item,
                                                                          const MotionResult& result, double factor) {
  if (!result.instrument_U) return item.instrument;
  const error_motions::InstrumentUncertainty own{factor * *result.instrument_U,
                                                 factor * result.instrument_U_per_m.value_or(0.0)};
  if (!item.instrument) return std::optional(own);
  if (item.instrument->a == own.a && item.instrument->b_per_m == own.b_per_m) return std::optional(own);
  return fail(fmt::format(
      "found an uncertainty of the instrument of {} in the file and another one given, expected one", item.name));
}

Result<ReadSingle> read_motion(const SingleItem& item, ErrorMotion error, const MotionResult& result,
                               std::string sha256) {
  const double factor = result.unit == MotionUnit::arcsec ? single_urad_per_arcsec : 1.0;
  ReadSingle read{{error, {}, {}, {}}, {item.name, item.file, std::move(sha256), result.runs}, {}};
  AXIOMETRY_TRY(read.item.instrument, instrument_of(item, result, factor));
  read.item.equipment = equipment_text(result.equipment);
  const double first = result.positions_mm.front();
  const auto scatter = [&](const std::vector<double>& s, std::size_t i) {
    return s.empty() ? std::optional<double>() : std::optional(factor * s[i]);
  };
  for (std::size_t i = 0; i < result.positions_mm.size(); ++i) {
    const double at = result.positions_mm[i];
    const double instrument = read.item.instrument ? read.item.instrument->standard(std::abs(at - first)) : 0.0;
    const auto u = mean_u(scatter(result.s_up, i), scatter(result.s_down, i), result.has_up ? result.runs : 0,
                          result.has_down ? result.runs : 0, instrument);
    if (!u) return std::unexpected(no_uncertainty(item.name));
    read.motion.positions_mm.push_back(at);
    read.motion.values.push_back(factor * result.means[i]);
    read.motion.u.push_back(*u);
  }
  read.remarks = result.remarks;
  std::erase(read.remarks, no_instrument_remark);
  if (!read.item.instrument) read.remarks.emplace_back(no_instrument_remark);
  read.reversal = factor * result.reversal;
  read.is_sense_stated = result.sense.has_value();
  return read;
}

Result<ReadSingle> read_other(const SingleItem& item, ErrorMotion error) {
  MotionRequest request;
  request.file = item.file;
  AXIOMETRY_TRY(request.error, motion_name(item.name));
  AXIOMETRY_TRY(const std::string bytes, file_bytes(item.file));
  if (formats::looks_like_motion_result(bytes)) {
    AXIOMETRY_TRY(const MotionResult result, in_file(result_of(bytes, item, *request.error), item.file));
    return in_file(read_motion(item, error, result, sha256(bytes)), item.file);
  }
  request.bytes = bytes;
  AXIOMETRY_TRY(const MeasuredMotion measured,
                error.is_rotation() ? measure_angle(request) : measure_straightness(request));
  return in_file(read_motion(item, error, as_result(measured), measured.sha256), item.file);
}

/// Positions ascend; a test in the order of its targets may descend.
Result<void> put_in_order(SingleMotion& motion, const SingleItem& item) {
  if (motion.positions_mm.size() < 2)
    return std::unexpected(in_file(Error{"found one position, expected two or more", {}, {}}, item.file));
  std::vector<std::size_t> order(motion.positions_mm.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::ranges::sort(order, {}, [&](std::size_t k) { return motion.positions_mm[k]; });
  SingleMotion sorted{motion.error, {}, {}, {}};
  for (const std::size_t k : order) {
    sorted.positions_mm.push_back(motion.positions_mm[k]);
    sorted.values.push_back(motion.values[k]);
    sorted.u.push_back(motion.u[k]);
  }
  motion = std::move(sorted);
  return {};
}

/// Positive along the axes, with the weights of the slope that the result has.
Result<volumetric::SquareLine> square_line(const MotionResult& result) {
  const auto reference = error_motions::parse_reference(result.reference);
  if (!reference || *reference == error_motions::Reference::none)
    return fail(fmt::format("found the reference {}, expected least-squares or end-points", result.reference));
  const auto error = result.error ? volumetric::error_motion_named(result.error->text()) : std::nullopt;
  if (!error || !result.sense)
    return fail("found a line without its error or without the way its readings are positive, expected both");
  return volumetric::SquareLine{*error, result.positions_mm, result.means,
                                error_motions::slope_weights(result.positions_mm, *reference)};
}

Result<ReadSquare> square_of(const std::string& bytes, const SingleItem& item, volumetric::Squareness which) {
  if (!formats::looks_like_motion_result(bytes))
    return fail("found no JSON, expected what axiometry squareness writes with --json");
  AXIOMETRY_TRY(const formats::MotionResults results, formats::read_motion_result(bytes));
  if (results.result != "squareness")
    return fail(fmt::format("found the result {}, expected squareness as {} is", results.result, item.name));
  if (!results.location)
    return fail(
        fmt::format("found a squareness without its sign in the machine, expected one made with --positive: "
                    "nothing states which way its readings are positive, so {} is not known",
                    item.name));
  const formats::LocationResult& location = *results.location;
  if (location.name != item.name)
    return fail(fmt::format("found {} in this result, expected {} as given", location.name, item.name));
  if (!location.k) return std::unexpected(no_uncertainty(item.name));
  ReadSquare read;
  read.measured.which = which;
  for (std::size_t k = 0; k < 2; ++k) {
    AXIOMETRY_TRY(read.measured.lines[k], square_line(results.motions[k]));
    for (const std::string& remark : results.motions[k].remarks)
      if (std::ranges::find(read.remarks, remark) == read.remarks.end()) read.remarks.push_back(remark);
  }
  // Of B0Z the angle between both axes is smaller than 90° (squareness.h): the square's error counts with that sign.
  const double sign = which == volumetric::Squareness::B0Z ? -1.0 : 1.0;
  const double few_runs = std::max(1.0, *location.k / 2.0);
  read.measured.square_urad = sign * single_urad_per_arcsec * results.square_error_arcsec.value_or(0.0);
  read.measured.u_scatter_urad = few_runs * location.u_scatter_urad;
  read.measured.u_instrument_urad = few_runs * location.u_instrument_urad;
  read.measured.u_square_urad = few_runs * single_urad_per_arcsec * results.square_U_arcsec.value_or(0.0) / 2.0;
  read.item = {item.name, item.file, sha256(bytes), std::max(results.motions[0].runs, results.motions[1].runs)};
  read.item.equipment = equipment_text(results.motions[0].equipment);
  if (const std::string second = equipment_text(results.motions[1].equipment); second != read.item.equipment)
    read.item.equipment += (read.item.equipment.empty() || second.empty() ? "" : "; ") + second;
  if (!results.square_U_arcsec)
    read.remarks.emplace_back("no uncertainty of the optical square is stated: U does not hold it");
  return read;
}

}  // namespace

Result<ReadSingle> read_single(const SingleItem& item, ErrorMotion error) {
  AXIOMETRY_TRY(ReadSingle read, error.is_positioning() ? read_positioning(item, error) : read_other(item, error));
  AXIOMETRY_TRY_VOID(put_in_order(read.motion, item));
  read.item.u_largest = *std::ranges::max_element(read.motion.u);
  return read;
}

Result<ReadSquare> read_square(const SingleItem& item, volumetric::Squareness which) {
  AXIOMETRY_TRY(const std::string bytes, file_bytes(item.file));
  return in_file(square_of(bytes, item, which), item.file);
}

std::optional<volumetric::Squareness> squareness_named(std::string_view name) {
  const auto found = std::ranges::find(volumetric::squareness_names, name);
  if (found == volumetric::squareness_names.end()) return std::nullopt;
  return static_cast<volumetric::Squareness>(found - volumetric::squareness_names.begin());
}

Result<ReadSingles> read_singles(const std::vector<SingleItem>& items) {
  ReadSingles all;
  std::vector<std::pair<std::size_t, volumetric::SquareMeasurement>> squares;  // each with its place in the list
  std::string of_unknown_sense;
  std::array<LostReversal, 2> lost_reversal;  // of displacements, of rotations
  for (const SingleItem& item : items) {
    if (std::ranges::find(all.items, item.name, &AssembledItem::name) != all.items.end())
      return fail(fmt::format("found {} twice, expected each error once", item.name));
    const auto remark = [&](const std::vector<std::string>& texts) {
      for (const std::string& each : texts) all.remarks.push_back(fmt::format("{}: {}", item.name, each));
    };
    if (const auto which = squareness_named(item.name); which && item.file.empty()) {
      all.errors.squareness.push_back({*which, item.urad, 0.5 * item.U_urad});
      all.items.push_back({item.name, {}, {}, 0, 0.5 * item.U_urad});
    } else if (which) {
      AXIOMETRY_TRY(ReadSquare read, read_square(item, *which));
      remark(read.remarks);
      squares.emplace_back(all.items.size(), std::move(read.measured));
      all.items.push_back(std::move(read.item));
    } else {
      AXIOMETRY_TRY(ReadSingle read, read_single(item, *volumetric::error_motion_named(item.name)));
      remark(read.remarks);
      if (!read.is_sense_stated) of_unknown_sense += (of_unknown_sense.empty() ? "" : ", ") + item.name;
      LostReversal& lost = lost_reversal[read.motion.error.is_rotation() ? 1 : 0];
      if (read.reversal > lost.size) lost = {read.reversal, item.name};
      all.errors.motions.push_back(std::move(read.motion));
      all.items.push_back(std::move(read.item));
    }
  }
  for (const auto& [place, measured] : squares) {
    AssembledItem& item = all.items[place];
    AXIOMETRY_TRY(const volumetric::SingleSquareness square,
                  in_file(volumetric::squareness_over_common_range(measured, all.errors), item.file));
    item.u_largest = square.u_urad;
    all.errors.squareness.push_back(square);
  }
  for (std::size_t k = 0; k < lost_reversal.size(); ++k)
    if (const LostReversal& lost = lost_reversal[k]; lost.size >= reversal_told)
      all.remarks.push_back(fmt::format(
          "{} differ by direction, by up to {:.2f} {} of {}: the errors hold their mean, and what is made of "
          "them has no reversal",
          k == 0 ? "displacements" : "rotations", lost.size, k == 0 ? "µm" : "µrad", lost.of));
  if (!of_unknown_sense.empty())
    all.remarks.push_back(
        fmt::format("nothing states which way these are positive, so they are taken along the axes of the machine and "
                    "by the right-hand rule about them: {}",
                    of_unknown_sense));
  return all;
}

}  // namespace axiometry::app
