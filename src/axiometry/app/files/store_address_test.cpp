// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/store_address.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace axiometry::app {
namespace {

class StoreAddress : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : names) ::unsetenv(name);
  }
  void TearDown() override {
    ::unsetenv("AXIOMETRY_STORE");
    ::unsetenv("XDG_DATA_HOME");
    if (!home_.empty()) ::setenv("HOME", home_.c_str(), 1);
  }
  static constexpr const char* names[] = {"AXIOMETRY_STORE", "XDG_DATA_HOME", "HOME"};

 private:
  std::string home_ = std::getenv("HOME") == nullptr ? "" : std::getenv("HOME");
};

TEST_F(StoreAddress, IsWhatIsAskedForFirst) {
  ::setenv("AXIOMETRY_STORE", "other.db", 1);
  EXPECT_EQ(*store_address("mine.db"), "mine.db");
  EXPECT_EQ(*store_address(""), "other.db");
}

TEST_F(StoreAddress, IsInTheUsersFolderOfDataElse) {
  EXPECT_FALSE(store_address(""));
  ::setenv("HOME", "/home/anna", 1);
  EXPECT_EQ(*store_address(""), "/home/anna/.local/share/axiometry/axiometry.db");
  ::setenv("XDG_DATA_HOME", "relative", 1);
  EXPECT_EQ(*store_address(""), "/home/anna/.local/share/axiometry/axiometry.db");
  ::setenv("XDG_DATA_HOME", "/data", 1);
  EXPECT_EQ(*store_address(""), "/data/axiometry/axiometry.db");
}

}  // namespace
}  // namespace axiometry::app
