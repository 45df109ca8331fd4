// SPDX-License-Identifier: Apache-2.0
#include "axiometry/volumetric/identify/identifier.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <thread>
#include <tuple>
#include <utility>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/volumetric/field/point_spread.h"
#include "axiometry/volumetric/identify/equations/thinned_problem.h"
#include "axiometry/volumetric/identify/smoothing.h"
#include "axiometry/volumetric/identify/station_start.h"

namespace axiometry::volumetric::detail {
namespace {

constexpr std::size_t outlier_rounds = 6;
constexpr std::size_t huber_rounds = 8;
constexpr double drift_chance_most = 1e-3;
constexpr std::size_t readings_for_unknown = 20;  // readings for each unknown in the first fit
constexpr std::size_t many_times_enough = 4;
constexpr double travel_slack_mm = 0.01;  // more than positions in part programs are rounded by

/// For a first look, before breaks and outliers are known: what a machine's errors usually need.
constexpr std::size_t first_size = 5;

std::string axis_text(std::size_t axis) { return std::string(1, "XYZ"[axis]); }

/// "line 12" or "reading 12".
std::string place_of(const VolumetricReading& reading, std::size_t i) {
  return reading.line > 0 ? fmt::format("line {}", reading.line) : fmt::format("reading {}", i + 1);
}

}  // namespace

Result<Identifier> Identifier::make(const MachineModel& machine, const VolumetricLengths& lengths,
                                    const IdentifyOptions& options) {
  AXIOMETRY_TRY_VOID(check_smoothness(options));
  Identifier identifier(machine, lengths, options);
  AXIOMETRY_TRY_VOID(identifier.check_readings());
  identifier.find_copies();
  if (options.reversal != Reversal::none) identifier.approaches_ = directions_of_rest(lengths.readings);
  identifier.find_unknown_directions();
  identifier.judged_.aside.assign(lengths.readings.size(), false);
  identifier.judged_.doubtful.assign(lengths.readings.size(), false);
  identifier.domains_ = curve_domains(machine.travel, identifier.observed_);
  AXIOMETRY_TRY_VOID(identifier.choose_first_sizes());
  return identifier;
}

Result<void> Identifier::check_readings() {
  if (lengths_.readings.empty()) return fail("found no lengths, expected some of each station and tool");
  for (const std::string& name : lengths_.tools) {
    const auto tool = machine_.tool_named(name);
    if (!tool) {
      std::string known;
      for (const Tool& t : machine_.tools) known += (known.empty() ? "" : ", ") + t.name;
      return fail(fmt::format("found lengths with tool {}, expected a tool of the machine: {}", text::quoted(name),
                              known.empty() ? "none is given" : known));
    }
    tools_mm_.push_back(machine_.tools[*tool].offset_mm);
  }
  tools_mm_ = seen_offsets(std::move(tools_mm_));
  constexpr double infinity = std::numeric_limits<double>::infinity();
  observed_ = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  for (std::size_t i = 0; i < lengths_.readings.size(); ++i) {
    const VolumetricReading& reading = lengths_.readings[i];
    if (!is_finite(reading.axes_mm) || !std::isfinite(reading.length_mm))
      return fail(fmt::format("found a number that is not finite, expected positions and a length in mm"),
                  {reading.line, 0});
    for (std::size_t a = 0; a < axis_count; ++a) {
      const double q = reading.axes_mm[a];
      observed_.lowest_mm[a] = std::min(observed_.lowest_mm[a], q);
      observed_.highest_mm[a] = std::max(observed_.highest_mm[a], q);
      const double lowest = machine_.travel.lowest_mm[a], highest = machine_.travel.highest_mm[a];
      if (q >= lowest - travel_slack_mm && q <= highest + travel_slack_mm) continue;
      return fail(
          fmt::format("found {} at {} mm ({}), expected it within its travel of {} to {} mm; are axes, signs or "
                      "units mixed up?",
                      axis_text(a), format_exact(q), place_of(reading, i), format_exact(lowest), format_exact(highest)),
          {reading.line, 0});
    }
  }
  for (std::size_t a = 0; a < axis_count; ++a)
    if (observed_.highest_mm[a] - observed_.lowest_mm[a] < 1.0)
      return fail(
          fmt::format("found all readings at one place of {}, expected them spread over its travel", axis_text(a)));
  return {};
}

/// Rows that are the same in every cell: one measurement, written twice.
void Identifier::find_copies() {
  const auto& readings = lengths_.readings;
  std::vector<std::pair<double, std::size_t>> order;  // only readings of exactly equal length are compared further
  order.reserve(readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) order.emplace_back(readings[i].length_mm, i);
  std::ranges::sort(order);
  const auto key = [&](const std::pair<double, std::size_t>& entry) {
    const VolumetricReading& r = readings[entry.second];
    return std::tuple(r.station, r.tool, r.segment, r.axes_mm.x, r.axes_mm.y, r.axes_mm.z);
  };
  is_copy_.assign(readings.size(), false);
  for (auto begin = order.begin(); begin != order.end();) {
    const auto end = std::find_if(begin, order.end(), [&](const auto& e) { return e.first != begin->first; });
    if (end - begin > 1) std::stable_sort(begin, end, [&](const auto& a, const auto& b) { return key(a) < key(b); });
    for (auto at = std::next(begin); at != end; ++at)
      if (key(*at) == key(*std::prev(at))) is_copy_[at->second] = true;
    begin = end;
  }
}

std::size_t Identifier::copies() const { return static_cast<std::size_t>(std::ranges::count(is_copy_, true)); }

std::vector<Approaches> directions_of_rest(std::span<const VolumetricReading> readings) {
  std::vector<Approaches> directions;
  directions.reserve(readings.size());
  Approaches now{};
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const VolumetricReading& reading = readings[i];
    const VolumetricReading* before = i > 0 ? &readings[i - 1] : nullptr;
    if (before == nullptr || before->station != reading.station || before->tool != reading.tool)
      now = {};
    else
      for (std::size_t a = 0; a < axis_count; ++a)
        if (const double way = reading.axes_mm[a] - before->axes_mm[a]; way != 0.0) now[a] = way > 0.0 ? 1.0 : -1.0;
    directions.push_back(now);
  }
  return directions;
}

