// SPDX-License-Identifier: Apache-2.0
// The methods side by side, the budget of Annex A and what it corrects.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "axiometry/verification/document_parts.h"

namespace axiometry::verification {
namespace {

using json::Kind;
using json::Value;

const Value* method_member(const Page& page, std::string_view method, Parameter p) {
  return present_value(present_value(present_value(&page.result, "uncertainty"), method), key_of(p));
}

Exact exact_member(const Value* own, std::string_view name) {
  const auto x = number_member(own, name);
  return x ? Exact(Interval::of(*x)) : std::nullopt;
}

/// ", µm" at the end of a caption.
std::optional<Interval> scale_of_caption(std::string_view caption) {
  const std::size_t comma = caption.rfind(", ");
  return scale_of_unit(comma == std::string_view::npos ? std::string_view() : caption.substr(comma + 2));
}

/// Numbers of one row of the tables of methods.
class MethodLine {
 public:
  MethodLine(const PrintedTable& table, std::size_t row, Parameter parameter, const Interval& scale, const Page& page)
      : table_(table), row_(row), parameter_(parameter), scale_(scale), page_(page) {}

  void check(std::size_t column, const Exact& right, const Interval& rounding, const Exact& ends_with) {
    const std::string printed = table_.cell(row_, column);
    if (says_nothing(printed)) return;
    const auto place = [&] {
      return fmt::format("{} {} of {} in \"{}\"", table_.group(column), table_.head(column), key_of(parameter_),
                         table_.caption());
    };
    if (!right) return page_.ledger.differ(place(), printed, "none");
    const int coarse = ends_with ? coarse_places(magnitude(*ends_with) * scale_, page_.uncertainty_digits) : 0;
    page_.ledger.text(place, printed, *right * scale_, rounding * scale_, coarse);
  }

 private:
  const PrintedTable& table_;
  std::size_t row_;
  Parameter parameter_;
  const Interval& scale_;
  const Page& page_;
};

/// The interval that a Monte Carlo run states, which holds the measured value.
struct StatedEnds {
  Exact low, high;

