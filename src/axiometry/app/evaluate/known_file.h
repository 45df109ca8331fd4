// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/evaluate/evaluate.h"
#include "axiometry/app/files/source.h"
#include "axiometry/formats/format.h"

/// Private to app/: files of which more is known than their bytes.
namespace axiometry::app {

struct KnownFormat {
  const formats::Format& format;  ///< format that fits the beginning
  std::string sha256;             ///< hash of all bytes
};

/// read_tests() of a source that was recognised and hashed before: neither is done again.
Result<void> read_known(Source& source, const KnownFormat& known, const TestSink& sink);

}  // namespace axiometry::app
