// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/capture_session.h"
#include "axiometry/app/requirements.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/format.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2_assessment.h"
#include "axiometry/standards/iso230_2_tolerance.h"

/// The use case "from a measured file to its evaluation".
namespace axiometry::app {

/// What is wanted beside Annex A, which costs nothing.
struct UncertaintyOptions {
  bool gum = false;
  bool monte_carlo = false;
  iso230_2::MonteCarloOptions trials;
};

struct EvaluateOptions {
  std::string format;                                         ///< id to force; empty: recognised by content
  std::vector<std::pair<std::string, std::string>> metadata;  ///< key and text, over what the file says
  std::optional<CaptureOptions> recording;  ///< inputs are continuous recordings, to be read after this plan
  bool nde_correct = false;                 ///< bring the readings to 20 °C first (standards/nde_correction.h)
  ToleranceOptions tolerance;
  UncertaintyOptions uncertainty;
  /// Whether the tests of a file of many are stated in full: every finding, and the hash of the file by a
  /// pass of its own. A table needs neither.
  bool many_in_full = true;
};

/// One test with everything that is said about it.
struct Evaluated {
  Test test;
  std::string name;  ///< of a test among many in its file; else empty
  iso230_2::Assessment assessment;
  std::vector<iso230_2::Judgement> judgements;
  std::optional<AppliedBand> tolerance_band;  ///< of the tolerance table, when there is one
};

/// Metadata over what the file says, the correction for expansion where it is asked for, then assessment and
/// verdicts. Fails on a key or value that the vocabulary does not allow, on a correction that cannot be made and as
/// requirements_for() does.
Result<Evaluated> evaluate_test(Test test, const EvaluateOptions& options,
                                iso230_2::Depth depth = iso230_2::Depth::every_finding);

/// The only test of a file ("-" is the standard input), as it was measured. Fails on a file of many.
Result<Test> read_test(const std::string& file, const std::string& format = "");

using EvaluatedSink = std::function<Result<void>(Evaluated&&)>;

/// Reads every test of one file ("-" is the standard input), evaluates and hands over each as soon as
/// it is complete. Errors carry the file's name; nothing after an error is handed over.
Result<void> evaluate_file(const std::string& file, const EvaluateOptions& options, const EvaluatedSink& sink);

/// A file that the user named, or one that was found in a folder the user named.
struct InputFile {
  std::string name;
  bool from_folder = false;  ///< then what no format recognises is passed over, not refused
};

/// Files stay, folders give the files below them in alphabetical order, hidden ones left out. Fails on
/// what does not exist.
Result<std::vector<InputFile>> expand_inputs(const std::vector<std::string>& names);

/// Whether any format recognises the beginning of the file.
Result<bool> is_test_file(const std::string& file);

}  // namespace axiometry::app
