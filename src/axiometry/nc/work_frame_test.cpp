// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/work_frame.h"

#include <gtest/gtest.h>

#include <map>

#include "axiometry/nc/dialect.h"
#include "tests/support/nc_controls.h"

namespace axiometry::nc {
namespace {

Plan framed_plan() {
  Plan plan;
  plan.axis = {.name = "X", .kind = AxisKind::linear};
  plan.targets = {Position::native(0), Position::native(10), Position::native(20)};
  plan.overrun = Position::native(2);
  plan.feed = 1000;
  plan.dwell = Duration::s(1);
  return plan;
}

Result<std::string> framed(std::string_view dialect, const std::string& frame) {
  const Plan plan = framed_plan();
  return find_dialect(dialect)->write({&plan, 1}, {.frame = frame});
}

/// The frame of every move, which is one; "several" where they differ.
std::string frame_of_moves(std::string_view dialect, const std::string& program) {
  const auto trace = testing_support::run_program(dialect, program);
  for (const auto& visit : trace.visits)
    if (visit.frame != trace.visits.front().frame) return "several";
  return trace.visits.front().frame;
}

TEST(WorkFrames, AreLeftAsTheyAreUnlessOneIsChosen) {
  for (const Dialect* dialect : dialect_table()) {
    const auto program = framed(dialect->id, "active");
    ASSERT_TRUE(program) << dialect->id;
    EXPECT_EQ(frame_of_moves(dialect->id, *program), "") << dialect->id;
    EXPECT_NE(program->find("POSITIONS IN THE WORK OFFSET THAT IS ACTIVE"), std::string::npos);
  }
}

TEST(WorkFrames, HoldForEveryMoveOfTheirControls) {
  const struct {
    const char *dialect, *asked, *frame, *told;
  } cases[] = {
      {"fanuc", "G54", "54", "POSITIONS IN THE WORK OFFSET G54, OTHER SHIFTS MUST BE OFF"},
      {"fanuc", "g54.1p48", "54.1P48", "WORK OFFSET G54.1 P48,"},
      {"haas", "G154 P99", "154P99", "WORK OFFSET G154 P99,"},
      {"iso6983", "G59", "59", "WORK OFFSET G59,"},
      {"mitsubishi", "G55", "55", "WORK OFFSET G55,"},
      {"mazak-eia", "G54.1 P1", "54.1P1", "WORK OFFSET G54.1 P1,"},
      {"okuma", "G15H200", "15H200", "WORK OFFSET G15 H200,"},
      {"okuma", "machine", "15H0", "POSITIONS IN THE COORDINATES OF THE MACHINE, BY G15 H0"},
      {"siemens-840d", "G500", "500", "WORK OFFSET G500,"},
      {"siemens-840d", "g599", "599", "WORK OFFSET G599,"},
      {"siemens-840d", "machine", "machine", "POSITIONS IN THE COORDINATES OF THE MACHINE, BY SUPA WHERE ABSOLUTE"},
      {"heidenhain", "Machine", "machine", "POSITIONS IN THE COORDINATES OF THE MACHINE, BY M91 WHERE ABSOLUTE"},
      {"fagor", "machine", "machine", "BY G53 WHERE ABSOLUTE"},
      {"fagor", "G54", "54", "WORK OFFSET G54,"},
      {"linuxcnc", "G59.3", "59.3", "WORK OFFSET G59.3,"},
      {"linuxcnc", "machine", "machine", "BY G53 WHERE ABSOLUTE"},
      {"grbl", "machine", "machine", "BY G53 WHERE ABSOLUTE"},
      {"grbl", "G57", "57", "WORK OFFSET G57,"},
  };
  for (const auto& [dialect, asked, frame, told] : cases) {
    const auto program = framed(dialect, asked);
    ASSERT_TRUE(program) << dialect << " " << asked << ": " << program.error().message;
    EXPECT_EQ(frame_of_moves(dialect, *program), frame) << *program;
    EXPECT_NE(program->find(told), std::string::npos) << *program;
  }
}

TEST(WorkFrames, AreRefusedWhereTheControlHasThemNot) {
  const std::map<std::pair<std::string, std::string>, std::string> refusals = {
      {{"fanuc", "machine"},
       "found the coordinates of the machine asked for, expected one of active, G54…G59, G54.1 P1…G54.1 P48: "
       "G53 may drive at rapid there; put a work offset at zero instead"},
      {{"fanuc", "G53"}, "found the frame \"G53\", expected one of active, G54…G59, G54.1 P1…G54.1 P48"},
      {{"siemens-840d", "G58"}, "found the frame \"G58\", expected one of active, machine, G54…G57, G500, G505…G599"},
      {{"heidenhain", "G54"}, "found the frame \"G54\", expected one of active, machine"},
  };
  for (const auto& [asked, message] : refusals) {
    const auto program = framed(asked.first, asked.second);
    ASSERT_FALSE(program) << asked.first << " " << asked.second;
    EXPECT_EQ(program.error().message, message);
  }
  for (const char* odd : {"", "G", "G0", "G054", "G54P", "G54.1", "G54.1P0", "G54.1P49", "G54)M3", "54", "G5 4 5"})
    EXPECT_FALSE(framed("fanuc", odd)) << odd;
}

TEST(LineEnds, AreThoseOfTheControl) {
  for (const Dialect* dialect : dialect_table()) {
    const bool crlf = testing_support::run_program(dialect->id, *framed(dialect->id, "active")).crlf;
    const bool wanted = dialect->id == "heidenhain" || dialect->id == "okuma" || dialect->id == "fagor" ||
                        dialect->id == "haas" || dialect->id == "mazak-eia";
    EXPECT_EQ(crlf, wanted) << dialect->id;
    EXPECT_EQ(dialect->manual.find("CR LF") != std::string_view::npos, wanted) << dialect->id;
  }
}

TEST(Triggers, AreOnlyTheMCodesThatSteerNothing) {
  const Plan plan = framed_plan();
  const auto refusal_of = [&](std::string_view dialect, unsigned code) {
    const auto program = find_dialect(dialect)->write({&plan, 1}, {.trigger_m_code = code});
    return program ? std::string() : program.error().message;
  };
  EXPECT_EQ(refusal_of("fanuc", 19),
            "found M19 as trigger, which steers the spindle, expected one of M7…M8, M24…M28, M57, M150…M189");
  EXPECT_EQ(refusal_of("heidenhain", 128),
            "found M128 as trigger, which may steer anything on this control, expected one of M8, M24…M28, M57");
  for (const Dialect* dialect : dialect_table())
    for (unsigned code : {0u,  1u,  2u,  3u,  4u,  5u,  6u,  10u, 13u, 17u, 19u, 20u, 29u,  30u,        40u,
                          41u, 42u, 45u, 48u, 60u, 70u, 89u, 91u, 94u, 96u, 98u, 99u, 203u, 99'999'999u})
      EXPECT_NE(refusal_of(dialect->id, code), "") << dialect->id << " M" << code;
  EXPECT_NE(refusal_of("fanuc", 198), "") << "calls a program";
  for (unsigned code : {107u, 114u, 118u, 126u, 127u, 129u, 136u, 140u, 141u, 144u, 150u, 200u})
    EXPECT_NE(refusal_of("heidenhain", code), "") << "M" << code;
  for (unsigned code : {20u, 22u, 23u, 25u, 26u}) EXPECT_NE(refusal_of("siemens-840d", code), "") << "punching";
  for (const char* dialect : {"fanuc", "fagor", "mazak-eia", "mitsubishi", "iso6983", "siemens-840d", "heidenhain"})
    for (unsigned code : {58u, 59u}) EXPECT_NE(refusal_of(dialect, code), "") << "surface speed (RS-274-D) " << dialect;
  EXPECT_EQ(refusal_of("siemens-840d", 27), "");
  EXPECT_EQ(refusal_of("linuxcnc", 199), "");
}

/// An instrument waits for a rise, and an output that is on already does not rise.
TEST(Triggers, OfOutputsThatStayOnAreSwitchedOffBehindTheDwell) {
  const Plan plan = framed_plan();
  const auto codes_of = [&](std::string_view dialect, unsigned code) {
    const auto program = find_dialect(dialect)->write({&plan, 1}, {.trigger_m_code = code});
    EXPECT_TRUE(program) << dialect << " M" << code;
    for (const testing_support::Visit& visit : testing_support::run_program(dialect, program ? *program : "").visits)
      if (!visit.m_codes.empty()) return visit.m_codes;
    return std::vector<unsigned>();
  };
  using Codes = std::vector<unsigned>;
  for (const Dialect* dialect : dialect_table()) EXPECT_EQ(codes_of(dialect->id, 8), (Codes{8, 9})) << dialect->id;
  EXPECT_EQ(codes_of("haas", 51), (Codes{51, 61}));
  EXPECT_EQ(codes_of("haas", 52), (Codes{52, 62}));
  EXPECT_EQ(codes_of("haas", 21), (Codes{21}));
  EXPECT_EQ(codes_of("fanuc", 57), (Codes{57})) << "the builder's";
  for (const Dialect* dialect : dialect_table()) {
    const auto off = find_dialect(dialect->id)->write({&plan, 1}, {.trigger_m_code = 9});
    ASSERT_FALSE(off) << dialect->id;
    EXPECT_TRUE(off.error().message.starts_with("found M9 as trigger, which only switches an output off, expected"));
  }
}

}  // namespace
}  // namespace axiometry::nc
