// SPDX-License-Identifier: Apache-2.0
#include "server/http/peer.h"

#include <gtest/gtest.h>

namespace axiometry::server {
namespace {

std::string peer(const char* address) { return peer_of(boost::asio::ip::make_address(address)); }

TEST(Peer, of_IPv4_is_its_address_however_it_is_written) {
  EXPECT_EQ(peer("192.0.2.1"), "192.0.2.1");
  EXPECT_EQ(peer("::ffff:192.0.2.1"), "192.0.2.1");
  EXPECT_EQ(peer("127.0.0.1"), "127.0.0.1");
}

TEST(Peer, of_IPv6_is_its_network) {
  EXPECT_EQ(peer("2001:db8:0:7:1:2:3:4"), "2001:db8:0:7::/64");
  EXPECT_EQ(peer("2001:db8:0:7:ffff::1"), peer("2001:db8:0:7::2"));
  EXPECT_NE(peer("2001:db8:0:8::1"), peer("2001:db8:0:7::1"));
  EXPECT_EQ(peer("::1"), "::1");
}

}  // namespace
}  // namespace axiometry::server
