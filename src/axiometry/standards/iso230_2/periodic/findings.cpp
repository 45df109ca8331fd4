// SPDX-License-Identifier: Apache-2.0
//
// The annex's own text is not at hand: two periods and four targets per period are what general practice asks for.
#include "axiometry/standards/iso230_2/periodic/findings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/standards/iso230_2/programme.h"

namespace axiometry::iso230_2 {
namespace {

constexpr double enough_periods = 2.0;
constexpr double enough_targets = 4.0;
constexpr double forgiven = 1e-9;  // relative tolerance for a number of periods or targets, as targets are rounded

/// At most so many digits, as a person would write it.
std::string figure(double x, int digits = 4) { return fmt::format("{:.{}g}", x, digits); }

/// Of one direction.
class DirectionFindings {
 public:
  DirectionFindings(const Test& test, const PeriodicDirection& d)
      : metadata_(test.metadata),
        d_(d),
        unit_(metadata_.axis.kind == AxisKind::linear ? " mm" : "°"),
        deviation_(deviation_unit(metadata_.axis.kind)),
        period_(d.period.value.in_native()) {}

  void add(std::vector<Finding>& all, bool name_direction) const {
    for (auto finding : {few_periods(), coarse_targets(), equal_spacing(), not_significant(), at_end(), expected(),
                         further(), above_scatter(), correlated(), missing_readings()}) {
      if (!finding) continue;
      if (name_direction) finding->message += fmt::format(" ({})", arrow(d_.direction));
      all.push_back(*std::move(finding));
    }
  }

 private:
  static Finding departure(std::string id, std::string message) {
    return {std::move(id), "Annex C", Severity::departure, std::move(message)};
  }
  static Finding note(std::string id, std::string message) {
    return {std::move(id), "Annex C", Severity::note, std::move(message)};
  }

  double spacing() const { return period_ / d_.targets_per_period; }
  std::string shown(double x) const { return period_text(x, metadata_.axis.kind); }

  /// A peak of chance stands anywhere: targets are judged by a period that is known or found.
  bool has_period() const { return d_.period_known || d_.significant; }

  std::optional<Finding> few_periods() const {
    if (!has_period() || d_.periods_covered >= enough_periods - forgiven) return std::nullopt;
    return departure("periodic-few-periods",
                     fmt::format("found {} periods of {} over {}, expected two or more", figure(d_.periods_covered, 3),
                                 shown(period_), shown(d_.periods_covered * period_)));
  }

  std::optional<Finding> coarse_targets() const {
    if (!has_period() || d_.targets_per_period >= enough_targets - forgiven) return std::nullopt;
    return departure(
        "periodic-coarse-targets",
        fmt::format("found targets every {} on average for a period of {}, that is {} per period, expected "
                    "four or more",
                    shown(spacing()), shown(period_), figure(d_.targets_per_period, 3)));
  }

  /// With an interval d the frequencies 1/λ and |1/λ − k/d| give the same readings.
  std::optional<Finding> equal_spacing() const {
    if (!has_period()) return std::nullopt;
    const double d = spacing();
    for (std::size_t k = 1; k < d_.points.size(); ++k)
      if (std::abs(d_.points[k].target.in_native() - d_.points[k - 1].target.in_native() - d) > equal_interval * d)
        return std::nullopt;
    const double frequency = 1.0 / period_;
    const double other = std::abs(frequency - std::round(std::max(frequency * d, 0.5 + forgiven)) / d);
    if (other <= forgiven / d) return std::nullopt;
    return note("periodic-equal-spacing",
                fmt::format("found equally spaced targets (every {}): a period of {} and one of {} give the same "
                            "readings, expected uneven steps to tell them apart",
                            shown(d), shown(period_), shown(1.0 / other)));
  }

  std::optional<Finding> not_significant() const {
    if (d_.significant) return std::nullopt;
    const double amplitude = d_.harmonics.front().amplitude.value.in_native();
    const double percent = 100.0 * d_.false_alarm_correlated;
    const std::string chance = percent < 10.0 ? figure(percent, 2) : fmt::format("{:.0f}", percent);
    if (d_.period_known)
      return note("periodic-not-significant",
                  fmt::format("found no significant error of the period {}: noise alone gives an amplitude of {} {} or "
                              "more in up to {} % of such tests",
                              shown(period_), figure(amplitude, 2), deviation_, chance));
    const double longest = d_.spectrum.front().period.in_native(), shortest = d_.spectrum.back().period.in_native();
    std::string message = fmt::format(
        "found no significant periodic error with a period from {} to {}: noise alone gives a peak as high as that at "
        "{} in up to {} % of such tests",
        shown(shortest), shown(longest), shown(std::clamp(period_, shortest, longest)), chance);
    const auto& stated = metadata_.axis.expected_period;
    if (stated && (stated->in_native() < shortest || stated->in_native() > longest))
      message += fmt::format(
          "; the expected period, {} after axis.expected_period, was not searched for: state it as "
          "known",
          shown(stated->in_native()));
    return note("periodic-not-significant", std::move(message));
  }

