// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/results/second_opinion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "axiometry/app/results/outputs.h"
#include "axiometry/app/results/report_subject.h"
#include "axiometry/app/results/result_json.h"
#include "axiometry/report/documents/compose.h"
#include "axiometry/standards/iso230_2/verdict/uncertainty_of_record.h"
#include "axiometry/verification/verify.h"

namespace axiometry::app {
namespace {

/// What only the trials know: how probable it is that a parameter lies between two values.
verification::Drawn drawn_by(const iso230_2::Assessment& assessment) {
  return [&assessment](std::string_view key, double low, double high) -> std::optional<verification::ProbabilityRange> {
    const auto* parameter = iso230_2::find_parameter(key);
    if (parameter == nullptr || !assessment.monte_carlo) return std::nullopt;
    std::optional<verification::ProbabilityRange> range;
    for (const auto& distribution : iso230_2::held_possible(*assessment.monte_carlo, *parameter)) {
      const double below = std::isinf(low) ? 0.0 : distribution.probability_below(low);
      const double p = std::max(0.0, distribution.probability_below(high) - below);
      if (!range) range = {p, p};
      *range = {std::min(range->least, p), std::max(range->most, p)};
    }
    return range;
  };
}

}  // namespace

Result<report::VerifiedFigures> second_opinion(const Evaluated& evaluated, const UncertaintyOptions& asked,
                                               const report::Options& options, std::string written) {
  if (written.empty()) written = json_line(evaluated);
  constexpr auto no_limit = std::numeric_limits<std::size_t>::max();
  AXIOMETRY_TRY(const json::Value result, json::parse(written, {.bytes = no_limit, .values = no_limit}));
  const report::Document document = report::compose(report_subject(evaluated), options);
  const std::string head = combined_csv_header(asked);
  const std::string row = combined_csv_row(evaluated, asked);
  const auto& as_measured = evaluated.test.as_measured;
  AXIOMETRY_TRY(const verification::Counts counts,
                verification::verify(
                    {result, document, head, row, options.uncertainty_digits},
                    {evaluated.test.series, as_measured ? &*as_measured : nullptr, drawn_by(evaluated.assessment)}));
  return report::VerifiedFigures{counts.figures, counts.verdicts, counts.compared};
}

}  // namespace axiometry::app
