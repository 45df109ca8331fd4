// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/live/service/capture_service.h"

#include <gmock/gmock.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <latch>
#include <mutex>
#include <thread>

#include "axiometry/app/files/whole_file.h"
#include "axiometry/app/live/service/piece_server_test_support.h"
#include "tests/support/simulated_recording.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing_support::PieceServer;
using testing_support::recording;
using testing_support::short_plan;
using Stage = CaptureState::Stage;
using namespace std::chrono_literals;

/// Takes what captures come to, as an archive would.
struct Archive {
  std::vector<std::string> raw;
  std::vector<std::optional<Test>> tests;
  std::string refuses;  ///< with this reason

  CaptureKeeping keeping() {
    return {.keep = [this](const CapturedEnd& end) -> Result<std::optional<store::Id>> {
              if (!refuses.empty()) return fail(ErrorKind::full, refuses);
              raw.push_back(whole_file(end.held.raw()).value_or(""));
              tests.push_back(end.test);
              if (!end.test) return std::optional<store::Id>();
              return std::optional(static_cast<store::Id>(tests.size()));
            },
            .kept = [](const HeldCapture&) -> Result<std::optional<store::Id>> { return std::nullopt; },
            .evaluate = [](const CaptureOrder&, const Test&) -> Result<Outcome> { return fail("not asked for"); }};
  }
};

class CaptureServiceTest : public testing::Test {
 protected:
  std::unique_ptr<CaptureService> open(std::vector<CaptureSource> sources = {}) {
    CaptureSettings settings{.folder = folder_, .sources = std::move(sources)};
    auto service = CaptureService::open(std::move(settings), archive_.keeping());
    EXPECT_TRUE(service);
    return *std::move(service);
  }

  static CaptureWish wish(const std::string& source, std::vector<std::pair<std::string, std::string>> options = {}) {
    return {
        .plan = 4, .whole = short_plan(), .source = source, .layout = {}, .options = std::move(options), .actor = "me"};
  }

  /// One of four runs, which goes on for seconds after its first readings even when it is played ten times as fast.
  static CaptureWish long_wish() {
    CaptureWish wanted = wish("simulator", {{"speed", "10"}, {"seed", "9"}});
    wanted.whole = short_plan(4);
    return wanted;
  }

  /// As soon as it is so, or after a minute.
  static CaptureState wait_until(CaptureService& service, store::Id id,
                                 const std::function<bool(const CaptureState&)>& so) {
    for (int k = 0; k < 6000; ++k) {
      if (auto state = service.state(id); !state || so(*state)) return state.value_or(CaptureState());
      std::this_thread::sleep_for(10ms);
    }
    return *service.state(id);
  }
  static bool ended(const CaptureState& state) { return has_ended(state.stage); }

  std::size_t files() const {
    std::size_t count = 0;
    std::error_code none;  // then nothing was ever begun
    for (const auto& entry : std::filesystem::directory_iterator(folder_, none))
      count += entry.path().filename().string().starts_with("capture-") ? 1 : 0;
    return count;
  }

  testing_support::TemporaryFolder temporary_;
  const std::string folder_ = temporary_.file("captures");
  Archive archive_;
};

TEST(CaptureSource, IsNamedOnTheCommandLine) {
  const auto tcp = parse_capture_source("laser-1=tcp://10.0.0.5:5000");
  ASSERT_TRUE(tcp);
  EXPECT_EQ(tcp->id, "laser-1");
  EXPECT_EQ(tcp->address.port, "5000");
  EXPECT_EQ(parse_capture_source("umd=serial:///dev/ttyACM0?baud=2000000")->kind, CaptureSource::Kind::serial);
  for (const char* bad : {"", "tcp://h:1", "=tcp://h:1", "a b=tcp://h:1", "simulator=tcp://h:1", "x=/etc/passwd",
                          "x=tcp://h", "x=file:///etc/passwd", "../x=tcp://h:1"})
    EXPECT_FALSE(parse_capture_source(bad)) << bad;
}

