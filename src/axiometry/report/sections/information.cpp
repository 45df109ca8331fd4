// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>

#include "axiometry/report/correction_text.h"
#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/standards/iso230_2/information.h"
#include "axiometry/standards/iso230_2/slope.h"
#include "axiometry/standards/readings/drift.h"

namespace axiometry::report {

namespace {

Fact slope_fact(const Subject& subject, const Options& options) {
  const auto slope = iso230_2::slope_of_means(subject.assessment.evaluation.positions);
  if (!slope) return {plain("Slope of the means"), quiet_cell("not applicable")};
  const AxisKind kind = subject.test.metadata.axis.kind;
  const double slope_native = slope->per_position_native;
  const std::string shown = kind == AxisKind::linear
                                ? fmt::format("{}\u00a0µm/m", format_fixed(1000.0 * slope_native, 2, options.numbers))
                                : fmt::format("{}\u00a0″/360°", format_fixed(360.0 * slope_native, 2, options.numbers));
  const auto over_travel = Deviation::native(slope_native * subject.test.series.travel_native());
  return {plain("Slope of the means"),
          text_cell(fmt::format(
              "{}, that is {}\u00a0{} over the measured travel (least-squares line). Information only: nothing "
              "was removed, and all results above contain it.",
              shown, shown_deviation(over_travel, options), deviation_unit(kind)))};
}

Fact drift_fact(const Subject& subject, const Options& options) {
  const auto drift = drift_of(subject.test);
  if (!course_of(subject.test).order_known)
    return {plain("Drift"), quiet_cell("not known: neither times nor the cycle tell the order of the readings")};
  const Series& series = subject.test.series;
  const bool both = series.has_both_directions();
  if (!drift)
    return {plain("Drift"), quiet_cell(both ? "not applicable: one approach from each direction"
                                            : "not applicable: one approach from one direction")};
  const auto& corrections = subject.test.provenance.corrections;
  const bool removed = std::ranges::find(corrections, "drift", &AppliedCorrection::id) != corrections.end();
  if (removed) return {plain("Drift"), quiet_cell("taken out by the correction for drift, see Provenance")};
  return {plain("Drift"), text_cell(fmt::format(
                              "{} (least-squares line in time with a constant per target and direction; {}). "
                              "Information only: nothing was removed.",
                              drift_statement(*drift, subject.test.metadata.axis.kind, options), drift->course.basis))};
}

Fact smaller_repeatability_fact(const iso230_2::SmallerRepeatability& smaller, const Subject& subject,
                                const Options& options) {
  const ShownParameter shown = show(*smaller.parameter, subject.assessment, subject.test.metadata.axis.kind, options);
  RichText text = plain(fmt::format("{}\u00a0{} (", shown.value, shown.unit));
  return {plain("Smaller of R↑ and R↓"),
          {joined({text, symbol(smaller.parameter->symbol), plain("): "),
                   sentence(iso230_2::smaller_repeatability_remark)})}};
}

}  // namespace

Section information_section(const Subject& subject, const Options& options) {
  Facts facts;
  facts.facts = {slope_fact(subject, options), drift_fact(subject, options)};
  if (const auto smaller =
          iso230_2::smaller_repeatability(subject.test.metadata, subject.assessment.evaluation.parameters))
    facts.facts.push_back(smaller_repeatability_fact(*smaller, subject, options));
  return {"information", "For information", true, {std::move(facts)}};
}

}  // namespace axiometry::report