/// Those before the first move of an axis at a station with a tool. Where they are more than a quarter of a segment, an
/// axis stood still for long, and too little would be left: they count as of the mean of both directions.
void Identifier::find_unknown_directions() {
  of_unknown_direction_.assign(lengths_.readings.size(), false);
  if (approaches_.empty()) return;
  struct Counts {
    std::size_t unknown = 0, all = 0;
  };
  std::map<std::tuple<std::size_t, std::size_t, std::size_t>, Counts> segments;
  const auto segment_of = [&](std::size_t i) -> Counts& {
    const VolumetricReading& reading = lengths_.readings[i];
    return segments[{reading.station, reading.tool, reading.segment}];
  };
  for (std::size_t i = 0; i < approaches_.size(); ++i) {
    segment_of(i).unknown += has_unknown_direction(approaches_[i]) ? 1u : 0u;
    ++segment_of(i).all;
  }
  for (std::size_t i = 0; i < approaches_.size(); ++i)
    of_unknown_direction_[i] = has_unknown_direction(approaches_[i]) && 4 * segment_of(i).unknown <= segment_of(i).all;
}

std::size_t Identifier::threads() const {
  return options_.threads > 0 ? options_.threads : std::max(1u, std::thread::hardware_concurrency());
}

Problem Identifier::problem() const {
  return {machine_,          *coefficients_, *unknowns_,
          lengths_.readings, tools_mm_,      approaches_,
          judged_.weights,   threads(),      penalty_ ? &*penalty_ : nullptr,
          options_.stop};
}

std::size_t Identifier::count() const {
  std::size_t count = 0;
  for (std::size_t i = 0; i < judged_.aside.size(); ++i)
    if (!judged_.aside[i] && !judged_.doubtful[i] && !has_no_say(i)) ++count;
  return count;
}

Result<void> Identifier::choose_first_sizes() {
  Sizes sizes;
  for (std::size_t a = 0; a < axis_count; ++a) {
    if (options_.sizes[a] > 0) {
      supported_[a] = {options_.sizes[a]};
      if (options_.curves != CurveKind::spline && options_.sizes[a] < 2)
        return fail(fmt::format("found curves of 1 for {}, expected at least 2: straightness of less is nothing",
                                axis_text(a)));
    } else {
      std::vector<double> positions;
      for (const VolumetricReading& reading : lengths_.readings) positions.push_back(reading.axes_mm[a]);
      supported_[a] = supported_sizes(options_.curves, domains_[a], std::move(positions));
    }
    if (supported_[a].empty())
      return fail(
          fmt::format("found {} at too few places of {} for its curves, expected at least 10 in all, at "
                      "4 or more places (Legendre curves need fewer)",
                      counted(lengths_.readings.size(), "reading"), axis_text(a)));
    const auto above = std::ranges::upper_bound(supported_[a], first_size);
    sizes[a] = above == supported_[a].begin() ? *above : *std::prev(above);
  }
  return take_sizes(sizes);
}

