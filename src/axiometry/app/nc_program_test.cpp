// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/nc_program.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace axiometry::app {
namespace {

constexpr std::string_view plan_text = R"({"axis": {"name": "X", "kind": "linear"}, "cycle": "standard",
 "targets": [0, 10, 20], "runs": 2, "overrun": 5, "feed": 1000, "dwell_s": 3, "further": [{"axis": {"name": "Y",
 "kind": "linear"}, "cycle": "step", "targets": [1, 2], "runs": 1, "overrun": 5, "feed": 1000, "dwell_s": 3}]})";

class NcProgram : public testing::Test {
 protected:
  NcProgram() : plan_(testing::TempDir() + "nc_program_plan.json") { std::ofstream(plan_) << plan_text; }

  std::string reason(NcRequest request) const {
    request.plan = plan_;
    const auto program = nc_program(request);
    return program ? "" : program.error().to_string();
  }

  std::string plan_;
};

TEST_F(NcProgram, WalksThePartOfThePlanThatIsAskedFor) {
  const auto first = nc_program({.plan = plan_, .dialect = "grbl"});
  const auto second = nc_program({.plan = plan_, .dialect = "grbl", .part = 2});
  ASSERT_TRUE(first);
  ASSERT_TRUE(second);
  EXPECT_NE(first->find("AXIS X"), std::string::npos);
  EXPECT_NE(second->find("AXIS Y"), std::string::npos);
}

TEST_F(NcProgram, SaysWhatThereIsInsteadOfWhatIsNot) {
  EXPECT_EQ(reason({.dialect = "grbl", .part = 3}), plan_ + ": found part 3 asked for, expected 1 to 2");
  EXPECT_EQ(reason({.dialect = "grbl", .part = 0}), plan_ + ": found part 0 asked for, expected 1 to 2");
  EXPECT_EQ(reason({.dialect = "linuxnc"}), "found the unknown dialect \"linuxnc\", expected perhaps linuxcnc");
  EXPECT_EQ(reason({.dialect = "grbl", .options = {.trigger_m_code = 3}}),
            plan_ + ": found M3 as trigger, expected an M code that leaves program, spindle and tool alone");
}

TEST_F(NcProgram, DoesNotTakeThePlacesOfThePlanOrOfAFileWhenItFails) {
  const std::string output = testing::TempDir() + "nc_program_test.nc";
  EXPECT_FALSE(write_nc_program({.plan = plan_, .dialect = "grbl"}, plan_));
  EXPECT_FALSE(write_nc_program({.plan = plan_, .dialect = "grbl", .part = 9}, output));
  EXPECT_FALSE(std::filesystem::exists(output));
  EXPECT_TRUE(write_nc_program({.plan = plan_, .dialect = "grbl"}, output));
  std::ostringstream text;
  text << std::ifstream(output).rdbuf();
  EXPECT_EQ(text.str(), *nc_program({.plan = plan_, .dialect = "grbl"}));
  std::filesystem::remove(output);
  std::ostringstream kept;
  kept << std::ifstream(plan_).rdbuf();
  EXPECT_EQ(kept.str(), plan_text);
}

}  // namespace
}  // namespace axiometry::app
