// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/report/conformity_text.h"
#include "axiometry/report/figures/conformity.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

namespace {

using iso230_2::Judgement;
using uncertainty::Verdict;

constexpr std::size_t values_named = 3;  // on the first page; all of them stand in the table of decisions

/// Which columns of the table of decisions this subject needs.
struct Wanted {
  bool guard_band = false;
  bool uncertainty = false;
};

Wanted wanted(std::span<const Judgement> judgements) {
  return {judgements.front().rule.kind != uncertainty::DecisionRule::Kind::simple,
          std::ranges::any_of(judgements, [](const Judgement& j) { return j.uncertainty.has_value(); })};
}

std::vector<Column> columns(Wanted want) {
  std::vector<Column> all = {{plain("Symbol"), Align::start, true}, {plain("Value"), Align::decimal}};
  if (want.uncertainty) all.push_back({italic("u"), Align::decimal});
  all.push_back({joined({plain("Tolerance "), italic("T")}), Align::decimal});
  if (want.guard_band) {
    all.push_back({joined({italic("T"), plain(" − "), italic("g")}), Align::decimal});
    all.push_back({joined({italic("T"), plain(" + "), italic("g")}), Align::decimal});
  }
  if (want.uncertainty) {
    all.push_back({symbol("p_c"), Align::decimal});
    all.push_back({plain("Risk")});
  }
  all.push_back({plain("Verdict")});
  return all;
}

/// "2.3 % consumer’s": of a false acceptance, or "… producer’s": of a false rejection.
TableCell risk_cell(const uncertainty::Decision& decision, const Options& options) {
  if (decision.consumer_risk)
    return text_cell(fmt::format("{}\u00a0consumer’s", shown_probability(*decision.consumer_risk, options)));
  if (decision.producer_risk)
    return text_cell(fmt::format("{}\u00a0producer’s", shown_probability(*decision.producer_risk, options)));
  return quiet_cell("–");
}

/// Numbers of one row.
class RowNumbers {
 public:
  RowNumbers(const Subject& subject, const Options& options, const ShownParameter& shown)
      : options_(options),
        scale_(parameter_scale(subject.test.metadata.axis.kind, options.unit)),
        decimals_(limit_decimals(shown)) {}
  TableCell exact(Deviation x) const { return text_cell(shown_limit(x, scale_, options_)); }
  TableCell acceptance(const std::optional<Deviation>& x) const { return guarded(x, acceptance_limit_to); }
  TableCell rejection(const std::optional<Deviation>& x) const { return guarded(x, rejection_limit_to); }

 private:
  TableCell guarded(const std::optional<Deviation>& x, double (*printed)(double, int)) const {
    if (!x) return quiet_cell("–");
    return text_cell(format_fixed(printed(x->in_native() * scale_.per_native, decimals_), decimals_, options_.numbers));
  }

