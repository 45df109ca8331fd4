// SPDX-License-Identifier: Apache-2.0
//
// What a table says of itself beside its numbers is held against what is asked for: its axis, and what one count is.
#include <gtest/gtest.h>

#include <string>
#include <tuple>
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
    EXPECT_EQ(why_not_read(id, text, options), "found a table in counts of 0.5 µm, expected 1 µm") << id;
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
  EXPECT_NE(why_not_read("pmac", text, options).find("is one count another amount?"), std::string::npos);
}

TEST(TableHeads, TellTheAxisAndTheCountWhereNobodyElseDoes) {
  for (const char* id : {"fanuc", "fanuc-bidirectional", "acs", "fagor", "twincat-ptp", "siemens-lec", "siemens-cec",
                         "pmac", "heidenhain", "mach4", "mitsubishi", "twincat-cnc", "aerotech"}) {
    const AxisTable& table = *axis_table_named(id).value();
    AxisTableOptions options;
    options.axis = "Y";
    if (std::string_view(id).starts_with("fanuc")) options.largest = 127;
    if (table.uses.resolution) options.resolution = 0.5;
    const std::string text = write_table(table, headed(), options).value();
    const AxisCorrection stated = read_table(table, text, options).value();
    AxisTableOptions untold;
    untold.axis_told = untold.resolution_told = false;
    if (std::string_view(id) == "mitsubishi") untold.resolution = 0.5;  // its tables do not say it
    const auto read = read_table(table, text, untold);
    ASSERT_TRUE(read) << id << ": " << read.error().message;
    EXPECT_EQ(read->values(Direction::up), stated.values(Direction::up)) << id;
    EXPECT_EQ(read->positions(), stated.positions()) << id;
  }
  AxisTableOptions untold;
  untold.axis_told = false;
  const AxisTable& lec = *axis_table_named("siemens-lec").value();
  std::string two = write_table(lec, headed(), {}).value();
  two.replace(two.find("[0,1,X]"), 7, "[0,1,Y]");
  EXPECT_EQ(why_not_read("siemens-lec", two, untold), "found the axis \"Y\", expected \"X\" alone")
      << "a table is of one axis";
}

TEST(TableHeads, OfOtherMakersNameTheirArraysAsTheyLike) {
  for (const auto& [id, ours, theirs] :
       {std::tuple("acs", "CompX", "CompTable"), std::tuple("twincat-ptp", "X_Compensation", "Table_Compensation")}) {
    std::string text = write_table(*axis_table_named(id).value(), headed(), {}).value();
    for (std::size_t at = text.find(ours); at != text.npos; at = text.find(ours, at))
      text.replace(at, std::string_view(ours).size(), theirs);
    EXPECT_NE(why_not_read(id, text, {}), "") << "here it is named for its axis";
    text.erase(0, text.find('\n') + 1);  // the sentence about the sign, which only tables of here have
    EXPECT_EQ(why_not_read(id, text, {}), "") << id;
  }
}

}  // namespace
}  // namespace axiometry::nc
