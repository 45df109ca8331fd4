// SPDX-License-Identifier: Apache-2.0
// The first page, the table of parameters, the table of decisions.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "axiometry/verification/document_parts.h"

namespace axiometry::verification {
namespace {

using json::Kind;
using json::Value;

constexpr std::string_view no_break_space = "\u00a0";

/// The first table of a section that has a column with this head.
std::optional<PrintedTable> table_with(const report::Section& section, std::string_view head) {
  for (const report::Block& block : section.blocks) {
    const auto* table = std::get_if<report::Table>(&block);
    if (table == nullptr) continue;
    PrintedTable printed(*table);
    if (printed.column(head)) return printed;
  }
  return std::nullopt;
}

/// A limit to twelve digits, more than that only where a conversion of units leaves them.
void check_limit(const std::string& place, std::string_view printed, const Value& decision, const Interval& scale,
                 const Page& page) {
  const auto limit = number_member(&decision, "limit");
  const auto decimal = decimal_of(printed);
  ++page.ledger.figures;
  if (limit && decimal) {
    const Interval right = Interval::of(*limit) * scale;
    if (within(Interval::of(*decimal), right, Interval::of(5.1e-12) * magnitude(right))) return;
  }
  page.ledger.differ(place, std::string(printed), limit ? shown(Interval::of(*limit) * scale) : "no limit");
}

/// The U that the result states by some method, in native units.
Exact stated_U(const Value& result, std::string_view method, Parameter p) {
  const Value* own = present_value(present_value(&result, "uncertainty"), method);
  const auto U =
      method == "annex_a" ? number_member(own, key_of(p)) : number_member(present_value(own, key_of(p)), "U");
  return U ? Exact(Interval::of(*U)) : std::nullopt;
}

/// What is stated of a parameter by the method of record.
const Value* of_record(const Value& result, Parameter p) {
  const Value* record = present_value(present_value(&result, "uncertainty"), "record");
  return present_value(present_value(record, "parameters"), key_of(p));
}

/// Ends of the interval of record, and where its numbers end: a quarter of its width.
struct StatedInterval {
  Interval lower, upper, quarter;
};

std::optional<StatedInterval> stated_interval(const Value& result, Parameter p) {
  const auto low = number_member(of_record(result, p), "low"), high = number_member(of_record(result, p), "high");
  if (!low || !high) return std::nullopt;
  const Interval lower = Interval::of(*low), upper = Interval::of(*high);
  return StatedInterval{lower, upper, (upper - lower) / Interval(4)};
}

/// One line of the table of parameters.
class ParameterLine {
 public:
  ParameterLine(const PrintedTable& table, std::size_t row, Parameter parameter, const Page& page)
      : table_(table), row_(row), parameter_(parameter), page_(page) {}

  void check() {
    const std::string value = table_.cell(row_, "Value");
    const Exact& right = of(page_.found.parameters, parameter_);
    const auto scale = scale_of_unit(table_.cell(row_, "Unit"));
    if (!right || !scale) {
      ++page_.ledger.figures;
      if (right || !says_nothing(value))
        page_.ledger.differ(place("value"), value, right ? shown(*right) : "not applicable");
    }
    if (right && scale) {
      check_uncertainty(*scale);
      page_.ledger.text([&] { return place("value"); }, value, *right * *scale, page_.found.rounding * *scale, coarse_);
    }
    const Value* decision = decision_of(page_.result, key_of(parameter_));
    if (decision == nullptr) return;
    if (const auto column = table_.column("Tolerance"); column && scale)
      check_limit(place("tolerance"), table_.cell(row_, *column), *decision, *scale, page_);
    if (table_.column("Verdict")) check_verdict(*decision);
  }

 private:
  std::string place(std::string_view what) const {
    return fmt::format("{} of {} in the table of parameters", what, key_of(parameter_));
  }

  void check_verdict(const Value& decision) {
    const std::string printed = table_.cell(row_, "Verdict");
    const std::string_view verdict = text_member(&decision, "verdict");
    ++page_.ledger.verdicts;
    page_.ledger.words([&] { return place("verdict"); }, printed, verdict == "not applicable" ? "no verdict" : verdict);
  }

