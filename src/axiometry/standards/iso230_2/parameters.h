// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "axiometry/model/series.h"
#include "axiometry/standards/iso230_2/axis_extremes.h"

/// ISO 230-2:2014, clauses 3 and 6: positioning accuracy and repeatability of one NC axis.
///
/// The same formulas serve linear and rotary axes; values are in the native deviation unit of the
/// axis (µm or ″). Derivation and worked example: docs/theory/iso230-2.md. The amendment of 2016 has
/// not been read. Deliberately absent: any fit or removal of offset, slope or drift. The deviations
/// are evaluated as they were measured.
namespace axiometry::iso230_2 {

/// "ISO 230-2:2014", the edition whose clause numbers are cited.
inline constexpr std::string_view edition = "ISO 230-2:2014";

/// Coverage factor of the repeatability band: mean ± 2 s (3.19, 3.26).
inline constexpr double coverage_factor = 2.0;

/// What clause 3 defines at one target position. A member is absent when its readings are: no mean
/// without a reading, no s without two of them.
struct PositionResult {
  Position target;                     ///< P_i, 3.4
  std::size_t count_up = 0;            ///< n↑ at this target
  std::size_t count_down = 0;          ///< n↓ at this target
  std::optional<Deviation> mean_up;    ///< x̄_i↑, 3.13
  std::optional<Deviation> mean_down;  ///< x̄_i↓, 3.13
  std::optional<Deviation> mean;       ///< x̄_i, 3.14; needs both directions
  std::optional<Deviation> reversal;   ///< B_i = x̄_i↑ − x̄_i↓, 3.15, signed
  std::optional<Deviation> s_up;       ///< s_i↑, 3.18, divisor n − 1
  std::optional<Deviation> s_down;     ///< s_i↓, 3.18
  std::optional<Deviation> R_up;       ///< R_i↑ = 4 s_i↑, 3.19
  std::optional<Deviation> R_down;     ///< R_i↓ = 4 s_i↓, 3.19
  /// R_i, 3.20: the largest of 2s_i↑ + 2s_i↓ + |B_i|, R_i↑, R_i↓; needs s_i of both directions, and so B_i.
  std::optional<Deviation> R;
};

/// The parameters of the axis (3.16 to 3.27). Absent means "not applicable": a bidirectional one
/// without two directions, R and A with a single approach per direction (6.2). Never zero, never NaN.
struct AxisParameters {
  std::optional<Deviation> A;       ///< bidirectional positioning error, 3.27
  std::optional<Deviation> A_up;    ///< unidirectional positioning error, 3.26
  std::optional<Deviation> A_down;  ///< unidirectional positioning error from above, 3.26
  std::optional<Deviation> E;       ///< bidirectional systematic positioning error, 3.24
  std::optional<Deviation> E_up;    ///< unidirectional systematic positioning error, 3.23
  std::optional<Deviation> E_down;
  std::optional<Deviation> M;     ///< mean bidirectional positioning error, 3.25
  std::optional<Deviation> R;     ///< bidirectional repeatability, 3.22
  std::optional<Deviation> R_up;  ///< unidirectional repeatability, 3.21
  std::optional<Deviation> R_down;
  std::optional<Deviation> B;       ///< reversal error, 3.16: max |B_i|
  std::optional<Deviation> B_mean;  ///< mean reversal error, 3.17, signed
};

/// One row of the parameter vocabulary: everything that names, lists or prints parameters reads it.
struct ParameterInfo {
  std::string_view key;     ///< name in JSON, CSV and --tolerance: "A_up"
  std::string_view symbol;  ///< "A↑"
  std::string_view title;   ///< "Unidirectional positioning error"
  std::string_view clause;  ///< "3.26"
  bool acceptance;          ///< marked in 8.2.2 as a basis for acceptance
  std::optional<Deviation> AxisParameters::*member;
};

/// The twelve parameters in the order of 8.2.2, A first.
inline constexpr ParameterInfo parameters[] = {
    {"A", "A", "Bidirectional positioning error", "3.27", true, &AxisParameters::A},
    {"A_up", "A↑", "Unidirectional positioning error", "3.26", true, &AxisParameters::A_up},
    {"A_down", "A↓", "Unidirectional positioning error", "3.26", true, &AxisParameters::A_down},
    {"E", "E", "Bidirectional systematic positioning error", "3.24", true, &AxisParameters::E},
    {"E_up", "E↑", "Unidirectional systematic positioning error", "3.23", false, &AxisParameters::E_up},
    {"E_down", "E↓", "Unidirectional systematic positioning error", "3.23", false, &AxisParameters::E_down},
    {"M", "M", "Mean bidirectional positioning error", "3.25", true, &AxisParameters::M},
    {"R", "R", "Bidirectional positioning repeatability", "3.22", false, &AxisParameters::R},
    {"R_up", "R↑", "Unidirectional positioning repeatability", "3.21", true, &AxisParameters::R_up},
    {"R_down", "R↓", "Unidirectional positioning repeatability", "3.21", true, &AxisParameters::R_down},
    {"B", "B", "Reversal error", "3.16", true, &AxisParameters::B},
    {"B_mean", "B̄", "Mean reversal error", "3.17", false, &AxisParameters::B_mean},
};

/// Ranges, largest values and scatters are no less than 0; the mean reversal error alone may be. Of figures of other
/// rules, which have these keys, likewise.
constexpr bool may_be_below_0(std::string_view key) { return key == "B_mean"; }

/// By key or symbol; nullptr when there is none.
const ParameterInfo* find_parameter(std::string_view name);

/// One row of the vocabulary of what clause 3 defines at a position.
struct PositionQuantity {
  std::string_view key;     ///< name in JSON, CSV and conformance cases: "mean_up"
  std::string_view clause;  ///< "3.13"
  std::optional<Deviation> PositionResult::*member;
};

inline constexpr PositionQuantity position_quantities[] = {
    {"mean_up", "3.13", &PositionResult::mean_up},
    {"mean_down", "3.13", &PositionResult::mean_down},
    {"mean", "3.14", &PositionResult::mean},
    {"reversal", "3.15", &PositionResult::reversal},
    {"s_up", "3.18", &PositionResult::s_up},
    {"s_down", "3.18", &PositionResult::s_down},
    {"R_up", "3.19", &PositionResult::R_up},
    {"R_down", "3.19", &PositionResult::R_down},
    {"R", "3.20", &PositionResult::R},
};

struct Evaluation {
  AxisParameters parameters;
  std::vector<PositionResult> positions;  ///< one per target, ascending
};

/// Evaluates clause 3 over every target. Total: any valid series has an evaluation.
///
/// Where readings are missing, each parameter is taken over the targets where its terms exist. E needs
/// both directions; A some s_i in both; M, B and B̄ a target with both; R that and some s_i in both
/// directions. Where some s_i exist and another does not, 0 stands for it, and in R for the B_i of a target
/// with one direction: this keeps the ordering below and makes the result a lower bound, also of targets that have
/// no R_i of their own. assess() then marks it as departing from the standard.
///
/// Checked on every result (contract): E ≥ E↑, E↓, M, B; A ≥ E, A↑, A↓, R; R ≥ R↑, R↓, B; |B̄| ≤ B.
///
/// Two-pass moments: for |x| < 1 mm and n ≤ 100 within 1e-9 µm of the exact value
/// (tests/conformance/iso230_2/offset.case).
Evaluation evaluate(const Series& series);

/// The first half of evaluate(): means, s_i, B_i and R_i of every target.
std::vector<PositionResult> evaluate_positions(const Series& series);

/// The same at one target, from the runs of both directions (native units, NaN where a reading is missing).
PositionResult evaluate_position(const Position& target, std::span<const double> up, std::span<const double> down);

/// The second half: the parameters of the axis from its positions.
AxisParameters evaluate_axis(std::span<const PositionResult> positions);

/// The parameters of an axis with one of its positions exchanged for another, in a time that does not grow with the
/// positions: what a single reading does to the axis is asked once for each outlier.
class AxisWithoutOne {
 public:
  explicit AxisWithoutOne(std::span<const PositionResult> positions);
  /// As evaluate_axis() with `instead` at position i; B̄ within the rounding of its sum.
  AxisParameters with(std::size_t i, const PositionResult& instead) const;

 private:
  std::vector<AxisExtremes> before_, after_;  // extremes of all positions before, and after, each
};

/// The position with other estimators s_i↑ and s_i↓, R_i following 3.19 and 3.20. A.10 corrects so.
PositionResult with_estimators(PositionResult position, std::optional<Deviation> s_up, std::optional<Deviation> s_down);

}  // namespace axiometry::iso230_2