  const Options& options_;
  ParameterScale scale_;
  int decimals_;
};

std::vector<TableCell> decision_row(const Judgement& judgement, const Subject& subject, Wanted want,
                                    const Options& options) {
  const auto& [tolerance, rule, magnitude, known, decision, withheld, remedy] = judgement;
  const AxisKind kind = subject.test.metadata.axis.kind;
  const ShownParameter shown = show(judgement, subject.assessment, kind, options);
  const RowNumbers numbers(subject, options, shown);
  std::vector<TableCell> row = {{symbol(tolerance.parameter->symbol)}};
  row.push_back(magnitude ? TableCell{strong(shown.value)} : quiet_cell("–"));
  if (want.uncertainty)
    row.push_back(known ? text_cell(shown_uncertainty(known->u, parameter_scale(kind, options.unit), options))
                        : quiet_cell("–"));
  row.push_back(numbers.exact(tolerance.limit));
  if (want.guard_band) {
    const bool none = magnitude && judgement.has_guard_band() && !judgement.acceptance_limit();
    row.push_back(none ? quiet_cell("none")
                       : numbers.acceptance(magnitude ? judgement.acceptance_limit() : std::nullopt));
    row.push_back(numbers.rejection(magnitude ? judgement.rejection_limit() : std::nullopt));
  }
  if (want.uncertainty) {
    row.push_back(decision.probability_range ? text_cell(shown_conformity(decision, options)) : quiet_cell("–"));
    row.push_back(risk_cell(decision, options));
  }
  row.push_back(verdict_cell(decision.verdict));
  return row;
}

/// "Grinder, up to 500 mm, in limits.csv, …": the names are the user's, what stands between is not.
RichText origin_words(std::string_view origin) {
  const std::size_t in = origin.rfind(", in ");
  const std::size_t travel = in == std::string_view::npos || in == 0 ? in : origin.rfind(", ", in - 1);
  if (in == std::string_view::npos || travel == std::string_view::npos) return verbatim(origin);
  const std::size_t file = in + std::string_view(", in ").size();
  return joined(
      {verbatim(origin.substr(0, travel)), plain(origin.substr(travel, file - travel)), verbatim(origin.substr(file))});
}

/// "Limits: A, E from the tolerance table Grinder, …; B from the limits of the axis as of 2026-11-26."
RichText origins_of_limits(std::span<const Judgement> judgements) {
  using enum iso230_2::ToleranceSource;
  RichText text;
  for (const auto source : {axis, table, test, entered, user}) {
    RichText symbols;
    std::string_view origin;
    for (const Judgement& judgement : judgements) {
      if (judgement.tolerance.source != source) continue;
      symbols = joined({symbols, plain(symbols.empty() ? "" : ", "), symbol(judgement.tolerance.parameter->symbol)});
      origin = judgement.tolerance.origin;
    }
    if (symbols.empty()) continue;
    text = joined({text, plain(text.empty() ? "Limits: " : "; "), symbols,
                   plain(fmt::format(" from the {}{}", source_title(source),
                                     origin.empty()   ? ""
                                     : source == axis ? " as of "
                                                      : " ")),
                   origin_words(origin)});
  }
  return joined({text, plain(".")});
}

/// "A = (9.6 ± 4.3) µm (Annex A); tolerance 10 µm", "A = 9.6 µm, 8.0 to 12.3 µm (Monte Carlo); tolerance 10 µm"
RichText value_and_tolerance(const Judgement& judgement, const Subject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  const ShownParameter shown = show(judgement, subject.assessment, kind, options);
  const std::string unit = (shown.unit == "″" || shown.unit == "°" ? "" : "\u00a0") + std::string(shown.unit);
  std::string value = shown.value + unit;
  if (!shown.U.empty()) value = fmt::format("({} ± {}){}", shown.value, shown.U, unit);
  if (!shown.interval.empty()) value += fmt::format(", {}{}", shown.interval, unit);
  const std::string method =
      judgement.uncertainty ? fmt::format(" ({})", iso230_2::method_title(judgement.uncertainty->method)) : "";
  const std::string limit = shown_limit(judgement.tolerance.limit, parameter_scale(kind, options.unit), options);
  return joined({symbol(judgement.tolerance.parameter->symbol),
                 plain(fmt::format(" = {}{}; tolerance {}{}", value, method, limit, unit))});
}

/// Of the parameters with the verdict of the whole, so that it can be weighed at a glance.
void append_values(Notice& notice, Verdict overall, const Subject& subject, const Options& options) {
  const auto decisive = [&](const Judgement& j) { return j.magnitude && j.decision.verdict == overall; };
  const auto all = static_cast<std::size_t>(std::ranges::count_if(subject.judgements, decisive));
  std::size_t named = 0;
  for (const Judgement& judgement : subject.judgements) {
    if (!decisive(judgement)) continue;
    if (named == values_named && all > values_named + 1) {
      notice.lines.push_back(plain(fmt::format("… and {} more.", all - named)));
      return;
    }
    notice.lines.push_back(value_and_tolerance(judgement, subject, options));
    ++named;
  }
}

std::vector<RichText> notes(const Subject& subject, Wanted want, const Options& options) {
  std::vector<RichText> notes = {
      with_symbols(rule_statement(subject.judgements, subject.test.metadata.axis.kind, options))};
  notes.push_back(origins_of_limits(subject.judgements));
  for (const std::string& withheld : withheld_statements(subject.judgements)) notes.push_back(plain(withheld));
  if (const std::string lacks = incomplete_statement(subject.judgements, subject.assessment); !lacks.empty())
    notes.push_back(with_symbols(lacks));
  if (const std::string late = uncalibrated_statement(subject.judgements, subject.assessment); !late.empty())
    notes.push_back(with_symbols(late));
  if (const std::string noise = noise_statement(subject.judgements, subject.assessment); !noise.empty())
    notes.push_back(plain(noise));
  if (want.guard_band && std::ranges::any_of(subject.judgements, [](const Judgement& j) {
        return j.magnitude && j.has_guard_band() && !j.acceptance_limit();
      }))
    notes.push_back(with_symbols("none: g is larger than T, so that no value could be accepted."));
  if (want.uncertainty)
    notes.push_back(
        plain("Risk of the verdict, at most: the consumer’s, that an accepted parameter does not conform; the "
              "producer’s, that "
              "a rejected one does."));
  if (std::ranges::any_of(subject.judgements, [](const Judgement& j) { return !j.magnitude; }))
    notes.push_back(plain("no verdict: the parameter does not exist in this test."));
  return notes;
}

}  // namespace

