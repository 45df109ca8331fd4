// SPDX-License-Identifier: Apache-2.0
#include "cli/text/method_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/method_values.h"
#include "axiometry/report/resolved_text.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/readings/runs_made.h"
#include "cli/text/flags_of_words.h"

namespace axiometry::cli {
namespace {

using report::MethodRow;
using report::ShownDistribution;

constexpr std::size_t parameter_width = 4;

/// A table whose columns are as wide as what stands in them, two blanks apart.
class TextTable {
 public:
  explicit TextTable(std::size_t rows) : lines_(rows + 2) {}

  /// Two lines of head, then a cell per row; numbers stand at the right, words at the left.
  void add(std::string_view head, std::string_view below, const std::vector<std::string>& cells, bool words = false) {
    std::size_t width = std::max(display_width(head), display_width(below));
    for (const std::string& cell : cells) width = std::max(width, display_width(cell));
    const auto aligned = [&](std::string_view text) { return words ? left(text, width) : right(text, width); };
    append(0, aligned(head));
    append(1, aligned(below));
    for (std::size_t k = 0; k < cells.size(); ++k) append(k + 2, aligned(cells[k]));
  }

  std::string text(const Terminal& terminal) const {
    std::string all;
    for (std::size_t k = 0; k < lines_.size(); ++k) {
      const std::string line = lines_[k].substr(0, lines_[k].find_last_not_of(' ') + 1);
      if (!line.empty()) all += (k < 2 ? terminal.faint(line) : line) + "\n";
    }
    return all;
  }

 private:
  void append(std::size_t line, const std::string& cell) { lines_[line] += (lines_[line].empty() ? "" : "  ") + cell; }

