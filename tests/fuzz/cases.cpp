// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a conformance case, and as the small languages beside it: tables of tolerances and of pitch errors.
#include "axiometry/app/check.h"
#include "axiometry/app/simulate_text.h"
#include "axiometry/app/tolerance_table.h"
#include "described.h"

using namespace axiometry;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzzing::as_text(data, size);
  const auto no_file = [](std::string_view) -> Result<Test> { return fail("found no file, expected none"); };
  if (const auto report = app::check_case(bytes, no_file); report)
    AXIOMETRY_CONTRACT(!report->comparisons.empty());
  else
    fuzzing::check_error(report.error());
  if (const auto table = app::read_tolerance_table(bytes, "table"); !table) fuzzing::check_error(table.error());
  if (const auto nodes = app::parse_pitch_table(bytes); !nodes) fuzzing::check_error(nodes.error());
  return 0;
}
