// SPDX-License-Identifier: Apache-2.0
#include "axiometry/standards/iso230_2/inputs/resolved_inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/standards/iso230_2/inputs/resolved_keys.h"
#include "axiometry/standards/iso230_2/inputs/resolved_rows.h"
#include "axiometry/standards/readings/artefact.h"
#include "axiometry/standards/readings/station_offset.h"
#include "axiometry/standards/readings/usual_expansion.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double mm_in_m = 1000.0;
constexpr double degrees_in_radian = 180.0 / std::numbers::pi;
constexpr double length_as_rounded = 0.999;  // share of the travel: 1744 mm may stand for 1744.209 mm
constexpr double length_far_above = 1.25;    // share of the travel: who measures four fifths of it may state all

std::string_view kind_word(EnvironmentKind kind) {
  switch (kind) {
    case EnvironmentKind::unknown: return "unknown";
    case EnvironmentKind::white: return "white";
    case EnvironmentKind::drift: return "drift";
    case EnvironmentKind::random_walk: return "random-walk";
  }
  return "";
}

std::string_view sum_word(CalibrationSum sum) { return sum == CalibrationSum::linear ? "linear" : "quadratic"; }

class Resolver {
 public:
  Resolver(const Metadata& metadata, const Series& series, const StatedItems& stated)
      : metadata_(metadata),
        in_(metadata.uncertainty),
        gum_(metadata.gum),
        list_(metadata.gum.distributions, stated),
        linear_(metadata.axis.kind == AxisKind::linear),
        artefact_(artefact_takes_place_of_device(metadata)),
        unit_(deviation_unit(metadata.axis.kind)),
        travel_mm_(series.travel_native()) {}

  ResolvedInputs resolve() && {
    length();
    device();
    if (artefact_) artefact();
    misalignment();
    resolve_bodies(list_, metadata_, result_);
    environment();
    others();
    if (!linear_) leave_out_linear();
    distributions();
    correlation();
    result_.asked_for = asked_for();
    if (!result_.asked_for)
      std::erase_if(list_.rows, [](const ResolvedRow& row) { return row.origin > InputOrigin::flag; });
    note_annex_a();
    note_other_coefficient();
    result_.rows = std::move(list_.rows);
    result_.remarks = std::move(list_.remarks);
    return std::move(result_);
  }

 private:
  /// L is never shorter than what was measured: whatever grows with it would be stated smaller than it is.
  void length() {
    const auto given = list_.take(length_key, "L", stated_number(in_.length), "mm");
    const bool too_short = linear_ && given && !(given->value >= length_as_rounded * travel_mm_);
    const bool stands = given && !too_short;
    result_.length_m = stands ? *given : ResolvedValue{travel_mm_, InputOrigin::measured_travel};
    if (too_short) list_.set_aside(length_key, fmt::format("the readings reach over {} mm", travel_text()));
    if (stands && linear_ && given->value > length_far_above * travel_mm_)
      list_.note(
          fmt::format("{} is far above the {} mm that the readings reach over, and uncertainties that grow with "
                      "the length are as large as it makes them",
                      statement_text(*list_.find(length_key)), travel_text()));
    if (!stands && linear_) list_.follow(length_key, "L", travel_mm_, "mm", InputOrigin::measured_travel);
    result_.length_m.value /= mm_in_m;
  }

  /// To a micrometre, without what subtracting targets leaves.
  std::string travel_text() const { return format_exact(std::round(1000.0 * travel_mm_) / 1000.0); }

  ResolvedCalibration calibration(const CalibrationKeys& keys, std::optional<double> constant,
                                  std::optional<double> per_length, const std::optional<CalibrationSum>& sum,
                                  std::string_view whose) {
    ResolvedCalibration all;
    all.constant = list_.take(keys.constant, "U_CALIBRATION", constant, unit_);
    all.per_length = list_.take(keys.per_length, "U_CALIBRATION", per_length, "µm/m");
    all.sum = sum.value_or(CalibrationSum::linear);
    if (sum || all.both()) {
      const auto origin = sum ? static_cast<InputOrigin>(list_.by(keys.sum)) : InputOrigin::assumed;
      list_.take_word(keys.sum, sum_word(all.sum), origin);
    }
    if (!all.both()) list_.cannot_act(keys.sum, "it takes a constant part and one per metre to have a sum");
    if (all.both() && all.constant->origin != all.per_length->origin)
      list_.note(fmt::format("the calibration of the {} is put together from two sources: {} and {}", whose,
                             statement_text(*list_.find(keys.constant)), statement_text(*list_.find(keys.per_length))));
    return all;
  }

