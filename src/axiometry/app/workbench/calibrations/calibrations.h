// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <stop_token>
#include <string>
#include <vector>

#include "axiometry/app/workbench/calibrations/calibration_evaluation.h"
#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/base/json/json.h"
#include "axiometry/store/store.h"

/// Calibrations in the archive: kept with their files, evaluated again, shown, compared.
///
/// As with tests, what a version found is kept with it: a report is made again from the files and the options of its
/// version, and is refused (conflict) where this program no longer finds the figures that were kept.
namespace axiometry::app {

struct NewCalibration {
  std::string kind;  ///< store/kept/calibration_kinds.h
  std::vector<CalibrationSource> files;
  json::Value options = json::Value::object();
  std::string title;                   ///< empty: as the files suggest
  std::optional<store::Id> machine{};  ///< none: the one of the archive that the files name, where it has one
  std::optional<store::Id> instrument{};
  std::string measured_on{};  ///< empty: as the files say
  std::string notes{};
  std::stop_token stop{};  ///< nobody waits for the answer any more
};

/// What is absent stays as it is.
struct CalibrationRevision {
  int base_version = 0;
  std::string reason;
  std::optional<json::Value> options{};  ///< it is evaluated again
  std::optional<std::string> title{};
  std::optional<std::optional<store::Id>> machine{};
  std::optional<std::optional<store::Id>> instrument{};
  std::optional<std::string> measured_on{};
  std::optional<std::string> notes{};
  std::stop_token stop{};  ///< nobody waits for the answer any more
};

/// A calibration of the archive at one of its versions.
struct KeptCalibration {
  store::Versioned<store::CalibrationRecord> calibration;
  std::vector<store::Versioned<store::CalibrationRecord>> versions;     ///< the first is version 1
  std::optional<store::Versioned<store::MachineRecord>> machine;        ///< as it is called now
  std::optional<store::Versioned<store::InstrumentRecord>> instrument;  ///< as it was known then
  json::Value result;                                                   ///< exactly what was kept
  /// Of one that has just been kept: the others of exactly these files, the oldest first, withdrawn ones too.
  std::optional<std::vector<store::Id>> same_files{};
};

/// Files and result are kept together, or nothing; also a second time, since other options or another program make
/// another calibration of the same files, but told in `same_files`. Fails as evaluate_calibration() and the archive do.
Result<KeptCalibration> keep_calibration(store::Store& archive, const NewCalibration& calibration, const store::By& by);

/// Without version: the latest.
Result<KeptCalibration> kept_calibration(const store::Store& archive, store::Id id, std::optional<int> version = {});

/// A new version. Fails with `conflict` when base_version is no longer the latest.
Result<KeptCalibration> revise_calibration(store::Store& archive, store::Id id, const CalibrationRevision& revision,
                                           const store::By& by);

/// A new version that says so. Fails with `conflict` when it is so already.
Result<KeptCalibration> withdraw_calibration(store::Store& archive, store::Id id, bool withdrawn, const store::By& by);

/// Fails on an extension that no writer has; "json" is the result that was kept.
Result<Rendered> calibration_report(const store::Store& archive, store::Id id, std::optional<int> version,
                                    const ReportRequest& request);

/// The bytes of a file as they came. Fails with not_found on a role that it has no file of.
Result<Rendered> calibration_file(const store::Store& archive, store::Id id, const std::string& role);

/// A figure of both, in its unit.
struct ComparedFigure {
  std::string parameter;
  std::string of;
  std::string unit;
  std::optional<double> before, before_u;  ///< absent where that one has none; u: standard uncertainty
  std::optional<double> after, after_u;
};

struct CalibrationComparison {
  KeptCalibration before, after;
  std::vector<ComparedFigure> rows;
};

/// The latest versions of two: their figures, and of the 21 errors the largest amount of each curve and squareness.
/// Fails on two of different kinds.
Result<CalibrationComparison> compare_calibrations(const store::Store& archive, store::Id before, store::Id after);

}  // namespace axiometry::app
