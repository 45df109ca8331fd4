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

TEST(PngWriter, SaysOfAnIssuedReportWhereTheTrailEndedBefore) {
  const auto example = testing::table_2();
  report::Subject issued = example.subject();
  issued.trail_head = "17:3f2a9c0b1d2e4f56";
  const std::string bare = written("png", example);
  const std::string png = find_writer("png")->write(issued, example.options).value();
  const std::string data = std::string("tEXtAudit trail before issue") + '\0' + issued.trail_head;
  ASSERT_EQ(png.substr(37, data.size()), data);
  EXPECT_EQ(big_endian_at(png, 33), data.size() - 4);
  EXPECT_EQ(big_endian_at(png, 37 + data.size()), 0x9e85fe88u) << "by zlib";
  EXPECT_EQ(png.substr(0, 33) + png.substr(37 + data.size() + 4), bare) << "all else stays as it was";
}

TEST(SvgWriter, SaysOfAnIssuedReportWhereTheTrailEndedBefore) {
  const auto example = testing::table_2();
  report::Subject issued = example.subject();
  issued.trail_head = "17:3f2a9c0b1d2e4f56";
  const std::string said = "<metadata>Audit trail before issue: 17:3f2a9c0b1d2e4f56</metadata>\n";
  std::string svg = find_writer("svg")->write(issued, example.options).value();
  ASSERT_THAT(svg, HasSubstr("</desc>\n" + said));
  EXPECT_EQ(svg.erase(svg.find(said), said.size()), written("svg", example)) << "all else stays as it was";
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
  example.assessment.findings.push_back(
      {"number-of-approaches", "5.3.2", iso230_2::Severity::departure, "only four runs"});
  const std::string svg = written("svg", example);
  EXPECT_THAT(svg, HasSubstr("not a test in accordance with it (departs from 5.3.2)"));
  EXPECT_THAT(svg, ::testing::Not(HasSubstr("Tested in accordance")));
}

}  // namespace
}  // namespace axiometry::report
