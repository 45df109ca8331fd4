// SPDX-License-Identifier: Apache-2.0
#include "connection.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/post.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/write.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/buffer_body.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <chrono>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "departure.h"
#include "request_head.h"

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
constexpr auto watching = std::chrono::milliseconds(500);
constexpr auto soon = std::chrono::seconds(2);
constexpr std::string_view line_is_full =
    "found more reports and evaluations in line than the server takes, expected fewer; try again in a moment";
constexpr std::string_view go_on = "HTTP/1.1 100 Continue\r\n\r\n";

/// Nothing of ours holds line ends; what came from elsewhere must not begin a header of its own.
std::string header_value(std::string_view value) {
  std::string safe(value);
  std::ranges::replace_if(
      safe, [](char c) { return static_cast<unsigned char>(c) < ' ' || c == 0x7F; }, ' ');
  return safe;
}

/// On a stream of TCP or TLS. A chain of steps, each of which begins the next; between two of them nothing happens, so
/// that no two operations run at once. All on the I/O thread, but for the answer itself.
template <typename Stream>
class Connection final : public Hangable, public std::enable_shared_from_this<Connection<Stream>> {
 public:
  Connection(Stream stream, std::string peer, ConnectionShare& share)
      : stream_(std::move(stream)),
        peer_(std::move(peer)),
        share_(share),
        timer_(stream_.get_executor()),
        watch_(stream_.get_executor()) {
    share_.connections.insert(this);
  }

  ~Connection() override {
    release_body();
    share_.connections.erase(this);
    if (share_.connections.empty() && share_.when_none) share_.when_none();
  }

  void begin() {
    if constexpr (is_tls) {
      allow(share_.limits.head);
      stream_.async_handshake(asio::ssl::stream_base::server, [self = this->shared_from_this()](error_code code) {
        if (code) return self->close();
        self->wait_for_request(self->share_.limits.head);
      });
    } else {
      wait_for_request(share_.limits.head);
    }
  }

  void hang_up() override {
    keeps_alive_ = false;
    if (is_idle_) close();
  }

 private:
  static constexpr bool is_tls = !std::is_same_v<Stream, tcp::socket>;

  tcp::socket& socket() {
    if constexpr (is_tls)
      return stream_.next_layer();
    else
      return stream_;
  }

  /// What runs now is cancelled after that time, unless this is called again. The stream stays whole, so that an answer
  /// can still be sent.
  void allow(Clock::duration time) { allow_until(Clock::now() + time); }

  void allow_until(Clock::time_point end) {
    timed_out_ = false;
    timer_.expires_at(end);
    timer_.async_wait([self = this->shared_from_this(), number = ++deadline_](error_code code) {
      if (code || number != self->deadline_) return;
      self->timed_out_ = true;
      error_code ignored;
      self->socket().cancel(ignored);
    });
  }

  void take_your_time() {
    ++deadline_;
    timer_.cancel();
  }

  Clock::duration time_for(std::size_t bytes) const {
    return share_.limits.grace + std::chrono::milliseconds(bytes * 1000 / share_.limits.bytes_per_second);
  }

  void close() {
    take_your_time();
    error_code ignored;
    socket().close(ignored);
  }

