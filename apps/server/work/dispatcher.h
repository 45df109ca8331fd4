// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/asio/io_context.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "server/http/transport.h"
#include "server/limits.h"
#include "server/work/job.h"
#include "server/work/request_queues.h"

namespace axiometry::server {

/// Where requests are handed in: each is read by a worker, which tells what it costs, and waits in the queue of its
/// load until it is answered. What several ask for at once is made once; what nobody waits for any more is given up,
/// unless it may keep something; and nobody waits longer than its load's deadline once the work has begun. What may
/// keep something is told to stop then, and its true answer is waited for: it may be too late. On the I/O thread alone.
class Dispatcher {
 public:
  Dispatcher(boost::asio::io_context& io, const Service& service, const Limits& limits, RequestQueues& queues);
  ~Dispatcher();
  Dispatcher(const Dispatcher&) = delete;
  Dispatcher& operator=(const Dispatcher&) = delete;

  using Ticket = std::uint64_t;
  using Reply = std::function<void(std::shared_ptr<const Response>)>;
  /// Calls the reply once, later, with what all who ask for the same may share: the answer, 503 with Retry-After where
  /// the queue is full, or 503 after the deadline; 504 where then nobody can say for long whether something was kept.
  /// With nothing where there was no memory to answer; what a reply throws is no affair of the others. Where this
  /// throws the reply is not called.
  Ticket ask(std::shared_ptr<Request> request, std::string who, Reply reply);

  /// The client has gone: its reply is forgotten, and so is the work where nobody else waits for it; what runs is told
  /// to stop. False where the work is done in any case: what is light, and what may keep something.
  bool leave(Ticket ticket);

  /// No worker does or is to do anything.
  bool is_idle() const { return working_.empty(); }
  /// Called when that is so again.
  std::function<void()> when_idle{};

  /// How many wait for what has this key; 0 also where nothing has it.
  std::size_t waiting_for(std::string_view key) const;

 private:
  struct Work;
  using Shared = std::shared_ptr<Work>;

  /// What the answer is, or nothing where there was no memory for it.
  using Made = std::optional<Response>;

  void submit(const Shared& work, Load line, void (Dispatcher::*step)(const Shared&));
  void attempt(const Shared& work, void (Dispatcher::*step)(const Shared&));
  void read(const Shared& work);
  void begin(const Shared& work);
  void compute(const Shared& work);
  void tell_of_failure(const Shared& work);
  void has_begun(const Shared& work, Load load);
  void is_overdue(const Shared& work, Load load);
  void has_been_read(const Shared& work);
  void hand_on(const Shared& work);
  void finish(const Shared& work, Made response);
  void answer(const Shared& work, Made response);
  std::shared_ptr<const Response> to_share(Made response, bool keeps) const;
  void forget_key(const Shared& work);
  void has_left_line(const Shared& work);
  /// On the I/O thread, from any other.
  void later(const Shared& work, void (Dispatcher::*step)(const Shared&));

  boost::asio::io_context& io_;
  const Service& service_;
  const Limits& limits_;
  RequestQueues& queues_;
  Ticket last_ = 0;
  std::map<Ticket, Shared> asked_;
  std::map<std::string, Shared, std::less<>> by_key_;
  std::set<Work*> working_;  // work in a line or being done
};

}  // namespace axiometry::server
