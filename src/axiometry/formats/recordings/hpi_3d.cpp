// SPDX-License-Identifier: Apache-2.0
//
// The serial stream of the Lasertex HPI-3D (Status Pro µLine): frames of 16 bytes with a check.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/formats/recording.h"
#include "axiometry/formats/recordings/hpi_frames.h"

namespace axiometry::formats {
namespace hpi_3d {
namespace {

using hpi::Frame;
using hpi::frame_size;
using hpi::FrameKind;

constexpr char first_of_frame = '\xAA';
constexpr std::size_t most_between_frames = 4096;  // bytes: ten seconds of the instrument
constexpr std::size_t most_velocities_alone = 250;
constexpr double pause_to_tell_s = 1.0;  // 25 distances
constexpr int most_sensors = 16;

/// What was out of order, told at the end.
struct HpiCounts {
  std::size_t bytes_before = 0;     // of a frame whose beginning is missing, where a recording or connection begins
  std::size_t bytes_between = 0;    // frames
  std::size_t damaged = 0;          // distances that those bytes were, at least
  std::size_t damaged_weather = 0;  // frames of them that began as such
  std::size_t too_fast = 0, weak = 0, unsettled = 0, velocities = 0, without_arrival = 0, pauses = 0;
  double longest_pause_s = 0.0;
  std::size_t bad_weather = 0;
};

class HpiReader final : public RecordingReader {
 public:
  explicit HpiReader(const RecordingOptions& options) : options_(options) {}

  Result<void> feed(std::string_view bytes, const SampleSink& sink) override {
    begun_ += bytes;
    auto taken = take_frames();
    auto flushed = flush(sink);  // also what stood before a refused byte
    return taken ? flushed : taken;
  }

  Result<void> finish(const SampleSink& sink) override {
    AXIOMETRY_TRY_VOID(flush(sink));
    if (skipped_ > 0) settle_skipped();
    if (const std::size_t rest = begun_.size(); rest > 0 && !options_.skip_damaged)
      return fail(fmt::format("found {} behind the last frame, expected whole frames of {} bytes",
                              counted(rest, "byte"), frame_size));
    if (distances_ > 0) return {};
    if (counts_.velocities > 0)
      return fail("found velocities and no distance, expected an instrument that is set to distances");
    if (counts_.too_fast + counts_.weak > 0)
      return fail(
          fmt::format("found no distance without the instrument's flag of {}, expected it cleared at the "
                      "instrument before the recording",
                      counts_.too_fast > 0 ? "too high a speed" : "too weak a signal"));
    return fail("found no frame with a distance, expected the stream of an HPI-3D");
  }

  Result<void> interrupted(const SampleSink& sink) override {
    begun_.clear();
    if (skipped_ > 0) settle_skipped();
    at_begin_ = true;
    last_arrival_s_ = std::numeric_limits<double>::quiet_NaN();
    return flush(sink);
  }

  std::size_t unfinished() const override { return begun_.size(); }
  std::size_t lost() const override {
    return counts_.damaged + counts_.too_fast + counts_.weak + counts_.without_arrival;
  }
  Environment environment() const override { return environment_; }
  std::vector<std::string> remarks() const override;

 private:
  Result<void> take_frames() {
    std::size_t at = 0;
    Result<void> done;
    while (done && begun_.size() - at >= frame_size) {
      if (const auto frame = hpi::frame_at(std::string_view(begun_).substr(at))) {
        if (skipped_ > 0) settle_skipped();
        at_begin_ = false;
        done = take(*frame);
        at += frame_size;
        continue;
      }
      if (std::string_view(begun_).substr(at).starts_with(hpi::begin_of_weather)) ++skipped_weather_;
      const std::size_t next = std::min(begun_.find(first_of_frame, at + 1), begun_.size() - (frame_size - 1));
      done = skip(next - at);
      at = next;
    }
    begun_.erase(0, at);
    return done;
  }

  /// Bytes that are no frame.
  Result<void> skip(std::size_t count) {
    skipped_ += count;
    if (!options_.skip_damaged && (!at_begin_ || skipped_ >= frame_size))
      return fail(
          fmt::format("found bytes that are no frame behind frame {}, expected AA B0, {} bytes with a check "
                      "that is right",
                      frames_, frame_size));
    if (skipped_ <= most_between_frames) return {};
    return fail(
        fmt::format("found {} bytes without a frame whose check is right, expected one in {} (is the baud "
                    "rate that of the instrument, 3000000?)",
                    most_between_frames, frame_size));
  }

  /// A frame follows. At a beginning less than a frame may have been joined in its middle.
  void settle_skipped() {
    const std::size_t bytes = std::exchange(skipped_, 0), weather_begun = std::exchange(skipped_weather_, 0);
    if (at_begin_ && bytes < frame_size) {
      counts_.bytes_before += bytes;
      return;
    }
    const std::size_t frames = (bytes + frame_size - 1) / frame_size;
    const std::size_t weather = std::min(frames, weather_begun);
    counts_.bytes_between += bytes;
    counts_.damaged += frames - weather;
    counts_.damaged_weather += weather;
    index_ += frames - weather;
  }

