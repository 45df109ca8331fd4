// SPDX-License-Identifier: Apache-2.0
//
// Roles of columns: by their names first, then by their numbers.
#include "axiometry/formats/table/generic_draft.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/series/sweep_directions.h"
#include "axiometry/formats/series/target_index.h"
#include "axiometry/formats/text/name_words.h"

namespace axiometry::formats::generic {
namespace {

constexpr double by_name = 0.95;
constexpr double by_numbers = 0.75;

using Columns = std::vector<std::size_t>;

std::string list_of(const Draft& draft, const Columns& columns) {
  std::string list;
  for (std::size_t c : columns) list += (list.empty() ? "" : ", ") + draft.called(c);
  return list;
}

template <typename Predicate>
Columns columns_where(const Draft& draft, Predicate predicate) {
  Columns found;
  for (std::size_t c = 0; c < draft.shape.columns; ++c)
    if (predicate(c)) found.push_back(c);
  return found;
}

/// A column of runs in a wide table, by its name: its direction or its number.
bool names_a_run(const Head& head) {
  return (head.run || head.direction) && (head.role == HeadRole::run || head.role == HeadRole::deviation ||
                                          head.role == HeadRole::measured || head.role == HeadRole::position);
}

/// The targets in the order of the rows are those of sweeps, or every one comes as often as any other.
bool comes_back_evenly(const ColumnFacts& column) {
  TargetIndex index;
  std::vector<std::uint32_t> numbers;
  for (double x : column.values) numbers.push_back(index.number(x));
  std::vector<std::size_t> counts(index.targets().size());
  for (std::uint32_t& number : numbers) {
    ++counts[number];
    number = index.ranks()[number];
  }
  if (motion_of(numbers, counts.size()).is_sweeps) return true;
  return std::ranges::max(counts) == std::ranges::min(counts) && counts.front() > 1;
}

constexpr NameWord words_of_seconds[] = {{"s"},        {"sec"},     {"secs"},     {"second"},
                                         {"seconds"},  {"sek"},     {"sekunde"},  {"sekunden"},
                                         {"secondes"}, {"secondi"}, {"segundos"}, {"秒", WordPlace::anywhere}};

/// Whether approaches follow each other as they do on a machine: not in less than a second on the mean, as minutes and
/// days of a spreadsheet would, nor in more than an hour, as milliseconds would.
bool may_be_seconds(const ColumnFacts& column) {
  constexpr double shortest_s = 1.0, longest_s = 3600.0;
  if (column.numbers < 2) return true;
  const double step = column.range() / static_cast<double>(column.numbers - 1);
  return step >= shortest_s && step <= longest_s;
}

constexpr NameWord words_of_beams[] = {{"status"}, {"quality", WordPlace::anywhere}, {"signal"}, {"beam"}};

bool is_nameless(const Draft& draft, std::size_t c) { return draft.heads[c].role == HeadRole::unknown; }

class Roles {
 public:
  explicit Roles(Draft& draft) : draft_(draft), taken_(draft.shape.columns, false) {}

  void decide() {
    set_axes_aside();
    find_directions();
    find_target();
    if (!find_wide()) find_readings();
    find_runs();
    find_times();
    for (std::size_t c = 0; c < draft_.shape.columns; ++c) {
      if (taken_[c]) continue;
      draft_.give_role(c, ImportRole::ignore, by_numbers, "nothing of it is needed");
      if (!may_part_rows(c)) continue;
      const std::string_view question =
          draft_.facts[c].numeric() ? "found the numbers {} in {}; do they part axes, or tell readings left out?"
                                    : "found the words {} in {}; do they part axes, or tell readings left out?";
      draft_.ask("columns", fmt::format(fmt::runtime(question), spellings(c), draft_.called(c)));
    }
  }

 private:
  /// A few words or whole numbers that change from row to row under an unknown name, or one of the beam: "X" and "Y",
  /// "ok" and "lost", 1 and 0. Each row its own parts nothing.
  bool may_part_rows(std::size_t c) const {
    constexpr std::size_t few = 4;
    const ColumnFacts& f = draft_.facts[c];
    if (draft_.shape.names.empty() || draft_.shape.names[c].empty()) return false;
    if (!is_nameless(draft_, c) && !has_any_word(draft_.shape.names[c], words_of_beams)) return false;
    if (f.numeric()) {
      const std::size_t kinds = f.distinct + (f.missing > 0 ? 1 : 0);
      return f.whole && kinds >= 2 && kinds <= few && kinds < f.values.size();
    }
    if (f.words == 0) return false;
    if (clock_seconds(f.spellings.front(), draft_.shape.decimal_mark)) return false;
    const std::size_t kinds = f.spellings.size() + (f.missing > 0 ? 1 : 0);
    return kinds >= 2 && kinds <= few;
  }

