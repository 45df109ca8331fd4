// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/files/source.h"
#include "axiometry/app/recordings/capture_session.h"
#include "axiometry/app/volumetric/part_stops.h"
#include "axiometry/base/result.h"
#include "axiometry/volumetric/machine/volumetric_data.h"

/// The use case "from a continuous recording of a tracking interferometer to the lengths of a part of a volumetric
/// plan".
namespace axiometry::app {

/// Names are those of the plan, in its order, whether there is a length of them or not; segments count from 1 with each
/// station and tool.
struct PartLengths {
  PartRange parts;
  volumetric::VolumetricLengths lengths;
  std::vector<PartStop> places;  ///< place of each length
  std::size_t planned = 0;       ///< stops of these parts
  std::size_t samples = 0;
  std::vector<std::string> notes;  ///< what could not be matched, where the beam was broken, …; sentences
  std::string layout;              ///< layout of the recording
  std::string sha256;              ///< hash of its file; empty for a live one
  bool simulated = false;          ///< as the recording says
};

/// What a session has found that was opened with any part of this plan. Its standstills are held against every part.
/// Parts that were said are refused where another one explains them far better; without, those that explain them best
/// are taken, and nothing is where two do so about as well. `may_hold_all`: all parts in succession too. Fails further
/// as capture::stop_lengths() does, and without any length.
Result<PartLengths> part_lengths(const volumetric::CalibrationPlan& plan, std::optional<PartRange> said,
                                 bool may_hold_all, const CaptureSession& session);

/// A session for these parts. Fails as check_parts() and CaptureSession do.
Result<CaptureSession> open_parts(const volumetric::CalibrationPlan& plan, PartRange parts,
                                  const CaptureOptions& options);

/// A whole recording. Fails as CaptureSession and part_lengths() do.
Result<PartLengths> read_part_recording(Source& source, const volumetric::CalibrationPlan& plan,
                                        std::optional<PartRange> said, bool may_hold_all,
                                        const CaptureOptions& options);

/// The table of them, as `volumetric identify` reads it: what was noted stands above it as comments.
std::string part_lengths_table(const PartLengths& lengths);

}  // namespace axiometry::app
