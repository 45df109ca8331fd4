// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/metadata.h"
#include "axiometry/model/origins.h"
#include "axiometry/model/series.h"

/// What a test states about its uncertainty, resolved once: of several statements about one thing the one that counts,
/// what follows where nothing was stated, and what cannot act. Annex A (uncertainty/annex_a.h) and the inputs of the
/// other methods (inputs.h) read this alone, so that no statement reaches one of them and not the others.
/// Rules and derivations: docs/theory/uncertainty.md, "Inputs as resolved".
namespace axiometry::iso230_2 {

/// Where a value comes from; the first four as StatedBy.
enum class InputOrigin {
  instrument,
  file,
  entered,
  flag,
  sensors,          ///< the largest departure from 20 °C of the sensors of a role
  air,              ///< the mean air temperature less 20 °C
  nde_correction,   ///< the coefficient of the correction for expansion
  scale,            ///< the coefficient of the scale
  measured_travel,  ///< L
  misalignment,     ///< θ_max from R over L
  alignment_angle,  ///< R from θ_max over L
  assumed,          ///< what the standard assumes where nothing is stated
};

std::string_view origin_key(InputOrigin origin);  ///< "flag", "nde-correction", …, as in the JSON results

/// What budgets say of a value that nobody stated: "assumed", "of the scale"; empty for one that was stated.
std::string_view origin_note(InputOrigin origin);

struct ResolvedValue {
  double value = 0.0;
  InputOrigin origin = InputOrigin::file;
};
using MaybeResolved = std::optional<ResolvedValue>;

/// Expansion and temperature of the machine or of what measures it. Ranges are full widths.
struct ResolvedBody {
  MaybeResolved expansion;          ///< α, µm/(m·°C)
  MaybeResolved expansion_range;    ///< R(α), µm/(m·°C); where ΔT is known never absent
  MaybeResolved difference;         ///< ΔT, °C
  MaybeResolved temperature_range;  ///< R(θ), °C; only where α is known
};

/// U = a and b·L of a certificate, k = 2.
struct ResolvedCalibration {
  MaybeResolved constant;    ///< a, µm or ″
  MaybeResolved per_length;  ///< b, µm/m
  CalibrationSum sum = CalibrationSum::linear;

  bool both() const { return constant && per_length; }
  /// U(l) at a length, m.
  double at(double length_m) const;
  /// By what both parts, taken as independent, must grow so that their root is nowhere below U(l) up to this length:
  /// max (a + b l)/√(a² + (b l)²), which is √2 where b L ≥ a, else the ratio at L; 1 for the root of squares or one
  /// part.
  double widening(double length_m) const;
};

/// Which methods a statement reaches.
enum class InputUse {
  none,         ///< `reason` says why
  all,          ///< Annex A, GUM and Monte Carlo
  annex_a,      ///< the other methods take a distribution in its place
  propagation,  ///< GUM and Monte Carlo: Annex A has no formula for it
};

std::string_view use_key(InputUse use);  ///< "none", "all", "annex-a", "gum-and-monte-carlo"

/// One statement, used or not.
struct ResolvedRow {
  std::string key;     ///< key of the vocabulary: "uncertainty.device_error_range_um_per_m", "sensors"
  std::string symbol;  ///< "R_DEVICE"
  std::optional<double> value;
  std::string word;  ///< word that stands in place of a value: "linear", "uniform 10 12"
  std::string unit;
  InputOrigin origin = InputOrigin::file;
  std::string
      instrument;  ///< what the value comes from: the name of an instrument, "recording at standstill"; or empty
  InputUse use = InputUse::all;
  std::string reason;  ///< why not used, or not by all methods: a clause; else empty
};

/// What a reader must know of how the statements were resolved; becomes a finding.
struct ResolvedRemark {
  bool missing = false;  ///< a statement that was made could not be used; else a note
  std::string message;   ///< a whole sentence without full stop, naming the keys
  std::string key{};     ///< of the metadata: the statement that it is about; may be empty
};

struct ResolvedInputs {
  bool asked_for = false;  ///< whether anything is stated that asks for an uncertainty: sensors alone do not
  ResolvedValue length_m;  ///< L
  std::optional<ResolvedBody> machine;
  std::optional<ResolvedBody> device;      ///< absent: its statement includes its temperature
  ResolvedCalibration device_calibration;  ///< none where the error range or an artefact counts
  MaybeResolved device_error_range;        ///< µm/m
  ResolvedCalibration artefact_calibration;
  MaybeResolved probing;                         ///< uncertainty of probing the artefact, µm
  MaybeResolved misalignment_mm;                 ///< R over L; both this and the next or none
  MaybeResolved alignment_deg;                   ///< θ_max
  MaybeResolved environment_sensitivity;         ///< K, µm/(m·°C)
  MaybeResolved environment_difference;          ///< ΔT_e, °C, which K belongs to
  std::vector<InputDistribution> distributions;  ///< distributions that count
  std::vector<ResolvedRow> rows;                 ///< rows in the order of the vocabulary, what follows beside its like
  std::vector<ResolvedRemark> remarks;
  std::vector<std::string> device_notes;  ///< notes on several statements about the device, for tables of the methods
};

/// Of several statements about one thing the one with the strongest origin counts (flag, entered, file, instrument); of
/// equally strong ones as the theory page lists. Whatever is overridden, cannot act or was assumed has its row, and all
/// but what was assumed its remark.
ResolvedInputs resolve_inputs(const Metadata& metadata, const Series& series, const StatedItems& stated = {});

/// α of the machine in µm/(m·°C) by the same rules, also where nothing asks for an uncertainty.
double machine_expansion(const Metadata& metadata);

}  // namespace axiometry::iso230_2
