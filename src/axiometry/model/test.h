// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/model/metadata.h"
#include "axiometry/model/origins.h"
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
  Position datum;                 ///< position where the instrument was set to zero: nothing is corrected there
  Deviation smallest;             ///< smallest amount that was added to a reading
  Deviation largest;
};

/// One correction that this program has applied to the readings, in words and figures that let it be done again.
struct AppliedCorrection {
  /// One input or intermediate result: "Refractive index of air", "1.000271 (Ciddor)".
  struct Detail {
    std::string name;
    std::string value;
  };
  std::string id;     ///< "air", as asked for on the command line
  std::string title;  ///< "Refractive index of air"
  std::vector<Detail> details;
  Deviation smallest;  ///< smallest amount that was added to a reading
  Deviation largest;
};

/// What a reader must know about how a file was understood: it becomes a finding of the assessment.
struct SourceRemark {
  bool departs = false;            ///< such a test is no test after ISO 230-2: "averages only"
  std::string message;             ///< what was found and how it was taken; a sentence without full stop
  bool of_swapped_labels = false;  ///< the labels of direction contradict the order of the rows
};

/// Where a test's readings come from, so that a result can be traced to the byte.
struct Provenance {
  std::string file;                              ///< name as the user gave it; "-" for the standard input
  std::string sha256;                            ///< hash of the source file's bytes, lower-case hexadecimal
  std::string format;                            ///< id of the format that read it, "csv-long"
  std::vector<SourceRemark> remarks{};           ///< what the reader of the file remarked
  std::vector<AppliedCorrection> corrections{};  ///< what was done to the readings since, in this order, and then
  std::optional<AppliedExpansionCorrection> expansion_correction{};
  StatedItems stated{};  ///< items of the metadata that come from elsewhere than the file
};

/// One positioning test: what was tested, how, and the readings. The readings are valid by
/// construction; metadata is as complete as its source.
struct Test {
  Metadata metadata;
  Series series;
  Provenance provenance;
  std::optional<Series> as_measured{};  ///< the readings before any correction by this program; never changed
  /// When each reading was taken, s since some beginning; dense as in Series::make_dense(), NaN where not known; empty
  /// when no time is known.
  std::vector<double> times_s{};
};

}  // namespace axiometry
