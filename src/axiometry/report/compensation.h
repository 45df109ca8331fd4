// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/model/axis_correction.h"
#include "axiometry/model/named_finding.h"
#include "axiometry/model/test.h"
#include "axiometry/report/document.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/iso230_2/parameters.h"

/// The report of a table by which a control corrects an axis.
namespace axiometry::report {

/// What a control says of its tables.
struct ControlWords {
  std::string_view title, sign, loading, verified, inferred;
  bool rolls_over = false;  ///< whether a table goes on beyond either end to the value of the other end
};

/// In one direction with the table, native deviation unit.
struct KnownMean {
  double residual = 0.0;    ///< mean deviation that is left, about the mean of all
  std::optional<double> U;  ///< U of the position that one approach ends at
};

/// To within what positions are known that the table corrects (compensation/compensated_positions.h).
struct KnownPositions {
  struct Row {
    Position target;
    std::optional<KnownMean> up, down;
  };
  std::vector<Row> targets;
  double zero = 0.0;                           ///< shift of the zero that positions are against
  std::optional<double> at_targets, anywhere;  ///< the largest |r| + U
  std::vector<std::string> notes;              ///< sentences without full stop
};

struct CompensationSubject {
  const Test& test;  ///< test as it was measured
  ControlWords control;
  const AxisCorrection& applied;   ///< what the file makes the control add, as it reads it
  const AxisCorrection* existing;  ///< active while the test was measured; may be none
  const iso230_2::Evaluation& before;
  const iso230_2::Evaluation& predicted;
  const iso230_2::AxisParameters* expected;  ///< parameters of a re-test, below in 95 %; none where nothing scatters
  const iso230_2::Evaluation* retest;        ///< may be none
  const Provenance* retest_source;           ///< of the re-test; none without one
  const iso230_2::AxisParameters& scatter;   ///< what no table removes
  const KnownPositions& known;
  std::span<const NamedFinding> findings;
  double smoothing = 0.0;
  std::string_view notes{};  ///< notes of who made it, in lines; may be none
};

/// Before, predicted and re-test as parameters and curves over each other, the table, what no table removes, how the
/// table gets into the control, what is verified of its format.
Document compose(const CompensationSubject& subject, const Options& options);

}  // namespace axiometry::report
