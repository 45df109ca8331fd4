// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/figures/mean_deviations.h"
#include "axiometry/report/method_values.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {

namespace {

using iso230_2::Coverage;
using iso230_2::ExpandedUncertainty;
using iso230_2::GumUncertainty;
using iso230_2::PositionComponents;
using iso230_2::PositionUncertainty;

std::string shown_k(double k, const Options& options) { return format_fixed(k, 2, options.numbers); }

TableCell degrees_cell(const ExpandedUncertainty& uncertainty, const Options& options) {
  if (uncertainty.coverage == Coverage::correlated) return quiet_cell("not defined");
  const auto& nu = uncertainty.effective_degrees_of_freedom;
  if (!nu || *nu > 1e4) return text_cell("∞");
  return text_cell(format_fixed(*nu, *nu < 10.0 ? 1 : 0, options.numbers));
}

Table parameter_table(const GumUncertainty& gum, AxisKind kind, const Options& options) {
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto shown = [&](Deviation u) { return text_cell(shown_uncertainty(u, scale, options)); };
  Table table;
  table.caption = plain(fmt::format("Expanded uncertainty of the parameters, {}", scale.unit));
  table.columns = {
      {plain("Symbol"), Align::start, true}, {plain("Parameter"), Align::start, false, true},
      {italic("u"), Align::decimal},         {symbol("ν_eff"), Align::decimal},
      {italic("k"), Align::decimal},         {joined({italic("U"), plain(" = "), italic("k u")}), Align::decimal}};
  for (const auto& p : gum.parameters) {
    table.rows.push_back({{symbol(p.parameter->symbol)},
                          text_cell(p.parameter->title),
                          shown(p.uncertainty.u),
                          degrees_cell(p.uncertainty, options),
                          text_cell(shown_k(p.uncertainty.k, options)),
                          shown(p.uncertainty.U)});
  }
  table.notes = {joined({italic("k"), plain(" for a probability of about 95\u00a0%: 2, or after Student’s t where "),
                         symbol("ν_eff"),
                         plain(" is finite (GUM, G.4). A parameter without a row is not touched by any "
                               "source.")})};
  for (const std::string& note : gum.notes) table.notes.push_back(sentence(note));
  return table;
}

Table factor_table(const GumUncertainty& gum, const Options& options) {
  Table table;
  table.caption = plain("Factors that multiply every position, µm/m");
  table.columns = {{plain("Symbol"), Align::start, true},
                   {plain("Factor"), Align::start, false, true},
                   {plain("Less 1"), Align::decimal},
                   {joined({italic("u"), plain(", linear (15)")}), Align::decimal},
                   {joined({italic("u"), plain(", exact (A.1)")}), Align::decimal},
                   {joined({italic("u"), plain(", used")}), Align::decimal}};
  const auto add = [&](const auto& factor, std::string_view sign, std::string_view title) {
    if (!factor) return;
    const auto number = [&](double x) { return text_cell(shown_short(x, options, 3)); };
    table.rows.push_back({{symbol(sign)},
                          text_cell(title),
                          number(factor->departure),
                          number(factor->u_linear),
                          number(factor->u_exact),
                          number(factor->u)});
  };
  add(gum.machine_thermal, "f_t", "Thermal expansion of the machine");
  add(gum.device_thermal, "f_t,D", "Thermal expansion of the measuring device");
  add(gum.alignment, "f_a", "Alignment of the measuring device with the axis");
  return table;
}

/// A column of the position table for each component that is not zero everywhere.
struct Component {
  std::string_view title;
  Deviation PositionComponents::*member;
};

constexpr Component components[] = {
    {"appr.", &PositionComponents::approaches},  {"therm.", &PositionComponents::thermal},
    {"align.", &PositionComponents::alignment},  {"res.", &PositionComponents::axis_resolution},
    {"instr.", &PositionComponents::instrument}, {"other", &PositionComponents::other}};

using PerDirection = std::optional<PositionComponents> PositionUncertainty::*;

std::vector<Component> existing(const GumUncertainty& gum, PerDirection direction) {
  std::vector<Component> found;
  for (const Component& component : components)
    if (std::ranges::any_of(gum.positions, [&](const PositionUncertainty& p) {
          return p.*direction && ((*(p.*direction)).*component.member).in_native() > 0.0;
        }))
      found.push_back(component);
  return found;
}

class PositionTable {
 public:
  PositionTable(const GumUncertainty& gum, const Subject& subject, const Options& options)
      : gum_(gum),
        subject_(subject),
        options_(options),
        shown_(shown_targets(subject.assessment.evaluation)),
        decimals_(decimals(gum, options)) {}

