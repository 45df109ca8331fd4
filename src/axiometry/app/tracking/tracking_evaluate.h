// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/given_file.h"
#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/base/json/json.h"
#include "axiometry/model/tracking.h"
#include "axiometry/report/report.h"
#include "axiometry/standards/iso230_6.h"
#include "axiometry/tracking/lengths/line_evaluation.h"

/// The use case "from the lengths along the lines of a plan to one test for each line".
namespace axiometry::app {

/// A limit for one line of the plan, "xy:E=20um".
struct LineTolerance {
  std::string line;
  ToleranceText limit;
};

struct TrackingEvaluateOptions {
  std::string plan;                                           ///< file of the plan
  std::string station;                                        ///< file of a located station; empty: the plan's
  std::vector<std::pair<std::string, std::string>> metadata;  ///< key and text, over what the file says
  bool reversed = false;                                      ///< lengths fall where the reflector recedes
  bool find_breaks = true;
  std::optional<double> break_threshold_mm{};
  CaptureOptions recording{};                  ///< what a continuous recording does not say itself; its plan is `plan`
  ToleranceOptions tolerance;                  ///< tolerance that holds for all lines
  std::vector<LineTolerance> line_tolerances;  ///< limits of one line, in place of those of all lines
  UncertaintyOptions uncertainty;
};

/// "E=20um" for all lines or "xy:E=20um" for one: put where it belongs. Fails as parse_tolerance() does and on a second
/// limit for the same parameter of the same line.
Result<void> add_tolerance(const std::string& text, TrackingEvaluateOptions& options);

/// A file that was read.
struct ReadFile {
  std::string file;
  std::string sha256;
};

struct EvaluatedLines {
  TrackingPlan plan;  ///< the plan, with the station that was used
  tracking::LinesEvaluation evaluation;
  std::vector<Evaluated> tests;         ///< one for each line of the evaluation; name is its id
  iso230_6::DiagonalSummary diagonals;  ///< summary of the lines that several axes drive
  ReadFile lengths;
  ReadFile plan_file;
  std::optional<ReadFile> station_file;
  bool in_program_order = false;
  std::string recording{};  ///< layout of the continuous recording that the lengths were taken out of; else empty
};

/// Reads lengths, a table or a continuous recording as formats::is_length_recording() has it ("-" is the standard
/// input), plan and station, evaluates every line and assesses its test as `axiometry evaluate` does. Fails, with the
/// file's name, as the readers, evaluate_lines() and evaluate_test() do, and on a tolerance for a line that was not
/// measured.
Result<EvaluatedLines> evaluate_tracking(const std::string& lengths, const TrackingEvaluateOptions& options);

struct TrackingFiles {
  GivenFile lengths;
  GivenFile plan;
  std::optional<GivenFile> station;  ///< none: the plan's
};

/// The same of files that are at hand; those that the options name are not looked at.
Result<EvaluatedLines> evaluate_tracking(const TrackingFiles& files, const TrackingEvaluateOptions& options);

/// One report of all lines.
report::Document lines_document(const EvaluatedLines& evaluated, const report::Options& options);

/// Everything, as docs/results.md describes it.
json::Value to_json(const EvaluatedLines& evaluated);

/// Writes JSON and reports. Fails when an output is an input or cannot be written.
Result<void> write_outputs(const EvaluatedLines& evaluated, const OutputNames& names, const report::Options& options);

/// Writes the test of each line to a file of its own, whose name has the id in the place of "{name}"; ".json" or ".csv"
/// says the format. Fails on a name without "{name}" or of another kind and when one is an input or cannot be written.
Result<void> save_tests(const EvaluatedLines& evaluated, const std::string& name, const InputFiles& inputs);

}  // namespace axiometry::app