TEST_F(CaptureServiceTest, PlaysTheSimulatorToTheEndAndKeepsWhatItSaid) {
  const auto service = open();
  const auto started = service->start(wish("simulator", {{"speed", "60"}, {"preset", "backlash"}, {"seed", "5"}}));
  ASSERT_TRUE(started) << started.error().to_string();
  EXPECT_EQ(started->stage, Stage::waiting);
  const CaptureState end = wait_until(*service, started->id, ended);
  EXPECT_EQ(end.stage, Stage::complete) << end.error;
  EXPECT_EQ(end.readings.size(), 6u);
  EXPECT_EQ(end.approaches, 6u);
  EXPECT_EQ(end.test, 1);
  ASSERT_EQ(archive_.tests.size(), 1u);
  EXPECT_THAT(archive_.tests[0]->metadata.conditions.comment, HasSubstr("Simulated, not measured"));
  const std::string whole = recording("backlash", 5);
  EXPECT_TRUE(whole.starts_with(archive_.raw[0]));
  EXPECT_GT(archive_.raw[0].size(), whole.size() / 2);
  EXPECT_EQ(files(), 0u);
}

TEST_F(CaptureServiceTest, TellsOnlyWhatIsNewAfterARevision) {
  const auto service = open();
  const auto started = service->start(wish("simulator", {{"speed", "60"}}));
  const CaptureState end = wait_until(*service, started->id, ended);
  ASSERT_EQ(end.readings.size(), 6u);
  EXPECT_TRUE(end.anew);
  const CaptureRevision third = end.readings[2].revision;
  const auto later = service->state(started->id, third);
  EXPECT_FALSE(later->anew);
  EXPECT_EQ(later->readings.size(), static_cast<std::size_t>(std::ranges::count_if(
                                        end.readings, [&](const auto& r) { return r.revision > third; })));
  EXPECT_TRUE(service->state(started->id, end.revision)->readings.empty());
  EXPECT_TRUE(service->state(started->id, end.revision + 100)->anew);  // of another life of the program
  EXPECT_EQ(service->state(99).error().kind, ErrorKind::not_found);
}

TEST_F(CaptureServiceTest, GoesOnWhenTheConnectionBreaksAndComesBack) {
  const std::string whole = recording("good", 3);
  const std::size_t half = whole.find('\n', whole.size() / 2) + 1;
  const PieceServer server({whole.substr(0, half + 5), whole.substr(half + 5)});
  const auto service = open({server.source()});
  const auto started = service->start(wish("laser", {{"give-up", "5"}}));
  ASSERT_TRUE(started) << started.error().to_string();
  const CaptureState end = wait_until(*service, started->id, ended);
  EXPECT_THAT(end.notices, Contains(HasSubstr("connection lost")));
  EXPECT_THAT(end.notices, Contains(HasSubstr("connected again")));
  EXPECT_GE(end.readings.size(), 5u);
  ASSERT_EQ(archive_.raw.size(), 1u);
  EXPECT_TRUE(whole.starts_with(archive_.raw[0]));
  EXPECT_TRUE(end.test);
}

TEST_F(CaptureServiceTest, ASourceThatDoesNotComeBackEndsTheCaptureAndWhatCameIsKept) {
  const std::string whole = recording("good", 3);
  const PieceServer server({whole.substr(0, whole.size() / 2)});
  const auto service = open({server.source()});
  const auto started = service->start(wish("laser", {{"give-up", "0"}}));
  ASSERT_TRUE(started) << started.error().to_string();
  const CaptureState end = wait_until(*service, started->id, ended);
  EXPECT_EQ(end.stage, Stage::stopped);
  EXPECT_TRUE(end.test) << end.error;
  EXPECT_EQ(archive_.raw.at(0), whole.substr(0, whole.size() / 2));
}

