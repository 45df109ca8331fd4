// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/cases/case_expectation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/language/language.h"

namespace axiometry::app {
namespace {

using iso230_2::AxisParameters;
using iso230_2::PositionResult;

CaseComparison unmet(const Statement& s, std::string expected, std::string got, std::string difference = {}) {
  return {s.words[0].at.line, expectation_text(s), std::move(expected), std::move(got), std::move(difference), false};
}

/// What came is what was expected.
CaseComparison met(const Statement& s, std::string got, std::string expected = {}) {
  return {s.words[0].at.line, expectation_text(s), expected.empty() ? got : std::move(expected), got, {}, true};
}

/// A quantity that a line names, and how many words the name took.
struct Named {
  std::optional<Deviation> value;
  std::size_t next = 0;
};

Result<Named> named_parameter(const Statement& s, std::size_t index, std::string_view key,
                              const std::optional<AxisParameters>& from) {
  const iso230_2::ParameterInfo* info = iso230_2::find_parameter(key);
  if (info == nullptr)
    return unexpected_word(s, index,
                           "a parameter (A, A_up, …, B_mean, U_A, …), position, budget, corrected, gum, finding, "
                           "conforming, label or error");
  return Named{from ? *from.*(info->member) : std::nullopt, index + 1};
}

Result<Named> named_position(const Statement& s, const std::vector<PositionResult>& positions) {
  const auto number = s.words.size() > 2 ? parse_count(s.words[2].text) : std::nullopt;
  if (!number || *number < 1 || *number > positions.size())
    return unexpected_word(s, 2, fmt::format("the number of a target from 1 to {}", positions.size()));
  for (const auto& quantity : iso230_2::position_quantities)
    if (s.words.size() > 3 && s.words[3].is(quantity.key)) return Named{positions[*number - 1].*quantity.member, 4};
  return unexpected_word(s, 3, "mean_up, mean_down, mean, reversal, s_up, s_down, R_up, R_down or R");
}

Result<Named> named_contributor(const Statement& s, const std::optional<iso230_2::AnnexA>& annex) {
  constexpr std::string_view keys[] = {"device",   "misalignment", "m_machine", "m_device", "e_machine",
                                       "e_device", "eve",          "probing",   "station"};
  if (s.words.size() < 3 || std::ranges::find(keys, s.words[2].text) == std::end(keys))
    return unexpected_word(s, 2, fmt::format("a contributor: {}", fmt::join(keys, ", ")));
  Named named{std::nullopt, 3};
  if (!annex) return named;
  const auto row = std::ranges::find(annex->budget, s.words[2].text, &iso230_2::Contributor::key);
  if (row != annex->budget.end()) named.value = row->U;
  return named;
}

struct ComponentName {
  std::string_view key;
  Deviation iso230_2::PositionComponents::*member;
};
constexpr ComponentName component_names[] = {
    {"approaches", &iso230_2::PositionComponents::approaches},
    {"thermal", &iso230_2::PositionComponents::thermal},
    {"alignment", &iso230_2::PositionComponents::alignment},
    {"axis_resolution", &iso230_2::PositionComponents::axis_resolution},
    {"instrument", &iso230_2::PositionComponents::instrument},
    {"other", &iso230_2::PositionComponents::other},
};

std::optional<Deviation> u_or_U(const iso230_2::ExpandedUncertainty& x, const Word& word) {
  return word.is("u") ? x.u : x.U;
}

/// "gum position 3 up thermal", "gum position 3 mean U".
Result<Named> named_gum_position(const Statement& s, const std::optional<iso230_2::GumUncertainty>& gum) {
  const auto number = s.words.size() > 3 ? parse_count(s.words[3].text) : std::nullopt;
  if (!number || *number < 1 || (gum && *number > gum->positions.size()))
    return unexpected_word(s, 3, "the number of a target");
  if (s.words.size() < 5 || !(s.words[4].is("up") || s.words[4].is("down") || s.words[4].is("mean")))
    return unexpected_word(s, 4, "up, down or mean");
  const bool mean = s.words[4].is("mean");
  const bool total = s.words.size() > 5 && (s.words[5].is("u") || s.words[5].is("U"));
  const auto* component = s.words.size() > 5 ? std::ranges::find(component_names, s.words[5].text, &ComponentName::key)
                                             : std::end(component_names);
  if (!total && (mean || component == std::end(component_names)))
    return unexpected_word(
        s, 5, mean ? "u or U" : "u, U, approaches, thermal, alignment, axis_resolution, instrument or other");
  Named named{std::nullopt, 6};
  if (!gum) return named;
  const iso230_2::PositionUncertainty& position = gum->positions[*number - 1];
  if (mean) {
    if (position.mean) named.value = u_or_U(*position.mean, s.words[5]);
    return named;
  }
  const auto& parts = s.words[4].is("up") ? position.up : position.down;
  if (parts) named.value = total ? u_or_U(parts->total, s.words[5]) : *parts.*(component->member);
  return named;
}

/// "gum u_A", "gum U_A" and the positions.
Result<Named> named_gum(const Statement& s, const std::optional<iso230_2::GumUncertainty>& gum) {
  if (s.words.size() > 2 && s.words[2].is("position")) return named_gum_position(s, gum);
  const std::string_view name = s.words.size() > 2 ? s.words[2].text : "";
  const bool prefixed = name.starts_with("u_") || name.starts_with("U_");
  const auto* info = prefixed ? iso230_2::find_parameter(name.substr(2)) : nullptr;
  if (info == nullptr) return unexpected_word(s, 2, "u_A, U_A, …, U_B_mean or position");
  Named named{std::nullopt, 3};
  const auto* parameter = gum ? gum->find(info->key) : nullptr;
  if (parameter != nullptr) named.value = name.front() == 'u' ? parameter->uncertainty.u : parameter->uncertainty.U;
  return named;
}

Result<Named> named_quantity(const Statement& s, const iso230_2::Assessment& a) {
  if (s.words.size() < 2) return unexpected_word(s, 1, "what is expected");
  const Word& word = s.words[1];
  if (word.is("position")) return named_position(s, a.evaluation.positions);
  if (word.is("budget")) return named_contributor(s, a.annex_a);
  if (word.is("gum")) return named_gum(s, a.gum);
  if (word.is("corrected")) {
    const std::string_view key = s.words.size() > 2 ? s.words[2].text : "";
    const bool corrected = a.annex_a && a.annex_a->corrected;
    return named_parameter(s, 2, key, corrected ? std::optional(a.annex_a->corrected->parameters) : std::nullopt);
  }
  if (word.text.starts_with("U_"))
    return named_parameter(s, 1, word.text.substr(2), a.annex_a ? std::optional(a.annex_a->U) : std::nullopt);
  return named_parameter(s, 1, word.text, a.evaluation.parameters);
}

struct Comparison {
  std::string_view relation;
  double number = 0.0;  // native
  std::string stated;
  StatedTolerance tolerance;
};

/// "= 9.6 um", "<= 10 um", "= 9.6 um within 0.05 um", beginning at the word of this index.
Result<Comparison> read_comparison(const Statement& s, std::size_t index, const ExpectationContext& context) {
  constexpr std::string_view relations[] = {"=", "<", ">", "<=", ">="};
  if (index >= s.words.size() || std::ranges::find(relations, s.words[index].text) == std::end(relations))
    return unexpected_word(s, index, "=, <, >, <=, >= or 'not applicable'");
  Comparison comparison{s.words[index].text, 0.0, {}, context.tolerance};
  AXIOMETRY_TRY(const double number, read_number(s, index + 1));
  AXIOMETRY_TRY(const formats::Unit* unit, read_deviation_unit(s, index + 2, context.kind));
  comparison.number = formats::deviation_in(*unit, number).in_native();
  comparison.stated = fmt::format("{} {}", s.words[index + 1].text, s.words[index + 2].text);
  std::size_t end = index + 3;
  if (end < s.words.size() && s.words[end].is("within") && comparison.relation == "=") {
    AXIOMETRY_TRY(comparison.tolerance, read_tolerance(s, end + 1, context.kind));
    end += 3;
  }
  if (end < s.words.size()) return unexpected_word(s, end, "the end of the line");
  return comparison;
}

bool holds(double x, const Comparison& c) {
  if (c.relation == "<") return x < c.number;
  if (c.relation == ">") return x > c.number;
  if (c.relation == "<=") return x <= c.number;
  if (c.relation == ">=") return x >= c.number;
  return std::abs(x - c.number) <= c.tolerance.native;
}

Result<CaseComparison> check_quantity(const Statement& s, const OperationOutcome& outcome,
                                      const ExpectationContext& context) {
  AXIOMETRY_TRY(const Named named, named_quantity(s, outcome.assessment));
  const std::string got =
      named.value ? fmt::format("{} {}", format_exact(named.value->in_native()), deviation_unit_key(context.kind))
                  : std::string("not applicable");
  const bool not_applicable =
      s.words.size() == named.next + 2 && s.words[named.next].is("not") && s.words[named.next + 1].is("applicable");
  if (not_applicable) return named.value ? unmet(s, "not applicable", got) : met(s, got);
  AXIOMETRY_TRY(const Comparison comparison, read_comparison(s, named.next, context));
  const bool equality = comparison.relation == "=";
  const std::string expected = equality ? fmt::format("{} within {}", comparison.stated, comparison.tolerance.stated)
                                        : fmt::format("{} {}", comparison.relation, comparison.stated);
  if (!named.value) return unmet(s, expected, got);
  if (holds(named.value->in_native(), comparison)) return met(s, got, expected);
  const double difference = named.value->in_native() - comparison.number;
  return unmet(s, expected, got, fmt::format("{:.3g} {}", difference, deviation_unit_key(context.kind)));
}

/// Of ISO 230-2:2014, and what findings about files and diagonals have in its place.
bool is_known_clause(std::string_view clause) {
  constexpr std::string_view known[] = {"1",       "2",       "4.1",   "4.2",   "4.3",   "5.1",   "5.2",     "5.3",
                                        "5.3.1",   "5.3.2",   "5.3.3", "5.3.4", "5.3.5", "6.1",   "6.2",     "6.3",
                                        "7",       "8",       "8.1",   "8.2",   "8.2.1", "8.2.2", "8.2.3",   "8.2.4",
                                        "A.2.1",   "A.2.2",   "A.2.3", "A.2.4", "A.2.5", "A.2.6", "Annex A", "Annex B",
                                        "Annex C", "Annex D", "230-6", "source"};
  constexpr unsigned long long terms = 24;  // 3.1 to 3.24
  if (text::is_one_of(clause, known)) return true;
  const auto term = clause.starts_with("3.") ? parse_count(clause.substr(2)) : std::nullopt;
  return term && *term >= 1 && *term <= terms;
}

/// The first word, of three letters or more, that no message of the program has, nor as a part: where it is not to be
/// found, it never is, whatever comes.
std::optional<std::string> word_of_no_message(std::string_view words) {
  static const std::string messages = [] {
    std::string all;
    for (const language::Phrase& phrase : language::phrases(language::Language::german))
      all += text::to_lower(phrase.english) + '\n';
    return all;
  }();
  constexpr std::size_t letters_least = 3;
  std::string word;
  for (const char c : text::to_lower(words) + ' ') {
    if (c >= 'a' && c <= 'z') {
      word += c;
      continue;
    }
    if (word.size() >= letters_least && !messages.contains(word)) return word;
    word.clear();
  }
  return std::nullopt;
}

/// expect [no] finding [CLAUSE] [SEVERITY] ["TEXT"]
Result<CaseComparison> check_finding(const Statement& s, const OperationOutcome& outcome) {
  const bool wanted = !s.words[1].is("no");
  std::size_t index = wanted ? 2 : 3;
  std::string_view clause, severity, part;
  const auto is_severity = [](const Word& w) { return w.is("departure") || w.is("missing") || w.is("note"); };
  if (index < s.words.size() && !s.words[index].quoted && !is_severity(s.words[index])) clause = s.words[index++].text;
  // Annexes are cited in two words: Annex B.
  std::string annex;
  if (clause == "Annex" && index < s.words.size()) clause = annex = fmt::format("Annex {}", s.words[index++].text);
  if (!wanted && !clause.empty() && !is_known_clause(clause))
    return unexpected_word(s, index - 1,
                           "a clause of ISO 230-2:2014 that findings cite, such as 5.3.2, 'Annex B' or source");
  if (index < s.words.size() && is_severity(s.words[index])) severity = s.words[index++].text;
  if (index < s.words.size() && s.words[index].quoted) {
    if (s.words[index].text.empty()) return unexpected_word(s, index, "a \"text\" that is not empty");
    part = s.words[index].text;
    if (const auto strange = word_of_no_message(part); !wanted && strange)
      return unexpected_word(s, index, fmt::format("words that messages have, not {}", text::quoted(*strange)));
    ++index;
  }
  if (index < s.words.size()) return unexpected_word(s, index, "departure, missing, note or a \"text\"");
  const auto& findings = outcome.assessment.findings;
  const auto match = std::ranges::find_if(findings, [&](const iso230_2::Finding& f) {
    return (clause.empty() || f.clause == clause) &&
           (severity.empty() || severity == iso230_2::severity_name(f.severity)) &&
           text::to_lower(f.message).contains(text::to_lower(part));
  });
  if (wanted && match == findings.end()) {
    std::vector<std::string> all;
    for (const auto& f : findings) all.push_back(fmt::format("{} {}", f.clause, iso230_2::severity_name(f.severity)));
    return unmet(s, "such a finding", all.empty() ? "no finding" : fmt::format("only {}", fmt::join(all, ", ")));
  }
  if (!wanted && match != findings.end())
    return unmet(s, "no such finding", fmt::format("{}: {}", match->clause, match->message));
  return met(s, wanted ? "such a finding" : "no such finding");
}

Result<CaseComparison> check_conforming(const Statement& s, const OperationOutcome& outcome) {
  const bool yes = s.words.size() == 3 && s.words[2].is("yes");
  if (!yes && !(s.words.size() == 3 && s.words[2].is("no"))) return unexpected_word(s, 2, "yes or no");
  if (outcome.assessment.conforming() == yes) return met(s, yes ? "yes" : "no");
  return unmet(s, yes ? "yes" : "no", yes ? "no: " + outcome.assessment.findings.front().message : "yes");
}

Result<CaseComparison> check_label(const Statement& s, const OperationOutcome& outcome) {
  if (s.words.size() != 3 || !(s.words[2].quoted || s.words[2].is("none")))
    return unexpected_word(s, 2, "a \"text\" or none");
  const std::string_view expected = s.words[2].quoted ? s.words[2].text : "";
  if (outcome.assessment.label == expected) return met(s, text::quoted(expected));
  return unmet(s, text::quoted(expected), text::quoted(outcome.assessment.label));
}

Result<CaseComparison> check_error(const Statement& s, const Result<OperationOutcome>& outcome) {
  if (s.words.size() != 3 || !s.words[2].quoted || s.words[2].text.empty())
    return unexpected_word(s, 2, "a \"text\" of the message");
  if (outcome) return unmet(s, "an error", "a result");
  const std::string message = outcome.error().to_string();
  if (message.find(s.words[2].text) != std::string::npos) return met(s, message);
  return unmet(s, text::quoted(s.words[2].text), message);
}

}  // namespace

std::string expectation_text(const Statement& statement) {
  return std::string(text::trim(statement.text.substr(statement.words[0].text.size())));
}

Result<StatedTolerance> read_tolerance(const Statement& statement, std::size_t index, AxisKind kind) {
  AXIOMETRY_TRY(const double number, read_number(statement, index));
  if (number < 0.0) return unexpected_word(statement, index, "a number not below 0");
  AXIOMETRY_TRY(const formats::Unit* unit, read_deviation_unit(statement, index + 1, kind));
  return StatedTolerance{formats::deviation_in(*unit, number).in_native(),
                         fmt::format("{} {}", statement.words[index].text, statement.words[index + 1].text)};
}

Result<CaseComparison> check_expectation(const Statement& s, const Result<OperationOutcome>& outcome,
                                         const ExpectationContext& context) {
  if (s.words.size() < 2) return unexpected_word(s, 1, "what is expected");
  const Word& word = s.words[1];
  if (word.is("error")) return check_error(s, outcome);
  if (!outcome) return unmet(s, "a result", "the error: " + outcome.error().to_string());
  const bool no_finding = word.is("no") && s.words.size() > 2 && s.words[2].is("finding");
  if (word.is("finding") || no_finding) return check_finding(s, *outcome);
  if (word.is("conforming")) return check_conforming(s, *outcome);
  if (word.is("label")) return check_label(s, *outcome);
  return check_quantity(s, *outcome, context);
}

}  // namespace axiometry::app
