// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"

/// What may be said of a result with the name of the standard: three claims, not one. A claim holds when nothing speaks
/// against it, and what was not stated does: absent is never the same as fine.
namespace axiometry::iso230_2 {

struct TestEnvironment;

enum class ClaimKind {
  computed,  ///< the formulas of clause 3 were applied to measured deviations
  tested,    ///< the test kept clauses 4 and 5, as far as a file can state it
  reported,  ///< every item and parameter of clause 8 is there
};

std::string_view claim_key(ClaimKind kind);  ///< "computed", "tested", "reported"

struct Claim {
  ClaimKind kind = ClaimKind::computed;
  std::string title;             ///< "Tested in accordance with ISO 230-2:2014"
  std::vector<Finding> against;  ///< departures contradict it; what is missing was not stated; no notes
  bool holds() const { return against.empty(); }
};

/// In the order of ClaimKind.
using Claims = std::array<Claim, 3>;

/// Of an assessment of either depth.
Claims claims_of(const Test& test, const Assessment& assessment);

/// What is known to be wrong with the values, or to lack of what the machine did: simulated readings, swapped labels, a
/// drift taken out, effects neither corrected nor in the uncertainty.
std::vector<Finding> errors_known_of(const Test& test, const Assessment& assessment);

inline const Claim& claim(const Claims& claims, ClaimKind kind) { return claims[static_cast<std::size_t>(kind)]; }

/// "contradicted by 2 points, 3 points open"; empty where it holds.
std::string against_text(const Claim& claim);

/// What ClaimKind::tested rests on that no item of a test states: a sentence without full stop. The gradient of the
/// temperature is among it unless it is known, by a log or stated (nullptr: neither), to lie within the limit that was
/// agreed; and the soaking unless it is stated for how long; the standard test cycle is not, of one
/// direction; that as much of the axis travel was measured as was agreed is, where that travel is not stated.
std::string word_of_the_tester(const Test& test, const TestEnvironment* surroundings);

}  // namespace axiometry::iso230_2
