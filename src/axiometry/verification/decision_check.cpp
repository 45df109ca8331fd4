// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/decision_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/verification/budget.h"

namespace axiometry::verification {
namespace {

using json::Kind;
using json::Value;

constexpr std::string_view conforms = "conforms";
constexpr std::string_view rejected = "does not conform";
constexpr std::string_view undecided = "undecided";
constexpr std::string_view no_verdict = "not applicable";

/// The verdicts that are right: one, or two where the value cannot be told apart from a boundary.
struct Allowed {
  bool conforming = false;
  bool rejecting = false;
  bool open = false;

  bool holds(std::string_view verdict) const {
    return (conforming && verdict == conforms) || (rejecting && verdict == rejected) || (open && verdict == undecided);
  }
  std::string text() const {
    std::string all;
    for (const auto& [allowed, name] :
         {std::pair(conforming, conforms), std::pair(rejecting, rejected), std::pair(open, undecided)})
      if (allowed) all.append(all.empty() ? "" : " or ").append(name);
    return all;
  }
};

/// One row and what its decision is made from.
struct Case {
  Parameter parameter = Parameter::A;
  Interval y;  ///< value with its sign
  Interval T;
  double limit = 0.0;  ///< T as a double
  std::optional<double> u;
  std::optional<double> degrees_of_freedom;  ///< Student's t, else normal
  std::string_view method;
  std::string_view rule;

