// SPDX-License-Identifier: Apache-2.0
#include "server/http/transport.h"

#include <fmt/format.h>
#include <openssl/ssl.h>
#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/steady_timer.hpp>
#include <csignal>
#include <cstdint>
#include <exception>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "axiometry/base/text/text.h"
#include "server/http/connection.h"
#include "server/log.h"
#include "server/work/dispatcher.h"
#include "server/work/request_queues.h"

namespace axiometry::server {
namespace {

namespace asio = boost::asio;
namespace ssl = boost::asio::ssl;
using asio::ip::tcp;
using boost::system::error_code;

constexpr std::size_t workers_min = 4;  // so that a slow disk does not keep lists waiting
constexpr std::size_t heavy_min = 2;    // so that a book of a report does not keep a small one waiting
constexpr std::size_t edit_workers = 4;
constexpr const char* ciphers_of_1_2 = "ECDHE+AESGCM:ECDHE+CHACHA20";  // those of 1.3 are of this kind all
constexpr int heavy_niceness = 10;

Result<asio::ip::address> parse_address(const std::string& text) {
  error_code code;
  const auto address = asio::ip::make_address(text, code);
  if (code)
    return fail(fmt::format("found the address {}, expected one as 127.0.0.1, ::1 or 0.0.0.0", text::quoted(text)));
  return address;
}

/// Each connection is a descriptor; where the usual limit is lower it is raised as far as this process may.
void allow_descriptors(std::size_t wanted) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0 || limit.rlim_cur >= wanted) return;
  limit.rlim_cur = std::min<rlim_t>(wanted, limit.rlim_max);
  static_cast<void>(::setrlimit(RLIMIT_NOFILE, &limit));
}

RequestQueues::Options queues_for(const Limits& limits) {
  const std::size_t processors = std::thread::hardware_concurrency();
  return {.light = {.threads = std::max(processors, workers_min), .waiting_max = limits.waiting},
          .edits = {.threads = edit_workers, .waiting_max = limits.waiting, .reserved = limits.waiting / 4},
          .heavy = {.threads = std::max(processors / 2, heavy_min),
                    .waiting_max = limits.heavy_waiting,
                    .reserved = limits.heavy_waiting / 4,
                    .niceness = heavy_niceness}};
}

std::unexpected<Error> cannot_use(std::string_view what, const std::string& file, const error_code& code) {
  return std::unexpected(Error{fmt::format("cannot use it as {}: {}", what, code.message()), file, {}});
}

Result<std::unique_ptr<ssl::context>> tls_context(const TransportOptions& options) {
  auto context = std::make_unique<ssl::context>(ssl::context::tls_server);
  error_code code;
  context->set_options(ssl::context::default_workarounds | ssl::context::no_compression | SSL_OP_NO_RENEGOTIATION,
                       code);
  ::SSL_CTX_set_min_proto_version(context->native_handle(), TLS1_2_VERSION);
  if (::SSL_CTX_set_cipher_list(context->native_handle(), ciphers_of_1_2) != 1)
    return fail(ErrorKind::unavailable, "found a library of TLS without ECDHE and AEAD, expected both");
  context->set_password_callback([](std::size_t, ssl::context::password_purpose) { return std::string(); }, code);
  context->use_certificate_chain_file(options.certificate, code);
  if (code) return cannot_use("a certificate in PEM", options.certificate, code);
  context->use_private_key_file(options.key, ssl::context::pem, code);
  if (code) return cannot_use("the certificate's private key in PEM, without a password", options.key, code);
  if (::SSL_CTX_check_private_key(context->native_handle()) != 1)
    return std::unexpected(Error{"found a key of another certificate, expected the key of this one", options.key, {}});
  return context;
}

}  // namespace

struct Transport::State {
  State(const TransportOptions& from, asio::ip::address at) : options(from), address(std::move(at)) {}

  TransportOptions options;
  asio::ip::address address;
  std::unique_ptr<ConnectionShare> share;  // outlives the connections, which the context ends with
  std::unique_ptr<ssl::context> tls;
  asio::io_context io{1};
  tcp::acceptor acceptor{io};
  asio::steady_timer pause{io};
  asio::steady_timer shutdown{io};
  asio::signal_set signals{io};
  End end;
  std::unique_ptr<Dispatcher> dispatcher;  // ends before the context, whose timers it holds
  std::unique_ptr<RequestQueues> queues;   // end before what their tasks answer to

  Result<void> bind();
  void accept();
  void accepted(const error_code& code, tcp::socket socket);
  void take_in(tcp::socket socket);
  void work();
  bool is_done() const { return share->connections.empty() && dispatcher->is_idle(); }
  void look_whether_done();
  void await_signal();
  void finish();
};

