// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/figures/distribution.h"
#include "axiometry/report/figures/mean_deviations.h"
#include "axiometry/report/method_values.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/standards/readings/runs_made.h"

namespace axiometry::report {

namespace {

using iso230_2::Measurand;

Measurand measurand_of(const iso230_2::Assessment& assessment) {
  return assessment.monte_carlo ? assessment.monte_carlo->measurand : assessment.gum->measurand;
}

TableCell number_cell(const std::string& number) { return number.empty() ? quiet_cell("–") : text_cell(number); }

RichText unit_note(std::string_view unit) { return plain(fmt::format(", {}", unit)); }

/// The table of the methods, column group by column group; groups of methods that were not run are left out.
class MethodTable {
 public:
  MethodTable(const Subject& subject, const Options& options)
      : assessment_(subject.assessment),
        scale_(parameter_scale(subject.test.metadata.axis.kind, options.unit)),
        rows_(method_rows(assessment_, subject.test.metadata.axis.kind, options)),
        run_(iso230_2::run_with_intervals(assessment_)),
        coverage_(run_ != nullptr ? shown_percent(run_->coverage, options) : "") {
    table_.rows.resize(rows_.size());
  }

  Table operator()() {
    table_.caption = joined({plain("The methods side by side"), unit_note(scale_.unit)});
    add_measured();
    if (assessment_.annex_a) add_U("Annex A", plain(" (k = 2)"), &MethodRow::annex_a_U);
    if (assessment_.gum) add_U("GUM", {}, &MethodRow::gum_U);
    if (run_ != nullptr) add_monte_carlo();
    add_widths();
    add_notes();
    return std::move(table_);
  }

 private:
  template <typename Cell>
  void add_column(Column column, const Cell& cell) {
    table_.columns.push_back(std::move(column));
    for (std::size_t k = 0; k < rows_.size(); ++k) table_.rows[k].push_back(cell(rows_[k]));
  }

  template <typename Member>
  void add_numbers(RichText head, bool opens_group, const Member& member) {
    add_column({std::move(head), Align::decimal, false, false, opens_group}, [&](const MethodRow& row) {
      return row.monte_carlo ? number_cell((*row.monte_carlo).*member) : quiet_cell("–");
    });
  }

  void add_measured() {
    table_.groups.push_back({plain("Parameter"), 2});
    add_column({plain("Symbol"), Align::start, true},
               [](const MethodRow& row) { return TableCell{symbol(row.parameter->symbol)}; });
    add_column({plain("Value"), Align::decimal}, [](const MethodRow& row) { return TableCell{strong(row.value)}; });
  }

  void add_U(std::string_view method, const RichText& factor, std::string MethodRow::*member) {
    table_.groups.push_back({plain(method), 1});
    add_column({joined({italic("U"), factor}), Align::decimal, false, false, true},
               [&](const MethodRow& row) { return number_cell(row.*member); });
  }

  void add_monte_carlo() {
    table_.groups.push_back({plain("Monte Carlo"), 5});
    add_numbers(italic("u"), true, &ShownDistribution::u);
    add_numbers(plain("Mean"), false, &ShownDistribution::mean);
    add_numbers(plain("Bias"), false, &ShownDistribution::bias);
    add_numbers(plain(coverage_ + " from"), false, &ShownDistribution::lower);
    add_numbers(plain("to"), false, &ShownDistribution::upper);
  }

  /// How wide the simpler methods are against the best one that was run.
  void add_widths() {
    const bool annex_a = assessment_.annex_a && (run_ != nullptr || assessment_.gum);
    const bool gum = assessment_.gum && run_ != nullptr;
    const std::size_t count = (annex_a ? 1 : 0) + (gum ? 1 : 0);
    if (count == 0) return;
    table_.groups.push_back({plain(run_ != nullptr ? "Against Monte Carlo" : "Against GUM"), count});
    const auto add = [&](std::string_view head, bool opens_group, std::string MethodRow::*member) {
      add_column({plain(head), Align::start, false, false, opens_group}, [&](const MethodRow& row) {
        const std::string& words = row.*member;
        if (words.empty()) return quiet_cell("–");
        return words.ends_with("narrower") ? TableCell{plain(words), Tone::caution} : text_cell(words);
      });
    };
    if (annex_a) add("Annex A", true, &MethodRow::annex_a_width);
    if (gum) add("GUM", !annex_a, &MethodRow::gum_width);
  }

  void add_notes() {
    if (run_ == nullptr) return;
    if (const std::string hypothesis = hypothesis_statement(assessment_); !hypothesis.empty())
      table_.notes.push_back(sentence(hypothesis));
    table_.notes.push_back(plain(
        "Bias: value less mean. The parameters are extremes: noise in the readings pushes them apart and makes the "
        "bias positive; systematic inputs, such as a temperature, widen them more often than they narrow them and "
        "make it negative. The measured value stays the result."));
    if (assessment_.annex_a || assessment_.gum)
      table_.notes.push_back(
          joined({plain("Against Monte Carlo: "), italic("U"),
                  plain(fmt::format(" compared with half the {} interval; alike: within 5\u00a0%.", coverage_))}));
    if (const std::string outside = outside_statement(rows_); !outside.empty())
      table_.notes.push_back(sentence(outside));
  }

