// SPDX-License-Identifier: Apache-2.0
//
// Deviations from the source: the errata named in the header; other n than 5 and 1; rotary axes; U_STATION.
#include "axiometry/standards/iso230_2/uncertainty/annex_a.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/model/fields.h"
#include "axiometry/standards/iso230_2/inputs/resolved_inputs.h"
#include "axiometry/standards/iso230_2/uncertainty/annex_a_positions.h"
#include "axiometry/standards/iso230_2/uncertainty/annex_a_repeatability.h"
#include "axiometry/standards/readings/artefact.h"
#include "axiometry/standards/readings/reading_change.h"
#include "axiometry/standards/readings/station_offset.h"

namespace axiometry::iso230_2 {
namespace {

// Half of expanded_per_range: the cosine error of a misalignment R over L is R²/2L.
constexpr double expanded_per_squared_misalignment = 0.3;
constexpr double length_limit_m = 2.0;        // A.2.6 holds up to here
constexpr double absurd_uncertainty = 1e100;  // µm or ″
constexpr double length_short_m = 0.3;        // A.2.3 warns below

/// A number that enters a formula, and where it came from when nobody gave it.
struct Known {
  double value = 0.0;
  std::string_view note;
};
using Input = std::optional<Known>;

struct Term {
  std::string_view symbol;
  std::string_view unit;
  Input input;
};

Input given(const std::optional<Deviation>& x) { return x ? Input(Known{x->in_native(), ""}) : std::nullopt; }
Input given(const MaybeResolved& x) { return x ? Input(Known{x->value, origin_note(x->origin)}) : std::nullopt; }

/// Whether anything of Annex A was given. L alone says nothing about an uncertainty, and what has no clause
/// belongs to other methods.
bool annex_a_given(const Metadata& metadata) {
  return std::ranges::any_of(metadata_fields(),
                             [&](const Field& field) {
                               return field.key.starts_with("uncertainty.") && field.key != "uncertainty.length_mm" &&
                                      !field.clause.empty() && is_given(field, metadata);
                             }) ||
         metadata.gum.alignment_angle || station_offset(metadata) ||
         (artefact_takes_place_of_device(metadata) &&
          (metadata.artefact.calibration_uncertainty || metadata.artefact.calibration_uncertainty_per_length ||
           metadata.artefact.probing_uncertainty));
}

/// Contributors of the form factor × product of the terms: all but misalignment.
Contributor product(Contributor contributor, double factor, std::initializer_list<Term> terms) {
  double U = factor;
  for (const Term& term : terms) {
    if (!term.input) {
      contributor.inputs.clear();
      return contributor;
    }
    contributor.inputs.push_back({term.symbol, term.input->value, term.unit, term.input->note});
    U *= term.input->value;
  }
  contributor.U = Deviation::native(U);
  return contributor;
}

/// Builds the budget and remembers what had to be assumed.
class AnnexABudget {
 public:
  AnnexABudget(const Metadata& metadata, const Series& series, const StatedItems& stated)
      : metadata_(metadata),
        resolved_(resolve_inputs(metadata, series, stated)),
        targets_(series.targets()),
        station_(station_offset(metadata)) {
    linear_ = metadata.axis.kind == AxisKind::linear;
    artefact_ = artefact_takes_place_of_device(metadata);
    length_ = given(resolved_.length_m);
  }

  std::vector<Contributor> rows() {
    std::vector<Contributor> rows = {device(),   misalignment(),           m_machine(), m_device(), e_machine(),
                                     e_device(), environmental_variation()};
    if (metadata_.artefact.probing_uncertainty && artefact_) rows.push_back(probing());
    if (station_) rows.push_back(station());
    for (Contributor& row : rows) leave_out_absurd(row);
    return rows;
  }
  double length_m() const { return length_->value; }
  const ResolvedCalibration& calibration() const {
    return artefact_ ? resolved_.artefact_calibration : resolved_.device_calibration;
  }
  std::vector<std::string> notes() && { return std::move(notes_); }

