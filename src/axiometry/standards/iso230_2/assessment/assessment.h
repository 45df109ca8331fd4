// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/finding.h"
#include "axiometry/standards/iso230_2/inputs/resolved_inputs.h"
#include "axiometry/standards/iso230_2/inputs/uncorrected_effects.h"
#include "axiometry/standards/iso230_2/monte_carlo/monte_carlo.h"
#include "axiometry/standards/iso230_2/parameters.h"
#include "axiometry/standards/iso230_2/uncertainty/annex_a.h"
#include "axiometry/standards/iso230_2/uncertainty/gum.h"

namespace axiometry::iso230_2 {

/// How far to look: a table of many tests says only whether each conforms.
enum class Depth {
  every_finding,
  departures_only,  ///< decides conforming() and leaves the rest out
};

/// How the test departs from clauses 4 to 8, in the order of the clauses, departures first.
std::vector<Finding> find_departures(const Metadata& metadata, const Series& series, const Evaluation& evaluation,
                                     const std::optional<AnnexA>& uncertainty, Depth depth = Depth::every_finding);

/// Whether the deviations progress in order from run to run (4.3): one of find_departures(), which leaves it out of a
/// table of many tests, where a claim asks for it all the same.
std::optional<Finding> find_progression(const Metadata& metadata, const Series& series, const Evaluation& evaluation,
                                        const std::optional<AnnexA>& uncertainty);

/// The whole answer to one test: everything a report shows. The findings are those of find_departures() with the
/// remarks of the test's source among them.
struct Assessment {
  Evaluation evaluation;
  ResolvedInputs inputs;  ///< inputs of the uncertainty, which every method takes
  std::optional<AnnexA> annex_a;
  std::optional<GumUncertainty> gum;  ///< this and the next are added by who wants them; assess() leaves them out
  std::optional<MonteCarlo> monte_carlo;
  /// What somebody chose to be the method of record; the default of verdict/uncertainty_of_record.h where nobody did.
  std::optional<UncertaintyMethod> method_of_record;
  std::vector<UncorrectedEffect> uncorrected;  ///< no verdict may rest on what they act on
  std::vector<Finding> findings;
  std::optional<Finding> progression;  ///< find_progression(), at every depth: looked for once
  std::string label;  ///< must stand wherever the results do: "step cycle (Annex B), not for acceptance"; else empty
  bool temperatures_recorded = false;  ///< whether a log tells the air's temperature at start and end of the test

  /// Whether no finding is a departure: nothing that is known of the test contradicts the standard. What may be claimed
  /// for it is another question (rules/claims.h).
  bool conforming() const;
};

Assessment assess(const Test& test, Depth depth = Depth::every_finding);

}  // namespace axiometry::iso230_2
