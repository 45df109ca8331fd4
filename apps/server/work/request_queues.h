// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

#include "server/work/load.h"
#include "server/work/worker_pool.h"

namespace axiometry::server {

/// The queues in which requests wait, each with workers that do nothing else: lists and pages wait for no report, and
/// neither does an edit that is to be kept.
class RequestQueues {
 public:
  struct Options {
    WorkerPool::Options light{};
    WorkerPool::Options edits{};
    WorkerPool::Options heavy{};  ///< of the queue of heavy requests and of lone ones
  };
  explicit RequestQueues(const Options& options);

  struct Place {
    Load load = Load::light;
    WorkerPool::Ticket ticket = 0;
  };
  /// As WorkerPool::submit() and withdraw() of the queue of that load.
  std::optional<Place> submit(Load load, const std::string& who, std::function<void()> task);
  bool withdraw(const Place& place);

 private:
  WorkerPool& of(Load load);

  WorkerPool light_;
  WorkerPool edits_;
  WorkerPool heavy_;
};

}  // namespace axiometry::server