  void wait_for_request(Clock::duration time) {
    if (share_.ending) return close();
    if (buffer_.size() > 0) return read_request_head();  // sent ahead
    is_idle_ = true;
    allow(time);
    stream_.async_read_some(buffer_.prepare(4096),
                            [self = this->shared_from_this()](error_code code, std::size_t count) {
                              self->is_idle_ = false;
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
    keeps_alive_ = false;
    began_ = Clock::now();
    allow(share_.limits.head);
    http::async_read_header(stream_, buffer_, *parser_,
                            [self = this->shared_from_this()](error_code code, std::size_t) { self->head_came(code); });
  }

  void head_came(error_code code) {
    if (code) return failed_to_read(code, "head");
    auto head = read_head(parser_->get(), peer_);
    if (!head) return respond(std::move(head).error());
    request_ = std::move(head->request);
    const bool has_body = !parser_->is_done();
    const bool may_stay = parser_->get().keep_alive();
    keeps_alive_ = may_stay && !has_body;
    if (auto refused = share_.service.refused(request_)) return respond(*std::move(refused));
    if (head->length && *head->length > share_.limits.upload_bytes) return respond(too_large());
    keeps_alive_ = may_stay;
    if (!has_body) return answer();
    if (head->expects_continue) return say_go_on();
    begin_body();
  }

  void say_go_on() {
    allow(share_.limits.head);
    asio::async_write(stream_, asio::buffer(go_on), [self = this->shared_from_this()](error_code code, std::size_t) {
      if (code) return self->close();
      self->begin_body();
    });
  }

  void begin_body() {
    piece_.resize(piece_bytes);
    body_began_ = Clock::now();
    read_body();
  }

  /// A piece may come as late as the smallest rate allows for what has come before it.
  void read_body() {
    parser_->get().body().data = piece_.data();
    parser_->get().body().size = piece_.size();
    allow_until(body_began_ + time_for(request_.body.size()));
    http::async_read_some(stream_, buffer_, *parser_,
                          [self = this->shared_from_this()](error_code code, std::size_t) { self->body_came(code); });
  }

  void body_came(error_code code) {
    if (code && code != http::error::need_buffer) return failed_to_read(code, "body");
    const std::size_t count = piece_.size() - parser_->get().body().size;
    if (request_.body.size() + count > share_.limits.upload_bytes) return give_up(too_large());
    if (share_.bodies_bytes + count > share_.limits.bodies_bytes)
      return give_up(
          busy("found more uploads at once than the server has memory for, expected fewer", soon, request_.language));
    share_.bodies_bytes += count;
    counted_bytes_ += count;
    request_.body.append(piece_.data(), count);
    if (!parser_->is_done()) return read_body();
    piece_ = {};
    answer();
  }

  void release_body() {
    share_.bodies_bytes -= std::exchange(counted_bytes_, 0);
    piece_ = {};
  }

  Response too_large() const {
    return refusal(413, fmt::format("found a body of more than {} bytes, expected less", share_.limits.upload_bytes),
                   request_.language);
  }

  /// An answer although the rest of the request is still to come.
  void give_up(Response response) {
    keeps_alive_ = false;
    std::string().swap(request_.body);
    release_body();
    respond(std::move(response));
  }

  void failed_to_read(error_code code, std::string_view part) {
    if (timed_out_)
      return give_up(refusal(408, fmt::format("found a request whose {} came too slowly, expected it faster", part)));
    if (code == http::error::end_of_stream || code == http::error::partial_message) return close();
    if (code.category() == http::make_error_code(http::error::bad_value).category()) return give_up(refusal_of(code));
    close();
  }

  void answer() {
    take_your_time();
    const Load load = share_.service.load_of ? share_.service.load_of(request_) : Load::light;
    const bool is_heavy = load != Load::light;
    WorkerPool& pool = is_heavy ? share_.heavy : share_.light;
    std::function<void()> task = [self = this->shared_from_this()]() mutable {
      Connection& connection = *self;
      std::string body = std::exchange(connection.request_.body, {});
      Request request = connection.request_;
      request.body = std::move(body);
      Response response = connection.share_.service.answer(std::move(request));
      asio::post(connection.timer_.get_executor(), [self = std::move(self), response = std::move(response)]() mutable {
        self->waiting_.reset();
        self->watch_.cancel();
        self->release_body();
        self->respond(std::move(response));
      });
    };
    waiting_ = pool.submit(peer_ + ' ' + request_.actor, std::move(task), load == Load::lone);
    if (waiting_) {
      if (is_heavy) watch_for_leaving();
      return;
    }
    release_body();
    if (is_heavy) return respond(busy(line_is_full, std::chrono::seconds(10), request_.language));
    respond(busy("found more requests at once than the server can answer, expected fewer", soon, request_.language));
  }

  /// Who leaves while the request is still in line gives up its place.
  void watch_for_leaving() {
    watch_.expires_after(watching);
    watch_.async_wait([self = this->shared_from_this()](error_code code) {
      if (code || !self->waiting_) return;
      if (!has_left(self->socket().native_handle())) return self->watch_for_leaving();
      if (self->share_.heavy.withdraw(*self->waiting_)) self->close();
    });
  }

  void respond(Response response) {
    if (response.delay.count() == 0) return write(std::move(response));
    take_your_time();
    timer_.expires_after(std::exchange(response.delay, {}));
    timer_.async_wait([self = this->shared_from_this(), response = std::move(response)](error_code) mutable {
      self->write(std::move(response));
    });
  }

  void write(Response response) {
    share_.service.finish(response);
    if (share_.ending) keeps_alive_ = false;
    const std::size_t size = response.body.size();
    if (share_.service.answered)
      share_.service.answered(
          {.request = request_,
           .status = response.status,
           .bytes = size,
           .milliseconds = std::chrono::duration<double, std::milli>(Clock::now() - began_).count()});
    allow(time_for(size));
    if (request_.method == "HEAD")
      send(message_of<http::empty_body>(response, size));
    else
      send(message_of<http::string_body>(response, size));
  }

  template <typename Body>
  std::shared_ptr<http::response<Body>> message_of(Response& response, std::size_t size) {
    auto message = std::make_shared<http::response<Body>>();
    message->version(parser_->get().version() == 10 ? 10 : 11);
    message->result(static_cast<unsigned>(response.status));
    for (const auto& [name, value] : response.headers) message->insert(name, header_value(value));
    const bool has_no_body = response.status == 204 || response.status == 304;
    if (!has_no_body) {
      message->set(http::field::content_type, header_value(response.content_type));
      message->content_length(size);
      if constexpr (std::is_same_v<Body, http::string_body>) message->body() = std::move(response.body);
    }
    message->keep_alive(keeps_alive_);
    return message;
  }

  template <typename Message>
  void send(std::shared_ptr<Message> message) {
    Message& whole = *message;
    http::async_write(stream_, whole,
                      [self = this->shared_from_this(), message](error_code code, std::size_t) { self->sent(code); });
  }

  void sent(error_code code) {
    if (code) return close();
    request_ = {};
    if (!keeps_alive_) return say_goodbye();
    wait_for_request(share_.limits.idle);
  }

  void say_goodbye() {
    allow(lingering);
    if constexpr (is_tls) {
      stream_.async_shutdown([self = this->shared_from_this()](error_code) { self->end_sending(); });
    } else {
      end_sending();
    }
  }

  /// A socket that is closed while the client still sends would take back the answer, so what comes is read and
  /// forgotten for a while.
  void end_sending() {
    error_code code;
    socket().shutdown(tcp::socket::shutdown_send, code);
    if (code) return close();
    piece_.resize(piece_bytes);
    allow(lingering);
    forget_more();
  }

  void forget_more() {
    socket().async_read_some(asio::buffer(piece_), [self = this->shared_from_this()](error_code code, std::size_t) {
      if (code) return self->close();
      self->forget_more();
    });
  }

  Stream stream_;
  std::string peer_;
  ConnectionShare& share_;
  asio::steady_timer timer_;
  asio::steady_timer watch_;
  std::optional<WorkerPool::Ticket> waiting_;  // in the line of either pool, or being answered
  std::uint64_t deadline_ = 0;                 // counts deadlines, so that one that has passed meanwhile is known
  bool timed_out_ = false;
  bool is_idle_ = false;
  bool keeps_alive_ = false;
  beast::flat_buffer buffer_{std::size_t{256} << 10};
  std::optional<http::request_parser<http::buffer_body>> parser_;
  Request request_;
  std::vector<char> piece_;
  std::size_t counted_bytes_ = 0;  // of this body in share_.bodies_bytes
  Clock::time_point began_;
  Clock::time_point body_began_;
};

std::string peer_of(const tcp::socket& socket) {
  error_code code;
  const auto endpoint = socket.remote_endpoint(code);
  return code ? "" : endpoint.address().to_string();
}

}  // namespace

void serve_plain(tcp::socket socket, ConnectionShare& share) {
  std::string peer = peer_of(socket);
  std::make_shared<Connection<tcp::socket>>(std::move(socket), std::move(peer), share)->begin();
}

void serve_tls(tcp::socket socket, asio::ssl::context& context, ConnectionShare& share) {
  using Stream = asio::ssl::stream<tcp::socket>;
  std::string peer = peer_of(socket);
  std::make_shared<Connection<Stream>>(Stream(std::move(socket), context), std::move(peer), share)->begin();
}

}  // namespace axiometry::server
