// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

#include "axiometry/compensation/prediction.h"
#include "axiometry/model/named_finding.h"

/// What a test that was measured again says of the table that was made of the first.
namespace axiometry::compensation {

struct RetestContext {
  bool sign_inferred = false;   ///< whether the control's sign is inferred: a sign mistake then names the way out
  bool above_expected = false;  ///< more is left than 95 % of re-tests would show, by more than chance lets expect
  bool above_95 = false;        ///< more is left than 95 % of re-tests would show
  bool is_part = false;         ///< much of the test was not measured again
};

/// How much of the test a re-test has that can be held against it: nothing where it is nearly all.
std::optional<NamedFinding> finding_of_part(const RetestEffect& effect, const Series& before, AxisKind kind);

/// Of a re-test: "does what it should", where all of the change is the table's, within 5 % or three times its standard
/// uncertainty, and nothing is above what was expected; or what went wrong instead, where that explains the change: a
/// sign mistake (the error doubled), a table that was not active, or in one direction alone, one that was added twice,
/// directions that are exchanged, positions mirrored, a reversal that is corrected twice. What nothing explains is told
/// as that, and so is a reversal of the table of which the re-test does not tell whether it is corrected.
NamedFinding finding_of_retest(const RetestEffect& effect, const RetestContext& context = {});

}  // namespace axiometry::compensation
