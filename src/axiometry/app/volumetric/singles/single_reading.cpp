// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/singles/single_reading.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>

#include "axiometry/app/error_motions/motion_evaluation.h"
#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/volumetric/singles/single_means.h"
#include "axiometry/base/go_on_unless.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/base/unit_sizes.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/motions/motion_result.h"
#include "axiometry/standards/error_motions/reference_line.h"
#include "axiometry/standards/iso230_2/scatter/run_tilts.h"
#include "axiometry/standards/readings/runs_made.h"

namespace axiometry::app {
namespace {

using formats::MotionResult;
using volumetric::ErrorMotion;
using volumetric::Reversal;

constexpr double reversal_told = 0.005;  // µm or µrad: what is printed

/// What means of both directions differ by the most, and of which error.
struct LostReversal {
  double size = 0.0;
  std::string of;
};

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

Result<ReadSingle> with_means(ReadSingle read, std::vector<PositionMeans> positions) {
  AXIOMETRY_TRY(SingleMeans means, single_means(read.motion.error, std::move(positions), read.item.instrument));
  means.motion.slope_u_per_mm = read.motion.slope_u_per_mm;
  read.motion = std::move(means.motion);
  read.item.directions = std::move(means.directions);
  read.item.reversal = means.reversal;
  const auto& [first_mm, last_mm] = std::pair(read.motion.positions_mm.front(), read.motion.positions_mm.back());
  for (std::size_t k = 0; k < read.motion.u.size(); ++k)
    read.item.u_largest =
        std::max(read.item.u_largest,
                 std::hypot(read.motion.u[k], read.motion.slope_u_per_mm *
                                                  (read.motion.positions_mm[k] - std::midpoint(first_mm, last_mm))));
  if (!read.item.instrument) read.remarks.emplace_back(no_instrument_remark);
  std::ranges::move(means.remarks, std::back_inserter(read.remarks));
  return read;
}

/// Where the axis stands at a position of a test, and whether it moves up where positions grow.
struct AxisPlace {
  double at_zero_mm = 0.0;
  double sense = 1.0;
};

/// A test may state its line in space, which may lead down the axis.
Result<AxisPlace> place_of_test(const Axis& axis, std::size_t wanted) {
  const char letter = static_cast<char>('X' + wanted);
  if (axis.kind != AxisKind::linear) return fail("found a rotary axis, expected a test of a linear one");
  if (!axis.name.empty() && axis.name != std::string(1, letter))
    return fail(fmt::format("found a test of axis {}, expected one of {} as E{}{} is", text::quoted(axis.name), letter,
                            letter, letter));
  const auto line = spatial_line(axis);
  if (!line) return AxisPlace{};
  constexpr double aside = 1e-3;
  if (std::abs(line->direction[wanted]) < 1.0 - aside * aside)
    return fail(
        fmt::format("found a test along a line that {} does not move on alone, expected one along {}", letter, letter));
  return AxisPlace{line->origin_mm[wanted], line->direction[wanted] > 0.0 ? 1.0 : -1.0};
}

/// Readings that tell how each position scatters by itself.
struct ScatterOfPositions {
  Series series;
  double widening = 1.0;  ///< of s, for degrees of freedom that slopes have taken
};

/// Where runs have slopes of their own, that of their mean is as uncertain as n of them let it be: it counts beside
/// what the positions have for themselves.
ScatterOfPositions take_slopes_of_runs(const Series& numbered, ReadSingle& read) {
  const Series series = without_empty_runs(numbered);
  const iso230_2::TiltStudy tilts = iso230_2::tilt_study(series);
  if (tilts.p > iso230_2::tilt_level) return {numbered};
  const double of_2u = error_motions::coverage_of(tilts.degrees()) / 2.0;  // so that 2 u holds what k u would
  read.motion.slope_u_per_mm = of_2u * tilts.u_of_mean() / series.travel_native();
  read.remarks.push_back(
      fmt::format("the runs have slopes of their own, which differ by {} µm over {} mm (standard "
                  "deviation): how well their mean is known is in the uncertainty of the curve",
                  format_significant(tilts.between(), 2), format_exact(series.travel_native())));
  const auto m = static_cast<double>(series.target_count());
  return {iso230_2::without_tilts(numbered), m > 2.0 ? std::sqrt(m / (m - 2.0)) : 1.0};
}

Result<ReadSingle> read_positioning(const SingleItem& item, ErrorMotion error) {
  AXIOMETRY_TRY(Test test, item.bytes ? read_test(GivenFile{item.file, *item.bytes}) : read_test(item.file));
  AXIOMETRY_TRY(const AxisPlace place, in_file(place_of_test(test.metadata.axis, error.axis), item.file));
  ReadSingle read{{error, {}, {}, {}, {}}, {item.name, item.file, test.provenance.sha256, test.series.run_count()}, {}};
  read.item.instrument = item.instrument;
  read.item.equipment = equipment_text(test.metadata.equipment);
  std::vector<PositionMeans> positions;
  const auto [untilted, widening] = take_slopes_of_runs(test.series, read);
  const auto along = [&](const std::optional<Deviation>& mean, const std::optional<Deviation>& s, std::size_t runs) {
    return mean ? std::optional(DirectionMean{place.sense * mean->in_native(),
                                              s ? std::optional(widening * s->in_native()) : std::nullopt, runs})
                : std::nullopt;
  };
  const std::vector<iso230_2::PositionResult> found = iso230_2::evaluate_positions(test.series),
                                              scattered = iso230_2::evaluate_positions(untilted);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const iso230_2::PositionResult& p = found[i];
    if (!p.mean_up && !p.mean_down) continue;
    PositionMeans means{place.at_zero_mm + place.sense * p.target.in_native(),
                        along(p.mean_up, scattered[i].s_up, p.count_up),
                        along(p.mean_down, scattered[i].s_down, p.count_down)};
    if (place.sense < 0.0) std::swap(means.up, means.down);
    positions.push_back(means);
  }
  return in_file(with_means(std::move(read), std::move(positions)), item.file);
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
    if (p.reversal) result.halves.push_back(0.5 * *p.reversal);
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
  const double factor = result.unit == MotionUnit::arcsec ? urad_per_arcsec : 1.0;
  ReadSingle read{{error, {}, {}, {}, {}}, {item.name, item.file, std::move(sha256), result.runs}, {}};
  AXIOMETRY_TRY(read.item.instrument, instrument_of(item, result, factor));
  read.item.equipment = equipment_text(result.equipment);
  read.remarks = result.remarks;
  std::erase(read.remarks, no_instrument_remark);
  std::erase(read.remarks, zero_instrument_remark);
  read.is_sense_stated = result.sense.has_value();
  std::vector<PositionMeans> positions;
  for (std::size_t i = 0; i < result.positions_mm.size(); ++i) {
    const auto direction = [&](bool is_there, double side, const std::vector<double>& s) {
      const double half = result.halves.empty() ? 0.0 : result.halves[i];
      return is_there
                 ? std::optional(DirectionMean{factor * (result.means[i] + side * half),
                                               s.empty() ? std::nullopt : std::optional(factor * s[i]), result.runs})
                 : std::nullopt;
    };
    positions.push_back({result.positions_mm[i], direction(result.has_up, 1.0, result.s_up),
                         direction(result.has_down, -1.0, result.s_down)});
  }
  return with_means(std::move(read), std::move(positions));
}

Result<ReadSingle> read_other(const SingleItem& item, ErrorMotion error) {
  MotionRequest request;
  request.file = item.file;
  AXIOMETRY_TRY(request.error, motion_name(item.name));
  AXIOMETRY_TRY(const std::string bytes, bytes_at_hand(item.bytes, item.file));
  if (formats::looks_like_motion_result(bytes)) {
    AXIOMETRY_TRY(const MotionResult result, in_file(result_of(bytes, item, *request.error), item.file));
    return in_file(read_motion(item, error, result, sha256(bytes)), item.file);
  }
  request.bytes = bytes;
  AXIOMETRY_TRY(const MeasuredMotion measured,
                error.is_rotation() ? measure_angle(request) : measure_straightness(request));
  return in_file(read_motion(item, error, as_result(measured), measured.sha256), item.file);
}

/// Positive along the axes, with the weights of the slope that the result has.
Result<volumetric::SquareLine> square_line(const MotionResult& result) {
  const auto reference = error_motions::parse_reference(result.reference);
  if (!reference || *reference == error_motions::Reference::none)
    return fail(fmt::format("found the reference {}, expected least-squares or end-points", result.reference));
  const auto error = result.error ? volumetric::error_motion_named(result.error->text()) : std::nullopt;
  if (!error || !result.sense)
    return fail("found a line without its error or without the way its readings are positive, expected both");
  const double direction = result.has_up && result.has_down ? 0.0 : result.has_up ? 1.0 : -1.0;
  return volumetric::SquareLine{*error, result.positions_mm, result.means,
                                error_motions::slope_weights(result.positions_mm, *reference), direction};
}

Result<ReadSquare> square_of(const std::string& bytes, const SingleItem& item, volumetric::Squareness which) {
  if (!formats::looks_like_motion_result(bytes))
    return fail("found no JSON, expected a result of squareness as axiometry squareness writes it");
  AXIOMETRY_TRY(const formats::MotionResults results, formats::read_motion_result(bytes));
  if (results.result != "squareness")
    return fail(fmt::format("found the result {}, expected squareness as {} is", results.result, item.name));
  if (!results.location)
    return fail(
        fmt::format("found a squareness without its sign in the machine, expected one with it: "
                    "nothing states which way its readings are positive, so {} is not known",
                    item.name));
  const formats::LocationResult& location = *results.location;
  if (location.name != item.name)
    return fail(fmt::format("found {} in this result, expected {} as given", location.name, item.name));
  if (const std::size_t runs = std::max(results.motions[0].runs, results.motions[1].runs); !location.k)
    return std::unexpected(runs > 1 ? no_uncertainty_of_equal_runs(item.name) : no_uncertainty_of(item.name));
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
  read.measured.square_urad = sign * urad_per_arcsec * results.square_error_arcsec.value_or(0.0);
  read.measured.u_scatter_urad = few_runs * location.u_scatter_urad;
  read.measured.u_instrument_urad = few_runs * location.u_instrument_urad;
  read.measured.u_square_urad = few_runs * urad_per_arcsec * results.square_U_arcsec.value_or(0.0) / 2.0;
  read.item = {item.name, item.file, sha256(bytes), std::max(results.motions[0].runs, results.motions[1].runs)};
  read.item.equipment = equipment_text(results.motions[0].equipment);
  if (const std::string second = equipment_text(results.motions[1].equipment); second != read.item.equipment)
    read.item.equipment += (read.item.equipment.empty() || second.empty() ? "" : "; ") + second;
  if (!results.square_U_arcsec)
    read.remarks.emplace_back("no uncertainty of the optical square is stated: U does not hold it");
  return read;
}

bool is_read_in_both(const volumetric::SingleErrors& errors, ErrorMotion error) {
  return std::ranges::any_of(
      errors.motions, [&](const volumetric::SingleMotion& m) { return m.error == error && m.reversal.has_value(); });
}

}  // namespace