  void device() {
    const ResolvedCalibration certificate =
        calibration(device_calibration_keys, stated_number(in_.device_calibration),
                    stated_number(in_.device_calibration_per_length), in_.device_calibration_sum, "measuring device");
    const MaybeResolved range = list_.take(error_range_key, "R_DEVICE", stated_number(in_.device_error_range), "µm/m");
    if (artefact_) {
      for (const std::string_view key : device_statement_keys)
        list_.set_aside(key, "an artefact takes the place of the measuring device");
      return;
    }
    if (!(certificate.constant || certificate.per_length)) {
      result_.device_error_range = range;
      return;
    }
    const bool range_counts = range && linear_ && list_.by(error_range_key) > list_.strength(device_calibration_all);
    if (range && linear_)
      result_.device_notes.push_back(fmt::format("Of several statements about the measuring device the {} was taken",
                                                 range_counts ? "error range" : "calibration"));
    if (range_counts) {
      for (const std::string_view key : device_calibration_all) list_.override_by(key, error_range_key);
      result_.device_error_range = range;
    } else {
      list_.override_by(error_range_key,
                        certificate.constant ? device_calibration_keys.constant : device_calibration_keys.per_length);
      result_.device_calibration = certificate;
    }
  }

  void artefact() {
    const Artefact& artefact = metadata_.artefact;
    result_.artefact_calibration =
        calibration(artefact_calibration_keys, stated_number(artefact.calibration_uncertainty),
                    stated_number(artefact.calibration_uncertainty_per_length), artefact.calibration_sum, "artefact");
    result_.probing = list_.take(probing_key, "U_PROBING", stated_number(artefact.probing_uncertainty), unit_);
  }

  /// Both say one thing: R over L is the tangent of θ_max.
  void misalignment() {
    result_.misalignment_mm = list_.take(misalignment_key, "R_MISALIGNMENT", stated_number(in_.misalignment), "mm");
    result_.alignment_deg =
        list_.take(alignment_angle_key, "θ_max",
                   gum_.alignment_angle ? std::optional(gum_.alignment_angle->in_deg()) : std::nullopt, "°");
    const bool any = result_.misalignment_mm || result_.alignment_deg;
    if (!linear_ || !any || station_offset(metadata_)) {
      for (const std::string_view key : {misalignment_key, alignment_angle_key})
        if (linear_) list_.set_aside(key, "the beam of a tracking interferometer follows the reflector");
      result_.misalignment_mm = result_.alignment_deg = std::nullopt;
      return;
    }
    const double L_mm = mm_in_m * result_.length_m.value;
    const auto angle = [&](double R_mm) { return std::atan(R_mm / L_mm) * degrees_in_radian; };
    if (result_.misalignment_mm && result_.alignment_deg) {
      const StatedBy of_range = list_.by(misalignment_key), of_angle = list_.by(alignment_angle_key);
      const bool wider = result_.alignment_deg->value >= angle(result_.misalignment_mm->value);
      const bool angle_counts = of_angle != of_range ? of_angle > of_range : wider;
      list_.override_by(angle_counts ? misalignment_key : alignment_angle_key,
                        angle_counts ? alignment_angle_key : misalignment_key);
      (angle_counts ? result_.misalignment_mm : result_.alignment_deg).reset();
    }
    if (result_.alignment_deg)
      result_.misalignment_mm = {L_mm * std::tan(result_.alignment_deg->value / degrees_in_radian),
                                 InputOrigin::alignment_angle};
    else
      result_.alignment_deg = {angle(result_.misalignment_mm->value), InputOrigin::misalignment};
  }

  void environment() {
    const MaybeResolved K = list_.take(sensitivity_key, "K", stated_number(gum_.environment_sensitivity), "µm/(m·°C)",
                                       InputUse::propagation);
    MaybeResolved difference =
        list_.take(air_difference_key, "ΔT_e", stated_number(gum_.environment_temperature_difference), "°C",
                   InputUse::propagation);
    if (!linear_) return;
    if (!K) {
      list_.cannot_act(air_difference_key, "the sensitivity K of the instrument is not given");
      return;
    }
    const Environment& air = metadata_.environment;
    const auto start = air.air_temperature_start ? air.air_temperature_start : air.air_temperature_end;
    if (start) {
      const double end = air.air_temperature_end.value_or(*start).in_celsius();
      const double shown = (start->in_celsius() + end) / 2.0 - reference_temperature;
      const StatedBy by = std::max(list_.by(air_start_key), list_.by(air_end_key));
      if (!difference) {
        difference = list_.follow(air_start_key, "ΔT_e", shown, "°C", InputOrigin::air, InputUse::propagation);
      } else if (by > list_.by(air_difference_key) && std::abs(shown - difference->value) > same_temperature) {
        list_.follow(air_start_key, "ΔT_e", shown, "°C", static_cast<InputOrigin>(by), InputUse::propagation);
        list_.override_by(air_difference_key, air_start_key);
        difference = ResolvedValue{shown, InputOrigin::air};
      }
    }
    if (!difference) {
      list_.cannot_act(sensitivity_key, "the air temperature is not known");
      return;
    }
    result_.environment_sensitivity = K;
    result_.environment_difference = difference;
  }

