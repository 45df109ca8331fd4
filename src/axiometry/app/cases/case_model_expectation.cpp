// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "axiometry/app/cases/case_expectation.h"
#include "axiometry/app/cases/case_model.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/uncertainty/validation.h"

namespace axiometry::app {
namespace {

using uncertainty::Budget;
using uncertainty::OutputSummary;

/// A figure that an expectation names, and how far it may be from what is expected when the line does not say.
struct Figure {
  std::optional<double> value;
  std::optional<double> tolerance;  // absent: a relative 1e-9
};

/// The words of "expect [OUTPUT] mcm shortest low = 1 within 0.1" before the relation.
struct Subject {
  std::size_t output = 0;
  std::string_view method;
  std::vector<std::string_view> quantity;
  std::size_t next = 0;  // the word behind

  bool is(std::string_view one) const { return quantity.size() == 1 && quantity[0] == one; }
  bool is(std::string_view one, std::string_view two) const {
    return quantity.size() == 2 && quantity[0] == one && quantity[1] == two;
  }
};

Result<Subject> read_subject(const Statement& s, const ModelStatements& said) {
  Subject subject;
  std::size_t index = 1;
  const auto is = [&](std::string_view word) { return index < s.words.size() && s.words[index].is(word); };
  if (!is("mcm") && !is("gum")) {
    const auto output = index < s.words.size() ? said.output(s.words[index].text) : std::nullopt;
    if (!output) return unexpected_word(s, index, "mcm, gum, error or the name of an output");
    subject.output = *output;
    ++index;
  } else if (said.formulas.size() > 1) {
    return unexpected_word(s, index, "the name of one of the outputs");
  }
  if (!is("mcm") && !is("gum")) return unexpected_word(s, index, "mcm or gum");
  subject.method = s.words[index++].text;
  const auto ends = [](const Word& w) {
    return std::ranges::any_of(std::initializer_list<std::string_view>{"=", "<", ">", "<=", ">=", "not", "yes", "no"},
                               [&w](std::string_view end) { return w.is(end); });
  };
  for (; index < s.words.size() && !ends(s.words[index]); ++index) subject.quantity.push_back(s.words[index].text);
  subject.next = index;
  return subject;
}

Result<Figure> trials_figure(const Statement& s, const Subject& subject, const OutputSummary& out) {
  const auto noise = [&out](double error) { return std::max(out.tolerance, 4 * error); };
  if (subject.is("y")) return Figure{out.mean, noise(out.mean_error)};
  if (subject.is("u")) return Figure{out.sd, noise(out.sd_error)};
  if (subject.is("low")) return Figure{out.symmetric.lower, noise(out.symmetric_error.lower)};
  if (subject.is("high")) return Figure{out.symmetric.upper, noise(out.symmetric_error.upper)};
  if (subject.is("shortest", "low")) return Figure{out.shortest.lower, out.tolerance};
  if (subject.is("shortest", "high")) return Figure{out.shortest.upper, out.tolerance};
  if (subject.is("trials")) return Figure{static_cast<double>(out.distribution.trials()), 0.0};
  return unexpected_word(s, subject.next - subject.quantity.size(),
                         "y, u, low, high, shortest low, shortest high or trials");
}

Result<Figure> law_figure(const Statement& s, const Subject& subject, const uncertainty::LawResult& law,
                          const ModelStatements& said) {
  const Budget& budget = law.outputs[subject.output];
  if (subject.is("y")) return Figure{budget.estimate, {}};
  if (subject.is("u")) return Figure{budget.standard_uncertainty, {}};
  if (subject.is("k")) return Figure{budget.coverage_factor, {}};
  if (subject.is("U")) return Figure{budget.expanded_uncertainty, {}};
  if (subject.is("low")) return Figure{budget.interval.lower, {}};
  if (subject.is("high")) return Figure{budget.interval.upper, {}};
  if (subject.is("degrees")) {
    const auto nu = budget.degrees_of_freedom;
    return Figure{nu && std::isinf(*nu) ? std::nullopt : nu, {}};
  }
  if (subject.is("second-order", "y")) return Figure{budget.second_order->estimate, {}};
  if (subject.is("second-order", "u")) return Figure{budget.second_order->standard_uncertainty, {}};
  if (subject.is("second-order", "low")) return Figure{budget.second_order->interval.lower, {}};
  if (subject.is("second-order", "high")) return Figure{budget.second_order->interval.upper, {}};
  const std::size_t first = subject.next - subject.quantity.size();
  if (subject.quantity.size() == 2) {
    const auto input = said.input(subject.quantity[1]), output = said.output(subject.quantity[1]);
    const bool of_input = subject.quantity[0] == "sensitivity" || subject.quantity[0] == "contribution";
    if (of_input && !input) return unexpected_word(s, first + 1, "the name of an input");
    if (subject.quantity[0] == "sensitivity") return Figure{budget.contributions[*input].sensitivity, {}};
    if (subject.quantity[0] == "contribution") return Figure{budget.contributions[*input].contribution, {}};
    if (subject.quantity[0] == "correlation" && !output) return unexpected_word(s, first + 1, "the name of an output");
    if (subject.quantity[0] == "correlation") return Figure{law.correlation(subject.output, *output), {}};
  }
  return unexpected_word(s, first,
                         "y, u, k, U, low, high, degrees, second-order y, u, low or high, sensitivity INPUT, "
                         "contribution INPUT, correlation OUTPUT or validated");
}

/// To two digits of the tolerance, as more mean nothing.
std::string shown(double x, double tolerance) {
  if (tolerance == 0.0) return fmt::format("{:.15g}", x);
  const double size = std::abs(x);
  if (size >= 1e9 || tolerance < 1e-8) return fmt::format("{:.10g}", x);
  std::string text = fmt::format("{:.{}f}", x, std::max(decimals_for(tolerance, 2), 0));
  if (text.find_first_not_of("-0.") == text.npos && text[0] == '-') text.erase(0, 1);  // the sign of noise
  return text;
}

Result<CaseComparison> compare(const Statement& s, std::size_t index, const Figure& figure) {
  CaseComparison c{s.words[0].at.line, expectation_text(s), {}, {}, {}, false};
  const auto word_is = [&](std::size_t k, std::string_view text) { return k < s.words.size() && s.words[k].is(text); };
  if (word_is(index, "not") && word_is(index + 1, "applicable") && s.words.size() == index + 2) {
    c.expected = "not applicable";
    c.got = figure.value ? format_exact(*figure.value) : c.expected;
    c.met = !figure.value;
    return c;
  }
  const std::string_view relation = index < s.words.size() ? s.words[index].text : "";
  if (relation != "=" && relation != "<" && relation != ">" && relation != "<=" && relation != ">=")
    return unexpected_word(s, index, "=, <, >, <=, >= or 'not applicable'");
  AXIOMETRY_TRY(const double number, read_number(s, index + 1));
  double tolerance = figure.tolerance.value_or(1e-9 * std::abs(number));
  std::size_t end = index + 2;
  if (relation == "=" && word_is(end, "within")) {
    AXIOMETRY_TRY(tolerance, read_number(s, end + 1));
    if (tolerance < 0.0) return unexpected_word(s, end + 1, "a number not below 0");
    end += 2;
  }
  if (end < s.words.size()) return unexpected_word(s, end, "the end of the line");
  const std::string stated(s.words[index + 1].text);
  c.expected =
      relation == "=" ? fmt::format("{} within {:.2g}", stated, tolerance) : fmt::format("{} {}", relation, stated);
  c.got = figure.value ? shown(*figure.value, tolerance) : "not applicable";
  if (!figure.value) return c;
  const double x = *figure.value;
  c.met = relation == "="    ? std::abs(x - number) <= tolerance
          : relation == "<"  ? x < number
          : relation == ">"  ? x > number
          : relation == "<=" ? x <= number
                             : x >= number;
  if (!c.met) c.difference = fmt::format("{:.3g}", x - number);
  return c;
}

/// gum validated [shortest] yes
Result<CaseComparison> check_validated(const Statement& s, const Subject& subject, const Budget& budget,
                                       const OutputSummary& out, int digits) {
  const bool shortest = subject.is("validated", "shortest");
  const bool yes = subject.next < s.words.size() && s.words[subject.next].is("yes");
  if (!yes && !(subject.next < s.words.size() && s.words[subject.next].is("no")))
    return unexpected_word(s, subject.next, "yes or no");
  if (subject.next + 1 < s.words.size()) return unexpected_word(s, subject.next + 1, "the end of the line");
  const auto v = uncertainty::validate(budget.interval, budget.standard_uncertainty,
                                       shortest ? out.shortest : out.symmetric, digits);
  const std::string got = fmt::format("{}, the ends are {:.1g} and {:.1g} apart, δ {:g}", v.holds() ? "yes" : "no",
                                      v.low, v.high, v.tolerance);
  return CaseComparison{s.words[0].at.line, expectation_text(s), yes ? "yes" : "no", got, {}, v.holds() == yes};
}

Result<CaseComparison> check_model_error(const Statement& s, const ModelStatements& said, ModelOutcome& outcome) {
  if (s.words.size() != 3 || !s.words[2].quoted) return unexpected_word(s, 2, "a \"text\" of the message");
  CaseComparison c{s.words[0].at.line, expectation_text(s), text::quoted(s.words[2].text), "a result", {}, false};
  const auto& law = outcome.law(said);
  const auto& trials = outcome.monte_carlo(said);
  if (!law) c.got = law.error().to_string();
  if (!trials && (law || c.got.find(s.words[2].text) == std::string::npos)) c.got = trials.error().to_string();
  c.met = (!law || !trials) && c.got.find(s.words[2].text) != std::string::npos;
  return c;
}

}  // namespace

Result<CaseComparison> check_model_expectation(const Statement& s, const ModelStatements& said, ModelOutcome& outcome) {
  if (s.words.size() > 1 && s.words[1].is("error")) return check_model_error(s, said, outcome);
  AXIOMETRY_TRY(const Subject subject, read_subject(s, said));
  const auto refused = [&s](const Error& error) {
    return CaseComparison{
        s.words[0].at.line, expectation_text(s), "a result", "the error: " + error.to_string(), {}, false};
  };
  const bool validated = subject.method == "gum" && (subject.is("validated") || subject.is("validated", "shortest"));
  if (subject.method == "gum" && !outcome.law(said)) return refused(outcome.law(said).error());
  if ((subject.method == "mcm" || validated) && !outcome.monte_carlo(said))
    return refused(outcome.monte_carlo(said).error());
  if (validated)
    return check_validated(s, subject, outcome.law(said)->outputs[subject.output],
                           outcome.monte_carlo(said)->outputs[subject.output], said.options.digits);
  AXIOMETRY_TRY(const Figure figure, subject.method == "mcm"
                                         ? trials_figure(s, subject, outcome.monte_carlo(said)->outputs[subject.output])
                                         : law_figure(s, subject, *outcome.law(said), said));
  return compare(s, subject.next, figure);
}

}  // namespace axiometry::app