  const iso230_2::Assessment& assessment_;
  ParameterScale scale_;
  std::vector<MethodRow> rows_;
  const iso230_2::MonteCarlo* run_;
  std::string coverage_;
  Table table_;
};

/// The interval that is stated and what is known about the accuracy of the numbers themselves.
Table interval_table(const Subject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  const auto& monte_carlo = *subject.assessment.monte_carlo;
  Table table;
  table.caption = joined({plain("Monte Carlo: coverage interval and numerical tolerance"),
                          unit_note(parameter_scale(kind, options.unit).unit)});
  const std::string coverage = shown_percent(monte_carlo.coverage, options);
  table.groups = {{plain("Parameter"), 2}, {plain(coverage + " stated"), 2}, {plain("Accuracy"), 2}};
  table.columns = {{plain("Symbol"), Align::start, true},
                   {italic("u"), Align::decimal},
                   {plain("from"), Align::decimal, false, false, true},
                   {plain("to"), Align::decimal},
                   {plain("δ"), Align::decimal, false, false, true},
                   {plain("Stable")}};
  for (const MethodRow& row : method_rows(subject.assessment, kind, options)) {
    if (!row.monte_carlo) continue;
    const ShownDistribution& d = *row.monte_carlo;
    table.rows.push_back({{symbol(row.parameter->symbol)},
                          text_cell(d.u),
                          text_cell(d.lower),
                          text_cell(d.upper),
                          text_cell(d.tolerance),
                          d.stable ? text_cell("yes") : TableCell{plain("no"), Tone::caution}});
  }
  table.notes = {
      joined({plain("δ: half a unit of the last significant digit of "), italic("u"),
              plain(monte_carlo.hypotheses.size() > 1 ? " that shall be right (JCGM 101, 7.9.2). Stable: mean and "
                                                      : " that shall be right (JCGM 101, 7.9.2). Stable: mean, "),
              italic("u"),
              plain(monte_carlo.hypotheses.size() > 1
                        ? " are known better than δ under every hypothesis about the noise, and the ends "
                          "of its interval better than half a unit of the last such digit of half the "
                          "widest."
                        : " and the ends of the symmetric interval are known better than δ.")})};
  return table;
}

Facts run_facts(const iso230_2::Assessment& assessment, const Options& options) {
  Facts facts{"How it was found", {}};
  const auto add = [&](std::string_view name, const std::string& value) {
    facts.facts.push_back({plain(name), TableCell{prose(value)}});
  };
  if (assessment.monte_carlo) {
    const auto& run = *assessment.monte_carlo;
    if (iso230_2::run_with_intervals(assessment) == nullptr) add("No interval", refusal_statement(run) + ".");
    add("Monte Carlo", "JCGM 101: every trial is a complete test that may have happened, evaluated by clause 3.");
    add("Run", trials_statement(run) + ".");
    add("Seed", fmt::format("{}; the same seed gives the same numbers on any number of threads.", run.seed));
    add("Coverage", fmt::format("{}.", shown_percent(run.coverage, options)));
    if (const std::string type_a = type_a_statement(run); !type_a.empty()) add("Sampling", type_a + ".");
  }
  if (assessment.gum)
    add("GUM",
        fmt::format("Law of propagation, linear at the extreme targets of this test; correlation {} between the errors "
                    "of ↑ and ↓ at a target.",
                    shown_exact(assessment.gum->up_down_correlation, options)));
  if (assessment.annex_a) add("Annex A", "Simplified formulas of the standard, k = 2, for this test.");
  return facts;
}

}  // namespace

Section method_section(const Subject& subject, const Options& options) {
  const auto& assessment = subject.assessment;
  Section section{"methods", "Uncertainty of the parameters", true, {}};
  section.blocks.emplace_back(Paragraph{plain(measurand_statement(
      measurand_of(assessment), most_runs_made(subject.test.series), !assessment.uncorrected.empty()))});
  section.blocks.emplace_back(Paragraph{plain(method_statement(assessment))});
  if (assessment.annex_a || assessment.gum || iso230_2::run_with_intervals(assessment) != nullptr)
    section.blocks.emplace_back(MethodTable(subject, options)());
  if (auto figure = distribution_figure(subject, options)) section.blocks.emplace_back(*std::move(figure));
  if (iso230_2::run_with_intervals(assessment) != nullptr)
    section.blocks.emplace_back(interval_table(subject, options));
  if (auto means = mean_interval_figure(subject, options)) section.blocks.emplace_back(*std::move(means));
  section.blocks.emplace_back(run_facts(assessment, options));
  return section;
}

}  // namespace axiometry::report
