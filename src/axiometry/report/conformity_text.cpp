// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/conformity_text.h"

#include <fmt/format.h>

#include <algorithm>

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

/// "A, R↑"
std::string symbols_of(std::span<const Judgement> judgements, std::optional<UncertaintyMethod> method) {
  std::string symbols;
  for (const Judgement& j : judgements) {
    const auto own = j.uncertainty ? std::optional(j.uncertainty->method) : std::nullopt;
    if (!j.magnitude || own != method) continue;
    symbols.append(symbols.empty() ? "" : ", ").append(j.tolerance.parameter->symbol);
  }
  return symbols;
}

/// ", for this test": what u is the uncertainty of, where the methods ask.
std::string measurand_of(std::span<const Judgement> judgements) {
  for (const Judgement& j : judgements)
    if (j.uncertainty && j.uncertainty->measurand)
      return *j.uncertainty->measurand == Measurand::this_test ? ", for this test"
                                                               : ", for this machine in the long run";
  return "";
}

/// "u = U/2 by Annex A", or of which parameters it is what where they differ.
std::string origins(std::span<const Judgement> judgements) {
  std::string all;
  const std::size_t judged = static_cast<std::size_t>(
      std::ranges::count_if(judgements, [](const Judgement& j) { return j.magnitude.has_value(); }));
  const auto add = [&](std::string_view what, std::optional<UncertaintyMethod> method) {
    const std::size_t count = static_cast<std::size_t>(std::ranges::count_if(judgements, [&](const Judgement& j) {
      return j.magnitude && (j.uncertainty ? std::optional(j.uncertainty->method) : std::nullopt) == method;
    }));
    if (count == 0) return;
    all += all.empty() ? "" : "; ";
    all += count == judged ? std::string(what) : fmt::format("{} ({})", what, symbols_of(judgements, method));
  };
  for (UncertaintyMethod method : {UncertaintyMethod::annex_a, UncertaintyMethod::gum, UncertaintyMethod::monte_carlo})
    add(origin_of(method) + (method == UncertaintyMethod::annex_a ? "" : measurand_of(judgements)), method);
  add("no u is known", std::nullopt);
  return all;
}

bool any_probability(std::span<const Judgement> judgements) {
  return std::ranges::any_of(judgements,
                             [](const Judgement& j) { return j.decision.probability_conforming.has_value(); });
}

/// Where the probabilities come from, by what the uncertainties come from.
std::string_view distributions(std::span<const Judgement> judgements) {
  const auto by_trials = std::ranges::count_if(judgements, [](const Judgement& j) {
    return j.uncertainty && j.uncertainty->method == UncertaintyMethod::monte_carlo;
  });
  const auto known = std::ranges::count_if(judgements, [](const Judgement& j) { return j.uncertainty.has_value(); });
  if (by_trials == 0) return "from a normal distribution about the value";
  return by_trials == known ? "from the Monte Carlo distribution"
                            : "from the Monte Carlo distribution where there is one, else a normal one";
}

/// Those whose verdict and probability point to different sides. A normal distribution about the value cannot do that;
/// a Monte Carlo one can, where noise has raised the measured value above all that the parameter may be.
std::string contradicted(std::span<const Judgement> judgements) {
  std::string symbols;
  for (const Judgement& j : judgements) {
    const double p = j.decision.probability_conforming.value_or(0.5);
    const bool conforms = j.decision.verdict == Verdict::conforms;
    const bool rejected = j.decision.verdict == Verdict::does_not_conform;
    if ((conforms && p < 0.5) || (rejected && p > 0.5))
      symbols.append(symbols.empty() ? "" : ", ").append(j.tolerance.parameter->symbol);
  }
  return symbols;
}

}  // namespace

std::string shown_probability(double probability, const Options& options) {
  const double percent = 100.0 * probability;
  constexpr double finest = 0.01;
  const auto shown = [&](double x, int decimals) { return format_fixed(x, decimals, options.numbers) + "\u00a0%"; };
  if (percent > 100.0 - finest) return "> " + shown(100.0 - finest, 2);
  if (percent < finest) return "< " + shown(finest, 2);
  return shown(percent, percent < 1.0 || percent > 99.0 ? 2 : 1);
}

ShownParameter show_judged(const Judgement& judgement, const iso230_2::Assessment& assessment, AxisKind kind,
                           const Options& options) {
  const iso230_2::ParameterInfo& parameter = *judgement.tolerance.parameter;
  ShownParameter shown = show(parameter, assessment, kind, options);
  if (!judgement.magnitude || !judgement.uncertainty) return shown;
  constexpr double coverage_factor = 2.0;
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const double U = coverage_factor * judgement.uncertainty->u.in_native() * scale.per_native;
  if (U == 0.0) return {shown.value, "0", shown.unit};
  const int decimals = decimals_for(U, options.uncertainty_digits);
  const double value = (assessment.evaluation.parameters.*parameter.member)->in_native() * scale.per_native;
  return {format_fixed(value, decimals, options.numbers), format_fixed(U, decimals, options.numbers), shown.unit};
}

int limit_decimals(const ShownParameter& shown) {
  const std::size_t fraction = fraction_length(shown.value);  // with the mark, and so one more than its decimals
  return fraction > 0 ? static_cast<int>(fraction) : 1;
}

std::string rule_title(const DecisionRule& rule, AxisKind kind, const Options& options) {
  switch (rule.kind) {
    case DecisionRule::Kind::simple: return "simple acceptance";
    case DecisionRule::Kind::iso_14253_1: return "ISO 14253-1";
    case DecisionRule::Kind::guard_band: break;
  }
  const ParameterScale scale = parameter_scale(kind, options.unit);
  return fmt::format("guard band of {}\u00a0{}", shown_short(rule.guard_band * scale.per_native, options), scale.unit);
}

std::string rule_statement(std::span<const Judgement> judgements, AxisKind kind, const Options& options) {
  if (judgements.empty()) return "";
  const DecisionRule& rule = judgements.front().rule;
  const bool simple = rule.kind == DecisionRule::Kind::simple;
  std::string text = fmt::format("Decision rule: {}. ", rule_title(rule, kind, options));
  text += simple
              ? "A parameter conforms when its magnitude does not exceed its tolerance T; its uncertainty is not "
                "taken into account."
              : "A parameter conforms up to T − g and does not conform above T + g; between the two it is undecided.";
  if (rule.kind == DecisionRule::Kind::iso_14253_1) text += " g = 1.65 u";
  if (rule.kind == DecisionRule::Kind::guard_band) text += " g was chosen";
  if (!simple) text += fmt::format("; {}.", origins(judgements));
  if (any_probability(judgements))
    text += fmt::format(" p_c: probability of conformity (JCGM 106), {}{}.", distributions(judgements),
                        simple ? "; " + origins(judgements) : std::string());
  if (const std::string symbols = contradicted(judgements); !symbols.empty())
    text += fmt::format(
        " {}: the verdict rests on the measured value, p_c on what remains of it without the bias that "
        "noise has added; here they disagree.",
        symbols);
  return text;
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