Result<void> Transport::State::bind() {
  error_code code;
  const tcp::endpoint endpoint(address, static_cast<std::uint16_t>(options.port));
  acceptor.open(endpoint.protocol(), code);
  if (!code) acceptor.set_option(asio::socket_base::reuse_address(true), code);
  if (!code) acceptor.bind(endpoint, code);
  if (!code) acceptor.listen(asio::socket_base::max_listen_connections, code);
  if (!code) return {};
  const std::string advice = code == asio::error::address_in_use
                                 ? "; another program listens there: choose another with --port, or 0 for a free one"
                                 : "";
  return fail(ErrorKind::unavailable, fmt::format("cannot listen on port {} of {}: {}{}", options.port, options.listen,
                                                  code.message(), advice));
}

void Transport::State::accept() {
  acceptor.async_accept([this](const error_code& code, tcp::socket socket) { accepted(code, std::move(socket)); });
}

void Transport::State::accepted(const error_code& code, tcp::socket socket) {
  if (share->ending) return;
  if (code == asio::error::no_descriptors || code == asio::error::no_buffer_space || code == asio::error::no_memory) {
    pause.expires_after(std::chrono::milliseconds(100));
    pause.async_wait([this](const error_code&) {
      if (!share->ending) accept();
    });
    return;
  }
  accept();
  if (!code) take_in(std::move(socket));
}

void Transport::State::take_in(tcp::socket socket) {
  std::string peer = peer_of(socket);
  if (!share->make_room(peer)) return;
  error_code ignored;
  socket.set_option(tcp::no_delay(true), ignored);
  serve(std::move(socket), tls.get(), std::move(peer), *share);
}

/// A fault of one connection ends that connection: what it held goes with its step.
void Transport::State::work() {
  while (true) {
    try {
      io.run();
      return;
    } catch (const std::exception& exception) {
      log_failure("a connection", exception);
    }
  }
}

void Transport::State::await_signal() {
  signals.async_wait([this](const error_code& code, int number) {
    if (code) return;
    if (share->ending) return io.stop();
    end.signal = number;
    await_signal();
    finish();
  });
}

/// Also where a connection is just being destroyed. Where that cannot be posted the shutdown ends it.
void Transport::State::look_whether_done() {
  try {
    asio::post(io, [this] {
      if (is_done()) io.stop();
    });
  } catch (const std::exception& exception) {
    log_failure("the end", exception);
  }
}

void Transport::State::finish() {
  share->ending = true;
  error_code ignored;
  acceptor.close(ignored);
  pause.cancel();
  shutdown.expires_after(options.limits.shutdown);
  shutdown.async_wait([this](const error_code& code) {
    if (!code) io.stop();
  });
  share->when_none = dispatcher->when_idle = [this] { look_whether_done(); };
  if (share->connections.empty()) share->when_none();
  const std::vector<Guest*> all(share->connections.begin(), share->connections.end());
  for (Guest* connection : all)
    if (share->connections.contains(connection)) connection->hang_up();
}

Transport::Transport(std::unique_ptr<State> state) : state_(std::move(state)) {}
Transport::~Transport() = default;

Result<std::unique_ptr<Transport>> Transport::listen(const TransportOptions& options) {
  AXIOMETRY_TRY(auto address, parse_address(options.listen));
  auto state = std::make_unique<State>(options, std::move(address));
  if (!options.certificate.empty()) {
    AXIOMETRY_TRY(state->tls, tls_context(options));
  }
  AXIOMETRY_TRY_VOID(state->bind());
  return std::unique_ptr<Transport>(new Transport(std::move(state)));
}

unsigned Transport::port() const { return state_->acceptor.local_endpoint().port(); }

Transport::End Transport::run(const Service& service, const std::function<void()>& ready) {
  allow_descriptors(state_->options.limits.connections + 256);
  const Limits& limits = state_->options.limits;
  state_->queues = std::make_unique<RequestQueues>(queues_for(limits));
  state_->dispatcher = std::make_unique<Dispatcher>(state_->io, service, limits, *state_->queues);
  state_->share = std::make_unique<ConnectionShare>(limits, service, *state_->dispatcher, state_->io);
  state_->signals.add(SIGINT);
  state_->signals.add(SIGTERM);
  state_->await_signal();
  state_->accept();
  ready();
  state_->work();
  state_->share->when_none = {};
  state_->dispatcher->when_idle = {};
  state_->end.all_answered = state_->is_done();
  return state_->end;
}

Result<bool> is_loopback(const std::string& text) {
  AXIOMETRY_TRY(const auto address, parse_address(text));
  return address.is_loopback();
}

}  // namespace axiometry::server
