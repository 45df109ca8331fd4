// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/conformity_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/method_values.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

namespace {

using iso230_2::Judgement;
using iso230_2::UncertaintyMethod;
using uncertainty::DecisionRule;
using uncertainty::Verdict;

std::string origin_of(UncertaintyMethod method) {
  switch (method) {
    case UncertaintyMethod::annex_a: return "u = U/2 by Annex A";
    case UncertaintyMethod::gum: return "u by the GUM";
    case UncertaintyMethod::monte_carlo: return "u by Monte Carlo";
  }
  return "";
}

/// ", for this test": what u is the uncertainty of, where the method asks.
std::string_view words_of(const std::optional<Measurand>& measurand) {
  if (!measurand) return "";
  return *measurand == Measurand::this_test ? ", for this test" : ", for this machine in the long run";
}

/// All rest on one method.
std::string origin_of(std::span<const Judgement> judgements) {
  const auto known = std::ranges::find_if(judgements, [](const Judgement& j) { return j.uncertainty.has_value(); });
  if (known == judgements.end()) return "no u is known, so that nothing is decided";
  return origin_of(known->uncertainty->method) + std::string(words_of(known->uncertainty->measurand));
}

bool any_probability(std::span<const Judgement> judgements) {
  return std::ranges::any_of(judgements,
                             [](const Judgement& j) { return j.decision.probability_conforming.has_value(); });
}

std::string_view distribution_of(std::span<const Judgement> judgements) {
  const bool by_trials = std::ranges::any_of(judgements, [](const Judgement& j) {
    return j.uncertainty && j.uncertainty->method == UncertaintyMethod::monte_carlo;
  });
  if (by_trials) return "from the Monte Carlo distributions";
  const bool by_t = std::ranges::any_of(
      judgements, [](const Judgement& j) { return j.uncertainty && j.uncertainty->degrees_of_freedom; });
  return by_t ? "from a normal distribution about the value, or from Student’s t where degrees of freedom are known"
              : "from a normal distribution about the value";
}

bool any_range(std::span<const Judgement> judgements) {
  return std::ranges::any_of(judgements, [](const Judgement& j) {
    return j.decision.probability_range && j.decision.probability_range->least < j.decision.probability_range->most;
  });
}

constexpr std::string_view formula_of(DecisionRule::Kind kind) {
  switch (kind) {
    case DecisionRule::Kind::simple:
      return "A parameter conforms when its magnitude does not exceed its tolerance T; its uncertainty is not taken "
             "into account";
    case DecisionRule::Kind::iso_14253_1:
      return "A parameter conforms when it keeps its tolerance T with a probability of 95 % or more, and does not "
             "conform "
             "when it exceeds T with 95 % or more; between the two it is undecided. T − g and T + g are the values, of "
             "the "
             "same uncertainty, where that changes";
    case DecisionRule::Kind::guard_band: break;
  }
  return "A parameter conforms up to T − g and does not conform above T + g; between the two it is undecided. g was "
         "chosen";
}

}  // namespace

std::string shown_probability(double probability, const Options& options) {
  const double percent = 100.0 * probability;
  constexpr double finest = 0.01;
  const auto shown = [&](double x, int decimals) { return format_fixed(x, decimals, options.numbers) + "\u00a0%"; };
  if (percent > 100.0 - finest) return "> " + shown(100.0 - finest, 2);
  if (percent < finest) return "< " + shown(finest, 2);
  int decimals = percent < 1.0 || percent > 99.0 ? 2 : 1;
  // What is not the probability that decides must not look like it.
  constexpr int most_decimals = 9;
  for (const double deciding :
       {100.0 * uncertainty::decision_probability, 100.0 * (1.0 - uncertainty::decision_probability)})
    while (decimals < most_decimals && percent != deciding &&
           std::abs(percent - deciding) < 0.5 * std::pow(10.0, -decimals))
      ++decimals;
  return shown(percent, decimals);
}

