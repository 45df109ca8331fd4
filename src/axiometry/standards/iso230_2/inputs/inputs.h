// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/metadata.h"
#include "axiometry/model/origins.h"
#include "axiometry/model/series.h"
#include "axiometry/uncertainty/distribution.h"

/// The input quantities of a positioning test's uncertainty, with their distributions: the one list that the
/// law of propagation (uncertainty/gum.h) and the Monte Carlo method (monte_carlo/monte_carlo.h) both read. Model and
/// equation numbers: Lira & Cargill, Precision Engineering 28 (2004) 232. Derivation: docs/theory/uncertainty.md.
namespace axiometry::iso230_2 {

/// How an input acts on the readings: on a reading at position P (mm or °, as the machine counts) it adds x.
/// One draw is shared by all readings of …
enum class Effect {
  machine_expansion,    ///< … the test: α in x = P (f_t(α, ΔT) − f_t(α̂, ΔT̂)), eq. 14; µm/(m·°C)
  machine_temperature,  ///< … the test: ΔT of the same; °C
  device_expansion,     ///< … the test: the same with the opposite sign, for the device (A.6, A.8)
  device_temperature,
  alignment,         ///< … the test: angle θ in x = P (1/cos θ − 1), eq. 18; of an artefact P (cos θ − 1); °
  station,           ///< … the test: offset Δ of the station across the line, in x = −error_um(Σ Δ²); mm
  scale,             ///< … the test: x = P ε; µm/m; linear axes only
  displacement,      ///< … the test: any two positions, however near, differ by x more; µm
  target,            ///< … one target in both directions, µm or ″
  target_direction,  ///< … one target in one direction, µm or ″
  run,               ///< … one run in both directions, µm or ″
  reading,           ///< each reading has its own, µm or ″: the noise of known size
};

std::string_view effect_key(Effect effect);  ///< "machine_expansion", …, "reading"

struct UncertaintyInput {
  std::string key;     ///< "machine_temperature"; also names the input in `uncertainty.distributions`
  std::string symbol;  ///< "ΔT"
  std::string title;   ///< "Temperature of the machine, less 20 °C"
  std::string source;  ///< equation or formula: "16, A.5"
  Effect effect = Effect::scale;
  /// Of α, ΔT, θ and Δ as they are, so that the means are α̂ and ΔT̂; of all others about zero.
  uncertainty::Distribution distribution;
  std::string unit;  ///< unit of the distribution
  std::string note;  ///< "assumed", "largest of the sensors", "as given"; empty for an item of the metadata
};

/// Everything that is known about the inputs of a test. Of expansion and temperature (of the machine, of the
/// device) there are both or none: what is known without uncertainty is a constant.
struct UncertaintyInputs {
  std::vector<UncertaintyInput> inputs;
  /// r between the errors of a `target` input in both directions of a target: at 1 it is the same error, at 0
  /// two independent ones. Also that of eq. 10. What is shared by the whole test has no use for it.
  double up_down_correlation = 1.0;
  std::vector<std::string> notes;  ///< what was assumed
  /// Whether lengths are those of an artefact: at an angle it has less along the axis than it is long, where an
  /// instrument shows less than the way.
  bool of_artefact = false;
  std::optional<Position> station;  ///< P_s, there where a `station` input is: what it acts from (station_offset.h)
};

/// From the metadata as resolved (resolved_inputs.h), where `uncertainty.distributions` replaces or adds to
/// what the single items say. The items of Annex A mean what they mean there, with the same defaults
/// (uncertainty/annex_a.h). An item that was not given has no input.
///
/// - machine_temperature: uniform of width R(θ) about ΔT; ΔT given, else the sensors' largest, else 0 with α known.
/// - machine_expansion: uniform of width R(α) about α.
/// - device_temperature, device_expansion: likewise, where R(θ), ΔT or R(α) of the device was given.
/// - alignment: θ uniform up to ± θ_max; given, else the angle of R_MISALIGNMENT over L.
/// - device: linear, ε normal with U/2 (A.2) or uniform over the error range (A.3); rotary, normal with U/2 at each
///   target. device_constant, which any two positions differ by, normal with U/2 (A.1). With both parts of a
///   calibration they are normal with w b/2 and w a/2: no displacement up to L then has less than the stated U
///   (ResolvedCalibration::widening(), w).
/// - artefact (Annex D), in place of the device: artefact_calibration, normal with w U/2 at each target, the same in
///   both directions; artefact_calibration_length, ε normal with w U/2; probing, normal with U/2 at each target and
///   direction: what the runs share, since what differs between them is part of their scatter. Its temperature counts
///   where α and sensors are known.
/// - environment: ε normal with K·ΔT_e (24); ΔT_e given, else the mean air temperature less 20 °C.
/// - axis_resolution, instrument_resolution: uniform of that width at each target (22, 23).
/// - station, station_smaller (tracking interferometer): the offsets Δ of the station in the two principal directions
///   across the line, normal with u1 and u2; the latter only above 0. A misalignment is then left out: the beam
///   follows.
/// - environmental_variation: uniform of width E_VE at each reading. run_drift: normal.
///
/// Whether the correction for expansion was applied changes nothing here: the uncertainty of α and ΔT is that of the
/// position at 20 °C either way. Where it was not applied, the known
/// expansion stays in the results as a deviation of the machine, and a note tells its size.
///
/// Empty inputs when nothing was given. Fails on a distribution that cannot be read or is not allowed, naming its
/// input (limits: |mean| + 10 sd up to 1 000 µm/(m·°C), 200 °C, 90°, 1e6 mm; 1e9 for others), on one given twice, on
/// one of the station without its position along the line, and on a correlation outside −1 to 1.
Result<UncertaintyInputs> uncertainty_inputs(const Metadata& metadata, const Series& series,
                                             const StatedItems& stated = {});

/// Said of parameters, by their symbols, on which nothing that is known acts.
std::string no_claim_note(std::span<const std::string_view> symbols);

/// Said of known noise where the scatter of the approaches counts (this_machine).
inline constexpr std::string_view scatter_note =
    "The known noise of readings and runs is part of the scatter and not counted again";

/// Which of two questions the uncertainty answers (model/metadata.h).
using axiometry::Measurand;

Measurand measurand_of(const Metadata& metadata);  ///< what is stated, else this_test

std::string_view measurand_key(Measurand measurand);    ///< "this-test", "this-machine"
std::string_view measurand_title(Measurand measurand);  ///< a clause for reports

}  // namespace axiometry::iso230_2
