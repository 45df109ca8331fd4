// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/text/other_tables.h"

#include <gmock/gmock.h>

#include "axiometry/formats/format.h"

namespace axiometry::formats {
namespace {

using testing::HasSubstr;

std::string refusal_of_table(std::string_view text) {
  const auto format = recognise(text);
  return format ? std::string((*format)->id) : format.error().message;
}

TEST(OtherTables, AreNamedAsWhatTheyAre) {
  EXPECT_THAT(refusal_of_table("axis,record,target,target_unit,name,value,U,unit,clause\nX,parameter,,,A,1,,um,3.27\n"),
              HasSubstr("found a report as CSV"));
  EXPECT_THAT(refusal_of_table("file,test,axis,kind,unit,conforming,A\nx.csv,,X,linear,um,yes,9.5\n"),
              HasSubstr("found a table of the results of many tests"));
  EXPECT_THAT(refusal_of_table("# of the hall\nname;kind;travel_up_to;unit;A\nMill;linear;500;um;16\n"),
              HasSubstr("beside which such a file is given"));
  EXPECT_THAT(refusal_of_table("# lengths\nline,target,direction,run,length_difference_mm,segment,time_s\n"
                               "xy,1,up,1,0,0,31.34\n"),
              HasSubstr("axiometry tracking evaluate"));
  EXPECT_THAT(refusal_of_table("station,tool,segment,x_mm,y_mm,z_mm,length_mm\nS1,T1,1,1,2,3,4\n"),
              HasSubstr("axiometry volumetric identify"));
}

TEST(OtherTables, AreNoTablesOfReadings) {
  EXPECT_EQ(refusal_of_table("target_mm,direction,run,deviation_um\n1,up,1,0.5\n2,up,1,0.7\n"), "csv-long");
  EXPECT_TRUE(check_no_other_table(""));
  EXPECT_TRUE(check_no_other_table("name,kind,target_mm,run,deviation_um\n"));
}

}  // namespace
}  // namespace axiometry::formats
