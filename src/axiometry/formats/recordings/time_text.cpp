// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recordings/time_text.h"

#include "axiometry/base/text/text.h"

namespace axiometry::formats {

std::optional<double> seconds_per_unit(std::string_view unit) {
  struct Spelling {
    std::string_view text;
    double seconds;
  };
  constexpr Spelling spellings[] = {{"s", 1.0},    {"sec", 1.0},  {"seconds", 1.0}, {"ms", 1e-3},
                                    {"us", 1e-6},  {"µs", 1e-6},  {"μs", 1e-6},     {"ns", 1e-9},
                                    {"min", 60.0}, {"h", 3600.0}, {"sekunden", 1.0}};
  for (const Spelling& s : spellings)
    if (text::equal_ignoring_case(s.text, unit)) return s.seconds;
  return std::nullopt;
}

}  // namespace axiometry::formats
