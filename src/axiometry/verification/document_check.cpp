// SPDX-License-Identifier: Apache-2.0
#include "axiometry/verification/document_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/verification/document_parts.h"

namespace axiometry::verification {
namespace {

using json::Kind;
using json::Value;

struct Part {
  std::string_view section;
  void (*check)(const report::Section&, const Page&);
  bool always;  ///< every report has it
};

constexpr Part parts[] = {{"parameters", &check_parameter_section, true},
                          {"conformity", &check_decision_section, false},
                          {"methods", &check_method_section, false},
                          {"positions", &check_position_section, true},
                          {"uncertainty", &check_annex_a_section, false}};

/// Keys of the parameters with a verdict, as the table of many tests has them: separated by blanks.
std::string keys_with(const Value& result, std::string_view verdict) {
  const Value* rows = present_value(&result, "tolerances");
  std::string keys;
  if (rows == nullptr || !rows->is(Kind::array)) return keys;
  for (const Value& row : rows->items())
    if (text_member(&row, "verdict") == verdict)
      keys.append(keys.empty() ? "" : " ").append(text_member(&row, "parameter"));
  return keys;
}

/// Nothing where it is 0: nothing is known without doubt.
Exact unless_zero(const Exact& U) {
  const Interval rounding = Interval::of(1e-30);
  return U && surely_at_most(*U, rounding) ? Exact() : U;
}

/// That of the method that stands with the results; nothing of Monte Carlo, which states an interval.
Exact U_of_record(const Value& result, const Found& found, Parameter p) {
  const Value* uncertainty = present_value(&result, "uncertainty");
  const std::string_view method = text_member(present_value(uncertainty, "record"), "method");
  if (method.empty() || method == "annex_a") return unless_zero(of(found.annex_a.U, p));
  const auto U = number_member(present_value(present_value(uncertainty, method), key_of(p)), "U");
  return method == "gum" && U ? unless_zero(Interval::of(*U)) : std::nullopt;
}

/// The cells of one line of RFC 4180.
std::vector<std::string> cells_of_line(std::string_view line) {
  while (line.ends_with('\n') || line.ends_with('\r')) line.remove_suffix(1);
  std::vector<std::string> cells(1);
  bool quoted = false;
  for (const char c : line) {
    if (c == '"') {
      quoted = !quoted;
    } else if (c == ',' && !quoted) {
      cells.emplace_back();
    } else {
      cells.back() += c;
    }
  }
  return cells;
}

}  // namespace

const Value* decision_of(const Value& result, std::string_view parameter_key) {
  const Value* rows = present_value(&result, "tolerances");
  if (rows == nullptr || !rows->is(Kind::array)) return nullptr;
  const auto found = std::ranges::find_if(
      rows->items(), [&](const Value& row) { return text_member(&row, "parameter") == parameter_key; });
  return found == rows->items().end() ? nullptr : &*found;
}

void check_document(const report::Document& document, const Value& result, const Found& found, const Evidence& evidence,
                    int uncertainty_digits, Ledger& ledger) {
  const Page page{result, found, evidence, uncertainty_digits, ledger};
  check_title(document, page);
  for (const Part& part : parts) {
    const auto section = std::ranges::find(document.sections, part.section, &report::Section::id);
    if (section != document.sections.end()) {
      part.check(*section, page);
    } else if (part.always) {
      ledger.differ(fmt::format("the section {}", part.section), "nothing", "a section of every report");
    }
  }
}

void check_table_row(std::string_view head, std::string_view row, const Value& result, const Found& found,
                     Ledger& ledger) {
  const auto heads = cells_of_line(head);
  const auto cells = cells_of_line(row);
  if (heads.size() != cells.size()) {
    ledger.differ("the number of cells in the table of tests", fmt::format("{}", cells.size()),
                  fmt::format("{}", heads.size()));
    return;
  }
  const auto number = [&](std::size_t k, const Exact& right, const Interval& rounding) {
    const auto place = [&] { return fmt::format("{} in the table of tests", heads[k]); };
    const auto printed = decimal_of(cells[k]);
    if (printed && right) {
      ledger.number(place, parse_number(cells[k]).value_or(0.0), *right, rounding);
    } else {
      ++ledger.figures;
      if (printed || right) ledger.differ(place(), cells[k], right ? shown(*right) : "nothing");
    }
  };
  for (std::size_t k = 0; k < heads.size(); ++k) {
    const std::string_view name = heads[k];
    if (const auto p = parameter_of_key(name)) number(k, of(found.parameters, *p), found.rounding);
    if (!name.starts_with("U_")) continue;
    const auto p = parameter_of_key(name.substr(2));
    if (!p) continue;
    const Exact U = U_of_record(result, found, *p);
    number(k, U, U ? magnitude(*U) * Interval::of(1e-14) : Interval(0));
  }
  for (const auto& [name, verdict] : {std::pair("does_not_conform", "does not conform"), {"undecided", "undecided"}}) {
    const auto at = std::ranges::find(heads, name);
    if (at == heads.end()) continue;
    const std::string& printed = cells[static_cast<std::size_t>(at - heads.begin())];
    if (!printed.empty()) ++ledger.verdicts;
    ledger.words([&] { return fmt::format("{} in the table of tests", name); }, printed, keys_with(result, verdict));
  }
}

}  // namespace axiometry::verification
