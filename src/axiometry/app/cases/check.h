// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/model/test.h"

/// Conformance cases: plain text in which a metrologist states readings and what an evaluation of them
/// must give. The language is described in docs/conformance-cases.md:
///
///     operation iso230-2
///     targets     0   500  1000   mm
///     up          0   1.0   2.0   um
///     down       -1   0.5   1.0   um
///     expect B = 1 um
///     expect R not applicable
///
/// or a measurement model with its inputs and what the two methods of uncertainty/ must give:
///
///     operation model
///     input X1 normal 0 1
///     input X2 uniform -1 1
///     model Y = X1 + X2
///     expect mcm u = 1.1547005
namespace axiometry::app {

/// One expectation and what came.
struct CaseComparison {
  std::size_t line = 0;
  std::string expectation;  ///< as it was written: "A = 9.6 um"
  std::string expected;     ///< "9.6 um within 1e-09 um"
  std::string got;          ///< "9.58 um", "not applicable", "no such finding"
  std::string difference;   ///< got − expected: "-0.0136 um"; empty where there is none
  bool met = false;
};

/// "line 12: A = 9.6 um: got 9.58 um, expected 9.6 um within 1e-09 um, difference -0.02 um"
std::string to_string(const CaseComparison& comparison);

/// What became of the expectations of one text.
struct CheckReport {
  std::string title;                        ///< title of the case; empty when it has none
  std::vector<CaseComparison> comparisons;  ///< at least one comparison, in the order of the lines

  std::vector<CaseComparison> failures() const;  ///< those that were not met
  bool passed() const { return failures().empty(); }
};

/// Gives the test of a file that a case names, relative to the case.
using LoadTest = std::function<Result<Test>(std::string_view file)>;

/// Carries out every operation of a case and compares. Fails, with line and column, when the text is no
/// case: an unknown word, a number or unit that cannot be read, readings that do not match the targets,
/// no expectation at all. Data that the evaluation refuses are no such failure: `expect error` is about
/// them, and any other expectation is then not met.
Result<CheckReport> check_case(std::string_view text, const LoadTest& load);

}  // namespace axiometry::app
