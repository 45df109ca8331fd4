// SPDX-License-Identifier: Apache-2.0
#include "server/http/client_hello.h"

#include <gtest/gtest.h>

#include <boost/asio/io_context.hpp>
#include <boost/asio/write.hpp>
#include <string>

namespace axiometry::server {
namespace {

using boost::asio::ip::tcp;

std::string big_endian(std::size_t number, int bytes) {
  std::string text;
  for (int k = bytes - 1; k >= 0; --k) text += static_cast<char>(number >> (8 * k));
  return text;
}

std::string record_of(const std::string& payload) { return "\x16\x03\x01" + big_endian(payload.size(), 2) + payload; }

std::string hello_of(std::size_t bytes) { return "\x01" + big_endian(bytes, 3) + std::string(bytes, 'h'); }

TEST(ClientHello, is_wanted_whole) {
  const std::string whole = record_of(hello_of(300));
  EXPECT_EQ(client_hello_wanted(""), 5U);
  for (std::size_t come = 1; come < 5; ++come) EXPECT_EQ(client_hello_wanted(whole.substr(0, come)), 5U) << come;
  for (std::size_t come = 5; come <= whole.size(); ++come)
    EXPECT_EQ(client_hello_wanted(whole.substr(0, come)), whole.size()) << come;
  EXPECT_EQ(client_hello_wanted(whole + "sent ahead"), whole.size());
}

TEST(ClientHello, is_wanted_whole_in_however_many_records) {
  const std::string hello = hello_of(300);
  std::string come;
  for (std::size_t from = 0; from < hello.size(); from += 2) {
    EXPECT_GT(client_hello_wanted(come), come.size());
    come += record_of(hello.substr(from, 2));
  }
  EXPECT_EQ(client_hello_wanted(come), come.size());
}

TEST(ClientHello, is_none_where_it_is_no_hello_or_a_longer_one) {
  for (const std::string& come :
       {std::string("GET / HTTP/1.1\r\n"), std::string("\x15\x03\x01\x00\x02\x01\x00", 7),
        record_of(std::string("\x02\x00\x00\x01h", 5)), record_of(""), std::string("\x16\x03\x01\xff\xff", 5)})
    EXPECT_EQ(client_hello_wanted(come), std::nullopt);
}

/// A client and what the server has of it.
struct Line {
  boost::asio::io_context io{1};
  tcp::socket client{io};
  tcp::socket socket{io};
  std::optional<bool> has_come;

  Line() {
    tcp::acceptor acceptor(io, tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0));
    client.connect(acceptor.local_endpoint());
    acceptor.accept(socket);
    await_client_hello(socket, [this](bool come) { has_come = come; });
  }
  std::size_t run_for(int milliseconds) { return io.run_for(std::chrono::milliseconds(milliseconds)); }
};

TEST(ClientHello, is_waited_for_without_asking_all_the_time) {
  Line line;
  const std::string whole = record_of(hello_of(300));
  for (const std::size_t from : {0, 1, 100}) {
    boost::asio::write(line.client, boost::asio::buffer(whole.substr(from, 1)));
    EXPECT_LT(line.run_for(100), 20U);
    EXPECT_EQ(line.has_come, std::nullopt);
    if (from == 1) boost::asio::write(line.client, boost::asio::buffer(whole.substr(2, 98)));
  }
  boost::asio::write(line.client, boost::asio::buffer(whole.substr(101)));
  line.run_for(10'000);
  EXPECT_EQ(line.has_come, true);
  EXPECT_EQ(line.socket.available(), whole.size()) << "nothing of it was read";
}

TEST(ClientHello, is_not_waited_for_of_who_has_left) {
  Line line;
  boost::asio::write(line.client, boost::asio::buffer("\x16", 1));
  line.run_for(50);
  EXPECT_EQ(line.has_come, std::nullopt);
  line.client.close();
  line.run_for(10'000);
  EXPECT_EQ(line.has_come, false);
}

}  // namespace
}  // namespace axiometry::server
