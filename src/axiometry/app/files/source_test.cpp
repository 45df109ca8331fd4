// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/source.h"
#include "tests/support/temporary_folder.h"

#include <gtest/gtest.h>

namespace axiometry::app {
namespace {

class SourceTest : public testing::Test {
 protected:
  std::string file(std::string_view bytes) const { return folder_.written("file", bytes); }

  testing_support::TemporaryFolder folder_;
};

TEST_F(SourceTest, LooksAtTheHeadWithoutConsumingIt) {
  std::string bytes;
  while (bytes.size() < 200'000) bytes += std::to_string(bytes.size()) + "\n";
  auto source = Source::open(file(bytes));
  ASSERT_TRUE(source);
  EXPECT_EQ(*source->head(), std::string_view(bytes).substr(0, 65536));
  EXPECT_EQ(*source->read_all(1 << 20), bytes);
  EXPECT_EQ(**source->whole_sha256(), sha256(bytes));
}

TEST_F(SourceTest, ReadsOnceWhatItHashesAhead) {
  std::string bytes;
  while (bytes.size() < 200'000) bytes += std::to_string(bytes.size()) + "\n";
  for (const std::string& written : {std::string(), std::string("short"), bytes}) {
    auto source = Source::open(file(written));
    ASSERT_TRUE(source);
    EXPECT_EQ(**source->sha256_ahead(), sha256(written));
    file("something else by now");
    EXPECT_EQ(*source->head(), std::string_view(written).substr(0, 65536));
    EXPECT_EQ(*source->read_all(1 << 20), written);
  }
  EXPECT_EQ(**Source::of_bytes("sent", bytes).sha256_ahead(), sha256(bytes));
}

TEST_F(SourceTest, RefusesMoreThanTheLimitWithoutReadingIt) {
  auto source = Source::open(file(std::string(3 << 20, 'x')));
  ASSERT_TRUE(source);
  const auto result = source->read_all(2 << 20);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().message, "found a file of 3 MiB, expected at most 2 MiB for one test");
}

TEST_F(SourceTest, SaysWhyItCannotOpen) {
  EXPECT_EQ(Source::open(folder_.file("none")).error().to_string(),
            folder_.file("none") + ": cannot open: No such file or directory");
  EXPECT_EQ(Source::open(folder_.path()).error().to_string(), folder_.path() + ": cannot read: Is a directory");
}

}  // namespace
}  // namespace axiometry::app
