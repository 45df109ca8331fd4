// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "axiometry/app/files/given_file.h"
#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/app/volumetric/part_stops.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/identify/identification.h"
#include "axiometry/volumetric/machine/volumetric_data.h"

/// The lengths of a volumetric calibration out of one or several files, tables and continuous recordings.
namespace axiometry::app {

/// A file of lengths, as it was used.
struct LengthsFile {
  std::string file;
  std::string sha256;
  std::size_t lengths = 0;  ///< how many lengths it gave
  std::string layout = {};  ///< layout of a continuous recording; empty for a table
  PartRange parts = {};     ///< parts of the plan that a recording holds
  std::size_t planned = 0;  ///< how many stops the parts of a recording have in the plan
};

struct GatheredLengths {
  volumetric::VolumetricLengths lengths;
  std::vector<LengthsFile> files;  ///< files in the order in which they were named
  std::vector<volumetric::VolumetricFinding> findings;
};

struct LengthsRequest {
  std::vector<std::string> files;     ///< "-" is the standard input
  std::vector<PartRange> parts = {};  ///< parts that the recordings hold, in their order; none: they are recognised
  CaptureOptions recording = {};      ///< what a recording does not say itself
  std::vector<GivenFile> given = {};  ///< their bytes where these are at hand, as many as files; then none is opened
};

/// Reads all. Of several files each station and tool may come from one table alone, and each stop of the plan from one
/// recording. Recordings need a plan (part_lengths.h); tables are held against it where there is one: rows of a station
/// and tool at the points of another part are refused, those at no point of their part are told. Fails, with the file's
/// name, as the readers do, on parts for more or fewer recordings than there are, on reversed lengths without a
/// recording, and on a part that two recordings seem to hold unless it was said for both.
Result<GatheredLengths> gather_lengths(const LengthsRequest& request, const volumetric::CalibrationPlan* plan);

}  // namespace axiometry::app
