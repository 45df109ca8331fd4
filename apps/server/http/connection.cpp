// SPDX-License-Identifier: Apache-2.0
#include "server/http/connection.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/buffer_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/serializer.hpp>
#include <boost/beast/http/write.hpp>
#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "server/http/byte_stream.h"
#include "server/http/client_hello.h"
#include "server/http/deadline.h"
#include "server/http/disconnect.h"
#include "server/http/request_head.h"
#include "server/http/response_message.h"

namespace axiometry::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = boost::beast::http;
using asio::ip::tcp;
using beast::error_code;
using Clock = std::chrono::steady_clock;

constexpr std::size_t piece_bytes = std::size_t{64} << 10;
constexpr auto lingering = std::chrono::seconds(3);
constexpr auto lingering_at_the_end = std::chrono::milliseconds(250);
constexpr auto watching = std::chrono::milliseconds(500);
constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";

/// A chain of steps, each of which begins the next; between two of them nothing happens, so
/// that no two operations run at once. All on the I/O thread, but for the answer itself.
class Connection final : public Guest, public std::enable_shared_from_this<Connection> {
 public:
  /// Within TLS where there is a context of it.
  Connection(tcp::socket socket, asio::ssl::context* context, std::string peer, ConnectionShare& share)
      : stream_(std::move(socket), context),
        peer_(std::move(peer)),
        whose_(peer_),
        share_(share),
        deadline_(stream_.get_executor()),
        watch_(stream_.get_executor()) {
    share_.connections.insert(this);
  }

  ~Connection() override {
    share_.connections.erase(this);
    if (share_.connections.empty() && share_.when_none) share_.when_none();
  }

  void begin() {
    if (stream_.is_tls()) return greet();
    wait_for_request(share_.limits.head);
  }

  void hang_up() override {
    keeps_alive_ = false;
    if (is_idle_) return close();
    if (is_leaving_) allow(lingering_at_the_end);
  }

  void make_room() override { close(); }
  ConnectionState state() const override { return {whose_, doing_, last_moved_, bytes_held()}; }

 private:
  using Doing = ConnectionState::Doing;

  tcp::socket& socket() { return stream_.socket(); }

  /// What runs now is cancelled after that time, unless this is called again. The stream stays whole, so that an answer
  /// can still be sent.
  void allow(Clock::duration time) { allow_until(Clock::now() + time); }

  void allow_until(Clock::time_point end) {
    deadline_.set(end, [self = shared_from_this()] {
      error_code ignored;
      self->socket().cancel(ignored);
    });
  }

  Clock::duration time_for(std::size_t bytes) const {
    return share_.limits.grace + std::chrono::milliseconds(bytes * 1000 / share_.limits.bytes_per_second);
  }

  void close() {
    is_closed_ = true;
    share_.connections.erase(this);
    deadline_.lift();
    error_code ignored;
    socket().close(ignored);
  }

  void greet() {
    deadline_.set(Clock::now() + share_.limits.head, [self = shared_from_this()] { self->close(); });
    await_client_hello(socket(), [self = shared_from_this()](bool has_come) {
      if (!has_come) return self->close();
      // Where the time passes before its turn comes, nothing holds it any more.
      self->share_.fair_queue.enter(self->peer_, [weak = self->weak_from_this()] {
        if (const auto still_there = weak.lock()) still_there->shake_hands();
      });
    });
  }

  void shake_hands() {
    stream_.greet_client([self = shared_from_this()](error_code code) {
      if (code) return self->close();
      self->wait_for_request(self->share_.limits.head);
    });
  }

  void wait_for_request(Clock::duration time) {
    if (share_.ending) return close();
    is_idle_ = true;
    if (buffer_.size() > 0) return read_request_head();  // sent ahead
    allow(time);
    stream_.async_read_some(buffer_.prepare(4096), [self = shared_from_this()](error_code code, std::size_t count) {
      if (code) return self->close();
      self->buffer_.commit(count);
      self->read_request_head();
    });
  }

