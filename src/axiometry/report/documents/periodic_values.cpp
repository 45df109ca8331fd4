// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "axiometry/report/periodic.h"
#include "axiometry/report/shown_number.h"

namespace axiometry::report {
namespace {

using iso230_2::PeriodicDirection;

constexpr int digits_without_u = 3;

/// Value and U, the value to U's last place. Of a fit without rest U is nothing but rounding: then seven digits.
PeriodicRow row(std::string title, std::string symbol, double value, std::optional<double> U, std::string_view unit,
                const Options& options) {
  PeriodicRow result{std::move(title), std::move(symbol), "", "", std::string(unit)};
  const bool tells = U && *U > 1e-7 * std::abs(value) && *U > 1e-9;
  if (!tells) {
    result.value = shown_short(std::round(value * 1e9) / 1e9 + 0.0, options, U ? 7 : digits_without_u);
    if (U) result.U = "0";
    return result;
  }
  const int decimals = decimals_for(*U, options.uncertainty_digits);
  result.value = format_fixed(value, decimals, options.numbers);
  result.U = format_fixed(*U, decimals, options.numbers);
  return result;
}

/// "0.034"; far tails rest on what the noise is like there, which nobody knows.
std::string shown_chance(double chance, const Options& options) {
  constexpr double far = 1e-4;
  if (chance < far) return fmt::format("< {}", format_fixed(far, 4, options.numbers));
  return shown_short(chance, options, 2);
}

double per_metre(AxisKind kind) { return kind == AxisKind::linear ? 1000.0 : 1.0; }

/// None of what noise alone makes as large, where no interval holds the truth as often as U says.
std::optional<double> expanded(double u, double k, bool significant) {
  return significant ? std::optional(k * u) : std::nullopt;
}

/// An angle's U is no more than half a turn.
std::optional<double> expanded_angle(Angle u, double k, bool significant) {
  return expanded(std::min(u.in_deg(), 180.0 / k), k, significant);
}

}  // namespace

std::vector<PeriodicRow> periodic_rows(const PeriodicDirection& d, AxisKind kind, const Options& options) {
  const double k = d.coverage_factor;
  const std::string_view mm = position_unit(kind), um = deviation_unit(kind);
  const auto& fundamental = d.harmonics.front();
  const auto plain_row = [&](std::string title, std::string symbol, double value, std::string_view unit) {
    return row(std::move(title), std::move(symbol), value, std::nullopt, unit, options);
  };
  const auto deviation_row = [&](std::string title, std::string symbol, const iso230_2::Estimate<Deviation>& x) {
    const auto U = expanded(x.u.in_native(), k, d.tells_U());
    return row(std::move(title), std::move(symbol), x.value.in_native(), U, um, options);
  };
  const auto angle_row = [&](std::string title, std::string symbol, const iso230_2::Estimate<Angle>& x) {
    return row(std::move(title), std::move(symbol), x.value.in_deg(), expanded_angle(x.u, k, d.tells_U()), "°",
               options);
  };

  std::vector<PeriodicRow> rows;
  if (d.period_known) {
    rows.push_back({"Period, as given", "λ", shown_exact(d.period.value.in_native(), options), "", std::string(mm)});
  } else {
    rows.push_back(row("Period, found", "λ", d.period.value.in_native(),
                       expanded(d.period.u.in_native(), k, d.tells_U()), mm, options));
  }
  rows.push_back(deviation_row("Amplitude", "A_1", fundamental.amplitude));
  rows.push_back(angle_row("Phase at the first target", "φ_1", fundamental.phase));
  rows.push_back(angle_row("Phase at position 0", "φ_0", d.phase_at_zero));
  rows.push_back(deviation_row("Peak to valley of the curve", "", d.peak_to_valley));
  rows.push_back(plain_row("Range of the deviations less the line", "", d.range_about_line.in_native(), um));
  rows.push_back(plain_row("Range of the residuals", "", d.range_of_residuals.in_native(), um));
  rows.push_back(plain_row("Standard deviation of the residuals", "s", d.residual_sd.in_native(), um));
  if (d.scatter_of_means)
    rows.push_back(plain_row("Scatter of the means, from the runs", "", d.scatter_of_means->in_native(), um));
  rows.push_back({"Degrees of freedom", "ν", fmt::format("{}", d.degrees_of_freedom), "", ""});
  rows.push_back(row("Slope of the removed line", "b", d.slope_native.value * per_metre(kind),
                     k * d.slope_native.u * per_metre(kind), kind == AxisKind::linear ? "µm/m" : "″/°", options));
  rows.push_back(row("Removed line at the first target", "a", d.offset.value.in_native(), k * d.offset.u.in_native(),
                     um, options));
  rows.push_back({d.period_known ? "Chance of this size by white noise" : "Chance of the peak by white noise", "p",
                  shown_chance(d.false_alarm, options), "", ""});
  rows.push_back(plain_row("Periods covered", "", d.periods_covered, ""));
  rows.push_back(plain_row("Targets per period", "", d.targets_per_period, ""));
  return rows;
}

Table harmonic_table(const PeriodicDirection& d, AxisKind kind, const Options& options) {
  Table table;
  table.caption = plain("Harmonics of the period");
  const std::string_view um = deviation_unit(kind);
  table.columns = {{italic("h"), Align::decimal, true},
                   {plain(fmt::format("Period, {}", position_unit(kind))), Align::decimal},
                   {joined({symbol("A_h"), plain(fmt::format(", {}", um))}), Align::decimal},
                   {joined({italic("U"), plain(fmt::format(", {}", um))}), Align::decimal},
                   {joined({symbol("φ_h"), plain(", °")}), Align::decimal},
                   {joined({italic("U"), plain(", °")}), Align::decimal},
                   {plain("Chance by white noise"), Align::decimal},
                   {plain("Part of the curve"), Align::start, false, true}};
  const auto has_told_size = [&](const auto& h) { return d.tells_U() && h.significant; };
  for (const auto& h : d.harmonics) {
    const bool told = has_told_size(h);
    const PeriodicRow A = row("", "", h.amplitude.value.in_native(),
                              expanded(h.amplitude.u.in_native(), d.coverage_factor, told), um, options);
    const PeriodicRow phase =
        row("", "", h.phase.value.in_deg(), expanded_angle(h.phase.u, d.coverage_factor, told), "°", options);
    const bool drawn = h.order == 1 || h.significant;
    table.rows.push_back({{plain(fmt::format("{}", h.order))},
                          {plain(shown_short(d.period.value.in_native() / static_cast<double>(h.order), options, 5))},
                          {plain(A.value)},
                          A.U.empty() ? quiet_cell("–") : text_cell(A.U),
                          {plain(phase.value)},
                          phase.U.empty() ? quiet_cell("–") : text_cell(phase.U),
                          {plain(shown_chance(h.chance, options))},
                          {plain(h.order == 1 ? "always"
                                 : drawn      ? "yes"
                                              : "no, not significant"),
                           drawn ? Tone::normal : Tone::quiet}});
  }
  table.notes = {
      joined({plain("Each harmonic is "), symbol("A_h"), plain(" sin(2π "), italic("h"), plain(" ("), italic("P"),
              plain(" − "), symbol("P_1"), plain(")/"), italic("λ"), plain(" + "), symbol("φ_h"),
              plain(fmt::format("). U = k u with k = {} for about 95\u00a0% (Student’s t).",
                                format_fixed(d.coverage_factor, 2, options.numbers)))})};
  if (!std::ranges::all_of(d.harmonics, has_told_size))
    table.notes.push_back(plain(
        "What is not significant has no U: noise alone makes as large an amplitude in more than 1 % of such tests."));
  return table;
}

}  // namespace axiometry::report
