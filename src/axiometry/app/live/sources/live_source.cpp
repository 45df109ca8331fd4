// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/sources/live_source.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <netdb.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>
#include <utility>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/recordings/hpi_frames.h"

namespace axiometry::app {
namespace {

constexpr int connect_ms = 5000;
constexpr auto silence_to_ask_again = std::chrono::seconds(5);

std::unexpected<Error> fail_at(const LiveAddress& address, const std::string& reason) {
  const bool tcp = address.kind == LiveAddress::Kind::tcp;
  return std::unexpected(Error{fmt::format("cannot connect: {}", reason),
                               tcp ? fmt::format("tcp://{}:{}", address.host, address.port) : address.host,
                               {}});
}

/// Connects without waiting longer than connect_ms; 0 or the error.
int connect_in_time(int descriptor, const addrinfo& to) {
  if (::connect(descriptor, to.ai_addr, to.ai_addrlen) == 0) return 0;
  if (errno != EINPROGRESS) return errno;
  pollfd wait{descriptor, POLLOUT, 0};
  const int ready = ::poll(&wait, 1, connect_ms);
  if (ready == 0) return ETIMEDOUT;
  if (ready < 0) return errno;
  int error = 0;
  socklen_t size = sizeof error;
  return ::getsockopt(descriptor, SOL_SOCKET, SO_ERROR, &error, &size) == 0 ? error : errno;
}

Result<int> connect_tcp(const LiveAddress& address) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* list = nullptr;
  if (const int code = ::getaddrinfo(address.host.c_str(), address.port.c_str(), &hints, &list); code != 0)
    return fail_at(address, ::gai_strerror(code));
  const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owner(list, ::freeaddrinfo);
  int error = EADDRNOTAVAIL;
  for (const addrinfo* to = list; to != nullptr; to = to->ai_next) {
    const int descriptor = ::socket(to->ai_family, to->ai_socktype | SOCK_CLOEXEC | SOCK_NONBLOCK, to->ai_protocol);
    if (descriptor < 0) continue;
    error = connect_in_time(descriptor, *to);
    if (error == 0) {
      const int on = 1;  // a cable that was pulled is noticed
      ::setsockopt(descriptor, SOL_SOCKET, SO_KEEPALIVE, &on, sizeof on);
      return descriptor;
    }
    ::close(descriptor);
  }
  return fail_at(address, std::strerror(error));
}

Result<std::optional<LiveAddress>> parse_tcp(const std::string& name, std::string_view rest) {
  const std::size_t colon = rest.rfind(':');
  if (colon == rest.npos || colon == 0 || colon + 1 == rest.size())
    return fail(fmt::format("found the source {}, expected tcp://host:port", text::quoted(name)));
  std::string_view host = rest.substr(0, colon);
  if (host.starts_with('[') && host.ends_with(']')) host = host.substr(1, host.size() - 2);  // IPv6
  const std::string_view port = rest.substr(colon + 1);
  constexpr std::size_t port_most = 65535;
  if (const auto number = parse_count(port); !number || *number < 1 || *number > port_most)
    return fail(
        fmt::format("found the port {} in {}, expected 1 to {}", text::quoted(port), text::quoted(name), port_most));
  return LiveAddress{LiveAddress::Kind::tcp, std::string(host), std::string(port)};
}

Result<void> take_option(LiveAddress& address, std::string_view option) {
  constexpr std::string_view baud_rate = "baud=", ask = "ask=";
  if (option.starts_with(ask)) {
    const std::string_view instrument = option.substr(ask.size());
    if (instrument != "hpi-3d")
      return fail(
          fmt::format("found the instrument {} to ask in the source, expected hpi-3d", text::quoted(instrument)));
    address.request = formats::hpi::commands_to_begin();
    return {};
  }
  const auto baud = option.starts_with(baud_rate) ? parse_count(option.substr(baud_rate.size())) : std::nullopt;
  if (!baud || *baud < 50 || *baud > 20'000'000)
    return fail(fmt::format("found {} in the source, expected baud= and a rate from 50 to 20000000, or ask=hpi-3d",
                            text::quoted(option)));
  address.baud = static_cast<unsigned>(*baud);
  return {};
}

Result<std::optional<LiveAddress>> parse_serial(const std::string& name, std::string_view rest) {
  LiveAddress address{LiveAddress::Kind::serial, std::string(rest.substr(0, rest.find('?'))), ""};
  if (address.host.empty())
    return fail(fmt::format("found the source {}, expected serial:///dev/ttyACM0?baud=2000000", text::quoted(name)));
  const std::size_t query = rest.find('?');
  if (query == rest.npos) return address;
  for (const std::string_view option : text::split(rest.substr(query + 1), '&'))
    AXIOMETRY_TRY_VOID(take_option(address, option));
  return address;
}

/// One connection; it ends when the other side closes it.
class Connection final : public LiveStream {
 public:
  Connection(int descriptor, std::string request) : descriptor_(descriptor), request_(std::move(request)) { ask(); }
  ~Connection() override { ::close(descriptor_); }

  Got read(std::span<char> buffer, std::chrono::milliseconds longest) override {
    pollfd wait{descriptor_, POLLIN, 0};
    const int ready = ::poll(&wait, 1, static_cast<int>(longest.count()));
    if (ready <= 0) {
      if (!request_.empty() && Clock::now() - heard_ >= silence_to_ask_again) ask();
      return {};
    }
    const ssize_t got = ::read(descriptor_, buffer.data(), buffer.size());
    if (got > 0) heard_ = Clock::now();
    if (got > 0) return {State::data, static_cast<std::size_t>(got)};
    if (got < 0 && (errno == EAGAIN || errno == EINTR)) return {};
    return {State::closed, 0, got == 0 ? "closed by the other side" : std::strerror(errno)};
  }

 private:
  using Clock = std::chrono::steady_clock;

  /// Whether it arrives is told by what comes back: a port that takes nothing now is asked again.
  void ask() {
    heard_ = Clock::now();
    if (!request_.empty()) static_cast<void>(!::write(descriptor_, request_.data(), request_.size()));
  }

  int descriptor_;
  std::string request_;
  Clock::time_point heard_;  // a byte, or the last time it was asked
};

}  // namespace

Result<std::optional<LiveAddress>> parse_live(const std::string& name) {
  constexpr std::string_view tcp = "tcp://", serial = "serial://", simulator = "simulator://";
  if (name.starts_with(tcp)) return parse_tcp(name, std::string_view(name).substr(tcp.size()));
  if (name.starts_with(serial)) return parse_serial(name, std::string_view(name).substr(serial.size()));
  if (!name.starts_with(simulator)) return std::optional<LiveAddress>();
  const std::string_view told = std::string_view(name).substr(simulator.size());
  if (!told.empty() && !told.starts_with('?'))
    return fail(fmt::format("found the source {}, expected simulator://?seed=7", text::quoted(name)));
  return LiveAddress{LiveAddress::Kind::simulator, std::string(told.substr(told.empty() ? 0 : 1)), ""};
}

Result<std::unique_ptr<LiveStream>> connect_to(const LiveAddress& address) {
  AXIOMETRY_TRY(const int descriptor, address.kind == LiveAddress::Kind::tcp ? connect_tcp(address)
                                                                             : open_serial(address.host, address.baud));
  return std::make_unique<Connection>(descriptor, address.request);
}

}  // namespace axiometry::app
