// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2.h"
#include "axiometry/standards/iso230_2_gum.h"
#include "axiometry/standards/iso230_2_monte_carlo.h"
#include "axiometry/standards/iso230_2_resolved_inputs.h"
#include "axiometry/standards/iso230_2_uncertainty.h"
#include "axiometry/standards/uncorrected_effects.h"

namespace axiometry::iso230_2 {

enum class Severity {
  departure,  ///< the test departs from the standard: it may not be called a test after ISO 230-2
  missing,    ///< something the report shall state (clause 8) was not given
  note,       ///< worth knowing; nothing is wrong
};

std::string_view severity_name(Severity severity);  ///< "departure", "missing", "note"

/// In place of a clause, of what the reader of the file found (Provenance::remarks) and not of a rule of the standard.
inline constexpr const char* source_clause = "source";

/// A deviation within a message, "2.99 µm", so that whoever shows the message may show it in another unit.
struct MessageDeviation {
  std::size_t at = 0;      ///< of its first byte
  std::size_t length = 0;  ///< in bytes, with its unit
  Deviation value;
};

/// One departure, omission or remark, with the clause it rests on.
struct Finding {
  std::string clause;  ///< "5.3.2"; "source"
  Severity severity = Severity::note;
  std::string message;  ///< what was found and what the clause expects; a whole sentence without full stop
  std::vector<MessageDeviation> deviations{};  ///< of the message, in its order
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
  ResolvedInputs inputs;  ///< of the uncertainty, that of every method
  std::optional<AnnexA> annex_a;
  std::optional<GumUncertainty> gum;  ///< this and the next are added by who wants them; assess() leaves them out
  std::optional<MonteCarlo> monte_carlo;
  /// What somebody chose to be the method of record; the default of iso230_2_record.h where nobody did.
  std::optional<UncertaintyMethod> method_of_record;
  std::vector<UncorrectedEffect> uncorrected;  ///< no verdict may rest on what they act on
  std::vector<Finding> findings;
  std::string label;  ///< must stand wherever the results do: "step cycle (Annex B), not for acceptance"; else empty

  /// Whether no finding is a departure: nothing that is known of the test contradicts the standard. What may be claimed
  /// for it is another question (iso230_2_claims.h).
  bool conforming() const;
};

Assessment assess(const Test& test, Depth depth = Depth::every_finding);

}  // namespace axiometry::iso230_2
