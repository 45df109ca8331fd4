// SPDX-License-Identifier: Apache-2.0
#include "cli/text/summary.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/counted.h"
#include "axiometry/report/claim_text.h"
#include "axiometry/report/conformity_text.h"
#include "axiometry/report/correction_text.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/finding_text.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/iso230_2/information.h"
#include "axiometry/standards/readings/runs_made.h"
#include "axiometry/standards/test_standard.h"
#include "cli/text/claims_text.h"
#include "cli/text/findings_text.h"
#include "cli/text/flags_of_words.h"
#include "cli/text/title_text.h"

namespace axiometry::cli {
namespace {

using iso230_2::Severity;
using uncertainty::Verdict;

constexpr std::size_t symbol_width = 4;
constexpr std::size_t title_width = 45;  // so that a line with a verdict fits 80 columns
constexpr std::size_t line_value_width = 9;

std::string approaches(const Series& series) {
  const std::size_t up = runs_made(series, Direction::up);
  const std::size_t down = runs_made(series, Direction::down);
  if (up > 0 && down > 0 && up != down) return fmt::format("{} ↑ and {} ↓", counted(up, "run"), down);
  return fmt::format("{} {}", counted(std::max(up, down), "run"),
                     up == down ? "in both directions"
                     : up > 0   ? "↑ only"
                                : "↓ only");
}

std::string heading(const app::Evaluated& e, const report::Options& options, const Terminal& terminal) {
  const Metadata& m = e.test.metadata;
  const Series& series = e.test.series;
  const auto target = [&](Position p) { return format_fixed(p.in_native(), 3, options.numbers); };
  std::string text =
      fmt::format("{}  {}\n", terminal.bold(report::printable(title_text(m.axis, m.machine.name, options))),
                  report::translated(axis_kind_name(m.axis.kind), options));
  text += report::translated(fmt::format("{} from {} to {}{}, {}", counted(series.target_count(), "target"),
                                         target(series.targets().front()), target(series.targets().back()),
                                         m.axis.kind == AxisKind::linear ? " mm" : "°", approaches(series)),
                             options) +
          "\n";
  const Provenance& p = e.test.provenance;
  text += terminal.faint(fmt::format(
      "{} ({}{})", p.file == "-" ? report::translated("standard input", options) : report::printable(p.file), p.format,
      p.sha256.empty() ? "" : ", SHA-256 " + p.sha256.substr(0, 12) + "…"));
  if (const std::string corrected = report::correction_statement(p.corrections); !corrected.empty())
    text += "\n" + wrapped(report::translated(corrected, options), terminal.width(), 0);
  return text + "\n\n";
}

bool exists(const app::Evaluated& e, const iso230_2::ParameterInfo& parameter) {
  return (e.assessment.evaluation.parameters.*parameter.member).has_value();
}

/// A parameter that has a limit, which stands below the table, so that the value tells on which side of it it lies.
report::ShownParameter shown_with_limit(const iso230_2::ParameterInfo& parameter, const app::Evaluated& e,
                                        const report::Options& options) {
  const AxisKind kind = e.test.metadata.axis.kind;
  for (const auto& judgement : e.judgements)
    if (judgement.tolerance.parameter->key == parameter.key)
      return report::show(judgement, e.assessment, kind, options);
  return report::show(parameter, e.assessment, kind, options);
}

std::string parameter_table(const app::Evaluated& e, const report::Options& options, const Terminal& terminal) {
  std::size_t value_width = 0;
  std::size_t uncertainty_width = 0;
  for (const auto& parameter : iso230_2::parameters) {
    const auto shown = shown_with_limit(parameter, e, options);
    if (exists(e, parameter)) value_width = std::max(value_width, display_width(shown.value));
    uncertainty_width = std::max(
        {uncertainty_width, display_width(shown.U), display_width(report::translated(shown.interval, options))});
  }
  std::size_t titles = title_width;
  for (const auto& parameter : iso230_2::parameters)
    titles = std::max(titles, display_width(report::translated(parameter.title, options)) + 2);
  std::string text;
  for (const auto& parameter : iso230_2::parameters) {
    const auto shown = shown_with_limit(parameter, e, options);
    const bool of_interval = !shown.interval.empty();
    const std::string uncertainty =
        (of_interval       ? ", "
         : shown.U.empty() ? "   "
                           : " ± ") +
        right(of_interval ? report::translated(shown.interval, options) : shown.U, uncertainty_width);
    text += terminal.bold(left(parameter.symbol, symbol_width)) +
            left(report::translated(parameter.title, options), titles);
    text += exists(e, parameter)
                ? right(shown.value, value_width) + (uncertainty_width > 0 ? uncertainty : "") + " " + shown.unit
                : terminal.faint(report::translated("not applicable", options));
    text += '\n';
  }
  if (const auto footnote = report::record_statement(e.assessment, options); !footnote.empty())
    text += terminal.faint(report::translated(footnote, options)) + "\n";
  return text + "\n";
}

std::string verdict_text(Verdict verdict, const report::Options& options, const Terminal& terminal) {
  const std::string name = report::translated(uncertainty::verdict_name(verdict), options);
  switch (verdict) {
    case Verdict::conforms: return terminal.green(name);
    case Verdict::does_not_conform: return terminal.red(name);
    case Verdict::undecided: return terminal.yellow(name);
    case Verdict::not_applicable: return terminal.faint(report::translated("no verdict: does not exist here", options));
  }
  return {};
}

/// Columns of the table of tolerances; a width of 0 leaves one out.
struct ToleranceWidths {
  std::size_t number = 9;
  std::size_t guarded = 0;  ///< where acceptance and rejection limit differ from the limit
  std::size_t probability = 0;
};

std::string tolerance_row(const iso230_2::Judgement& judgement, const app::Evaluated& e, const report::Options& options,
                          const ToleranceWidths& widths, const Terminal& terminal) {
  const AxisKind kind = e.test.metadata.axis.kind;
  const report::ParameterScale scale = report::parameter_scale(kind, options.unit);
  const int decimals = report::limit_decimals(report::show(judgement, e.assessment, kind, options));
  const auto number = [&](const std::optional<Deviation>& x, double (*printed)(double, int)) {
    return x ? format_fixed(printed(x->in_native() * scale.per_native, decimals), decimals, options.numbers)
             : std::string("–");
  };
  const auto& [tolerance, rule, magnitude, known, decision, withheld, remedy] = judgement;
  std::string text = terminal.bold(left(tolerance.parameter->symbol, symbol_width));
  text += right(report::shown_limit(tolerance.limit, scale, options), widths.number);
  if (widths.guarded > 0)
    text += right(number(magnitude ? judgement.acceptance_limit() : std::nullopt, report::acceptance_limit_to),
                  widths.guarded) +
            right(number(magnitude ? judgement.rejection_limit() : std::nullopt, report::rejection_limit_to),
                  widths.guarded);
  if (widths.probability > 0)
    text += right(report::translated(report::shown_conformity(decision, options), options), widths.probability);
  return text + "  " + verdict_text(decision.verdict, options, terminal) + "\n";
}

std::string tolerance_table(const app::Evaluated& e, const report::Options& options, const Terminal& terminal) {
  if (e.judgements.empty()) return "";
  const report::ParameterScale scale = report::parameter_scale(e.test.metadata.axis.kind, options.unit);
  ToleranceWidths widths;
  const auto& rule = e.judgements.front().rule;
  if (rule.kind != uncertainty::DecisionRule::Kind::simple) widths.guarded = 11;
  for (const auto& judgement : e.judgements)
    if (judgement.decision.probability_range)
      widths.probability = std::max(
          {widths.probability, std::size_t{10},
           display_width(report::translated(report::shown_conformity(judgement.decision, options), options)) + 2});
  const std::string limit = fmt::format("{}/{}", report::translated("limit", options), scale.unit);
  const std::string accept = report::translated("accept", options) + " ≤",
                    reject = report::translated("reject", options) + " >";
  widths.number = std::max(widths.number, display_width(limit) + 1);
  if (widths.guarded > 0)
    widths.guarded = std::max({widths.guarded, display_width(accept) + 2, display_width(reject) + 2});
  std::string text = left("", symbol_width) + right(limit, widths.number);
  if (widths.guarded > 0) text += right(accept, widths.guarded) + right(reject, widths.guarded);
  if (widths.probability > 0) text += right("p_c", widths.probability);
  text = terminal.faint(text + "  " + report::translated("verdict", options)) + "\n";
  for (const auto& judgement : e.judgements) text += tolerance_row(judgement, e, options, widths, terminal);
  text += terminal.faint(wrapped(
              report::translated(report::rule_statement(e.judgements, e.test.metadata.axis.kind, options), options),
              terminal.width(), 0)) +
          "\n";
  if (const std::string lacks = report::incomplete_statement(e.judgements, e.assessment); !lacks.empty())
    text += terminal.yellow(wrapped(report::translated(lacks, options), terminal.width(), 0)) + "\n";
  if (const std::string late = report::uncalibrated_statement(e.judgements, e.assessment); !late.empty())
    text += terminal.yellow(wrapped(report::translated(late, options), terminal.width(), 0)) + "\n";
  if (const std::string noise = report::noise_statement(e.judgements, e.assessment); !noise.empty())
    text += terminal.yellow(wrapped(report::translated(noise, options), terminal.width(), 0)) + "\n";
  for (const std::string& withheld : report::withheld_statements(e.judgements))
    text += terminal.yellow(wrapped(with_flags(report::translated(withheld, options), withheld), terminal.width(), 0)) +
            "\n";
  if (e.tolerance_band)
    text += terminal.faint(
                wrapped(fmt::format("{}{}{}, {}, {} {}", report::translated("Tolerance table", options),
                                    report::colon(options), report::printable(e.tolerance_band->name),
                                    report::translated(e.tolerance_band->travel, options),
                                    report::translated("from", options), report::printable(e.tolerance_band->file)),
                        terminal.width(), 0)) +
            "\n";
  return text + "\n";
}

/// "A, R↑", of those with this verdict.
std::string symbols_with(const app::Evaluated& e, Verdict verdict) {
  std::string symbols;
  for (const auto& judgement : e.judgements)
    if (judgement.decision.verdict == verdict)
      symbols += fmt::format("{}{}", symbols.empty() ? "" : ", ", judgement.tolerance.parameter->symbol);
  return symbols;
}

std::string smaller_repeatability_text(const app::Evaluated& e, const report::Options& options,
                                       const Terminal& terminal) {
  const auto smaller = iso230_2::smaller_repeatability(e.test.metadata, e.assessment.evaluation.parameters);
  if (!smaller) return "";
  const auto shown = shown_with_limit(*smaller->parameter, e, options);
  const std::string text =
      fmt::format("min(R↑, R↓) = {} {} ({}): {}", shown.value, shown.unit, smaller->parameter->symbol,
                  report::translated(std::string(iso230_2::smaller_repeatability_remark), options));
  return terminal.faint(wrapped(text, terminal.width(), 0)) + "\n\n";
}

std::string conclusion(const app::Evaluated& e, const iso230_2::Claims& claims, const report::Options& options,
                       const Terminal& terminal) {
  const auto said = [&](const std::string& english) { return report::translated(english, options); };
  const iso230_2::Claim& tested = claim(claims, iso230_2::ClaimKind::tested);
  const std::string standing = said(report::standing_text(claims, e.test.metadata.axis) + ".");
  std::string text = tested.holds()                    ? terminal.green(standing)
                     : report::is_contradicted(tested) ? terminal.red(standing)
                                                       : terminal.yellow(standing);
  if (!e.assessment.label.empty()) text += " " + terminal.bold(said(e.assessment.label + "."));
  if (const std::string worst = symbols_with(e, Verdict::does_not_conform); !worst.empty())
    text += " " + terminal.red(said(fmt::format("Does not conform: {}.", worst)));
  if (const std::string open = symbols_with(e, Verdict::undecided); !open.empty())
    text += " " + terminal.yellow(said(fmt::format("Undecided: {}.", open)));
  if (const std::string good = symbols_with(e, Verdict::conforms); !good.empty())
    text += " " + terminal.green(said(fmt::format("Conforms: {}.", good)));
  text += "\n";
  if (e.verified)
    text += terminal.faint(wrapped(said("verified: " + report::verified_statement(*e.verified)), terminal.width(), 0)) +
            "\n";
  return text;
}

/// Who asks for the uncertainty in full is told when there is none.
std::string uncertainty_text(const app::Evaluated& e, const report::Options& options, const Terminal& terminal,
                             Detail detail) {
  const std::string text = method_tables(e, options, terminal, detail);
  if (detail != Detail::full) return text;
  const std::string resolved = resolved_inputs_text(e, options, terminal);
  if (!text.empty()) return text + resolved;
  return resolved +
         wrapped(report::translated(
                     "No input of the uncertainty was given, so that nothing is known about it. Give what is known in "
                     "the file "
                     "or by flags such as --environmental-variation (all: 'axiometry uncertainty --help'); --measurand "
                     "this-machine needs none.",
                     options),
                 terminal.width(), 0) +
         "\n\n";
}

}  // namespace

std::string summary(const app::Evaluated& e, const report::Options& options, const Terminal& terminal, Detail detail) {
  const AxisKind kind = e.test.metadata.axis.kind;
  const iso230_2::Claims claims = iso230_2::claims_of(e.test, e.assessment);
  return heading(e, options, terminal) + parameter_table(e, options, terminal) + tolerance_table(e, options, terminal) +
         uncertainty_text(e, options, terminal, detail) +
         findings_text(report::shown_findings(e.assessment.findings, e.assessment, kind, options), options, terminal) +
         smaller_repeatability_text(e, options, terminal) + claims_text(e, claims, options, terminal) +
         conclusion(e, claims, options, terminal);
}

namespace {

/// "does not conform: A, R↑", what the verdict rests on.
std::string line_verdict(const app::Evaluated& e, Verdict verdict, const report::Options& options,
                         const Terminal& terminal) {
  const std::string text = fmt::format("{}{}{}", report::translated(uncertainty::verdict_name(verdict), options),
                                       report::colon(options), symbols_with(e, verdict));
  if (verdict == Verdict::conforms) return terminal.green(text);
  return verdict == Verdict::does_not_conform ? terminal.red(text) : terminal.yellow(text);
}

constexpr std::string_view line_parameters[] = {"A", "E", "M", "R", "B"};

/// Approached from one direction alone an axis has no A, E and R, but those of that direction, which carry its arrow.
std::string line_value(std::string_view key, const app::Evaluated& e, const report::Options& options) {
  const auto value = [&](const iso230_2::ParameterInfo& parameter) {
    return shown_with_limit(parameter, e, options).value;
  };
  const iso230_2::ParameterInfo& both = *iso230_2::find_parameter(key);
  if (exists(e, both)) return value(both);
  const bool up = e.test.series.has(Direction::up);
  if (up == e.test.series.has(Direction::down)) return "–";
  const auto one = iso230_2::find_parameter(fmt::format("{}_{}", key, up ? "up" : "down"));
  return one && exists(e, *one) ? value(*one) + (up ? "↑" : "↓") : "–";
}

}  // namespace

std::string line_header(const report::Options& options, const Terminal& terminal) {
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  std::string text;
  for (std::string_view key : line_parameters) text += right(key, line_value_width);
  return terminal.bold(text + "  " + left(said("unit"), 6) + left(said("axis"), 6) + left("ISO", 5) + said("test")) +
         "\n";
}

std::string line(const app::Evaluated& e, const report::Options& options, const Terminal& terminal) {
  std::string text;
  for (std::string_view key : line_parameters) text += right(line_value(key, e, options), line_value_width);
  const std::string unit = shown_with_limit(*iso230_2::find_parameter("B"), e, options).unit;
  const std::string axis = report::printable(e.test.metadata.axis.name);
  text += "  " + left(unit, 6) + left(axis.empty() ? "–" : axis, 6);
  const iso230_2::Claims claims = iso230_2::claims_of(e.test, e.assessment);
  const iso230_2::Claim& tested = claim(claims, iso230_2::ClaimKind::tested);
  const std::string answer = left(report::translated(tested.holds() ? "yes" : "no", options), 5);
  text += tested.holds()                    ? terminal.green(answer)
          : report::is_contradicted(tested) ? terminal.red(answer)
                                            : terminal.yellow(answer);
  text += report::printable(e.test.provenance.file + (e.name.empty() ? "" : ":" + e.name));
  if (!e.assessment.label.empty()) text += "  (" + report::translated(e.assessment.label, options) + ")";
  if (const auto verdict = iso230_2::overall_verdict(e.judgements))
    text += "  " + line_verdict(e, *verdict, options, terminal);
  return text + "\n";
}

}  // namespace axiometry::cli
