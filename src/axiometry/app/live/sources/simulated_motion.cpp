// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/sources/simulated_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <iterator>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/motions/motion_units.h"
#include "axiometry/simulation/motion_walk.h"

namespace axiometry::app {
namespace {

using capture::StopSign;
using simulation::MotionWalk;
using MotionClock = std::chrono::steady_clock;

constexpr std::string_view layout_of_motion = "time-position";
constexpr auto motion_packet = std::chrono::milliseconds(50);      // of real time, as instruments send them
constexpr std::size_t most_motion_waiting = std::size_t{1} << 20;  // bytes that nobody has read
constexpr double urad_in_arcsec = 0.20626480624709636;             // ″
constexpr std::array presets_of_motion = {
    MotionPreset{"good", "Nothing goes wrong",
                 "A bow, a slope and another value on the way back, each run within the noise"},
    MotionPreset{"drift", "The readings drift",
                 "Each run lies apart from the one before, by what the instrument moved meanwhile"},
};

bool tells_beside(StopSign sign) { return sign == StopSign::trigger || sign == StopSign::position; }

/// What capture and axis know of each other. Both are used by one thread.
struct AxisAndCapture {
  bool waits = false;    // whether it waits at each stop until the stop is done
  std::size_t done = 0;  // approaches that have a reading or are left without one
  std::optional<capture::StandstillDetector::Whereabouts> now{};

  /// At the stop that was due before it does not stand any more, as far as anybody is concerned.
  void go_on(std::size_t now_done) {
    if (waits && now && now_done != done) now->at_rest = false;
    done = now_done;
  }
};

/// How a line of the stream is written. All lines have as many bytes, so that the bytes that were heard tell how many
/// samples they were.
struct MotionLines {
  StopSign sign;
  std::string head;
  double unit_size = 1.0;  // µm or µrad of one unit

  std::string line(double time_s, const MotionWalk::Moment& moment) const {
    std::string text = fmt::format("{:>10.2f},{:>14.6g}", time_s, moment.value / unit_size);
    if (sign == StopSign::trigger) text += moment.trigger ? ",1" : ",0";
    if (sign == StopSign::position) text += fmt::format(",{:>13.5f}", moment.position_mm);
    return text + "\n";
  }
  std::size_t width() const { return line(0.0, {}).size(); }
};

/// Makes what has come to be sent whenever somebody reads.
class SimulatedMotionStream final : public LiveStream {
 public:
  SimulatedMotionStream(MotionWalk walk, MotionLines lines, const SimulatedPace& pace,
                        std::shared_ptr<AxisAndCapture> shared)
      : walk_(std::move(walk)), lines_(std::move(lines)), pace_(pace), shared_(std::move(shared)) {
    const std::uint64_t head = lines_.head.size();
    first_ = next_ = pace_.skip > head ? (pace_.skip - head) / lines_.width() : 0;
    if (pace_.skip > 0) waiting_ = "\n";  // behind a line that was cut off
    if (pace_.skip < head) waiting_ += lines_.head;
  }

  Got read(std::span<char> buffer, std::chrono::milliseconds longest) override {
    if (!begin_) start();
    if (waiting_.empty() && !over_) {
      const auto until = std::min(made_ + motion_packet, MotionClock::now() + longest);
      std::this_thread::sleep_until(until);
      make(std::chrono::duration<double>(MotionClock::now() - *begin_).count() * pace_.speed);
    }
    if (waiting_.empty()) return over_ ? Got{State::over, 0} : Got{};
    const std::size_t count = std::min(buffer.size(), waiting_.size());
    std::copy_n(waiting_.begin(), count, buffer.begin());
    waiting_.erase(0, count);
    return {State::data, count};
  }

 private:
  void start() {
    begin_ = made_ = MotionClock::now();
    const std::size_t done = std::min(shared_->done, walk_.rests().size());
    if (done > 0 && shared_->waits) walked_s_ = walk_.rests()[done - 1].to_s;
  }

  /// All that comes until then, s of the machine since the stream began.
  void make(double elapsed_s) {
    made_ = MotionClock::now();
    const double from_s = first_ > 0 ? time_of(first_ - 1) : 0.0;
    while (waiting_.size() < most_motion_waiting && !over_) {
      if (lines_.sign == StopSign::readings ? next_ == walk_.rests().size() : walked_s_ > walk_.duration_s()) {
        over_ = true;
        break;
      }
      const double time_s = time_of(next_);
      if (time_s - from_s > elapsed_s) break;
      walked_s_ = shared_->waits ? behind(walked_s_) : time_s;
      waiting_ += lines_.line(time_s, walk_.at(walked_s_, next_++));
    }
    tell(from_s + elapsed_s);
  }

  double time_of(std::uint64_t sample) const {
    if (lines_.sign != StopSign::readings) return static_cast<double>(sample) / simulated_rate_hz;
    const auto& rests = walk_.rests();
    return rests[std::min<std::size_t>(sample, rests.size() - 1)].middle_s();
  }

