// SPDX-License-Identifier: Apache-2.0
#include "server/http/post.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/asio/connect.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/beast/core/error.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/read.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/http/write.hpp>
#include <chrono>
#include <exception>
#include <optional>
#include <string_view>

#include "axiometry/base/text/text.h"
#include "axiometry/base/version.h"
#include "server/http/byte_stream.h"

namespace axiometry::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
namespace ssl = asio::ssl;
using boost::system::error_code;
using Clock = std::chrono::steady_clock;

struct Address {
  bool secure = false;
  std::string authority{};  // host and port as they were written
  std::string host{}, port{}, path{};
};

/// "host", "host:80" or "[::1]:80".
bool read_authority(std::string_view text, Address& address) {
  const std::size_t bracket = text.starts_with('[') ? text.find(']') : 0;
  if (bracket == text.npos || text.find_first_of(" \r\n\t@") != text.npos) return false;
  const std::size_t colon = text.find(':', bracket);
  address.host = bracket == 0 ? text.substr(0, colon) : text.substr(1, bracket - 1);
  if (colon != text.npos) address.port = text.substr(colon + 1);
  return !address.host.empty() && !address.port.empty();
}

Result<Address> address_of(std::string_view url) {
  constexpr std::string_view plain = "http://", secure = "https://";
  Address address{.secure = url.starts_with(secure)};
  address.port = address.secure ? "443" : "80";
  const std::string_view rest = url.substr(std::min(url.size(), (address.secure ? secure : plain).size()));
  const std::size_t end = std::min(rest.find_first_of("/?#"), rest.size());
  address.authority = rest.substr(0, end);
  const std::string_view path = rest.substr(end, rest.find('#') == rest.npos ? rest.npos : rest.find('#') - end);
  address.path = (path.starts_with('/') ? "" : "/") + std::string(path);
  const bool is_sound = (address.secure || url.starts_with(plain)) && read_authority(address.authority, address) &&
                        path.find_first_of(" \r\n\t") == path.npos;
  if (!is_sound)
    return fail(fmt::format("found the address {}, expected one such as http://host/path or https://host:8443/path",
                            text::quoted(url)));
  return address;
}

using Message = http::response<http::string_body>;

/// One step after another, all before the same moment. A step that fails or is late throws system_error.
class Steps {
 public:
  explicit Steps(Clock::time_point until) : until_(until) {}

  asio::io_context& io() { return io_; }

  /// Begins a step, which is given what is to be called at its end.
  template <typename Step>
  void take(const Step& step) {
    std::optional<error_code> ended;
    step([&ended](error_code code, const auto&...) { ended = code; });
    io_.restart();
    io_.run_until(until_);
    if (!ended) throw boost::system::system_error(beast::error::timeout);  // the handler was never called
    if (*ended) throw boost::system::system_error(*ended);
  }

 private:
  Clock::time_point until_;
  asio::io_context io_;
};

Message exchange(Steps& steps, ByteStream& stream, const Address& address, const Post& post) {
  http::request<http::string_body> request{http::verb::post, address.path, 11};
  request.set(http::field::host, address.authority);
  request.set(http::field::user_agent, fmt::format("axiometry/{}", version));
  request.set(http::field::content_type, post.type);
  request.set(http::field::accept, post.answer_type);
  request.set(http::field::connection, "close");
  request.body() = post.body;
  request.prepare_payload();
  steps.take([&](auto done) { http::async_write(stream, request, std::move(done)); });
  http::response_parser<http::string_body> parser;
  parser.body_limit(post.most);
  beast::flat_buffer buffer;
  steps.take([&](auto done) { http::async_read_header(stream, buffer, parser, std::move(done)); });
  // Beast of Boost 1.74 does not hold an announced length against its limit every time.
  const auto length = parser.content_length();
  if (length && *length > post.most) throw boost::system::system_error(http::error::body_limit);
  steps.take([&](auto done) { http::async_read(stream, buffer, parser, std::move(done)); });
  return parser.release();
}

Message ask(const Address& address, const Post& post) {
  Steps steps(Clock::now() + post.longest);
  asio::ip::tcp::resolver resolver(steps.io());
  asio::ip::tcp::resolver::results_type found;
  steps.take([&](auto done) {
    resolver.async_resolve(address.host, address.port, [&found, done](error_code code, const auto& places) {
      found = places;
      done(code);
    });
  });
  std::optional<ssl::context> context;
  if (address.secure) {
    context.emplace(ssl::context::tls_client);
    context->set_default_verify_paths();
    context->set_verify_mode(ssl::verify_peer);
  }
  ByteStream stream(asio::ip::tcp::socket(steps.io()), context ? &*context : nullptr);
  steps.take([&](auto done) { asio::async_connect(stream.socket(), found, std::move(done)); });
  if (address.secure) steps.take([&](auto done) { stream.greet_server(address.host, std::move(done)); });
  return exchange(steps, stream, address, post);
}

}  // namespace

Result<std::string> post(const Post& post) {
  AXIOMETRY_TRY(const Address address, address_of(post.url));
  std::optional<Message> answer;
  std::string reason;
  try {
    answer = ask(address, post);
  } catch (const boost::system::system_error& error) {
    const bool late = error.code() == beast::error::timeout;
    reason = late ? fmt::format("it took longer than {} s", post.longest.count()) : error.code().message();
  } catch (const std::exception& error) {
    reason = error.what();
  }
  if (!answer) return fail(fmt::format("no answer from {}: {}", post.url, reason));
  if (answer->result() != http::status::ok)
    return fail(fmt::format("found status {} from {}, expected 200", answer->result_int(), post.url));
  const auto field = (*answer)[http::field::content_type];
  const std::string_view type(field.data(), field.size());
  if (text::to_lower(text::trim(type.substr(0, type.find(';')))) != post.answer_type)
    return fail(fmt::format("found {} from {}, expected {}", text::quoted(type), post.url, post.answer_type));
  return std::move(answer->body());
}

}  // namespace axiometry::server