Result<Coefficients> Identifier::coefficients_of(const Sizes& sizes) const {
  TravelBox ranges;
  for (std::size_t a = 0; a < axis_count; ++a) {
    ranges.lowest_mm[a] = domains_[a].lower_mm;
    ranges.highest_mm[a] = domains_[a].upper_mm;
  }
  return Coefficients::make(options_.curves, ranges, sizes, options_.reversal);
}

Result<void> Identifier::take_sizes(const Sizes& sizes) {
  AXIOMETRY_TRY(coefficients_, coefficients_of(sizes));
  sizes_ = sizes;
  return {};
}

/// Unknowns, and a start from the stations alone.
Result<void> Identifier::start() {
  unknowns_ = unknowns_of(*coefficients_, lengths_.readings, judged_.breaks, drift_);
  constexpr std::size_t stretches_most = 2000;
  if (unknowns_->stretches.size() > stretches_most)
    return fail(fmt::format("found {} segments, expected at most {}: a segment ends where the beam was broken",
                            unknowns_->stretches.size(), stretches_most));
  AXIOMETRY_TRY(state_, start_state(problem(), lengths_));
  if (sigmas_.empty()) take_sigmas();
  refine_start();
  return {};
}

void Identifier::take_sigmas() {
  for (std::size_t i = 0; i < lengths_.readings.size(); ++i) {
    const Vector3 station = state_->stations_mm[unknowns_->stretches[unknowns_->stretch_of[i]].virtual_station];
    const VolumetricReading& reading = lengths_.readings[i];
    sigmas_.push_back(machine_.sigma_um(distance(reading.axes_mm + tools_mm_[reading.tool], station)));
  }
  judged_.weights = stated_weights();
}

/// Of very many readings some bring the start so near that one step of all is enough. Where these do not tell
/// everything, directions that nothing tells must not be begun with.
void Identifier::refine_start() {
  const std::size_t enough = readings_for_unknown * unknowns_->columns;
  if (lengths_.readings.size() < many_times_enough * enough) return;
  const ThinnedProblem few(problem(), some_of_each_stretch(*unknowns_, enough));
  auto fit = least_squares(few.problem(), *state_);
  if (fit && fit->solution.null_directions() == 0) state_ = std::move(fit->state);
}

Result<void> Identifier::refit() {
  if (count() <= unknown_count())
    return fail(fmt::format(
        "found {} for {} unknowns, expected more lengths than unknowns: measure more points or ask for simpler "
        "curves",
        counted(count(), "length"), unknown_count()));
  AXIOMETRY_TRY(fit_, least_squares(problem(), *state_));
  state_ = fit_->state;
  return {};
}

std::vector<double> Identifier::stated_weights() const {
  std::vector<double> weights = instrument_weights();
  for (std::size_t i = 0; i < weights.size(); ++i)
    if (judged_.doubtful[i]) weights[i] = 0.0;
  return weights;
}

std::vector<double> Identifier::instrument_weights() const {
  std::vector<double> weights;
  for (std::size_t i = 0; i < sigmas_.size(); ++i)
    weights.push_back(has_no_say(i) ? 0.0 : 1.0 / (sigmas_[i] * sigmas_[i]));
  return weights;
}

/// Whether anything changed. Readings come back when they fit again.
bool Identifier::set_aside_beyond_limit() {
  const std::vector<double> stated = stated_weights();
  Problem all = problem();
  all.weights = stated;
  const double limit = outlier_limit(stated.size()) * robust_scale(all, fit_->residuals_um);
  bool changed = false;
  for (std::size_t i = 0; i < judged_.aside.size(); ++i) {
    const bool is_beyond = !has_no_say(i) && std::abs(fit_->residuals_um[i]) > limit * sigmas_[i];
    changed = changed || is_beyond != judged_.aside[i];
    judged_.aside[i] = is_beyond;
  }
  weigh_what_is_used();
  return changed;
}

/// As stated, but for what was set aside.
void Identifier::weigh_what_is_used() {
  judged_.weights = stated_weights();
  for (std::size_t i = 0; i < judged_.aside.size(); ++i)
    if (judged_.aside[i]) judged_.weights[i] = 0.0;
}