  Table operator()() {
    const AxisKind kind = subject_.test.metadata.axis.kind;
    const int decimals = position_decimals(subject_.test.series.targets());
    table_.dense = true;
    table_.caption =
        plain(fmt::format("Components of the standard uncertainty at the targets, {}", deviation_unit(kind)));
    table_.rows.resize(shown_.places.size());
    table_.groups.push_back({plain("Target"), 2});
    table_.columns = {{italic("i"), Align::decimal, true},
                      {joined({symbol("P_i"), plain(fmt::format(", {}", position_unit(kind)))}), Align::decimal}};
    for (std::size_t row = 0; row < shown_.places.size(); ++row) {
      const std::size_t i = shown_.places[row];
      table_.rows[row] = {text_cell(fmt::format("{}", i + 1)),
                          text_cell(format_fixed(gum_.positions[i].target.in_native(), decimals, options_.numbers))};
    }
    add_direction("x̄_i↑", &PositionUncertainty::up);
    add_direction("x̄_i↓", &PositionUncertainty::down);
    add_mean();
    table_.notes = {
        plain("Approaches: of the mean of the approaches. Thermal: expansion of the machine and of the "
              "device. Alignment, resolution of the axis, instrument with calibration and environment: "
              "as in the table of inputs.")};
    note_left_out(table_, shown_);
    return std::move(table_);
  }

 private:
  /// One more than the smallest uncertainty of a mean needs, so that the columns can be compared.
  static int decimals(const GumUncertainty& gum, const Options& options) {
    std::optional<double> smallest;
    for (const PositionUncertainty& p : gum.positions)
      for (const auto& c : {p.up, p.down})
        if (c && c->total.u.in_native() > 0.0)
          smallest = std::min(smallest.value_or(c->total.u.in_native()), c->total.u.in_native());
    constexpr int finest = 6;
    const int needed = smallest ? decimals_for(*smallest, options.uncertainty_digits) + 1 : *options.deviation_decimals;
    return std::clamp(needed, 0, finest);
  }

  TableCell cell(const std::optional<Deviation>& u) const {
    if (!u) return quiet_cell("–");
    return text_cell(format_fixed(u->in_native(), decimals_, options_.numbers));
  }

  template <typename Value>
  void add_column(RichText head, bool opens_group, const Value& value) {
    table_.columns.push_back({std::move(head), Align::decimal, false, false, opens_group});
    for (std::size_t row = 0; row < shown_.places.size(); ++row)
      table_.rows[row].push_back(value(gum_.positions[shown_.places[row]]));
  }

  void add_direction(std::string_view sign, PerDirection direction) {
    if (std::ranges::none_of(gum_.positions, [&](const auto& p) { return (p.*direction).has_value(); })) return;
    const auto shown = existing(gum_, direction);
    table_.groups.push_back({symbol(sign), shown.size() + 2});
    bool opens = true;
    for (const Component& component : shown) {
      add_column(plain(component.title), std::exchange(opens, false), [&](const PositionUncertainty& p) {
        return cell(p.*direction ? std::optional((*(p.*direction)).*component.member) : std::nullopt);
      });
    }
    add_column(italic("u"), std::exchange(opens, false), [&](const PositionUncertainty& p) {
      return cell(p.*direction ? std::optional((p.*direction)->total.u) : std::nullopt);
    });
    add_column(italic("U"), false, [&](const PositionUncertainty& p) {
      return cell(p.*direction ? std::optional((p.*direction)->total.U) : std::nullopt);
    });
  }

  void add_mean() {
    if (std::ranges::none_of(gum_.positions, [](const auto& p) { return p.mean.has_value(); })) return;
    table_.groups.push_back({symbol("x̄_i"), 2});
    add_column(italic("u"), true,
               [&](const PositionUncertainty& p) { return cell(p.mean ? std::optional(p.mean->u) : std::nullopt); });
    add_column(italic("U"), false,
               [&](const PositionUncertainty& p) { return cell(p.mean ? std::optional(p.mean->U) : std::nullopt); });
  }

  const GumUncertainty& gum_;
  const Subject& subject_;
  const Options& options_;
  ShownTargets shown_;
  int decimals_ = 0;
  Table table_;
};

}  // namespace

Section gum_section(const Subject& subject, const Options& options) {
  const GumUncertainty& gum = *subject.assessment.gum;
  const AxisKind kind = subject.test.metadata.axis.kind;
  Section section{"gum", "Law of propagation of uncertainty (GUM)", true, {}};
  section.blocks.emplace_back(parameter_table(gum, kind, options));
  Table budget = contribution_table(gum_contributions(gum), subject, options);
  budget.caption = joined({plain("GUM: contributions |"), italic("c"), plain("|\u2009"), italic("u"),
                           plain(fmt::format(" of the sources, {}", parameter_scale(kind, options.unit).unit))});
  section.blocks.emplace_back(std::move(budget));
  if (Table factors = factor_table(gum, options); !factors.rows.empty())
    section.blocks.emplace_back(std::move(factors));
  if (auto means = mean_deviation_figure(subject, options)) section.blocks.emplace_back(*std::move(means));
  section.blocks.emplace_back(PositionTable(gum, subject, options)());
  return section;
}

}  // namespace axiometry::report
