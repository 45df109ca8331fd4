// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/base/unit_sizes.h"
#include "axiometry/report/figures/drift_recording.h"
#include "axiometry/report/figures/mean_deviations.h"
#include "axiometry/report/method_values.h"
#include "axiometry/report/resolved_text.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/standards/readings/artefact.h"
#include "axiometry/standards/readings/runs_made.h"
#include "axiometry/standards/readings/station_offset.h"

namespace axiometry::report {

namespace {

using iso230_2::AnnexA;
using iso230_2::BudgetInput;
using iso230_2::Contributor;

constexpr int digits_given = 7;    // of inputs as stated; more would show what the conversion of units leaves
constexpr int digits_derived = 5;  // of inputs that nobody stated, such as the measured travel

/// "ΔT = 5 °C (assumed)", one input per line.
RichText inputs_text(const Contributor& contributor, const Options& options) {
  RichText text;
  for (const BudgetInput& input : contributor.inputs) {
    std::string value = fmt::format(
        "\u00a0=\u00a0{}", shown_short(input.value, options, input.note.empty() ? digits_given : digits_derived));
    if (!input.unit.empty()) value += fmt::format("\u00a0{}", input.unit);
    if (!input.note.empty()) value += fmt::format(" ({})", input.note);
    text = joined({text, plain(text.empty() ? "" : "\n"), symbol(input.symbol), plain(value)});
  }
  return text;
}

/// What it means that a contributor has no U. Inputs of the device's temperature may be missing rightly.
std::string_view meaning_of_absence(const Contributor& contributor, const Metadata& metadata) {
  const AnnexAInputs& given = metadata.uncertainty;
  const bool for_any_axis = contributor.key == "device" || contributor.key == "eve";
  if (metadata.axis.kind == AxisKind::rotary && !for_any_axis) return "for linear axes only";
  if (iso230_2::artefact_takes_place_of_device(metadata)) return "not given; left out";
  if (contributor.key == "misalignment" && station_offset(metadata)) return "the beam follows the reflector";
  if (contributor.key == "m_device" && !given.device_temperature_range) return "part of the device’s statement";
  if (contributor.key == "e_device" && !given.device_temperature_difference && !given.device_expansion_range)
    return "part of the device’s statement";
  return "not given; left out";
}

Table budget_table(const AnnexA& annex_a, const Metadata& metadata, const Options& options) {
  const AxisKind kind = metadata.axis.kind;
  const ParameterScale scale = parameter_scale(kind, options.unit);
  Table table;
  table.caption = plain("Budget: expanded contributions");
  table.columns = {{plain("Contributor"), Align::start, true, true},
                   {plain("Symbol")},
                   {plain("Inputs"), Align::start, false, true},
                   {joined({italic("U"), plain(" ("), italic("k"), plain(" = 2)")}), Align::decimal},
                   {plain("Unit")},
                   {plain("Formula")}};
  for (const Contributor& contributor : annex_a.budget) {
    const RichText inputs = inputs_text(contributor, options);
    table.rows.push_back(
        {text_cell(contributor.title),
         {symbol(contributor.symbol)},
         contributor.U ? TableCell{inputs} : quiet_cell(meaning_of_absence(contributor, metadata)),
         contributor.U ? text_cell(shown_uncertainty(*contributor.U, scale, options)) : quiet_cell("–"),
         contributor.U ? text_cell(scale.unit) : quiet_cell(""),
         text_cell(contributor.formula)});
  }
  for (const std::string& note : annex_a.notes) table.notes.push_back(sentence(note));
  return table;
}

/// What was stated about the uncertainty, what counts of it and where it comes from.
Table resolved_table(const std::vector<iso230_2::ResolvedRow>& rows, const Options& options) {
  Table table;
  table.caption = plain("Inputs as resolved");
  table.columns = {{plain("Symbol"), Align::start, true},
                   {plain("Input"), Align::start, false, true},
                   {plain("Value"), Align::start, false, true},
                   {plain("Origin"), Align::start, false, true},
                   {plain("Used by"), Align::start, false, true}};
  for (const iso230_2::ResolvedRow& row : rows) {
    const bool used = row.use != iso230_2::InputUse::none;
    table.rows.push_back({{symbol(row.symbol)},
                          text_cell(input_title(row)),
                          text_cell(input_value(row, options)),
                          text_cell(origin_text(row)),
                          used ? text_cell(use_text(row)) : TableCell{plain(use_text(row)), Tone::caution}});
  }
  return table;
}

constexpr std::string_view repeatability_keys[] = {"R", "R_up", "R_down"};

/// R, R↑ and R↓ as measured and corrected.
Table corrected_axis_table(const Subject& subject, const Options& options) {
  const auto& assessment = subject.assessment;
  const AxisKind kind = subject.test.metadata.axis.kind;
  const ParameterScale scale = parameter_scale(kind, options.unit);
  const auto cell = [&](const std::optional<Deviation>& value, const iso230_2::ParameterInfo& parameter) {
    const int decimals = parameter_decimals(parameter, assessment, kind, options);
    return value ? text_cell(format_fixed(value->in_native() * scale.per_native, decimals, options.numbers))
                 : quiet_cell("not applicable");
  };
  Table table;
  table.caption = plain("Repeatability of the axis, corrected for the environmental variation (A.2.6)");
  table.columns = {{plain("Symbol"), Align::start, true},
                   {plain("Parameter"), Align::start, false, true},
                   {plain("As measured"), Align::decimal},
                   {plain("Corrected"), Align::decimal},
                   {plain("Unit")}};
  for (std::string_view key : repeatability_keys) {
    const auto* parameter = iso230_2::find_parameter(key);
    table.rows.push_back({{symbol(parameter->symbol)},
                          text_cell(parameter->title),
                          cell(assessment.evaluation.parameters.*parameter->member, *parameter),
                          cell(assessment.annex_a->corrected->parameters.*parameter->member, *parameter),
                          text_cell(scale.unit)});
  }
  return table;
}

Table corrected_position_table(const Subject& subject, const Options& options) {
  const AxisKind kind = subject.test.metadata.axis.kind;
  const auto& corrected = *subject.assessment.annex_a->corrected;
  const auto& measured = subject.assessment.evaluation.positions;
  const int decimals = position_decimals(subject.test.series.targets());
  Table table;
  table.dense = true;
  table.caption =
      plain(fmt::format("Repeatability at the targets, as measured and corrected (A.10), {}", deviation_unit(kind)));
  table.groups = {{plain("Target"), 2}, {symbol("R_i↑"), 2}, {symbol("R_i↓"), 2}, {symbol("R_i"), 2}, {{}, 1}};
  table.columns = {{italic("i"), Align::decimal, true},
                   {joined({symbol("P_i"), plain(fmt::format(", {}", position_unit(kind)))}), Align::decimal}};
  for (int group = 0; group < 3; ++group) {
    table.columns.push_back({plain("measured"), Align::decimal, false, false, true});
    table.columns.push_back({plain("corrected"), Align::decimal});
  }
  table.columns.push_back({plain("Remark"), Align::start, false, false, true});
  const ShownTargets shown = shown_targets(subject.assessment.evaluation);
  for (const std::size_t i : shown.places) {
    const auto& before = measured[i];
    const auto& after = corrected.positions[i];
    const bool floored = std::ranges::find(corrected.floored, i) != corrected.floored.end();
    table.rows.push_back({text_cell(fmt::format("{}", i + 1)),
                          text_cell(format_fixed(before.target.in_native(), decimals, options.numbers)),
                          deviation_cell(before.R_up, options), deviation_cell(after.R_up, options),
                          deviation_cell(before.R_down, options), deviation_cell(after.R_down, options),
                          deviation_cell(before.R, options), deviation_cell(after.R, options),
                          floored ? TableCell{plain("floored"), Tone::caution} : quiet_cell("")});
  }
  if (!corrected.floored.empty())
    table.notes = {
        joined({plain("Floored: the environmental variation exceeds the spread of the readings, "), symbol("s_i"),
                plain("² < ("), symbol("U_EVE"), plain("/2)², and 0 was taken for the corrected "), symbol("s_i"),
                plain(" of that direction.")})};
  note_left_out(table, shown);
  return table;
}

/// As many decimals as the smallest U needs.
int composed_decimals(const AnnexA& annex_a, const Options& options) {
  std::optional<double> smallest;
  for (const iso230_2::AnnexAPosition& position : annex_a.positions)
    for (const auto& mean : {position.up, position.down, position.mean})
      if (mean && mean->U.in_native() > 0.0)
        smallest = std::min(smallest.value_or(mean->U.in_native()), mean->U.in_native());
  constexpr int finest = 6;
  return std::clamp(smallest ? decimals_for(*smallest, options.uncertainty_digits) : *options.deviation_decimals, 0,
                    finest);
}

/// The contributors over the length to each target, and the uncertainty of its mean deviations, k = 2.
class ComposedMeanTable {
 public:
  ComposedMeanTable(const Subject& subject, const Options& options)
      : annex_a_(*subject.assessment.annex_a),
        kind_(subject.test.metadata.axis.kind),
        options_(options),
        shown_(shown_targets(subject.assessment.evaluation)),
        decimals_(composed_decimals(annex_a_, options)) {
    table_.rows.resize(shown_.places.size());
  }