TableCell verdict_cell(Verdict verdict) {
  if (verdict == Verdict::not_applicable) return quiet_cell("no verdict");
  return {strong(uncertainty::verdict_name(verdict)), tone_of(verdict)};
}

std::optional<Notice> tolerance_notice(const Subject& subject, const Options& options) {
  const auto overall = iso230_2::overall_verdict(subject.judgements);
  if (!overall) return std::nullopt;
  constexpr std::pair<Verdict, std::string_view> words[] = {{Verdict::does_not_conform, "Does not conform: "},
                                                            {Verdict::undecided, "Undecided: "},
                                                            {Verdict::conforms, "Conforms: "}};
  Notice notice{tone_of(*overall), {}, {}};
  if (*overall == Verdict::not_applicable) notice = {Tone::caution, plain("No verdict"), {}};
  RichText others;
  for (const auto& [verdict, word] : words) {
    const RichText symbols = symbols_with(subject.judgements, verdict);
    if (symbols.empty()) continue;
    if (verdict == *overall) {
      notice.heading = joined({plain(word), symbols});
    } else {
      others = joined({others, plain(others.empty() ? "" : " "), plain(word), symbols, plain(".")});
    }
  }
  if (const RichText unjudged = symbols_with(subject.judgements, Verdict::not_applicable); !unjudged.empty())
    others = joined({others, plain(others.empty() ? "No verdict on " : " No verdict on "), unjudged,
                     plain(": not applicable to this test.")});
  append_values(notice, *overall, subject, options);
  for (const std::string& withheld : withheld_statements(subject.judgements)) notice.lines.push_back(plain(withheld));
  if (!others.empty()) notice.lines.push_back(std::move(others));
  notice.lines.push_back(plain(fmt::format(
      "Decision rule: {}.", rule_title(subject.judgements.front().rule, subject.test.metadata.axis.kind, options))));
  return notice;
}

Section conformity_section(const Subject& subject, const Options& options) {
  Section section{"conformity", "Conformity to tolerances", true, {}};
  if (subject.judgements.empty()) return section;
  const Wanted want = wanted(subject.judgements);
  Table table;
  table.caption = plain(fmt::format("Decisions; values, uncertainties and limits in {}",
                                    parameter_scale(subject.test.metadata.axis.kind, options.unit).unit));
  table.columns = columns(want);
  for (const Judgement& judgement : subject.judgements)
    table.rows.push_back(decision_row(judgement, subject, want, options));
  table.notes = notes(subject, want, options);
  section.blocks.emplace_back(std::move(table));
  if (auto figure = conformity_figure(subject, options)) section.blocks.emplace_back(*std::move(figure));
  return section;
}

}  // namespace axiometry::report
