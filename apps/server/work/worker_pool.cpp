// SPDX-License-Identifier: Apache-2.0
#include "server/work/worker_pool.h"

#include <sys/resource.h>

#include <algorithm>
#include <exception>
#include <iterator>
#include <utility>

#include "server/log.h"

namespace axiometry::server {
namespace {

/// On Linux this is of the calling thread and those that it begins; elsewhere of the whole process, so not done.
void lower_priority([[maybe_unused]] int niceness) {
#ifdef __linux__
  if (niceness > 0) static_cast<void>(::setpriority(PRIO_PROCESS, 0, niceness));
#endif
}

}  // namespace

WorkerPool::WorkerPool(const Options& options) : options_(options) {
  for (std::size_t i = 0; i < options_.threads; ++i) threads_.emplace_back([this] { work(); });
}

WorkerPool::~WorkerPool() {
  std::map<std::string, std::deque<Task>> forgotten;
  {
    const std::scoped_lock lock(mutex_);
    ended_ = true;
    forgotten.swap(lines_);
  }
  changed_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

std::optional<WorkerPool::Ticket> WorkerPool::submit(const std::string& who, std::function<void()> task, bool lone) {
  Ticket ticket = 0;
  {
    const std::scoped_lock lock(mutex_);
    const std::size_t may_wait = options_.waiting_max - (lines_.contains(who) ? options_.reserved : 0);
    if (ended_ || waiting_ >= may_wait) return {};
    std::deque<Task>& line = lines_[who];
    if (line.empty() && std::ranges::find(turns_, who) == turns_.end()) turns_.push_back(who);
    ticket = ++last_ticket_;
    line.push_back({ticket, std::move(task), lone});
    ++waiting_;
  }
  changed_.notify_one();
  return ticket;
}

bool WorkerPool::withdraw(Ticket ticket) {
  std::function<void()> forgotten;  // ends after the lock: it may hold what asks for this pool again
  const std::scoped_lock lock(mutex_);
  for (auto& [who, line] : lines_) {
    const auto task = std::ranges::find(line, ticket, &Task::ticket);
    if (task == line.end()) continue;
    forgotten = std::move(task->work);
    line.erase(task);
    --waiting_;
    if (!line.empty()) return true;
    std::erase(turns_, who);
    lines_.erase(who);
    return true;
  }
  return false;
}

/// Takes no memory, of which there may be none.
std::optional<WorkerPool::Task> WorkerPool::next() {
  const auto may_begin = [this](const Task& task) { return !(task.lone && lone_runs_); };
  for (auto turn = turns_.begin(); turn != turns_.end(); ++turn) {
    const auto line = lines_.find(*turn);
    const auto found = std::ranges::find_if(line->second, may_begin);
    if (found == line->second.end()) continue;
    Task task = std::move(*found);
    line->second.erase(found);
    --waiting_;
    lone_runs_ = lone_runs_ || task.lone;
    std::rotate(turn, std::next(turn), turns_.end());
    if (line->second.empty()) {
      lines_.erase(line);
      turns_.pop_back();
    }
    return task;
  }
  return std::nullopt;
}

/// What a task throws all the same is its own affair, and no reason to end the program.
void WorkerPool::run(Task& task) {
  try {
    task.work();
  } catch (const std::exception& exception) {
    log_failure("a request", exception);
  }
  task.work = nullptr;
}

void WorkerPool::work() {
  lower_priority(options_.niceness);
  std::unique_lock lock(mutex_);
  while (true) {
    std::optional<Task> task;
    changed_.wait(lock, [&] { return ended_ || (task = next()); });
    if (ended_) return;
    lock.unlock();
    run(*task);
    lock.lock();
    if (!task->lone) continue;
    lone_runs_ = false;
    changed_.notify_one();
  }
}

}  // namespace axiometry::server
