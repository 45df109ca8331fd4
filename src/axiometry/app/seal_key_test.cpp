// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/seal_key.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <fstream>

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
