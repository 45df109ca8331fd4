// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/app/live/service/capture_service.h"

namespace axiometry::app {

/// What a capture needs to run: checked, and with its source reached.
struct CaptureService::Begun {
  CaptureSource source;
  CaptureSession session;
  LiveCapture live;
  std::optional<SimulatedCapture> simulated;
  std::optional<LengthTask> task{};  ///< task of a capture of lengths
};

/// One capture in its thread. Its state is read from others.
class CaptureService::Running {
 public:
  Running(HeldCapture held, Begun begun, const CaptureKeeping& keeping);
  /// Interrupts it, and waits until its thread has seen that.
  ~Running();

  void stop() { stop_ = true; }
  void interrupt() { interrupt_ = true; }
  bool press(capture::StopKey key);  ///< false where nobody listens any more
  void wait_for_end(std::chrono::milliseconds longest);
  CaptureState state(std::optional<CaptureRevision> after) const;  ///< nothing: without readings, events and evaluation

  const std::string& source() const { return source_; }
  bool ended() const;
  bool interrupted() const;
  bool concluding() const { return concludes_; }  ///< plays what there is, and stops by itself

 private:
  struct End {
    CaptureState::Stage stage;
    std::optional<store::Id> test;
    std::string error;
    std::optional<TableEnd> came_to{};
  };

  void run();
  CaptureObserver observer();
  void tell_notice(const std::string& text);
  void now(const CaptureSession& session);
  void take_readings(const std::vector<capture::CapturedReading>& all);
  void take_lengths(const CaptureSession& session);
  void take_values(const MotionListener& motion);
  std::vector<capture::StopKey> take_keys();
  void listen_no_more();
  void evaluate(Test test);
  End conclude(const Result<CaptureOutcome>& outcome);
  static End left_for_later(const Error& error);
  Result<FoundTable> table_of(const HeardLive& heard) const;
  End conclude_table(const HeardLive& heard);
  Result<void> ended_table(const TableEnd& end);
  void tell(End end);

  const std::string source_;
  const bool concludes_;
  const CaptureKeeping& keeping_;
  std::optional<HeldCapture> held_;  // held until the capture has ended
  std::optional<Begun> begun_;
  std::optional<Test> test_;  // the test as far as its readings have come
  bool evaluated_ = true;     // whether what has come was evaluated
  std::atomic<bool> stop_ = false;
  std::atomic<bool> interrupt_ = false;

  mutable std::mutex mutex_;  // guards the state
  std::condition_variable changed_;
  CaptureState state_;
  std::size_t notices_left_out_ = 0;
  CaptureRevision anew_at_ = 0;  // readings before it hold no longer
  std::size_t standstills_ = 0;  // standstills that the state of a capture of lengths knows
  std::size_t told_ = 0;         // readings and events of a motion that were told, which change what is read
  std::vector<capture::StopKey> keys_;
  bool listens_ = true;  // whether it listens to keys
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace axiometry::app