  Table operator()() {
    table_.dense = true;
    table_.caption = plain(
        fmt::format("Expanded uncertainty of the mean deviations, composed of the contributors of Annex A (k = 2), {}",
                    deviation_unit(kind_)));
    add_targets();
    add_contributors();
    add_means("x̄_i↑", annex_a_.runs == 1 ? "A.17" : "A.15", &iso230_2::AnnexAPosition::up);
    add_means("x̄_i↓", annex_a_.runs == 1 ? "A.17" : "A.15", &iso230_2::AnnexAPosition::down);
    add_means("x̄_i", annex_a_.runs == 1 ? "A.18" : "A.16", &iso230_2::AnnexAPosition::mean);
    add_notes();
    return std::move(table_);
  }

 private:
  TableCell cell(const std::optional<Deviation>& U) const {
    return U ? text_cell(format_fixed(U->in_native(), decimals_, options_.numbers)) : quiet_cell("–");
  }

  template <typename Cell>
  void add_column(RichText head, bool opens_group, const Cell& of) {
    table_.columns.push_back({std::move(head), Align::decimal, false, false, opens_group});
    for (std::size_t row = 0; row < shown_.places.size(); ++row) table_.rows[row].push_back(of(shown_.places[row]));
  }

  void add_targets() {
    std::vector<Position> targets;
    for (const iso230_2::AnnexAPosition& position : annex_a_.positions) targets.push_back(position.target);
    const int decimals = position_decimals(targets);
    const bool linear = kind_ == AxisKind::linear;
    table_.groups.push_back({plain("Target"), linear ? 3u : 2u});
    table_.columns = {{italic("i"), Align::decimal, true}};
    for (std::size_t row = 0; row < shown_.places.size(); ++row)
      table_.rows[row].push_back(text_cell(fmt::format("{}", shown_.places[row] + 1)));
    add_column(joined({symbol("P_i"), plain(fmt::format(", {}", position_unit(kind_)))}), false, [&](std::size_t i) {
      return text_cell(format_fixed(targets[i].in_native(), decimals, options_.numbers));
    });
    if (!linear) return;
    add_column(joined({symbol("l_i"), plain(", mm")}), false, [&](std::size_t i) {
      return text_cell(
          format_fixed(mm_per_m * annex_a_.positions[i].length_m.value_or(0.0), decimals, options_.numbers));
    });
  }

