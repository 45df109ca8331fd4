// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/volumetric/singles/assemble_singles.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "axiometry/app/volumetric/result_model.h"
#include "axiometry/language/language.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::app {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* assembled_machine =
    R"({"chain": "FXYZ", "travel_mm": {"X": [0, 900], "Y": [0, 500], "Z": [-400, 0]}, "tools_mm": {"T": [0, 0, -150]},
        "functional_point_mm": {"X": [0, 0, 0], "Y": [0, 0, 0]}})";
constexpr const char* U_lacks = "EXX: no uncertainty of the instrument is stated: U does not hold it";

/// EXX of two runs that differ by 0.02 µm, whose reversal is 10 µm; without a reading downwards between others unless
/// `whole`.
std::string positioning(bool whole) {
  std::string text = "# axis.name: X\ntarget_mm,run,direction,deviation_um\n";
  for (const int run : {1, 2})
    for (const int target : {0, 300, 600, 900})
      for (const bool up : {true, false})
        if (whole || up || target != 600)
          text += fmt::format("{},{},{},{:.2f}\n", target, run, up ? "up" : "down",
                              (up ? 0.1 : -9.9) + (run == 1 ? 0.01 : -0.01));
  return text;
}

AssembleRequest request_in(const testing_support::TemporaryFolder& folder, const std::string& exx) {
  AssembleRequest request;
  request.machine = folder.written("machine.json", assembled_machine);
  request.items = {{.name = "EXX", .file = folder.written("exx.csv", exx)}};
  request.stands[0] = SingleStand{{0, 0, 0}, "T"};
  return request;
}

TEST(AssembleSingles, RefuseATargetApproachedFromOneSideAmongOthersFromBoth) {
  const testing_support::TemporaryFolder folder;
  EXPECT_TRUE(assemble_singles(request_in(folder, positioning(true))));
  const auto assembled = assemble_singles(request_in(folder, positioning(false)));
  ASSERT_FALSE(assembled);
  EXPECT_THAT(assembled.error().message,
              HasSubstr("found 600 mm approached from one side alone, expected both as at the other targets"));
}

TEST(AssembleSingles, SayWhereNoUncertaintyOfTheInstrumentIsStated) {
  const testing_support::TemporaryFolder folder;
  AssembleRequest request = request_in(folder, positioning(true));
  const auto without = assemble_singles(request);
  ASSERT_TRUE(without) << without.error().message;
  EXPECT_THAT(without->remarks, Contains(U_lacks));
  request.items[0].instrument = error_motions::InstrumentUncertainty{0.4, 0.5};
  const auto with = assemble_singles(request);
  ASSERT_TRUE(with) << with.error().message;
  EXPECT_THAT(with->remarks, Not(Contains(U_lacks)));
}

/// The mean of both directions hides it, in the errors and in all that is made of them.
TEST(AssembleSingles, TellTheReversalThatTheirMeansLose) {
  const testing_support::TemporaryFolder folder;
  AssembleRequest request = request_in(folder, positioning(true));
  request.reversal = volumetric::Reversal::none;
  const auto assembled = assemble_singles(request);
  ASSERT_TRUE(assembled) << assembled.error().message;
  EXPECT_THAT(assembled->remarks, Contains(HasSubstr("displacements differ by direction, by up to 10.00 µm of EXX")));
  const auto kept = kept_model(folder.written("result.json", json::dump(present(*assembled, {}).json, 0)));
  ASSERT_TRUE(kept) << kept.error().message;
  std::vector<std::string> told;
  for (const NamedFinding& note : kept->against) {
    EXPECT_EQ(note.id, "volumetric-singles-remark");
    EXPECT_FALSE(note.serious);
    told.push_back(note.message);
  }
  const std::string of_exx =
      "no uncertainty of the instrument is stated: U does not hold it (EXX, of the errors measured singly, from which "
      "this was made)";
  EXPECT_THAT(told, Contains(of_exx));
  const std::string french = language::translated(of_exx, language::Language::french);
  EXPECT_THAT(french, HasSubstr("aucune incertitude de l’instrument"));
  EXPECT_THAT(french, HasSubstr("(EXX, des erreurs mesurées une à une"));
  EXPECT_THAT(told, Contains(HasSubstr("10.00 µm of EXX")));
}

