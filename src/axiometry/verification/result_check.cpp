// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/result_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "axiometry/verification/decision_check.h"

namespace axiometry::verification {
namespace {

using json::Kind;
using json::Value;

/// Of sums and products of a few doubles.
Interval roundoff_of(double x) { return Interval::of(1e-14) * magnitude(Interval::of(x)); }

/// A member per parameter.
void check_parameters(const Value* object, const ExactParameters& right, const Interval& rounding,
                      std::string_view where, Ledger& ledger) {
  if (object == nullptr || !object->is(Kind::object))
    return ledger.differ(std::string(where), "nothing", "12 parameters");
  for (std::size_t k = 0; k < right.size(); ++k)
    ledger.number([&] { return fmt::format("{} in {}", parameter_names[k].key, where); },
                  number_member(object, parameter_names[k].key), right[k], rounding);
}

struct PositionMember {
  std::string_view key;
  Exact (*value)(const ExactPosition&);
};

constexpr PositionMember position_members[] = {
    {"mean_up", [](const ExactPosition& p) { return p.up.mean; }},
    {"mean_down", [](const ExactPosition& p) { return p.down.mean; }},
    {"mean", [](const ExactPosition& p) { return p.mean(); }},
    {"reversal", [](const ExactPosition& p) { return p.reversal(); }},
    {"s_up", [](const ExactPosition& p) { return p.up.s; }},
    {"s_down", [](const ExactPosition& p) { return p.down.s; }},
    {"R_up", [](const ExactPosition& p) { return p.R_up(); }},
    {"R_down", [](const ExactPosition& p) { return p.R_down(); }},
    {"R", [](const ExactPosition& p) { return p.R(); }},
};

void check_positions(const Value* list, const Found& found, Ledger& ledger) {
  if (list == nullptr || !list->is(Kind::array)) return;
  if (list->items().size() != found.positions.size())
    ledger.differ("the number of positions", fmt::format("{}", list->items().size()),
                  fmt::format("{}", found.positions.size()));
  const std::size_t count = std::min(list->items().size(), found.positions.size());
  for (std::size_t i = 0; i < count; ++i) {
    const Value& row = list->items()[i];
    const ExactPosition& right = found.positions[i];
    const auto place = [i](std::string_view key) {
      return [i, key] { return fmt::format("{} of position {}", key, i + 1); };
    };
    ledger.number(place("target"), number_member(&row, "target"), right.target, Interval(0));
    ledger.number(place("n_up"), number_member(&row, "n_up"), Interval(static_cast<int>(right.up.count)), Interval(0));
    ledger.number(place("n_down"), number_member(&row, "n_down"), Interval(static_cast<int>(right.down.count)),
                  Interval(0));
    for (const PositionMember& member : position_members)
      ledger.number(place(member.key), number_member(&row, member.key), member.value(right), found.rounding);
  }
}

/// What is told for information: the smaller of both unidirectional repeatabilities.
void check_information(const Value* information, const Found& found, Ledger& ledger) {
  const Value* row = present_value(information, "smaller_repeatability");
  const auto stated = number_member(row, "value");
  if (!stated) return;
  const Exact& up = of(found.parameters, Parameter::R_up);
  const Exact& down = of(found.parameters, Parameter::R_down);
  const Exact right = up && down ? Exact(smaller(*up, *down)) : up ? up : down;
  ledger.number([] { return std::string("the smaller repeatability"); }, stated, right, found.rounding);
}

/// Of readings that were corrected the result has every one.
void check_readings(const Value* list, const Series& series, Ledger& ledger) {
  if (list == nullptr || !list->is(Kind::array)) return;
  std::size_t index = 0;
  for (const Value& row : list->items()) {
    const auto target = number_member(&row, "target");
    const auto run = number_member(&row, "run");
    const auto deviation = number_member(&row, "deviation");
    ++index;
    if (!target || !run || !deviation) continue;
    const auto direction = text_member(&row, "direction") == "down" ? Direction::down : Direction::up;
    const auto found = std::ranges::find(series.targets(), *target, &Position::in_native);
    if (found == series.targets().end() || !(*run >= 1.0 && *run <= static_cast<double>(series.run_count()))) {
      ledger.differ(fmt::format("reading {}", index), fmt::format("target {}, run {}", *target, *run),
                    "one that was measured");
      continue;
    }
    const auto reading = series.reading(static_cast<std::size_t>(found - series.targets().begin()), direction,
                                        static_cast<std::size_t>(*run) - 1);
    ledger.number([&] { return fmt::format("reading {}", index); }, deviation,
                  reading ? Exact(Interval::of(reading->in_native())) : std::nullopt, Interval(0));
  }
}

/// Σ u_k² of what the sources give a parameter; nothing without a budget.
std::optional<Interval> sum_of_squares(const Value* budget, std::string_view key) {
  const Value* rows = present_value(budget, "contributions");
  if (rows == nullptr || !rows->is(Kind::array)) return std::nullopt;
  Interval sum = 0;
  for (const Value& row : rows->items())
    if (const auto u = number_member(present_value(&row, "u"), key)) sum = sum + Interval::of(*u) * Interval::of(*u);
  return sum;
}

/// Of the GUM the value, u from the contributions of its sources, k from the degrees of freedom, and U = k u.
void check_gum(const Value* gum, const Value* budget, const Found& found, Ledger& ledger) {
  if (gum == nullptr || !gum->is(Kind::object)) return;
  for (std::size_t k = 0; k < found.parameters.size(); ++k) {
    const Value* own = present_value(gum, parameter_names[k].key);
    if (own == nullptr) continue;
    const auto place = [k](std::string_view what) {
      return [k, what] { return fmt::format("{} of {} by the GUM", what, parameter_names[k].key); };
    };
    ledger.number(place("value"), number_member(own, "value"), found.parameters[k], found.rounding);
    const auto u = number_member(own, "u"), U = number_member(own, "U"), factor = number_member(own, "k");
    if (const auto squares = sum_of_squares(budget, parameter_names[k].key); u && squares)
      ledger.number(place("u"), *u, root(*squares), Interval::of(1e-12) * magnitude(Interval::of(*u)));
    else
      ledger.compared += u.has_value();
    if (const auto nu = number_member(own, "nu_eff"); factor)
      ledger.number(place("k"), *factor, nu ? coverage_factor(*nu) : Interval(2), Interval::of(3e-6 * *factor));
    if (u && U && factor) ledger.number(place("U"), *U, Interval::of(*u) * Interval::of(*factor), roundoff_of(*U));
  }
}

/// Of a Monte Carlo run the value, the bias, and that intervals are such.
void check_monte_carlo(const Value* run, const Found& found, Ledger& ledger) {
  if (run == nullptr || !run->is(Kind::object)) return;
  for (std::size_t k = 0; k < found.parameters.size(); ++k) {
    const Value* own = present_value(run, parameter_names[k].key);
    if (own == nullptr) continue;
    const auto place = [k](std::string_view what) {
      return [k, what] { return fmt::format("{} of {} by Monte Carlo", what, parameter_names[k].key); };
    };
    ledger.number(place("value"), number_member(own, "value"), found.parameters[k], found.rounding);
    const auto mean = number_member(own, "mean"), bias = number_member(own, "bias");
    if (mean && bias && found.parameters[k])
      ledger.number(place("bias"), *bias, *found.parameters[k] - Interval::of(*mean),
                    found.rounding + roundoff_of(*mean));
    ledger.compared += mean.has_value() + number_member(own, "u").has_value();
    for (const std::string_view name : {"symmetric", "shortest"}) {
      const Value* ends = present_value(own, name);
      if (ends == nullptr || !ends->is(Kind::array) || ends->items().size() != 2) continue;
      ledger.compared += 2;
      const Value& lower = ends->items()[0];
      const Value& upper = ends->items()[1];
      if (lower.is(Kind::number) && upper.is(Kind::number) && lower.number() > upper.number())
        ledger.differ(place(name)(), fmt::format("{} to {}", lower.number(), upper.number()), "ends in their order");
    }
  }
}

void check_annex_a(const Value& uncertainty, Found& found, Ledger& ledger) {
  const Value* stated = present_value(&uncertainty, "annex_a");
  const Value* budget = present_value(&uncertainty, "annex_a_budget");
  if (stated == nullptr || budget == nullptr) return;
  found.annex_a = check_budget(*budget, found.parameters, found.positions, ledger);
  for (std::size_t k = 0; k < found.parameters.size(); ++k) {
    const Exact& U = found.annex_a.U[k];
    ledger.number([&] { return fmt::format("U of {} after Annex A", parameter_names[k].key); },
                  number_member(stated, parameter_names[k].key), U,
                  U ? magnitude(*U) * Interval::of(1e-14) : Interval(0));
  }
  const Value* corrected = present_value(budget, "corrected_repeatability");
  if (corrected == nullptr || !found.annex_a.U_eve) return;
  found.corrected_positions = without_environment(found.positions, *found.annex_a.U_eve, found.rounding);
  found.corrected = exact_parameters(found.corrected_positions);
  for (const Parameter p : {Parameter::R, Parameter::R_up, Parameter::R_down}) {
    const std::string_view key = key_of(p);
    ledger.number([&] { return fmt::format("{} corrected for the environment", key); }, number_member(corrected, key),
                  of(found.corrected, p), found.rounding);
  }
}

using Ends = std::pair<Interval, Interval>;

std::optional<Ends> ends_of(const Value* drawn) {
  const Value* ends = present_value(drawn, "symmetric");
  if (ends == nullptr || !ends->is(Kind::array) || ends->items().size() != 2) return std::nullopt;
  const Value& low = ends->items()[0];
  const Value& high = ends->items()[1];
  if (!low.is(Kind::number) || !high.is(Kind::number)) return std::nullopt;
  return Ends{Interval::of(low.number()), Interval::of(high.number())};
}

/// The lowest and the highest end of all hypotheses about the noise, and of each moved to the mean of the first, which
/// knows none. Of a run without hypotheses its own ends.
std::optional<Ends> envelope_of(const Value* drawn) {
  const Value* all = present_value(drawn, "by_hypothesis");
  if (all == nullptr || !all->is(Kind::object) || all->members().empty()) return ends_of(drawn);
  const auto first = number_member(&all->members().front().second, "mean");
  std::optional<Ends> envelope;
  for (const auto& [key, hypothesis] : all->members()) {
    const auto ends = ends_of(&hypothesis);
    const auto mean = number_member(&hypothesis, "mean");
    if (!ends || !mean || !first) return std::nullopt;
    const Interval shift = Interval::of(*first) - Interval::of(*mean);
    const Interval low = smaller(ends->first, ends->first + shift), high = larger(ends->second, ends->second + shift);
    envelope = envelope ? Ends{smaller(envelope->first, low), larger(envelope->second, high)} : Ends{low, high};
  }
  return envelope;
}

/// What stands with the results is what its method says: U and value ± U, or the interval that was drawn, widened to
/// hold the value.
void check_record(const Value& uncertainty, const Found& found, Ledger& ledger) {
  const Value* record = present_value(&uncertainty, "record");
  const std::string_view method = text_member(record, "method");
  const Value* stated = present_value(record, "parameters");
  for (std::size_t k = 0; k < found.parameters.size(); ++k) {
    const std::string_view key = parameter_names[k].key;
    const Value* row = present_value(stated, key);
    const Exact& y = found.parameters[k];
    if (row == nullptr || !y) continue;
    const auto check = [&](std::string_view member, const Exact& right) {
      const auto x = number_member(row, member);
      if (x && right)
        ledger.number([&] { return fmt::format("{} of {} of record", member, key); }, *x, *right,
                      found.rounding + roundoff_of(*x));
    };
    const Value* own = present_value(present_value(&uncertainty, method), key);
    Exact U = method == "annex_a" ? found.annex_a.U[k] : std::nullopt;
    if (const auto of_gum = number_member(own, "U"); method == "gum" && of_gum) U = Interval::of(*of_gum);
    if (U) {
      const auto of_gum = method == "gum" ? number_member(own, "u") : std::nullopt;
      check("u", of_gum ? Exact(Interval::of(*of_gum)) : Exact(*U / Interval(2)));
      check("U", U);
      check("low", *y - *U);
      check("high", *y + *U);
    }
    if (method != "monte_carlo") continue;
    if (const auto u = number_member(own, "u")) check("u", Interval::of(*u));
    if (const auto ends = envelope_of(own)) {
      // Moved to another mean an end may lie below 0, where no range and no largest value is.
      const bool has_a_sign = static_cast<Parameter>(k) == Parameter::B_mean;
      check("low", smaller(*y, has_a_sign ? ends->first : larger(ends->first, Interval(0))));
      check("high", larger(*y, ends->second));
    }
  }
}

/// The uncertainty that decides is one of those that the result states: u of a method, or half its U.
void check_deciding(const Value& row, const Value* uncertainty, Ledger& ledger) {
  const auto u = number_member(&row, "u");
  const std::string_view method = text_member(&row, "u_method");
  const std::string_view key = text_member(&row, "parameter");
  const Value* own = present_value(uncertainty, method);
  if (!u || own == nullptr) return;
  const Value* of_parameter = method == "annex_a" ? nullptr : present_value(own, key);
  const auto U = method == "annex_a" ? number_member(own, key) : number_member(of_parameter, "U");
  const auto standard = number_member(of_parameter, "u");
  const auto is_it = [&](const std::optional<double>& x, double factor) {
    return x && within(Interval::of(*u), Interval::of(*x) * Interval::of(factor), roundoff_of(*u));
  };
  ++ledger.figures;
  if (!is_it(standard, 1.0) && !is_it(U, 0.5))
    ledger.differ(fmt::format("u of {} against its limit", key), fmt::format("{}", *u),
                  fmt::format("that of {}", method));
  if (number_member(&row, "u_degrees_of_freedom") != number_member(of_parameter, "nu_eff"))
    ledger.differ(fmt::format("degrees of freedom of {} against its limit", key),
                  fmt::format("{}", number_member(&row, "u_degrees_of_freedom").value_or(0.0)),
                  fmt::format("those of {}", method));
}

}  // namespace

Found check_result(const Value& result, const Evidence& evidence, Ledger& ledger) {
  Found found;
  found.positions = exact_positions(evidence.series);
  found.parameters = exact_parameters(found.positions);
  found.rounding = rounding_of(evidence.series);
  check_parameters(present_value(&result, "parameters"), found.parameters, found.rounding, "the parameters", ledger);
  check_positions(present_value(&result, "positions"), found, ledger);
  check_information(present_value(&result, "information"), found, ledger);
  check_readings(present_value(&result, "readings"), evidence.series, ledger);
  const Value* uncertainty = present_value(&result, "uncertainty");
  if (uncertainty != nullptr) {
    check_annex_a(*uncertainty, found, ledger);
    check_gum(present_value(uncertainty, "gum"), present_value(uncertainty, "gum_budget"), found, ledger);
    check_monte_carlo(present_value(uncertainty, "monte_carlo"), found, ledger);
    check_record(*uncertainty, found, ledger);
  }
  const Value* decisions = present_value(&result, "tolerances");
  if (decisions == nullptr || !decisions->is(Kind::array)) return found;
  for (const Value& row : decisions->items()) check_deciding(row, uncertainty, ledger);
  check_decisions(*decisions, text_member(&result, "verdict"),
                  {found.parameters, found.rounding, evidence.drawn, found.positions,
                   text_member(present_value(uncertainty, "monte_carlo_run"), "type_a")},
                  ledger);
  return found;
}

}  // namespace axiometry::verification