  /// What stands for itself.
  void others() {
    list_.take(axis_resolution_key, "r", stated_number(gum_.axis_resolution), unit_, InputUse::propagation);
    list_.take(instrument_resolution_key, "r_s", stated_number(gum_.instrument_resolution), unit_,
               InputUse::propagation);
    list_.take(run_drift_key, "d", stated_number(gum_.run_drift), unit_, InputUse::propagation);
    list_.take(variation_key, "E_VE", stated_number(in_.environmental_variation), unit_);
    kind_of_variation();
  }

  void kind_of_variation() {
    const bool recorded = !gum_.drift_recording.empty();
    if (gum_.drift_interval && !recorded)
      list_.remarks.push_back(
          {true, fmt::format("{} cannot act: there is no recording at standstill", recording_interval_key),
           std::string(recording_interval_key)});
    if (!gum_.environment_kind) return;
    list_.take_word(kind_key, kind_word(*gum_.environment_kind), static_cast<InputOrigin>(list_.by(kind_key)));
    if (recorded) list_.cannot_act(kind_key, "the recording at standstill tells it");
    if (!in_.environmental_variation) list_.cannot_act(kind_key, "no environmental variation is stated");
  }

  void leave_out_linear() {
    for (const std::string_view key : linear_keys) list_.cannot_act(key, "it means nothing on a rotary axis");
    result_.device_calibration.per_length.reset();
    result_.device_error_range.reset();
  }

  /// Each in its place; one that a stronger statement of a single item overrides does not count.
  void distributions() {
    const auto& all = gum_.distributions;
    const StatedItem* item = list_.item(distributions_key);
    const std::size_t own = item == nullptr ? 0 : std::min(item->records, all.size());
    const auto by_of = [&](std::size_t k) { return k + own >= all.size() ? item->by : StatedBy::file; };
    for (std::size_t k = 0; k < all.size(); ++k) {
      if (all[k].input.empty() && all[k].distribution.empty()) continue;
      const StatedBy by = by_of(k);
      const std::string key = fmt::format("{} ({})", distributions_key, all[k].input);
      list_.take_word(key, all[k].distribution, static_cast<InputOrigin>(by), InputUse::propagation);
      const auto again = std::ranges::find_if(all.begin() + static_cast<std::ptrdiff_t>(k) + 1, all.end(),
                                              [&](const InputDistribution& d) { return d.input == all[k].input; });
      if (again != all.end() && by_of(static_cast<std::size_t>(again - all.begin())) > by) {
        list_.set_aside(key, "a later one takes its place");
        list_.rows.back().key = std::string(distributions_key);  // the later one has the whole key
        continue;
      }
      const std::span<const std::string_view> replaced = items_of_input(all[k].input);
      const auto stronger = std::ranges::find_if(replaced, [&](std::string_view other) {
        const ResolvedRow* row = list_.find(other);
        return row != nullptr && row->use != InputUse::none && row->origin <= InputOrigin::flag && list_.by(other) > by;
      });
      if (stronger != replaced.end()) {
        list_.override_by(key, *stronger);
        continue;
      }
      for (const std::string_view other : replaced) replace(other, all[k].input);
      result_.distributions.push_back(all[k]);
    }
  }

  /// An item whose place a distribution takes where methods know distributions.
  void replace(std::string_view key, const std::string& input) {
    ResolvedRow* row = list_.find(key);
    if (row == nullptr || row->use == InputUse::none) return;
    const bool in_annex_a = row->use == InputUse::all;
    row->use = in_annex_a ? InputUse::annex_a : InputUse::none;
    row->reason = fmt::format("the distribution of {} takes its place in GUM and Monte Carlo", input);
    if (row->origin <= InputOrigin::flag)
      list_.note(fmt::format("{} {}: {}", statement_text(*row), in_annex_a ? "acts in Annex A alone" : "does not count",
                             row->reason));
  }

  void correlation() {
    if (!list_.take(correlation_key, "r", gum_.up_down_correlation, "", InputUse::propagation)) return;
    const bool acts = gum_.axis_resolution || gum_.instrument_resolution || result_.artefact_calibration.constant ||
                      (result_.device_calibration.constant && !linear_) ||
                      std::ranges::any_of(result_.distributions,
                                          [](const InputDistribution& d) { return d.input.starts_with("target"); });
    if (!acts)
      list_.note(
          fmt::format("{} acts on the mean deviations of the targets alone: no error of single targets is stated",
                      statement_text(*list_.find(correlation_key))));
  }