/// First by a loss that heeds large residuals less, so that what belongs is not pulled along; then without them.
Result<void> Identifier::find_outliers() {
  if (!options_.find_outliers) return {};
  for (std::size_t round = 0; round < outlier_rounds; ++round) {
    if (!set_aside_beyond_limit()) return {};
    if (round == 0) {
      const std::vector<double> stated = stated_weights();
      for (std::size_t k = 0; k < huber_rounds; ++k) {
        Problem whole = problem();
        whole.weights = stated;
        judged_.weights = huber_weights(whole, fit_->residuals_um);
        AXIOMETRY_TRY_VOID(refit());
      }
      set_aside_beyond_limit();
    }
    AXIOMETRY_TRY_VOID(refit());
  }
  return {};
}

Result<void> Identifier::find_drift() {
  if (options_.drift == DriftModel::none || drift_) return {};
  if (options_.drift == DriftModel::automatic && drift_chance(problem(), fit_->residuals_um) > drift_chance_most)
    return {};
  return fit_with_drift(true);
}

Result<void> Identifier::fit_with_drift(bool drift) {
  drift_ = drift;
  AXIOMETRY_TRY_VOID(start());
  AXIOMETRY_TRY_VOID(refit());
  return find_outliers();
}

/// Drift first: in the order of a tour curves take up a part of it, and what is left looks like breaks. But a break
/// looks like drift too: where breaks were found, it must show once more, and where none was, must explain more.
Result<void> Identifier::find_drift_and_breaks() {
  const std::size_t before = judged_.breaks.size();
  const bool drifted = drift_;
  AXIOMETRY_TRY_VOID(find_drift());
  AXIOMETRY_TRY_VOID(find_breaks());
  if (options_.drift != DriftModel::automatic || drifted || !drift_) return {};
  if (judged_.breaks.size() == before) return take_breaks_for_drift();
  AXIOMETRY_TRY_VOID(fit_with_drift(false));
  AXIOMETRY_TRY_VOID(find_drift());
  return find_breaks();
}

std::size_t Identifier::unknown_count() const {
  return coefficients_->free() + unknowns_->columns - coefficients_->raw();
}

/// With coarser curves where there are few readings: a quarter more of them than unknowns, where that can be had.
Result<void> Identifier::fit_first() {
  AXIOMETRY_TRY_VOID(start());
  const auto is_least = [&](std::size_t a) { return sizes_[a] == supported_[a].front(); };
  while (4 * count() < 5 * unknown_count() && !(is_least(0) && is_least(1) && is_least(2))) {
    Sizes coarser = sizes_;
    for (std::size_t a = 0; a < axis_count; ++a)
      if (!is_least(a)) coarser[a] = *std::prev(std::ranges::lower_bound(supported_[a], sizes_[a]));
    AXIOMETRY_TRY_VOID(take_sizes(coarser));
    unknowns_ = unknowns_of(*coefficients_, lengths_.readings, judged_.breaks, drift_);
    state_->coefficients.assign(coefficients_->raw(), 0.0);
  }
  return refit();
}

/// Finer curves leave less, so that more is seen in what is left: then once more.
Result<void> Identifier::run() {
  AXIOMETRY_TRY_VOID(fit_first());
  for (std::size_t round = 0; round < 2; ++round) {
    const std::size_t breaks = judged_.breaks.size();
    const bool drift = drift_;
    AXIOMETRY_TRY_VOID(find_outliers());
    AXIOMETRY_TRY_VOID(find_drift_and_breaks());
    if (round == 0 || judged_.breaks.size() > breaks || drift_ != drift) AXIOMETRY_TRY_VOID(choose_sizes());
  }
  AXIOMETRY_TRY_VOID(find_outliers());
  AXIOMETRY_TRY_VOID(drop_unclear_breaks());
  AXIOMETRY_TRY_VOID(smooth());
  return find_part_scales();
}

/// What scales explain is no outlier: readings are judged once more where scales were taken out.
Result<void> Identifier::find_part_scales() {
  if (!options_.find_part_scales) return {};
  for (std::size_t round = 0; round < outlier_rounds; ++round) {
    part_scales_.reset();
    const double freedom = static_cast<double>(count()) - static_cast<double>(fit_->solution.told());
    auto found = part_scale_fit(problem(), *fit_, freedom, middle_mm());
    if (!found || found->told.chance > (found->told.held ? part_scales_level : untold_scales_level))
      return round > 0 ? find_outliers() : Result<void>{};
    part_scales_ = std::move(found);
    if (has_part_scales()) take_out(*part_scales_, problem(), *fit_);
    const bool is_last = !has_part_scales() || !options_.find_outliers || round + 1 == outlier_rounds;
    if (is_last || !set_aside_beyond_limit()) return {};
    AXIOMETRY_TRY_VOID(refit());
  }
  return {};
}

}  // namespace axiometry::volumetric::detail