std::string shown_conformity(const uncertainty::Decision& decision, const Options& options) {
  if (!decision.probability_range) return "–";
  const std::string least = shown_probability(decision.probability_range->least, options);
  const std::string most = shown_probability(decision.probability_range->most, options);
  return least == most ? most : fmt::format("{} to {}", least, most);
}

int limit_decimals(const ShownParameter& shown) { return shown.decimals + 1; }

std::string rule_title(const DecisionRule& rule, AxisKind kind, const Options& options) {
  switch (rule.kind) {
    case DecisionRule::Kind::simple: return "simple acceptance";
    case DecisionRule::Kind::iso_14253_1: return "ISO 14253-1";
    case DecisionRule::Kind::guard_band: break;
  }
  const ParameterScale scale = parameter_scale(kind, options.unit);
  return fmt::format("guard band of {}\u00a0{}", shown_short(rule.guard_band * scale.per_native, options), scale.unit);
}

std::string record_statement(const iso230_2::Assessment& assessment, const Options& options) {
  const auto method = iso230_2::method_of_record(assessment);
  if (!method) return "";
  switch (*method) {
    case UncertaintyMethod::annex_a: return "± U with k = 2, Annex A (simplified method)";
    case UncertaintyMethod::gum: return "± U after the GUM, about 95 %";
    case UncertaintyMethod::monte_carlo: break;
  }
  if (assessment.monte_carlo && iso230_2::run_with_intervals(assessment) == nullptr)
    return "No interval is stated (Monte Carlo)";
  const double coverage = assessment.monte_carlo ? assessment.monte_carlo->coverage : 0.95;
  return fmt::format("from … to: interval of {}, Monte Carlo", shown_percent(coverage, options));
}

std::string rule_statement(std::span<const Judgement> judgements, AxisKind kind, const Options& options) {
  if (judgements.empty()) return "";
  const DecisionRule& rule = judgements.front().rule;
  const bool simple = rule.kind == DecisionRule::Kind::simple;
  std::string text = fmt::format("Decision rule: {}. {}", rule_title(rule, kind, options), formula_of(rule.kind));
  text += simple ? "." : fmt::format("; {}.", origin_of(judgements));
  if (any_probability(judgements))
    text += fmt::format(" p_c: probability of conformity (JCGM 106), {}{}.", distribution_of(judgements),
                        simple ? "; " + origin_of(judgements) : std::string());
  if (any_range(judgements))
    text += " Where p_c has two figures, it lies between them, whatever of what is held possible is true.";
  return text;
}

bool uncertainty_decides(std::span<const Judgement> judgements) {
  return std::ranges::any_of(judgements, [](const Judgement& j) {
    return j.rule.kind != DecisionRule::Kind::simple && j.uncertainty.has_value();
  });
}

std::string incomplete_statement(std::span<const Judgement> judgements, const iso230_2::Assessment& assessment) {
  const bool decides = uncertainty_decides(judgements);
  const auto found = std::ranges::find(assessment.findings, "uncertainty-stated", &iso230_2::Finding::id);
  if ((!decides && !any_probability(judgements)) || found == assessment.findings.end()) return "";
  return decides ? fmt::format("p_c and verdicts hold only as far as what lacks is negligible: {}.", found->message)
                 : fmt::format("p_c and risks hold only as far as what lacks is negligible: {}.", found->message);
}

/// What equipment out of calibration contributes is not known, and is in no uncertainty.
std::string uncalibrated_statement(std::span<const Judgement> judgements, const iso230_2::Assessment& assessment) {
  const bool decides = uncertainty_decides(judgements);
  const auto found = std::ranges::find(assessment.findings, "equipment-calibrated", &iso230_2::Finding::id);
  if ((!decides && !any_probability(judgements)) || found == assessment.findings.end()) return "";
  return decides
             ? fmt::format("p_c and verdicts hold only as far as the equipment measured as when it was calibrated: {}.",
                           found->message)
             : fmt::format("p_c and risks hold only as far as the equipment measured as when it was calibrated: {}.",
                           found->message);
}

