// SPDX-License-Identifier: Apache-2.0
//
// The simulator as a source of live captures: its recording, played as fast as a machine would make it, or faster.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stop_token>
#include <thread>
#include <vector>

#include "axiometry/app/live/sources/capture_source.h"
#include "axiometry/app/live/sources/played_source.h"
#include "axiometry/app/recordings/raw_recording.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/simulated.h"
#include "axiometry/simulation/presets.h"
#include "axiometry/simulation/simulate.h"

namespace axiometry::app {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::array speeds = {1.0, 10.0, 60.0};
constexpr double packet_s = 0.05;                           // of real time, as instruments send them
constexpr std::size_t most_waiting = std::size_t{4} << 20;  // bytes that nobody has read

/// A thread simulates and waits for the time of each packet; read() takes what has come.
class SimulatedStream final : public LiveStream {
 public:
  SimulatedStream(PlayedRecording recording, RecordingEncoder encoder, const SimulatedPace& pace)
      : recording_(std::move(recording)),
        encoder_(std::move(encoder)),
        speed_(pace.speed),
        skip_(pace.skip),
        packet_(encoder_.head()),
        thread_([this](const std::stop_token& stop) { produce(stop); }) {}

  Got read(std::span<char> buffer, std::chrono::milliseconds longest) override {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, longest, [&] { return over_ || !waiting_.empty(); });
    if (waiting_.empty()) return over_ ? Got{State::over, 0, why_} : Got{};
    const std::size_t count = std::min(buffer.size(), waiting_.size());
    std::copy_n(waiting_.begin(), count, buffer.begin());
    waiting_.erase(0, count);
    changed_.notify_all();
    return {State::data, count};
  }

 private:
  void produce(const std::stop_token& stop) {
    const auto made = recording_([&](std::span<const Sample> samples) { return take(samples, stop); });
    send();
    const std::scoped_lock lock(mutex_);
    over_ = true;
    if (!made) why_ = made.error().message;
    changed_.notify_all();
  }

  Result<void> take(std::span<const Sample> samples, const std::stop_token& stop) {
    for (const Sample& sample : samples) {
      encoder_.append(packet_, sample);
      if (skip_ >= packet_.size()) {  // all of this packet was heard before
        skip_ -= packet_.size();
        packet_.clear();
        continue;
      }
      packet_.erase(0, std::exchange(skip_, 0));
      if (!first_s_) sent_s_ = *(first_s_ = sample.time_s);
      if (sample.time_s - sent_s_ < packet_s * speed_) continue;
      sent_s_ = sample.time_s;
      const auto due = begin_ + std::chrono::duration_cast<Clock::duration>(
                                    std::chrono::duration<double>((sample.time_s - *first_s_) / speed_));
      {
        std::unique_lock lock(mutex_);
        changed_.wait_until(lock, stop, due, [] { return false; });
        changed_.wait(lock, stop, [&] { return waiting_.size() < most_waiting; });
      }
      if (stop.stop_requested()) return fail("the capture has ended");
      send();
    }
    return {};
  }

  void send() {
    const std::scoped_lock lock(mutex_);
    waiting_ += std::exchange(packet_, {});
    changed_.notify_all();
  }

  const PlayedRecording recording_;
  RecordingEncoder encoder_;
  const double speed_;
  const Clock::time_point begin_ = Clock::now();
  std::uint64_t skip_;
  std::string packet_;
  std::optional<double> first_s_;
  double sent_s_ = 0.0;

  std::mutex mutex_;
  std::condition_variable_any changed_;
  std::string waiting_;
  std::string why_;
  bool over_ = false;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace

std::span<const double> simulation_speeds() { return speeds; }

Result<Connect> played_source(PlayedRecording recording, const RawSetting& setting, const SimulatedPace& pace) {
  AXIOMETRY_TRY(const RecordingEncoder encoder, RecordingEncoder::make(RawLayout::text, setting));
  return Connect([recording = std::move(recording), encoder, pace]() -> Result<std::unique_ptr<LiveStream>> {
    return std::make_unique<SimulatedStream>(recording, encoder, pace);
  });
}

Result<Connect> simulated_source(const SimulatedCapture& capture) {
  const simulation::Preset* preset = simulation::find_preset(capture.preset);
  if (preset == nullptr) {
    std::vector<std::string_view> known;
    for (const simulation::Preset& p : simulation::presets()) known.push_back(p.id);
    return fail(
        fmt::format("preset: found {}, expected one of {}", text::quoted(capture.preset), fmt::join(known, ", ")));
  }
  simulation::Request request{.plan = capture.plan,
                              .axis = preset->make(capture.plan),
                              .departures = {},
                              .seed = capture.seed,
                              .fault = std::string(preset->id)};
  AXIOMETRY_TRY(const std::size_t samples, simulation::count_samples(request, {.rate = simulated_rate_hz}));
  const RawSetting setting{capture.plan.axis.kind, samples, simulated_rate_hz};
  const auto record = [request](const SampleSink& sink) -> Result<void> {
    AXIOMETRY_TRY_VOID(simulation::record(request, {.rate = simulated_rate_hz}, sink));
    return {};
  };
  return played_source(record, setting, {capture.speed, capture.skip});
}

void mark_simulated(Test& test, const SimulatedCapture& capture) {
  TestConditions& conditions = test.metadata.conditions;
  conditions.purpose = simulation_purpose;
  conditions.comment = fmt::format("Simulated, not measured: fault {}; seed {}", capture.preset, capture.seed);
}

}  // namespace axiometry::app