  std::vector<std::string> lines_;
};

template <typename Cell>
std::vector<std::string> cells(const std::vector<MethodRow>& rows, const Cell& cell) {
  std::vector<std::string> all;
  for (const MethodRow& row : rows) {
    const std::string text = cell(row);
    all.push_back(text.empty() ? "–" : text);
  }
  return all;
}

/// What one of the numbers of the Monte Carlo method is in a row.
template <typename Member>
std::vector<std::string> numbers(const std::vector<MethodRow>& rows, const Member& member) {
  return cells(rows, [&](const MethodRow& row) {
    return row.monte_carlo ? std::string((*row.monte_carlo).*member) : std::string();
  });
}

std::vector<std::string> symbols(const std::vector<MethodRow>& rows) {
  return cells(rows, [](const MethodRow& row) { return left(row.parameter->symbol, parameter_width); });
}

std::string cut(const std::string& words, std::size_t width) {
  if (display_width(words) <= width) return words;
  std::size_t end = 0;
  while (true) {
    const std::size_t next = end + character_at(words, end).length;
    if (display_width(words.substr(0, next)) + 1 > width) return words.substr(0, end) + "…";
    end = next;
  }
}

std::string side_by_side(const app::Evaluated& e, const std::vector<MethodRow>& rows, const report::Options& options,
                         const Terminal& terminal) {
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  const auto& assessment = e.assessment;
  const report::ParameterScale scale = report::parameter_scale(e.test.metadata.axis.kind, options.unit);
  TextTable table(rows.size());
  table.add("", fmt::format("/{}", scale.unit), symbols(rows), true);
  table.add("", said("value"), cells(rows, [](const MethodRow& row) { return row.value; }));
  if (assessment.annex_a)
    table.add(said("Annex A"), "± U", cells(rows, [](const MethodRow& row) { return row.annex_a_U; }));
  if (assessment.gum) table.add("GUM", "± U", cells(rows, [](const MethodRow& row) { return row.gum_U; }));
  const auto* run = iso230_2::run_with_intervals(assessment);
  if (run != nullptr) {
    table.add("MC", "u", numbers(rows, &ShownDistribution::u));
    table.add("", said("bias"), numbers(rows, &ShownDistribution::bias));
    const std::string coverage = report::shown_percent(run->coverage, options);
    table.add(coverage, said("from"), numbers(rows, &ShownDistribution::lower));
    table.add("", said("to"), numbers(rows, &ShownDistribution::upper));
  }
  const std::string_view against = run != nullptr ? "than MC" : "than GUM";
  if (assessment.annex_a && (run != nullptr || assessment.gum))
    table.add(said("Annex A"), said(against),
              cells(rows, [&](const MethodRow& row) { return said(row.annex_a_width); }), true);
  if (assessment.gum && run != nullptr && !assessment.annex_a)
    table.add("GUM", said(against), cells(rows, [&](const MethodRow& row) { return said(row.gum_width); }), true);
  return table.text(terminal);
}

std::string intervals(const app::Evaluated& e, const std::vector<MethodRow>& rows, const report::Options& options,
                      const Terminal& terminal) {
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  if (iso230_2::run_with_intervals(e.assessment) == nullptr) return "";
  const report::ParameterScale scale = report::parameter_scale(e.test.metadata.axis.kind, options.unit);
  TextTable table(rows.size());
  table.add("", fmt::format("/{}", scale.unit), symbols(rows), true);
  table.add("", said("mean"), numbers(rows, &ShownDistribution::mean));
  table.add(said("stated"), said("from"), numbers(rows, &ShownDistribution::lower));
  table.add("", said("to"), numbers(rows, &ShownDistribution::upper));
  table.add(options.language == language::Language::german ? "Toleranz" : said("tolerance"), said("of u"),
            numbers(rows, &ShownDistribution::tolerance));
  table.add(
      "", said("stable"),
      cells(rows,
            [&](const MethodRow& row) { return said(row.monte_carlo && row.monte_carlo->stable ? "yes" : "no"); }),
      true);
  return table.text(terminal) + "\n";
}

/// u of every input for the main parameters, with its part of the variance.
std::string contribution_table(const app::Evaluated& e, const report::Options& options, const Terminal& terminal) {
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  const auto all = report::contributions(e.assessment);
  const report::ParameterScale scale = report::parameter_scale(e.test.metadata.axis.kind, options.unit);
  constexpr std::size_t title_width = 24;
  TextTable table(all.size());
  std::vector<std::string> titles;
  for (const auto& c : all) titles.push_back(cut(report::printable(said(c.title)), title_width));
  table.add(said("contribution"), fmt::format("u/{}", scale.unit), titles, true);
  for (std::size_t p : report::main_parameters(e.assessment.evaluation.parameters)) {
    std::vector<std::string> column;
    for (std::size_t k = 0; k < all.size(); ++k)
      column.push_back(all[k].u[p] == 0.0
                           ? "–"
                           : fmt::format("{} {:>5}",
                                         report::shown_uncertainty(Deviation::native(all[k].u[p]), scale, options),
                                         report::shown_percent(report::share(all, k, p), options)));
    table.add(iso230_2::parameters[p].symbol, "", column);
  }
  return all.empty() ? "" : table.text(terminal) + "\n";
}

std::string input_list(const app::Evaluated& e, const report::Options& options, const Terminal& terminal) {
  const auto said = [&](std::string_view english) { return report::translated(english, options); };
  std::string text;
  const auto add = [&](const std::string& symbol, const std::string& title, const std::string& distribution,
                       const std::string& unit, const std::string& note) {
    const std::string words =
        fmt::format("{}{}{} {}{}", said(title), report::colon(options), distribution.empty() ? "–" : said(distribution),
                    unit, note.empty() ? "" : fmt::format(" ({})", said(note)));
    text += terminal.bold(left(symbol, 7)) + " " + wrapped(report::printable(words), terminal.width(), 8) + "\n";
  };
  if (e.assessment.monte_carlo) {
    for (const auto& i : e.assessment.monte_carlo->inputs)
      add(i.symbol, i.title, report::shown_distribution(i.distribution, options), i.unit, i.note);
  } else {
    for (const auto& s : e.assessment.gum->sources)
      add(s.symbol, s.title, report::shown_distribution(s.distribution, options), s.unit, s.note);
  }
  return text.empty() ? text : terminal.faint(report::translated("inputs", options)) + "\n" + text + "\n";
}

std::string paragraph(const std::string& words, const report::Options& options, const Terminal& terminal) {
  return terminal.faint(wrapped(report::translated(words, options), terminal.width(), 0)) + "\n";
}

/// How the Monte Carlo method was run.
std::string run_lines(const app::Evaluated& e, const report::Options& options, const Terminal& terminal) {
  if (!e.assessment.monte_carlo) return "";
  const auto& run = *e.assessment.monte_carlo;
  std::string text = paragraph(fmt::format("Monte Carlo (MC): {}; seed {}; {} coverage.", report::trials_statement(run),
                                           run.seed, report::shown_percent(run.coverage, options)),
                               options, terminal);
  if (const std::string hypothesis = report::hypothesis_statement(e.assessment); !hypothesis.empty())
    text += paragraph(hypothesis + ".", options, terminal);
  if (iso230_2::run_with_intervals(e.assessment) == nullptr)
    text += paragraph(report::refusal_statement(run) + ".", options, terminal);
  if (const std::string type_a = report::type_a_statement(run); !type_a.empty())
    text += paragraph("Sampling of the approaches: " + type_a + ".", options, terminal);
  return text;
}

/// For A and R; with all details for E, M and B as well.
std::string leading_lines(const app::Evaluated& e, const report::Options& options, const Terminal& terminal,
                          Detail detail) {
  const auto all = report::contributions(e.assessment);
  std::string text;
  for (std::size_t p : report::main_parameters(e.assessment.evaluation.parameters)) {
    const auto& parameter = iso230_2::parameters[p];
    if (detail == Detail::summary && !parameter.key.starts_with('A') && !parameter.key.starts_with('R')) continue;
    if (const auto first = report::leading(all, p, e.assessment))
      text += wrapped(report::printable(report::translated(
                          fmt::format("Largest contribution to {} ({}): {}.", parameter.symbol,
                                      iso230_2::method_title(report::contributing_method(e.assessment)),
                                      report::leading_statement(*first, e.test.metadata.axis.kind, options)),
                          options)),
                      terminal.width(), 0) +
              "\n";
  }
  return text;
}

std::string notes(const app::Evaluated& e, const report::Options& options, const Terminal& terminal) {
  std::vector<std::string> all;
  const auto add = [&](const std::vector<std::string>& list) {
    for (const std::string& note : list)
      if (std::ranges::find(all, note) == all.end()) all.push_back(note);
  };
  if (e.assessment.monte_carlo) add(e.assessment.monte_carlo->notes);
  if (e.assessment.gum) add(e.assessment.gum->notes);
  std::string text;
  for (const std::string& note : all)
    text += terminal.faint(left(report::translated("note", options), 8)) +
            wrapped(report::printable(with_flags(report::translated(note, options), note)), terminal.width(), 8) + "\n";
  return text.empty() ? text : text + "\n";
}

}  // namespace

std::string method_tables(const app::Evaluated& e, const report::Options& asked, const Terminal& terminal,
                          Detail detail) {
  const auto& assessment = e.assessment;
  if (!assessment.gum && !assessment.monte_carlo) return "";
  const report::Options options = report::fitted(asked, assessment.evaluation.parameters);
  const auto rows = report::method_rows(assessment, e.test.metadata.axis.kind, options);
  const auto measurand = assessment.monte_carlo ? assessment.monte_carlo->measurand : assessment.gum->measurand;
  std::string text;
  if (detail == Detail::full && !assessment.label.empty())
    text += terminal.bold(report::printable(report::translated(assessment.label, options))) + "\n";
  text += wrapped(report::translated(report::measurand_statement(measurand, most_runs_made(e.test.series),
                                                                 !assessment.uncorrected.empty()),
                                     options),
                  terminal.width(), 0) +
          "\n\n";
  text += side_by_side(e, rows, options, terminal);
  text += paragraph(report::method_statement(assessment), options, terminal);
  if (const std::string outside = report::outside_statement(rows); !outside.empty())
    text += paragraph(outside + ".", options, terminal);
  text += run_lines(e, options, terminal) + "\n";
  if (const std::string lines = leading_lines(e, options, terminal, detail); !lines.empty()) text += lines + "\n";
  if (detail == Detail::summary) return text;
  return text + contribution_table(e, options, terminal) + intervals(e, rows, options, terminal) +
         input_list(e, options, terminal) + notes(e, options, terminal);
}

std::string resolved_inputs_text(const app::Evaluated& e, const report::Options& options, const Terminal& terminal) {
  const auto said = [&](const std::string& english) { return report::printable(report::translated(english, options)); };
  std::string text;
  for (const auto& row : e.assessment.inputs.rows) {
    const std::string words = fmt::format("{}{}{} ({}){}{}", said(report::input_title(row)), report::colon(options),
                                          said(report::input_value(row, options)), said(report::origin_text(row)),
                                          report::semicolon(options), said(report::use_text(row)));
    text += terminal.bold(left(row.symbol, 14)) + " " + wrapped(words, terminal.width(), 15) + "\n";
  }
  return text.empty() ? text : terminal.faint(said("inputs as resolved")) + "\n" + text + "\n";
}

}  // namespace axiometry::cli