 private:
  /// Lengths next to nothing or beyond the solar system would end in infinities.
  void leave_out_absurd(Contributor& row) {
    if (!row.U || row.U->in_native() <= absurd_uncertainty) return;
    notes_.push_back(fmt::format("{} is left out: at L = {} m it has no sensible value", row.symbol, length_m()));
    row.U.reset();
  }

  Term L() const { return {"L", "m", length_}; }
  std::string_view deviation() const { return deviation_unit(metadata_.axis.kind); }

  /// A constant part and one in proportion to the length, put together as the certificate says.
  Contributor certificate(Contributor row, const ResolvedCalibration& stated) const {
    if (!stated.constant && !stated.per_length) return row;
    if (stated.constant) row.inputs.push_back({"U_CALIBRATION", stated.constant->value, deviation(), ""});
    if (stated.per_length) {
      row.formula = !stated.both() ? "A.2" : stated.sum == CalibrationSum::linear ? "A.1 + A.2" : "A.1, A.2";
      row.inputs.push_back({"U_CALIBRATION", stated.per_length->value, "µm/m", ""});
      row.inputs.push_back({"L", length_->value, "m", length_->note});
    }
    row.U = Deviation::native(stated.at(length_m()));
    return row;
  }

  Contributor artefact() {
    const AnnexAInputs& of_device = metadata_.uncertainty;
    if (of_device.device_calibration || of_device.device_calibration_per_length || of_device.device_error_range)
      notes_.push_back(
          "The artefact takes the place of the measuring device, whose calibration and error range are "
          "left out");
    return certificate({"device", "U_DEVICE", "Calibration of the artefact", "A.1", {}, {}},
                       resolved_.artefact_calibration);
  }

  Contributor probing() {
    return product({"probing", "U_PROBING", "Probing of the artefact", "Annex D", {}, {}}, 1.0,
                   {{"U_PROBING", deviation(), given(resolved_.probing)}});
  }

  /// Not in the annex: the range of the errors over the targets, with the probability of an expanded uncertainty.
  Contributor station() {
    const StationErrors errors(targets_, station_->at);
    Contributor row{"station", "U_STATION", "Station of the tracking interferometer", "Lee et al. 19", {}, {}};
    row.inputs = {{"u_1", station_->larger_mm, "mm", ""},
                  {"u_2", station_->smaller_mm, "mm", ""},
                  {"d_nearest", errors.nearest_mm(), "mm", "from the targets"},
                  {"d_farthest", errors.farthest_mm(), "mm", "from the targets"}};
    row.U = Deviation::native(errors.range_um(offset_squared_quantile(*station_, 0.95)));
    notes_.push_back(
        "U_STATION is not in Annex A: it bounds, with 95 %, what a wrongly determined station does to the lengths "
        "along the line (Lee et al., eqs 17 to 23)");
    return row;
  }

  Contributor device() {
    if (artefact_) return artefact();
    Contributor row{"device", "U_DEVICE", "Measuring device", "A.1", {}, {}};
    notes_.insert(notes_.end(), resolved_.device_notes.begin(), resolved_.device_notes.end());
    if (!resolved_.device_error_range) return certificate(std::move(row), resolved_.device_calibration);
    row.formula = "A.3";
    return product(row, expanded_per_range, {{"R_DEVICE", "µm/m", given(resolved_.device_error_range)}, L()});
  }

