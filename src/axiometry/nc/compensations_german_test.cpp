// SPDX-License-Identifier: Apache-2.0
//
// What is said of the controls, and what is refused of their tables, in German.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>
#include <vector>

#include "axiometry/language/language.h"
#include "axiometry/nc/axis_table.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {
namespace {

using language::Language;

/// Refusals that were met, each of which must be German.
class Refusals {
 public:
  void expect_german(const Error& error) {
    if (!met_.insert(error.message).second) return;
    EXPECT_TRUE(language::is_known(error.message, Language::german)) << error.message;
    const std::string german = language::translated(error.message, Language::german, {.decimal_mark = ','});
    EXPECT_EQ(german.find("expected"), std::string::npos) << german;
    expectations_.insert(german.substr(german.rfind("erwartet: ") + 10));
  }
  std::size_t kinds() const { return expectations_.size(); }

 private:
  std::set<std::string> met_, expectations_;
};

/// Three positions (two where there is no table) that every control of linear axes can hold.
AxisCorrection held_by(const AxisTable& table) {
  const auto made = [&](std::vector<double> positions, std::vector<double> up, std::vector<double> down) {
    if (table.curves == TableCurves::both_ways) down = up;
    return AxisCorrection::make(AxisKind::linear, std::move(positions), std::move(up), std::move(down)).value();
  };
  if (table.limits.points == 2) return made({0.0, 20.0}, {0.0, 20.0}, {-50.0, -30.0});
  if (table.limits.origin == TableOrigin::last) return made({-25.4, -12.7, 0.0}, {10.16, 5.08, 0.0}, {});
  return made({0.0, 10.0, 20.0}, {0.0, 8.0, 12.0}, {0.0, 0.0, -4.0});
}

AxisTableOptions usual_options(const AxisTable& table) {
  AxisTableOptions options;
  if (table.uses.steps_per_unit) options.steps_per_unit = 80.0;
  if (table.uses.magnification) options.magnification = 2;
  if (table.limits.cross_only) options.axis = "Y", options.output_axis = "X";
  return options;
}

std::string text_of_lines(const std::vector<std::string>& lines) {
  std::string text;
  for (const std::string& line : lines) text += line + '\n';
  return text;
}

/// The line with its last number replaced, or with one behind it where it has none.
std::string with_number(const std::string& line, const std::string& number) {
  constexpr std::string_view digits = "0123456789";
  const std::size_t last = line.find_last_of(digits);
  if (last == std::string::npos) return line + ' ' + number;
  const std::size_t before = line.find_last_not_of("0123456789.-", last);
  return line.substr(0, before == std::string::npos ? 0 : before + 1) + number + line.substr(last + 1);
}

/// Every way in which one line of a table can be wrong.
std::vector<std::string> spoiled(const std::string& text) {
  std::vector<std::string> lines, all;
  for (const TableLine& line : lines_of(text)) lines.emplace_back(line.text);
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const auto place = static_cast<std::ptrdiff_t>(k);
    const auto replaced = [&](const std::string& by) {
      std::vector<std::string> other = lines;
      other[k] = by;
      all.push_back(text_of_lines(other));
    };
    for (const char* by : {"rubbish, 1. 2 = x", "7", "a \"quoted\" word", "X = 0.5", "%", "[END]", "M17"}) replaced(by);
    for (const char* number : {"0", "-3", "0.25", "7.5", "100", "999999", "12345678901", "x"})
      replaced(with_number(lines[k], number));
    replaced(lines[k].substr(0, lines[k].size() / 2));
    replaced(lines[k] + " 5");
    for (const std::size_t cut : {std::size_t{1}, lines.size() - k}) {  // this line, and all from it on
      std::vector<std::string> fewer = lines;
      fewer.erase(fewer.begin() + place, fewer.begin() + place + static_cast<std::ptrdiff_t>(cut));
      all.push_back(text_of_lines(fewer));
    }
    std::vector<std::string> twice = lines;
    twice.insert(twice.begin() + place, lines[k]);
    all.push_back(text_of_lines(twice));
    all.push_back(text + lines[k] + '\n');
  }
  return all;
}

