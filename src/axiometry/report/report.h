// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/language/language.h"
#include "axiometry/model/test.h"
#include "axiometry/report/documents/verified.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/iso230_2/verdict/tolerance.h"
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"

namespace axiometry::iso230_2 {
struct LoggedEnvironment;  // standards/environment/environment.h
struct TestEnvironment;    // likewise
}  // namespace axiometry::iso230_2

namespace axiometry::report {

/// The unit in which parameters are shown; deviations at positions are in µm or ″ always.
enum class DisplayUnit { native, mm, um, nm, deg, arcsec };

struct Options {
  NumberStyle numbers;                     ///< decimal point or comma
  DisplayUnit unit = DisplayUnit::native;  ///< native: µm or ″
  /// Of deviations and of parameters without U, in µm or ″. When not chosen: 1 (0.1 µm), and more where
  /// A (or what there is of it) would otherwise show fewer than two significant digits; see fitted().
  std::optional<int> deviation_decimals{};
  int uncertainty_digits = 2;  ///< significant digits of U; the parameter ends at the same place
  language::Language language = language::Language::english;  ///< language of the program's words, not the user's
};

/// The options with deviation_decimals chosen. Every entry to this folder (show, figures, compose) fits
/// the options it is given.
Options fitted(Options options, const iso230_2::AxisParameters& measured);

/// All that a report is made of.
struct Subject {
  const Test& test;
  const iso230_2::Assessment& assessment;
  std::span<const iso230_2::Judgement> judgements;
  std::optional<VerifiedFigures> verified{};  ///< what was recomputed, where all of it was before
  std::string trail_head{};  ///< end of the archive's audit trail before an issued report: "17:3f2a9c0b1d2e4f56"
  const iso230_2::LoggedEnvironment* temperatures = nullptr;  ///< temperatures about the test, if logged
  const iso230_2::TestEnvironment* environment = nullptr;     ///< environment of the test, by that log or stated
};

/// What a trail_head is called wherever an output says it.
inline constexpr std::string_view trail_head_name = "Audit trail before issue";

/// Parameter value and uncertainty of record (verdict/uncertainty_of_record.h) as shown to people: U to
/// `uncertainty_digits` significant digits, the value to U's last place; without U to `deviation_decimals`.
struct ShownParameter {
  std::string value;       ///< "9.6"; "not applicable" where the parameter does not exist
  std::string U;           ///< "4.3" or ""; of Annex A or the GUM
  std::string unit;        ///< "µm"
  std::string interval{};  ///< interval of the Monte Carlo method, which has no U: "8.0 to 12.3"; else ""
  int decimals = 0;        ///< decimals of the value; negative for tens, hundreds
};
ShownParameter show(const iso230_2::ParameterInfo& parameter, const iso230_2::Assessment& assessment, AxisKind kind,
                    const Options& options);
/// Beside its limit: with as many decimals more as tell on which side of it, of T − g and of T + g the value lies.
ShownParameter show(const iso230_2::Judgement& judgement, const iso230_2::Assessment& assessment, AxisKind kind,
                    const Options& options);

}  // namespace axiometry::report
