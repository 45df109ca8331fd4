// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2.h"
#include "axiometry/standards/iso230_2_gum.h"
#include "axiometry/standards/iso230_2_monte_carlo.h"
#include "axiometry/standards/iso230_2_uncertainty.h"

namespace axiometry::iso230_2 {

enum class Severity {
  departure,  ///< the test departs from the standard: the result may not be called an ISO 230-2 result
  missing,    ///< something the report shall state (clause 8) was not given
  note,       ///< worth knowing; nothing is wrong
};

std::string_view severity_name(Severity severity);  ///< "departure", "missing", "note"

/// In place of a clause, of what the reader of the file found (Provenance::remarks) and not of a rule of the standard.
inline constexpr const char* source_clause = "source";

/// One departure, omission or remark, with the clause it rests on.
struct Finding {
  std::string clause;  ///< "5.3.2"; "source"
  Severity severity = Severity::note;
  std::string message;  ///< what was found and what the clause expects; a whole sentence without full stop
};

/// How far to look: a table of many tests says only whether each conforms.
enum class Depth {
  every_finding,
  departures_only,  ///< decides conforming() and leaves the rest out
};

/// How the test departs from clauses 4 to 8, in the order of the clauses, departures first.
std::vector<Finding> find_departures(const Metadata& metadata, const Series& series, const Evaluation& evaluation,
                                     const std::optional<AnnexA>& uncertainty, Depth depth = Depth::every_finding);

/// The whole answer to one test: everything a report shows. The findings are those of find_departures() with the
/// remarks of the test's source among them.
struct Assessment {
  Evaluation evaluation;
  std::optional<AnnexA> annex_a;
  std::optional<GumUncertainty> gum;  ///< this and the next are added by who wants them; assess() leaves them out
  std::optional<MonteCarlo> monte_carlo;
  std::vector<Finding> findings;
  std::string label;  ///< must stand wherever the results do: "step cycle (Annex B), not for acceptance"; else empty

  /// Whether the result may be called an ISO 230-2:2014 result: no finding is a departure.
  bool conforming() const;
};

Assessment assess(const Test& test, Depth depth = Depth::every_finding);

}  // namespace axiometry::iso230_2
