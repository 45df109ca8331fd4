// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as a continuous recording of every layout: samples do not depend on how the bytes are cut, and a reader
// that may pass over damaged lines gives no sample that is not there.
#include <cmath>

#include "described.h"
#include "tests/support/recording_feed.h"

using namespace axiometry;

namespace {

void check_samples(const testing_support::ReadSamples& read) {
  double before = -INFINITY;
  for (const Sample& sample : read.samples) {
    AXIOMETRY_CONTRACT(std::isfinite(sample.position) && sample.time_s >= before);
    before = sample.time_s;
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view bytes = fuzzing::as_text(data, size);
  if (const auto found = formats::recognise_recording(bytes); !found) fuzzing::check_error(found.error());
  for (const formats::Recording* layout : formats::recording_table()) {
    formats::RecordingOptions options;
    if (layout->id == "umd") options.units_per_count = 1e-4;
    const auto whole = testing_support::read_samples(layout->id, bytes, options);
    check_samples(whole);
    const auto cut = testing_support::read_samples(layout->id, bytes, options, 1 + size % 7);
    AXIOMETRY_CONTRACT(whole.refusal == cut.refusal && whole.samples.size() == cut.samples.size());
    options.skip_damaged = true;
    check_samples(testing_support::read_samples(layout->id, bytes, options, 64));
    options.skip_damaged = false;
  }
  return 0;
}