  std::string_view key() const { return key_of(parameter); }
  bool two_sided() const { return parameter == Parameter::B_mean; }
  bool has_scatter() const { return key().front() == 'A' || key().front() == 'R'; }
  bool has_root() const { return has_scatter(); }
  Interval magnitude_of_y() const { return magnitude(y); }
};

/// Whether y ≤ limit may be said, and whether the contrary.
struct Comparison {
  bool may_hold = false;
  bool may_fail = false;
};

/// Without roots the intervals tell, as long as the limit is a decimal. With roots what is a billionth above its limit
/// may count as at it; where rounding is more than that, also what is at it as above.
Comparison at_most_of(const Case& c, const Interval& limit, const Interval& rounding) {
  const Interval y = c.magnitude_of_y();
  if (!c.has_root()) return {possibly_at_most(y, limit), !possibly_at_most(y, limit)};
  const Interval slack = Interval::of(1e-9) * y;
  const bool coarse = possibly_at_most(slack, rounding);
  return {possibly_at_most(y, limit + slack), !possibly_at_most(y, coarse ? limit - rounding : limit)};
}

constexpr double probability_rounding = 1e-11;
constexpr double probability_of_decision = 0.95;

/// From the least to the most that is held possible.
struct Bounds {
  Interval least;
  Interval most;
};

/// P(Z ≤ z) of the standard normal distribution, or of Student's t.
Interval below(const Case& c, const Interval& z) {
  return c.degrees_of_freedom ? student_t_distribution(z, *c.degrees_of_freedom) : normal_distribution(z);
}

/// P(Y ≤ T), of B̄ P(−T ≤ Y ≤ T).
Interval probability_about_value(const Case& c, const Interval& rounding) {
  const Interval u = Interval::of(*c.u);
  if (u.lower() <= 0) return Interval(possibly_at_most(c.magnitude_of_y(), c.T + rounding) ? 1 : 0);
  const Interval above = below(c, (c.T - c.y) / u);
  if (!c.two_sided()) return above;
  return larger(above - below(c, (Interval(0) - c.T - c.y) / u), 0);
}

/// Nothing without an uncertainty.
std::optional<Bounds> probability(const Case& c, const Known& known) {
  if (!c.u) return std::nullopt;
  if (c.method == "monte_carlo" && known.drawn) {  // without trials normal, as every other
    constexpr double anywhere = std::numeric_limits<double>::infinity();
    if (const auto range = known.drawn(c.key(), c.two_sided() ? -c.limit : -anywhere, c.limit))
      return Bounds{Interval::of(range->least), Interval::of(range->most)};
  }
  const Interval p = probability_about_value(c, known.rounding);
  return Bounds{p, p};
}

/// A value beyond its limit is never accepted, one within it never rejected, whatever was drawn.
Bounds with_the_value(const Case& c, Bounds p, const Interval& rounding) {
  const Comparison value = at_most_of(c, c.T, rounding);
  const Interval sure = Interval::of(probability_of_decision);
  if (!value.may_hold && possibly_at_most(sure, p.least)) p.least = Interval(0);
  if (!value.may_fail && possibly_at_most(p.most, Interval(1) - sure)) p.most = Interval(1);
  return p;
}

Allowed by_probability(const Case& c, const Bounds& p, const Interval& rounding) {
  const Interval sure = Interval::of(probability_of_decision);
  const Interval apart =
      Interval::of(1e-9) + (Interval::of(*c.u).lower() > 0 ? rounding / Interval::of(*c.u) : Interval(0));
  Allowed allowed;
  allowed.conforming = possibly_at_most(sure - apart, p.least);
  allowed.rejecting = possibly_at_most(p.most, Interval(1) - sure + apart);
  allowed.open = !surely_at_most(sure + apart, p.least) && !surely_at_most(p.most, Interval(1) - sure - apart);
  return allowed;
}

Allowed by_guard_band(const Case& c, double g, const Interval& rounding) {
  const Comparison accepted = at_most_of(c, c.T - Interval::of(g), rounding);
  const Comparison not_rejected = at_most_of(c, c.T + Interval::of(g), rounding);
  return {accepted.may_hold, not_rejected.may_fail, accepted.may_fail && not_rejected.may_hold};
}

Allowed allowed_verdicts(const Case& c, const std::optional<double>& g, const std::optional<Bounds>& p,
                         const Interval& rounding) {
  if (c.rule == "simple") {
    const Comparison comparison = at_most_of(c, c.T, rounding);
    return {comparison.may_hold, comparison.may_fail, false};
  }
  if (!c.u) return {false, false, true};
  if (c.rule == "guard-band") return g ? by_guard_band(c, *g, rounding) : Allowed{false, false, true};
  if (c.rule == "iso14253-1" && p) return by_probability(c, *p, rounding);
  return {};
}

bool is_withheld(const Value& row) {
  const Value* withheld = present_value(&row, "withheld");
  if (withheld == nullptr) return false;
  return !(withheld->is(Kind::boolean) && !withheld->boolean()) &&
         !(withheld->is(Kind::array) && withheld->items().empty()) &&
         !(withheld->is(Kind::text) && withheld->text().empty());
}

/// Whether the uncertainty of a row holds the truth less often than it states.
bool holds_too_little(const Case& c, std::string_view type_a) {
  if (c.method != "monte_carlo") return false;
  return type_a == "resampled" || (type_a == "t-scaled" && c.parameter != Parameter::B_mean);
}

bool complete(const ExactCell& cell, bool with_scatter) { return cell.mean && (!with_scatter || cell.s); }

/// Whether some target lacks a reading that the parameter is taken from.
bool lacks_a_term(const Case& c, std::span<const ExactPosition> positions) {
  return std::ranges::any_of(positions, [&](const ExactPosition& at) {
    const bool up = complete(at.up, c.has_scatter()), down = complete(at.down, c.has_scatter());
    if (c.key().ends_with("_up")) return !up;
    if (c.key().ends_with("_down")) return !down;
    return !up || !down;
  });
}

/// Less what a value cannot show of which terms are missing.
Allowed of_a_part(Allowed allowed, const Case& c) {
  const bool rejects = allowed.rejecting && !c.two_sided();
  allowed.open = allowed.open || allowed.conforming || rejects != allowed.rejecting;
  allowed.conforming = false;
  allowed.rejecting = rejects;
  return allowed;
}

std::string place_of(const Case& c, std::string_view what) {
  return fmt::format("{} of {} against its limit", what, c.key());
}

/// Of what is held possible the probability that says least: the one nearest to a half.
Interval cautious(const Bounds& p) {
  const Interval half = Interval::of(0.5);
  if (!possibly_at_most(p.least, half)) return p.least;
  return possibly_at_most(half, p.most) ? half : p.most;
}

/// Probability, risks and both limits, as far as the row has them.
void check_numbers(const Value& row, std::string_view verdict, const Case& c, const std::optional<Bounds>& p,
                   const Known& known, Ledger& ledger) {
  const auto named = [&](std::string_view what) { return [&c, what] { return place_of(c, what); }; };
  Interval slack = Interval::of(probability_rounding);
  // The slope of the distribution is at most 0.4/u.
  if (c.u && Interval::of(*c.u).lower() > 0) slack = slack + known.rounding / Interval::of(*c.u);
  const auto compare = [&](std::string_view member, std::string_view what, const auto& right) {
    if (const auto stated = number_member(&row, member); stated && p)
      ledger.number(named(what), *stated, right(), slack);
  };
  compare("probability_conforming", "probability of conformity", [&] { return cautious(*p); });
  compare("probability_least", "least probability of conformity", [&] { return p->least; });
  compare("probability_most", "largest probability of conformity", [&] { return p->most; });
  compare("consumer_risk", "consumer's risk", [&] { return Interval(1) - p->least; });
  compare("producer_risk", "producer's risk", [&] { return p->most; });
  if (number_member(&row, "consumer_risk") && verdict != conforms)
    ledger.differ(place_of(c, "consumer's risk"), "a number", "none, since nothing was accepted");
  if (number_member(&row, "producer_risk") && verdict != rejected)
    ledger.differ(place_of(c, "producer's risk"), "a number", "none, since nothing was rejected");
  const auto g = number_member(&row, "guard_band");
  if (!g) return;
  const double above = number_member(&row, "rejection_band").value_or(*g);
  const Interval roundoff = Interval::of(1e-15) * (c.T + magnitude(Interval::of(*g)) + magnitude(Interval::of(above)));
  if (const auto stated = number_member(&row, "acceptance_limit"))
    ledger.number(named("acceptance limit"), *stated, c.T - Interval::of(*g), roundoff);
  if (const auto stated = number_member(&row, "rejection_limit"))
    ledger.number(named("rejection limit"), *stated, c.T + Interval::of(above), roundoff);
}

/// The verdict of a row, checked; empty for a row that names no parameter.
std::string_view check_row(const Value& row, const Known& known, Ledger& ledger) {
  const std::string_view verdict = text_member(&row, "verdict");
  const auto parameter = parameter_of_key(text_member(&row, "parameter"));
  const auto limit = number_member(&row, "limit");
  if (!parameter || !limit) {
    ledger.differ("a decision", std::string(text_member(&row, "parameter")), "a parameter with a limit");
    return verdict;
  }
  ++ledger.verdicts;
  Case c{*parameter,
         0,
         Interval::of(*limit),
         *limit,
         number_member(&row, "u"),
         number_member(&row, "u_degrees_of_freedom"),
         text_member(&row, "u_method"),
         text_member(&row, "rule")};
  const auto expect = [&](const std::string& right) {
    ledger.words([&] { return place_of(c, "verdict"); }, verdict, right);
  };
  const Exact& y = of(known.measured, *parameter);
  if (!y) {
    expect(std::string(no_verdict));
    return verdict;
  }
  c.y = *y;
  if (is_withheld(row)) {
    expect(std::string(undecided));
    return verdict;
  }
  if (holds_too_little(c, known.type_a)) {
    c.u.reset();
    if (number_member(&row, "probability_conforming"))
      ledger.differ(place_of(c, "probability of conformity"), "a number",
                    fmt::format("none, since intervals of {} hold too little", known.type_a));
  }
  auto p = probability(c, known);
  if (p) p = with_the_value(c, *p, known.rounding);
  Allowed allowed = allowed_verdicts(c, number_member(&row, "guard_band"), p, known.rounding);
  if (lacks_a_term(c, known.positions)) allowed = of_a_part(allowed, c);
  if (!allowed.holds(verdict)) expect(allowed.text().empty() ? std::string("none that is known") : allowed.text());
  check_numbers(row, verdict, c, p, known, ledger);
  return verdict;
}

}  // namespace

void check_decisions(const Value& rows, std::string_view overall, const Known& known, Ledger& ledger) {
  constexpr std::array gravity = {no_verdict, conforms, undecided, rejected};
  if (!rows.is(Kind::array)) return;
  std::size_t worst = 0;
  bool all_judged = true;
  for (const Value& row : rows.items()) {
    const std::string_view verdict = check_row(row, known, ledger);
    const auto rank = std::ranges::find(gravity, verdict);
    all_judged = all_judged && verdict != no_verdict;
    if (rank != gravity.end()) worst = std::max(worst, static_cast<std::size_t>(rank - gravity.begin()));
  }
  if (rows.items().empty()) return;
  ++ledger.verdicts;
  ledger.words([] { return std::string("the verdict on all limits"); }, overall,
               gravity[worst] == conforms && !all_judged ? undecided : gravity[worst]);
}

}  // namespace axiometry::verification
