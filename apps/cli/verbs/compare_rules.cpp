// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>
#include "cli/flags/verb.h"

#include "axiometry/app/compare_rules/compare_rules.h"
#include "axiometry/base/text/text.h"
#include "axiometry/language/words.h"
#include "axiometry/report/drawing/utf8.h"
#include "axiometry/report/rules.h"
#include "axiometry/report/translated.h"
#include "axiometry/standards/rules/rule_trials.h"
#include "cli/failure.h"
#include "cli/flags/experiment_flags.h"
#include "cli/flags/option_text.h"
#include "cli/flags/reading_flags.h"
#include "cli/flags/uncertainty_flags.h"
#include "cli/text/findings_text.h"
#include "cli/text/terminal.h"
#include "cli/text/title_text.h"
#include "cli/verbs/commands.h"

namespace axiometry::cli {
namespace {

struct RuleArguments {
  std::string file;
  app::EvaluateOptions reading;
  std::vector<std::string> standards;
  std::vector<const standards::AxisRule*> rules;
  app::OutputNames outputs;
  report::Options report;
  bool quiet = false;
};

/// What the terminal shows of one test, in the reader's language.
class RuleSummary {
 public:
  RuleSummary(const app::ComparedRules& compared, const report::Options& options, const Terminal& terminal)
      : compared_(compared), options_(options), terminal_(terminal) {
    for (const auto& rule : compared.comparison.rules)
      rows_.push_back(report::rule_rows(rule, compared.comparison, options));
    for (const auto& rows : rows_)
      for (const report::RuleRow& row : rows) number_width_ = std::max(number_width_, display_width(row.value));
    for (const auto& rows : rows_)
      for (const report::RuleRow& row : rows) {
        title_width_ = std::max(title_width_, display_width(named(row)));
        value_width_ = std::max(value_width_, display_width(value_of(row)));
        interval_width_ = std::max(interval_width_, display_width(said(row.interval)));
        other_width_ = std::max(other_width_, display_width(row.counterpart_value));
        difference_width_ = std::max(difference_width_, display_width(row.difference));
      }
  }

  std::string text() const {
    std::string all = heading();
    for (std::size_t k = 0; k < rows_.size(); ++k) all += rule_text(*compared_.comparison.rules[k].rule, rows_[k]);
    all += "\n";
    all += findings_text(compared_.comparison.findings, options_, terminal_);
    for (const auto& warning : compared_.comparison.warnings)
      all += wrapped(report::printable(said(warning.message + ".")), terminal_.width(), 2) + "\n";
    if (!compared_.comparison.warnings.empty()) all += "\n";
    if (compared_.comparison.trials)
      for (const std::string& note : compared_.comparison.trials->notes)
        all += terminal_.faint(wrapped(said(language::capitalised(note) + "."), terminal_.width(), 2)) + "\n";
    for (const std::string& remark :
         {std::string(standards::no_conformity_stated), standards::uncertainty_statement(compared_.comparison)})
      all += terminal_.faint(wrapped(said(remark + "."), terminal_.width(), 0)) + "\n";
    const std::string& label = compared_.comparison.iso230_2.label;
    return label.empty() ? all : all + terminal_.bold(said(label + ".")) + "\n";
  }

 private:
  std::string said(std::string_view english) const { return report::translated(english, options_); }

  std::string unit() const { return std::string(deviation_unit(compared_.test.metadata.axis.kind)); }

  std::string heading() const {
    const Metadata& m = compared_.test.metadata;
    const Provenance& p = compared_.test.provenance;
    return fmt::format("{}  {}\n{}\n", terminal_.bold(report::printable(title_text(m.axis, m.machine.name, options_))),
                       said(fmt::format("by other rules, beside {}", iso230_2::edition)),
                       terminal_.faint(fmt::format(
                           "{} ({})", p.file == "-" ? said("standard input") : report::printable(p.file), p.format)));
  }

  /// "Positioning uncertainty P"
  std::string named(const report::RuleRow& row) const {
    const std::string title = said(row.title);
    return row.symbol.empty() ? title : title + " " + row.symbol;
  }

  /// Figures of one evidence stand under it.
  std::string rule_text(const standards::AxisRule& rule, const std::vector<report::RuleRow>& rows) const {
    std::string all;
    std::string_view evidence;
    for (const report::RuleRow& row : rows) {
      if (row.evidence != evidence)
        all += fmt::format("\n{}  {}\n", terminal_.bold(rule.name), terminal_.faint(said(row.evidence)));
      evidence = row.evidence;
      all += row_text(row);
    }
    return all + "  " + terminal_.faint(wrapped(said(rule.remark), terminal_.width(), 2)) + "\n";
  }

  /// "4.1 µm = 0.00024 % T", the numbers under each other.
  std::string value_of(const report::RuleRow& row) const {
    if (row.value.empty()) return {};
    const std::string value = right(row.value, number_width_) + " " + unit();
    return row.share_of_travel.empty() ? value : value + fmt::format(" = {} T", row.share_of_travel);
  }

