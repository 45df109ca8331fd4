// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/report/sections/sections.h"
#include "axiometry/report/shown_number.h"
#include "axiometry/standards/iso230_2_slope.h"

namespace axiometry::report {

Section information_section(const Subject& subject, const Options& options) {
  Section section{"information", "For information", true, {}};
  const auto slope = iso230_2::slope_of_means(subject.assessment.evaluation.positions);
  if (!slope) {
    section.blocks.emplace_back(Paragraph{plain("Slope of the means: not applicable."), Tone::quiet});
    return section;
  }
  const AxisKind kind = subject.test.metadata.axis.kind;
  const double slope_native = slope->per_position_native;
  const std::string shown = kind == AxisKind::linear
                                ? fmt::format("{}\u00a0µm/m", format_fixed(1000.0 * slope_native, 2, options.numbers))
                                : fmt::format("{}\u00a0″/360°", format_fixed(360.0 * slope_native, 2, options.numbers));
  const auto over_travel = Deviation::native(slope_native * subject.test.series.travel_native());
  Facts facts;
  facts.facts = {{plain("Slope of the means"),
                  text_cell(fmt::format(
                      "{}, that is {}\u00a0{} over the measured travel (least-squares line). Information only: nothing "
                      "was removed, and all results above contain it.",
                      shown, shown_deviation(over_travel, options), deviation_unit(kind)))}};
  section.blocks.emplace_back(std::move(facts));
  return section;
}

}  // namespace axiometry::report
