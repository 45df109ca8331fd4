// SPDX-License-Identifier: Apache-2.0
//
// Validation on files that real test stands have written. Their licences do not allow copies here: the
// test looks for them in the folder that AXIOMETRY_PUBLIC_DATA names, else in ../shared/data beside the
// source folder, and is skipped where they are not. The expected figures come from an independent
// evaluation in decimal arithmetic, printed in mm.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "axiometry/formats/format.h"
#include "axiometry/standards/iso230_2/assessment/assessment.h"

namespace axiometry::iso230_2 {
namespace {

std::filesystem::path data_folder() {
  const char* named = std::getenv("AXIOMETRY_PUBLIC_DATA");
  return named ? std::filesystem::path(named) : std::filesystem::path(AXIOMETRY_SOURCE_DIR) / ".." / "shared" / "data";
}

struct Published {
  const char* file;
  const char* format;
  double A, E, M, R, B;  // mm
  double half_digit;     // mm
};

void PrintTo(const Published& published, std::ostream* out) { *out << published.file; }

class PublicData : public testing::TestWithParam<Published> {};

TEST_P(PublicData, GivesTheFiguresOfTheOracle) {
  const Published& expected = GetParam();
  const std::filesystem::path path = data_folder() / expected.file;
  if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
  std::ostringstream bytes;
  bytes << std::ifstream(path, std::ios::binary).rdbuf();
  const auto format = formats::recognise(bytes.str().substr(0, 65536));
  ASSERT_TRUE(format) << format.error().to_string();
  EXPECT_EQ((*format)->id, expected.format);
  const auto test = (*format)->read(bytes.str());
  ASSERT_TRUE(test) << test.error().to_string();
  const AxisParameters p = assess(*test).evaluation.parameters;
  const auto mm = [](const std::optional<Deviation>& x) { return x ? x->in_native() / 1000.0 : NAN; };
  EXPECT_NEAR(mm(p.A), expected.A, expected.half_digit);
  EXPECT_NEAR(mm(p.E), expected.E, expected.half_digit);
  EXPECT_NEAR(mm(p.M), expected.M, expected.half_digit);
  EXPECT_NEAR(mm(p.R), expected.R, expected.half_digit);
  EXPECT_NEAR(mm(p.B), expected.B, expected.half_digit);
}

INSTANTIATE_TEST_SUITE_P(
    Instruments, PublicData,
    testing::Values(
        Published{"ecmc/psi_stage.dat", "ecmc-dat", .00008881, .00003680, .00002770, .00006882, .00001220, 0.51e-8},
        Published{"ecmc/slit.dat", "ecmc-dat", .021969, .012940, .009242, .014336, .004485, 0.51e-6},
        Published{"ecmc/slit_other_header.dat", "ecmc-dat", .021969, .012940, .009242, .014336, .004485, 0.51e-6},
        Published{"ecmc/target_z.dat", "ecmc-dat", .036853, .035279, .033364, .006418, .002364, 0.51e-6},
        Published{"ecmc/cfg_tool_demo_raw.csv", "ecmc-cfg-csv", .007776, .006558, .004087, .004461, .003206, 0.51e-6},
        Published{"formats/renishaw_like_SYNTHETIC.rtl", "renishaw-rtl", .135271, .122847, .093653, .055161, .033576,
                  0.51e-6}),
    [](const auto& of) { return std::filesystem::path(of.param.file).stem().string(); });

}  // namespace
}  // namespace axiometry::iso230_2
