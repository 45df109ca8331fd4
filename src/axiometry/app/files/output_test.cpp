// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/output.h"
#include "tests/support/temporary_folder.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <sys/syscall.h>

#include <cerrno>
#include <filesystem>
#include <functional>
#include <iterator>
#include <vector>

namespace {

/// In the place of the system's: sees what is synced and when, and fails where it is asked to. Empty: only passes on.
std::function<bool(int descriptor)> watched_sync;  // NOLINT: a function of C has no other way to be told

}  // namespace

extern "C" int fsync(int descriptor) {
  if (watched_sync && !watched_sync(descriptor)) {
    errno = EIO;
    return -1;
  }
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

namespace axiometry::app {
namespace {

namespace fs = std::filesystem;

class OutputTest : public testing::Test {
 protected:
  std::string content(const std::string& name) const { return folder_.content(name); }
  std::size_t file_count() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_.path()), {}));
  }
  std::string path(const std::string& name) const { return folder_.file(name); }

  testing_support::TemporaryFolder folder_;
};

TEST_F(OutputTest, AppearsOnCommit) {
  auto file = OutputFile::create(path("a.txt"));
  ASSERT_TRUE(file);
  ASSERT_TRUE(file->write("one\n"));
  EXPECT_FALSE(fs::exists(path("a.txt")));
  ASSERT_TRUE(file->commit());
  EXPECT_EQ(content("a.txt"), "one\n");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(OutputTest, LeavesNothingWithoutCommitAndKeepsWhatWasThere) {
  ASSERT_TRUE(write_file(path("a.txt"), "old"));
  {
    auto file = OutputFile::create(path("a.txt"));
    ASSERT_TRUE(file);
    ASSERT_TRUE(file->write(std::string(1 << 20, 'x')));
  }
  EXPECT_EQ(content("a.txt"), "old");
  EXPECT_EQ(file_count(), 1u);
}

/// "file" or "folder" of each that was synced while this lives, with whether the name was there.
class SyncWatch {
 public:
  explicit SyncWatch(std::string name, int fails_at = 0) {
    watched_sync = [this, name = std::move(name), fails_at](int descriptor) {
      struct stat status {};
      ::fstat(descriptor, &status);
      seen_.push_back(std::string(S_ISDIR(status.st_mode) ? "folder" : "file") + (fs::exists(name) ? ", named" : ""));
      return static_cast<int>(seen_.size()) != fails_at;
    };
  }
  ~SyncWatch() { watched_sync = nullptr; }
  SyncWatch(const SyncWatch&) = delete;
  SyncWatch& operator=(const SyncWatch&) = delete;

  const std::vector<std::string>& seen() const { return seen_; }

 private:
  std::vector<std::string> seen_;
};

TEST_F(OutputTest, IsOnTheDiskBeforeItHasItsNameAndItsNameBeforeItIsDone) {
  const SyncWatch watch(path("a.txt"));
  ASSERT_TRUE(write_file(path("a.txt"), "one"));
  EXPECT_EQ(watch.seen(), (std::vector<std::string>{"file", "folder, named"}));
}

TEST_F(OutputTest, ASecretIsItsOwnersAndOnTheDiskAndTakesNoOthersName) {
  {
    const SyncWatch watch(path("key"));
    ASSERT_TRUE(write_secret_file(path("key"), "one"));
    EXPECT_EQ(watch.seen(), (std::vector<std::string>{"file", "folder, named"}));
  }
  struct stat status {};
  ASSERT_EQ(::stat(path("key").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  const auto refused = write_secret_file(path("key"), "two");
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::conflict);
  EXPECT_EQ(content("key"), "one");
  EXPECT_EQ(file_count(), 1u);
}

TEST_F(OutputTest, LeavesNoSecretWhereTheDiskDoesNotTakeIt) {
  const SyncWatch watch(path("key"), 1);
  EXPECT_FALSE(write_secret_file(path("key"), "one"));
  EXPECT_EQ(file_count(), 0u);
}

TEST_F(OutputTest, KeepsWhatWasThereWhenTheDiskDoesNotTakeTheNewOne) {
  ASSERT_TRUE(write_file(path("a.txt"), "old"));
  {
    const SyncWatch watch(path("a.txt"), 1);
    const auto refused = write_file(path("a.txt"), "new");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().message.find("cannot write: "), std::string::npos);
  }
  EXPECT_EQ(content("a.txt"), "old");
  EXPECT_EQ(file_count(), 1u);
  const SyncWatch watch(path("a.txt"), 2);
  EXPECT_FALSE(write_file(path("a.txt"), "new")) << "nobody knows whether the name is on the disk";
}

TEST_F(OutputTest, LeavesNothingWhenTheProcessIsKilled) {
  const int nameless = ::open(folder_.path().c_str(), O_TMPFILE | O_WRONLY, 0666);
  if (nameless < 0) GTEST_SKIP() << "no files without a name on this file system";
  ::close(nameless);
  const pid_t child = ::fork();
  if (child == 0) {
    auto file = OutputFile::create(path("a.txt"));
    if (file) static_cast<void>(file->write(std::string(1 << 20, 'x')));
    ::_exit(0);  // no destructor runs
  }
  int status = 0;
  ASSERT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(file_count(), 0u);
}

TEST_F(OutputTest, KeepsThePermissionsOfTheFileItReplaces) {
  ASSERT_TRUE(write_file(path("a.txt"), "old"));
  ASSERT_EQ(::chmod(path("a.txt").c_str(), 0640), 0);
  ASSERT_TRUE(write_file(path("a.txt"), "new"));
  struct stat status {};
  ASSERT_EQ(::stat(path("a.txt").c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777u, 0640u);
}

TEST_F(OutputTest, WritesWhatALinkPointsToAndKeepsTheLink) {
  ASSERT_TRUE(write_file(path("a.txt"), "old"));
  fs::create_symlink("a.txt", path("link.txt"));
  ASSERT_TRUE(write_file(path("link.txt"), "new"));
  EXPECT_TRUE(fs::is_symlink(path("link.txt")));
  EXPECT_EQ(content("a.txt"), "new");
}

TEST_F(OutputTest, IsCalledWhatItIs) {
  for (const char* name : {"-", "", "plan", "/dev/stdout", "a.b/plan", "x.json", "x.JSON", "Plan of X.Json"})
    EXPECT_TRUE(check_ending(name, {".json"})) << name;
  const auto table = check_ending("x.csv", {".json"});
  ASSERT_FALSE(table);
  EXPECT_EQ(table.error().message, "found the output \"x.csv\", expected a file ending in .json");
  const auto json = check_ending("x.json", {".csv", ".txt"});
  ASSERT_FALSE(json);
  EXPECT_EQ(json.error().message, "found the output \"x.json\", expected a file ending in .csv, .txt");
}

TEST_F(OutputTest, CanBeAskedBefore) {
  EXPECT_TRUE(check_writable("-"));
  EXPECT_TRUE(check_writable("/dev/null"));
  EXPECT_TRUE(check_writable(path("new.json")));
  EXPECT_FALSE(fs::exists(path("new.json")));
  ASSERT_TRUE(write_file(path("old.json"), "old"));
  EXPECT_TRUE(check_writable(path("old.json")));
  EXPECT_EQ(content("old.json"), "old");
  EXPECT_EQ(check_writable(path("no/x.json")).error().message, "cannot write: No such file or directory");
  EXPECT_EQ(check_writable(folder_.path()).error().message, "cannot write: Is a directory");
}

TEST_F(OutputTest, SaysWhyItCannotWrite) {
  const auto result = write_file(path("no/such/folder.txt"), "x");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().to_string(), path("no/such/folder.txt") + ": cannot write: No such file or directory");
  EXPECT_EQ(write_file(folder_.path(), "x").error().message, "cannot write: Is a directory");
  EXPECT_EQ(write_file("/dev/full", "x").error().message, "cannot write: No space left on device");
}

}  // namespace
}  // namespace axiometry::app
