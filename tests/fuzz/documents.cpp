// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as what an archive gives back of a kept test: its options and changes, and as JSON of its own. What is read
// is refused as damaged or understood, never trusted.
#include "axiometry/app/workbench/test_state.h"
#include "axiometry/base/json.h"
#include "described.h"

using namespace axiometry;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes(fuzzing::as_text(data, size));
  if (const auto value = json::parse(bytes); value) {
    const std::string written = json::dump(*value);
    const auto again = json::parse(written);
    AXIOMETRY_CONTRACT(again && json::dump(*again) == written);
  } else {
    fuzzing::check_error(value.error());
  }
  store::Evaluation evaluation;
  evaluation.options = bytes;
  if (const auto options = app::kept_options(evaluation); !options)
    AXIOMETRY_CONTRACT(options.error().kind == ErrorKind::damaged);
  store::TestState state;
  state.changes = bytes;
  if (const auto changes = app::kept_changes(state); !changes)
    AXIOMETRY_CONTRACT(changes.error().kind == ErrorKind::damaged);
  return 0;
}