  Result<void> take(const Frame& frame) {
    ++frames_;
    switch (frame.kind) {
      case FrameKind::distance: return take_distance(frame);
      case FrameKind::velocity:
        if (++counts_.velocities < most_velocities_alone || distances_ > 0) return {};
        return fail("found velocities and no distance, expected an instrument that is set to distances");
      case FrameKind::weather: note_weather(frame.weather); return {};
      case FrameKind::other: return {};
    }
    return {};
  }

  Result<void> take_distance(const Frame& frame) {
    const std::size_t index = index_++;
    const double arrival = options_.arrival_s ? options_.arrival_s() : std::numeric_limits<double>::quiet_NaN();
    note_pause(arrival);
    if (frame.too_fast || frame.weak) {
      ++(frame.too_fast ? counts_.too_fast : counts_.weak);
      return {};
    }
    double time_s = static_cast<double>(index) / options_.rate_hz.value_or(hpi::distances_per_second);
    if (!options_.rate_hz && options_.arrival_s) {
      if (std::isnan(arrival)) {
        ++counts_.without_arrival;
        return {};
      }
      time_s = arrival;
    }
    if (time_s < last_time_s_)
      return fail(fmt::format("found time running backwards from {} s to {} s, expected samples in order of time",
                              format_exact(last_time_s_), format_exact(time_s)));
    last_time_s_ = time_s;
    counts_.unsettled += frame.laser_settled ? 0 : 1;
    ++distances_;
    samples_.push_back({time_s, frame.distance_mm});
    return {};
  }

  void note_pause(double arrival_s) {
    const double pause = arrival_s - last_arrival_s_;
    if (pause > pause_to_tell_s) {
      ++counts_.pauses;
      counts_.longest_pause_s = std::max(counts_.longest_pause_s, pause);
    }
    last_arrival_s_ = arrival_s;
  }

  void note_weather(const hpi::Weather& weather);

  Result<void> flush(const SampleSink& sink) {
    if (samples_.empty()) return {};
    auto done = sink(samples_);
    samples_.clear();
    return done;
  }

