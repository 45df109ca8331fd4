// SPDX-License-Identifier: Apache-2.0
// Parameters and positions as one tidy table for spreadsheets and scripts: RFC 4180, UTF-8, CRLF, one value per line.
//
//   axis         name of the axis, as given
//   record       "parameter", "position", and where they were run "gum" and "monte_carlo": parameters by that method,
//                of "gum" also the means of each target with their U;
//                "claim"; of an issued report "trail": where the audit trail of the archive ended before its issue
//   target       of a position: its coordinate; empty for parameters
//   target_unit  "mm" or "deg"
//   name         key of the JSON output: "A_up"; of a position "mean_up", "n_up", …; of "monte_carlo" with what it is:
//                "A_up.mean", ".u", ".bias", ".low", ".high" (the interval that is stated), ".shortest_low",
//                ".shortest_high"
//   value        empty where it does not exist
//   U            expanded uncertainty, of "parameter" after Annex A, k = 2; empty where none was estimated
//   unit         "um", "mm", "nm", "arcsec", "deg"; empty for counts
//   clause       of ISO 230-2:2014
//   remark       what the result must not be mistaken for: not tested after the standard, that it is a diagonal
//                after ISO 230-6, the label, which corrections of the readings it contains; else empty
//   limit        of a parameter with a tolerance, in `unit`; else empty
//   verdict      "conforms", "does not conform", "undecided" or "not applicable"; empty without a limit
//   low, high    ends of the interval of record, in `unit`; empty where none was estimated
//   method       "annex_a", "gum" or "monte_carlo": whose U and interval these are
//   symbol       of a parameter, with the axis (8.2.4): "E_XX,A↑"; empty where the axis has none
//
// Numbers in full double precision. Parameters are in the display unit, positions in µm or ″. With a
// decimal comma the columns are separated by semicolons.
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/base/text/text.h"
#include "axiometry/report/claim_text.h"
#include "axiometry/report/correction_text.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/writer.h"
#include "axiometry/standards/iso230_2/error_symbol.h"
#include "axiometry/standards/test_standard.h"

namespace axiometry::report {

namespace csv {
namespace {

struct Line {
  std::string_view record;
  std::string target;
  std::string_view name;
  std::string value;
  std::string U;
  std::string_view unit;
  std::string_view clause;
  std::string limit{};
  std::string_view verdict{};
  std::string low{};
  std::string high{};
  std::string_view method{};
  std::string symbol{};
};

std::string_view ascii_unit(std::string_view unit) {
  if (unit == "µm") return "um";
  if (unit == "″") return "arcsec";
  if (unit == "°") return "deg";
  return unit;
}

class Csv {
 public:
  Csv(const Subject& subject, const Options& options)
      : mark_(options.numbers.decimal_mark),
        separator_(mark_ == ',' ? ';' : ','),
        kind_(subject.test.metadata.axis.kind) {
    const Axis& axis = subject.test.metadata.axis;
    axis_ = text::no_formula(axis.name);
    const iso230_2::Claims claims = iso230_2::claims_of(subject.test, subject.assessment);
    if (!claim(claims, iso230_2::ClaimKind::tested).holds()) remark_ = standing_text(claims, axis);
    if (is_diagonal(axis) && remark_.empty()) remark_ = edition_of(axis);
    if (!subject.assessment.label.empty()) remark_ += (remark_.empty() ? "" : "; ") + subject.assessment.label;
    if (const std::string corrected = correction_statement(subject.test.provenance.corrections); !corrected.empty())
      remark_ += (remark_.empty() ? "" : "; ") + corrected;
    remark_ = text::no_formula(remark_);
    append_cells({"axis", "record", "target", "target_unit", "name", "value", "U", "unit", "clause", "remark", "limit",
                  "verdict", "low", "high", "method", "symbol"});
  }

  std::string number(double x) const {
    std::string digits = format_exact(x);
    for (char& c : digits)
      if (c == '.') c = mark_;
    return digits;
  }

  std::string number(const std::optional<Deviation>& deviation, double factor = 1.0) const {
    return deviation ? number(deviation->in_native() * factor) : "";
  }

  void append(const Line& line) {
    const std::string_view target_unit = line.target.empty() ? "" : ascii_unit(position_unit(kind_));
    append_cells({axis_, line.record, line.target, target_unit, line.name, line.value, line.U, line.unit, line.clause,
                  remark_, line.limit, line.verdict, line.low, line.high, line.method, line.symbol});
  }

