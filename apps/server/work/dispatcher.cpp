// SPDX-License-Identifier: Apache-2.0
#include "server/work/dispatcher.h"

#include <fmt/format.h>

#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <exception>
#include <optional>
#include <stop_token>
#include <thread>
#include <utility>

#include "server/log.h"

namespace axiometry::server {
namespace {

namespace asio = boost::asio;

constexpr auto ask_later = std::chrono::seconds(10);
constexpr auto until_there_is_memory = std::chrono::milliseconds(20);
constexpr std::string_view line_is_full =
    "found more reports and evaluations in line than the server takes, expected fewer; try again in a moment";
constexpr std::string_view outcome_unknown =
    "the server's work at this request does not end; whether anything was kept is not known: look before it is sent "
    "again";
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

std::string too_long(const Limits& limits, Load load) {
  return fmt::format("found a request that took longer than {:g} s, expected one that asks for less",
                     std::chrono::duration<double>(deadline_of(limits, load)).count());
}

std::string message_of_refusal(const Response& refused) {
  const auto body = json::parse(refused.body);
  const json::Value* error = body ? body->find("error") : nullptr;
  const json::Value* message = error != nullptr ? error->find("message") : nullptr;
  return message != nullptr && message->is(json::Kind::text) ? std::string(message->text()) : std::string();
}

/// What it came to says the work; why it was stopped, and when to come again, the dispatcher.
Response stopped(const Response& came_to, std::string_view why, language::Language language) {
  return busy(fmt::format("{}; {}", language::translated(why, language), message_of_refusal(came_to)), ask_later,
              language);
}

/// What `make` gives; nothing where there is no memory for it.
template <typename Make>
std::optional<Response> made(const Make& make) {
  try {
    return make();
  } catch (const std::exception& exception) {
    log_failure("an answer", exception);
    return {};
  }
}

std::optional<Response> refusal_of_overdue(const Limits& limits, Load load, language::Language language) {
  return made([&] { return busy(too_long(limits, load), ask_later, language); });
}

/// From a worker, sooner or later: somebody waits for it, and nobody else tells.
template <typename Step>
void post_in_any_case(asio::io_context& io, const Step& step) {
  while (true) {
    try {
      return asio::post(io, step);
    } catch (const std::exception& exception) {
      log_failure("telling of a failure", exception);
      std::this_thread::sleep_for(until_there_is_memory);
    }
  }
}

/// What a reply throws ends its own connection.
void hand_out(const Dispatcher::Reply& reply, const std::shared_ptr<const Response>& response) {
  try {
    reply(response);
  } catch (const std::exception& exception) {
    log_failure("giving an answer", exception);
    reply(nullptr);
  }
}

}  // namespace

/// One computation and all who wait for it.
struct Dispatcher::Work {
  Work(asio::io_context& io, std::shared_ptr<Request> asked, std::string asker, bool may_keep)
      : request(std::move(asked)), who(std::move(asker)), language(request->language), keeps(may_keep), deadline(io) {}

