// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a conformance case, and as the small languages beside it: tables of tolerances and of pitch errors.
#include <algorithm>
#include <string>

#include "axiometry/app/cases/check.h"
#include "axiometry/app/evaluate/tolerance_table.h"
#include "axiometry/app/simulate/simulate_text.h"
#include "described.h"

using namespace axiometry;

/// A Monte Carlo case draws a hundred times in place of a hundred thousand: its figures then fail, which is no fault.
static std::string with_few_trials(std::string text) {
  constexpr std::string_view key = "trials";
  for (std::size_t at = text.find(key); at != text.npos; at = text.find(key, at + 1)) {
    const std::size_t begin = text.find_first_not_of(" =:", at + key.size());
    const std::size_t end = text.find_first_not_of("0123456789", begin);
    if (begin != text.npos && end - begin > 3) text.replace(begin, std::min(end, text.size()) - begin, "100");
  }
  return text;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzzing::as_text(data, size);
  const auto no_file = [](std::string_view) -> Result<Test> { return fail("found no file, expected none"); };
  if (const auto report = app::check_case(with_few_trials(std::string(bytes)), no_file); report)
    AXIOMETRY_CONTRACT(!report->comparisons.empty());
  else
    fuzzing::check_error(report.error());
  if (const auto table = app::read_tolerance_table(bytes, "table"); !table) fuzzing::check_error(table.error());
  if (const auto nodes = app::parse_pitch_table(bytes); !nodes) fuzzing::check_error(nodes.error());
  return 0;
}
