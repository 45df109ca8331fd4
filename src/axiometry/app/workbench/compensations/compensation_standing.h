// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/workbench/compensations/compensations.h"

/// What the tests that a kept table rests on have become since, and what still counts of what was found.
namespace axiometry::app {

/// With what became of it. Fails as the archive does.
Result<TestOfCompensation> test_of_compensation(const store::Transaction& archive, store::Id id, int version);

/// Of both tests: withdrawn, or with a later version that differs in metadata, options or axis. Empty where neither is.
std::vector<NamedFinding> findings_since(const TestOfCompensation& test,
                                         const std::optional<TestOfCompensation>& retest);

/// Those of a result that was kept without what was concluded from its re-test, where that no longer counts.
std::vector<KeptFinding> counting_findings(const json::Value& result, bool retest_counts);

/// Of a table in a form that earlier versions of this program wrote, with which the control does something else than
/// was found of it: serious. Its bytes are kept as they are.
std::optional<NamedFinding> former_form(std::string_view control, std::string_view table);

}  // namespace axiometry::app
