// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/app/evaluate/requirements.h"
#include "axiometry/app/files/given_file.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/app/temperatures/evaluated_temperatures.h"
#include "axiometry/base/result.h"
#include "axiometry/formats/format.h"
#include "axiometry/model/test.h"
#include "axiometry/report/documents/verified.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"
#include "axiometry/standards/iso230_2/verdict/tolerance.h"
#include "axiometry/standards/readings/reading_correction.h"

/// The use case "from a measured file to its evaluation".
namespace axiometry::app {

/// What is wanted beside Annex A, which costs nothing.
struct UncertaintyOptions {
  bool gum = false;
  bool monte_carlo = false;
  iso230_2::MonteCarloOptions trials;
};

/// What is known of the calibration of one component of the test equipment beside the test itself.
struct EquipmentCalibration {
  std::size_t component = 0;  ///< its place in the list of equipment, from 0
  std::string certificate;
  std::string calibrated_on;
  std::string calibration_due;
};

struct EvaluateOptions {
  std::string format;                                         ///< id to force; empty: recognised by content
  std::string profile;                                        ///< file of an import profile to read after; or empty
  std::vector<std::pair<std::string, std::string>> metadata;  ///< key and text, over what the file says
  StatedItems stated{};                ///< keys of `metadata` that are no flags, and who states them
  std::vector<std::string> remarks{};  ///< what must be known of where metadata come from: notes among the findings
  std::optional<CaptureOptions> recording;    ///< inputs are continuous recordings, to be read after this plan
  CorrectionRequest corrections;              ///< what is corrected in the readings before they are evaluated
  std::string drift_recording;                ///< file of a recording at standstill (A.2.5); empty: none but the test's
  std::optional<LogWithTest> temperatures{};  ///< log of the temperatures before and during the test (4.1)
  /// Whether the readings are indicated positions of an artefact's probing (standards/readings/artefact.h). When not
  /// said: where the test states the artefact's calibrated positions.
  std::optional<bool> artefact{};
  /// For components of which neither the file nor `metadata` states a calibration.
  std::vector<EquipmentCalibration> calibrations{};
  ToleranceOptions tolerance;
  UncertaintyOptions uncertainty;
  /// Whether the tests of a file of many are stated in full: every finding, and the hash of the file by a
  /// pass of its own. A table needs neither.
  bool many_in_full = true;
};

/// One test with everything that is said about it.
struct Evaluated {
  Test test;
  std::string name;  ///< name of a test among many in its file; else empty
  iso230_2::Assessment assessment;
  std::vector<iso230_2::Judgement> judgements;
  std::optional<AppliedBand> tolerance_band;                      ///< band of the tolerance table, when there is one
  std::optional<report::VerifiedFigures> verified{};              ///< figures recomputed by second_opinion(), if at all
  std::optional<EvaluatedTemperatures> temperatures{};            ///< what a log of the temperatures tells, if any
  std::optional<iso230_2::TestEnvironment> stated_environment{};  ///< what the test itself states, without a log

  /// Of the test, by a log or stated; nullptr where nothing is known of it and nothing agreed.
  const iso230_2::TestEnvironment* environment() const {
    if (temperatures) return &temperatures->environment;
    return stated_environment ? &*stated_environment : nullptr;
  }
};

/// Whether the test itself says how a component of its equipment was calibrated.
bool states_calibration(const Equipment& component);

/// Metadata over what the file says, calibrations, then what is done to the readings: the artefact's calibrated
/// positions, the corrections that are asked for. Fails on a key or value that the vocabulary does not allow, and on
/// what cannot be done.
Result<Test> prepare_test(Test test, const EvaluateOptions& options);

/// prepare_test(), then assessment and verdicts. Fails on a key or value that the vocabulary does not allow, on a
/// correction that cannot be made and as requirements_for() does.
Result<Evaluated> evaluate_test(Test test, const EvaluateOptions& options,
                                iso230_2::Depth depth = iso230_2::Depth::every_finding);

/// The only test of a file ("-" is the standard input), as it was measured; read after an import profile when there is
/// one. Fails on a file of many, and on a format beside a profile unless it is the generic one.
Result<Test> read_test(const std::string& file, const std::string& format = "", const std::string& profile = "");
/// The same of a file that is at hand.
Result<Test> read_test(const GivenFile& file);

/// Puts metadata over what the file says. Fails as set_field_text() does, and where axis.kind would change.
Result<void> set_metadata(Metadata& metadata, std::span<const std::pair<std::string, std::string>> items);

using EvaluatedSink = std::function<Result<void>(Evaluated&&)>;
using TestSink = std::function<Result<void>(Test&&, std::string&& name)>;

/// Hands over every test of a source as it was measured, with its name where it is one among many. Fails as the format
/// that its beginning fits does; nothing after an error is handed over.
Result<void> read_tests(Source& source, const TestSink& sink);

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

}  // namespace axiometry::app
