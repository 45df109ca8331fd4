// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/metadata.h"
#include "axiometry/model/origins.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// ISO 230-2:2014, Annex A: simplified expanded uncertainty (k = 2) of every parameter of the axis,
/// formulas (A.1) to (A.19). Derivation and the four published examples: docs/theory/annex-a.md.
///
/// Errata settled (docs/theory/annex-a.md): the u under the roots of (A.15) to (A.18) are expanded
/// uncertainties and the factor 2 printed once is dropped; (A.19) combines U(E) and U(R↑, R↓).
namespace axiometry::iso230_2 {

/// One named input of a contributor, with the unit it is stated in.
struct BudgetInput {
  std::string_view symbol;  ///< "R(θ)"
  double value = 0.0;
  std::string_view unit;  ///< "°C"
  std::string_view note;  ///< how a value follows that was not given: "assumed", "from the travel"; else empty
};

/// One line of the budget.
struct Contributor {
  /// "device", "misalignment", "m_machine", "m_device", "e_machine", "e_device", "eve"; of an artefact "probing", of a
  /// tracking interferometer "station"
  std::string_view key;
  std::string_view symbol;   ///< "U_M,MACHINE TOOL"
  std::string_view title;    ///< "Temperature measurement of the machine tool"
  std::string_view formula;  ///< "A.5"; of the station, which is not in the annex, "Lee et al. 19"
  std::vector<BudgetInput> inputs;
  std::optional<Deviation> U;  ///< expanded, k = 2; absent when its inputs were not given
};

/// Repeatabilities corrected for environmental variation (A.2.6, A.10), beside the measured ones.
struct CorrectedRepeatability {
  std::vector<PositionResult> positions;  ///< results with s_i and R_i corrected
  AxisParameters parameters;              ///< only R, R↑ and R↓ are meant; the others stay as measured
  std::vector<std::size_t> floored;       ///< targets (index) where s_i² < (U_EVE/2)² and 0 was taken
};

/// (A.10): s_i² less (U_EVE/2)², never below 0, and R_i, R, R↑ and R↓ from it.
CorrectedRepeatability corrected_repeatability(const Evaluation& evaluation, Deviation U_eve);

/// Of one mean deviation, k = 2.
struct AnnexAMean {
  std::optional<Deviation> environment;  ///< U_EVE of the mean: over √n in x̄_i↑ and x̄_i↓; absent without E_VE
  Deviation U;
};

/// The mean deviations of one target. Annex A prints no U of them: composed here of its contributors.
struct AnnexAPosition {
  Position target;
  std::optional<double> length_m;                       ///< l_i; absent of rotary axes
  std::vector<std::optional<Deviation>> contributions;  ///< parts of AnnexA::budget at l_i, in its order; without U_EVE
  std::optional<AnnexAMean> up, down, mean;  ///< uncertainties of x̄_i↑, x̄_i↓ and x̄_i, where they exist
};

struct AnnexA {
  std::vector<Contributor> budget;  ///< always all seven, in the order of A.2; then probing and station, if given
  AxisParameters U;                 ///< expanded uncertainty, k = 2, of each parameter that exists (but see below)
  std::vector<std::string_view> missing;  ///< missing_contributors(): where there are any, every U is too small
  std::size_t runs = 0;                   ///< n used: the smallest number of approaches in any measured cell
  bool slow_environment = false;          ///< E_VE is stated as drift or random walk: other factors in A.11 and A.14
  Position datum;                         ///< the mean deviations count from here: `nde.datum`, else the first target
  std::vector<AnnexAPosition> positions;  ///< a position for each target
  std::vector<std::string> notes;         ///< what was assumed or generalised
  std::optional<CorrectedRepeatability> corrected;  ///< when E_VE is given and R exists
};

/// The uncertainty of an evaluation from the inputs of its test. Absent when none of the contributors can
/// be computed from them; one whose inputs are missing counts as 0 and findings say so. U(R), U(B) and
/// their like rest on U_EVE alone and are absent without it: ±0 would be a false claim.
///
/// - L: `inputs.length`, else the measured travel.
/// - n = 5 and n = 1 as printed. For other n (generalised here): U_EVE²/n in (A.15), U_EVE²/2n in
///   (A.16), 2·U_EVE/√n in (A.12); it is 0.894 for n = 5 where 0.9 is printed and 2 for n = 1 as (A.13).
/// - E_VE stated as a drift or a random walk (generalised here): U(R↑) and U(R) take √2/0.6 √(n/(n − 1)) and 1/(0.6 n)
///   more than that in place of 2.0 and 2.2; 2.64 and 2.97 for n = 5. E, M and B, which a slow variation moves less
///   than noise of the same range, keep theirs.
/// - U(B̄) is not in the annex: U(B), which bounds it.
/// - α of the machine: given, else that of the scale, else of the NDE correction, else 12 µm/(m·°C)
///   (Table A.2), noted as assumed. R(α): given, else 2 µm/(m·°C) (A.2.4.3), when ΔT is known. ΔT: given,
///   else the largest |T − 20 °C| of the sensors with role "machine". For the device alike, but only when
///   one of ΔT and R(α) was given: without, its statement is taken to include its temperature.
/// - Which of several statements counts, and what follows where one is missing: inputs/resolved_inputs.h. Of equally
///   strong ones about the device the calibration (A.1, A.2) before the error range (A.3).
/// - A calibration with a constant part a and one of b per metre: U_DEVICE = a + b·L, or √(a² + (b·L)²) where the
///   certificate says so; of an artefact likewise.
/// - An artefact (Annex D) takes the place of the device, whatever is said of another device; it counts as expanding
///   where its α is known and not 0. U of one probing is the same in every run: it counts as one more contributor to E,
///   M and A and, since both sides of a place are probed, √2 times to B.
/// - A tracking interferometer whose station is uncertain across the line (TrackingInputs; station_offset.h) adds a
///   contributor that the annex does not know, to E, M and A: what the range of the length difference over the targets
///   stays below with 95 %. Readings are not corrected for its mean, so that the whole range counts. It shifts both
///   directions alike: B and R have no part in it. Its beam follows the reflector; a misalignment (A.4) is left out.
/// - (A.10), (A.11) and (A.14) are given up to L = 2 000 mm. Above, nothing is corrected, and U of an R that
///   exists all the same follows (A.11) and (A.14), noted.
/// - Rotary axes: the annex is written for linear ones; (A.1) and (A.9) apply with ″, the terms in µm/m
///   do not.
///
/// The mean deviations of a target, which the annex does not print (derivation: docs/theory/annex-a.md, "The mean
/// deviations of a target"), take the contributors for the length l_i from the datum to the target instead of L:
/// - (A.1) and what is not stated per length as it is; (A.2), (A.3) and (A.5) to (A.8) with l_i for L; (A.4) for the
///   same angle, 0.3 R² l_i/L²: the run-off R over L is R l_i/L over l_i. Where L is stated above the measured travel,
///   l_i grows in the same proportion.
/// - U of one probing and of a station, which no length divides, whole at every target.
/// - x̄_i↑, x̄_i↓ after (A.15) and (A.17) with U_EVE²/n, x̄_i after (A.16) and (A.18) with U_EVE²/2n, n of the mean's
///   cell; of cells that differ in n (1/n↑ + 1/n↓)/4 for 1/2n. At l_i = L with n everywhere these are U(E) and U(M).
///
/// Inputs are ≥ 0 (ΔT may be negative; its magnitude counts): model/fields.h checks them on entry.
std::optional<AnnexA> annex_a(const Metadata& metadata, const Series& series, const Evaluation& evaluation,
                              const StatedItems& stated = {});

/// Keys of the contributors that 8.2.1 asks for at least and that a budget (of nothing given an empty one) does not
/// know, as far as Annex A has a formula for this kind of axis. Where there are any, every U is too small.
std::vector<std::string_view> missing_contributors(std::span<const Contributor> budget, AxisKind kind);

}  // namespace axiometry::iso230_2
