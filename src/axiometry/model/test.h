// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/model/metadata.h"
#include "axiometry/model/series.h"

namespace axiometry {

/// Where a test's readings come from, so that a result can be traced to the byte.
struct Provenance {
  std::string file;    ///< name as the user gave it; "-" for the standard input
  std::string sha256;  ///< of the source file's bytes, lower-case hexadecimal
  std::string format;  ///< id of the format that read it, "csv-long"
};

/// One positioning test: what was tested, how, and the readings. The readings are valid by
/// construction; metadata is as complete as its source.
struct Test {
  Metadata metadata;
  Series series;
  Provenance provenance;
};

}  // namespace axiometry