TEST_F(CaptureServiceTest, WhatIsNoRecordingIsKeptAsItCame) {
  const PieceServer server({std::string(70'000, 'x') + "\nno numbers\nat all\nin here\n"});
  const auto service = open({server.source()});
  const auto started = service->start(wish("laser", {{"give-up", "0"}}));
  const CaptureState end = wait_until(*service, started->id, ended);
  EXPECT_EQ(end.stage, Stage::failed);
  EXPECT_FALSE(end.error.empty());
  EXPECT_FALSE(end.test);
  ASSERT_EQ(archive_.raw.size(), 1u);
  EXPECT_TRUE(archive_.raw[0].starts_with("xxx"));
}

TEST_F(CaptureServiceTest, IsGoneOnWithWhereTheProgramEnded) {
  store::Id id = 0;
  {
    const auto service = open();
    id = service->start(long_wish())->id;
    wait_until(*service, id, [](const CaptureState& state) { return state.taken >= 2; });
  }
  EXPECT_TRUE(archive_.tests.empty());
  const auto service = open();
  const auto left = service->states();
  ASSERT_EQ(left.size(), 1u);
  EXPECT_EQ(left[0].stage, Stage::interrupted);
  EXPECT_EQ(left[0].id, id);
  EXPECT_EQ(service->state(id)->stage, Stage::interrupted);
  const auto resumed = service->resume(id);
  ASSERT_TRUE(resumed) << resumed.error().to_string();
  EXPECT_EQ(service->resume(id).error().kind, ErrorKind::conflict);
  const CaptureState end = wait_until(*service, id, ended);
  EXPECT_TRUE(end.stage == Stage::complete || end.stage == Stage::stopped) << stage_name(end.stage) << end.error;
  EXPECT_GE(end.readings.size(), 23u);
  ASSERT_EQ(archive_.raw.size(), 1u);
  EXPECT_TRUE(recording("good", 9, 4).starts_with(archive_.raw[0]));
  EXPECT_EQ(files(), 0u);
  EXPECT_EQ(service->resume(id).error().kind, ErrorKind::not_found);
}

TEST_F(CaptureServiceTest, AnInterruptedOneCanBeConcludedWithoutItsSource) {
  const std::string whole = recording("good", 3);
  store::Id id = 0;
  {
    const PieceServer server({whole.substr(0, whole.size() / 2)});
    const auto service = open({server.source()});
    id = service->start(wish("laser", {{"give-up", "100"}}))->id;
    wait_until(*service, id, [](const CaptureState& state) { return !state.notices.empty(); });
  }
  const auto service = open();
  EXPECT_EQ(service->resume(id).error().kind, ErrorKind::not_found);  // the source is not named any more
  const auto end = service->stop(id);
  ASSERT_TRUE(end) << end.error().to_string();
  EXPECT_EQ(end->stage, Stage::stopped);
  EXPECT_TRUE(end->test) << end->error;
  EXPECT_EQ(archive_.raw.at(0), whole.substr(0, whole.size() / 2));
}

/// Its queue of connections is full: who connects hears nothing until it is gone, then a refusal.
class SilentServer {
 public:
  SilentServer() {
    listener_ = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    EXPECT_EQ(::bind(listener_, reinterpret_cast<sockaddr*>(&address), size), 0);
    EXPECT_EQ(::getsockname(listener_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    EXPECT_EQ(::listen(listener_, 0), 0);
    port_ = ntohs(address.sin_port);
    for (int& client : clients_) {
      client = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0);
      static_cast<void>(::connect(client, reinterpret_cast<sockaddr*>(&address), size));
    }
  }
  ~SilentServer() {
    ::close(listener_);
    for (const int client : clients_) ::close(client);
  }
  CaptureSource source() const { return *parse_capture_source("laser=tcp://127.0.0.1:" + std::to_string(port_)); }

 private:
  int listener_ = -1;
  unsigned port_ = 0;
  std::array<int, 4> clients_{};
};

TEST_F(CaptureServiceTest, IsThereWhileItsSourceIsReachedAgain) {
  const std::string whole = recording("good", 3);
  store::Id id = 0;
  {
    const PieceServer server({whole.substr(0, whole.size() / 2)});
    const auto service = open({server.source()});
    id = service->start(wish("laser", {{"give-up", "100"}}))->id;
    wait_until(*service, id, [](const CaptureState& state) { return !state.notices.empty(); });
  }
  std::optional<SilentServer> silent(std::in_place);
  const auto service = open({silent->source()});
  std::atomic<bool> done = false;
  std::jthread resuming([&] {
    EXPECT_FALSE(service->resume(id));
    done = true;
  });
  bool seen = false;
  while (!done) {
    const auto state = service->state(id);
    ASSERT_TRUE(state) << state.error().message;
    ASSERT_EQ(service->states().size(), 1u);
    if (state->stage == Stage::waiting) seen = true;
    if (seen) silent.reset();
    std::this_thread::sleep_for(1ms);
  }
  EXPECT_TRUE(seen);
  EXPECT_EQ(service->state(id)->stage, Stage::interrupted);
}

TEST_F(CaptureServiceTest, WhatTheStoreCannotTakeStaysAndIsKeptLater) {
  archive_.refuses = "the disk is full";
  const auto service = open();
  const store::Id id = service->start(wish("simulator", {{"speed", "60"}}))->id;
  const CaptureState end = wait_until(*service, id, ended);
  EXPECT_EQ(end.stage, Stage::interrupted);
  EXPECT_THAT(end.error, HasSubstr("the disk is full"));
  EXPECT_GE(files(), 3u);
  archive_.refuses.clear();
  const auto kept = service->stop(id);
  ASSERT_TRUE(kept) << kept.error().to_string();
  EXPECT_EQ(kept->stage, Stage::complete);
  EXPECT_EQ(kept->test, 1);
  EXPECT_EQ(files(), 0u);
}

/// Again and again: how soon one asks after the end is a matter of microseconds.
TEST_F(CaptureServiceTest, WhoSeesAnInterruptionMayGoOnAtOnce) {
  archive_.refuses = "the disk is full";
  const auto service = open();
  const store::Id id = service->start(wish("simulator", {{"speed", "60"}}))->id;
  wait_until(*service, id, [](const CaptureState& state) { return state.taken >= 1; });
  for (int k = 0; k < 100; ++k) {
    const auto stopped = service->stop(id);
    ASSERT_TRUE(stopped) << k << ": " << stopped.error().message;
    ASSERT_EQ(stopped->stage, Stage::interrupted);
  }
}

TEST_F(CaptureServiceTest, APersonStopsIt) {
  const auto service = open();
  const store::Id id = service->start(long_wish())->id;
  wait_until(*service, id, [](const CaptureState& state) { return state.taken >= 2; });
  const auto end = service->stop(id);
  EXPECT_EQ(end->stage, Stage::stopped);
  EXPECT_TRUE(end->test) << end->error;
  EXPECT_EQ(service->stop(id)->stage, Stage::stopped);
}

TEST_F(CaptureServiceTest, RefusesWhatItCannotDo) {
  const PieceServer server({"", "", ""});
  const auto service = open({server.source(), *parse_capture_source("gone=tcp://127.0.0.1:1")});
  const auto refused = [&](const std::string& source, std::vector<std::pair<std::string, std::string>> options) {
    const auto state = service->start(wish(source, std::move(options)));
    return state ? std::string() : state.error().message;
  };
  EXPECT_THAT(refused("tcp://127.0.0.1:22", {}), HasSubstr("found no source"));
  EXPECT_THAT(refused("gone", {}), HasSubstr("gone: cannot connect"));
  EXPECT_THAT(refused("simulator", {{"speed", "1000"}}), HasSubstr("speed: found \"1000\", expected one of 1, 10, 60"));
  EXPECT_THAT(refused("simulator", {{"preset", "fire"}}), HasSubstr("preset: found \"fire\""));
  EXPECT_THAT(refused("laser", {{"speed", "10"}}), HasSubstr("with the simulator only"));
  EXPECT_THAT(refused("simulator", {{"plan", "/etc/passwd"}}), HasSubstr("found the unknown option \"plan\""));
  EXPECT_THAT(refused("simulator", {{"rate", "-1"}}), HasSubstr("rate: found \"-1\""));
  EXPECT_THAT(refused("simulator", {{"part", "2"}}), HasSubstr("found part 2"));
  EXPECT_EQ(files(), 0u);
}

TEST_F(CaptureServiceTest, RunsNoMoreThanItMayAtOnce) {
  const auto service = open();
  for (int k = 0; k < 8; ++k) ASSERT_TRUE(service->start(wish("simulator", {{"speed", "1"}})));
  const auto ninth = service->start(wish("simulator", {{"speed", "1"}}));
  ASSERT_FALSE(ninth);
  EXPECT_EQ(ninth.error().kind, ErrorKind::unavailable);
  ASSERT_TRUE(service->stop(service->states().front().id));
  EXPECT_TRUE(service->start(wish("simulator", {{"speed", "1"}})));
}

TEST_F(CaptureServiceTest, EndsNoMoreInterruptedOnesThanItMayAtOnce) {
  std::vector<store::Id> ids;
  {
    const auto service = open();
    for (int k = 0; k < 3; ++k) ids.push_back(service->start(long_wish())->id);
    for (const store::Id id : ids) wait_until(*service, id, [](const CaptureState& state) { return state.taken >= 2; });
  }
  std::atomic<int> keeping = 0;
  std::latch may_keep(1);
  std::mutex archive;
  CaptureKeeping slow = archive_.keeping();
  slow.keep = [&, keep = slow.keep](const CapturedEnd& end) {
    ++keeping;
    may_keep.wait();
    const std::scoped_lock lock(archive);
    return keep(end);
  };
  const auto service = *CaptureService::open({.folder = folder_, .sources = {}}, std::move(slow));
  std::vector<std::jthread> stopping;
  for (const store::Id id : {ids[0], ids[1]}) stopping.emplace_back([&service, id] { EXPECT_TRUE(service->stop(id)); });
  for (int k = 0; k < 6000 && keeping < 2; ++k) std::this_thread::sleep_for(10ms);
  const auto third = service->stop(ids[2]);
  EXPECT_THAT(third ? "" : third.error().message, HasSubstr("found 2 interrupted captures being ended"));
  EXPECT_TRUE(!third && third.error().kind == ErrorKind::unavailable);
  EXPECT_EQ(keeping, 2);
  EXPECT_EQ(service->state(ids[2])->stage, Stage::interrupted);
  may_keep.count_down();
  stopping.clear();
  for (const store::Id id : {ids[0], ids[1]}) wait_until(*service, id, ended);
  EXPECT_TRUE(service->stop(ids[2]));
  EXPECT_TRUE(wait_until(*service, ids[2], ended).test);
}

TEST_F(CaptureServiceTest, ARecordingHasALimit) {
  CaptureSettings settings{.folder = folder_, .sources = {}, .most_at_once = 8, .raw_limit = 20'000};
  const auto service = *CaptureService::open(std::move(settings), archive_.keeping());
  const store::Id id = service->start(wish("simulator", {{"speed", "60"}}))->id;
  const CaptureState end = wait_until(*service, id, ended);
  EXPECT_EQ(end.stage, Stage::stopped);
  EXPECT_THAT(end.notices, Contains(HasSubstr("as long as one may be")));
  EXPECT_LE(archive_.raw.at(0).size(), 20'000u);
}

}  // namespace
}  // namespace axiometry::app