  /// The column that holds U or an interval is the one after the value.
  void check_uncertainty(const Interval& scale) {
    const auto value = table_.column("Value");
    if (!value || *value + 1 >= table_.column_count()) return;
    const std::string head(table_.head(*value + 1));
    const std::string printed = table_.cell(row_, *value + 1);
    const std::size_t to = printed.find(" to ");
    if (to != std::string::npos) return check_interval(printed.substr(0, to), printed.substr(to + 4), scale);
    if (says_nothing(printed)) return;
    for (const std::string_view method : {"annex_a", "gum"}) {
      if (head.contains("GUM") && method == "annex_a") continue;
      if ((head.contains("Annex A") || head.contains("k = 2")) && method == "gum") continue;
      const Exact U =
          method == "annex_a" ? of(page_.found.annex_a.U, parameter_) : stated_U(page_.result, method, parameter_);
      if (!U) continue;
      coarse_ = coarse_places(*U * scale, page_.uncertainty_digits);
      page_.ledger.text([&] { return place("U"); }, printed, *U * scale, *U * scale * Interval::of(1e-13), coarse_);
      return;
    }
    page_.ledger.differ(place("U"), printed, "none");
  }

  void check_interval(const std::string& lower, const std::string& upper, const Interval& scale) {
    const auto stated = stated_interval(page_.result, parameter_);
    if (!stated) return page_.ledger.differ(place("interval"), lower + " to " + upper, "none");
    coarse_ = coarse_places(stated->quarter * scale, page_.uncertainty_digits);
    page_.ledger.text([&] { return place("lower end"); }, lower, stated->lower * scale, Interval::of(1e-12), coarse_);
    page_.ledger.text([&] { return place("upper end"); }, upper, stated->upper * scale, Interval::of(1e-12), coarse_);
  }