  std::string row_text(const report::RuleRow& row) const {
    std::string line = left(named(row), title_width_ + 2);
    if (row.value.empty())
      return line + terminal_.faint(wrapped(said(row.absence), terminal_.width(), title_width_ + 2)) + "\n";
    line += left(value_of(row), value_width_);
    if (interval_width_ > 0) line += "   " + left(said(row.interval), interval_width_);
    if (!row.counterpart_value.empty())
      line += "   " + terminal_.faint(
                          fmt::format("{} = {}", left(row.counterpart, 2), right(row.counterpart_value, other_width_)));
    if (!row.difference.empty()) line += "   " + right(row.difference, difference_width_);
    if (!row.relative.empty()) line += fmt::format(" ({})", row.relative);
    line.resize(line.find_last_not_of(' ') + 1);
    if (!row.no_interval.empty())
      line += "\n  " + terminal_.faint(wrapped(said("No interval: " + row.no_interval + "."), terminal_.width(), 4));
    return line + "\n";
  }

  const app::ComparedRules& compared_;
  const report::Options& options_;
  const Terminal& terminal_;
  std::vector<std::vector<report::RuleRow>> rows_;
  std::size_t title_width_ = 0, number_width_ = 0, value_width_ = 0, interval_width_ = 0, other_width_ = 0,
              difference_width_ = 0;
};

int run_rules(RuleArguments& arguments) {
  const app::InputFile input{arguments.file, false};
  arguments.outputs.inputs = app::InputFiles(std::span(&input, 1));
  if (auto spared = app::check_inputs_spared(arguments.outputs); !spared) return failed(spared.error(), exit_usage);
  auto compared = app::compare_rules_of(arguments.file, arguments.reading, arguments.rules);
  if (!compared) return failed(compared.error());
  if (!arguments.quiet && arguments.outputs.json != "-") {
    const Terminal terminal(ColourChoice::automatic);
    fmt::print("{}", RuleSummary(*compared, arguments.report, terminal).text());
  }
  if (auto written = app::write_outputs(*compared, arguments.outputs, arguments.report); !written)
    return failed(written.error());
  return exit_done;
}

void add_rule_input(const Verb& verb, RuleArguments& a) {
  verb.add_option("FILE", a.file, "Measured test, or - for the standard input")->required();
  verb.add_option("--standard", a.standards, "Only these rules, by the names below; may be repeated")
      ->type_name("RULE")
      ->one_at_a_time()
      ->group("Input");
  add_reading_flags(verb, a.reading, "axis.travel_end=500");
  add_method_flags(verb, a.reading.uncertainty);
}

/// Other methods than trials know the parameters of ISO 230-2:2014 alone.
void check_rule_methods(const Verb& verb, app::UncertaintyOptions& options) {
  check_method_flags(verb, options);
  if (verb.count("--uncertainty") > 0 && (options.gum || !options.monte_carlo))
    throw UsageError("--uncertainty", "found another method, expected monte-carlo: the others know no other rules");
  if (verb.count("--trials") == 0) options.trials.propagation.trials = standards::usual_rule_trials;
}

/// A comparison has tables and no figures: a picture of it would be empty.
void refuse_pictures(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    const std::string lower = text::to_lower(name);
    if (lower.ends_with(".svg") || lower.ends_with(".png"))
      throw UsageError("--report",
                       fmt::format("found {}, expected html, pdf or csv: there is no figure", text::quoted(name)));
  }
}

/// "  vdi-dgq-3441       VDI/DGQ 3441 (second-hand)" for each, with every evidence that its figures rest on.
std::string list_of_rules() {
  std::string all;
  for (const auto* rule : standards::axis_rule_table()) {
    std::vector<std::string_view> evidence;
    for (const auto& figure : rule->figures)
      if (const auto key = standards::evidence_key(figure.evidence); std::ranges::find(evidence, key) == evidence.end())
        evidence.push_back(key);
    all += fmt::format("\n  {:<20}{} ({})", rule->id, rule->name, fmt::join(evidence, ", "));
  }
  return all + R"(
In brackets on what the formulas rest: only what rests on "text" was checked against the text of the rule.)";
}

}  // namespace

void add_compare_rules(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("compare-rules",
                                     "The same readings by other rules (VDI/DGQ 3441, JIS, GB/T, older ISO 230-2)");
  auto arguments = std::make_shared<RuleArguments>();
  add_rule_input(*verb, *arguments);
  add_output_flags(*verb, arguments->outputs, arguments->report, arguments->quiet, "html, pdf or csv");
  verb->callback([verb = *verb, arguments, &exit_code] {
    check_rule_methods(verb, arguments->reading.uncertainty);
    auto rules = app::named_rules(arguments->standards);
    if (!rules) throw UsageError("--standard", rules.error().message);
    arguments->rules = *std::move(rules);
    if (auto outputs = app::check_outputs(arguments->outputs); !outputs)
      throw UsageError("--report", outputs.error().message);
    refuse_pictures(arguments->outputs.reports);
    exit_code = run_rules(*arguments);
  });
  verb->footer(R"(Each figure stands beside the parameter of ISO 230-2:2014 that it is taken for, with what is known of
its formula. No conformity with other rules is stated. With --uncertainty monte-carlo each figure has the interval in
which it lies by that formula, from the trials that the parameters of ISO 230-2:2014 have too. Rules:)" +
               list_of_rules() + R"(
Examples:
  axiometry compare-rules test.csv
  axiometry compare-rules test.csv --standard vdi-dgq-3441 --standard iso-230-2-2006
  axiometry compare-rules test.csv --uncertainty monte-carlo --seed 7
  axiometry compare-rules test.csv --report rules.pdf --json rules.json)");
}

}  // namespace axiometry::cli
