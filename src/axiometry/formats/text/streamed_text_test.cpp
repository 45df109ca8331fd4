// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/streamed_text.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "axiometry/formats/text/decoded_text.h"

namespace axiometry::formats {
namespace {

using namespace std::string_view_literals;

std::string streamed_in_pieces(std::string_view bytes, std::size_t size) {
  StreamedText text;
  std::string all;
  for (; !bytes.empty(); bytes.remove_prefix(std::min(size, bytes.size()))) all += text.decoded(bytes.substr(0, size));
  return all;
}

TEST(StreamedText, IsWhatTheWholeTextIsHoweverItIsCut) {
  for (const std::string_view bytes :
       {"\xFF\xFEt\0 \0[\0\xB5\0s\0]\0\n\0\xAC\x20\x3D\xD8\0\xDE.\0"sv, "\xFE\xFF\0t\0\xB5\x20\xAC\xD8\x3D\xDE\0\0."sv,
        "plain, \xC2\xB5m\n"sv, "\xB5m of a code page\n"sv, "\xFFyes\n"sv, "\xFE"sv, ""sv})
    for (std::size_t size = 1; size <= bytes.size(); ++size) {
      const auto whole = decoded_text(bytes);
      const bool utf16 = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
      const std::string expected = utf16 ? whole.value().text : bytes == "\xFE" ? "" : std::string(bytes);
      EXPECT_EQ(streamed_in_pieces(bytes, size), expected) << size;
    }
}

TEST(StreamedText, TellsWhatIsNotWhole) {
  StreamedText text;
  EXPECT_EQ(text.decoded("\xFF\xFE"
                         "1\0"
                         "2"sv),
            "1");
  EXPECT_TRUE(text.is_utf16());
  EXPECT_EQ(text.unfinished(), 1u);
  text.interrupted();
  EXPECT_EQ(text.unfinished(), 0u);
  EXPECT_EQ(text.decoded("3\0"sv), "3");
  EXPECT_EQ(text.decoded("\x3D\xD8"
                         "4\0"sv),
            "\xEF\xBF\xBD"
            "4")
      << "half of a pair";
  EXPECT_EQ(text.decoded("\0\xDE"sv), "\xEF\xBF\xBD");
}

}  // namespace
}  // namespace axiometry::formats
