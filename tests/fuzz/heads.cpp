// SPDX-License-Identifier: Apache-2.0
//
// Any bytes as what a client sends first: the head of a request, its target, its fields, and whether it is let in.
#include <boost/asio/buffer.hpp>
#include <boost/beast/http/empty_body.hpp>
#include <boost/beast/http/parser.hpp>

#include "described.h"
#include "server/access/guard.h"
#include "server/http/request_head.h"
#include "server/http/target.h"

using namespace axiometry;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  namespace http = boost::beast::http;
  const std::string_view bytes = fuzzing::as_text(data, size);
  http::request_parser<http::empty_body> parser;
  parser.header_limit(16 << 10);
  parser.skip(true);
  boost::beast::error_code code;
  parser.put(boost::asio::buffer(bytes.data(), bytes.size()), code);
  if (code && code != http::error::need_more) {
    AXIOMETRY_CONTRACT(server::refusal_of(code).status >= 400);
  } else if (parser.is_header_done()) {
    const auto head = server::read_head(parser.get().base(), "127.0.0.1");
    if (!head)
      AXIOMETRY_CONTRACT(head.error().status >= 400 && head.error().status < 600);
    else
      AXIOMETRY_CONTRACT(head->request.path.starts_with('/'));
  }
  const auto [first, rest] = fuzzing::parted(bytes);
  if (const auto target = server::parse_target(first); target) {
    for (const char forbidden : {'\\', '\n', '\0'})
      AXIOMETRY_CONTRACT(target->path.find(forbidden) == std::string::npos);
    AXIOMETRY_CONTRACT(target->path.find("/../") == std::string::npos);
  } else {
    fuzzing::check_error(target.error());
  }
  if (const auto decoded = server::percent_decoded(rest); !decoded) fuzzing::check_error(decoded.error());
  return 0;
}
