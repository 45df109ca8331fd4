// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "axiometry/app/files/output.h"
#include "axiometry/base/contract.h"
#include "axiometry/base/result.h"

/// What is made piece by piece: `put` is called with a function that takes a text, and fails where that does.
namespace axiometry::app {

/// Into a file, in memory that does not grow with it. Fails when the file cannot be written.
Result<void> write_piecewise(const std::string& file, const auto& put) {
  AXIOMETRY_TRY(OutputFile output, OutputFile::create(file));
  AXIOMETRY_TRY_VOID(put([&](const std::string& piece) { return output.write(piece); }));
  return output.commit();
}

/// The whole as a text. Contract: `put` fails for no reason of its own.
std::string text_of_pieces(const auto& put) {
  std::string all;
  const Result<void> done = put([&](const std::string& piece) -> Result<void> {
    all += piece;
    return {};
  });
  AXIOMETRY_CONTRACT(done.has_value());
  return all;
}

}  // namespace axiometry::app
