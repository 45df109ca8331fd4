// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <boost/asio/io_context.hpp>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "job.h"
#include "limits.h"
#include "lines.h"
#include "transport.h"

namespace axiometry::server {

/// Where requests are handed in: each is read by a worker, which tells what it costs, and waits in the line of its load
/// until it is answered. What several ask for at once is made once; what nobody waits for any more is given up, unless
/// it keeps something; and nobody waits for longer than the deadline of the load once the work has begun. On the I/O
/// thread alone.
class Desk {
 public:
  Desk(boost::asio::io_context& io, const Service& service, const Limits& limits, Lines& lines);
  ~Desk();
  Desk(const Desk&) = delete;
  Desk& operator=(const Desk&) = delete;

  using Ticket = std::uint64_t;
  using Reply = std::function<void(std::shared_ptr<const Response>)>;
  /// Calls the reply once, later, with what all who ask for the same may share: the answer, 503 with Retry-After where
  /// the line is full, or 503 after the deadline.
  Ticket ask(std::shared_ptr<Request> request, std::string who, Reply reply);

  /// The client has gone: its reply is forgotten, and so is the work where nobody else waits for it; what runs is told
  /// to stop. False where the work is done in any case: of light ones, and of edits, which are kept.
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

  void submit(const Shared& work, Load line, std::function<void()> task);
  void attempt(const Shared& work, void (Desk::*step)(const Shared&));
  void read(const Shared& work);
  void compute(const Shared& work);
  void has_begun(const Shared& work, Load load);
  void has_been_read(const Shared& work);
  void finish(const Shared& work, Response response);
  void answer(const Shared& work, Response response);
  void forget_key(const Shared& work);
  void has_left_line(const Shared& work);
  /// On the I/O thread, from any other.
  void later(const Shared& work, void (Desk::*step)(const Shared&));

  boost::asio::io_context& io_;
  const Service& service_;
  const Limits& limits_;
  Lines& lines_;
  Ticket last_ = 0;
  std::map<Ticket, Shared> asked_;
  std::map<std::string, Shared, std::less<>> by_key_;
  std::set<Work*> working_;  // in a line or being done
};

}  // namespace axiometry::server