  /// Each with its equation; what was not given has no column.
  void add_contributors() {
    bool opens = true;
    std::size_t count = 0;
    for (std::size_t k = 0; k < annex_a_.budget.size(); ++k) {
      const Contributor& row = annex_a_.budget[k];
      if (!row.U || row.key == "eve") continue;
      add_column(joined({symbol(row.symbol), plain(fmt::format(" ({})", row.formula))}), std::exchange(opens, false),
                 [&](std::size_t i) { return cell(annex_a_.positions[i].contributions[k]); });
      ++count;
    }
    if (count > 0) table_.groups.push_back({plain("Contributors"), count});
  }

  void add_means(std::string_view sign, std::string_view equation,
                 std::optional<iso230_2::AnnexAMean> iso230_2::AnnexAPosition::*of) {
    if (std::ranges::none_of(annex_a_.positions, [&](const auto& position) { return (position.*of).has_value(); }))
      return;
    const auto U_eve = std::ranges::find(annex_a_.budget, "eve", &Contributor::key);
    const bool varies = U_eve != annex_a_.budget.end() && U_eve->U;
    table_.groups.push_back({symbol(sign), varies ? 2u : 1u});
    if (varies)
      add_column(joined({symbol("U_EVE"), plain(" (A.9)")}), true, [&](std::size_t i) {
        const auto& mean = annex_a_.positions[i].*of;
        return cell(mean ? mean->environment : std::nullopt);
      });
    add_column(joined({italic("U"), plain(fmt::format(" ({})", equation))}), !varies, [&](std::size_t i) {
      const auto& mean = annex_a_.positions[i].*of;
      return cell(mean ? std::optional(mean->U) : std::nullopt);
    });
  }