/// EXX of five runs of which each has a slope of its own, in µm over the travel.
std::string positioning(const std::vector<double>& tilts_um) {
  std::string text = "# axis.name: X\ntarget_mm,run,direction,deviation_um\n";
  for (std::size_t run = 0; run < tilts_um.size(); ++run)
    for (int k = 0; k < 10; ++k)
      for (const bool up : {true, false})
        text += fmt::format("{},{},{},{:.3f}\n", 100 * k, run + 1, up ? "up" : "down",
                            tilts_um[run] * k / 9.0 + 0.02 * ((k * 7 + static_cast<int>(run) * 3 + (up ? 2 : 0)) % 5));
  return text;
}

TEST(AssembleSingles, HoldWhatSlopesOfRunsLeaveOpenOfTheirMean) {
  const testing_support::TemporaryFolder folder;
  const auto largest_u = [&](const std::vector<double>& tilts_um, bool told) {
    const auto assembled = assemble_singles(request_in(folder, positioning(tilts_um)));
    EXPECT_TRUE(assembled) << assembled.error().message;
    const auto of_slopes = Contains(HasSubstr("EXX: the runs have slopes of their own, which differ by"));
    if (told)
      EXPECT_THAT(assembled->remarks, of_slopes);
    else
      EXPECT_THAT(assembled->remarks, Not(of_slopes));
    return assembled->items.front().u_largest;
  };
  const double alike = largest_u({1, 1, 1, 1, 1}, false);
  const double tilted = largest_u({1, 4, -2, 5, -3}, true);
  EXPECT_LT(alike, 0.1);
  // s/√5 of the tilts is 1.6 µm over the travel, k of four degrees of freedom 2.87.
  EXPECT_NEAR(tilted, 0.5 * 2.87 / 2.0 * 1.6, 0.2) << "standard uncertainty at the ends, from the middle";
}

TEST(AssembleSingles, WriteTheInstrumentAndThePlacesIntoTheJson) {
  const testing_support::TemporaryFolder folder;
  AssembleRequest request = request_in(folder, positioning(true));
  request.items[0].instrument = error_motions::InstrumentUncertainty{0.4, 0.5};
  const auto assembled = assemble_singles(request);
  ASSERT_TRUE(assembled) << assembled.error().message;
  const std::string text = json::dump(present(*assembled, {}).json, 0);
  EXPECT_THAT(text, HasSubstr(R"("instrument":{"U_constant":0.4,"U_per_m":0.5})"));
  EXPECT_THAT(text, HasSubstr(R"("at":{"X":{"axes_mm":[0,0,0],"tool":"T","approaches":{}}})"));
  request.stands[0]->approaches = {0.0, -1.0, 1.0};
  const auto stated = assemble_singles(request);
  ASSERT_TRUE(stated) << stated.error().message;
  EXPECT_THAT(json::dump(present(*stated, {}).json, 0), HasSubstr(R"("approaches":{"Y":"down","Z":"up"})"));
}

TEST(AssembleSingles, AreToldWhereTheAxesStoodAndInWhichDirectionTheyCameToRest) {
  const auto plain = parse_stand("Y=500,0,-200.5@T1");
  ASSERT_TRUE(plain) << plain.error().message;
  EXPECT_EQ(plain->first, 1u);
  EXPECT_EQ(plain->second.axes_mm.z, -200.5);
  EXPECT_EQ(plain->second.tool, "T1");
  EXPECT_EQ(plain->second.approaches, volumetric::Approaches{});
  const auto directed = parse_stand("X=0,300:up,-200:down");
  ASSERT_TRUE(directed) << directed.error().message;
  EXPECT_EQ(directed->second.approaches, (volumetric::Approaches{0.0, 1.0, -1.0}));
  EXPECT_EQ(directed->second.tool, "");
  for (const char* wrong : {"", "X=", "W=0,1,2", "X=0,300", "X=0,300,a", "X=0:up,300,-200", "X=0,300:left,-200",
                            "X=0,300:,-200", "X=0,300:up:up,-200"})
    EXPECT_FALSE(parse_stand(wrong)) << wrong;
}

}  // namespace
}  // namespace axiometry::app
