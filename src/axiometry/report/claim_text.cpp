// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/claim_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "axiometry/standards/test_standard.h"

namespace axiometry::report {

using iso230_2::ClaimKind;

std::string standing_text(const iso230_2::Claims& claims, const Axis& axis) {
  const iso230_2::Claim& tested = claim(claims, ClaimKind::tested);
  if (tested.holds()) return tested.title;
  const iso230_2::Claim& computed = claim(claims, ClaimKind::computed);
  if (computed.holds() && !is_diagonal(axis)) return computed.title + "; not a test in accordance with it";
  return fmt::format("Formulas of {} only", edition_of(axis));
}

std::string standing_name(const iso230_2::Claims& claims, const Axis& axis) {
  if (claim(claims, ClaimKind::tested).holds()) return edition_of(axis);
  const iso230_2::Claim& computed = claim(claims, ClaimKind::computed);
  // Of a diagonal the name of its own standard belongs beside that of the parameters.
  if (computed.holds() && !is_diagonal(axis)) return computed.title;
  return fmt::format("Formulas of {}", edition_of(axis));
}

bool is_contradicted(const iso230_2::Claim& claim) {
  return std::ranges::any_of(claim.against, [](const iso230_2::Finding& finding) {
    return finding.severity == iso230_2::Severity::departure;
  });
}

}  // namespace axiometry::report