  Contributor misalignment() {
    Contributor row{"misalignment",
                    "U_MISALIGNMENT",
                    artefact_ ? "Misalignment of the artefact" : "Misalignment of the measuring device",
                    "A.4",
                    {},
                    {}};
    if (!linear_) return row;
    const Input range = given(resolved_.misalignment_mm);
    if (station_) {
      if (metadata_.uncertainty.misalignment) notes_.emplace_back(followed_beam_note);
      return row;
    }
    const double L_m = length_m();
    if (!range) {
      if (L_m < length_short_m)
        notes_.push_back(
            fmt::format("U_MISALIGNMENT counts as zero because no misalignment was given; it grows as 1/L and is not "
                        "negligible under 300 mm (1 mm over {:.4g} mm gives {:.2g} µm)",
                        1000.0 * L_m, expanded_per_squared_misalignment / L_m));
      return row;
    }
    const double U = expanded_per_squared_misalignment * range->value * range->value / L_m;
    row.inputs = {{"R_MISALIGNMENT", range->value, "mm", range->note}, {"L", L_m, "m", length_->note}};
    row.U = Deviation::native(U);
    if (L_m < length_short_m && U > 0.0)
      notes_.push_back(
          fmt::format("U_MISALIGNMENT grows as 1/L and is not negligible under 300 mm: {:.2g} µm at L = {:.4g} mm", U,
                      1000.0 * L_m));
    return row;
  }

  Contributor m_machine() {
    const Contributor row{"m_machine", "U_M,MACHINE TOOL", "Temperature measurement of the machine tool", "A.5", {},
                          {}};
    if (!resolved_.machine || !resolved_.machine->temperature_range) return row;
    const ResolvedBody& body = *resolved_.machine;
    if (body.expansion->origin == InputOrigin::assumed)
      notes_.push_back("α of the machine tool was not given; 12 µm/(m·°C) is assumed (Table A.2)");
    return product(row, expanded_per_range,
                   {{"α", "µm/(m·°C)", given(body.expansion)}, L(), {"R(θ)", "°C", given(body.temperature_range)}});
  }

  Contributor m_device() {
    const Contributor row{
        "m_device",
        "U_M,DEVICE",
        artefact_ ? "Temperature measurement of the artefact" : "Temperature measurement of the measuring device",
        "A.6",
        {},
        {}};
    if (linear_ && metadata_.uncertainty.device_temperature_range &&
        !(resolved_.device && resolved_.device->temperature_range && resolved_.device->expansion))
      notes_.push_back("R(θ) of the measuring device is left out because its α was not given (formula A.6)");
    if (!resolved_.device) return row;
    return product(row, expanded_per_range,
                   {{"α", "µm/(m·°C)", given(resolved_.device->expansion)},
                    L(),
                    {"R(θ)", "°C", given(resolved_.device->temperature_range)}});
  }

  Contributor e_machine() {
    const Contributor row{"e_machine", "U_E,MACHINE TOOL", "Expansion coefficient of the machine tool", "A.7", {}, {}};
    return expansion_term(row, "machine tool", resolved_.machine, metadata_.uncertainty.machine_expansion_range);
  }

  Contributor e_device() {
    const Contributor row{
        "e_device",
        "U_E,DEVICE",
        artefact_ ? "Expansion coefficient of the artefact" : "Expansion coefficient of the measuring device",
        "A.8",
        {},
        {}};
    // R(θ) alone does not say that what the device shows depends on its temperature.
    const AnnexAInputs& in = metadata_.uncertainty;
    const auto& alpha = resolved_.device ? resolved_.device->expansion : MaybeResolved();
    const bool expands = artefact_ && alpha && alpha->value != 0.0;
    if (!(in.device_temperature_difference || in.device_expansion_range || expands)) return row;
    return expansion_term(row, artefact_ ? "artefact" : "measuring device", resolved_.device,
                          in.device_expansion_range);
  }

  Contributor expansion_term(const Contributor& row, std::string_view whose, const std::optional<ResolvedBody>& body,
                             const std::optional<ExpansionCoefficient>& stated_range) {
    if (!linear_) return row;
    if (!body || !body->difference) {
      if (stated_range)
        notes_.push_back(fmt::format("R(α) of the {} is left out because its temperature was not given", whose));
      return row;
    }
    if (body->expansion_range->origin == InputOrigin::assumed)
      notes_.push_back(fmt::format("R(α) of the {} was not given; 2 µm/(m·°C) is assumed (A.2.4.3)", whose));
    Input difference = given(body->difference);
    difference->value = std::abs(difference->value);
    return product(row, expanded_per_range,
                   {{"ΔT", "°C", difference}, L(), {"R(α)", "µm/(m·°C)", given(body->expansion_range)}});
  }