  RecordingOptions options_;
  std::string begun_;  // less than a frame between two calls
  bool at_begin_ = true;
  std::size_t skipped_ = 0;          // bytes since the last frame
  std::size_t skipped_weather_ = 0;  // frames that began among them
  std::size_t frames_ = 0, distances_ = 0;
  std::size_t index_ = 0;  // of the next distance, damaged frames counted as such but for those of the weather
  double last_time_s_ = -1e300;
  double last_arrival_s_ = std::numeric_limits<double>::quiet_NaN();
  std::vector<Sample> samples_;
  Environment environment_;
  HpiCounts counts_;
};

void HpiReader::note_weather(const hpi::Weather& weather) {
  const auto note = [](auto& first, auto& last, auto value) {
    if (!first) first = value;
    last = value;
  };
  const bool possible = weather.celsius > -60.0 && weather.celsius < 100.0 && weather.sensor < most_sensors;
  if (!possible) {
    ++counts_.bad_weather;
    return;
  }
  if (weather.sensor > 0) {
    const std::string name = fmt::format("sensor {}", weather.sensor);
    auto place = std::ranges::find(environment_.sensors, name, &TemperatureSensor::location);
    if (place == environment_.sensors.end())
      place = environment_.sensors.insert(place, TemperatureSensor{"machine", name, std::nullopt, std::nullopt});
    note(place->start, place->end, Temperature::celsius(weather.celsius));
    return;
  }
  Environment& air = environment_;
  note(air.air_temperature_start, air.air_temperature_end, Temperature::celsius(weather.celsius));
  if (weather.percent <= 100.0)
    note(air.air_humidity_start, air.air_humidity_end, RelativeHumidity::percent(weather.percent));
  if (weather.pascal > 0.0) note(air.air_pressure_start, air.air_pressure_end, Pressure::kPa(weather.pascal / 1000.0));
}

/// "2 lost samples", "1 damaged frame of the weather", or both.
std::string what_was_damaged(const HpiCounts& counts) {
  const std::string lost = counted(counts.damaged, "lost sample");
  if (counts.damaged_weather == 0) return lost;
  const std::string weather =
      counted(counts.damaged_weather, "damaged frame of the weather", "damaged frames of the weather");
  return counts.damaged == 0 ? weather : lost + " and " + weather;
}

std::vector<std::string> HpiReader::remarks() const {
  std::vector<std::string> remarks;
  const HpiCounts& c = counts_;
  if (c.bytes_before > 0)
    remarks.push_back(fmt::format("passed over {} of a frame that had begun before", counted(c.bytes_before, "byte")));
  if (c.bytes_between > 0)
    remarks.push_back(fmt::format("{} between the frames made no frame whose check is right; counted as {}",
                                  counted(c.bytes_between, "byte"), what_was_damaged(c)));
  if (c.too_fast > 0)
    remarks.push_back(
        fmt::format("left out {} with the instrument's flag of too high a speed: behind it distances are "
                    "wrong until the instrument is set to zero and the flag cleared",
                    counted(c.too_fast, "sample")));
  if (c.weak > 0)
    remarks.push_back(
        fmt::format("left out {} with the instrument's flag of too weak a signal: behind it distances "
                    "may be wrong until the instrument is set to zero and the flag cleared",
                    counted(c.weak, "sample")));
  if (c.unsettled > 0)
    remarks.push_back(fmt::format("{} came while the instrument did not show its laser as ready; they are used",
                                  counted(c.unsettled, "sample")));
  if (c.velocities > 0)
    remarks.push_back(
        fmt::format("passed over {} between the distances", counted(c.velocities, "velocity", "velocities")));
  if (c.bad_weather > 0)
    remarks.push_back(fmt::format("left out {} of the weather that no sensor shows", counted(c.bad_weather, "value")));
  if (c.pauses > 0)
    remarks.push_back(
        fmt::format("the instrument was silent for more than a second {}, {} s at most: samples may be "
                    "missing there",
                    counted(c.pauses, "time"), format_fixed(c.longest_pause_s, 1)));
  if (distances_ > 0 && !options_.rate_hz && !options_.arrival_s)
    remarks.push_back(
        "the recording tells no times: 25 samples a second are assumed, as the instrument sends them, where no rate is "
        "stated");
  return remarks;
}

Result<std::unique_ptr<RecordingReader>> open(const RecordingOptions& options) {
  if (options.kind != AxisKind::linear)
    return fail("found the stream of an HPI-3D, which tells distances, for a rotary axis, expected a linear axis");
  if (options.units_per_count)
    return fail("found a length per count for the stream of an HPI-3D, expected none: it tells distances");
  if (options.axis > 0)
    return fail(fmt::format("found axis {} of the stream, expected 1: it holds one distance", options.axis + 1));
  if (options.rate_hz && !(std::isfinite(*options.rate_hz) && *options.rate_hz > 0.0))
    return fail(fmt::format("found a rate of {} Hz, expected one above 0", *options.rate_hz));
  return std::make_unique<HpiReader>(options);
}

/// Sure with two frames, or one that may have lost its neighbours.
int recognise(std::string_view head) {
  std::size_t frames = 0, passed = 0;
  for (std::size_t at = head.find(first_of_frame); at != head.npos && head.size() - at >= frame_size && frames < 4;) {
    if (hpi::frame_at(head.substr(at))) {
      ++frames;
      at += frame_size;
      if (at >= head.size()) break;
      continue;
    }
    if (++passed > most_between_frames) break;
    at = head.find(first_of_frame, at + 1);
  }
  return frames > 1 ? 100 : frames == 1 ? 60 : 0;
}

constexpr std::string_view manual =
    R"(The serial stream of the Lasertex HPI-3D interferometer (Status Pro µLine): frames of 16 bytes, 3 000 000 baud,
8 data bits, no parity, one stop bit. Known from a program that reads it, not from its maker.

```
AA B0 15  00 00 00 06 AC FC 00  00 00 00 09 5A  6A      11.2 mm
AA B0 0A  00 08 69 2D 50 3C 27 94 00 00 00 00  86      air: 21.53 °C, 45 %, 1013.2 hPa
```

- A frame is `AA`, a command of two bytes, twelve bytes of data and a CRC-8 of the fifteen bytes before it (polynomial
  31 hex, begun with FF). Numbers are two's complement, the most significant byte first.
- `B0 15`, 25 times a second: the distance, seven bytes in steps of 10⁻¹⁰ m; then bit 3 of the tenth byte of data says
  that it moved too fast, bit 3 of the eleventh that the signal is strong enough, bit 0 that the laser is ready.
- `B0 0A`, once a second: number of the sensor (0: of the air), temperature in 0.01 °C (two bytes), humidity in %,
  battery, link, pressure in 10 Pa (two bytes). First and last values go into the test: the air's, and of others as
  sensors of the machine.
- A sample counts at the moment it arrives; of a file without times 25 samples a second are assumed, or `--rate`.
- Samples with the flag of too high a speed or of too weak a signal are counted as lost, never used: the instrument
  keeps these flags until they are cleared, since distances behind them may be wrong.
- Refused: bytes that are no frame. Of a live stream and with `--skip-damaged` they are passed over up to the next
  frame whose check is right and counted as lost, a frame that begins as weather as that alone; 4096 bytes without a
  frame are refused all the same. So is an instrument that is set to velocities.
- `serial:///dev/ttyUSB0?baud=3000000&ask=hpi-3d` asks the instrument for distances and weather; nothing is set to zero
  and no flag cleared. Without `ask` nothing is sent to it.
)";

}  // namespace
}  // namespace hpi_3d

extern const Recording hpi_3d_recording;
const Recording hpi_3d_recording = {
    .id = "hpi-3d",
    .title = "Lasertex HPI-3D (µLine) serial stream",
    .extensions = ".raw .bin",
    .manual = hpi_3d::manual,
    .recognise = hpi_3d::recognise,
    .open = hpi_3d::open,
};

}  // namespace axiometry::formats
