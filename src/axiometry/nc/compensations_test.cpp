// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "axiometry/nc/axis_table.h"
#include "axiometry/nc/table_text.h"
#include "tests/support/cpu_time.h"

namespace axiometry::nc {
namespace {

AxisCorrection correction_of(AxisKind kind, std::vector<double> positions, std::vector<double> up,
                             std::vector<double> down) {
  return AxisCorrection::make(kind, std::move(positions), std::move(up), std::move(down)).value();
}

AxisTableOptions options_of(const AxisTable& table, AxisKind kind) {
  AxisTableOptions options;
  options.kind = kind;
  options.axis = kind == AxisKind::linear ? "X" : "A";
  if (table.limits.cross_only) options.axis = "Y", options.output_axis = "X";
  if (table.uses.steps_per_unit) options.steps_per_unit = 80.0;
  if (table.id.starts_with("fanuc")) options.magnification = 4;
  if (table.id == "pmac") options.resolution = 0.1;
  if (table.id == "haas") options.resolution = 0.5;
  return options;
}

/// Half of the last digit, or of the last count, that each format has.
double rounding_of(const AxisTable& table, const AxisTableOptions& options) {
  const bool is_linear = options.kind == AxisKind::linear;
  if (table.id.starts_with("fanuc")) return 0.51 * options.magnification * options.resolution;
  if (table.id == "mitsubishi") return 0.26 * options.magnification * options.resolution;
  if (table.id == "haas") return 1.28;
  if (table.id == "pmac") return options.resolution / 16.0;
  if (table.id == "fagor" && options.in_inch) return 0.13;
  if (table.id == "twincat-cnc" || table.id == "fagor" || table.id == "axeserr") return is_linear ? 0.051 : 0.181;
  if (table.limits.points == 2) return is_linear ? 0.2 : 0.6;  // six decimals of 80 steps per unit
  return 0.003;
}

/// A table that the control can hold, 0 at the reference point.
AxisCorrection fitting(const AxisTable& table, AxisKind kind, bool each_way) {
  if (table.limits.points == 2)
    return correction_of(kind, {-20.0, 20.0}, {-6.0, 6.0},
                         each_way ? std::vector{-17.5, -5.5} : std::vector{-6.0, 6.0});
  std::vector<double> positions, up, down;
  const int first = table.limits.origin == TableOrigin::last ? -6 : kind == AxisKind::rotary ? 0 : -4;
  const int last = table.limits.origin == TableOrigin::last ? 0 : kind == AxisKind::rotary ? 12 : 4;
  const double step = table.limits.step_native > 0.0 ? table.limits.step_native : kind == AxisKind::rotary ? 30.0 : 5.0;
  for (int k = first; k <= last; ++k) {
    positions.push_back(step * k);
    const double turn = kind == AxisKind::rotary ? 2.0 * 3.14159265358979 * k / 12.0 : 0.7 * k;
    up.push_back(20.0 * std::sin(turn));
    down.push_back(each_way ? 12.3 * std::sin(turn) + 7.7 * std::cos(turn) - 13.4 : up.back());
  }
  return correction_of(kind, std::move(positions), std::move(up), std::move(down));
}

/// Calls `then(table, options, correction)` with everything that each control can hold.
void for_all(auto&& then) {
  for (const AxisTable* table : axis_table_table())
    for (const AxisKind kind : {AxisKind::linear, AxisKind::rotary}) {
      if (kind == AxisKind::linear ? !table->limits.linear : !table->limits.rotary) continue;
      for (const bool each_way : {false, true}) {
        if (each_way && table->curves == TableCurves::both_ways) continue;
        SCOPED_TRACE(std::string(table->id) + (kind == AxisKind::linear ? " linear" : " rotary") +
                     (each_way ? " each way" : ""));
        then(*table, options_of(*table, kind), fitting(*table, kind, each_way));
      }
    }
}

std::string table_text_of(const AxisTable& table, const AxisCorrection& correction, const AxisTableOptions& options) {
  const auto text = table.write(correction, options);
  if (!text) ADD_FAILURE() << text.error().message;
  return text.value_or("");
}

void expect_near(const AxisCorrection& found, const AxisCorrection& expected, double tolerance, double place) {
  ASSERT_EQ(found.positions().size(), expected.positions().size());
  for (std::size_t k = 0; k < found.positions().size(); ++k) {
    EXPECT_NEAR(found.positions()[k], expected.positions()[k], place);
    for (const Direction direction : {Direction::up, Direction::down})
      EXPECT_NEAR(found.values(direction)[k], expected.values(direction)[k], tolerance) << found.positions()[k];
  }
}

std::vector<std::string> lines_in(const std::string& text) {
  std::vector<std::string> lines;
  for (const TableLine& line : lines_of(text)) lines.emplace_back(line.text);
  return lines;
}

std::string joined_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

TEST(Compensations, EachTableSaysWhatItIs) {
  std::set<std::string_view> ids, titles;
  for (const AxisTable* table : axis_table_table()) {
    SCOPED_TRACE(table->id);
    EXPECT_TRUE(ids.insert(table->id).second);
    EXPECT_TRUE(titles.insert(table->title).second);
    EXPECT_TRUE(table->extension.starts_with('.'));
    for (const std::string_view text : {table->sign, table->loading, table->verified}) {
      EXPECT_FALSE(text.empty());
      EXPECT_TRUE(text.ends_with('.'));
    }
    EXPECT_TRUE(table->inferred.empty() || table->inferred.ends_with('.'));
    EXPECT_TRUE(axis_table_named(table->id).has_value());
  }
  EXPECT_GE(ids.size(), 20u);
}

TEST(Compensations, WhatIsWrittenIsReadWithinItsRounding) {
  for_all([](const AxisTable& table, const AxisTableOptions& options, const AxisCorrection& correction) {
    const std::string text = table_text_of(table, correction, options);
    const auto found = table.read(text, options);
    ASSERT_TRUE(found) << found.error().to_string() << '\n' << text;
    expect_near(*found, correction, rounding_of(table, options), 1e-5);
    EXPECT_EQ(table.write(*found, options), text) << "written again";
    EXPECT_EQ(text.find('\t'), std::string::npos);
    EXPECT_TRUE(text.ends_with('\n'));
    if (table.limits.points == 2) {
      EXPECT_NE(text.find("range -20.0 to 20.0"), std::string::npos);
    }
  });
}

/// In counts of 3.6 ″ (0.001°), 1.8 ″ and the like sums of doubles would not come back to 0 where whole numbers do.
TEST(Compensations, ATurnClosesWhateverOneCountStandsFor) {
  for_all([](const AxisTable& table, AxisTableOptions options, const AxisCorrection& correction) {
    if (options.kind != AxisKind::rotary || !table.uses.resolution) return;
    options.magnification = table.uses.magnification && !table.uses.largest ? 4 : 1;
    if (table.uses.largest) options.largest = 127;
    for (const double resolution : {3.6, 1.8, 0.36, 0.1, 0.6}) {
      SCOPED_TRACE(resolution);
      options.resolution = resolution;
      const std::string text = table_text_of(table, correction, options);
      const auto found = read_table(table, text, options);
      ASSERT_TRUE(found) << found.error().to_string() << '\n' << text;
      expect_near(*found, correction, rounding_of(table, options), 1e-5);
      if (table.limits.closes) {
        constexpr double rounding = 1e-9;  // of sums of doubles
        EXPECT_NEAR(found->values(Direction::up).front(), found->values(Direction::up).back(), rounding);
        EXPECT_NEAR(found->values(Direction::down).front(), found->values(Direction::down).back(), rounding);
      }
    }
  });
}

TEST(Compensations, InchesAreThoseOfTheControl) {
  for_all([](const AxisTable& table, AxisTableOptions options, const AxisCorrection& correction) {
    if (options.kind == AxisKind::rotary) return;
    const std::string in_mm = table_text_of(table, correction, options);
    options.in_inch = true;
    const auto text = write_table(table, correction, options);
    if (table.limits.points == 2 || table.id == "axeserr" || table.id.starts_with("fanuc")) {
      EXPECT_FALSE(table.uses.inch) << "counts in mm alone";
    }
    if (!table.uses.inch) {
      EXPECT_FALSE(text);
      EXPECT_FALSE(read_table(table, in_mm, options));
      return;
    }
    ASSERT_TRUE(text) << text.error().message;
    EXPECT_NE(*text, in_mm);
    const auto found = table.read(*text, options);
    ASSERT_TRUE(found) << found.error().to_string() << '\n' << *text;
    expect_near(*found, correction, rounding_of(table, options), table.id == "fagor" ? 2e-4 : 1e-5);
  });
}

TEST(Compensations, APositiveCorrectionIsSpelledAsTheControlTakesIt) {
  const std::map<std::string_view, std::vector<std::string_view>> by_hand = {
      {"acs", {"\nCompX(1)=0.010000\n", "MAP(APOS(0),CompX,0.0,10.0)"}},
      {"aerotech", {"SAMPDIST=10.0 OFFSET=0.0\n0.0000\n10.0000\n"}},
      {"axeserr", {"\n10.0000, -0.0100, -0.0100\n"}},
      {"fagor", {"\nP002 10.0000 -0.0100 0.0000\n"}},
      {"fanuc", {"\nN10001P5\n", "\n3624 = 10.0\n"}},
      {"fanuc-bidirectional", {"\nN10001P5\n", "\nN10003P5\n", "\n3627 = 0\n"}},
      {"haas", {"\n1 0\n2 4\n"}},
      {"heidenhain", {"\n1 10.000000 -0.010000 -0.010000\n"}},
      {"kflop", {"3\n10.0\n0.0\n0,0.000000\n1,10.010000\n"}},
      {"linuxcnc", {"\n10.000000 9.990000 9.990000\n"}},
      {"linuxcnc-type1", {"\n10.000000 0.010000 0.010000\n"}},
      {"mach4", {"Map = Positive\n1 0.000000\n2 0.010000\n"}},
      {"mitsubishi", {"\n#4101 20\n"}},
      {"pmac", {"#1 DEFINE COMP 3,30000\n160\n"}},
      {"siemens-cec", {"\n$AN_CEC[0,1]=-0.010000\n", "\n$AN_CEC_DIRECTION[0]=0\n"}},
      {"siemens-lec", {"\n$AA_ENC_COMP[0,1,X]=-0.010000\n", "\n$AA_ENC_COMP_STEP[0,X]=10.0\n"}},
      {"twincat-cnc", {"\nkw.ssfk.table[1].pos -100\n", "\nkw.ssfk.table[1].neg -100\n"}},
      {"twincat-ptp", {"(Position := 10.000000, Compensation := 0.010000),\n"}},
      {"grblhal", {"\n$100=80.080000\n", "\n$160=0.050000\n"}},
      {"marlin", {"\nM92 X80.080000\nM425 F1 X0.050000\nM500\n"}},
      {"marlin-skew", {"\nM852 I-0.00100000\nM500\n"}},
      {"smoothie", {"\nalpha_steps_per_mm 80.080000\nalpha_backlash_mm 0.050000\n"}},
  };
  for (const AxisTable* table : axis_table_table()) {
    SCOPED_TRACE(table->id);
    ASSERT_TRUE(by_hand.contains(table->id));
    AxisTableOptions options;
    if (table->uses.steps_per_unit) options.steps_per_unit = 80.0;
    if (table->id.starts_with("fanuc")) options.magnification = 2;
    const std::vector<double> up = {0.0, 10.0, 20.0};
    if (table->limits.cross_only) options.axis = "Y", options.output_axis = "X";
    const AxisCorrection correction =
        table->limits.cross_only    ? correction_of(AxisKind::linear, {0.0, 20.0}, {0.0, 20.0}, {0.0, 20.0})
        : table->limits.points == 2 ? correction_of(AxisKind::linear, {0.0, 20.0}, {0.0, 20.0}, {-50.0, -30.0})
        : table->id == "haas"       ? correction_of(AxisKind::linear, {-12.7, 0.0}, {10.16, 0.0}, {10.16, 0.0})
                                    : correction_of(AxisKind::linear, {0.0, 10.0, 20.0}, up, up);
    const std::string text = table_text_of(*table, correction, options);
    for (const std::string_view part : by_hand.at(table->id)) {
      EXPECT_NE(('\n' + text).find(part), std::string::npos) << part << "\nin\n" << text;
    }
  }
}

TEST(Compensations, DirectionsAreNotExchanged) {
  const AxisCorrection up_alone =
      correction_of(AxisKind::linear, {0.0, 10.0, 20.0}, {0.0, 8.0, 12.0}, {0.0, 0.0, -4.0});
  for (const auto& [id, part] : std::map<std::string_view, std::string_view>{
           {"linuxcnc-type1", "10.000000 0.008000 0.000000\n"},
           {"axeserr", "10.0000, -0.0080, 0.0000\n"},
           {"fagor", "P002 10.0000 -0.0080 0.0000\n"},
           {"heidenhain", "2 20.000000 0.004000 -0.012000\n"},
           {"pmac", "#1 DEFINE BLCOMP 3,30000\n128\n256\n0\nI186=0\n"},
           {"siemens-cec", "$AN_CEC[1,2]=0.004000\n"},
           {"twincat-cnc", "kw.ssfk.table[2].neg 40\n"},
       }) {
    const std::string text = table_text_of(*axis_table_named(id).value(), up_alone, {});
    EXPECT_NE(text.find(part), std::string::npos) << part << "\nin\n" << text;
  }
}

/// By the manuals BLCOMP is 0 at home, and its last entry stands for home: both agree where Ix86 has the reversal.
TEST(Compensations, TheReversalAtHomeOfPmacIsItsConstant) {
  const AxisTable& pmac = *axis_table_named("pmac").value();
  const AxisCorrection loose = correction_of(AxisKind::linear, {0.0, 10.0, 20.0}, {0.0, 0.0, 0.0}, {-5.0, -6.0, -3.5});
  const std::string text = table_text_of(pmac, loose, {});
  const std::string blcomp = "#1 DEFINE BLCOMP 3,30000\n16\n-24\n0\nI186=80\nI51=1\n";
  ASSERT_TRUE(text.ends_with(blcomp)) << text;
  const auto back = pmac.read(text, {});
  ASSERT_TRUE(back) << back.error().message;
  EXPECT_NEAR(back->at(0.0, Direction::down), -5.0, 1e-9);
  EXPECT_NEAR(back->at(20.0, Direction::down), -3.5, 1e-9);
  const std::string comp = text.substr(0, text.size() - blcomp.size());
  for (const char* end :
       {"#1 DEFINE BLCOMP 3,30000\n96\n56\n80\nI51=1\n", "#1 DEFINE BLCOMP 3,30000\n16\n-24\n0\nI51=1\n",
        "#1 DEFINE BLCOMP 3,30000\n16\n-24\n1\nI186=80\nI51=1\n",
        "#1 DEFINE BLCOMP 3,30000\n16\n-24\n0\nI186=-80\nI51=1\n"})
    EXPECT_FALSE(pmac.read(comp + end, {})) << end;
  EXPECT_FALSE(pmac.write(correction_of(AxisKind::linear, {0.0, 10.0}, {0.0, 0.0}, {1.0, 1.0}), {})) << "negative";
  // What earlier versions wrote is named so; a table of somebody else, without the range, is not.
  EXPECT_EQ(pmac.former(text), "");
  const std::string earlier = comp + "#1 DEFINE BLCOMP 3,30000\n96\n56\n80\nI51=1\n";
  EXPECT_NE(pmac.former(earlier), "");
  EXPECT_EQ(pmac.read(earlier, {}).error().message, pmac.former(earlier));
  EXPECT_EQ(pmac.former(earlier.substr(earlier.find("#1 DEFINE COMP"))), "");
}

void expect_refused(std::string_view id, const AxisCorrection& correction, const AxisTableOptions& options,
                    std::string_view why) {
  const auto text = axis_table_named(id).value()->write(correction, options);
  ASSERT_FALSE(text) << id << '\n' << *text;
  EXPECT_NE(text.error().message.find(why), std::string::npos) << id << ": " << text.error().message;
}

TEST(Compensations, WhatAControlCannotHoldIsRefusedByName) {
  const std::vector<double> steep = {0.0, 80.0, 0.0}, flat = {0.0, 0.0, 0.0};
  const AxisCorrection jump = correction_of(AxisKind::linear, {0.0, 10.0, 20.0}, steep, steep);
  AxisTableOptions options;
  expect_refused("fanuc", jump, options, "-7 to 7");
  expect_refused("fanuc-bidirectional", jump, options, "-7 to 7");
  options.largest = 127;
  EXPECT_TRUE(axis_table_named("fanuc").value()->write(jump, options));
  expect_refused("mitsubishi", jump, {}, "-128 to 127");
  options.reference = 5.0;
  expect_refused("fanuc", jump, options, "whole number of steps");
  options.reference = 10.0;
  expect_refused("pmac", jump, options, "expected 0");
  // Either reversal is within 24 bits, what stands in BLCOMP, their difference, is not.
  const AxisCorrection turned = correction_of(AxisKind::linear, {0.0, 10.0, 20.0}, flat, {-4000.0, 4000.0, 0.0});
  options = {};
  options.resolution = 0.01;
  expect_refused("pmac", turned, options, "found a correction of -12800000 counts / 16, expected at most 8388607");
  const AxisCorrection coarse = correction_of(AxisKind::linear, {-12.7, 0.0}, {100.0, 0.0}, {100.0, 0.0});
  options = {};
  options.resolution = 0.5;
  expect_refused("haas", coarse, options, "127 encoder steps");
  expect_refused("haas", jump, {}, "expected 12.7");
  options.axis = "X;\nM30";
  expect_refused("siemens-lec", jump, options, "letters and digits");
  for (const auto& [id, backlash] : {std::pair("grblhal", -5.0), std::pair("smoothie", -5.0)})
    expect_refused(id, correction_of(AxisKind::linear, {0.0, 20.0}, {0.0, 1.0}, {-backlash, 1.0 - backlash}), {},
                   "expected 0 or more");
}

TEST(Compensations, LimitsOfTheDescriptorAreKept) {
  for (const AxisTable* table : axis_table_table()) {
    SCOPED_TRACE(table->id);
    const AxisTableLimits& limits = table->limits;
    AxisTableOptions options;
    if (table->uses.steps_per_unit) options.steps_per_unit = 80.0;
    if (limits.points > 0 && table->id != "haas") {
      std::vector<double> positions, zeros(limits.points + 1, 0.0);
      for (std::size_t k = 0; k <= limits.points; ++k) positions.push_back(static_cast<double>(k));
      EXPECT_FALSE(table->write(correction_of(AxisKind::linear, positions, zeros, zeros), options)) << "points";
    }
    if (limits.equidistant) {
      EXPECT_FALSE(
          table->write(correction_of(AxisKind::linear, {0.0, 1.0, 3.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}), options));
    }
    if (table->curves == TableCurves::both_ways) {
      EXPECT_FALSE(table->write(correction_of(AxisKind::linear, {0.0, 10.0}, {0.0, 1.0}, {0.0, 2.0}), options));
    }
    if (!limits.rotary) {
      options.kind = AxisKind::rotary;
      EXPECT_FALSE(table->write(correction_of(AxisKind::rotary, {0.0, 12.7}, {0.0, 0.0}, {0.0, 0.0}), options));
    }
    if (limits.closes && limits.rotary) {
      options.kind = AxisKind::rotary;
      const std::vector<double> open = {0.0, 2.0, 4.0};
      EXPECT_FALSE(table->write(correction_of(AxisKind::rotary, {0.0, 180.0, 360.0}, open, open), options));
    }
  }
}

TEST(Compensations, ALineThatIsNoneIsRefusedWhereItStands) {
  for_all([](const AxisTable& table, const AxisTableOptions& options, const AxisCorrection& correction) {
    const std::vector<std::string> lines = lines_in(table_text_of(table, correction, options));
    for (std::size_t k = 0; k < lines.size(); ++k) {
      std::vector<std::string> bad = lines;
      bad[k] = "rubbish 1 2 x";
      const auto found = table.read(joined_lines(bad), options);
      ASSERT_FALSE(found) << "line " << k + 1 << ": " << lines[k];
      if (lines[k] != "%" && lines[k] != "M17") {
        EXPECT_EQ(found.error().at.line, k + 1) << found.error().message;
      }
    }
  });
}

TEST(Compensations, ALineTooFewOrTwiceIsRefused) {
  const std::set<std::string_view> without_count = {"linuxcnc", "linuxcnc-type1", "axeserr", "fagor",  "haas",
                                                    "aerotech", "heidenhain",     "grblhal", "marlin", "smoothie"};
  const auto may_be_missing = [](const std::string& line) {
    return line.starts_with(';') || line.starts_with("# ") || line.starts_with("//") || line.starts_with('!') ||
           line.starts_with('(') || line.starts_with("%_N") || line.starts_with("CHANDATA") ||
           line.starts_with("kopf.") || line.find("interval") != line.npos || line.find("startpos") != line.npos ||
           line.find("modulo") != line.npos || line.starts_with("MFLAGS") || line.starts_with("DEPENDS") ||
           line == "STOP" || line.starts_with("#400") || line.starts_with("3605") || line.starts_with("3627") ||
           line.starts_with("Motor") || line.find("MULT_BY") != line.npos;
  };
  for_all([&](const AxisTable& table, const AxisTableOptions& options, const AxisCorrection& correction) {
    const std::vector<std::string> lines = lines_in(table_text_of(table, correction, options));
    for (std::size_t k = 0; k < lines.size(); ++k) {
      if (may_be_missing(lines[k])) continue;
      std::vector<std::string> fewer = lines, more = lines;
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
      more.insert(more.begin() + static_cast<std::ptrdiff_t>(k), lines[k]);
      if (!without_count.contains(table.id)) {
        EXPECT_FALSE(table.read(joined_lines(fewer), options)) << "without line " << k + 1 << ": " << lines[k];
      }
      if (table.id != "aerotech") {
        EXPECT_FALSE(table.read(joined_lines(more), options)) << "twice " << lines[k];
      }
    }
  });
}

TEST(Compensations, TablesOfAnotherAxisAreNotTakenForThis) {
  for_all([](const AxisTable& table, AxisTableOptions options, const AxisCorrection& correction) {
    const std::string text = table_text_of(table, correction, options);
    options.axis = "Y";
    const bool names_axis = text.find(options.kind == AxisKind::linear ? "X" : "A ") != std::string::npos;
    if (table.id == "pmac" || table.id == "haas" || !names_axis) return;  // by number, or by hand alone
    EXPECT_FALSE(table.read(text, options)) << text;
  });
}

TEST(Compensations, ATextIsKnownByItsFirstLines) {
  for_all([](const AxisTable& table, const AxisTableOptions& options, const AxisCorrection& correction) {
    const std::string text = table_text_of(table, correction, options);
    for (const AxisTable* other : axis_table_table()) {
      if (!other->recognises) continue;
      const bool is_own = other == &table || (other->id.starts_with("fanuc") && table.id.starts_with("fanuc"));
      EXPECT_EQ(other->recognises(text), is_own) << other->id;
      EXPECT_FALSE(other->recognises("")) << other->id;
    }
  });
}

TEST(Compensations, RepeatedPiecesAreRefusedOrReadInProportion) {
  for (const AxisTable* table : axis_table_table()) {
    SCOPED_TRACE(table->id);
    const AxisKind kind = AxisKind::linear;
    const AxisTableOptions options = options_of(*table, kind);
    const std::string text =
        table_text_of(*table, fitting(*table, kind, table->curves != TableCurves::both_ways), options);
    const std::vector<std::string> lines = lines_in(text);
    std::vector<std::string> pieces;
    for (std::size_t k = 0; k < lines.size(); k += 8) pieces.push_back(lines[k] + '\n');
    pieces.insert(pieces.end(), {text, "1 2 3\n", "9", "(", "[", ",", "=", "\n", "N1P1\n", "%\n", " "});
    for (const std::string& piece : pieces)
      for (const std::size_t size : {1'000u, 10'000u, 100'000u}) {
        std::string hostile = text.substr(0, text.size() / 2);
        while (hostile.size() < size) hostile += piece;
        const double before = testing_support::cpu_seconds();
        const auto found = table->read(hostile, options);
        EXPECT_LT(testing_support::cpu_seconds() - before, 2.0) << size << " bytes of " << piece;
        if (found) {
          EXPECT_LE(found->positions().size(), hostile.size());
        }
      }
  }
}

TEST(Compensations, ControlsWithoutTablesSayWhatTheyLeaveOut) {
  AxisTableOptions options;
  const AxisCorrection line = correction_of(AxisKind::linear, {0.0, 20.0}, {0.0, 20.0}, {-50.0, -30.0});
  const AxisTable& grblhal = *axis_table_named("grblhal").value();
  const std::string text = table_text_of(grblhal, line, options);
  EXPECT_NE(text.find("left out: a scale of 1.001000000"), std::string::npos) << text;
  EXPECT_EQ(text.find("$100"), std::string::npos) << text;
  const auto found = grblhal.read(text, options);
  ASSERT_TRUE(found);
  expect_near(*found, correction_of(AxisKind::linear, {0.0, 20.0}, {0.0, 0.0}, {-50.0, -50.0}), 1e-6, 1e-9);
}

TEST(Compensations, FanucPointsHaveTheNumbersOfTheControl) {
  // By hand: −20 to 20 in steps of 5, the reference point 0 is number 40: four sections below it end at 37 to 40.
  std::vector<double> positions, values;
  for (int k = -4; k <= 4; ++k) {
    positions.push_back(5.0 * k);
    values.push_back(3.0 * k);
  }
  AxisTableOptions options;
  options.number = 40;
  const std::string text = table_text_of(*axis_table_named("fanuc").value(),
                                         correction_of(AxisKind::linear, positions, values, values), options);
  EXPECT_TRUE(text.starts_with("%\nN10037P3\nN10038P3\n")) << text;
  EXPECT_NE(text.find("\n3620 = 40\n3621 = 37\n3622 = 44\n3623 = 1\n3624 = 5.0\n"), std::string::npos) << text;
}

/// The file and what it does; empty where it is refused.
std::pair<std::string, std::vector<double>> made_with(const AxisTable& table, const AxisCorrection& correction,
                                                      const AxisTableOptions& options) {
  const auto text = table.write(correction, options);
  if (!text) return {};
  const auto read = table.read(*text, options);
  return {*text, read ? read->values(Direction::up) : std::vector<double>()};
}

TEST(AxisTables, DependOnTheOptionsThatTheySay) {
  for_all([](const AxisTable& table, const AxisTableOptions& options, const AxisCorrection& correction) {
    const auto before = made_with(table, correction, options);
    AxisTableOptions number = options, resolution = options, magnification = options, largest = options,
                     steps = options;
    number.number = 3;
    resolution.resolution /= 100.0;
    magnification.magnification += 1;
    largest.largest = 1;
    steps.steps_per_unit = 90.0;
    AxisTableOptions output = options;
    output.output_axis = "Y";
    EXPECT_EQ(made_with(table, correction, number) != before, table.uses.number);
    EXPECT_EQ(made_with(table, correction, resolution) != before, table.uses.resolution);
    EXPECT_EQ(made_with(table, correction, magnification) != before, table.uses.magnification);
    EXPECT_EQ(made_with(table, correction, largest) != before, table.uses.largest);
    EXPECT_EQ(made_with(table, correction, steps) != before, table.uses.steps_per_unit);
    EXPECT_EQ(made_with(table, correction, output) != before, table.uses.output_axis);
  });
}

TEST(AxisTables, TakeASpacingThatTheyAreToldOnlyWhereTheFileMayLackIt) {
  for_all([](const AxisTable& table, AxisTableOptions options, const AxisCorrection& correction) {
    std::string text = table_text_of(table, correction, options);
    // The points of a Fanuc alone, without parameters; a turn cannot be known without them, nor two directions.
    if (table.id.starts_with("fanuc")) text.erase(text.rfind("%") + 2);
    const double spacing = correction.positions()[1] - correction.positions()[0];
    EXPECT_EQ(static_cast<bool>(table.read(text, options)), !table.id.starts_with("fanuc"));
    options.step = spacing;
    const auto told = table.read(text, options);
    if (table.id == "fanuc-bidirectional" || (table.id == "fanuc" && options.kind == AxisKind::rotary)) {
      EXPECT_FALSE(told);
      return;
    }
    ASSERT_TRUE(told) << told.error().to_string();
    EXPECT_EQ(table.uses.told_step, table.id == "fanuc");
    if (table.uses.told_step) {
      EXPECT_DOUBLE_EQ(told->positions()[1] - told->positions()[0], spacing);
    }
  });
}

TEST(AxisTables, RefuseWhatTheyHaveNoUseFor) {
  const AxisTable& linuxcnc = **axis_table_named("linuxcnc");
  AxisTableOptions options;
  EXPECT_TRUE(check_used(linuxcnc, options));
  options.magnification = 4;
  EXPECT_EQ(check_used(linuxcnc, options).error().message,
            "found magnification given for LinuxCNC, COMP_FILE_TYPE 0, which has no use for it; expected it to be left "
            "out");
  EXPECT_TRUE(check_used(**axis_table_named("fanuc"), options));
}

}  // namespace
}  // namespace axiometry::nc