  Contributor environmental_variation() {
    return product({"eve", "U_EVE", "Environmental variation", "A.9", {}, {}}, expanded_per_range,
                   {{"E_VE", deviation(), given(metadata_.uncertainty.environmental_variation)}});
  }

  const Metadata& metadata_;
  ResolvedInputs resolved_;
  std::span<const Position> targets_;
  std::optional<StationOffset> station_;
  bool linear_ = true;
  bool artefact_ = false;  // an artefact in place of the device (Annex D)
  Input length_;
  std::vector<std::string> notes_;
};

std::optional<Deviation> find_U(const std::vector<Contributor>& budget, std::string_view key) {
  const auto row = std::ranges::find(budget, key, &Contributor::key);
  return row == budget.end() ? std::nullopt : row->U;
}

/// (A.11) to (A.19) for the parameters that exist. A parameter of whose contributors none is known has no U.
AxisParameters combine(const std::vector<Contributor>& budget, std::size_t runs, bool slow,
                       const AxisParameters& measured) {
  const auto eve = find_U(budget, "eve");
  const double U_eve = eve ? eve->in_native() : 0.0;
  const double n = static_cast<double>(runs);
  double squares = 0.0;
  bool any = false;
  for (const Contributor& row : budget) {
    if (!row.U) continue;
    any = true;
    if (row.key != "eve") squares += row.U->in_native() * row.U->in_native();
  }
  const RepeatabilityFactors of_R = repeatability_factors(runs, slow);
  const double R_unidirectional = of_R.unidirectional * U_eve;  // A.11
  const auto probing = find_U(budget, "probing");  // both sides of a place, each with its error, in every run
  const double probed = probing ? std::numbers::sqrt2 * probing->in_native() : 0.0;
  const double reversal = std::hypot((runs == 5 ? 0.9 : 2.0 / std::sqrt(n)) * U_eve, probed);  // A.12, A.13
  const double R = of_R.bidirectional * U_eve;                                                 // A.14
  const double E = std::sqrt(squares + U_eve * U_eve / n);                                     // A.15, A.17
  const double M = std::sqrt(squares + U_eve * U_eve / (2.0 * n));                             // A.16, A.18
  const double A = std::hypot(E, R_unidirectional);                                            // A.19

  AxisParameters U;
  const auto state = [&](std::optional<Deviation> AxisParameters::*member, bool known, double value) {
    if (known && measured.*member) U.*member = Deviation::native(value);
  };
  for (auto member : {&AxisParameters::A, &AxisParameters::A_up, &AxisParameters::A_down}) state(member, any, A);
  for (auto member : {&AxisParameters::E, &AxisParameters::E_up, &AxisParameters::E_down}) state(member, any, E);
  state(&AxisParameters::M, any, M);
  state(&AxisParameters::R, eve.has_value(), R);
  for (auto member : {&AxisParameters::R_up, &AxisParameters::R_down}) state(member, eve.has_value(), R_unidirectional);
  for (auto member : {&AxisParameters::B, &AxisParameters::B_mean})
    state(member, eve.has_value() || probing.has_value(), reversal);
  return U;
}

std::vector<std::string> general_notes(const AnnexA& annex, const Metadata& metadata) {
  std::vector<std::string> notes;
  if (metadata.axis.kind == AxisKind::rotary)
    notes.push_back(
        "Annex A is written for linear axes: of its contributors the device (A.1) and the environmental variation "
        "(A.9) are combined in ″, the terms in µm/m do not apply");
  else if (artefact_takes_place_of_device(metadata) && !find_U(annex.budget, "m_device"))
    notes.push_back(
        "The artefact takes the place of the measuring device (Annex D); R(θ) of its temperature was not given, and "
        "U_M,DEVICE counts as zero");
  else if (!find_U(annex.budget, "m_device") && !find_U(annex.budget, "e_device"))
    notes.push_back(
        "U_M,DEVICE and U_E,DEVICE count as zero: right if the statement about the device includes its temperature, or "
        "if the device takes the temperature of the machine (A.6, A.8)");
  if (annex.runs > 1 && annex.runs < 5 && !annex.slow_environment)
    notes.push_back(
        fmt::format("For n = {} the factors printed for n = 5 and n = 1 are generalised: U_EVE²/n in A.15, U_EVE²/2n "
                    "in A.16, 2 U_EVE/√n in A.12, 4 U_EVE/√(n − 1) in A.11, and both of these in A.14",
                    annex.runs));
  else if (annex.runs != 5 && annex.runs != 1)
    notes.push_back(
        fmt::format("For n = {} the factors printed for n = 5 and n = 1 are generalised: U_EVE²/n in A.15, U_EVE²/2n "
                    "in A.16, 2 U_EVE/√n in A.12; those of A.11 and A.14 are kept",
                    annex.runs));
  if (annex.slow_environment && annex.runs > 1) {
    const RepeatabilityFactors factors = repeatability_factors(annex.runs, true);
    notes.push_back(
        fmt::format("The environmental variation is stated to be slow: A.11 and A.14 take {:.2f} and {:.2f}, for one "
                    "swing over the "
                    "test, in place of 2.0 and 2.2, which are for noise of single readings",
                    factors.unidirectional, factors.bidirectional));
  } else if (find_U(annex.budget, "eve") && metadata.gum.environment_kind != EnvironmentKind::white)
    notes.push_back(
        "The factors of U_EVE in A.11 to A.18 take it for noise of single readings; a slow drift moves neighbouring "
        "readings alike, see the Monte Carlo method");
  if (annex.U.B_mean) notes.push_back("For B̄ the annex has no formula; U(B), which bounds it, is stated");
  return notes;
}

}  // namespace

std::optional<AnnexA> annex_a(const Metadata& metadata, const Series& series, const Evaluation& evaluation,
                              const StatedItems& stated) {
  if (!annex_a_given(metadata)) return std::nullopt;
  AnnexABudget budget(metadata, series, stated);
  AnnexA result;
  result.budget = budget.rows();
  if (std::ranges::none_of(result.budget, [](const Contributor& row) { return row.U.has_value(); }))
    return std::nullopt;
  result.missing = missing_contributors(result.budget, metadata.axis.kind);
  result.runs = smallest_count(series);
  const auto kind = metadata.gum.environment_kind.value_or(EnvironmentKind::unknown);
  result.slow_environment =
      (kind == EnvironmentKind::drift || kind == EnvironmentKind::random_walk) && find_U(result.budget, "eve");
  result.U = combine(result.budget, result.runs, result.slow_environment, evaluation.parameters);
  result.datum = datum_of(metadata, series);
  const MeasuredLength length{budget.length_m(), metadata.axis.kind, budget.calibration()};
  result.positions = annex_a_positions(result, length, evaluation);
  const bool too_long = metadata.axis.kind == AxisKind::linear && budget.length_m() > length_limit_m;
  result.notes = std::move(budget).notes();
  for (std::string& note : general_notes(result, metadata)) result.notes.push_back(std::move(note));
  const auto eve = find_U(result.budget, "eve");
  const bool repeats = evaluation.parameters.R_up || evaluation.parameters.R_down;
  if (eve && repeats && !too_long) result.corrected = corrected_repeatability(evaluation, *eve);
  if (eve && repeats && too_long)
    result.notes.push_back(
        "Above 2 000 mm the annex has no formula for repeatability: (A.11) and (A.14) are used all the same, and "
        "nothing is corrected for the environment (A.2.6)");
  return result;
}

}  // namespace axiometry::iso230_2