  /// Before anything takes them for runs; but targets are below "Axis" too, where no other column holds any.
  void set_axes_aside() {
    if (draft_.shape.names.empty()) return;
    const Columns found = columns_where(draft_, [&](std::size_t c) {
      const Head& head = draft_.heads[c];
      return (head.role == HeadRole::unknown || head.role == HeadRole::index) && head.unit == nullptr &&
             may_number_axes(draft_.shape.names[c], draft_.facts[c]);
    });
    if (found.empty()) return;
    for (const std::size_t c : found) taken_[c] = true;
    const bool targets_elsewhere =
        !free_with(HeadRole::target).empty() || !free_with(HeadRole::position).empty() || !target_by_numbers().empty();
    for (const std::size_t c : found) {
      taken_[c] = targets_elsewhere;
      if (targets_elsewhere) ask_about_axes(draft_, c, draft_.facts[c]);
    }
  }

  void take(std::size_t c, ImportRole role, double confidence, std::string reason) {
    taken_[c] = true;
    draft_.give_role(c, role, confidence, std::move(reason));
  }

  bool free_numbers(std::size_t c) const { return !taken_[c] && draft_.facts[c].numeric(); }

  Columns free_with(HeadRole role) const {
    return columns_where(draft_, [&](std::size_t c) {
      return free_numbers(c) && draft_.heads[c].role == role && !names_a_run(draft_.heads[c]);
    });
  }

  void find_directions() {
    const auto says_direction = [&](std::size_t c) {
      const ColumnFacts& f = draft_.facts[c];
      return f.numbers == 0 && f.words > 0 &&
             std::ranges::all_of(f.spellings, [](const std::string& s) { return direction_word(s).has_value(); });
    };
    Columns found = columns_where(draft_, [&](std::size_t c) { return draft_.heads[c].role == HeadRole::direction; });
    const bool named = !found.empty();
    if (!named)
      found = columns_where(draft_, [&](std::size_t c) {
        return is_nameless(draft_, c) && (says_direction(c) || is_signs(draft_.facts[c]));
      });
    if (found.empty()) return;
    if (found.size() > 1)
      return draft_.ask("columns",
                        fmt::format("found the directions in {}; which of them is it?", list_of(draft_, found)));
    const std::size_t c = found.front();
    take(c, ImportRole::direction, named ? by_name : by_numbers, named ? "its name" : "its words say directions");
    const bool signs = draft_.facts[c].numeric() && draft_.facts[c].magnitude() == 1.0 &&
                       draft_.facts[c].distinct <= 2 && draft_.facts[c].least != 0.0;
    if (!says_direction(c) && !signs)
      draft_.ask("up_words", fmt::format("found the words {} in {}; which of them say up, and which down (down_words)?",
                                         spellings(c), draft_.called(c)));
  }

  std::string spellings(std::size_t c) const {
    std::string list;
    for (std::size_t k = 0; k < draft_.shape.rows.size() && k < 100; ++k) {
      const std::string word = text::quoted(draft_.shape.rows[k][c]);
      if (!list.contains(word)) list += (list.empty() ? "" : ", ") + word;
    }
    return list;
  }

  void find_target() {
    Columns found = free_with(HeadRole::target);
    double confidence = by_name;
    std::string reason = "its name";
    if (found.empty()) {
      found = free_with(HeadRole::position);
      std::erase_if(found, [&](std::size_t c) { return found.size() > 1 && !may_be_target(draft_.facts[c]); });
    }
    if (found.empty()) {
      found = target_by_numbers();
      confidence = by_numbers;
      reason = "its values come back in the order of a test";
    }
    if (found.empty())
      return draft_.ask("columns", "found no column whose few values come back; which column holds the targets?");
    if (found.size() > 1)
      return draft_.ask(
          "columns", fmt::format("found {} that may all be the targets; which of them is it?", list_of(draft_, found)));
    take(found.front(), ImportRole::target, confidence, std::move(reason));
    target_ = found.front();
  }

