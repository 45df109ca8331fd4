// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/report/report.h"
#include "axiometry/uncertainty/distribution.h"

/// The uncertainty of the parameters by several methods, as people read it: reports and the terminal show the same
/// numbers and say the same sentences.
namespace axiometry::report {

/// What the Monte Carlo method says about one parameter. Mean, bias and interval end where a quarter of
/// the interval's width does, u where it does itself.
struct ShownDistribution {
  std::string mean;
  std::string u;
  std::string bias;            ///< value − mean
  std::string lower, upper;    ///< ends of the interval that is stated, which holds the value
  std::string tolerance;       ///< δ of JCGM 101, 7.9.2; the half of the last place shown where it is met
  bool stable = false;         ///< whether δ is met
  bool value_outside = false;  ///< whether the interval had to be widened to hold the measured value
};

/// One parameter by every method that was run.
struct MethodRow {
  const iso230_2::ParameterInfo* parameter = nullptr;
  std::string value;      ///< value as show() shows it
  std::string annex_a_U;  ///< k = 2; empty where the method says nothing
  std::string gum_U;      ///< with its own k; empty where the method says nothing
  std::optional<ShownDistribution> monte_carlo;
  std::string annex_a_width;  ///< width_words() against the symmetric interval, without one against the GUM's U
  std::string gum_width;      ///< width_words() against the symmetric interval
};

/// Those that exist, in the order of `parameters`, in the unit of the options.
std::vector<MethodRow> method_rows(const iso230_2::Assessment& assessment, AxisKind kind, const Options& options);

/// How far an expanded uncertainty is off another: "1.4× wider", "1.4× narrower", or "alike" within 5 %. Empty when
/// one of them is zero.
std::string width_words(double U, double half_width, const Options& options);

/// Whole sentences: which question the uncertainty answers. `runs`: approaches per direction. Says where the value
/// still holds effects that were not corrected, for which no uncertainty stands.
std::string measurand_statement(iso230_2::Measurand measurand, std::size_t runs, bool uncorrected);

/// Which of the methods is that of record, a sentence; empty where nothing was estimated.
std::string method_statement(const iso230_2::Assessment& assessment);

/// Whose u, mean and histogram stand beside an interval that holds for several hypotheses; empty where there is one.
/// Without full stop.
std::string hypothesis_statement(const iso230_2::Assessment& assessment);

/// "1 000 000 trials, as asked for" or how an adaptive run ended. Without full stop.
std::string trials_statement(const iso230_2::MonteCarlo& monte_carlo);

/// Why a run states no interval; empty where it states one. Without full stop.
std::string refusal_statement(const iso230_2::MonteCarlo& monte_carlo);

/// How the sampling of the approaches enters; empty for this_test.
std::string type_a_statement(const iso230_2::MonteCarlo& monte_carlo);

/// "Intervals widened to hold the measured value, …: R, R↑"; empty where there is none. Without full stop.
std::string outside_statement(std::span<const MethodRow> rows);

/// "uniform from −0.85 to 0.85", to five digits.
std::string shown_distribution(const uncertainty::Distribution& distribution, const Options& options);
/// The same of what Distribution::text() wrote; as it is where that cannot be read.
std::string shown_distribution(const std::string& text, const Options& options);

/// "95 %"
std::string shown_percent(double share, const Options& options);

/// Whole number with thin spaces: "1 000 000".
std::string shown_count(std::size_t count);

/// The method that contributions() are from.
iso230_2::UncertaintyMethod contributing_method(const iso230_2::Assessment& assessment);
/// What each input contributes, from the Monte Carlo method or, where that does not say, from the GUM's budget;
/// largest first for the first of main_parameters(). Inputs without effect on any parameter come last.
std::vector<iso230_2::Contribution> contributions(const iso230_2::Assessment& assessment);
std::vector<iso230_2::Contribution> gum_contributions(const iso230_2::GumUncertainty& gum);

/// Indices of A, E, M, R and B as far as they exist; with one direction of A, E and R of that.
std::vector<std::size_t> main_parameters(const iso230_2::AxisParameters& measured);

/// Part of the sum of the squares of all contributions to a parameter; 0 when they are all zero.
double share(std::span<const iso230_2::Contribution> all, std::size_t of, std::size_t parameter);

/// u of a parameter from the method that contributions() are from; 0 where there is none.
double standard_uncertainty(const iso230_2::Assessment& assessment, std::size_t parameter);

/// The input that it pays most to improve.
struct Leading {
  const iso230_2::Contribution* contribution = nullptr;  ///< contribution of the list that was given
  double share = 0.0;
  double u = 0.0;          ///< u of the parameter, native unit
  double u_without = 0.0;  ///< about what would remain without it: u √(1 − share)
};

/// Of `all`, which must be contributions() of the assessment or made of them. Nothing when nothing contributes.
std::optional<Leading> leading(std::span<const iso230_2::Contribution> all, std::size_t parameter,
                               const iso230_2::Assessment& assessment);

/// "Temperature of the machine, 82 % of the variance; without it u would fall from 7.2 to about 3.0 µm". No full stop.
std::string leading_statement(const Leading& leading, AxisKind kind, const Options& options);

}  // namespace axiometry::report
