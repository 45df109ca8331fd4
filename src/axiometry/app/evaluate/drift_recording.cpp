// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/evaluate/drift_recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "axiometry/app/files/source.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/formats/recording.h"
#include "axiometry/numeric/median.h"
#include "axiometry/standards/iso230_2/inputs/resolved_keys.h"
#include "axiometry/standards/iso230_2/monte_carlo/environment_recording.h"
#include "axiometry/standards/readings/test_course.h"

namespace axiometry::app {
namespace {

using iso230_2::recording_key;
using iso230_2::variation_key;

constexpr std::size_t most_values = 2000;
constexpr std::size_t most_kept = 2 * most_values;
constexpr double most_steps_of_gap = 10.0;
constexpr std::string_view from_recording = "recording at standstill";
constexpr std::size_t block_bytes = 1 << 16;
constexpr double native_per_unit_linear = 1000.0;  // µm per mm
constexpr double native_per_unit_rotary = 3600.0;  // ″ per °

}  // namespace

Result<void> DriftPicker::take(std::span<const Sample> samples) {
  for (const Sample& sample : samples) {
    if (seen_++ % stride_ != 0) continue;
    kept_.push_back(sample);
    if (kept_.size() < most_kept) continue;
    for (std::size_t k = 0; 2 * k < kept_.size(); ++k) kept_[k] = kept_[2 * k];
    kept_.resize((kept_.size() + 1) / 2);
    stride_ *= 2;
  }
  return {};
}

Result<DriftRecording> DriftPicker::picked() const {
  if (kept_.size() < least_recorded_values)
    return fail(fmt::format("found {}, expected at least {} of a recording at standstill",
                            counted(kept_.size(), "value"), least_recorded_values));
  std::vector<double> intervals;
  for (std::size_t k = 1; k < kept_.size(); ++k) intervals.push_back(kept_[k].time_s - kept_[k - 1].time_s);
  const auto gap = std::ranges::max_element(intervals);
  const double longest = *gap, begin_of_gap = kept_[static_cast<std::size_t>(gap - intervals.begin())].time_s;
  const double median = numeric::upper_median(std::move(intervals));
  if (!(median > 0.0)) return fail("found values without a time between them, expected a recording at standstill");
  if (longest > most_steps_of_gap * median)
    return fail(
        fmt::format("found a gap of {:.4g} s after {:.6g} s in values about {:.4g} s apart, expected a recording "
                    "at standstill without gaps",
                    longest, begin_of_gap, median));
  const double span = kept_.back().time_s - kept_.front().time_s;
  const double step = median * std::max(1.0, std::ceil(span / (median * double(most_values - 1))));
  DriftRecording recording{{}, Duration::s(step)};
  std::size_t at = 0;
  for (double time = 0.0; time <= span * (1.0 + 1e-9); time += step) {
    while (at + 1 < kept_.size() && kept_[at + 1].time_s - kept_.front().time_s <= time + 1e-6 * step) ++at;
    recording.values.push_back(kept_[at].position);
  }
  const double mean =
      std::accumulate(recording.values.begin(), recording.values.end(), 0.0) / double(recording.values.size());
  for (double& x : recording.values) x -= mean;
  return recording;
}

Result<DriftRecording> read_drift_recording(const std::string& file, AxisKind kind) {
  const auto in_it = [&](Error error) {
    if (error.file.empty()) error.file = file;
    return std::unexpected(std::move(error));
  };
  auto source = Source::open(file);
  if (!source) return in_it(std::move(source).error());
  auto head = source->head();
  if (!head) return in_it(std::move(head).error());
  auto layout = formats::recognise_recording(*head);
  if (!layout) return in_it(std::move(layout).error());
  formats::RecordingOptions options;
  options.kind = kind;
  options.at_standstill = true;
  auto reader = (*layout)->open(options);
  if (!reader) return in_it(std::move(reader).error());
  DriftPicker picker;
  Sha256 digest;
  const auto sink = [&](std::span<const Sample> samples) { return picker.take(samples); };
  std::vector<char> block(block_bytes);
  while (true) {
    const auto got = source->read(block);
    if (!got) return in_it(got.error());
    if (*got == 0) break;
    digest.update({block.data(), *got});
    if (auto fed = (*reader)->feed({block.data(), *got}, sink); !fed) return in_it(std::move(fed).error());
  }
  if (auto finished = (*reader)->finish(sink); !finished) return in_it(std::move(finished).error());
  auto recording = picker.picked();
  if (!recording) return in_it(std::move(recording).error());
  const auto [least, most] = std::ranges::minmax(recording->values);
  if (most - least > 1.0)
    return in_it(
        {fmt::format("found values over a range of {:.3g} {}, expected a standstill; a head such as "
                     "'time_s,deviation_{}' tells the unit",
                     most - least, position_unit(kind), deviation_unit_key(kind))});
  recording->sha256 = digest.finish();
  for (double& x : recording->values) x *= kind == AxisKind::linear ? native_per_unit_linear : native_per_unit_rotary;
  return recording;
}

Test with_recorded_variation(Test test) {
  GumInputs& gum = test.metadata.gum;
  const StatedItem* known = test.provenance.stated.find(variation_key);
  if (gum.drift_recording.empty() || (known != nullptr && known->name == from_recording)) return test;
  const auto tell = [&](std::string text) { test.provenance.remarks.push_back({false, std::move(text)}); };
  auto& stated = test.metadata.uncertainty.environmental_variation;
  const std::string_view unit = deviation_unit(test.metadata.axis.kind);
  const StatedItems& origins = test.provenance.stated;
  if (stated && origins.by(variation_key) > origins.by(recording_key)) {
    tell(fmt::format("The recording at standstill does not count: {} = {} {} is stated over it", variation_key,
                     format_exact(stated->in_native()), unit));
    gum.drift_recording.clear();
    return test;
  }
  const auto recorded = recorded_environment(test.metadata, course_of(test));
  if (!recorded || !(recorded->range > 0.0)) {
    tell(
        fmt::format("The recording at standstill says nothing and does not count: expected at least {} values that are "
                    "not all the same, and uncertainty.drift_interval_s",
                    least_recorded_values));
    gum.drift_recording.clear();
    return test;
  }
  if (stated && stated->in_native() != recorded->range)
    tell(fmt::format("{} = {} {} does not count: the recording at standstill takes its place", variation_key,
                     format_exact(stated->in_native()), unit));
  stated = Deviation::native(recorded->range);
  auto& items = test.provenance.stated.items;
  std::erase_if(items, [](const StatedItem& item) { return item.key == variation_key; });
  items.push_back({std::string(variation_key), test.provenance.stated.by(recording_key), std::string(from_recording)});
  tell(fmt::format("E_VE = {:.3g} {} is the largest range of the recording at standstill over {:.4g} s, {}",
                   recorded->range, unit, recorded->length_s,
                   recorded->whole ? "all of it" : "the length of the test"));
  return test;
}

}  // namespace axiometry::app
