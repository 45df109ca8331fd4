// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/reader.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/base/json/json.h"
#include "axiometry/standards/rules/comparison.h"

/// The use case "from a measured file to its figures by several rules".
namespace axiometry::app {

struct ComparedRules {
  Test test;
  standards::RuleComparison comparison;
};

/// The rules of these ids, each once. Fails on an id that no rule has, listing those there are, and on one given twice.
Result<std::vector<const standards::AxisRule*>> named_rules(std::span<const std::string> ids);

/// Reads the only test of a file, prepares it as evaluate_test() does and compares the rules, all where none is given.
/// Errors carry the file's name.
Result<ComparedRules> compare_rules_of(const std::string& file, const EvaluateOptions& reading,
                                       std::span<const standards::AxisRule* const> rules);

/// The same of a test that is prepared already, with intervals where trials are asked for; an adaptive
/// run where their number is not said. Fails as compare_rules() and add_intervals() do.
Result<ComparedRules> compare_rules_of(Test test, std::span<const standards::AxisRule* const> rules,
                                       const UncertaintyOptions& uncertainty = {});

/// Everything, as docs/results.md describes it.
json::Value to_json(const ComparedRules& compared);
/// RulesCompared of the API (apps/server/openapi.json): without what the test itself tells, texts in the reader's
/// language, and beside the numbers of each figure how they are shown.
json::Value to_json(const ComparedRules& compared, const Reader& reader);

/// Writes JSON and reports. Fails when an output is the input or cannot be written.
Result<void> write_outputs(const ComparedRules& compared, const OutputNames& names, const report::Options& options);

}  // namespace axiometry::app