  std::shared_ptr<Request> request;
  std::string who;
  language::Language language;
  bool keeps = false;          // whether the job may keep something
  bool may_have_kept = false;  // set by the workers once they have begun to answer it
  Job job;                     // of the workers, one after another
  std::string key;             // of the job, once it is in by_key_
  Load line = Load::light;
  std::optional<RequestQueues::Place> place;  // its place while it waits in a line or its worker does it
  std::stop_source stop;
  std::optional<Load> overdue;  // told to stop by the deadline of that
  asio::steady_timer deadline;
  std::map<Ticket, Reply> waiting;
};

Dispatcher::Dispatcher(asio::io_context& io, const Service& service, const Limits& limits, RequestQueues& queues)
    : io_(io), service_(service), limits_(limits), queues_(queues) {}

Dispatcher::~Dispatcher() = default;

void Dispatcher::later(const Shared& work, void (Dispatcher::*step)(const Shared&)) {
  asio::post(io_, [this, work, step] { (this->*step)(work); });
}

Dispatcher::Ticket Dispatcher::ask(std::shared_ptr<Request> request, std::string who, Reply reply) {
  const Load line = service_.queue_of(*request);
  const bool keeps = service_.keeps && service_.keeps(*request);
  auto work = std::make_shared<Work>(io_, std::move(request), std::move(who), keeps);
  const Ticket ticket = ++last_;
  work->waiting.emplace(ticket, std::move(reply));
  asked_.emplace(ticket, work);
  try {
    submit(work, line, &Dispatcher::read);
  } catch (...) {
    asked_.erase(ticket);
    work->waiting.clear();
    throw;
  }
  return ticket;
}

void Dispatcher::submit(const Shared& work, Load line, void (Dispatcher::*step)(const Shared&)) {
  work->line = line;
  work->place = queues_.submit(line, work->who, [this, work, step] { attempt(work, step); });
  if (work->place) {
    working_.insert(work.get());
    return;
  }
  const bool heavy = is_heavy(line);
  asio::post(io_, [this, work, heavy] {
    const auto full = heavy ? line_is_full : too_many_requests;
    const auto when = heavy ? ask_later : ask_again_soon;
    finish(work, made([&] { return with_event(busy(full, when, work->language), SecurityEvent::quota_refused); }));
  });
}

/// On a worker: a step that fails ends its own request, whatever it was.
void Dispatcher::attempt(const Shared& work, void (Dispatcher::*step)(const Shared&)) {
  try {
    (this->*step)(work);
  } catch (const std::exception& exception) {
    log_failure("a request", exception);
    tell_of_failure(work);
  }
}

void Dispatcher::tell_of_failure(const Shared& work) {
  post_in_any_case(io_,
                   [this, work] { finish(work, made([&] { return failure(work->may_have_kept, work->language); })); });
}

/// On a worker. What costs no more than what this worker is for it does at once.
void Dispatcher::read(const Shared& work) {
  const Load line = work->line;
  asio::post(io_, [this, work, line] { has_begun(work, line); });
  work->job = service_.read(work->request);
  if (work->job.key.empty() && may_do(line, work->job.load)) return compute(work);
  later(work, &Dispatcher::has_been_read);
}

/// On a worker, of what was read.
void Dispatcher::begin(const Shared& work) {
  asio::post(io_, [this, work] { has_begun(work, work->job.load); });
  compute(work);
}

/// On a worker.
void Dispatcher::compute(const Shared& work) {
  work->may_have_kept = work->keeps;
  Response response = work->job.answer(work->stop.get_token());
  work->job.answer = nullptr;
  work->request.reset();
  asio::post(io_, [this, work, response = std::move(response)]() mutable { finish(work, std::move(response)); });
}

void Dispatcher::has_begun(const Shared& work, Load load) {
  if (work->waiting.empty()) return;
  work->deadline.expires_after(deadline_of(limits_, load));
  work->deadline.async_wait([this, work, load](const boost::system::error_code& code) {
    if (!code && !work->waiting.empty()) is_overdue(work, load);
  });
}

void Dispatcher::is_overdue(const Shared& work, Load load) {
  work->stop.request_stop();
  work->overdue = load;
  if (!work->keeps) return answer(work, refusal_of_overdue(limits_, load, work->language));
  work->deadline.expires_after(limits_.outcome_deadline);
  work->deadline.async_wait([this, work](const boost::system::error_code& code) {
    if (code || work->waiting.empty()) return;
    answer(work, made([&] { return refusal(504, outcome_unknown, work->language); }));
  });
}

/// What was read for too long has kept nothing yet. What cannot be handed on ends here.
void Dispatcher::has_been_read(const Shared& work) {
  has_left_line(work);
  if (work->waiting.empty()) return;
  if (work->overdue) return answer(work, refusal_of_overdue(limits_, *work->overdue, work->language));
  try {
    hand_on(work);
  } catch (const std::exception& exception) {
    log_failure("a request", exception);
    answer(work, {});
  }
}

/// Who asks for what is being made already waits for that.
void Dispatcher::hand_on(const Shared& work) {
  work->key = work->job.key;
  if (!work->key.empty()) {
    const auto [same, is_first] = by_key_.try_emplace(work->key, work);
    if (!is_first) {
      for (const auto& [ticket, reply] : work->waiting) asked_[ticket] = same->second;
      same->second->waiting.merge(work->waiting);
      return;
    }
  }
  submit(work, work->job.load, &Dispatcher::begin);
}

void Dispatcher::forget_key(const Shared& work) {
  const auto found = by_key_.find(work->key);
  if (found != by_key_.end() && found->second == work) by_key_.erase(found);
}

/// The worker is free again, or the place.
void Dispatcher::has_left_line(const Shared& work) {
  work->deadline.cancel();
  work->place.reset();
  working_.erase(work.get());
  if (working_.empty() && when_idle) when_idle();
}

void Dispatcher::finish(const Shared& work, Made response) {
  has_left_line(work);
  if (work->overdue && response && response->status == 503)
    response = made([&] { return stopped(*response, too_long(limits_, *work->overdue), work->language); });
  answer(work, std::move(response));
}

void Dispatcher::answer(const Shared& work, Made response) {
  work->deadline.cancel();
  forget_key(work);
  if (work->waiting.empty()) return;
  const auto waiting = std::exchange(work->waiting, {});
  for (const auto& [ticket, reply] : waiting) asked_.erase(ticket);
  const auto shared = to_share(std::move(response), work->keeps);
  for (const auto& [ticket, reply] : waiting) hand_out(reply, shared);
}

/// Nothing where there is no memory for it.
std::shared_ptr<const Response> Dispatcher::to_share(Made response, bool keeps) const {
  if (!response) return nullptr;
  try {
    response->is_receipt = keeps;
    service_.finish(*response);
    return std::make_shared<const Response>(*std::move(response));
  } catch (const std::exception& exception) {
    log_failure("an answer", exception);
    return nullptr;
  }
}

bool Dispatcher::leave(Ticket ticket) {
  const auto found = asked_.find(ticket);
  if (found == asked_.end()) return false;
  const Shared work = found->second;
  if (work->keeps || !is_heavy(work->line)) return false;
  asked_.erase(found);
  work->waiting.erase(ticket);
  if (!work->waiting.empty()) return true;
  work->deadline.cancel();
  forget_key(work);
  if (work->place && queues_.withdraw(*work->place))
    has_left_line(work);
  else
    work->stop.request_stop();
  return true;
}

std::size_t Dispatcher::waiting_for(std::string_view key) const {
  const auto found = by_key_.find(key);
  return found == by_key_.end() ? 0 : found->second->waiting.size();
}

}  // namespace axiometry::server
