// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"
#include "axiometry/standards/rules/comparison.h"

/// The uncertainty of other rules' figures by the Monte Carlo method that carries the parameters of ISO 230-2:2014
/// (standards/iso230_2/monte_carlo/): each trial is a complete test that may have happened, and each figure is taken of
/// it. An interval is of the figure as its formula is known here; it says nothing of whether that is the rule's.
///
/// For this test every figure has one. In the long run of a machine there are means and s of the targets but no single
/// readings, unless whole runs are resampled: figures made of single readings then have none.
namespace axiometry::standards {

/// Trials where nobody says how many: ends of intervals are known to about 1 % of their width. An adaptive run would
/// wait for the slowest of some sixty figures.
inline constexpr std::size_t usual_rule_trials = 50'000;

inline constexpr std::string_view nothing_acts = "nothing that is known acts on it";
inline constexpr std::string_view zero_left_out =
    "Figures that count from zero, as positioning accuracy of GB/T 38614 does, count from where the instrument was set "
    "to zero: an error of that zero is not in their intervals";
/// Of this test, where nothing is stated of the runs.
inline constexpr std::string_view clamping_left_out =
    "Shifts of whole runs by clamping anew are in the intervals of figures that count from zero only where a drift "
    "from "
    "run to run is stated";
/// Of two runs of a machine in the long run.
inline constexpr std::string_view two_runs_tell_little =
    "Where two runs alone lie far apart, intervals of 95 % of figures that count from zero held the true value in 89 % "
    "of simulated tests; three runs mend that";
inline constexpr std::string_view no_single_readings =
    "is made of single readings, which the long run of a machine does not have";

/// Adds intervals to the figures of a comparison of that test. None where nothing is known of the uncertainty. Fails as
/// iso230_2::monte_carlo() does; the comparison is then as before. Takes a time that grows with trials × (readings +
/// figures × targets).
Result<void> add_intervals(RuleComparison& comparison, const Test& test, const iso230_2::MonteCarloOptions& options);

}  // namespace axiometry::standards
