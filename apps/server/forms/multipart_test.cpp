// SPDX-License-Identifier: Apache-2.0
#include "server/forms/multipart.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiometry::server {
namespace {

using testing::HasSubstr;

constexpr std::string_view type = "multipart/form-data; boundary=cut";

std::string part(std::string_view head, std::string_view bytes) {
  return "--cut\r\n" + std::string(head) + "\r\n\r\n" + std::string(bytes) + "\r\n";
}

std::string refusal_of(std::string_view body, std::string_view content_type = type) {
  const auto parts = form_parts(content_type, body);
  return parts ? "taken" : parts.error().message;
}

TEST(FormParts, AreReadWithTheirBytesAsTheyAre) {
  const std::string binary("a\r\n--cu\0\xFF", 9);
  const std::string body =
      part("Content-Disposition: form-data; name=\"file\"; filename=\"a;b.csv\"\r\nContent-Type: text/csv", binary) +
      part("content-disposition: form-data; name=note", "hello") + "--cut--\r\n";
  const auto parts = form_parts(type, body);
  ASSERT_TRUE(parts) << parts.error().message;
  ASSERT_EQ(parts->size(), 2u);
  EXPECT_EQ((*parts)[0].bytes, binary);
  EXPECT_EQ((*parts)[0].file_name, "a;b.csv");
  EXPECT_EQ((*parts)[0].content_type, "text/csv");
  EXPECT_TRUE((*parts)[0].is_file);
  EXPECT_FALSE((*parts)[1].is_file);
  EXPECT_EQ((*parts)[1].bytes, "hello");
}

TEST(FormParts, MayBeEmptyFiles) {
  const std::string body = part("Content-Disposition: form-data; name=f; filename=\"e\"", "") + "--cut--\r\n";
  const auto parts = form_parts(type, body);
  ASSERT_TRUE(parts) << parts.error().message;
  EXPECT_EQ(parts->front().bytes, "");
}

TEST(FormParts, RefuseWhatIsCutOffOrMalformed) {
  const std::string good = part("Content-Disposition: form-data; name=f; filename=\"a\"", "x");
  EXPECT_EQ(refusal_of(good + "--cut--\r\n"), "taken");
  EXPECT_THAT(refusal_of(good), HasSubstr("cut off"));
  EXPECT_THAT(refusal_of(good.substr(0, good.size() - 5)), HasSubstr("end of its head"));
  EXPECT_THAT(refusal_of(good + "--cut"), HasSubstr("behind a boundary"));
  EXPECT_THAT(refusal_of("x" + good + "--cut--"), HasSubstr("begin"));
  EXPECT_THAT(refusal_of(good + "--cut--\r\nmore"), HasSubstr("behind a boundary"));
  EXPECT_THAT(refusal_of(part("no field", "x") + "--cut--"), HasSubstr("header field"));
  EXPECT_THAT(refusal_of(part("Content-Type: text/csv", "x") + "--cut--"), HasSubstr("without a name"));
  EXPECT_THAT(refusal_of(part("Content-Disposition: form-data; name=f\r\nContent-Transfer-Encoding: base64", "x")),
              HasSubstr("transfer encoding"));
  EXPECT_THAT(refusal_of(good, "multipart/form-data"), HasSubstr("boundary"));
  EXPECT_THAT(refusal_of(good, "multipart/form-data; boundary=\"\""), HasSubstr("boundary"));
  std::string many;
  for (int k = 0; k < 101; ++k) many += good;
  EXPECT_THAT(refusal_of(many + "--cut--"), HasSubstr("100"));
  EXPECT_THAT(refusal_of("--cut\r\n" + std::string(5000, 'x')), HasSubstr("end of its head"));
}

TEST(HeaderParameter, PrefersTheExtendedName) {
  EXPECT_EQ(header_parameter("attachment; filename=\"a.csv\"; filename*=UTF-8''%C3%A4.csv", "filename"), "ä.csv");
  EXPECT_EQ(header_parameter("attachment; filename=\"say \\\"x\\\".csv\"", "filename"), "say \"x\".csv");
  EXPECT_EQ(header_parameter("attachment; filename=C:\\a.csv", "filename"), "C:\\a.csv");
  EXPECT_EQ(header_parameter("attachment", "filename"), "");
  EXPECT_EQ(header_parameter("attachment; filename=\"a", "filename"), "");
}

}  // namespace
}  // namespace axiometry::server