  const PrintedTable& table_;
  std::size_t row_;
  Parameter parameter_;
  const Page& page_;
  int coarse_ = 0;
};

/// "95.3 %", "> 99.99 %", "< 0.01 %".
void check_percent(const std::string& place, std::string_view printed, double probability, const Page& page) {
  const Interval right = Interval::of(probability) * Interval(100);
  const bool above = printed.starts_with("> ");
  const bool below = printed.starts_with("< ");
  if (above || below) printed.remove_prefix(2);
  printed = printed.substr(0, printed.find(no_break_space));
  const auto decimal = decimal_of(printed);
  if (!decimal || !(above || below)) return page.ledger.text([&] { return place; }, printed, right, Interval::of(1e-9));
  ++page.ledger.figures;
  // Shares closer to 0 or 1 than these are shown so.
  const Interval bound = above ? Interval::of(99.99) : Interval::of(0.01);
  const bool is_beyond = above ? !possibly_at_most(right, bound) : !possibly_at_most(bound, right);
  if (!is_beyond || !within(Interval::of(*decimal), bound, 0))
    page.ledger.differ(place, std::string(printed), shown(right, 6) + " %");
}

void check_decision_line(const PrintedTable& table, std::size_t row, const Value& decision, const Interval& scale,
                         const Page& page) {
  const std::string key(text_member(&decision, "parameter"));
  const auto place = [&](std::string_view what) {
    return fmt::format("{} of {} in the table of decisions", what, key);
  };
  const Exact& y = of(page.found.parameters, *parameter_of_key(key));
  const Parameter parameter = *parameter_of_key(key);
  const auto expanded = number_member(of_record(page.result, parameter), "U");
  const auto interval = stated_interval(page.result, parameter);
  const Interval end = expanded ? Interval::of(*expanded) : interval ? interval->quarter : Interval(0);
  const int coarse = expanded || interval ? coarse_places(end * scale, page.uncertainty_digits) : 0;
  if (const std::string value = table.cell(row, "Value"); y && !says_nothing(value))
    page.ledger.text([&] { return place("value"); }, value, *y * scale, page.found.rounding * scale, coarse);
  check_limit(place("limit"), table.cell(row, "Tolerance T"), decision, scale, page);
  struct Stated {
    std::string_view head;
    std::string_view member;
  };
  for (const auto& [head, member] : {Stated{"u", "u"}, Stated{"g", "guard_band"}, Stated{"T − g", "acceptance_limit"},
                                     Stated{"T + g", "rejection_limit"}}) {
    const std::string printed = table.cell(row, head);
    const auto stated = number_member(&decision, member);
    if (says_nothing(printed)) continue;
    if (!stated) {
      page.ledger.differ(place(head), printed, "none");
      continue;
    }
    const Interval right = Interval::of(*stated) * scale;
    const auto named = [&] { return place(head); };
    if (head.starts_with('T')) {
      // What lies nearer to a printed number than the second rounding of T and g is that number.
      const Interval rounding = larger(Interval(1), magnitude(right)) * Interval::of(1e-9);
      page.ledger.inward(named, printed, right, rounding, head == "T − g", std::max(0, coarse - 1));
      continue;
    }
    page.ledger.text(named, printed, right, magnitude(right) * Interval::of(1e-14),
                     head == "u" ? coarse_places(right, page.uncertainty_digits) : 0);
  }
  const std::string p_c = table.cell(row, "pc");
  const auto least = number_member(&decision, "probability_least");
  const auto most = number_member(&decision, "probability_most");
  if (const std::size_t to = p_c.find(" to "); least && most && p_c.contains('%')) {
    check_percent(place("p_c"), p_c.substr(0, to), *least, page);
    if (to != std::string::npos) check_percent(place("p_c"), p_c.substr(to + 4), *most, page);
  }
  if (const auto p = number_member(&decision, "probability_conforming"); p && !least && p_c.contains('%'))
    check_percent(place("p_c"), p_c, *p, page);
  ++page.ledger.verdicts;
  const std::string_view verdict = text_member(&decision, "verdict");
  page.ledger.words([&] { return place("verdict"); }, table.cell(row, "Verdict"),
                    verdict == "not applicable" ? "no verdict" : verdict);
}

/// "A, R↑", of the decisions with this verdict.
std::string symbols_with(const Value& result, std::string_view verdict) {
  const Value* rows = present_value(&result, "tolerances");
  std::string symbols;
  if (rows == nullptr || !rows->is(Kind::array)) return symbols;
  for (const Value& row : rows->items()) {
    const auto p = parameter_of_key(text_member(&row, "parameter"));
    if (p && text_member(&row, "verdict") == verdict) symbols.append(symbols.empty() ? "" : ", ").append(symbol_of(*p));
  }
  return symbols;
}

/// "Does not conform: A, R↑" and the like, wherever they stand in a line.
void check_verdict_words(std::string_view line, const Page& page) {
  struct Words {
    std::string_view begin;
    std::string_view verdict;
  };
  constexpr Words all[] = {
      {"Does not conform: ", "does not conform"}, {"Undecided: ", "undecided"}, {"Conforms: ", "conforms"}};
  for (const auto& [begin, verdict] : all) {
    const std::size_t at = line.find(begin);
    if (at == std::string_view::npos) continue;
    std::string_view symbols = line.substr(at + begin.size());
    symbols = symbols.substr(0, std::min(symbols.find('.'), symbols.find(';')));
    ++page.ledger.verdicts;
    page.ledger.words([&] { return fmt::format("\"{}\" on the first page", begin); }, symbols,
                      symbols_with(page.result, verdict));
  }
}

/// "9.6" of "9.6 µm (GUM)".
std::string_view number_at_begin(std::string_view text) {
  constexpr std::string_view true_minus = "\u2212";
  const std::size_t sign = text.starts_with(true_minus) ? true_minus.size() : 0;
  return text.substr(0, text.find_first_not_of("0123456789.,", sign));
}

/// "A = (9.6 ± 4.3) µm (Annex A); tolerance 10 µm"
void check_value_line(std::string_view line, const Page& page) {
  const std::size_t equals = line.find(" = ");
  const std::size_t semicolon = line.find("; tolerance ");
  if (equals == std::string_view::npos || semicolon == std::string_view::npos || semicolon < equals) return;
  const auto parameter = parameter_of_symbol(line.substr(0, equals));
  const Value* decision = parameter ? decision_of(page.result, key_of(*parameter)) : nullptr;
  if (decision == nullptr) return;
  const auto place = [&](std::string_view what) {
    return fmt::format("{} of {} on the first page", what, key_of(*parameter));
  };
  std::string_view limit = line.substr(semicolon + std::string_view("; tolerance ").size());
  std::string_view unit;
  for (const std::string_view known : {"µm", "mm", "nm", "″", "°"})
    if (limit.ends_with(known)) unit = known;
  const auto scale = scale_of_unit(unit);
  if (!scale) return page.ledger.differ(place("unit"), std::string(limit), "a unit");
  limit.remove_suffix(unit.size());
  if (limit.ends_with(no_break_space)) limit.remove_suffix(no_break_space.size());
  check_limit(place("tolerance"), limit, *decision, *scale, page);
  std::string_view value = line.substr(equals + 3, semicolon - equals - 3);
  const Exact& y = of(page.found.parameters, *parameter);
  int coarse = 0;
  const std::size_t pm = value.find(" ± ");
  if (value.starts_with('(') && pm != std::string_view::npos) {
    const auto expanded = number_member(of_record(page.result, *parameter), "U");
    const std::string_view U = value.substr(pm + std::string_view(" ± ").size());
    const Interval right = expanded ? Interval::of(*expanded) * *scale : Interval(0);
    coarse = coarse_places(right, page.uncertainty_digits);
    page.ledger.text([&] { return place("U"); }, U.substr(0, U.find(')')), right,
                     magnitude(right) * Interval::of(1e-13), coarse);
    value = value.substr(1, pm - 1);
  } else {
    const std::size_t to = value.find(" to ");
    const std::size_t comma = to == std::string_view::npos ? to : value.rfind(", ", to);
    if (const auto stated = stated_interval(page.result, *parameter); stated && comma != std::string_view::npos) {
      coarse = coarse_places(stated->quarter * *scale, page.uncertainty_digits);
      const std::string_view upper = value.substr(to + 4);
      page.ledger.text([&] { return place("lower end"); }, value.substr(comma + 2, to - comma - 2),
                       stated->lower * *scale, Interval::of(1e-12), coarse);
      page.ledger.text([&] { return place("upper end"); }, number_at_begin(upper), stated->upper * *scale,
                       Interval::of(1e-12), coarse);
    }
    value = number_at_begin(value);
  }
  if (y) page.ledger.text([&] { return place("value"); }, value, *y * *scale, page.found.rounding * *scale, coarse);
}

}  // namespace

void check_title(const report::Document& document, const Page& page) {
  for (const report::Notice& notice : document.status) {
    check_verdict_words(text_of(notice.heading), page);
    for (const report::RichText& line : notice.lines) {
      const std::string text = text_of(line);
      check_verdict_words(text, page);
      check_value_line(text, page);
    }
  }
}

void check_parameter_section(const report::Section& section, const Page& page) {
  const auto table = table_with(section, "Value");
  std::size_t lines = 0;
  for (std::size_t row = 0; table && row < table->row_count(); ++row) {
    const std::string symbol = table->cell(row, "Symbol");
    const auto parameter = parameter_of_symbol(bare_symbol(symbol));
    if (!parameter) continue;
    ParameterLine(*table, row, *parameter, page).check();
    ++lines;
  }
  if (lines != parameter_names.size())
    page.ledger.differ("the lines of the table of parameters", fmt::format("{}", lines), "12");
}

void check_decision_section(const report::Section& section, const Page& page) {
  const auto table = table_with(section, "Tolerance T");
  if (!table) return page.ledger.differ("the table of decisions", "nothing", "a table");
  const std::size_t in = table->caption().rfind(" in ");
  const auto scale = scale_of_unit(in == std::string_view::npos ? std::string_view() : table->caption().substr(in + 4));
  if (!scale) return page.ledger.differ("the unit of the decisions", std::string(table->caption()), "a unit");
  for (std::size_t row = 0; row < table->row_count(); ++row) {
    const std::string symbol = table->cell(row, "Symbol");
    const auto parameter = parameter_of_symbol(bare_symbol(symbol));
    const Value* decision = parameter ? decision_of(page.result, key_of(*parameter)) : nullptr;
    if (decision == nullptr) {
      page.ledger.differ("the table of decisions", symbol, "a parameter with a limit");
      continue;
    }
    check_decision_line(*table, row, *decision, *scale, page);
  }
}

}  // namespace axiometry::verification