  void read_request_head() {
    parser_.emplace();
    parser_->header_limit(static_cast<std::uint32_t>(share_.limits.head_bytes));
    // Checked here, with the body. Beast of Boost 1.74 takes "none" for a limit that every body exceeds.
    parser_->body_limit(std::numeric_limits<std::uint64_t>::max());
    request_ = {};
    request_.peer = peer_;
    keeps_alive_ = false;
    began_ = Clock::now();
    allow(share_.limits.head);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = shared_from_this()](error_code code, std::size_t) { self->head_came(code); });
  }

  void head_came(error_code code) {
    is_idle_ = false;
    if (code) return failed_to_read(code, "head");
    auto head = read_head(parser_->get(), peer_);
    if (!head) return respond(std::move(head).error());
    request_ = std::move(head->request);
    const bool has_body = !parser_->is_done();
    const bool may_stay = parser_->get().keep_alive();
    keeps_alive_ = may_stay && !has_body;
    if (auto refused = share_.service.refused(request_)) return respond(*std::move(refused));
    if (share_.service.peer_of) whose_ = share_.service.peer_of(request_);
    body_max_ = share_.limits.upload_bytes;
    if (share_.service.body_max) body_max_ = std::min(body_max_, share_.service.body_max(request_));
    if (head->length && *head->length > body_max_) return respond(body_too_large(request_, body_max_));
    keeps_alive_ = may_stay;
    if (!has_body) return answer();
    if (head->expects_continue) return send_continue();
    begin_body();
  }

  void send_continue() {
    allow(share_.limits.head);
    asio::async_write(stream_, asio::buffer(go_on), [self = shared_from_this()](error_code code, std::size_t) {
      if (code) return self->close();
      self->begin_body();
    });
  }

  void begin_body() {
    piece_.resize(piece_bytes);
    parser_->on_chunk_header(refuse_large_chunk_);
    body_began_ = last_moved_ = Clock::now();
    doing_ = Doing::receiving;
    read_body();
  }

  /// A piece may come as late as the smallest rate allows for what has come before it.
  void read_body() {
    parser_->get().body().data = piece_.data();
    parser_->get().body().size = piece_.size();
    allow_until(body_began_ + time_for(request_.body.size()));
    http::async_read_some(stream_, buffer_, *parser_,
                          [self = shared_from_this()](error_code code, std::size_t) { self->body_came(code); });
  }

  void body_came(error_code code) {
    if (code == http::error::body_limit) return give_up(body_too_large(request_, body_max_));
    if (code && code != http::error::need_buffer) return failed_to_read(code, "body");
    const std::size_t count = piece_.size() - parser_->get().body().size;
    if (request_.body.size() + count > body_max_) return give_up(body_too_large(request_, body_max_));
    last_moved_ = Clock::now();
    if (!share_.make_memory(*this, count)) return give_up(too_many_bodies(request_));
    body_bytes_ += count;
    request_.body.append(piece_.data(), count);
    if (!parser_->is_done()) return read_body();
    piece_ = {};
    answer();
  }

  std::size_t bytes_held() const {
    const auto sharing = static_cast<std::size_t>(std::max(1L, answer_.use_count()));
    return body_bytes_ + (answer_ ? answer_->body.size() / sharing : 0);
  }

  /// An answer although the rest of the request is still to come.
  void give_up(Response response) {
    keeps_alive_ = false;
    release_body();
    respond(std::move(response));
  }

  void failed_to_read(error_code code, std::string_view part) {
    if (deadline_.has_passed())
      return give_up(refusal(408, fmt::format("found a request whose {} came too slowly, expected it faster", part)));
    if (code == http::error::end_of_stream || code == http::error::partial_message) return close();
    if (code.category() == http::make_error_code(http::error::bad_value).category()) return give_up(refusal_of(code));
    close();
  }

  void answer() {
    deadline_.lift();
    doing_ = Doing::waiting;
    std::string body = std::exchange(request_.body, {});
    auto request = std::make_shared<Request>(request_);
    request->body = std::move(body);
    asked_ = share_.dispatcher.ask(std::move(request), whose_,
                                   [self = shared_from_this()](std::shared_ptr<const Response> response) {
                                     self->asked_.reset();
                                     self->watch_.cancel();
                                     self->release_body();
                                     self->deliver(std::move(response));
                                   });
    watch_for_leaving();
  }

  void release_body() {
    body_bytes_ = 0;
    piece_ = {};
    std::string().swap(request_.body);
  }

  /// Who leaves while the request is in line or being answered gives up what it asked for.
  void watch_for_leaving() {
    watch_.expires_after(watching);
    watch_.async_wait([self = shared_from_this()](error_code code) {
      if (code || !self->asked_) return;
      if (!has_left(self->socket().native_handle())) return self->watch_for_leaving();
      if (!self->share_.dispatcher.leave(*self->asked_)) return self->watch_for_leaving();
      self->asked_.reset();
      self->close();
    });
  }

  /// One that the transport makes itself.
  void respond(Response response) {
    share_.service.finish(response);
    deliver(std::make_shared<const Response>(std::move(response)));
  }

  void deliver(std::shared_ptr<const Response> response) {
    if (!response) return close();
    share_.tell_of_event(request_, *response);
    if (response->delay.count() == 0) return write(std::move(response));
    if (share_.ending) return close();
    is_idle_ = true;
    doing_ = Doing::idle;  // computes nothing: may give way
    const auto end = Clock::now() + response->delay;
    deadline_.set(end, [self = shared_from_this(), response = std::move(response)]() mutable {
      self->write(std::move(response));
    });
  }

  void write(std::shared_ptr<const Response> response) {
    if (is_closed_) return;
    is_idle_ = false;
    last_moved_ = Clock::now();
    if (share_.ending) keeps_alive_ = false;
    answer_ = share_.as_fits(*this, std::move(response), request_);
    doing_ = Doing::sending;
    answer_until_ = Clock::now() + time_for(answer_->body.size());
    message_.emplace(message_of(*answer_, {.version = parser_->get().version() == 10 ? 10U : 11U,
                                           .head_only = request_.method == "HEAD",
                                           .keeps_alive = keeps_alive_,
                                           .is_of_api = request_.path.starts_with("/api/")}));
    serializer_.emplace(*message_);
    send();
    share_.tell_of_answer(request_, *answer_, Clock::now() - began_);
  }

  /// Piece by piece, each of which must go out within the grace, and all within what the size allows.
  void send() {
    allow_until(std::min(answer_until_, Clock::now() + share_.limits.grace));
    http::async_write_some(stream_, *serializer_, [self = shared_from_this()](error_code code, std::size_t) {
      if (code) return self->close();
      self->last_moved_ = Clock::now();
      if (!self->serializer_->is_done()) return self->send();
      self->sent();
    });
  }

  void sent() {
    serializer_.reset();
    message_.reset();
    answer_.reset();
    request_ = {};
    doing_ = Doing::idle;
    if (!keeps_alive_) return say_goodbye();
    wait_for_request(share_.limits.idle);
  }

  void say_goodbye() {
    is_leaving_ = true;
    allow(share_.ending ? lingering_at_the_end : lingering);
    stream_.say_goodbye([self = shared_from_this()](error_code) { self->end_sending(); });
  }

  /// A socket that is closed while the client still sends would take back the answer, so what comes is read and
  /// forgotten for a while.
  void end_sending() {
    error_code code;
    socket().shutdown(tcp::socket::shutdown_send, code);
    if (code) return close();
    piece_.resize(piece_bytes);
    drain();
  }

  void drain() {
    socket().async_read_some(asio::buffer(piece_), [self = shared_from_this()](error_code code, std::size_t) {
      if (code) return self->close();
      self->drain();
    });
  }

  ByteStream stream_;
  std::string peer_;   // the address
  std::string whose_;  // share and turn it takes: of the address, or of who has signed in; of nobody's own choice
  ConnectionShare& share_;
  Deadline deadline_;
  asio::steady_timer watch_;
  std::optional<Dispatcher::Ticket> asked_;  // the request that waits in a line or is being answered
  bool is_idle_ = true;                      // no head has come whole, or the answer is only held back
  bool is_leaving_ = false;                  // has the last answer
  bool is_closed_ = false;
  bool keeps_alive_ = false;
  Doing doing_ = Doing::silent;
  Clock::time_point last_moved_ = Clock::now();
  beast::flat_buffer buffer_{std::size_t{256} << 10};
  std::optional<http::request_parser<http::buffer_body>> parser_;
  Request request_;
  std::vector<char> piece_;
  std::function<void(std::uint64_t, beast::string_view, error_code&)> refuse_large_chunk_ =
      [this](std::uint64_t size, beast::string_view, error_code& code) {
        if (size > body_max_) code = http::error::body_limit;
      };
  std::size_t body_max_ = 0;
  std::size_t body_bytes_ = 0;              // bytes of the body, also while the request is answered
  std::shared_ptr<const Response> answer_;  // the answer that is being sent
  std::optional<ResponseMessage> message_;
  std::optional<http::serializer<false, ResponseMessage::body_type>> serializer_;
  Clock::time_point began_, body_began_, answer_until_;
};

}  // namespace

void serve(tcp::socket socket, asio::ssl::context* context, std::string peer, ConnectionShare& share) {
  std::make_shared<Connection>(std::move(socket), context, std::move(peer), share)->begin();
}

}  // namespace axiometry::server