  Columns target_by_numbers() const {
    Columns found = columns_where(draft_, [&](std::size_t c) {
      return free_numbers(c) && is_nameless(draft_, c) && may_be_target(draft_.facts[c]) &&
             !is_signs(draft_.facts[c]) && comes_back_evenly(draft_.facts[c]);
    });
    const auto drop = [&](auto predicate) {
      Columns kept = found;
      std::erase_if(kept, predicate);
      if (!kept.empty()) found = kept;
    };
    drop([&](std::size_t c) { return draft_.facts[c].distinct * 2 > draft_.facts[c].numbers; });
    drop([&](std::size_t c) { return counts_rows(draft_.facts[c]); });
    drop([&](std::size_t c) { return counts_runs(draft_.facts[c]); });
    drop([&](std::size_t c) {  // a measured position beside its target
      return std::ranges::any_of(found, [&](std::size_t t) {
        return t != c && draft_.facts[t].distinct < draft_.facts[c].distinct &&
               is_close_to(draft_.facts[c], draft_.facts[t]);
      });
    });
    return found;
  }

  bool close_to_target(std::size_t c) const { return target_ && is_close_to(draft_.facts[c], draft_.facts[*target_]); }

  /// One column per run, or one per direction.
  bool find_wide() {
    const auto named = [&](auto accept) {
      return columns_where(draft_, [&](std::size_t c) {
        return !taken_[c] && (draft_.facts[c].words == 0 || draft_.facts[c].numeric()) &&
               accept(draft_.heads[c], draft_.shape.names);
      });
    };
    Columns found = named([](const Head& h, const auto&) {
      return names_a_run(h) || (h.role == HeadRole::unknown && h.direction.has_value());
    });
    std::erase_if(found, [&](std::size_t c) {  // "Run 1" is a reading, a column of whole run numbers is not
      return draft_.heads[c].role == HeadRole::run && !draft_.heads[c].run && !draft_.heads[c].direction;
    });
    const bool plain = !free_with(HeadRole::deviation).empty() || !free_with(HeadRole::measured).empty();
    if (found.empty() && !plain)
      found = named([](const Head& h, const auto&) { return h.role == HeadRole::unknown && h.run.has_value(); });
    if (found.empty() || plain) return false;
    const bool any_deviation =
        std::ranges::any_of(found, [&](std::size_t c) { return draft_.heads[c].role == HeadRole::deviation; });
    std::erase_if(found, [&](std::size_t c) {
      const HeadRole role = draft_.heads[c].role;
      return any_deviation && (role == HeadRole::measured || role == HeadRole::position);
    });
    for (std::size_t c : found) take_run_column(c);
    return true;
  }

  void take_run_column(std::size_t c) {
    const Head& head = draft_.heads[c];
    const bool stated = head.role == HeadRole::deviation;
    const ImportRole role = !stated && close_to_target(c) ? ImportRole::position : ImportRole::deviation;
    take(c, role, stated ? by_name : by_numbers,
         role == ImportRole::position ? "its name says the run, its numbers are close to the targets"
                                      : "its name says the run or the direction");
    draft_.column(c).direction = head.direction;
    draft_.column(c).run = head.run;
  }

  void find_readings() {
    if (!target_) return;
    Columns found = free_with(HeadRole::deviation);
    if (found.size() == 1) return take(found.front(), ImportRole::deviation, by_name, "its name");
    if (found.empty()) {
      found = free_with(HeadRole::measured);
      if (found.empty()) found = free_with(HeadRole::position);
      if (found.size() == 1) return take_measured(found.front());
    }
    if (found.empty()) return find_readings_by_numbers();
    draft_.ask("columns",
               fmt::format("found {} that may all be the readings; which of them is it?", list_of(draft_, found)));
  }

  void take_measured(std::size_t c) {
    constexpr double small = 0.1;  // of the range of the targets
    if (close_to_target(c)) return take(c, ImportRole::position, by_name, "its name, and numbers close to the targets");
    if (draft_.facts[c].magnitude() <= small * draft_.facts[*target_].range())
      return take(c, ImportRole::deviation, by_numbers, "its numbers are too small for measured positions");
    draft_.ask("columns", fmt::format("found {} named as measured, but neither close to the targets nor small; are "
                                      "they deviations or positions, and in which unit?",
                                      draft_.called(c)));
  }