/// What takes more than one wrong line.
struct WrongTable {
  std::string_view id;
  std::string text;
  AxisTableOptions options{};
};

std::string replaced_in(std::string text, std::string_view from, std::string_view to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from << " in\n" << text;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string text_of_control(std::string_view id) {
  const AxisTable& table = *axis_table_named(id).value();
  return table.write(held_by(table), usual_options(table)).value();
}

std::vector<WrongTable> wrong_as_a_whole() {
  std::string fagor, linuxcnc, one_way;
  for (int k = 1; k <= 1001; ++k) {
    fmt::format_to(std::back_inserter(fagor), "P{:03} {} 0 0\n", k, k);
    fmt::format_to(std::back_inserter(linuxcnc), "{0} {0} {0}\n", k);
  }
  const std::string cec = text_of_control("siemens-cec");
  for (const TableLine& line : lines_of(cec))
    if (line.text.find("[1") == std::string_view::npos) one_way += std::string(line.text) + '\n';
  const std::string elsewhere =
      replaced_in(replaced_in(cec, "_MIN[1]=0.0", "_MIN[1]=5.0"), "_MAX[1]=20.0", "_MAX[1]=25.0");
  const std::string turn = "%\nN10000P0\nN10001P1\n%\n3620 = 0\n3621 = 0\n3622 = 1\n3623 = 1\n3625 = 360\n3624 = ";
  const std::string list = text_of_control("twincat-cnc");
  return {{"fagor", fagor},
          {"linuxcnc", linuxcnc},
          {"fanuc", "%\n%\n", {.step = 10.0}},
          {"fanuc", "%\nN10000P0\n%\n3700 = 1\n"},
          {"fanuc", turn + "180\n", {.kind = AxisKind::rotary}},
          {"fanuc", turn + "360\n", {.kind = AxisKind::rotary}},
          {"siemens-cec", one_way},
          {"siemens-cec", elsewhere},
          {"siemens-cec", replaced_in(cec, "$AN_CEC[0,0]", "$AN_CEC[0,-1]")},
          {"grblhal", text_of_control("grblhal")},
          {"twincat-cnc", list + "kw.ssfk.table[0].up 3\n"},
          {"twincat-cnc", list + "kw.other.unit 3\n"},
          {"twincat-cnc", list + "kw.ssfk.colour 3\n"}};
}

TEST(GermanControls, SayAllOfThemselvesInGerman) {
  for (const AxisTable* table : axis_table_table())
    for (const std::string_view text :
         {table->title, table->sign, table->loading, table->verified, table->inferred, table->turned_sign}) {
      if (text.empty()) continue;
      EXPECT_TRUE(language::is_known(text, Language::german)) << table->id << ": " << text;
      if (text.ends_with('.')) {
        EXPECT_NE(language::translated(text, Language::german), text);
      }
    }
}

TEST(GermanControls, RefuseTablesInGerman) {
  Refusals refusals;
  for (const AxisTable* table : axis_table_table()) {
    SCOPED_TRACE(table->id);
    const AxisTableOptions usual = usual_options(*table);
    const auto text = table->write(held_by(*table), usual);
    ASSERT_TRUE(text) << text.error().message;
    std::vector<AxisTableOptions> other(4, usual);
    other[1].axis = "Y";
    other[2].number = 3;
    other[3].kind = AxisKind::rotary;
    for (const AxisTableOptions& options : other)
      for (const std::string& wrong : spoiled(*text))
        if (const auto found = table->read(wrong, options); !found) refusals.expect_german(found.error());
  }
  for (const WrongTable& wrong : wrong_as_a_whole()) {
    const auto found = axis_table_named(wrong.id).value()->read(wrong.text, wrong.options);
    ASSERT_FALSE(found) << wrong.id << '\n' << wrong.text.substr(0, 2000);
    refusals.expect_german(found.error());
  }
  EXPECT_GT(refusals.kinds(), 150u);
}

TEST(GermanControls, RefuseWhatTheyCannotHoldInGerman) {
  Refusals refusals;
  std::vector<AxisCorrection> corrections;
  const auto add = [&](AxisKind kind, const std::vector<double>& positions, const std::vector<double>& up,
                       const std::vector<double>& down) {
    corrections.push_back(AxisCorrection::make(kind, positions, up, down).value());
  };
  for (const AxisKind kind : {AxisKind::linear, AxisKind::rotary}) {
    add(kind, {0}, {0}, {0});
    add(kind, {0, 7, 20}, {0, 1, 2}, {0, 1, 2});
    add(kind, {0, 10, 20}, {0, 80.5, 0}, {0, 80.5, 0});
    add(kind, {0, 10, 20}, {0, 80.5, 0}, {50, -80.5, 7});
    add(kind, {0, 10, 20}, {0, 9'000, 0}, {0, 9'000, 0});
    add(kind, {0, 10, 20}, {0.5, 1, 2}, {0.5, 1, 2});
    add(kind, {0, 20}, {0, 1}, {0, 5});
    add(kind, {0, 20}, {0, 1}, {7.25, 8.25});
    add(kind, {0, 20}, {0, 1}, {0, 0.5});
    add(kind, {-12.7, 0}, {900, 0}, {900, 0});
    add(kind, {-12.7, 0}, {5, 1}, {5, 1});
    add(kind, {0, 10, 20}, {1, 2, 3}, {0, 0, 0});
    add(kind, {0, 1e-5, 2e-5}, {0, 1, 2}, {0, 1, 2});
  }
  add(AxisKind::rotary, {0, 180, 360}, {0, 2, 4.5}, {0, 2, 4.5});
  add(AxisKind::rotary, {180, 360, 540}, {0, 2, 0}, {0, 2, 0});
  std::vector<double> many, zeros(2000);
  for (int k = 0; k < 2000; ++k) many.push_back(12.7 * (k - 1999));
  add(AxisKind::linear, many, zeros, zeros);

  for (const AxisTable* table : axis_table_table()) {
    SCOPED_TRACE(table->id);
    std::vector<AxisTableOptions> other(9, usual_options(*table));
    other[1].axis = "?";
    other[2].axis = "W";
    other[3].in_inch = true;
    other[4].number = 99'999;
    other[5].largest = 500;
    other[6].reference = 3.3;
    other[7].reference = 90.0;
    other[8].resolution = 1e-6;
    for (AxisTableOptions options : other)
      for (const AxisCorrection& correction : corrections) {
        options.kind = correction.kind();
        if (const auto text = table->write(correction, options); !text) refusals.expect_german(text.error());
      }
    for (const NamedTableOption& option : named_table_options()) {
      const AxisTableOptions given{
          .in_inch = true, .number = 1, .resolution = 2, .magnification = 2, .largest = 2, .steps_per_unit = 2};
      if (table->uses.*option.used) continue;
      const auto used = check_used(*table, given);
      ASSERT_FALSE(used);
      refusals.expect_german(used.error());
    }
  }
  refusals.expect_german(axis_table_named("x").error());
  EXPECT_GT(refusals.kinds(), 50u);
}

TEST(GermanControls, RefuseWhatIsNoCorrectionInGerman) {
  Refusals refusals;
  const auto refused_of = [&](std::vector<double> positions, std::vector<double> up, std::vector<double> down) {
    const auto found = AxisCorrection::make(AxisKind::linear, std::move(positions), std::move(up), std::move(down));
    ASSERT_FALSE(found);
    refusals.expect_german(found.error());
  };
  refused_of({}, {}, {});
  refused_of(std::vector<double>(AxisCorrection::nodes_max + 1), {}, {});
  refused_of({0, 1.5}, {0}, {0, 1});
  refused_of({0, 1.5}, {0, 1.0 / 0.0}, {0, 1});
  refused_of({1.5, 0.5}, {0, 1}, {0, 1});
  refused_of({0.5, 1.5}, {0, 1}, {0, 1e12});
  EXPECT_EQ(language::translated("found position 0.5 after 1.5, expected positions that ascend", Language::german,
                                 {.decimal_mark = ','}),
            "Position 0,5 nach 1,5; erwartet: aufsteigende Positionen");
}

}  // namespace
}  // namespace axiometry::nc
