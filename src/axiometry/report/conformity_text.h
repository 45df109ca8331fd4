// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "axiometry/report/document.h"
#include "axiometry/report/report.h"

/// Decisions on conformity in words, the same in reports and in the terminal.
namespace axiometry::report {

/// "57.3 %", finer towards both ends: "99.95 %", "> 99.99 %", "< 0.01 %"; never 0 or 100 %, which no estimate gives.
std::string shown_probability(double probability, const Options& options);

/// The same of p_c, from the least to the most that is held possible: "57.3 %", or "0.4 to 57.3 %".
std::string shown_conformity(const uncertainty::Decision& decision, const Options& options);

/// Decimals of T − g and T + g: one more than those of the value, so that a limit near it can be told from it.
int limit_decimals(const ShownParameter& shown);

/// "simple acceptance", "ISO 14253-1", "guard band of 3 µm"
std::string rule_title(const uncertainty::DecisionRule& rule, AxisKind kind, const Options& options);

/// Whose uncertainty stands beside the values: "U = 2 u by Annex A". Empty where there is none.
std::string record_statement(const iso230_2::Assessment& assessment, const Options& options);

/// The rule that was used, its formula, and where u came from. Nothing without a judgement.
std::string rule_statement(std::span<const iso230_2::Judgement> judgements, AxisKind kind, const Options& options);

/// That the uncertainty which decides is known to lack something; empty under simple acceptance, and where nothing
/// lacks.
std::string incomplete_statement(std::span<const iso230_2::Judgement> judgements,
                                 const iso230_2::Assessment& assessment);

/// That equipment was out of calibration, whose contribution is in no uncertainty; empty where it was not, and under
/// simple acceptance without probabilities.
std::string uncalibrated_statement(std::span<const iso230_2::Judgement> judgements,
                                   const iso230_2::Assessment& assessment);

/// That noise makes A and R larger than the uncertainty of record knows, where one of them lies beyond its limit and a
/// finding tells it (noise-beside-scatter); else empty.
std::string noise_statement(std::span<const iso230_2::Judgement> judgements, const iso230_2::Assessment& assessment);

/// Why nothing was decided on some parameters, a sentence for each reason: "A, E: undecided, because …".
std::vector<std::string> withheld_statements(std::span<const iso230_2::Judgement> judgements);

/// The statement with its symbols T, g, u and U in italics.
RichText with_symbols(std::string_view statement);

/// "A, E↑", of those with this verdict.
RichText symbols_with(std::span<const iso230_2::Judgement> judgements, uncertainty::Verdict verdict);

/// Which tone a verdict has.
Tone tone_of(uncertainty::Verdict verdict);

/// As a reader knows it: "tolerance table", "file of the test", "command line".
std::string_view source_title(iso230_2::ToleranceSource source);

}  // namespace axiometry::report
