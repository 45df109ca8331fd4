// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "axiometry/simulation/axis_errors.h"
#include "axiometry/simulation/instrument_errors.h"
#include "axiometry/simulation/simulate.h"

namespace axiometry::simulation {
namespace {

constexpr std::size_t strip = 4096;  // samples made at once; a multiple of RandomStream::group
constexpr double samples_max = 1e12;

/// Which samples arrive.
class Selection {
 public:
  Selection(const RecordingRequest& recording, std::uint64_t seed)
      : recording_(recording), stream_({seed, stream_drop_out, 0}) {}

  /// Whether each of the samples from `first` on, `count` of them, arrives. To be called strip by strip.
  std::span<const bool> next(std::size_t first, std::size_t count) {
    kept_.fill(true);
    if (recording_.drop_out_probability > 0.0) {
      stream_.fill_uniform(draws_);
      for (std::size_t k = 0; k < count; ++k) kept_[k] = draws_[k] >= recording_.drop_out_probability;
    }
    for (const Gap& gap : recording_.gaps)
      for (std::size_t k = 0; k < count; ++k) {
        const double t = static_cast<double>(first + k) / recording_.rate;
        if (t >= gap.begin.in_s() && t < gap.begin.in_s() + gap.length.in_s()) kept_[k] = false;
      }
    return std::span(kept_).first(count);
  }

 private:
  const RecordingRequest& recording_;
  numeric::RandomStream stream_;
  std::array<double, strip> draws_;
  std::array<bool, strip> kept_;
};

Result<void> check_recording(const RecordingRequest& recording) {
  if (!(recording.rate >= 0.001 && recording.rate <= 1e7))
    return fail(fmt::format("found a rate of {} samples a second, expected 0.001 to 10000000", recording.rate));
  if (!(recording.drop_out_probability >= 0.0 && recording.drop_out_probability < 1.0))
    return fail(fmt::format("found a probability of drop-outs of {}, expected 0 or more, below 1",
                            recording.drop_out_probability));
  for (const Gap& gap : recording.gaps) {
    const double begin = gap.begin.in_s(), length = gap.length.in_s();
    if (!(begin >= 0.0 && length > 0.0 && std::isfinite(begin + length)))
      return fail(fmt::format("found a gap of {} s from {} s, expected a length above 0 from 0 s on", length, begin));
  }
  return {};
}

/// All samples, whether they arrive or not.
Result<std::size_t> total_of(const Timeline& timeline, const RecordingRequest& recording) {
  const double total = std::floor(timeline.duration() * recording.rate) + 1.0;
  if (total > samples_max)
    return fail(fmt::format("found a recording of {:.3g} samples, expected at most {:.3g}", total, samples_max));
  return static_cast<std::size_t>(total);
}

/// Walks the time line sample by sample.
class Recorder {
 public:
  Recorder(const Request& request, const Timeline& timeline, const InstrumentErrors& instrument)
      : axis_(request.axis, request.plan, timeline, request.seed),
        timeline_(timeline),
        instrument_(instrument),
        noise_um_(request.axis.instrument.noise.in_native()),
        per_position_(deviation_per_position(request.plan.axis.kind)) {}

  Sample sample(double t, double z) {
    const auto legs = timeline_.legs();
    while (t > legs[leg_].leave && leg_ + 1 < legs.size()) {
      close_standstill();
      ++leg_;
    }
    const Leg& leg = legs[leg_];
    const Phase& phase = Timeline::phase_at(leg, t);
    const double c = Timeline::command(leg, phase, t);
    const bool resting = t >= leg.arrive;
    const double lag = timeline_.following_error(phase, t);
    truth_ = (resting ? axis_.rest(leg_) : axis_.on_the_way(leg_, c)) + axis_.in_time(leg_, c, t) - lag * per_position_;
    inside_ = leg.approach && t >= leg.settled;
    const double deviation = truth_ + instrument_.at(leg_, c, t) + noise_um_ * z;
    return {t, c + instrument_.shown(c, deviation) / per_position_};
  }

