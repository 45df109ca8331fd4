// SPDX-License-Identifier: Apache-2.0
// The workbench while somebody else is at the same archive. Each again and again: it is a matter of milliseconds.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <barrier>
#include <chrono>
#include <latch>
#include <optional>
#include <stop_token>
#include <thread>

#include "axiometry/app/workbench/examples/example_table2.h"
#include "axiometry/app/workbench/workbench.h"
#include "tests/support/archive.h"

namespace axiometry::app {
namespace {

const store::By somebody{"A. Tester", "a test"};

class TheWorkbenchBesideOthers : public testing::Test {
 protected:
  Result<Received> receive(Workbench& workbench, std::string_view bytes) {
    const Upload upload{"table2.json", bytes};
    return workbench.receive(std::span(&upload, 1), somebody);
  }

  /// Table 2 in bytes of its own.
  static std::string table2(std::size_t number) { return std::string(example_table2) + std::string(number, '\n'); }

  testing_support::Archive archive_;
  store::Store& store_ = archive_.store();
  Workbench workbench_{store_};
};

/// The interferometer of Table 2; all that a version says tells its number.
store::InstrumentRecord laser_as_of(int version) {
  store::InstrumentRecord laser;
  laser.manufacturer = "Example Instruments";
  laser.type = "LI-1";
  laser.serial_number = "1234";
  laser.certificate = fmt::format("C-{}", version);
  laser.calibrated_on = "2014-01-10";
  laser.inputs = {{"uncertainty.instrument_resolution", fmt::format("{}", version)}};
  return laser;
}

/// That a test was evaluated with the very version of the instrument with which it is linked.
void expect_one_version(const KeptTest& test) {
  const FromArchive& taken = test.outcome.from_archive;
  ASSERT_EQ(taken.instruments.size(), 1u);
  ASSERT_EQ(taken.calibrations.size(), 1u);
  const auto& linked = test.record.state.instruments;
  const auto laser = std::ranges::find(linked, "1234", &store::InstrumentRecord::serial_number);
  ASSERT_NE(laser, linked.end());
  EXPECT_EQ(taken.calibrations[0].version, taken.instruments[0].version);
  EXPECT_EQ(laser->certificate, fmt::format("C-{}", taken.instruments[0].version));
}

TEST_F(TheWorkbenchBesideOthers, EvaluatesAndKeepsAsOfOneMomentWhileAnInstrumentChanges) {
  ASSERT_TRUE(store_.add(laser_as_of(1), somebody));
  const std::jthread changing([&](const std::stop_token& stop) {
    for (int version = 1; version < 1000 && !stop.stop_requested(); ++version) {
      const auto changed = store_.change(1, version, laser_as_of(version + 1), somebody);
      ASSERT_TRUE(changed) << changed.error().to_string();
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  for (std::size_t k = 0; k < 40; ++k) {
    const auto received = receive(workbench_, table2(k));
    ASSERT_TRUE(received) << received.error().to_string();
    const store::Id id = received->tests.front().id;
    expect_one_version(*workbench_.test(id));
    const auto revised = workbench_.revise(id, {.draft = {}, .base_version = 1, .title = "Anew"}, somebody);
    ASSERT_TRUE(revised) << revised.error().to_string();
    expect_one_version(*revised);
  }
}

TEST_F(TheWorkbenchBesideOthers, TellsOneOfTwoWhoSendTheSameBytesOfTheOther) {
  for (std::size_t k = 0; k < 20; ++k) {
    const std::string bytes = table2(k);
    std::barrier together(2);
    std::vector<store::Id> same[2], own[2];
    const auto send = [&](int who) {
      together.arrive_and_wait();
      const auto received = receive(workbench_, bytes);
      ASSERT_TRUE(received) << received.error().to_string();
      same[who] = received->same_content;
      own[who] = {received->tests.front().id};
    };
    std::thread other(send, 1);
    send(0);
    other.join();
    const int second = own[1] > own[0] ? 1 : 0;
    EXPECT_THAT(same[1 - second], testing::IsEmpty());
    EXPECT_EQ(same[second], own[1 - second]);
  }
}

TEST_F(TheWorkbenchBesideOthers, KeepsNothingOfWhatIsStoppedWhileItWaitsToBeKept) {
  const auto received = receive(workbench_, example_table2);
  ASSERT_TRUE(received);
  const store::Id id = received->tests.front().id;
  const ReportRequest wanted{.extension = "csv", .options = {}};
  ASSERT_TRUE(workbench_.report(id, {}, wanted)) << "so that it is evaluated";
  const auto stopped = [&](const auto& work) {
    std::latch writing(1);
    std::latch go_on(1);
    std::jthread other([&] {
      const auto written = store_.write([&](store::Transaction&) -> Result<int> {
        writing.count_down();
        go_on.wait();
        return 0;
      });
      EXPECT_TRUE(written);
      if (!written) writing.count_down();
    });
    writing.wait();
    std::stop_source source;
    std::optional<Error> error;
    std::atomic<bool> done = false;
    std::jthread working([&] {
      error = work(source.get_token());
      done = true;
    });
    while (store_.waiting_to_write() == 0 && !done) std::this_thread::yield();
    EXPECT_FALSE(done) << "waits for the other";
    source.request_stop();
    go_on.count_down();
    working.join();
    return error ? error->message : "kept";
  };
  const auto error_of = [](const auto& result) { return result ? std::nullopt : std::optional(result.error()); };
  EXPECT_THAT(
      stopped([&](const std::stop_token& stop) {
        return error_of(workbench_.revise(id, {.draft = {}, .base_version = 1, .title = "Anew"}, somebody, stop));
      }),
      testing::HasSubstr("nothing was kept"));
  EXPECT_THAT(stopped([&](const std::stop_token& stop) {
                ReportRequest report = wanted;
                report.stop = stop;
                return error_of(workbench_.issue(id, {}, report, somebody));
              }),
              testing::HasSubstr("nothing was kept"));
  EXPECT_EQ(workbench_.test(id)->versions.size(), 1U);
  EXPECT_TRUE(store_.documents(id)->empty());
}

TEST_F(TheWorkbenchBesideOthers, ShowsATestAsOfOneMomentWhileItIsRevised) {
  const auto received = receive(workbench_, example_table2);
  ASSERT_TRUE(received);
  const store::Id id = received->tests.front().id;
  std::atomic<bool> done = false;
  std::jthread revising([&] {
    for (int version = 1; version < 60; ++version)
      EXPECT_TRUE(workbench_.revise(id, {.draft = {}, .base_version = version, .title = "Anew"}, somebody));
    done = true;
  });
  while (!done) {
    const auto test = workbench_.test(id);
    ASSERT_TRUE(test) << test.error().to_string();
    ASSERT_EQ(test->versions.size(), static_cast<std::size_t>(test->record.latest));
  }
}

}  // namespace
}  // namespace axiometry::app
