// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/simulate/tracked_machine_text.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace axiometry::app {
namespace {

/// The truth that these options make, or the message why there is none.
struct Said {
  TrackedTruth truth;
  std::string message;
};
Said say(std::initializer_list<std::pair<std::string_view, std::string_view>> list) {
  Said said;
  for (const auto& [name, text] : list) {
    const auto option = std::ranges::find(tracked_options(), name, &TrackedOption::name);
    EXPECT_NE(option, tracked_options().end()) << name;
    if (const auto done = option->apply(text, said.truth); !done) said.message = done.error().message;
  }
  return said;
}

TEST(TrackedOptions, AreReadInTheUnitsThatPeopleUse) {
  const Said said = say({{"--scale", "y=100um/m"},
                         {"--scale", "X=0.01%"},
                         {"--scale", "z=-2e-5"},
                         {"--scale-origin", "1,2,3"},
                         {"--squareness", "C0Y=20urad"},
                         {"--squareness", "B0Z=-0.1mrad"},
                         {"--squareness", "A0Z=10arcsec"},
                         {"--backlash", "x=3um"},
                         {"--repeatability", "0.5um"},
                         {"--repeatability", "z=1um"},
                         {"--growth", "z=0.02mm"},
                         {"--growth-time", "30min"},
                         {"--noise", "0.1um:0.15um/m"},
                         {"--air", "1ppm"},
                         {"--dead-path", "0.5m"},
                         {"--wave", "y/x:800mm:3um:30deg"},
                         {"--beam-break", "120:3.5mm"},
                         {"--beam-break", "7:-1mm:told"}});
  ASSERT_EQ(said.message, "");
  const auto& [machine, tracker] = said.truth;
  EXPECT_NEAR(machine.scale[0].in_um_per_m(), 100.0, 1e-12);
  EXPECT_EQ(machine.scale[1].in_um_per_m(), 100.0);
  EXPECT_NEAR(machine.scale[2].in_um_per_m(), -20.0, 1e-12);
  EXPECT_EQ(machine.origin_mm, (Vector3{1, 2, 3}));
  EXPECT_EQ(machine.C0Y.in_um_per_m(), 20.0);
  EXPECT_NEAR(machine.B0Z.in_um_per_m(), -100.0, 1e-12);
  EXPECT_NEAR(machine.A0Z.in_um_per_m(), 48.48136811, 1e-8);
  EXPECT_EQ(machine.backlash[0].in_um(), 3.0);
  EXPECT_EQ(machine.repeatability[0].in_um(), 0.5);
  EXPECT_EQ(machine.repeatability[2].in_um(), 1.0);
  EXPECT_EQ(machine.growth[2].in_um(), 20.0);
  EXPECT_EQ(machine.growth_time.in_s(), 1800.0);
  EXPECT_EQ(tracker.noise.in_um(), 0.1);
  EXPECT_EQ(tracker.noise_per_length.in_um_per_m(), 0.15);
  EXPECT_EQ(tracker.scale_error.in_um_per_m(), 1.0);
  EXPECT_EQ(tracker.dead_path_mm, 500.0);
  ASSERT_EQ(machine.waves.size(), 1u);
  EXPECT_EQ(machine.waves[0].displaced, 1u);
  EXPECT_EQ(machine.waves[0].moved, 0u);
  EXPECT_EQ(machine.waves[0].phase.in_deg(), 30.0);
  ASSERT_EQ(tracker.breaks.size(), 2u) << "in the order of the readings";
  EXPECT_EQ(tracker.breaks[0].before_reading, 6u);
  EXPECT_TRUE(tracker.breaks[0].told);
  EXPECT_EQ(tracker.breaks[1].jump_mm, 3.5);
}

TEST(TrackedOptions, ThatMakeNoSenseSayWhatWasExpected) {
  EXPECT_EQ(say({{"--scale", "y"}}).message, "found \"y\", expected NAME=VALUE");
  EXPECT_EQ(say({{"--scale", "a=1"}}).message, "found the axis \"a\", expected x, y or z");
  EXPECT_EQ(say({{"--squareness", "C0Z=1urad"}}).message, "found the squareness \"C0Z\", expected C0Y, B0Z or A0Z");
  for (const auto& [name, text] :
       std::initializer_list<std::pair<std::string_view, std::string_view>>{{"--scale", "y=100um"},
                                                                            {"--scale", "y=nan"},
                                                                            {"--squareness", "C0Y=20"},
                                                                            {"--wave", "y:800mm:3um"},
                                                                            {"--wave", "y/x:800mm"},
                                                                            {"--beam-break", "0:1mm"},
                                                                            {"--beam-break", "1:1mm:said"},
                                                                            {"--noise", "1um:1ppm:2"},
                                                                            {"--dead-path", "5"},
                                                                            {"--offset", "1,2"}})
    EXPECT_NE(say({{name, text}}).message, "") << name << " " << text;
}

}  // namespace
}  // namespace axiometry::app
