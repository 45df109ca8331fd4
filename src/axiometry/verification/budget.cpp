// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/budget.h"

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

namespace axiometry::verification {
namespace {

using json::Kind;
using json::Value;

/// Ten products and roots of doubles: more than any line or sum of the annex has.
constexpr double budget_rounding = 1e-14;
constexpr double means_rounding = 4e-14;  // a length, its share and one more root

/// The inputs of one line by their symbols.
class StatedInputs {
 public:
  explicit StatedInputs(const Value& line) {
    const Value* list = present_value(&line, "inputs");
    if (list == nullptr || !list->is(Kind::array)) return;
    for (const Value& row : list->items())
      if (const auto value = number_member(&row, "value")) {
        rows_.push_back({text_member(&row, "symbol"), text_member(&row, "unit"), Interval::of(*value)});
        if (rows_.back().symbol == "L" && text_member(&row, "note") == "measured travel") measured_travel_ = value;
      }
  }

  /// L in m, where it follows from the targets.
  const std::optional<double>& measured_travel() const { return measured_travel_; }

  /// The same with l in place of L.
  StatedInputs over(const Interval& l) const {
    StatedInputs inputs = *this;
    for (Row& row : inputs.rows_)
      if (row.symbol == "L") row.value = l;
    return inputs;
  }

  /// Of a unit where several inputs have the symbol.
  Exact find(std::string_view symbol, std::string_view unit = {}) const {
    for (const Row& row : rows_)
      if (row.symbol == symbol && (unit.empty() || row.unit == unit)) return row.value;
    return std::nullopt;
  }

 private:
  struct Row {
    std::string_view symbol;
    std::string_view unit;
    Interval value;
  };
  std::vector<Row> rows_;
  std::optional<double> measured_travel_;
};

Interval squared(const Interval& x) { return x * x; }

Exact product(std::initializer_list<Exact> factors) {
  Interval all = 1;
  for (const Exact& factor : factors) {
    if (!factor) return std::nullopt;
    all = all * *factor;
  }
  return all;
}

const Interval& six_tenths() {
  static const Interval value = Interval::of(0.6);
  return value;
}

/// (A.1) and (A.2), together their sum ("A.1 + A.2") or the root of both squares ("A.1, A.2"); (A.3).
Exact exact_device(const StatedInputs& inputs, std::string_view formula) {
  const Exact L = inputs.find("L");
  if (formula == "A.3") return product({six_tenths(), inputs.find("R_DEVICE"), L});
  if (formula == "A.2") return product({inputs.find("U_CALIBRATION"), L});
  if (formula == "A.1") return inputs.find("U_CALIBRATION");
  if ((formula != "A.1, A.2" && formula != "A.1 + A.2") || !L) return std::nullopt;
  const Exact per_length = product({inputs.find("U_CALIBRATION", "µm/m"), L});
  Exact constant = inputs.find("U_CALIBRATION", "µm");
  if (!constant) constant = inputs.find("U_CALIBRATION", "″");
  if (!per_length || !constant) return std::nullopt;
  if (formula == "A.1 + A.2") return *per_length + *constant;
  return root(squared(*per_length) + squared(*constant));
}

/// Nothing where the line is none of the annex, or its inputs are not those of its formula.
Exact exact_line(std::string_view key, std::string_view formula, const StatedInputs& inputs) {
  const Exact L = inputs.find("L");
  if (key == "device") return exact_device(inputs, formula);
  if (key == "misalignment") {
    const Exact R = inputs.find("R_MISALIGNMENT");
    if (!R || !L || L->lower() <= 0) return std::nullopt;
    return Interval::of(0.3) * squared(*R) / *L;
  }
  if (key == "m_machine" || key == "m_device") return product({six_tenths(), inputs.find("α"), L, inputs.find("R(θ)")});
  if (key == "e_machine" || key == "e_device")
    return product({six_tenths(), inputs.find("ΔT"), L, inputs.find("R(α)")});
  if (key == "eve") return product({six_tenths(), inputs.find("E_VE")});
  if (key == "probing") return inputs.find("U_PROBING");
  return std::nullopt;
}

/// A line of the budget that has a U.
struct BudgetLine {
  std::string_view key, formula;
  StatedInputs inputs;
  Interval U;

  /// In a mean deviation over the length l in place of L; as it is where there is none, as of a rotary axis.
  Interval at(const Exact& l) const {
    if (!l || key == "probing" || key == "station") return U;
    if (key == "device" && formula != "A.3")
      if (const Exact own = exact_device(inputs.over(*l), formula)) return *own;
    const Exact L = inputs.find("L");
    return L && L->lower() > 0 ? U * *l / *L : U;  // (A.4) is 0.3 R² l/L², in proportion to l too
  }
};

/// What enters the combination of all lines.
struct ExactSum {
  Interval squares = 0;  ///< squares of all contributions but U_EVE
  Exact eve;
  Exact probing;
  bool any = false;
};

/// A.11 and A.14 as printed, for fewer than five approaches by what noise does to s of so few, or of one swing of the
/// range E_VE = U_EVE/0.6 over the test.
struct RepeatabilityTerms {
  Interval one_way, both_ways;

