// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "axiometry/report/figures/figures_test_support.h"
#include "axiometry/report/writer.h"

namespace axiometry::report {
namespace {

using ::testing::HasSubstr;

std::string written(std::string_view extension, const testing::Drawn& drawn) {
  return find_writer(extension)->write(drawn.subject(), drawn.options).value();
}

unsigned big_endian_at(std::string_view bytes, std::size_t at) {
  unsigned value = 0;
  for (std::size_t k = at; k < at + 4; ++k) value = (value << 8) | static_cast<unsigned char>(bytes[k]);
  return value;
}

TEST(FindWriter, TakesAnyCase) {
  ASSERT_NE(find_writer("png"), nullptr);
  EXPECT_EQ(find_writer("PNG"), find_writer("png"));
  EXPECT_EQ(find_writer("docx"), nullptr);
  EXPECT_EQ(find_writer(""), nullptr);
}

TEST(PngWriter, MakesAPictureOf200DotsPerInch) {
  const std::string png = written("png", testing::table_2());
  ASSERT_TRUE(png.starts_with("\x89PNG\r\n"));
  EXPECT_EQ(big_endian_at(png, 16), 1489u);  // 536 points wide
  EXPECT_EQ(png.substr(37, 4), "pHYs");
  EXPECT_EQ(big_endian_at(png, 41), 7874u);
}

TEST(PngWriter, WritesTheSameBytesAgain) {
  EXPECT_EQ(written("png", testing::table_2()), written("png", testing::table_2()));
}

TEST(SvgWriter, SaysWhatWasTestedAndAfterWhichStandard) {
  auto example = testing::table_2();
  example.test.metadata.machine.name = "Mill <1> & Co";
  const std::string svg = written("svg", example);
  EXPECT_THAT(svg, HasSubstr("Axis X · Mill &lt;1&gt; &amp; Co"));
  EXPECT_THAT(svg, HasSubstr("Computed after clause 3 of ISO 230-2:2014; not a test in accordance with it"));
  EXPECT_THAT(svg, HasSubstr("Figure 3b."));
}

TEST(SvgWriter, NeverCallsADepartingTestAnIsoResult) {
  auto example = testing::table_2();
  example.assessment.findings.push_back({"5.3.2", iso230_2::Severity::departure, "only four runs"});
  const std::string svg = written("svg", example);
  EXPECT_THAT(svg, HasSubstr("not a test in accordance with it (departs from 5.3.2)"));
  EXPECT_THAT(svg, ::testing::Not(HasSubstr("Tested in accordance")));
}

}  // namespace
}  // namespace axiometry::report
