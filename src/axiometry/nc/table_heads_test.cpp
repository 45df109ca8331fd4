// SPDX-License-Identifier: Apache-2.0
//
// What a table says of itself beside its numbers is held against what is asked for: its axis, and what one count is.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "axiometry/language/language.h"
#include "axiometry/nc/axis_table.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {
namespace {

AxisCorrection headed() {
  const std::vector<double> values{0.0, 8.0, 12.0};
  return AxisCorrection::make(AxisKind::linear, {0.0, 10.0, 20.0}, values, values).value();
}

/// Why it is refused, in words that are German and French too; empty where it is read.
std::string why_not_read(std::string_view id, std::string_view text, const AxisTableOptions& options) {
  const auto read = read_table(*axis_table_named(id).value(), text, options);
  if (read) return {};
  for (const auto other : {language::Language::german, language::Language::french})
    EXPECT_TRUE(language::is_known(read.error().message, other)) << read.error().message;
  return read.error().message;
}

TEST(TableHeads, NameTheAxisThatTheyAreOf) {
  for (const char* id : {"fanuc", "fanuc-bidirectional", "acs", "fagor", "twincat-ptp", "siemens-lec"}) {
    AxisTableOptions options;
    options.axis = "Y1";
    options.largest = std::string_view(id).starts_with("fanuc") ? 127 : 0;
    const std::string text = write_table(*axis_table_named(id).value(), headed(), options).value();
    EXPECT_EQ(why_not_read(id, text, options), "") << id;
    options.axis = "y1";
    EXPECT_EQ(why_not_read(id, text, options), "") << id << ": capitals do not matter";
    options.axis = "X";
    EXPECT_EQ(why_not_read(id, text, options), "found the axis \"Y1\", expected \"X\" alone") << id;
  }
}

TEST(TableHeads, SayWhatOneCountIs) {
  for (const char* id : {"fanuc", "pmac"}) {
    AxisTableOptions options;
    options.largest = std::string_view(id).starts_with("fanuc") ? 127 : 0;
    options.resolution = 0.5;
    const AxisTable& table = *axis_table_named(id).value();
    const std::string text = write_table(table, headed(), options).value();
    EXPECT_NE(text.find("0.5 um"), std::string::npos) << text;
    EXPECT_EQ(why_not_read(id, text, options), "") << id;
    options.resolution = 1.0;
    EXPECT_EQ(why_not_read(id, text, options), "found a table in counts of 0.5 µm, expected 1 µm (--resolution)") << id;
    options.resolution = 0.5;
    std::string other = text;
    other.replace(other.find("0.5 um"), 6, "0.5 arcsec");
    EXPECT_NE(why_not_read(id, other, options).find("counts of 0.5 ″"), std::string::npos) << id;
    other = text;
    other.replace(other.find("0.5 um"), 6, "half");
    EXPECT_NE(why_not_read(id, other, options).find("a number and um or arcsec"), std::string::npos) << id;
    other = text;
    other.replace(other.find("0.5 um"), 6, "0.500000 um");
    EXPECT_EQ(why_not_read(id, other, options), "") << id;
  }
}

TEST(TableHeads, OfPmacHaveARangeThatFitsTheEntries) {
  AxisTableOptions options;
  options.resolution = 0.1;
  std::string text = write_table(*axis_table_named("pmac").value(), headed(), options).value();
  text.erase(text.find("; one count"), text.find('\n', text.find("; one count")) + 1 - text.find("; one count"));
  EXPECT_EQ(why_not_read("pmac", text, options), "") << "a table of a control says no count";
  options.resolution = 1.0;
  EXPECT_NE(why_not_read("pmac", text, options).find("is one count another amount (--resolution)?"), std::string::npos);
}

}  // namespace
}  // namespace axiometry::nc
