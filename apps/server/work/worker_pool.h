// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

namespace axiometry::server {

/// Threads that do one task after another. Who asked takes turns with the others who wait; the tasks of one are done in
/// the order in which they came. Of lone tasks one is done at a time; those that wait for it keep no thread and let the
/// others pass.
class WorkerPool {
 public:
  struct Options {
    std::size_t threads = 1;
    std::size_t waiting_max = 1;  ///< tasks
    std::size_t reserved = 0;     ///< places among these that only who has nothing waiting gets
    int niceness = 0;             ///< how far other threads are preferred (0 to 19), where the system can tell them
  };
  explicit WorkerPool(const Options& options);
  ~WorkerPool();  ///< forgets what waits, waits for what runs
  WorkerPool(const WorkerPool&) = delete;
  WorkerPool& operator=(const WorkerPool&) = delete;

  using Ticket = std::uint64_t;
  /// Nothing when so many wait already that this one is not taken. What a task throws is logged and forgotten.
  std::optional<Ticket> submit(const std::string& who, std::function<void()> task, bool lone = false);

  /// Gives a place in the line back: the task is forgotten. False when it has begun, and then it is done.
  bool withdraw(Ticket ticket);

 private:
  struct Task {
    Ticket ticket = 0;
    std::function<void()> work;
    bool lone = false;
  };
  void work();
  static void run(Task& task);
  std::optional<Task> next();

  Options options_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::map<std::string, std::deque<Task>> lines_;  // tasks of those who have something waiting
  std::deque<std::string> turns_;                  // names in the order of their turns
  std::size_t waiting_ = 0;
  bool lone_runs_ = false;
  Ticket last_ticket_ = 0;
  bool ended_ = false;
  std::vector<std::thread> threads_;
};

}  // namespace axiometry::server
