// SPDX-License-Identifier: Apache-2.0
#include "server/http/connection.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/executor_work_guard.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <latch>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace axiometry::server {
namespace {

using boost::asio::ip::tcp;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

constexpr WorkerPool::Options two_workers{.threads = 2, .waiting_max = 10};

/// A server's connections, whose answers are by path what `answers` says; what is posted may be kept.
struct Counter {
  Service service;
  Limits limits;
  std::map<std::string, Response> answers;
  std::vector<int> told;                   // statuses of what was answered
  std::unique_ptr<ConnectionShare> share;  // outlives the connections, which the context ends with
  boost::asio::io_context io{1};
  boost::asio::executor_work_guard<boost::asio::io_context::executor_type> open{io.get_executor()};
  tcp::acceptor acceptor{io, tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0)};
  std::unique_ptr<Dispatcher> dispatcher;
  std::unique_ptr<RequestQueues> queues;

  Counter() {
    service.refused = [](const Request&) { return std::nullopt; };
    service.queue_of = [](const Request&) { return Load::light; };
    service.keeps = [](const Request& request) { return request.method == "POST"; };
    service.read = [this](const std::shared_ptr<Request>& request) {
      return Job{.answer = [answer = answers.at(request->path)](const auto&) { return answer; }};
    };
    service.finish = [](Response&) {};
    service.answered = [this](const Service::Answered& answered) { told.push_back(answered.status); };
    queues = std::make_unique<RequestQueues>(
        RequestQueues::Options{.light = two_workers, .edits = two_workers, .heavy = two_workers});
    dispatcher = std::make_unique<Dispatcher>(io, service, limits, *queues);
    share = std::make_unique<ConnectionShare>(limits, service, *dispatcher, io);
  }

  void run_for(int milliseconds) { io.run_for(std::chrono::milliseconds(milliseconds)); }

  /// As when the server is to end.
  void hang_up() {
    share->ending = true;
    const std::vector<Guest*> all(share->connections.begin(), share->connections.end());
    for (Guest* one : all) one->hang_up();
  }

  tcp::socket connected() {
    tcp::socket client(io);
    client.open(tcp::v4());
    client.set_option(tcp::socket::receive_buffer_size(4096));
    client.connect(acceptor.local_endpoint());
    return client;
  }
  /// One that has sent its request and reads nothing.
  tcp::socket client(const std::string& head, const std::string& peer = "a") {
    tcp::socket client = connected();
    serve(acceptor.accept(), nullptr, peer, *share);
    boost::asio::write(client, boost::asio::buffer(head + " HTTP/1.1\r\nHost: localhost\r\n\r\n"));
    return client;
  }
  /// What it has come to after the time that this takes; an answer may come in pieces.
  std::string read(tcp::socket& client) {
    std::string text;
    for (int k = 0; k < 500 && !text.contains("\r\n\r\n") && client.is_open(); ++k) {
      run_for(10);
      std::string piece(std::size_t{1} << 16, '\0');
      boost::system::error_code code;
      client.non_blocking(true);
      piece.resize(client.read_some(boost::asio::buffer(piece), code));
      text += piece;
      if (code == boost::asio::error::eof) client.close();
    }
    return text;
  }
};

constexpr std::size_t large = std::size_t{16} << 20;

Response large_answer(int status) { return {.status = status, .body = std::string(large, ' ')}; }

/// Somebody who holds that and says whether it had to go.
struct Holder final : Guest {
  explicit Holder(ConnectionState held) : is(held) {}
  void hang_up() override {}
  void make_room() override { is_gone = true; }
  ConnectionState state() const override { return is; }
  ConnectionState is;
  bool is_gone = false;
};

