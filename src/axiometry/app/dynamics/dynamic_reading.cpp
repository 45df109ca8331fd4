// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "axiometry/app/dynamics/dynamic_motion.h"
#include "axiometry/app/files/source.h"
#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/recordings/raw_times.h"
#include "axiometry/base/counted.h"
#include "axiometry/base/go_on_unless.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recording.h"

namespace axiometry::app {
namespace {

constexpr std::size_t dynamic_block = std::size_t{256} << 10;
constexpr std::size_t samples_least = 64, peaks_shown = 10;
constexpr double uneven_most = 0.01;   // deviation as a share of an interval
constexpr double written_to_s = 1e-6;  // to which times in a file of text are rounded

Result<const formats::Recording*> layout_of(Source& source, const std::string& id) {
  AXIOMETRY_TRY(const std::string_view head, source.head());
  if (id.empty()) return formats::recognise_recording(head);
  if (const formats::Recording* found = formats::find_recording(id)) return found;
  std::string ids;
  for (const formats::Recording* r : formats::recording_table())
    ids += fmt::format("{}{}", ids.empty() ? "" : ", ", r->id);
  return fail(fmt::format("found the unknown stream {}, expected one of {}", text::quoted(id), ids));
}

/// Samples as they come, while they are evenly spaced.
class EvenSamples {
 public:
  explicit EvenSamples(const DynamicOptions& options) : options_(options) {}

  Result<void> take(std::span<const Sample> samples) {
    for (const Sample& s : samples) {
      if (options_.from_s && s.time_s < *options_.from_s) continue;
      if (options_.to_s && s.time_s > *options_.to_s) continue;
      if (positions_.size() == options_.samples_most)
        return fail(
            fmt::format("found more than {} samples, expected fewer: a part of the recording can be asked for: "
                        "from one time to another",
                        options_.samples_most));
      positions_.push_back(options_.reverse ? -s.position : s.position);
      stamps_.push_back(s.time_s);
    }
    return {};
  }

  std::size_t count() const { return positions_.size(); }

  /// The interval is that over all samples; each must lie within 1 % of one of its even place, and of the sample before
  /// it.
  Result<capture::MotionRecord> record() && {
    if (positions_.size() < samples_least)
      return fail(fmt::format("found {}, expected {} at least", counted(positions_.size(), "sample"), samples_least));
    const double interval = (stamps_.back() - stamps_.front()) / static_cast<double>(stamps_.size() - 1);
    if (!(interval > 0.0)) return fail("found all samples at one time, expected them one after the other");
    AXIOMETRY_TRY_VOID(check_steps(interval));
    AXIOMETRY_TRY_VOID(check_places(interval));
    return capture::MotionRecord{1.0 / interval, stamps_.front(), std::move(positions_)};
  }

 private:
  static double rounded(double x) { return std::round(x * 1e9) / 1e9; }

  /// However coarsely times are written, a missing sample shows.
  static double uneven(double interval) { return uneven_most * interval + std::min(written_to_s, 0.5 * interval); }

  Result<void> check_steps(double interval) const {
    for (std::size_t k = 1; k < stamps_.size(); ++k) {
      const double step = stamps_[k] - stamps_[k - 1];
      if (std::abs(step - interval) <= uneven(interval)) continue;
      return fail(
          fmt::format("found {} s between samples {} and {}, expected {} s as on the whole: samples are missing "
                      "or not evenly spaced",
                      format_exact(rounded(step)), k, k + 1, format_exact(rounded(interval))));
    }
    return {};
  }

  /// Small errors of steps add up: a clock that runs slowly at first and fast later makes velocities wrong.
  Result<void> check_places(double interval) const {
    for (std::size_t k = 1; k < stamps_.size(); ++k) {
      const double even_s = stamps_.front() + static_cast<double>(k) * interval;
      if (std::abs(stamps_[k] - even_s) <= uneven(interval)) continue;
      return fail(
          fmt::format("found sample {} at {} s, expected it at {} s, evenly spaced with all others: the clock of the "
                      "recording is not even",
                      k + 1, format_exact(rounded(stamps_[k])), format_exact(rounded(even_s))));
    }
    return {};
  }

