// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/decoded_text.h"

#include <gtest/gtest.h>

namespace axiometry::formats {
namespace {

using namespace std::string_literals;

struct Encoded {
  std::string what;
  std::string bytes;
  std::string text;
  std::string encoding;
};

class Encodings : public testing::TestWithParam<Encoded> {};

TEST_P(Encodings, AreFoundOut) {
  const auto decoded = decoded_text(GetParam().bytes);
  ASSERT_TRUE(decoded) << decoded.error().to_string();
  EXPECT_EQ(decoded->text, GetParam().text);
  EXPECT_EQ(decoded->encoding, GetParam().encoding);
  EXPECT_EQ(encoding_remarks(*decoded).empty(), GetParam().encoding == "UTF-8");
}

INSTANTIATE_TEST_SUITE_P(
    Texts, Encodings,
    testing::Values(Encoded{"Ascii", "Machine: Mill 5\r\n", "Machine: Mill 5\r\n", "UTF-8"},
                    Encoded{"Utf8", "Fr\xC3\xA4se", "Fräse", "UTF-8"},
                    Encoded{"Utf8WithMark", "\xEF\xBB\xBFX 20 °C", "X 20 °C", "UTF-8"},
                    Encoded{"Latin1", "Fr\xE4se, 20 \xB0"s + "C, \xB5m", "Fräse, 20 °C, µm", "Windows-1252"},
                    // F6 DF is a pair of GBK too, but of a character that hardly anybody writes.
                    Encoded{"Latin1ThatIsValidGbk", "Gr\xF6\xDF"s + "e", "Größe", "Windows-1252"},
                    Encoded{"Windows", "\x84Mill\x93 \x96 \x80", "„Mill“ – €", "Windows-1252"},
                    Encoded{"Latin1ThatIsNoWindows", "a\x81\xE4", "a\u0081ä", "Latin-1"},
                    Encoded{"Gbk", "\xBB\xFA\xB4\xB2\xA3\xBA\xC8\xFD\xD6\xE1", "机床：三轴", "GBK"},
                    Encoded{"GbkWithSymbols", "\xD0\xCD\xBA\xC5 20\xA1\xE6 \xA6\xCCm", "型号 20℃ μm", "GBK"},
                    Encoded{"Utf16Little", "\xFF\xFEX\0\xB0\0\n\0"s, "X°\n", "UTF-16"},
                    Encoded{"Utf16Big", "\xFE\xFF\0X\0\xB0\0\n"s, "X°\n", "UTF-16"},
                    Encoded{"Utf16WithoutMark", "X\0Y\0\n\0"s, "XY\n", "UTF-16"}),
    [](const auto& of) { return of.param.what; });

TEST(DecodedText, TakesLinesThatEndInCarriageReturnAlone) {
  const auto decoded = decoded_text("a\rb\rc\r");
  ASSERT_TRUE(decoded);
  EXPECT_EQ(decoded->text, "a\nb\nc\n");
  EXPECT_EQ(encoding_remarks(*decoded).size(), 1u);
}

TEST(DecodedText, RefusesWhatIsNoText) {
  const auto message = [](std::string_view bytes) {
    const auto decoded = decoded_text(bytes);
    return decoded ? "no error" : decoded.error().to_string();
  };
  EXPECT_EQ(message(""), "found an empty file, expected measured deviations");
  EXPECT_EQ(message("ab\0cd"s), "line 1:3: found a NUL byte, so this is a binary file, expected a text file");
  EXPECT_EQ(message(std::string(400, '\0')),
            "line 1:1: found a NUL byte, so this is a binary file, expected a text file");
  EXPECT_EQ(message("\xFF\xFEX\0Y"s), "line 1:1: found UTF-16LE text that is cut or broken, expected whole characters");
  EXPECT_EQ(message("\xFF\xFE\0\0X\0\0\0"s),
            "line 1:1: found UTF-16 or UTF-32 text, expected UTF-8; save the file as UTF-8");
}

}  // namespace
}  // namespace axiometry::formats
