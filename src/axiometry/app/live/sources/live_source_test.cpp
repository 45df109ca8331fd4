// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/sources/live_source.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <pty.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace axiometry::app {
namespace {

TEST(LiveAddress, IsReadFromTheNameOfTheSource) {
  EXPECT_FALSE(*parse_live("run.csv"));
  EXPECT_FALSE(*parse_live("-"));
  const auto tcp = parse_live("tcp://laser.local:5000");
  EXPECT_EQ((*tcp)->host, "laser.local");
  EXPECT_EQ((*tcp)->port, "5000");
  EXPECT_EQ((*parse_live("tcp://[::1]:5000"))->host, "::1");
  const auto serial = parse_live("serial:///dev/ttyACM0?baud=2000000");
  EXPECT_EQ((*serial)->host, "/dev/ttyACM0");
  EXPECT_EQ((*serial)->baud, 2'000'000u);
  EXPECT_EQ((*parse_live("serial:///dev/ttyUSB1"))->baud, 115'200u);
  for (const char* bad : {"tcp://", "tcp://host", "tcp://:5", "tcp://host:", "serial://",
                          "serial:///dev/x?baud=", "serial:///dev/x?baud=-1", "serial:///dev/x?speed=9600",
                          "serial:///dev/x?baud=1e6", "serial:///dev/x?ask=laser", "serial:///dev/x?baud=9600&ask="})
    EXPECT_FALSE(parse_live(bad)) << bad;
}

TEST(LiveAddress, NothingIsSentToAnInstrumentUnlessTheSourceSaysSo) {
  EXPECT_EQ((*parse_live("serial:///dev/x?baud=3000000"))->request, "");
  const auto asking = parse_live("serial:///dev/x?baud=3000000&ask=hpi-3d");
  EXPECT_EQ((*asking)->baud, 3'000'000u);
  EXPECT_EQ((*asking)->request.size(), 16u);
}

std::string text_of(LiveStream& connection, std::size_t size) {
  std::string text;
  std::array<char, 16> buffer{};
  for (int k = 0; k < 100 && text.size() < size; ++k) {
    const auto got = connection.read(buffer, std::chrono::milliseconds(100));
    if (got.state == LiveStream::State::closed) break;
    text.append(buffer.data(), got.count);
  }
  return text;
}

TEST(LiveConnection, ReadsASerialPortByteForByteAtAnyBaudRate) {
  int master = -1, slave = -1;
  std::array<char, 256> name{};
  ASSERT_EQ(::openpty(&master, &slave, name.data(), nullptr, nullptr), 0);
  for (unsigned baud : {9600u, 2'000'000u, 1'234'567u}) {
    auto connection = connect_to({LiveAddress::Kind::serial, name.data(), "", baud});
    ASSERT_TRUE(connection) << connection.error().to_string();
    // None of these may be translated, echoed or taken for a command of the terminal.
    const std::string bytes("0 0 1\r\n\x03\x04\x11\x13\x1A\0\xFF end", 17);
    ASSERT_EQ(::write(master, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    EXPECT_EQ(text_of(**connection, bytes.size()), bytes);
  }
  ::close(slave);
  ::close(master);
}

TEST(LiveConnection, AsksAnInstrumentAtASerialPort) {
  int master = -1, slave = -1;
  std::array<char, 256> name{};
  ASSERT_EQ(::openpty(&master, &slave, name.data(), nullptr, nullptr), 0);
  const auto address = parse_live(std::string("serial://") + name.data() + "?baud=3000000&ask=hpi-3d");
  const auto connection = connect_to(**address);
  ASSERT_TRUE(connection) << connection.error().to_string();
  std::array<char, 64> heard{};
  EXPECT_EQ(::read(master, heard.data(), heard.size()), 16);
  EXPECT_EQ(std::string(heard.data(), 16), (*address)->request);
  ::close(slave);
  ::close(master);
}

TEST(LiveConnection, SaysWhyItCannotConnectAndWhenTheOtherSideCloses) {
  EXPECT_FALSE(connect_to({LiveAddress::Kind::serial, "/dev/none", "", 9600}));
  EXPECT_FALSE(connect_to({LiveAddress::Kind::serial, "/dev/null", "", 9600}));
  const int server = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(server, reinterpret_cast<sockaddr*>(&address), size), 0);
  ASSERT_EQ(::getsockname(server, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const LiveAddress to{LiveAddress::Kind::tcp, "127.0.0.1", std::to_string(ntohs(address.sin_port))};
  EXPECT_EQ(connect_to(to).error().message, "cannot connect: Connection refused");
  ASSERT_EQ(::listen(server, 1), 0);
  auto connection = connect_to(to);
  ASSERT_TRUE(connection);
  const int peer = ::accept(server, nullptr, nullptr);
  ASSERT_EQ(::write(peer, "abc", 3), 3);
  ::close(peer);
  EXPECT_EQ(text_of(**connection, 4), "abc");
  std::array<char, 4> buffer{};
  EXPECT_EQ((*connection)->read(buffer, std::chrono::milliseconds(100)).state, LiveStream::State::closed);
  ::close(server);
}

}  // namespace
}  // namespace axiometry::app