  std::optional<Finding> at_end() const {
    if (d_.beyond_band)
      return note(
          "periodic-peak-at-end",
          fmt::format("found the highest peak at the end of the searched band, at {}, and a period beyond it "
                      "that fits better, where nothing was searched: what is told is that of the end, without U",
                      shown(period_)));
    if (!d_.peak_at_end || !d_.significant) return std::nullopt;
    return note(
        "periodic-peak-at-end",
        fmt::format("found the highest peak at the end of the searched band, at {}: the error may have a period "
                    "beyond it, or none (a bow of the axis looks so)",
                    shown(period_)));
  }

  std::optional<Finding> expected() const {
    const auto& stated = metadata_.axis.expected_period;
    if (!stated || stated->in_native() <= 0.0) return std::nullopt;
    const double U = d_.coverage_factor * d_.period.u.in_native();
    const double difference = std::abs(period_ - stated->in_native());
    constexpr double clearly = 1.5;  // times U: one good test in 400 or so is beyond
    if (difference <= std::max(clearly * U, 1e-3 * stated->in_native())) return std::nullopt;
    if (!has_period()) return std::nullopt;
    return note("periodic-other-than-expected",
                fmt::format("found a period of {}{}, expected {} after axis.expected_period", shown(period_),
                            d_.period_known ? " given" : fmt::format(" ± {}", figure(U, 2) + unit_),
                            shown(stated->in_native())));
  }

  std::optional<Finding> further() const {
    if (!d_.further) return std::nullopt;
    const double other = d_.further->period.in_native();
    const double ratio = other / period_;
    const bool multiple = ratio > 1.5 && std::abs(ratio - std::round(ratio)) < 0.02 * ratio;
    return note(
        "periodic-further-period",
        fmt::format("found a further period of {} with an amplitude of {} {} in what the curve leaves{}",
                    figure(other) + unit_, figure(d_.further->amplitude.in_native(), 2), deviation_,
                    multiple ? fmt::format("; it is {:.0f} times the first, which may be its harmonic", ratio) : ""));
  }

  /// Residuals far above what the runs let expect are no noise: the axis does more than a line and this curve.
  std::optional<Finding> above_scatter() const {
    constexpr double far_above = 3.0;
    if (!d_.scatter_of_means) return std::nullopt;
    const double scatter = d_.scatter_of_means->in_native(), sd = d_.residual_sd.in_native();
    if (scatter <= 0.0 || sd <= far_above * scatter) return std::nullopt;
    return note(
        "periodic-above-scatter",
        fmt::format("found a residual standard deviation of {} {}, where the scatter of the runs lets expect {} "
                    "{}: the deviations hold more than a line and this period",
                    figure(sd, 2), deviation_, figure(scatter, 2), deviation_));
  }

  /// What the fit and the chances take for independent of each other is not.
  std::optional<Finding> correlated() const {
    constexpr double shown = 1.05;  // a factor that would print as "1 times" is not told
    if (!d_.residual_correlation.told) return std::nullopt;
    if (d_.curve_times < shown)
      return note("periodic-correlated-residuals",
                  fmt::format("found residuals that go on from target to target (correlation {:.2f}): U of the line "
                              "was enlarged {:.2g} times, that of so short a period not, and chances of white noise "
                              "are too small",
                              d_.residual_correlation.lag_one, d_.line_times));
    return note("periodic-correlated-residuals",
                fmt::format("found residuals that go on from target to target (correlation {:.2f}): U of the curve was "
                            "enlarged {:.2g} times and U of the line {:.2g} times, and chances of white noise are too "
                            "small",
                            d_.residual_correlation.lag_one, d_.curve_times, d_.line_times));
  }

  std::optional<Finding> missing_readings() const {
    if (d_.missing == 0) return std::nullopt;
    return note("periodic-missing-readings",
                fmt::format("found {} missing: what the runs are shifted by against each other was taken out before "
                            "their mean, and how well it is known is in U",
                            counted(d_.missing, "reading")));
  }

  const Metadata& metadata_;
  const PeriodicDirection& d_;
  std::string unit_;
  std::string_view deviation_;
  double period_;
};

}  // namespace

std::string period_text(double native, AxisKind kind) {
  return format_exact(std::round(native * 1e4) / 1e4) + (kind == AxisKind::linear ? " mm" : "°");
}

std::vector<Finding> periodic_findings(const Test& test, std::span<const PeriodicDirection> directions) {
  std::vector<Finding> all;
  const bool both = directions.size() > 1;
  for (const PeriodicDirection& d : directions) DirectionFindings(test, d).add(all, both);
  if (both)
    all.push_back({"periodic-both-directions", "Annex C", Severity::note,
                   "found readings from both directions, expected one: each is evaluated for itself"});
  std::ranges::stable_sort(all, {}, &Finding::severity);
  return all;
}

bool PeriodicError::conforming() const {
  return std::ranges::none_of(findings, [](const Finding& finding) { return finding.severity == Severity::departure; });
}

}  // namespace axiometry::iso230_2