  std::string take() { return std::move(text_); }

 private:
  void append_cells(std::initializer_list<std::string_view> cells) {
    bool first = true;
    for (std::string_view cell : cells) {
      if (!first) text_ += separator_;
      first = false;
      text_ += text::csv_cell(cell, separator_);
    }
    text_ += "\r\n";
  }

  char mark_;
  char separator_;
  AxisKind kind_;
  std::string axis_;
  std::string remark_;
  std::string text_;
};

void append_parameters(Csv& csv, const Subject& subject, const Options& options) {
  const ParameterScale scale = parameter_scale(subject.test.metadata.axis.kind, options.unit);
  const auto& assessment = subject.assessment;
  for (const auto& parameter : iso230_2::parameters) {
    Line line{"parameter",
              "",
              parameter.key,
              csv.number(assessment.evaluation.parameters.*parameter.member, scale.per_native),
              "",
              ascii_unit(scale.unit),
              parameter.clause};
    line.symbol = iso230_2::error_symbol(subject.test.metadata.axis, parameter);
    if (const auto known = iso230_2::uncertainty_of_record(assessment, parameter)) {
      line.U = csv.number(known->U, scale.per_native);  // none of the Monte Carlo method, which states the interval
      line.low = csv.number(known->interval.lower * scale.per_native);
      line.high = csv.number(known->interval.upper * scale.per_native);
      line.method = iso230_2::method_key(known->method);
    }
    for (const iso230_2::Judgement& judgement : subject.judgements) {
      if (judgement.tolerance.parameter->key != parameter.key) continue;
      line.limit = csv.number(judgement.tolerance.limit, scale.per_native);
      line.verdict = uncertainty::verdict_name(judgement.decision.verdict);
    }
    csv.append(line);
  }
}

void append_positions(Csv& csv, const Subject& subject) {
  const std::string_view unit = ascii_unit(deviation_unit(subject.test.metadata.axis.kind));
  for (const iso230_2::PositionResult& position : subject.assessment.evaluation.positions) {
    const std::string target = csv.number(position.target.in_native());
    csv.append({"position", target, "n_up", fmt::format("{}", position.count_up), "", "", "3.5"});
    csv.append({"position", target, "n_down", fmt::format("{}", position.count_down), "", "", "3.5"});
    for (const auto& quantity : iso230_2::position_quantities)
      csv.append({"position", target, quantity.key, csv.number(position.*quantity.member), "", unit, quantity.clause});
  }
}

/// Means of a target with U composed of the contributors of Annex A, and which of these nothing was given of.
void append_annex_a_positions(Csv& csv, const iso230_2::Assessment& assessment, std::string_view unit) {
  const iso230_2::AnnexA& annex = *assessment.annex_a;
  for (std::size_t i = 0; i < annex.positions.size(); ++i) {
    const iso230_2::PositionResult& result = assessment.evaluation.positions[i];
    const iso230_2::AnnexAPosition& known = annex.positions[i];
    const std::string target = csv.number(result.target.in_native());
    const auto add = [&](std::string_view name, const std::optional<Deviation>& mean,
                         const std::optional<iso230_2::AnnexAMean>& own, std::string_view clause) {
      if (own) csv.append({"annex_a", target, name, csv.number(mean), csv.number(own->U), unit, clause});
    };
    add("mean_up", result.mean_up, known.up, "3.13");
    add("mean_down", result.mean_down, known.down, "3.13");
    add("mean", result.mean, known.mean, "3.14");
  }
  for (const std::string_view key : annex.missing)
    csv.append({"annex_a", "", "missing", std::string(key), "", "", "8.2.1"});
}

/// Means of a target with U, after Lira & Cargill (2004), eqs 8 and 10.
void append_gum_positions(Csv& csv, const iso230_2::Assessment& assessment, std::string_view unit) {
  const auto& results = assessment.evaluation.positions;
  const auto& known = assessment.gum->positions;
  for (std::size_t i = 0; i < std::min(results.size(), known.size()); ++i) {
    const std::string target = csv.number(results[i].target.in_native());
    const auto add = [&](std::string_view name, const std::optional<Deviation>& mean, Deviation U,
                         std::string_view clause) {
      csv.append({"gum", target, name, csv.number(mean), csv.number(U), unit, clause});
    };
    if (known[i].up) add("mean_up", results[i].mean_up, known[i].up->total.U, "3.13");
    if (known[i].down) add("mean_down", results[i].mean_down, known[i].down->total.U, "3.13");
    if (known[i].mean) add("mean", results[i].mean, known[i].mean->U, "3.14");
  }
}

void append_gum(Csv& csv, const iso230_2::GumUncertainty& gum, const ParameterScale& scale) {
  for (const auto& p : gum.parameters)
    csv.append({"gum", "", p.parameter->key, csv.number(p.value, scale.per_native),
                csv.number(p.uncertainty.U, scale.per_native), ascii_unit(scale.unit), p.parameter->clause});
}

void append_monte_carlo(Csv& csv, const iso230_2::MonteCarlo& monte_carlo, const ParameterScale& scale) {
  for (std::size_t k = 0; k < std::size(iso230_2::parameters); ++k) {
    const auto& d = monte_carlo.distributions[k];
    if (!d || !d->refusal.empty()) continue;
    const auto& s = d->summary;
    const std::pair<std::string_view, double> numbers[] = {{"mean", s.mean},
                                                           {"u", s.sd},
                                                           {"bias", d->bias()},
                                                           {"low", d->low},
                                                           {"high", d->high},
                                                           {"shortest_low", s.shortest.lower},
                                                           {"shortest_high", s.shortest.upper}};
    for (const auto& [what, number] : numbers) {
      const std::string name = fmt::format("{}.{}", iso230_2::parameters[k].key, what);
      csv.append({"monte_carlo", "", name, csv.number(number * scale.per_native), "", ascii_unit(scale.unit),
                  iso230_2::parameters[k].clause});
    }
  }
}

Result<std::string> write(const Subject& subject, const Options& options) {
  Csv csv(subject, options);
  append_parameters(csv, subject, options);
  const ParameterScale scale = parameter_scale(subject.test.metadata.axis.kind, options.unit);
  if (subject.assessment.annex_a)
    append_annex_a_positions(csv, subject.assessment, ascii_unit(deviation_unit(subject.test.metadata.axis.kind)));
  if (subject.assessment.gum) {
    append_gum(csv, *subject.assessment.gum, scale);
    append_gum_positions(csv, subject.assessment, ascii_unit(deviation_unit(subject.test.metadata.axis.kind)));
  }
  if (subject.assessment.monte_carlo) append_monte_carlo(csv, *subject.assessment.monte_carlo, scale);
  append_positions(csv, subject);
  for (const iso230_2::Claim& claim : iso230_2::claims_of(subject.test, subject.assessment))
    csv.append({"claim", "", iso230_2::claim_key(claim.kind), claim.holds() ? "yes" : "no", "", "", ""});
  if (!subject.trail_head.empty()) csv.append({"trail", "", "head", subject.trail_head, "", "", ""});
  return csv.take();
}

void append_row(std::string& out, std::span<const std::string> cells, char separator) {
  for (std::size_t k = 0; k < cells.size(); ++k) {
    if (k > 0) out += separator;
    out += text::csv_cell(text::no_formula(cells[k]), separator);
  }
  out += "\r\n";
}

/// With a label, each row says it in a column of its own.
std::string cells_of(const Table& table, const std::string& label, char separator) {
  std::string out;
  std::vector<std::string> head;
  for (const Column& column : table.columns) head.push_back(plain_text(column.head));
  if (!label.empty()) head.push_back("remark");
  append_row(out, head, separator);
  for (const auto& row : table.rows) {
    std::vector<std::string> cells;
    for (const TableCell& cell : row) cells.push_back(plain_text(cell.text));
    if (!label.empty()) cells.push_back(label);
    append_row(out, cells, separator);
  }
  return out;
}

Result<std::string> set(const Document& document, const Options& options) {
  const char separator = options.numbers.decimal_mark == ',' ? ';' : ',';
  std::string out;
  for (const Section& section : document.sections)
    for (const Block& block : section.blocks)
      if (const auto* table = std::get_if<Table>(&block))
        out += (out.empty() ? "" : "\r\n") + cells_of(*table, document.label, separator);
  return out;
}

}  // namespace
}  // namespace csv

extern const Writer csv_writer;
const Writer csv_writer = {"csv", "Parameters and positions as CSV", &csv::write, &csv::set};

}  // namespace axiometry::report
