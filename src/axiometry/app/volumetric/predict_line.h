// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/results/experiment.h"
#include "axiometry/app/volumetric/result_model.h"
#include "axiometry/volumetric/field/line_prediction.h"
#include "axiometry/volumetric/identify/identification.h"

/// The use case "what would a test of this line show, and does one that was measured agree".
namespace axiometry::app {

struct PredictRequest {
  std::string result;    ///< file of `axiometry volumetric identify --out`
  std::string axis;      ///< "X", "Y" or "Z"; or
  std::string diagonal;  ///< one of volumetric::diagonal_names(); or neither, where plan or test state a line in space
  std::string at;        ///< where the others stand, for a line along an axis: "y=300,z=-250"
  std::string tool;      ///< may be empty where the machine has one
  std::string plan;      ///< file; its targets, and its line where it states one; or
  std::string measured;  ///< file of a test, likewise; it is held against the prediction
};

struct PredictedTest {
  PredictRequest request;
  volumetric::ErrorModel model;
  std::size_t tool = 0;
  volumetric::PredictedLine predicted;
  std::optional<volumetric::LineComparison> comparison;
  std::vector<volumetric::VolumetricFinding> findings;
  std::string result_sha256 = {}, measured_sha256 = {};  ///< hashes of their files; empty of what is read once
};

/// A line that plan or test state is the one that is predicted; an axis with its place, or a diagonal, must be the same
/// line, and so must the axis that they name and the tool point of a test that states its line. Fails as the files, on
/// a line that is not stated or stated twice, on targets where the errors are not known, and on a line of which the
/// lengths do not tell all. A test of one direction is held against that direction where the errors tell it.
Result<PredictedTest> predict_test(const PredictRequest& request);

/// The same of a model that is at hand; request.result is only its name.
Result<PredictedTest> predict_test(KeptModel kept, const PredictRequest& request);

/// Report and JSON; keys: docs/results.md.
Experiment present(const PredictedTest& predicted, const report::Options& options);

}  // namespace axiometry::app