  StatedEnds(const Value* drawn, const Exact& value)
      : low(exact_member(drawn, "low")), high(exact_member(drawn, "high")) {
    if (low && value) low = smaller(*low, *value);
    if (high && value) high = larger(*high, *value);
  }
  /// Where numbers beside it end: a quarter of its width.
  Exact quarter() const { return low && high ? Exact((*high - *low) / Interval(4)) : std::nullopt; }
};

/// Where the value of a parameter ends: U of record, or a quarter of its interval; nothing without either.
Exact end_of_value(const Page& page, Parameter p) {
  const Value* record = present_value(present_value(&page.result, "uncertainty"), "record");
  const Value* own = present_value(present_value(record, "parameters"), key_of(p));
  if (const Exact U = exact_member(own, "U")) return U;
  const Exact low = exact_member(own, "low"), high = exact_member(own, "high");
  return low && high ? Exact((*high - *low) / Interval(4)) : std::nullopt;
}

void check_method_line(const PrintedTable& table, std::size_t row, Parameter p, const Interval& scale,
                       const Page& page) {
  MethodLine line(table, row, p, scale, page);
  const Interval none = Interval::of(1e-20);
  const Value* gum = method_member(page, "gum", p);
  const Value* drawn = method_member(page, "monte_carlo", p);
  const Exact u = exact_member(drawn, "u");
  const StatedEnds ends(drawn, of(page.found.parameters, p));
  const Exact quarter = ends.quarter();
  for (std::size_t column = 0; column < table.column_count(); ++column) {
    const std::string_view head = table.head(column);
    const std::string_view group = table.group(column);
    const Exact& U = of(page.found.annex_a.U, p);
    if (head == "Value") line.check(column, of(page.found.parameters, p), page.found.rounding, end_of_value(page, p));
    if (group == "Annex A" && head.starts_with('U')) line.check(column, U, U ? *U * Interval::of(1e-13) : none, U);
    if (group == "GUM" && head.starts_with('U'))
      line.check(column, exact_member(gum, "U"), none, exact_member(gum, "U"));
    if (group != "Monte Carlo") continue;
    if (head == "u") line.check(column, u, none, u);
    if (head == "Mean") line.check(column, exact_member(drawn, "mean"), none, quarter);
    if (head == "Bias") line.check(column, exact_member(drawn, "bias"), none, quarter);
    if (head.ends_with(" from")) line.check(column, ends.low, page.found.rounding, quarter);
    if (head == "to") line.check(column, ends.high, page.found.rounding, quarter);
  }
}

void check_interval_line(const PrintedTable& table, std::size_t row, Parameter p, const Interval& scale,
                         const Page& page) {
  MethodLine line(table, row, p, scale, page);
  const Interval none = Interval::of(1e-20);
  const Value* drawn = method_member(page, "monte_carlo", p);
  const Exact u = exact_member(drawn, "u");
  const StatedEnds ends(drawn, of(page.found.parameters, p));
  for (std::size_t column = 0; column < table.column_count(); ++column) {
    const std::string_view head = table.head(column);
    if (head == "u") line.check(column, u, none, u);
    if (!table.group(column).ends_with("stated")) continue;
    if (head == "from") line.check(column, ends.low, page.found.rounding, ends.quarter());
    if (head == "to") line.check(column, ends.high, page.found.rounding, ends.quarter());
  }
}

void check_budget_table(const PrintedTable& table, const Page& page) {
  const Value* budget = present_value(present_value(&page.result, "uncertainty"), "annex_a_budget");
  const Value* lines = present_value(budget, "contributors");
  if (lines == nullptr || !lines->is(Kind::array)) return;
  const auto column = [&]() -> std::optional<std::size_t> {
    for (std::size_t k = 0; k < table.column_count(); ++k)
      if (table.head(k).starts_with("U (")) return k;
    return std::nullopt;
  }();
  if (!column) return;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const std::string title = table.cell(row, "Contributor");
    const std::string printed = table.cell(row, *column);
    const auto line =
        std::ranges::find_if(lines->items(), [&](const Value& each) { return text_member(&each, "title") == title; });
    if (line == lines->items().end() || says_nothing(printed)) continue;
    const Exact U = exact_member(&*line, "U");
    const auto scale = scale_of_unit(table.cell(row, "Unit"));
    if (!U || !scale) {
      page.ledger.differ(fmt::format("{} in the budget", title), printed, "none");
      continue;
    }
    page.ledger.text([&] { return fmt::format("{} in the budget", title); }, printed, *U * *scale,
                     *U * *scale * Interval::of(1e-13), coarse_places(*U * *scale, page.uncertainty_digits));
  }
}

void check_corrected_axis_table(const PrintedTable& table, const Page& page) {
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const std::string symbol = table.cell(row, "Symbol");
    const auto p = parameter_of_symbol(bare_symbol(symbol));
    const auto scale = scale_of_unit(table.cell(row, "Unit"));
    if (!p || !scale) continue;
    MethodLine line(table, row, *p, *scale, page);
    line.check(*table.column("As measured"), of(page.found.parameters, *p), page.found.rounding,
               end_of_value(page, *p));
    line.check(*table.column("Corrected"), of(page.found.corrected, *p), page.found.rounding, end_of_value(page, *p));
  }
}

void check_corrected_position_table(const PrintedTable& table, const Page& page) {
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto target = target_of(table, row, page.found.corrected_positions.size());
    if (!target) {
      page.ledger.differ(fmt::format("line {} of \"{}\"", row + 1, table.caption()), table.cell(row, std::size_t{0}),
                         "the number of a target");
      continue;
    }
    page.ledger.text([&] { return fmt::format("target {} in \"{}\"", *target + 1, table.caption()); },
                     table.cell(row, std::size_t{1}), page.found.positions[*target].target, Interval::of(1e-12));
    for (std::size_t column = 2; column < table.column_count(); ++column) {
      const bool measured = table.head(column) == "measured";
      if (!measured && table.head(column) != "corrected") continue;
      const ExactPosition& p = measured ? page.found.positions[*target] : page.found.corrected_positions[*target];
      const std::string_view group = table.group(column);
      const Exact right = group.contains("↑") ? p.R_up() : group.contains("↓") ? p.R_down() : p.R();
      const std::string printed = table.cell(row, column);
      const auto place = [&] { return fmt::format("{} {} of target {}", group, table.head(column), *target + 1); };
      if (right && !says_nothing(printed)) {
        page.ledger.text(place, printed, *right, page.found.rounding);
      } else if (right || !says_nothing(printed)) {
        page.ledger.differ(place(), printed, right ? shown(*right, 8) : "nothing");
      }
    }
  }
}