  RepeatabilityTerms(const Interval& eve, std::size_t runs, bool slow)
      : one_way(Interval(2) * eve), both_ways(Interval::of(2.2) * eve) {
    if (runs < 2 || (runs >= 5 && !slow)) return;
    const Interval n = static_cast<int>(runs);
    if (!slow) {
      const Interval of_s = Interval(16) / (n - Interval(1));
      one_way = root(of_s) * eve;
      both_ways = root(of_s + Interval(4) / n) * eve;
      return;
    }
    const Interval range = eve / Interval::of(0.6);
    const Interval s = range * root(n / (Interval(8) * (n - Interval(1))));
    one_way = Interval(4) * s;
    both_ways = one_way + range / n;
  }
};

ExactParameters combined(const ExactSum& sum, const ExactParameters& measured, std::size_t runs, bool slow) {
  const Interval eve = sum.eve.value_or(Interval(0));
  const Interval n = static_cast<int>(runs);
  const Interval of_E = root(sum.squares + squared(eve) / n);
  const Interval of_M = root(sum.squares + squared(eve) / (Interval(2) * n));
  const auto [one_way, both_ways] = RepeatabilityTerms(eve, runs, slow);
  const Interval factor = runs == 5 ? Interval::of(0.9) : Interval(2) / root(n);
  const Interval of_B = root(squared(factor * eve) + Interval(2) * squared(sum.probing.value_or(Interval(0))));
  const Interval of_A = root(squared(of_E) + squared(one_way));
  ExactParameters U;
  const auto state = [&](std::initializer_list<Parameter> which, bool known, const Interval& value) {
    for (const Parameter p : which)
      if (known && of(measured, p)) of(U, p) = value;
  };
  using enum Parameter;
  state({A, A_up, A_down}, sum.any, of_A);
  state({E, E_up, E_down}, sum.any, of_E);
  state({M}, sum.any, of_M);
  state({R}, sum.eve.has_value(), both_ways);
  state({R_up, R_down}, sum.eve.has_value(), one_way);
  state({B, B_mean}, sum.eve || sum.probing, of_B);
  return U;
}

/// The means of the targets, as the budget lists them, held against what its lines make of them.
class MeansCheck {
 public:
  MeansCheck(const Value& budget, std::span<const BudgetLine> lines, const Exact& eve,
             std::span<const ExactPosition> positions, Ledger& ledger)
      : lines_(lines), eve_(eve), positions_(positions), ledger_(ledger), datum_(number_member(&budget, "datum")) {
    for (const BudgetLine& line : lines)
      if (!L_) L_ = line.inputs.find("L");
  }

  std::vector<ExactMeans> operator()(const Value& rows) {
    std::vector<ExactMeans> all;
    if (!datum_ || rows.items().size() != positions_.size()) {
      ledger_.differ("targets in the budget of Annex A", fmt::format("{}", rows.items().size()),
                     fmt::format("{}, counted from a datum", positions_.size()));
      return all;
    }
    for (std::size_t i = 0; i < positions_.size(); ++i) all.push_back(means_of(i, rows.items()[i]));
    return all;
  }

 private:
  ExactMeans means_of(std::size_t i, const Value& row) {
    const ExactPosition& p = positions_[i];
    ExactMeans own;
    find_length(p, row, own);
    const auto name = [i](std::string_view what) { return fmt::format("{} of target {} by Annex A", what, i + 1); };
    ledger_.number([&] { return name("l"); }, number_member(&row, "length_m"), own.length_m, of_length_);
    const Value* stated = present_value(&row, "contributions");
    Interval squares = 0;
    for (const BudgetLine& line : lines_) {
      if (line.key == "eve") continue;
      const Interval U = own.contributions.emplace_back(line.at(own.length_m)).value();
      squares = squares + squared(U);
      ledger_.number([&] { return name(line.key); }, number_member(stated, line.key), Exact(U), near(U));
    }
    const Interval up = static_cast<int>(p.up.count), down = static_cast<int>(p.down.count);
    if (p.up.mean) own.up = combined_with(squares, Interval(1) / up);        // (A.15), (A.17)
    if (p.down.mean) own.down = combined_with(squares, Interval(1) / down);  // (A.15), (A.17)
    if (p.mean())                                                            // (A.16), (A.18)
      own.mean = combined_with(squares, (Interval(1) / up + Interval(1) / down) / Interval(4));
    for (const auto& [key, mean] : {std::pair{"up", &own.up}, {"down", &own.down}, {"mean", &own.mean}}) {
      const Value* printed = present_value(&row, key);
      ledger_.number([&] { return name(fmt::format("U_EVE of {}", key)); }, number_member(printed, "environment"),
                     mean->environment, mean->environment ? near(*mean->environment) : Interval(0));
      ledger_.number([&] { return name(fmt::format("U of {}", key)); }, number_member(printed, "U"), mean->U,
                     mean->U ? near(*mean->U) : Interval(0));
    }
    return own;
  }

