// SPDX-License-Identifier: Apache-2.0
//
// Tables with the targets across and one row per run.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/table/generic_draft.h"

namespace axiometry::formats::generic {
namespace {

/// The first row's numbers from column `from` on; empty when one of its cells is none.
std::vector<double> across(const Draft& draft, std::size_t from) {
  std::vector<double> numbers;
  const auto& row = draft.shape.rows.front();
  for (std::size_t c = from; c < row.size(); ++c) {
    const auto number = number_in(row[c], draft.shape.decimal_mark);
    if (!number) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

/// Whether the numbers below are readings at targets across: small beside their range, or close to them.
bool are_readings_below(const Draft& draft, std::size_t from, const std::vector<double>& targets, bool close) {
  const auto [least, largest] = std::ranges::minmax(targets);
  const double range = largest - least;
  constexpr double near = 0.01;
  constexpr double small = 0.05;
  for (std::size_t r = 1; r < draft.shape.rows.size(); ++r)
    for (std::size_t k = 0; k < targets.size(); ++k) {
      const auto x = number_in(draft.shape.rows[r][from + k], draft.shape.decimal_mark);
      if (x && std::abs(close ? *x - targets[k] : *x) > (close ? near : small) * range) return false;
    }
  return true;
}

/// 0 or 1, 2, 3, …
bool is_counting(const std::vector<double>& numbers) {
  if (numbers.front() != 0.0 && numbers.front() != 1.0) return false;
  for (std::size_t k = 1; k < numbers.size(); ++k)
    if (numbers[k] != numbers[k - 1] + 1.0) return false;
  return true;
}

/// Columns before the first target: at most three, with words or numbers of runs below.
std::optional<std::size_t> label_count(const Draft& draft) {
  constexpr std::size_t most = 3;
  for (std::size_t from = 0; from <= std::min(most, draft.shape.columns - 2); ++from) {
    const std::vector<double> targets = across(draft, from);
    if (targets.size() < 2 || !is_monotone(targets)) continue;
    return from;
  }
  return std::nullopt;
}

/// "Mittelwert auf" below "Lauf 1 auf" is no run.
void ask_about_computed_row(Draft& draft, std::size_t c) {
  bool any_numbered = false;
  for (std::size_t r = 1; r < draft.shape.rows.size(); ++r)
    any_numbered = any_numbered || head_of(draft.shape.rows[r][c]).run.has_value();
  for (std::size_t r = 1; r < draft.shape.rows.size(); ++r) {
    const Head head = head_of(draft.shape.rows[r][c]);
    if (head.role != HeadRole::ignored && (head.run || !any_numbered)) continue;
    return draft.ask("end", fmt::format("found the row {} among rows of runs; is it a run too, or a limit or a mean?",
                                        text::quoted(draft.shape.rows[r][c])));
  }
}

/// A few words that come back: "X" and "Y".
void ask_about_words(Draft& draft, std::size_t c, const ColumnFacts& facts) {
  constexpr std::size_t few = 4;
  const std::size_t kinds = facts.spellings.size();
  if (facts.numeric() || kinds < 2 || kinds > few || kinds * 2 > facts.words) return;
  std::string words;
  for (const std::string& word : facts.spellings) words += (words.empty() ? "" : ", ") + text::quoted(word);
  draft.ask("columns", fmt::format("found the words {} in {}; do they part axes, or tell readings left out?", words,
                                   draft.called(c)));
}

void decide_label(Draft& draft, std::size_t c) {
  const ColumnFacts facts = facts_of(draft.shape, 1)[c];
  const std::string& name = draft.shape.rows.front()[c];
  draft.column(c).name = name;
  const auto all = [&](auto predicate) {
    return !facts.spellings.empty() && std::ranges::all_of(facts.spellings, predicate);
  };
  if (may_number_axes(name, facts)) return ask_about_axes(draft, c, facts);
  if (facts.numeric() && facts.whole && facts.missing == 0) {
    draft.give_role(c, ImportRole::run, 0.85, "its whole numbers before the readings");
    draft.guess.profile.first_run = facts.least == 0.0 ? 0 : 1;
  } else if (all([](const std::string& s) { return direction_word(s).has_value(); })) {
    draft.give_role(c, ImportRole::direction, 0.9, "its words say directions");
  } else if (all([](const std::string& s) { return head_of(s).direction || head_of(s).run; })) {
    draft.give_role(c, ImportRole::label, 0.85, "its labels name runs or directions");
    for (std::size_t r = 1; r < draft.shape.rows.size(); ++r)
      if (head_of(draft.shape.rows[r][c]).run == std::size_t{0}) draft.guess.profile.first_run = 0;
    ask_about_computed_row(draft, c);
  } else {
    draft.give_role(c, ImportRole::ignore, 0.75, "nothing of it is needed");
    ask_about_words(draft, c, facts);
  }
}

void decide_across_units(Draft& draft, std::size_t labels, bool close) {
  ImportProfile& profile = draft.guess.profile;
  const Unit* target = draft.stated.target;
  const Unit* reading = draft.stated.reading;
  for (std::size_t c = 0; c < labels; ++c) {
    if (const Unit* unit = head_of(draft.shape.rows.front()[c]).unit; unit != nullptr) target = unit;
    for (std::size_t r = 1; r < draft.shape.rows.size(); ++r)
      if (const Unit* unit = head_of(draft.shape.rows[r][c]).unit; unit != nullptr) reading = unit;
  }
  if (close && reading == nullptr) reading = target;
  if (close && target == nullptr) target = reading;
  profile.target_unit = target;
  profile.reading_unit = reading;
  if (target != nullptr)
    draft.decide("target_unit", std::string(target->name), 0.9, "stated with the targets or above");
  if (reading != nullptr)
    draft.decide("reading_unit", std::string(reading->name), 0.9, "stated with the readings or above");
  if (target == nullptr) draft.ask("target_unit", "in which unit are the targets across the table?");
  if (reading == nullptr) draft.ask("reading_unit", "in which unit are the readings?");
}

void decide_across_rules(Draft& draft, std::size_t labels) {
  ImportProfile& profile = draft.guess.profile;
  bool every_direction = labels > 0;
  bool every_run = labels > 0;
  if (const auto c = draft.find(ImportRole::label))
    for (std::size_t r = 1; r < draft.shape.rows.size(); ++r) {
      const Head head = head_of(draft.shape.rows[r][*c]);
      every_direction = every_direction && head.direction;
      every_run = every_run && head.run;
    }
  else
    every_direction = every_run = false;
  if (draft.find(ImportRole::direction))
    profile.direction = DirectionRule::column;
  else if (every_direction)
    profile.direction = DirectionRule::names;
  if (profile.direction)
    draft.decide("direction", std::string(word_of(*profile.direction)), 0.9, "stated before the readings");
  else
    draft.ask("direction",
              "found rows of runs without a direction; from where was each approached: up, down, visits or "
              "run-parity?");
  profile.runs = every_run || draft.find(ImportRole::run) ? RunRule::column : RunRule::repetition;
  draft.decide("runs", std::string(word_of(profile.runs)), 0.85,
               profile.runs == RunRule::column ? "stated before the readings" : "nothing counts them");
}

}  // namespace

bool decide_transposed(Draft& draft) {
  if (draft.shape.rows.size() < 2 || !draft.shape.names.empty()) return false;
  const auto labels = label_count(draft);
  if (!labels) return false;
  const std::vector<double> targets = across(draft, *labels);
  const bool close = are_readings_below(draft, *labels, targets, true);
  const HeadRole corner = *labels > 0 ? head_of(draft.shape.rows.front()[*labels - 1]).role : HeadRole::unknown;
  const bool named = corner == HeadRole::target || corner == HeadRole::position;
  const bool small = are_readings_below(draft, *labels, targets, false);
  constexpr std::size_t enough = 3;
  if (!close && !small && !named) return false;
  if (!named && targets.size() < enough) return false;
  // "Soll;1;2;3" above targets that rise down the rows is a header of runs.
  if (is_counting(targets) && *labels == 1 && is_monotone(facts_of(draft.shape, 1).front().values)) return false;
  ImportProfile& profile = draft.guess.profile;
  profile.layout = TableLayout::transposed;
  profile.header_lines = 1;
  profile.columns.assign(*labels + 1, {});
  draft.decide("layout", "transposed", named ? 0.9 : 0.75, "the targets stand across, one row per run");
  for (std::size_t c = 0; c < *labels; ++c) decide_label(draft, c);
  profile.columns.back().role = close ? ImportRole::position : ImportRole::deviation;
  draft.decide(fmt::format("columns[{}].role", *labels), std::string(word_of(profile.columns.back().role)), 0.9,
               close ? "the numbers are close to the targets" : "the numbers are small beside the targets");
  decide_across_units(draft, *labels, close);
  decide_across_rules(draft, *labels);
  return true;
}

}  // namespace axiometry::formats::generic