TEST(Connection, gives_a_receipt_of_what_was_kept_where_the_answer_does_not_fit) {
  Counter counter;
  Holder waits({.peer = "b", .doing = ConnectionState::Doing::waiting, .bytes = large});
  counter.share->connections.insert(&waits);
  counter.limits.held_bytes = large / 2 * 3;
  counter.answers["/withdraw"] = large_answer(200);
  counter.answers["/withdraw"].kept = {.id = 12, .version = 3};
  counter.answers["/edit"] = large_answer(201);
  counter.answers["/edit"].headers = {{"Location", "/api/tests/12"}};
  counter.answers["/report"] = large_answer(200);
  auto first = counter.client("POST /withdraw");
  EXPECT_THAT(counter.read(first), AllOf(StartsWith("HTTP/1.1 200 "),
                                         HasSubstr(R"({"kept":true,"id":12,"version":3,"message":"it was kept)")));
  auto second = counter.client("POST /edit");
  EXPECT_THAT(counter.read(second), AllOf(StartsWith("HTTP/1.1 201 "), HasSubstr("Location: /api/tests/12"),
                                          HasSubstr(R"({"kept":true,"id":null,"version":null,)")));
  auto third = counter.client("GET /report");
  EXPECT_THAT(counter.read(third), StartsWith("HTTP/1.1 503 "));
  EXPECT_EQ(counter.told, (std::vector{200, 201, 503}));
  EXPECT_FALSE(waits.is_gone);
  counter.share->connections.erase(&waits);
}

TEST(Connection, tells_at_once_of_what_concerns_security_though_its_answer_is_held_back) {
  Counter counter;
  std::vector<std::pair<SecurityEvent, std::string>> events;
  counter.service.secured = [&](const Request& request, const Response& response) {
    events.emplace_back(response.event, request.peer + " " + request.path + " " + std::to_string(response.status));
  };
  counter.limits.held_bytes = large - 1;
  counter.answers["/guess"] = {.status = 401, .delay = std::chrono::hours(1), .event = SecurityEvent::token_refused};
  counter.answers["/large"] = large_answer(200);
  counter.answers["/small"] = {.status = 204};
  auto guesser = counter.client("GET /guess");
  while (events.empty()) counter.run_for(10);
  auto large_one = counter.client("GET /large", "b");
  EXPECT_THAT(counter.read(large_one), StartsWith("HTTP/1.1 503 "));
  auto small = counter.client("GET /small", "b");
  EXPECT_THAT(counter.read(small), StartsWith("HTTP/1.1 204 "));
  EXPECT_THAT(events, testing::ElementsAre(std::pair(SecurityEvent::token_refused, "a /guess 401"),
                                           std::pair(SecurityEvent::quota_refused, "b /large 503")));
}

TEST(Connection, gives_no_answer_of_any_kind_that_does_not_fit) {
  Counter counter;
  counter.limits.held_bytes = large - 1;
  counter.answers["/made"] = large_answer(201);
  auto client = counter.client("GET /made");
  EXPECT_THAT(counter.read(client), StartsWith("HTTP/1.1 503 "));
}

TEST(Connection, tells_of_no_answer_that_cannot_be_given) {
  Counter counter;
  counter.answers["/fault"] = {.status = 1000};  // no status of HTTP: nothing can be made of it
  counter.answers["/after"] = {.status = 204};
  auto client = counter.client("GET /fault");
  EXPECT_EQ(counter.read(client), "");
  auto next = counter.client("GET /after");
  EXPECT_THAT(counter.read(next), StartsWith("HTTP/1.1 204 "));
  EXPECT_EQ(counter.told, std::vector{204});
}

const Response held_back{.status = 401, .delay = std::chrono::hours(1), .event = SecurityEvent::token_refused};

TEST(Connection, ends_with_the_server_where_its_answer_is_only_held_back) {
  Counter counter;
  bool has_guessed = false;
  counter.service.secured = [&](const auto&, const auto&) { has_guessed = true; };
  counter.answers["/guess"] = held_back;
  auto guesser = counter.client("GET /guess");
  while (!has_guessed) counter.run_for(10);
  EXPECT_EQ(counter.share->connections.size(), 1U);
  counter.hang_up();
  EXPECT_TRUE(counter.share->connections.empty());
  counter.run_for(10);
  EXPECT_TRUE(counter.told.empty());
}

TEST(Connection, holds_no_answer_back_once_the_server_is_to_end) {
  std::latch begun(1);
  std::latch go_on(1);
  Counter counter;
  counter.service.read = [&](const auto&) {
    return Job{.answer = [&](const auto&) {
      begun.count_down();
      go_on.wait();
      return held_back;
    }};
  };
  auto guesser = counter.client("GET /guess");
  while (!begun.try_wait()) counter.run_for(10);
  counter.hang_up();
  EXPECT_EQ(counter.share->connections.size(), 1U) << "its request is in flight";
  go_on.count_down();
  for (int k = 0; k < 500 && !counter.share->connections.empty(); ++k) counter.run_for(10);
  EXPECT_TRUE(counter.share->connections.empty());
}

TEST(Connection, ends_with_the_server_where_it_has_not_begun_to_speak_TLS) {
  Counter counter;
  boost::asio::ssl::context context(boost::asio::ssl::context::tls_server);
  auto silent = counter.connected();
  serve(counter.acceptor.accept(), &context, "a", *counter.share);
  auto stops = counter.connected();
  serve(counter.acceptor.accept(), &context, "a", *counter.share);
  boost::asio::write(stops, boost::asio::buffer("\x16\x03\x01", 3));
  counter.run_for(50);
  EXPECT_EQ(counter.share->connections.size(), 2U);
  counter.hang_up();
  EXPECT_TRUE(counter.share->connections.empty());
  counter.run_for(50);
}

TEST(Connection, gives_way_only_where_that_makes_room) {
  Counter counter;
  counter.limits.held_bytes = 800;
  Holder still({.peer = "a", .doing = ConnectionState::Doing::sending, .bytes = 100});
  Holder waits({.peer = "b", .doing = ConnectionState::Doing::waiting, .bytes = 600});
  Holder asks({.peer = "c", .doing = ConnectionState::Doing::sending});
  counter.share->connections = {&still, &waits, &asks};
  EXPECT_FALSE(counter.share->make_memory(asks, 300));
  EXPECT_FALSE(still.is_gone);
  EXPECT_TRUE(counter.share->make_memory(asks, 200));
  EXPECT_TRUE(still.is_gone);
  EXPECT_FALSE(waits.is_gone);
  counter.share->connections.clear();
}

TEST(Connection, that_sends_a_small_body_has_a_share_of_its_own_and_no_more) {
  Counter counter;
  counter.limits.held_bytes = 80 * small_body;
  std::vector<std::unique_ptr<Holder>> all;
  for (int k = 0; k < 60; ++k)
    counter.share->connections.insert(
        all
            .emplace_back(std::make_unique<Holder>(ConnectionState{
                .peer = k < 30 ? "a" : "b", .doing = ConnectionState::Doing::waiting, .bytes = small_body}))
            .get());
  Holder asks({.peer = "c", .doing = ConnectionState::Doing::receiving});
  counter.share->connections.insert(&asks);
  EXPECT_FALSE(counter.share->make_memory(asks, small_body));
  counter.share->connections.clear();
}

}  // namespace
}  // namespace axiometry::server