  void add_notes() {
    table_.notes.push_back(plain(
        "Composed here of the contributors of Annex A and combined as for the parameters; the annex itself states no "
        "uncertainty of mean deviations."));
    if (kind_ == AxisKind::linear)
      table_.notes.push_back(joined({symbol("l_i"), plain(": the length from where the instrument was set to zero, "
                                                          "else from the first target.")}));
    if (!annex_a_.missing.empty())
      table_.notes.push_back(
          joined({italic("U"), plain(" covers only the contributors that were given; see the budget.")}));
    note_left_out(table_, shown_);
  }

  const AnnexA& annex_a_;
  AxisKind kind_;
  const Options& options_;
  ShownTargets shown_;
  int decimals_;
  Table table_;
};

}  // namespace

Section uncertainty_section(const Subject& subject, const Options& options) {
  Section section{"uncertainty", "Measurement uncertainty (Annex A)", true, {}};
  const auto& annex_a = subject.assessment.annex_a;
  const auto& rows = subject.assessment.inputs.rows;
  const auto add_inputs = [&] {
    if (!rows.empty()) section.blocks.emplace_back(resolved_table(rows, options));
    if (auto recording = drift_recording_figure(subject, options)) section.blocks.emplace_back(*std::move(recording));
  };
  if (!annex_a) {
    section.blocks.emplace_back(Paragraph{plain("Not estimated: no input of Annex A was given."), Tone::quiet});
    add_inputs();
    return section;
  }
  section.blocks.emplace_back(Paragraph{plain(measurand_statement(
      iso230_2::Measurand::this_test, most_runs_made(subject.test.series), !subject.assessment.uncorrected.empty()))});
  section.blocks.emplace_back(budget_table(*annex_a, subject.test.metadata, options));
  add_inputs();
  if (auto means = mean_annex_a_figure(subject, options)) section.blocks.emplace_back(*std::move(means));
  if (!annex_a->positions.empty()) section.blocks.emplace_back(ComposedMeanTable(subject, options)());
  if (annex_a->corrected) {
    section.blocks.emplace_back(corrected_axis_table(subject, options));
    section.blocks.emplace_back(corrected_position_table(subject, options));
  }
  return section;
}

}  // namespace axiometry::report