  /// Whether somebody asked for an uncertainty: sensors and coefficients alone are items of clause 8.1.
  bool asked_for() const {
    return in_.device_calibration || in_.device_calibration_per_length || in_.device_error_range || in_.misalignment ||
           in_.machine_expansion || in_.machine_temperature_range || in_.machine_temperature_difference ||
           in_.machine_expansion_range || in_.device_temperature_range || in_.device_temperature_difference ||
           in_.device_expansion_range || result_.device || metadata_.artefact.calibration_uncertainty ||
           metadata_.artefact.calibration_uncertainty_per_length || metadata_.artefact.probing_uncertainty ||
           in_.environmental_variation || gum_.axis_resolution || gum_.instrument_resolution ||
           gum_.environment_sensitivity || gum_.alignment_angle || gum_.run_drift || station_offset(metadata_) ||
           !gum_.distributions.empty();
  }

  void note_annex_a() {
    const bool stated = std::ranges::any_of(list_.rows, [](const ResolvedRow& row) {
      return (row.use == InputUse::all || row.use == InputUse::annex_a) && row.origin <= InputOrigin::flag &&
             row.key != length_key;
    });
    std::vector<std::string> keys;
    for (const ResolvedRow& row : list_.rows)
      if (row.use == InputUse::propagation && row.origin <= InputOrigin::flag && row.key != correlation_key)
        keys.push_back(row.key);
    if (stated && !keys.empty())
      list_.note(
          fmt::format("Annex A has no formula for {}: its uncertainties do not contain it", fmt::join(keys, ", ")));
  }

  /// The correction was made with another coefficient than that of the uncertainty.
  void note_other_coefficient() {
    const ResolvedRow* row = list_.find(machine_keys.expansion);
    const auto of_nde = stated_number(metadata_.nde.machine_expansion);
    if (!linear_ || metadata_.nde.applied != true || !of_nde || row == nullptr || row->origin > InputOrigin::flag ||
        *row->value == *of_nde)
      return;
    std::string left;
    if (result_.machine && result_.machine->difference)
      left =
          fmt::format("; of ΔT = {:.3g} °C over L that leaves {:.3g} µm, which no method contains",
                      result_.machine->difference->value,
                      std::abs((*row->value - *of_nde) * result_.machine->difference->value * result_.length_m.value));
    list_.note(
        fmt::format("the readings were corrected for expansion with {} = {} µm/(m·°C), the uncertainty takes {}{}",
                    machine_keys.nde_expansion, format_exact(*of_nde), statement_text(*row), left));
  }

  const Metadata& metadata_;
  const AnnexAInputs& in_;
  const GumInputs& gum_;
  StatementList list_;
  bool linear_;
  bool artefact_;  // an artefact in place of the device (Annex D)
  std::string_view unit_;
  double travel_mm_;
  ResolvedInputs result_;
};

}  // namespace

std::string_view origin_key(InputOrigin origin) {
  constexpr std::string_view keys[] = {"instrument",      "file",         "entered",         "flag",
                                       "sensors",         "air",          "nde-correction",  "scale",
                                       "measured-travel", "misalignment", "alignment-angle", "assumed"};
  return keys[static_cast<std::size_t>(origin)];
}

std::string_view origin_note(InputOrigin origin) {
  switch (origin) {
    case InputOrigin::sensors: return "largest of the sensors";
    case InputOrigin::air: return "ΔT_e from the air temperature";
    case InputOrigin::nde_correction: return "of the NDE correction";
    case InputOrigin::scale: return "of the scale";
    case InputOrigin::measured_travel: return "measured travel";
    case InputOrigin::misalignment: return "from the misalignment over L";
    case InputOrigin::alignment_angle: return "from the angle over L";
    case InputOrigin::assumed: return "assumed";
    default: return "";
  }
}

std::string_view use_key(InputUse use) {
  constexpr std::string_view keys[] = {"none", "all", "annex-a", "gum-and-monte-carlo"};
  return keys[static_cast<std::size_t>(use)];
}

double ResolvedCalibration::at(double length_m) const {
  const double a = constant ? constant->value : 0.0;
  const double b_l = per_length ? per_length->value * length_m : 0.0;
  return sum == CalibrationSum::linear ? a + b_l : std::hypot(a, b_l);
}

double ResolvedCalibration::widening(double length_m) const {
  if (!both() || sum == CalibrationSum::quadratic) return 1.0;
  const double a = constant->value;
  const double b_L = per_length->value * length_m;
  if (a <= 0.0 || !(b_L > 0.0)) return 1.0;
  // The ratio grows with l up to b·l = a, where it is √2, and falls beyond.
  return b_L >= a ? std::numbers::sqrt2 : (a + b_L) / std::hypot(a, b_L);
}

ResolvedInputs resolve_inputs(const Metadata& metadata, const Series& series, const StatedItems& stated) {
  return Resolver(metadata, series, stated).resolve();
}

}  // namespace axiometry::iso230_2
