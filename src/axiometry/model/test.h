// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "axiometry/model/metadata.h"
#include "axiometry/model/series.h"

namespace axiometry {

/// A correction for nominal differential expansion (4.1) that this program has applied to the readings, with all that
/// it takes to do it again.
struct AppliedExpansionCorrection {
  /// Of the machine or of the measuring equipment: the mean of its sensors.
  struct Part {
    ExpansionCoefficient expansion;
    Temperature start;
    Temperature end;
    std::size_t sensors = 0;
  };
  Part machine;
  std::optional<Part> equipment;  ///< absent: its expansion is none, or part of its own readings
  Position datum;                 ///< where the instrument was set to zero: nothing is corrected there
  Deviation smallest;             ///< of what was added to single readings
  Deviation largest;
};

/// Where a test's readings come from, so that a result can be traced to the byte.
struct Provenance {
  std::string file;    ///< name as the user gave it; "-" for the standard input
  std::string sha256;  ///< of the source file's bytes, lower-case hexadecimal
  std::string format;  ///< id of the format that read it, "csv-long"
  std::optional<AppliedExpansionCorrection> expansion_correction{};  ///< what was done to the readings since
};

/// One positioning test: what was tested, how, and the readings. The readings are valid by
/// construction; metadata is as complete as its source.
struct Test {
  Metadata metadata;
  Series series;
  Provenance provenance;
  std::optional<Series> as_measured{};  ///< the readings before a correction by this program; never changed
};

}  // namespace axiometry
