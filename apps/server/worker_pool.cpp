// SPDX-License-Identifier: Apache-2.0
#include "worker_pool.h"

#include <sys/resource.h>

#include <algorithm>
#include <utility>

namespace axiometry::server {
namespace {

/// On Linux this is of the calling thread and those that it begins; elsewhere of the whole process, so not done.
void give_way([[maybe_unused]] int niceness) {
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

std::optional<WorkerPool::Ticket> WorkerPool::submit(const std::string& who, std::function<void()> task) {
  Ticket ticket = 0;
  {
    const std::scoped_lock lock(mutex_);
    const std::size_t may_wait = options_.waiting_max - (lines_.contains(who) ? options_.reserved : 0);
    if (ended_ || waiting_ >= may_wait) return {};
    std::deque<Task>& line = lines_[who];
    if (line.empty()) turns_.push_back(who);
    ticket = ++last_ticket_;
    line.push_back({ticket, std::move(task)});
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

std::function<void()> WorkerPool::next() {
  const std::string who = std::move(turns_.front());
  turns_.pop_front();
  const auto line = lines_.find(who);
  std::function<void()> task = std::move(line->second.front().work);
  line->second.pop_front();
  --waiting_;
  if (line->second.empty())
    lines_.erase(line);
  else
    turns_.push_back(who);
  return task;
}

void WorkerPool::work() {
  give_way(options_.niceness);
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return ended_ || !turns_.empty(); });
    if (ended_) return;
    std::function<void()> task = next();
    lock.unlock();
    task();
    task = nullptr;
    lock.lock();
  }
}

}  // namespace axiometry::server
