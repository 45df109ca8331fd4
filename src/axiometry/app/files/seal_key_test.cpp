// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/seal_key.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

TEST(SealKey, IsMadeOnceForItsOwnerOnlyAndIsTheSameThen) {
  const testing_support::TemporaryFolder folder;
  const std::string file = folder.file("new/archive.db.key");
  const auto made = key_in(file);
  ASSERT_TRUE(made) << made.error().to_string();
  struct stat status {};
  ASSERT_EQ(::stat(file.c_str(), &status), 0);
  EXPECT_EQ(status.st_mode & 0777, 0600u);
  EXPECT_EQ(key_in(file)->public_key(), made->public_key());
  EXPECT_EQ(read_key(file)->public_key(), made->public_key());
}

TEST(SealKey, IsOneForAllWhoMakeItAtOnce) {
  for (int round = 0; round < 20; ++round) {
    const testing_support::TemporaryFolder folder;
    const std::string file = folder.file("key");
    std::string public_keys[4];
    {
      std::vector<std::jthread> makers;
      for (std::string& key : public_keys)
        makers.emplace_back([&] {
          const auto made = key_in(file);
          key = made ? made->public_key() : made.error().to_string();
        });
    }
    for (const std::string& key : public_keys) EXPECT_EQ(key, read_key(file)->public_key());
    const auto files = std::filesystem::directory_iterator(folder.file("."));
    EXPECT_EQ(std::distance(begin(files), end(files)), 1) << "nothing half made stays";
  }
}

TEST(SealKey, IsRefusedWhereOthersMayReadItOrItIsNone) {
  const testing_support::TemporaryFolder folder;
  const std::string file = folder.file("key");
  ASSERT_TRUE(key_in(file));
  ::chmod(file.c_str(), 0640);
  EXPECT_FALSE(key_in(file));
  std::ofstream(folder.file("other")) << "no key";
  ::chmod(folder.file("other").c_str(), 0600);
  EXPECT_FALSE(key_in(folder.file("other")));
  EXPECT_FALSE(read_key(folder.file("none")));
}

TEST(SealKey, LiesBesideTheFileOfAnArchive) {
  EXPECT_EQ(*default_key_file({.kind = "sqlite", .location = "hall/tests.db", .why_not = ""}), "hall/tests.db.key");
}

}  // namespace
}  // namespace axiometry::app