  /// The sample made last arrives.
  void keep() {
    if (!inside_) return;
    sum_ += truth_;
    ++count_;
  }

  std::vector<TrueStandstill> finish() && {
    while (leg_ < timeline_.legs().size()) {
      close_standstill();
      ++leg_;
    }
    return std::move(standstills_);
  }

 private:
  void close_standstill() {
    const Leg& leg = timeline_.legs()[leg_];
    if (!leg.approach) return;
    TrueStandstill& s = standstills_.emplace_back();
    s.approach = *leg.approach;
    s.extra = leg.extra;
    s.begin = Duration::s(leg.settled);
    s.end = Duration::s(leg.leave);
    s.samples = count_;
    if (count_ > 0) s.mean = Deviation::native(sum_ / static_cast<double>(count_));
    sum_ = 0.0;
    count_ = 0;
  }

  AxisErrors axis_;
  const Timeline& timeline_;
  const InstrumentErrors& instrument_;
  double noise_um_, per_position_;
  std::size_t leg_ = 0;
  bool inside_ = false;
  double truth_ = 0.0, sum_ = 0.0;
  std::size_t count_ = 0;
  std::vector<TrueStandstill> standstills_;
};

}  // namespace

Result<std::size_t> count_samples(const Request& request, const RecordingRequest& recording) {
  AXIOMETRY_TRY_VOID(check_sound(request.axis, request.plan));
  AXIOMETRY_TRY_VOID(check_recording(recording));
  AXIOMETRY_TRY(const Timeline timeline, Timeline::make(request.plan, request.axis, request.departures));
  AXIOMETRY_TRY(const std::size_t total, total_of(timeline, recording));
  if (recording.gaps.empty() && recording.drop_out_probability == 0.0) return total;
  Selection selection(recording, request.seed);
  std::size_t count = 0;
  for (std::size_t first = 0; first < total; first += strip)
    count += static_cast<std::size_t>(std::ranges::count(selection.next(first, std::min(strip, total - first)), true));
  return count;
}

Result<TrueRecording> record(const Request& request, const RecordingRequest& recording, const SampleSink& sink) {
  AXIOMETRY_TRY_VOID(check_sound(request.axis, request.plan));
  AXIOMETRY_TRY_VOID(check_recording(recording));
  AXIOMETRY_TRY(const Timeline timeline, Timeline::make(request.plan, request.axis, request.departures));
  AXIOMETRY_TRY(const InstrumentErrors instrument,
                InstrumentErrors::make(request.axis.instrument, request.plan, timeline, request.seed));
  AXIOMETRY_TRY(const std::size_t total, total_of(timeline, recording));

  Recorder recorder(request, timeline, instrument);
  Selection selection(recording, request.seed);
  numeric::RandomStream noise_stream({request.seed, stream_sample_noise, 0});
  std::vector<double> noise(strip);
  std::vector<Sample> samples(strip);
  TrueRecording truth{.standstills = {}, .duration = Duration::s(timeline.duration())};
  for (std::size_t first = 0; first < total; first += strip) {
    const std::size_t count = std::min(strip, total - first);
    const std::span<const bool> kept = selection.next(first, count);
    if (request.axis.instrument.noise.in_native() > 0.0) noise_stream.fill_normal(noise);
    std::size_t arrived = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const Sample sample = recorder.sample(static_cast<double>(first + k) / recording.rate, noise[k]);
      if (!kept[k]) continue;
      recorder.keep();
      samples[arrived++] = sample;
    }
    truth.samples += arrived;
    if (arrived > 0) AXIOMETRY_TRY_VOID(sink(std::span<const Sample>(samples).first(arrived)));
  }
  truth.lost = total - truth.samples;
  truth.standstills = std::move(recorder).finish();
  return truth;
}

}  // namespace axiometry::simulation