/// What of the means of a target stands in a column of their table; nothing where there is none.
Exact composed_figure(const ExactMeans& means, std::string_view group, std::string_view head, std::size_t contributor) {
  if (head.starts_with("l")) return means.length_m ? Exact(*means.length_m * Interval(1000)) : std::nullopt;
  if (group == "Contributors")
    return contributor < means.contributions.size() ? means.contributions[contributor] : std::nullopt;
  const ExactMean& mean = group.contains("↑") ? means.up : group.contains("↓") ? means.down : means.mean;
  return head.contains("EVE") ? mean.environment : mean.U;
}

void check_composed_mean_table(const PrintedTable& table, const Page& page) {
  const std::vector<ExactMeans>& all = page.found.annex_a.means;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto target = target_of(table, row, all.size());
    if (!target) {
      page.ledger.differ(fmt::format("line {} of \"{}\"", row + 1, table.caption()), table.cell(row, std::size_t{0}),
                         "the number of a target");
      continue;
    }
    page.ledger.text([&] { return fmt::format("target {} in \"{}\"", *target + 1, table.caption()); },
                     table.cell(row, std::size_t{1}), page.found.positions[*target].target, Interval::of(1e-12));
    std::size_t contributor = 0;
    for (std::size_t column = 2; column < table.column_count(); ++column) {
      const std::string_view group = table.group(column);
      const Exact right = composed_figure(all[*target], group, table.head(column), contributor);
      if (group == "Contributors") ++contributor;
      const std::string printed = table.cell(row, column);
      const auto place = [&] { return fmt::format("{} {} of target {}", group, table.head(column), *target + 1); };
      if (right && !says_nothing(printed)) {
        page.ledger.text(place, printed, *right, magnitude(*right) * Interval::of(1e-12));
      } else if (right || !says_nothing(printed)) {
        page.ledger.differ(place(), printed, right ? shown(*right, 8) : "nothing");
      }
    }
  }
}

/// Every table of a section.
template <typename Check>
void for_each_table(const report::Section& section, const Check& check) {
  for (const report::Block& block : section.blocks)
    if (const auto* table = std::get_if<report::Table>(&block)) check(PrintedTable(*table));
}

}  // namespace

void check_method_section(const report::Section& section, const Page& page) {
  for_each_table(section, [&](const PrintedTable& table) {
    const auto scale = scale_of_caption(table.caption());
    if (!scale || !table.column("Symbol")) return;
    for (std::size_t row = 0; row < table.row_count(); ++row) {
      const std::string symbol = table.cell(row, "Symbol");
      const auto p = parameter_of_symbol(bare_symbol(symbol));
      if (!p) continue;
      if (table.column("Value")) {
        check_method_line(table, row, *p, *scale, page);
      } else {
        check_interval_line(table, row, *p, *scale, page);
      }
    }
  });
}

void check_annex_a_section(const report::Section& section, const Page& page) {
  for_each_table(section, [&](const PrintedTable& table) {
    if (table.column("Contributor")) return check_budget_table(table, page);
    if (table.column("As measured") && table.column("Corrected")) return check_corrected_axis_table(table, page);
    if (table.caption().starts_with(
            "Expanded uncertainty of the mean deviations, composed of the contributors of Annex A"))
      return check_composed_mean_table(table, page);
    if (table.column("measured")) check_corrected_position_table(table, page);
  });
}

}  // namespace axiometry::verification