  /// The next moment of the program: it stands still in the middle of the rest that is due, at the last one for as long
  /// as it may be taken back, and is driven back to one that was taken back.
  double behind(double walked_s) const {
    const double next_s = walked_s + 1.0 / simulated_rate_hz;
    const auto& rests = walk_.rests();
    if (shared_->done >= rests.size()) return std::min(next_s, std::max(walked_s, rests.back().to_s));
    const MotionWalk::Rest& due = rests[shared_->done];
    if (walked_s > due.to_s) return due.from_s;
    return walked_s <= due.middle_s() ? std::min(next_s, due.middle_s()) : next_s;
  }

  void tell(double until_s) {
    const double at_s = lines_.sign == StopSign::readings ? until_s : walked_s_;
    const MotionWalk::Moment moment = walk_.at(at_s, next_);
    const bool elsewhere = shared_->waits && shared_->done < walk_.rests().size() &&
                           (at_s < walk_.rests()[shared_->done].from_s || at_s > walk_.rests()[shared_->done].to_s);
    shared_->now = {.position = Position::native(moment.position_mm), .at_rest = moment.at_rest && !elsewhere};
  }

  MotionWalk walk_;
  MotionLines lines_;
  SimulatedPace pace_;
  std::shared_ptr<AxisAndCapture> shared_;
  std::uint64_t first_ = 0, next_ = 0;  // samples
  std::optional<MotionClock::time_point> begin_;
  MotionClock::time_point made_;
  double walked_s_ = 0.0;
  std::string waiting_;
  bool over_ = false;
};

/// A plan has its approaches in one order.
std::size_t done_of(const std::vector<Approach>& order, const std::optional<Approach>& due) {
  if (!due) return order.size();
  return static_cast<std::size_t>(std::ranges::distance(order.begin(), std::ranges::find(order, *due)));
}

MotionLines motion_lines_of(const SimulatedMotionCapture& capture, const MotionListener& motion) {
  const bool angle = motion.error().rotation();
  const formats::Unit* unit = motion.stated().unit;
  if (unit == nullptr) unit = formats::find_unit(angle ? "urad" : "um");
  MotionLines lines{.sign = motion.stated().sign, .head = {}};
  lines.unit_size = formats::motion_value(*unit, 1.0);
  if (formats::motion_unit_of(*unit) == MotionUnit::arcsec) lines.unit_size /= urad_in_arcsec;
  lines.head = fmt::format("# {}\ntime_s,{} [{}]{}\n", simulated_motion_note(capture, motion.error()),
                           motion.error().text(), unit->name,
                           lines.sign == StopSign::trigger    ? ",trigger"
                           : lines.sign == StopSign::position ? ",position [mm]"
                                                              : "");
  return lines;
}

}  // namespace

std::span<const MotionPreset> motion_presets() { return presets_of_motion; }

std::string simulated_motion_note(const SimulatedMotionCapture& capture, const MotionName& error) {
  return fmt::format("Simulated, not measured: fault {}, size {} {}; seed {}", capture.preset,
                     format_exact(capture.size), error.rotation() ? "urad" : "um", capture.seed);
}

Result<void> hear_simulated_motion(CaptureOptions& options) {
  const auto other = [](std::string_view what, std::string_view found, std::string_view expected) {
    return fail(fmt::format("{}: found {} with the simulator, expected {} or none", what, found, expected));
  };
  formats::RecordingOptions& recording = options.recording;
  MotionStatement& stated = *options.motion;
  if (!options.stream.empty() && options.stream != layout_of_motion)
    return other("layout", options.stream, layout_of_motion);
  if (recording.axis_stated && recording.axis != 0)
    return other("stream-axis", fmt::format("{}", recording.axis + 1), "1");
  if (stated.stop_column && *stated.stop_column != 1)
    return other("stop-column", fmt::format("{}", *stated.stop_column + 1), "2");
  options.stream = layout_of_motion;
  recording.axis = 0;
  recording.axis_stated = true;
  if (tells_beside(stated.sign)) stated.stop_column = 1;
  return {};
}

Result<SimulatedMotion> simulated_motion_source(const SimulatedMotionCapture& capture, const CaptureSession& session) {
  if (std::ranges::find(presets_of_motion, capture.preset, &MotionPreset::id) == presets_of_motion.end()) {
    std::vector<std::string_view> known;
    for (const MotionPreset& preset : presets_of_motion) known.push_back(preset.id);
    return fail(
        fmt::format("preset: found {}, expected one of {}", text::quoted(capture.preset), fmt::join(known, ", ")));
  }
  const MotionListener& motion = *session.motion();
  const Plan& plan = motion.values().plan();
  AXIOMETRY_TRY(MotionWalk walk,
                MotionWalk::make(plan, {.size = capture.size, .drifts = capture.preset == "drift"}, capture.seed));
  const auto shared = std::make_shared<AxisAndCapture>();
  shared->waits = motion.stated().sign == StopSign::keys;
  SimulatedMotion made;
  made.connect = [walk = std::move(walk), lines = motion_lines_of(capture, motion), pace = capture.pace,
                  shared]() -> Result<std::unique_ptr<LiveStream>> {
    return std::make_unique<SimulatedMotionStream>(walk, lines, pace, shared);
  };
  made.beside = [order = approaches(plan), shared](CaptureSession& heard) {
    shared->go_on(done_of(order, heard.motion()->values().due()));
    if (shared->now) heard.tell_axis(*shared->now);
  };
  return made;
}

}  // namespace axiometry::app
