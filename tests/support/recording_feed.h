// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/formats/recording.h"

namespace axiometry::testing_support {

/// What a reader made of bytes: samples, or the place and reason of a refusal.
struct ReadSamples {
  std::vector<Sample> samples;
  std::string refusal;  ///< "3:1: found …"; empty when there was none
  std::size_t lost = 0;
  Environment environment;
};

/// Feeds the bytes in pieces of this size.
inline ReadSamples read_samples(std::string_view id, std::string_view bytes,
                                const formats::RecordingOptions& options = {}, std::size_t piece = 1'000'000) {
  ReadSamples result;
  const formats::Recording* const recording = formats::find_recording(id);
  if (recording == nullptr) return {{}, "no such layout", 0, {}};
  auto reader = recording->open(options);
  if (!reader) return {{}, reader.error().to_string(), 0, {}};
  const SampleSink sink = [&](std::span<const Sample> samples) -> Result<void> {
    result.samples.insert(result.samples.end(), samples.begin(), samples.end());
    return {};
  };
  Result<void> done;
  for (std::size_t k = 0; k < bytes.size() && done; k += piece) done = (*reader)->feed(bytes.substr(k, piece), sink);
  if (done) done = (*reader)->finish(sink);
  if (!done) result.refusal = done.error().to_string();
  result.lost = (*reader)->lost();
  result.environment = (*reader)->environment();
  return result;
}

/// Whether the result is the same for every place at which the bytes can be cut in two, and for pieces of one to
/// seven bytes.
inline bool same_however_cut(std::string_view id, std::string_view bytes,
                             const formats::RecordingOptions& options = {}) {
  const auto same = [](const ReadSamples& a, const ReadSamples& b) {
    return a.refusal == b.refusal && a.lost == b.lost &&
           std::ranges::equal(a.samples, b.samples, [](const Sample& x, const Sample& y) {
             return x.time_s == y.time_s && x.position == y.position;
           });
  };
  const ReadSamples whole = read_samples(id, bytes, options);
  for (std::size_t piece = 1; piece <= bytes.size(); ++piece)
    if (!same(read_samples(id, bytes, options, piece), whole)) return false;
  return true;
}

}  // namespace axiometry::testing_support
