// SPDX-License-Identifier: Apache-2.0
//
// Who holds a recording, a capture or their count: another one for a moment, or nobody can say.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <thread>

#include "axiometry/app/files/output.h"
#include "axiometry/app/live/disk/capture_folder.h"
#include "axiometry/app/recordings/raw_log.h"
#include "tests/support/simulated_recording.h"
#include "tests/support/temporary_folder.h"

namespace {

/// In front of the system's: the error with which it fails for that file, or 0. Empty: only passes on.
std::function<int(const std::string& file)> watched_lock;  // NOLINT: a function of C has no other way to be told

int system_lock(int descriptor, int operation) { return static_cast<int>(::syscall(SYS_flock, descriptor, operation)); }

}  // namespace

extern "C" int flock(int descriptor, int operation) noexcept {
  if (!watched_lock) return system_lock(descriptor, operation);
  std::error_code none;
  const auto file = std::filesystem::read_symlink("/proc/self/fd/" + std::to_string(descriptor), none);
  if (const int error = watched_lock(file.string()); error != 0) {
    errno = error;
    return -1;
  }
  return system_lock(descriptor, operation);
}

namespace axiometry::app {
namespace {

using testing::HasSubstr;

class CaptureLockTest : public testing::Test {
 protected:
  ~CaptureLockTest() override { watched_lock = nullptr; }

  Result<HeldCapture> added() {
    CaptureOrder order;
    order.walked = testing_support::short_plan();
    return CaptureFolder(path_).add(order);
  }
  bool has_orders() const {
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(path_, none))
      if (entry.path().extension() == ".json") return true;
    return false;
  }

  testing_support::TemporaryFolder folder_;
  const std::string path_ = folder_.file("captures");
};

TEST_F(CaptureLockTest, NobodyHoldsARecordingThatTheSystemCannotLock) {
  const std::string raw = folder_.file("run.raw");
  ASSERT_TRUE(write_file(raw, "abc"));
  watched_lock = [](const std::string&) { return ENOLCK; };
  const auto held = RawHold::take(raw);
  ASSERT_FALSE(held);
  EXPECT_THAT(held.error().to_string(), HasSubstr("run.raw: cannot lock: "));
  watched_lock = nullptr;
  EXPECT_TRUE(RawHold::take(raw));
}

TEST_F(CaptureLockTest, NoCaptureIsCountedWhereTheSystemCannotLock) {
  for (const std::string_view what : {"captures", "capture-1.json"}) {
    watched_lock = [&](const std::string& file) { return file.ends_with(what) ? ENOLCK : 0; };
    const auto held = added();
    ASSERT_FALSE(held) << what;
    EXPECT_EQ(held.error().kind, ErrorKind::unavailable);
    EXPECT_THAT(held.error().message, HasSubstr("cannot "));
    EXPECT_FALSE(has_orders()) << what;
  }
}

TEST_F(CaptureLockTest, ASignalKeepsNobodyFromCounting) {
  int interruptions = 0;
  watched_lock = [&](const std::string&) { return ++interruptions % 2 == 1 ? EINTR : 0; };
  const auto held = added();
  ASSERT_TRUE(held) << held.error().message;
  EXPECT_EQ(interruptions, 4);
}

/// In the moment between the making of the order and its being locked.
TEST_F(CaptureLockTest, ANewCaptureWaitsForAnotherProgramThatLooksAtItsOrder) {
  std::optional<std::jthread> another;
  watched_lock = [&](const std::string& file) {
    if (another || !file.ends_with(".json")) return 0;
    const int looking = ::open(file.c_str(), O_RDWR | O_CLOEXEC);
    EXPECT_EQ(system_lock(looking, LOCK_EX | LOCK_NB), 0);
    another.emplace([looking] {
      std::this_thread::sleep_for(std::chrono::milliseconds(50));
      ::close(looking);
    });
    return 0;
  };
  const auto held = added();
  EXPECT_TRUE(another);
  ASSERT_TRUE(held) << held.error().message;
  EXPECT_EQ(held->id(), 1);
}

}  // namespace
}  // namespace axiometry::app