Result<ReadSingle> read_single(const SingleItem& item, ErrorMotion error) {
  return error.is_positioning() ? read_positioning(item, error) : read_other(item, error);
}

Result<ReadSquare> read_square(const SingleItem& item, volumetric::Squareness which) {
  AXIOMETRY_TRY(const std::string bytes, bytes_at_hand(item.bytes, item.file));
  return in_file(square_of(bytes, item, which), item.file);
}

std::optional<volumetric::Squareness> squareness_named(std::string_view name) {
  const auto found = std::ranges::find(volumetric::squareness_names, name);
  if (found == volumetric::squareness_names.end()) return std::nullopt;
  return static_cast<volumetric::Squareness>(found - volumetric::squareness_names.begin());
}

Result<ReadSingles> read_singles(const std::vector<SingleItem>& items, Reversal reversal, const std::stop_token& stop) {
  ReadSingles all;
  all.errors.reversal = reversal;
  std::vector<std::pair<std::size_t, volumetric::SquareMeasurement>> squares;  // each with its place in the list
  std::string of_unknown_sense, of_one_direction;
  std::array<LostReversal, 2> lost_reversal;  // lost reversal of displacements and of rotations
  for (const SingleItem& item : items) {
    AXIOMETRY_TRY_VOID(go_on_unless(stop));
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
      if (read.item.directions != "both") of_one_direction += (of_one_direction.empty() ? "" : ", ") + item.name;
      LostReversal& lost = lost_reversal[read.motion.error.is_rotation() ? 1 : 0];
      if (reversal == Reversal::none && read.item.reversal > lost.size) lost = {read.item.reversal, item.name};
      all.errors.motions.push_back(std::move(read.motion));
      all.items.push_back(std::move(read.item));
    }
  }
  for (const auto& [place, measured] : squares) {
    AssembledItem& item = all.items[place];
    AXIOMETRY_TRY(const volumetric::SingleSquareness square,
                  in_file(volumetric::squareness_over_common_range(measured, all.errors), item.file));
    item.u_largest = square.u_urad;
    for (const volumetric::SquareLine& line : measured.lines)
      if (line.direction != 0.0 && !is_read_in_both(all.errors, line.error))
        of_one_direction += fmt::format("{}{} ({})", of_one_direction.empty() ? "" : ", ", item.name,
                                        volumetric::error_name(line.error));
    all.errors.squareness.push_back(square);
  }
  for (std::size_t k = 0; k < lost_reversal.size(); ++k)
    if (const LostReversal& lost = lost_reversal[k]; lost.size >= reversal_told)
      all.remarks.push_back(fmt::format(
          "{} differ by direction, by up to {:.2f} {} of {}: the errors hold their mean, and what is made of "
          "them has no reversal",
          k == 0 ? "displacements" : "rotations", lost.size, k == 0 ? "µm" : "µrad", lost.of));
  if (!of_one_direction.empty())
    all.remarks.push_back("read in one direction alone, which is taken for the mean of both: " + of_one_direction);
  if (!of_unknown_sense.empty())
    all.remarks.push_back(
        fmt::format("nothing states which way these are positive, so they are taken along the axes of the machine and "
                    "by the right-hand rule about them: {}",
                    of_unknown_sense));
  return all;
}

}  // namespace axiometry::app
