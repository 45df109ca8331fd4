// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/streamed_text.h"

namespace axiometry::formats {

const Recording* find_recording(std::string_view id) {
  for (const Recording* recording : recording_table())
    if (text::equal_ignoring_case(recording->id, id)) return recording;
  return nullptr;
}

Result<const Recording*> recognise_recording(std::string_view head) {
  if (head.empty()) return fail("found an empty recording, expected samples");
  StreamedText text;
  const std::string_view decoded = text.decoded(head);
  const Recording* best = nullptr;
  int best_score = 0;
  std::string titles;
  for (const Recording* recording : recording_table()) {
    titles += fmt::format("{}{} ({})", titles.empty() ? "" : "; ", recording->id, recording->title);
    const int score = std::max(recording->recognise(head), text.is_utf16() ? recording->recognise(decoded) : 0);
    if (score <= best_score) continue;
    best = recording;
    best_score = score;
  }
  if (best != nullptr) return best;
  return fail(fmt::format("found a recording that begins with {}, expected one of: {}",
                          text::quoted(text::trim(decoded.substr(0, decoded.find('\n')))), titles),
              {1, 1});
}

Result<void> check_times_and_positions(const RecordingOptions& options) {
  if (options.units_per_count) return fail("found a length per count for a stream of positions, expected none");
  return {};
}

Result<double> mm_per_count(Length wavelength, double counts_per_wavelength) {
  const double mm = wavelength.in_mm();
  if (!(std::isfinite(mm) && mm > 0.0))
    return fail(fmt::format("found a wavelength of {} mm, expected one above 0", mm));
  if (!(std::isfinite(counts_per_wavelength) && counts_per_wavelength > 0.0))
    return fail(
        fmt::format("found {} counts per wavelength, expected a number above 0, such as 8", counts_per_wavelength));
  return mm / counts_per_wavelength;
}

}  // namespace axiometry::formats