std::string noise_statement(std::span<const Judgement> judgements, const iso230_2::Assessment& assessment) {
  const auto found = std::ranges::find(assessment.findings, "noise-beside-scatter", &iso230_2::Finding::id);
  if (found == assessment.findings.end()) return "";
  const iso230_2::AxisParameters& p = assessment.evaluation.parameters;
  // Without any scatter A is E, and R no less than B.
  const auto least = [&p](std::string_view key) -> double {
    const auto& of = key == "A" ? p.E : key == "A_up" ? p.E_up : key == "A_down" ? p.E_down : key == "R" ? p.B : p.A;
    return key.starts_with("R_") || !of ? 0.0 : std::abs(of->in_native());
  };
  std::vector<std::string_view> symbols;
  for (const Judgement& j : judgements) {
    const std::string_view key = j.tolerance.parameter->key;
    if (!(key.starts_with('A') || key.starts_with('R')) || !j.withheld.empty() || !j.magnitude) continue;
    const double limit = j.tolerance.limit.in_native();
    if (j.magnitude->in_native() > limit && least(key) <= limit) symbols.push_back(j.tolerance.parameter->symbol);
  }
  if (symbols.empty()) return "";
  const std::string all = fmt::format("{}", fmt::join(symbols, ", "));
  return symbols.size() == 1
             ? fmt::format(
                   "A limit that {} seems to exceed may be kept: noise of the readings makes A and R larger, by "
                   "more than the method of record sees.",
                   all)
             : fmt::format(
                   "Limits that {} seem to exceed may be kept: noise of the readings makes A and R larger, by "
                   "more than the method of record sees.",
                   all);
}

std::vector<std::string> withheld_statements(std::span<const Judgement> judgements) {
  std::vector<std::string> reasons;
  for (const Judgement& judgement : judgements)
    if (!judgement.withheld.empty() && std::ranges::find(reasons, judgement.withheld) == reasons.end())
      reasons.push_back(judgement.withheld);
  for (std::string& reason : reasons) {
    std::string symbols;
    for (const Judgement& judgement : judgements)
      if (judgement.withheld == reason)
        symbols += fmt::format("{}{}", symbols.empty() ? "" : ", ", judgement.tolerance.parameter->symbol);
    reason = fmt::format("{}: undecided, because {}.", symbols, reason);
  }
  return reasons;
}

RichText with_symbols(std::string_view statement) {
  constexpr std::string_view symbols = "TguU";
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  RichText text;
  std::size_t done = 0;
  for (std::size_t k = 0; k < statement.size(); ++k) {
    const bool alone =
        (k == 0 || !is_letter(statement[k - 1])) && (k + 1 == statement.size() || !is_letter(statement[k + 1]));
    if (!alone || symbols.find(statement[k]) == std::string_view::npos) continue;
    text = joined({text, prose(statement.substr(done, k - done)), italic(statement.substr(k, 1))});
    done = k + 1;
  }
  return joined({text, prose(statement.substr(done))});
}

RichText symbols_with(std::span<const Judgement> judgements, Verdict verdict) {
  RichText symbols;
  for (const Judgement& judgement : judgements)
    if (judgement.decision.verdict == verdict)
      symbols = joined({symbols, plain(symbols.empty() ? "" : ", "), symbol(judgement.tolerance.parameter->symbol)});
  return symbols;
}

Tone tone_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::conforms: return Tone::good;
    case Verdict::does_not_conform: return Tone::bad;
    case Verdict::undecided: return Tone::caution;
    case Verdict::not_applicable: return Tone::quiet;
  }
  return Tone::normal;
}

std::string_view source_title(iso230_2::ToleranceSource source) {
  switch (source) {
    case iso230_2::ToleranceSource::axis: return "limits of the axis";
    case iso230_2::ToleranceSource::table: return "tolerance table";
    case iso230_2::ToleranceSource::test: return "file of the test";
    case iso230_2::ToleranceSource::entered: return "entries made for this test";
    case iso230_2::ToleranceSource::user: return "command line";
  }
  return "";
}

}  // namespace axiometry::report
