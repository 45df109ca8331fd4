// SPDX-License-Identifier: Apache-2.0
//
// Units, sign, directions and runs of a table with its targets in a column.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/series/sweep_directions.h"
#include "axiometry/formats/series/target_index.h"
#include "axiometry/formats/table/generic_draft.h"

namespace axiometry::formats::generic {
namespace {

bool is_reading(const ImportColumn& column) {
  return column.role == ImportRole::deviation || column.role == ImportRole::position;
}

std::vector<std::size_t> readings_of(const Draft& draft) {
  std::vector<std::size_t> found;
  for (std::size_t c = 0; c < draft.shape.columns; ++c)
    if (is_reading(draft.guess.profile.columns[c])) found.push_back(c);
  return found;
}

void decide_target_unit(Draft& draft, std::size_t target, std::span<const std::size_t> readings) {
  ImportProfile& profile = draft.guess.profile;
  const auto take = [&](const Unit* unit, double confidence, std::string reason) {
    profile.target_unit = unit;
    draft.decide("target_unit", std::string(unit->name), confidence, std::move(reason));
  };
  if (draft.heads[target].unit != nullptr) return take(draft.heads[target].unit, 0.95, "stated with the name");
  if (draft.stated.target != nullptr) return take(draft.stated.target, 0.9, "stated above the table");
  if (!readings.empty() && profile.columns[readings.front()].role == ImportRole::position) {
    const Unit* unit = draft.heads[readings.front()].unit;
    if (unit == nullptr) unit = draft.stated.reading;
    if (unit != nullptr) return take(unit, 0.85, "that of the measured positions");
  }
  draft.ask("target_unit", fmt::format("in which unit are the targets ({})?", draft.called(target)));
}

/// How deviations follow from a column of measured positions that is not read.
struct Comparison {
  double sign = 0.0;      ///< 1 or −1; 0: neither
  double farthest = 0.0;  ///< from measured minus target, native units
};

Comparison compare(const Draft& draft, std::size_t target, std::size_t position, std::size_t deviation,
                   const Unit& target_unit, const Unit& unit) {
  const auto &targets = draft.facts[target].values, &positions = draft.facts[position].values,
             &deviations = draft.facts[deviation].values;
  const double per_position = deviation_per_position(target_unit.kind);
  double largest = 0.0;
  double plus = 0.0;
  double minus = 0.0;
  for (std::size_t k = 0; k < targets.size(); ++k) {
    if (std::isnan(targets[k]) || std::isnan(positions[k]) || std::isnan(deviations[k])) continue;
    const double difference = position_in(target_unit, positions[k] - targets[k]).in_native() * per_position;
    const double stated = deviation_in(unit, deviations[k]).in_native();
    largest = std::max(largest, std::abs(difference));
    plus = std::max(plus, std::abs(stated - difference));
    minus = std::max(minus, std::abs(stated + difference));
  }
  // Both columns are rounded to some digit of theirs: a tenth of the largest deviation tells the sign all the same.
  constexpr double rounding = 0.1;
  if (plus <= rounding * largest && largest > 0.0) return {1.0, plus};
  if (minus <= rounding * largest && largest > 0.0) return {-1.0, minus};
  return {0.0, plus};
}

std::optional<std::size_t> positions_beside(const Draft& draft, std::size_t target) {
  for (std::size_t c = 0; c < draft.shape.columns; ++c)
    if (draft.guess.profile.columns[c].role == ImportRole::ignore && is_close_to(draft.facts[c], draft.facts[target]))
      return c;
  return std::nullopt;
}

/// The only unit in which deviations are measured minus target.
const Unit* unit_by_positions(const Draft& draft, std::size_t target, std::size_t position, std::size_t deviation) {
  const Unit* found = nullptr;
  const Unit& target_unit = *draft.guess.profile.target_unit;
  for (const Unit& unit : units()) {
    if (unit.kind != target_unit.kind || compare(draft, target, position, deviation, target_unit, unit).sign == 0.0)
      continue;
    if (found != nullptr) return nullptr;
    found = &unit;
  }
  return found;
}

void decide_reading_unit(Draft& draft, std::size_t target, std::span<const std::size_t> readings) {
  ImportProfile& profile = draft.guess.profile;
  const auto take = [&](const Unit* unit, double confidence, std::string reason) {
    profile.reading_unit = unit;
    draft.decide("reading_unit", std::string(unit->name), confidence, std::move(reason));
  };
  const std::size_t first = readings.front();
  const Unit* unit = draft.heads[first].unit;
  for (std::size_t c : readings)
    if (draft.heads[c].unit != nullptr && draft.heads[c].unit != unit) draft.column(c).unit = draft.heads[c].unit;
  if (unit != nullptr) return take(unit, 0.95, "stated with the name");
  if (draft.stated.reading != nullptr) return take(draft.stated.reading, 0.9, "stated above the table");
  if (profile.target_unit != nullptr) {
    if (profile.columns[first].role == ImportRole::position)
      return take(profile.target_unit, 0.85, "measured positions have the unit of their targets");
    if (const auto position = positions_beside(draft, target))
      if (const Unit* fitting = unit_by_positions(draft, target, *position, first))
        return take(fitting, 0.9, fmt::format("in no other they are {} minus target", draft.called(*position)));
  }
  draft.ask("reading_unit", fmt::format("in which unit are the readings ({}, up to {:.6g})?", draft.called(first),
                                        draft.facts[first].magnitude()));
}

/// A unit that is a thousand times too large shows: no axis that is tested departs by a hundredth of its way, which is
/// a millimetre or a degree at least. One a thousand times too small shows where readings differ by less than 0.05 µm
/// over 100 mm or more: a machine of steel grows by as much in 0.05 K. Between these a column of measured positions
/// tells.
void doubt_reading_unit(Draft& draft, std::size_t target, std::span<const std::size_t> readings) {
  constexpr double share_of_way = 0.01, least_way = 1.0;        // mm or °
  constexpr double least_departure = 5e-5, far_enough = 100.0;  // mm
  const ImportProfile& profile = draft.guess.profile;
  if (profile.target_unit == nullptr || profile.reading_unit == nullptr) return;
  const double way = position_in(*profile.target_unit, draft.facts[target].range()).in_native();
  const auto position = positions_beside(draft, target);
  for (const std::size_t c : readings) {
    const Unit& unit = profile.columns[c].unit != nullptr ? *profile.columns[c].unit : *profile.reading_unit;
    if (profile.columns[c].role != ImportRole::deviation || unit.kind != profile.target_unit->kind) continue;
    const double range = draft.facts[c].range();
    const double departs = deviation_in(unit, range).in_native() / deviation_per_position(unit.kind);
    const bool too_far = departs >= std::max(least_way, share_of_way * way);
    const bool too_true =
        unit.kind == AxisKind::linear && way >= far_enough && departs > 0.0 && departs < least_departure;
    const Unit* by_positions = position ? unit_by_positions(draft, target, *position, c) : nullptr;
    if (!too_far && !too_true && by_positions != nullptr && by_positions != &unit)
      return draft.ask("reading_unit",
                       fmt::format("found readings ({}) that are the difference of {} and target in {}, "
                                   "not in {}; in which unit are they?",
                                   draft.called(c), draft.called(*position), by_positions->symbol, unit.symbol));
    if (!too_far && !too_true) continue;
    return draft.ask("reading_unit",
                     fmt::format("found readings that differ by {:.6g} {} over {:.6g} {} of targets; are "
                                 "they really in {} ({})?",
                                 range, unit.symbol, draft.facts[target].range(), profile.target_unit->symbol,
                                 unit.symbol, draft.called(c)));
  }
}

void ask_sign(Draft& draft, std::size_t reading) {
  draft.ask("sign", fmt::format("found {}, whose name leaves its sign open; is it actual minus target (1) or target "
                                "minus actual, as a correction is (-1)?",
                                draft.called(reading)));
}

void decide_sign(Draft& draft, std::size_t target, std::size_t reading) {
  ImportProfile& profile = draft.guess.profile;
  if (profile.columns[reading].role != ImportRole::deviation) return;
  const auto position = positions_beside(draft, target);
  if (position && profile.target_unit != nullptr && profile.reading_unit != nullptr &&
      profile.target_unit->kind == profile.reading_unit->kind) {
    const Comparison found = compare(draft, target, *position, reading, *profile.target_unit, *profile.reading_unit);
    profile.sign = found.sign < 0.0 ? -1.0 : 1.0;
    if (found.sign != 0.0)
      return draft.decide("sign", found.sign > 0.0 ? "1" : "-1", 0.95,
                          fmt::format("the deviations are {} {} target", draft.called(*position),
                                      found.sign > 0.0 ? "minus" : "taken from the"));
    return draft.decide(
        "sign", "1", 0.5,
        fmt::format("the deviations are not {} minus target: they differ by up to {:.4g} {}; a gain or an "
                    "offset may have been taken out, or they are corrected",
                    draft.called(*position), found.farthest, deviation_unit(profile.target_unit->kind)));
  }
  if (draft.heads[reading].sign_open) return ask_sign(draft, reading);
  if (!draft.heads[reading].target_minus_actual) return;
  profile.sign = -1.0;
  draft.decide("sign", "-1", 0.9, "its name says target minus actual");
}

/// A column that is not read, but tells that the rows stand from the last to the first: times of an unknown unit, or a
/// running number.
std::optional<std::size_t> counts_backwards(const Draft& draft) {
  for (std::size_t c = 0; c < draft.shape.columns; ++c) {
    const HeadRole head = draft.heads[c].role;
    if (draft.guess.profile.columns[c].role == ImportRole::ignore &&
        (head == HeadRole::time || head == HeadRole::index) && is_newest_first(draft.facts[c].values))
      return c;
  }
  return std::nullopt;
}

struct Sequence {
  Motion motion;
  std::vector<double> runs;  ///< of the run column, by row; empty without one
};

bool lists_newest_first(const Draft& draft) {
  const auto time = draft.find(ImportRole::time);
  if (!time) return false;
  std::vector<double> times;
  for (const auto& row : draft.shape.rows)
    times.push_back(clock_seconds(row[*time], draft.shape.decimal_mark).value_or(std::nan("")));
  return is_newest_first(times);
}

Sequence sequence_of(const Draft& draft, std::size_t target) {
  TargetIndex index;
  std::vector<std::uint32_t> ranks;
  for (double x : draft.facts[target].values) {
    if (std::isnan(x)) return {};
    ranks.push_back(index.number(x));
  }
  for (std::uint32_t& rank : ranks) rank = index.ranks()[rank];
  const bool turn = lists_newest_first(draft);
  if (turn) std::ranges::reverse(ranks);
  Sequence sequence{motion_of(ranks, index.targets().size()), {}};
  if (turn) std::ranges::reverse(sequence.motion.directions);
  if (const auto run = draft.find(ImportRole::run)) sequence.runs = draft.facts[*run].values;
  return sequence;
}

/// Whether every run goes one way and the next one back; then runs are counted one way each.
struct Parity {
  bool alternates = false;
  Direction first = Direction::up;
};

Parity parity_of(std::span<const double> runs, std::span<const Direction> directions, double first_run) {
  std::map<double, std::set<Direction>> of_run;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    if (std::isnan(runs[k])) return {};
    of_run[runs[k]].insert(directions[k]);
  }
  if (of_run.size() < 2) return {};
  const auto parity = [&](double run) { return std::fmod(run - first_run, 2.0) != 0.0; };
  const auto& [run, ways] = *of_run.begin();
  Parity result{true, *ways.begin()};
  if (parity(run)) result.first = result.first == Direction::up ? Direction::down : Direction::up;
  for (const auto& [r, w] : of_run) {
    const bool first = *w.begin() == result.first;
    if (w.size() != 1 || first == parity(r)) return {};
  }
  return result;
}

double first_run_of(const Draft& draft) {
  const auto run = draft.find(ImportRole::run);
  return run && draft.facts[*run].numbers > 0 && draft.facts[*run].least == 0.0 ? 0.0 : 1.0;
}

void decide_direction(Draft& draft, const Sequence& sequence, std::span<const std::size_t> readings) {
  ImportProfile& profile = draft.guess.profile;
  const auto take = [&](DirectionRule rule, double confidence, std::string reason) {
    profile.direction = rule;
    draft.decide("direction", std::string(word_of(rule)), confidence, std::move(reason));
  };
  const auto fixed = [&](std::size_t c) { return profile.columns[c].direction.has_value(); };
  if (draft.find(ImportRole::direction)) {
    for (std::size_t c : readings) draft.column(c).direction.reset();
    return take(DirectionRule::column, 0.95, "a column says it");
  }
  const Motion& motion = sequence.motion;
  const bool both_ways = motion.is_sweeps && motion.has_up && motion.has_down;
  if (readings.size() == 1 && fixed(readings.front()) && both_ways)
    return draft.ask("direction", fmt::format("found {} named for one direction and targets that rise and fall; from "
                                              "where was each target approached: up, down, motion or names?",
                                              draft.called(readings.front())));
  if (!readings.empty() && std::ranges::all_of(readings, fixed))
    return take(DirectionRule::names, 0.95, "the names of the readings say it");
  if (readings.size() == 1 && both_ways) {
    if (const auto falling = draft.find(ImportRole::time) ? std::nullopt : counts_backwards(draft))
      return draft.ask("direction",
                       fmt::format("found {} falling from row to row: do the rows stand from the last to the first? "
                                   "Then turn them round; if they stand in the order of the measurement: motion",
                                   draft.called(*falling)));
    const Parity parity = parity_of(sequence.runs, motion.directions, first_run_of(draft));
    if (!parity.alternates)
      return take(DirectionRule::motion, 0.85, "the targets rise and fall in the order of the rows");
    profile.first_direction = parity.first;
    return take(DirectionRule::run_parity, 0.85,
                fmt::format("runs go {} and {} in turn", parity.first == Direction::up ? "up" : "down",
                            parity.first == Direction::up ? "down" : "up"));
  }
  const std::string found = !motion.is_sweeps ? "no order of sweeps along the axis"
                            : readings.size() != 1
                                ? "several columns of readings without a direction in their names"
                                : fmt::format("targets that only {}", motion.has_up ? "rise" : "fall");
  draft.ask("direction", fmt::format("found no column of directions and {}; from where was each target approached: up, "
                                     "down, motion, visits or run-parity?",
                                     found));
}

/// "X aller" beside "Passage 1 aller": a run, or computed from the runs. "hin" beside "hin.1" is a name that a program
/// made unique.
void ask_about_unnumbered(Draft& draft, std::span<const std::size_t> readings) {
  const auto numbered = [&](std::size_t c) { return draft.column(c).run.has_value(); };
  if (std::ranges::none_of(readings, numbered)) return;
  for (const std::size_t c : readings) {
    const bool repeated = std::ranges::any_of(readings, [&](std::size_t other) {
      return numbered(other) && draft.shape.names[other].starts_with(draft.shape.names[c]);
    });
    if (numbered(c) || repeated) continue;
    return draft.ask("columns", fmt::format("found {} beside numbered runs; is it a run too, or a limit or a mean?",
                                            draft.called(c)));
  }
}

/// Numbers of runs in names of columns, from 1; or counted, where several columns of one direction have none.
bool number_columns(Draft& draft, std::span<const std::size_t> readings) {
  const auto numbered = [&](std::size_t c) { return draft.column(c).run.has_value(); };
  std::map<int, std::size_t> per_direction;
  for (std::size_t c : readings)
    ++per_direction[draft.column(c).direction ? static_cast<int>(*draft.column(c).direction) : 2];
  const bool several = std::ranges::any_of(per_direction, [](const auto& p) { return p.second > 1; });
  if (std::ranges::all_of(readings, numbered)) {
    if (readings.size() == 1 && !draft.column(readings.front()).direction) return false;
    const bool from_zero = std::ranges::any_of(readings, [&](std::size_t c) { return *draft.column(c).run == 0; });
    for (std::size_t c : readings) *draft.column(c).run += from_zero;
    return true;
  }
  ask_about_unnumbered(draft, readings);
  for (std::size_t c : readings) draft.column(c).run.reset();
  if (!several) return false;
  std::map<int, std::size_t> next;
  for (std::size_t c : readings)
    draft.column(c).run = ++next[draft.column(c).direction ? static_cast<int>(*draft.column(c).direction) : 2];
  return true;
}

/// Directions by row as far as they are known without reading the file.
std::vector<Direction> directions_by_row(const Draft& draft, const Sequence& sequence) {
  if (draft.guess.profile.direction == DirectionRule::motion) return sequence.motion.directions;
  std::vector<Direction> directions;
  if (const auto c = draft.find(ImportRole::direction))
    for (const auto& row : draft.shape.rows) {
      const auto direction = direction_word(row[*c]);
      if (!direction) return {};
      directions.push_back(*direction);
    }
  return directions;
}

void decide_runs(Draft& draft, const Sequence& sequence, std::span<const std::size_t> readings) {
  ImportProfile& profile = draft.guess.profile;
  const auto take = [&](RunRule rule, double confidence, std::string reason) {
    profile.runs = rule;
    draft.decide("runs", std::string(word_of(rule)), confidence, std::move(reason));
  };
  if (number_columns(draft, readings)) {
    profile.layout = TableLayout::wide;
    return take(RunRule::names, 0.9, "one column per run");
  }
  profile.first_run = static_cast<std::size_t>(first_run_of(draft));
  if (!draft.find(ImportRole::run)) return take(RunRule::repetition, 0.85, "no column counts them");
  const std::vector<Direction> directions = directions_by_row(draft, sequence);
  if (!directions.empty() && !sequence.runs.empty() &&
      parity_of(sequence.runs, directions, first_run_of(draft)).alternates)
    return take(RunRule::repetition, 0.85, "the column counts runs one way each, so approaches count themselves");
  take(RunRule::column, 0.95, fmt::format("a column counts them from {}", profile.first_run));
}

}  // namespace

void decide_units(Draft& draft) {
  const auto target = draft.find(ImportRole::target);
  const std::vector<std::size_t> readings = readings_of(draft);
  if (!target || readings.empty()) return;
  decide_target_unit(draft, *target, readings);
  decide_reading_unit(draft, *target, readings);
  doubt_reading_unit(draft, *target, readings);
  if (readings.size() == 1) return decide_sign(draft, *target, readings.front());
  const auto open = std::ranges::find_if(
      readings, [&](std::size_t c) { return draft.heads[c].sign_open && draft.heads[c].role == HeadRole::unknown; });
  if (open != readings.end()) ask_sign(draft, *open);
}

void decide_rules(Draft& draft) {
  const auto target = draft.find(ImportRole::target);
  const std::vector<std::size_t> readings = readings_of(draft);
  if (!target || readings.empty()) return;
  const Sequence sequence = sequence_of(draft, *target);
  decide_direction(draft, sequence, readings);
  decide_runs(draft, sequence, readings);
  draft.decide("layout", std::string(word_of(draft.guess.profile.layout)), 0.9,
               draft.guess.profile.layout == TableLayout::wide ? "one column per run" : "one row per approach");
}

}  // namespace axiometry::formats::generic
