// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/base/json.h"
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

/// Everything, as docs/results.md describes it.
json::Value to_json(const ComparedRules& compared);

/// Writes JSON and reports. Fails when an output is the input or cannot be written.
Result<void> write_outputs(const ComparedRules& compared, const OutputNames& names, const report::Options& options);

}  // namespace axiometry::app