  /// l_i = |P_i − P_datum|, stretched where an L above the measured travel is stated; where no line has L, as stated.
  void find_length(const ExactPosition& p, const Value& row, ExactMeans& own) {
    const auto stated = number_member(&row, "length_m");
    if (!stated) return;
    const Interval datum = Interval::of(*datum_), metre = 1000;
    const Interval travel = (positions_.back().target - positions_.front().target) / metre;
    const bool stretches = L_ && travel.lower() > 0;
    const Interval stretch = stretches ? larger(Interval(1), *L_ / travel) : Interval(1);
    own.length_m = L_ ? magnitude(p.target - datum) / metre * stretch : Interval::of(*stated);
    of_length_ = Interval::of(means_rounding) * (magnitude(p.target) + magnitude(datum)) / metre * stretch;
    share_of_length_ = L_ && L_->lower() > 0 ? of_length_ / *L_ : Interval(0);
  }

  ExactMean combined_with(const Interval& squares, const Interval& share) const {
    ExactMean mean;
    if (eve_) mean.environment = *eve_ * root(share);
    mean.U = root(squares + (eve_ ? squared(*eve_) * share : Interval(0)));
    return mean;
  }

  /// How far a figure may be off by rounding: its own, and that of the length in every line.
  Interval near(const Interval& U) const {
    Interval sum = 0;
    for (const BudgetLine& line : lines_) sum = sum + line.U;
    return magnitude(U) * Interval::of(means_rounding) + sum * share_of_length_;
  }

  std::span<const BudgetLine> lines_;
  const Exact& eve_;
  std::span<const ExactPosition> positions_;
  Ledger& ledger_;
  std::optional<double> datum_;
  Exact L_;
  Interval of_length_ = 0, share_of_length_ = 0;
};

}  // namespace

const Value* present_value(const Value* object, std::string_view name) {
  if (object == nullptr || !object->is(Kind::object)) return nullptr;
  const Value* found = object->find(name);
  return found == nullptr || found->is(Kind::null) ? nullptr : found;
}

std::optional<double> number_member(const Value* object, std::string_view name) {
  const Value* found = present_value(object, name);
  return found != nullptr && found->is(Kind::number) ? std::optional(found->number()) : std::nullopt;
}

std::string_view text_member(const Value* object, std::string_view name) {
  const Value* found = present_value(object, name);
  return found != nullptr && found->is(Kind::text) ? std::string_view(found->text()) : std::string_view();
}

ExactAnnexA check_budget(const Value& budget, const ExactParameters& measured, std::span<const ExactPosition> positions,
                         Ledger& ledger) {
  const std::size_t runs = fewest_runs(positions);
  ExactSum sum;
  std::vector<BudgetLine> with_U;
  const Interval relative = Interval::of(budget_rounding);
  const Value* lines = present_value(&budget, "contributors");
  if (lines != nullptr && lines->is(Kind::array)) {
    for (const Value& line : lines->items()) {
      const std::string_view key = text_member(&line, "key");
      const auto stated = number_member(&line, "U");
      if (!stated) continue;  // the inputs of this contributor were not given, and its line says so
      sum.any = true;
      const StatedInputs inputs(line);
      if (const auto L = inputs.measured_travel(); L && !positions.empty()) {
        const Interval& first = positions.front().target;
        const Interval& last = positions.back().target;
        ledger.number([&] { return fmt::format("L of {} in the budget", key); }, *L, (last - first) / Interval(1000),
                      relative * (magnitude(first) + magnitude(last)) / Interval(1000));
      }
      const Exact found = exact_line(key, text_member(&line, "formula"), inputs);
      const Interval U = found.value_or(Interval::of(*stated));
      if (found) {
        ledger.number([&] { return fmt::format("{} in the budget of Annex A", text_member(&line, "symbol")); }, *stated,
                      U, magnitude(U) * relative);
      } else {
        ++ledger.compared;
      }
      if (key == "eve") {
        sum.eve = U;
      } else {
        sum.squares = sum.squares + U * U;
      }
      if (key == "probing") sum.probing = U;
      with_U.push_back({key, text_member(&line, "formula"), inputs, U});
    }
  }
  if (const auto stated = number_member(&budget, "runs"))
    ledger.number([] { return std::string("n in the budget of Annex A"); }, *stated, Interval(static_cast<int>(runs)),
                  Interval(0));
  if (runs == 0) return {};
  const Value* slow = present_value(&budget, "slow_environment");
  ExactAnnexA found{
      combined(sum, measured, runs, slow != nullptr && slow->is(Kind::boolean) && slow->boolean()), sum.eve, {}};
  const Value* rows = present_value(&budget, "positions");
  if (rows != nullptr && rows->is(Kind::array))
    found.means = MeansCheck(budget, with_U, found.U_eve, positions, ledger)(*rows);
  return found;
}

}  // namespace axiometry::verification
