// SPDX-License-Identifier: Apache-2.0
//
// One capture becomes one test, also where the archive gets the test of a program that was killed long after: its
// COMMIT was on its way, and nobody saw the test when the capture was gone on with.
#include <gmock/gmock.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <semaphore>
#include <thread>

#include "axiometry/app/live/runs/capture_run.h"
#include "axiometry/app/live/service/capture_keeping.h"
#include "axiometry/app/recordings/raw_log.h"
#include "axiometry/formats/plan/plan_json.h"
#include "axiometry/store/database/clock.h"
#include "axiometry/store/store_test_support.h"
#include "tests/support/simulated_recording.h"

namespace axiometry::app {
namespace {

using store::must;
using testing_support::lines_of;
using testing_support::short_plan;

/// An archive with a plan.
struct Planned {
  explicit Planned(const std::string& address) : store(must(store::Store::open(address))) {
    const std::string bytes = formats::write_plan(short_plan());
    const auto content = must(store->keep({sha256(bytes), "plan.json", "plan", bytes}, store::by_anna));
    plan = must(store->add(store::PlanRecord{"X", {}, content}, store::by_anna)).id;
  }

  std::unique_ptr<store::Store> store;
  Workbench workbench{*store};
  store::Id plan = 0;
};

class CaptureLate : public store::BothStores {
 protected:
  HeldCapture captured(store::Id plan) {
    HeldCapture held = must(CaptureFolder(file("captures"))
                                .add({.plan = plan,
                                      .part = 1,
                                      .walked = short_plan(),
                                      .source = "laser",
                                      .layout = "time-position",
                                      .options = {},
                                      .actor = "Anna",
                                      .started = store::now_text()}));
    RawLog log = must(RawLog::create(held.raw()));
    for (const auto& line : lines_of("time-position")) must(log.append(line.text, log.stamp()));
    return held;
  }

  static axiometry::Test test_of(const HeldCapture& held) {
    CaptureOptions options;
    options.stream = "time-position";
    return must(run_live_capture(must(CaptureSession::open(short_plan(), options)),
                                 {.name = "x", .connect = {}, .raw = {}, .resume = held.raw()}, {}))
        .test;
  }

  /// The file that a capture becomes, as an archive of its own got it.
  Upload upload_of(HeldCapture& held, const axiometry::Test& test) {
    Planned other(file("other.db"));
    const store::Id id = *must(keeping_in(other.workbench).keep({held, test}));
    const store::TestRecord record = must(other.store->test(id));
    bytes_ = must(other.store->content(record.sha256)).bytes;
    return {.name = record.file_name, .bytes = bytes_, .plan = record.state.plan};
  }

  std::size_t notes() const {
    std::ifstream order(file("captures") + "/capture-1.json", std::ios::binary);
    const std::string text{std::istreambuf_iterator<char>(order), {}};
    std::size_t count = 0;
    for (auto at = text.find("becomes test"); at != std::string::npos; at = text.find("becomes test", at + 1)) ++count;
    return count;
  }

  std::string bytes_;
};
AXIOMETRY_ON_BOTH_STORES(CaptureLate);

TEST_P(CaptureLate, ATestThatTheArchiveGetsBehindTheLookForItIsNotKeptTwice) {
  Planned archive(new_address());
  HeldCapture held = captured(archive.plan);
  axiometry::Test test = test_of(held);
  const Upload killed = upload_of(held, test);
  std::binary_semaphore on_its_way(0);
  const std::jthread late([&] {
    must(archive.store->write([&](store::Transaction& transaction) {
      auto received = archive.workbench.receive(transaction, {&killed, 1}, store::by_anna);
      on_its_way.release();
      const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(5);
      while (notes() < 2 && std::chrono::steady_clock::now() < patience)
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      return received;
    }));
  });
  on_its_way.acquire();
  const CaptureKeeping keeping = keeping_in(archive.workbench);
  EXPECT_EQ(must(keeping.kept(held)), std::nullopt);
  test.provenance.file = "seen in another life of the program";
  EXPECT_EQ(must(keeping.keep({held, test})), 1);
  EXPECT_EQ(notes(), 2u);
  EXPECT_EQ(must(archive.store->tests({})).rows.size(), 1u);
  EXPECT_EQ(must(archive.store->documents(1)).size(), 2u);  // the recording and its times
}

TEST_P(CaptureLate, ATestIsFoundByEachOfTheNotes) {
  Planned archive(new_address());
  HeldCapture held = captured(archive.plan);
  const auto id = must(keeping_in(archive.workbench).keep({held, test_of(held)}));
  must(held.note_test(std::string(64, 'a')));
  EXPECT_EQ(must(keeping_in(archive.workbench).kept(held)), id);
}

TEST_P(CaptureLate, AFileOfTheSameContentUnderAnotherNameIsAnother) {
  Planned archive(new_address());
  HeldCapture held = captured(archive.plan);
  Upload upload = upload_of(held, test_of(held));
  upload.perhaps_kept_as = {sha256(upload.bytes)};
  EXPECT_EQ(must(archive.workbench.receive({&upload, 1}, store::by_anna)).tests.front().id, 1);
  EXPECT_EQ(must(archive.workbench.receive({&upload, 1}, store::by_anna)).tests.front().id, 1);
  upload.name = "other.json";
  EXPECT_EQ(must(archive.workbench.receive({&upload, 1}, store::by_anna)).tests.front().id, 2);
  upload.perhaps_kept_as = {};
  EXPECT_EQ(must(archive.workbench.receive({&upload, 1}, store::by_anna)).tests.front().id, 3);
}

}  // namespace
}  // namespace axiometry::app