  const DynamicOptions& options_;
  std::vector<double> positions_, stamps_;
};

struct ReadMotion {
  capture::MotionRecord record;
  std::string sha256, layout;
  std::vector<std::string> remarks;
};

Result<ReadMotion> read_motion(Source& source, const DynamicOptions& options) {
  AXIOMETRY_TRY(const formats::Recording* layout, layout_of(source, options.stream));
  formats::RecordingOptions recording;
  recording.kind = options.kind;
  recording.rate_hz = options.rate_hz;
  recording.units_per_count = options.units_per_count;
  recording.axis = options.stream_axis.value_or(0);
  recording.axis_stated = options.stream_axis.has_value();
  recording.skip_damaged = options.skip_damaged;
  AXIOMETRY_TRY(const auto reader, layout->open(recording));
  EvenSamples samples(options);
  Sha256 digest;
  const SampleSink sink = [&](std::span<const Sample> some) { return samples.take(some); };
  std::vector<char> block(dynamic_block);
  while (true) {
    AXIOMETRY_TRY_VOID(go_on_unless(options.stop));
    AXIOMETRY_TRY(const std::size_t got, source.read(block));
    if (got == 0) break;
    digest.update({block.data(), got});
    AXIOMETRY_TRY_VOID(reader->feed({block.data(), got}, sink));
  }
  AXIOMETRY_TRY_VOID(reader->finish(sink));
  // Samples with gaps between them are evenly spaced only where one at least is missing between any two.
  const std::size_t lost = reader->lost();
  if (lost > 0 && (!recording.skip_damaged || lost + 1 >= samples.count()))
    return fail(fmt::format("found {} in the recording, expected none: what is fast cannot be told across a gap",
                            counted(lost, "lost sample")));
  AXIOMETRY_TRY(capture::MotionRecord record, std::move(samples).record());
  ReadMotion read{std::move(record), digest.finish(), std::string(layout->id), reader->remarks()};
  if (lost > 0)
    read.remarks.push_back(fmt::format("the recording shows {}, none of which is missing in the part that is looked at",
                                       counted(lost, "lost or damaged sample")));
  return read;
}

/// What the rounding of positions to doubles, and of what is left of their line, makes of a position at most.
double rounding_of(const DynamicMotion& motion) {
  constexpr double roundings = 4.0;
  double farthest = 0.0;
  for (const double x : motion.record.positions) farthest = std::max(farthest, std::abs(x));
  return roundings * std::numeric_limits<double>::epsilon() * farthest;
}

void find_spectrum(DynamicMotion& motion) {
  const auto longest = std::ranges::max_element(motion.stretches, {}, &capture::UniformStretch::count);
  const bool moved = longest != motion.stretches.end();
  motion.spectrum_of = moved ? SpectrumOf::longest_stretch : SpectrumOf::whole;
  motion.spectrum_stretch = moved ? *longest : capture::whole_stretch(motion.record);
  std::vector<double> values = capture::residuals_of(motion.record, motion.spectrum_stretch);
  for (double& x : values) x *= deviation_per_position(motion.kind);
  motion.spectrum = capture::motion_spectrum(
      values, {motion.record.rate_hz, peaks_shown, rounding_of(motion) * deviation_per_position(motion.kind)});
}

void add_limits(DynamicMotion& motion) {
  if (motion.stretches.empty())
    motion.remarks.push_back(
        "no stretch of even motion was found: the vibrations are those of the whole recording about a straight line, "
        "into which every acceleration enters");
  motion.remarks.push_back(
      "standstills at targets are not looked for: nothing here is a parameter of ISO 230-2, and neither an error of "
      "scale "
      "nor "
      "a reversal error can be told");
  if (const double step = motion.course.resolution * deviation_per_position(motion.kind); step > 0.0)
    motion.remarks.push_back(
        fmt::format("the positions come in steps of {:.3g} {}, which hide what is smaller: the noise counts as that of "
                    "rounding to such steps",
                    step, deviation_unit(motion.kind)));
  if (!motion.feed)
    motion.remarks.push_back("the feed that was asked for is not stated: how far the axis is from it is not known");
}

Result<DynamicMotion> measured(Source source, const DynamicOptions& options) {
  AXIOMETRY_TRY(ReadMotion read, read_motion(source, options));
  DynamicMotion motion;
  motion.file = source.name();
  motion.sha256 = std::move(read.sha256);
  motion.layout = std::move(read.layout);
  motion.kind = options.kind;
  motion.record = std::move(read.record);
  motion.remarks = std::move(read.remarks);
  motion.feed = options.feed;
  motion.uniform_share = options.uniform_share;
  AXIOMETRY_TRY(motion.course, capture::motion_course(
                                   motion.record, options.window_s.value_or(capture::usual_window_s(motion.record))));
  AXIOMETRY_TRY_VOID(go_on_unless(options.stop));
  motion.stretches = capture::uniform_stretches(motion.record, motion.course, {.share = options.uniform_share});
  AXIOMETRY_TRY_VOID(go_on_unless(options.stop));
  find_spectrum(motion);
  add_limits(motion);
  return motion;
}

}  // namespace

Result<DynamicMotion> measure_dynamic(const std::string& file, const DynamicOptions& options) {
  const auto measure = [&]() -> Result<DynamicMotion> {
    AXIOMETRY_TRY(Source source, Source::open(file));
    DynamicOptions asked = options;
    asked.skip_damaged = options.skip_damaged || is_raw(file);
    return measured(std::move(source), asked);
  };
  return in_file(measure(), file);
}

Result<DynamicMotion> measure_dynamic(const GivenFile& file, const DynamicOptions& options) {
  DynamicOptions asked = options;
  asked.skip_damaged = options.skip_damaged || is_raw_name(file.name);
  return in_file(measured(Source::of_bytes(file.name, file.bytes), asked), file.name);
}

DynamicExtremes extremes_of(const DynamicMotion& motion) {
  // Within half a window of the ends there is no window of their own.
  const auto inner = [&](const std::vector<double>& list) {
    return std::span(list).subspan(motion.course.half_window, list.size() - 2 * motion.course.half_window);
  };
  const std::span<const double> v = inner(motion.course.velocity), a = inner(motion.course.acceleration);
  const auto place = [&](std::span<const double> list, auto at) {
    return static_cast<std::size_t>(at - list.begin()) + motion.course.half_window;
  };
  const auto [v_low, v_high] = std::ranges::minmax_element(v);
  const auto [a_low, a_high] = std::ranges::minmax_element(a);
  return {.fastest_up = place(v, v_high),
          .fastest_down = place(v, v_low),
          .strongest_up = place(a, a_high),
          .strongest_down = place(a, a_low)};
}

std::optional<double> way_of(const DynamicMotion& motion, const capture::SpectrumPeak& peak) {
  if (motion.spectrum_of != SpectrumOf::longest_stretch || !(peak.frequency_hz > 0.0)) return std::nullopt;
  return std::abs(motion.spectrum_stretch.velocity) / peak.frequency_hz;
}

}  // namespace axiometry::app
