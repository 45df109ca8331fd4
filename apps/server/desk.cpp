// SPDX-License-Identifier: Apache-2.0
#include "desk.h"

#include <fmt/format.h>

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <exception>
#include <optional>
#include <stop_token>
#include <utility>

#include "log.h"

namespace axiometry::server {
namespace {

namespace asio = boost::asio;

constexpr auto ask_soon = std::chrono::seconds(2);
constexpr auto ask_later = std::chrono::seconds(10);
constexpr std::string_view line_is_full =
    "found more reports and evaluations in line than the server takes, expected fewer; try again in a moment";
constexpr std::string_view too_many_requests = "found more requests at once than the server can answer, expected fewer";

bool is_heavy(Load load) { return load == Load::heavy || load == Load::lone; }

/// Whether a worker of that line may do the work at once: it is as light as what the line is for.
bool may_do(Load line, Load load) {
  if (load == Load::lone) return false;  // one at a time
  return line == load || line == Load::heavy;
}

std::chrono::milliseconds deadline_of(const Limits& limits, Load load) {
  if (load == Load::lone) return limits.lone_deadline;
  return load == Load::heavy ? limits.heavy_deadline : limits.light_deadline;
}

}  // namespace

/// One computation and all who wait for it.
struct Desk::Work {
  Work(asio::io_context& io, std::shared_ptr<Request> asked, std::string asker)
      : request(std::move(asked)), who(std::move(asker)), language(request->language), deadline(io) {}

  std::shared_ptr<Request> request;
  std::string who;
  language::Language language;
  Job job;          // of the workers, one after another
  std::string key;  // of the job, once it is in by_key_
  Load line = Load::light;
  std::optional<Lines::Place> place;  // in a line, or being done by its worker
  std::stop_source stop;
  asio::steady_timer deadline;
  std::map<Ticket, Reply> waiting;
};

Desk::Desk(asio::io_context& io, const Service& service, const Limits& limits, Lines& lines)
    : io_(io), service_(service), limits_(limits), lines_(lines) {}

Desk::~Desk() = default;

void Desk::later(const Shared& work, void (Desk::*step)(const Shared&)) {
  asio::post(io_, [this, work, step] { (this->*step)(work); });
}

Desk::Ticket Desk::ask(std::shared_ptr<Request> request, std::string who, Reply reply) {
  const Load line = service_.line_of(*request);
  auto work = std::make_shared<Work>(io_, std::move(request), std::move(who));
  const Ticket ticket = ++last_;
  work->waiting.emplace(ticket, std::move(reply));
  asked_.emplace(ticket, work);
  submit(work, line, [this, work] { attempt(work, &Desk::read); });
  return ticket;
}

void Desk::submit(const Shared& work, Load line, std::function<void()> task) {
  work->line = line;
  work->place = lines_.submit(line, work->who, std::move(task));
  if (work->place) {
    working_.insert(work.get());
    return;
  }
  const bool heavy = is_heavy(line);
  asio::post(io_, [this, work, heavy] {
    finish(work, busy(heavy ? line_is_full : too_many_requests, heavy ? ask_later : ask_soon, work->language));
  });
}

/// On a worker: a step that fails ends its own request, whatever it was.
void Desk::attempt(const Shared& work, void (Desk::*step)(const Shared&)) {
  try {
    (this->*step)(work);
  } catch (const std::exception& exception) {
    log_line(fmt::format("axiometry: a request failed: {}", exception.what()));
    asio::post(io_, [this, work] {
      finish(work, refusal(500, "the program failed at this request; nothing was kept", work->language));
    });
  }
}

/// On a worker. What costs no more than what this worker is for it does at once.
void Desk::read(const Shared& work) {
  const Load line = work->line;
  asio::post(io_, [this, work, line] { has_begun(work, line); });
  work->job = service_.read(work->request);
  if (work->job.key.empty() && may_do(line, work->job.load)) return compute(work);
  later(work, &Desk::has_been_read);
}

void Desk::compute(const Shared& work) {
  Response response = work->job.answer(work->stop.get_token());
  work->job.answer = nullptr;
  work->request.reset();
  asio::post(io_, [this, work, response = std::move(response)]() mutable { finish(work, std::move(response)); });
}

void Desk::has_begun(const Shared& work, Load load) {
  if (work->waiting.empty()) return;
  work->deadline.expires_after(deadline_of(limits_, load));
  work->deadline.async_wait([this, work, load](const boost::system::error_code& code) {
    if (code || work->waiting.empty()) return;
    work->stop.request_stop();
    const auto seconds = std::chrono::duration<double>(deadline_of(limits_, load)).count();
    answer(work,
           busy(fmt::format("found a request that took longer than {:g} s, expected one that asks for less", seconds),
                ask_later, work->language));
  });
}

/// Who asks for what is being made already waits for that.
void Desk::has_been_read(const Shared& work) {
  has_left_line(work);
  if (work->waiting.empty()) return;
  work->key = work->job.key;
  if (!work->key.empty()) {
    const auto [same, is_first] = by_key_.try_emplace(work->key, work);
    if (!is_first) {
      for (const auto& [ticket, reply] : work->waiting) asked_[ticket] = same->second;
      same->second->waiting.merge(work->waiting);
      return;
    }
  }
  submit(work, work->job.load, [this, work] {
    asio::post(io_, [this, work] { has_begun(work, work->job.load); });
    attempt(work, &Desk::compute);
  });
}

void Desk::forget_key(const Shared& work) {
  const auto found = by_key_.find(work->key);
  if (found != by_key_.end() && found->second == work) by_key_.erase(found);
}

/// The worker is free again, or the place.
void Desk::has_left_line(const Shared& work) {
  work->deadline.cancel();
  work->place.reset();
  working_.erase(work.get());
  if (working_.empty() && when_idle) when_idle();
}

void Desk::finish(const Shared& work, Response response) {
  has_left_line(work);
  answer(work, std::move(response));
}

void Desk::answer(const Shared& work, Response response) {
  work->deadline.cancel();
  forget_key(work);
  if (work->waiting.empty()) return;
  service_.finish(response);
  const auto shared = std::make_shared<const Response>(std::move(response));
  const auto waiting = std::exchange(work->waiting, {});
  for (const auto& [ticket, reply] : waiting) asked_.erase(ticket);
  for (const auto& [ticket, reply] : waiting) reply(shared);
}

bool Desk::leave(Ticket ticket) {
  const auto found = asked_.find(ticket);
  if (found == asked_.end()) return false;
  const Shared work = found->second;
  if (!is_heavy(work->line)) return false;
  asked_.erase(found);
  work->waiting.erase(ticket);
  if (!work->waiting.empty()) return true;
  work->deadline.cancel();
  forget_key(work);
  if (work->place && lines_.withdraw(*work->place))
    has_left_line(work);
  else
    work->stop.request_stop();
  return true;
}

std::size_t Desk::waiting_for(std::string_view key) const {
  const auto found = by_key_.find(key);
  return found == by_key_.end() ? 0 : found->second->waiting.size();
}

}  // namespace axiometry::server
