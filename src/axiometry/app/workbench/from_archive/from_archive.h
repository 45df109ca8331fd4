// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/workbench/test_options.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "axiometry/model/test.h"
#include "axiometry/standards/iso230_2/verdict/tolerance.h"
#include "axiometry/store/store.h"

/// What an evaluation takes from the archive beside the test itself: inputs of its instruments and limits of its axis.
/// Both may change later; what was taken is kept with every version, so that it can be computed again.
namespace axiometry::app {

/// The inputs of one instrument that were taken: those that neither the file nor the user states.
struct InstrumentInputs {
  store::Id instrument = 0;
  int version = 0;
  std::string name;
  Changes inputs;
  /// What nobody else states either, but part of a statement that somebody makes: a certificate's a + b·L, of which the
  /// file has a, is taken as a whole or not at all.
  Changes left_out{};
};

/// The calibration of a component of the test equipment that held on the day of the test, and the version of the
/// instrument that tells of it. The newest before that day where none held any more; the last where that day is not
/// known.
struct KnownCalibration {
  store::Id instrument = 0;
  int version = 0;
  EquipmentCalibration calibration;
};

/// Limits of the axis; they apply where nothing else sets a limit.
struct AxisLimits {
  store::Id axis = 0;
  int version = 0;
  std::vector<store::Limit> limits;
  std::string set_on{};  ///< day of that version of the axis; empty in what was kept before days were
};

struct FromArchive {
  std::vector<InstrumentInputs> instruments;
  std::vector<KnownCalibration> calibrations{};
  std::optional<AxisLimits> axis;
};

/// [{"parameter", "value"}].
json::Value limits_to_json(const std::vector<store::Limit>& limits);
/// Fails, with line and column, on an unknown parameter, one given twice, and a limit outside 0 to 1 000 000 µm or ″.
Result<std::vector<store::Limit>> limits_from(const json::Value& value);

json::Value to_json(const FromArchive& taken);
/// Fails, with line and column, on what to_json() does not write.
Result<FromArchive> from_archive_of(const json::Value& value);

/// How people call an instrument: "Example Instruments LI-1 1234", or its role.
std::string instrument_name(const store::InstrumentRecord& instrument);

/// The instruments that the metadata list, in their order; lines that say nothing are left out.
std::vector<store::InstrumentRecord> instruments_of(const Metadata& metadata);
store::MachineRecord machine_of(const Metadata& metadata);
store::AxisRecord axis_of(const Metadata& metadata);

/// What the archive has linked a test with; nothing of a test that it does not have.
struct ArchiveLinks {
  std::optional<store::Id> machine;
  std::optional<store::Id> axis;
  std::vector<store::Id> instruments;
};

/// What an evaluation asks the archive.
struct ArchiveQuestion {
  Metadata metadata;  ///< what the file says with the user's changes
  Changes changes;
  std::optional<ArchiveLinks> links{};
};

/// What a test is evaluated with that comes from the archive. The links count unless the changes are about machine,
/// axis or equipment; without them things are those that the archive would link the test with (Transaction::known()),
/// the axis that of the machine with which a revision of it would stay. A
/// key that the changes name, even to take its value away, is not taken from an instrument.
Result<FromArchive> find_in_archive(const store::Transaction& archive, const ArchiveQuestion& question);

/// The options with what was taken: inputs of instruments, then the changes, calibrations and the limits of the axis.
EvaluateOptions with_archive(EvaluateOptions options, const Changes& changes, const FromArchive& taken);

}  // namespace axiometry::app