  void find_readings_by_numbers() {
    const auto is_free = [&](std::size_t c) {
      const ColumnFacts& f = draft_.facts[c];
      return free_numbers(c) && is_nameless(draft_, c) && !counts_rows(f) && !counts_runs(f) && !is_signs(f);
    };
    const Columns positions = columns_where(draft_, [&](std::size_t c) { return is_free(c) && close_to_target(c); });
    const Columns deviations = columns_where(draft_, [&](std::size_t c) { return is_free(c) && !close_to_target(c); });
    if (positions.size() == 1 && deviations.empty())
      return take(positions.front(), ImportRole::position, by_numbers, "its numbers are close to the targets");
    if (positions.size() <= 1 && deviations.size() == 1)
      return take(deviations.front(), ImportRole::deviation, by_numbers, "no other column can hold the readings");
    Columns all = positions;
    all.insert(all.end(), deviations.begin(), deviations.end());
    draft_.ask("columns", all.empty() ? "found no column of readings; which column holds them?"
                                      : fmt::format("found {} that may all be the readings; which of them is it?",
                                                    list_of(draft_, all)));
  }

  void find_runs() {
    Columns found = columns_where(draft_, [&](std::size_t c) {
      return !taken_[c] && draft_.heads[c].role == HeadRole::run && draft_.facts[c].missing == 0 &&
             (draft_.facts[c].numeric() ? draft_.facts[c].whole : all_name_runs(c));
    });
    const bool named = !found.empty();
    if (!named)
      found = columns_where(draft_, [&](std::size_t c) {
        return free_numbers(c) && is_nameless(draft_, c) && counts_runs(draft_.facts[c]);
      });
    if (found.size() == 1)
      take(found.front(), ImportRole::run, named ? by_name : by_numbers, named ? "its name" : "it counts from 0 or 1");
    if (found.size() > 1)
      draft_.ask("columns",
                 fmt::format("found {} that may all count the runs; which of them does?", list_of(draft_, found)));
  }

  bool all_name_runs(std::size_t c) const {
    const ColumnFacts& f = draft_.facts[c];
    return f.words > 0 &&
           std::ranges::all_of(f.spellings, [](const std::string& s) { return head_of(s).run.has_value(); });
  }

  void find_times() {
    for (std::size_t c = 0; c < draft_.shape.columns; ++c) {
      if (taken_[c] || draft_.heads[c].role != HeadRole::time) continue;
      const std::string name = text::to_lower(draft_.shape.names[c]);
      const bool other_unit = name.contains("ms") || name.contains("min") || name.contains("[h");
      const bool readable = std::ranges::all_of(draft_.shape.rows, [&](const auto& row) {
        return is_missing(row[c]) || clock_seconds(row[c], draft_.shape.decimal_mark);
      });
      if (other_unit || !readable) continue;
      if (!draft_.facts[c].numeric() || has_any_word(name, words_of_seconds))
        return take(c, ImportRole::time, by_name, "its name");
      if (may_be_seconds(draft_.facts[c]))
        return take(c, ImportRole::time, by_numbers, "its name, which tells no unit, so taken for seconds");
      take(c, ImportRole::ignore, by_name, "times whose unit nobody tells, and which are hardly seconds");
    }
  }

  Draft& draft_;
  std::vector<bool> taken_;
  std::optional<std::size_t> target_;
};

}  // namespace

std::string Draft::called(std::size_t c) const {
  const std::string name = c < shape.names.size() ? shape.names[c] : std::string();
  return fmt::format("column {}{}", c + 1, name.empty() ? "" : " " + text::quoted(name));
}

std::optional<std::size_t> Draft::find(ImportRole role) const {
  const auto& columns = guess.profile.columns;
  const auto found = std::ranges::find(columns, role, &ImportColumn::role);
  if (found == columns.end()) return std::nullopt;
  return static_cast<std::size_t>(found - columns.begin());
}

void Draft::decide(std::string key, std::string value, double confidence, std::string reason) {
  guess.decisions.push_back({std::move(key), std::move(value), confidence, std::move(reason)});
}

void Draft::ask(std::string key, std::string question) {
  guess.questions.push_back({std::move(key), "", 0.0, std::move(question)});
}

void Draft::give_role(std::size_t c, ImportRole role, double confidence, std::string reason) {
  column(c).role = role;
  decide(fmt::format("columns[{}].role", c), fmt::format("{}: {}", called(c), word_of(role)), confidence,
         std::move(reason));
}

void decide_columns(Draft& draft) { Roles(draft).decide(); }

}  // namespace axiometry::formats::generic
