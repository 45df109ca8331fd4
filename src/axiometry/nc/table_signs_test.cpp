// SPDX-License-Identifier: Apache-2.0
//
// Signs that were inferred and may be turned, numbers beside a table, and bytes that no table has.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "axiometry/nc/axis_table.h"
#include "axiometry/nc/table_text.h"

namespace axiometry::nc {
namespace {

AxisCorrection slanted(const AxisTable& table) {
  std::vector<double> positions{0.0, 10.0, 20.0};
  if (table.limits.origin == TableOrigin::last) positions = {-25.4, -12.7, 0.0};
  const std::vector<double> up =
      table.limits.origin == TableOrigin::last ? std::vector{10.16, 5.08, 0.0} : std::vector{0.0, 8.0, 12.0};
  return AxisCorrection::make(AxisKind::linear, std::move(positions), up, up).value();
}

const AxisTable& table_of(std::string_view id) { return *axis_table_named(id).value(); }

TEST(TableSigns, AreTurnedWhereTheyWereInferredAndNowhereElse) {
  std::size_t turned = 0;
  for (const AxisTable* table : axis_table_table()) {
    SCOPED_TRACE(table->id);
    const bool inferred = table->sign.contains("(inferred");
    EXPECT_EQ(table->uses.turned_sign, inferred);
    EXPECT_EQ(table->turned_sign.empty(), !inferred);
    AxisTableOptions options;
    options.turned_sign = true;
    if (!inferred) {
      const auto refused = write_table(*table, slanted(*table), options);
      ASSERT_FALSE(refused);
      EXPECT_NE(refused.error().message.find("that sign is verified"), std::string::npos) << refused.error().message;
      EXPECT_FALSE(read_table(*table, "", options));
      continue;
    }
    ++turned;
    const std::string plain = write_table(*table, slanted(*table), {}).value();
    const std::string other = write_table(*table, slanted(*table), options).value();
    EXPECT_NE(plain, other);
    const auto back = read_table(*table, other, options);
    ASSERT_TRUE(back) << back.error().message;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(back->values(Direction::up)[k], slanted(*table).values(Direction::up)[k], 1.3);
    // What the file says of itself is not passed over; a file that says nothing is read with the other sign.
    const auto as_plain = read_table(*table, other, {});
    if (other.contains("A positive number")) {
      ASSERT_FALSE(as_plain) << other;
      EXPECT_NE(as_plain.error().message.find("turned or not"), std::string::npos);
      EXPECT_FALSE(read_table(*table, plain, options));
    } else {
      EXPECT_EQ(table->id, "heidenhain");  // whose tables have no comment
      ASSERT_TRUE(as_plain);
      EXPECT_NEAR(as_plain->values(Direction::up)[1], -8.0, 1e-3);
    }
  }
  EXPECT_EQ(turned, 6u);
}

TEST(TableSigns, SayTheOppositeWhenTurned) {
  for (const AxisTable* table : axis_table_table()) {
    if (!table->uses.turned_sign) continue;
    const bool upwards = table->sign.contains("in the positive direction:");
    EXPECT_TRUE(table->turned_sign.contains(upwards ? "in the negative direction:" : "in the positive direction:"))
        << table->id;
    AxisTableOptions options;
    EXPECT_EQ(sign_of(*table, options), table->sign);
    options.turned_sign = true;
    EXPECT_EQ(sign_of(*table, options), table->turned_sign);
  }
}

TEST(TableNumbers, ABacklashStandsBesideOneCurve) {
  const AxisTable& lec = table_of("siemens-lec");
  const AxisCorrection correction =
      AxisCorrection::make(AxisKind::linear, {0.0, 10.0, 20.0}, {0.0, 8.0, 12.0}, {-3.7, 4.3, 8.3}).value();
  const std::string text = write_table(lec, correction, {}).value();
  EXPECT_NE(text.find("\n; MD32450 = its value while the axis was measured + 0.003700\n"), std::string::npos) << text;
  const AxisCorrection back = read_table(lec, text, {}).value();
  EXPECT_NEAR(back.values(Direction::up)[1], 8.0, 1e-9);
  EXPECT_NEAR(back.values(Direction::down)[1], 4.3, 1e-9);

  AxisTableOptions in_inch;
  in_inch.in_inch = true;
  EXPECT_NEAR(read_table(lec, write_table(lec, correction, in_inch).value(), in_inch)->values(Direction::down)[2], 8.3,
              1e-3);
  AxisTableOptions rotary;
  rotary.kind = AxisKind::rotary;
  const AxisCorrection turning = AxisCorrection::make(AxisKind::rotary, {0.0, 10.0}, {0.0, 36.0}, {-7.2, 28.8}).value();
  const std::string angles = write_table(lec, turning, rotary).value();
  EXPECT_NE(angles.find("+ 0.002000\n"), std::string::npos) << angles;
  EXPECT_NEAR(read_table(lec, angles, rotary)->values(Direction::down)[1], 28.8, 1e-6);

  const std::string line = "; MD32450 = its value while the axis was measured + 0.003700\n";
  for (const char* bad : {"+ x\n", "+ \n", "+ 0.1 0.2\n"}) {
    std::string spoiled = text;
    spoiled.replace(spoiled.find("+ 0.003700\n"), 11, bad);
    EXPECT_FALSE(read_table(lec, spoiled, {})) << spoiled;
  }
  EXPECT_FALSE(read_table(lec, line + text, {})) << "twice";
}

TEST(TableNumbers, ABacklashThatNoNumberHoldsIsRefused) {
  const AxisTable& lec = table_of("siemens-lec");
  const auto why = [&](std::vector<double> down) {
    const auto text =
        write_table(lec, AxisCorrection::make(AxisKind::linear, {0.0, 10.0}, {0.0, 8.0}, std::move(down)).value(), {});
    return text ? *text : text.error().message;
  };
  EXPECT_NE(why({-3.0, 4.0}).find("the same everywhere"), std::string::npos);
  EXPECT_NE(why({3.0, 11.0}).find("; MD32450 = its value while the axis was measured + -0.003000\n"), std::string::npos)
      << "an encoder that lags has a negative one";
  EXPECT_NE(write_table(table_of("kflop"),
                        AxisCorrection::make(AxisKind::linear, {0.0, 10.0}, {0.0, 8.0}, {-3.0, 5.0}).value(), {})
                .error()
                .message.find("expected one for both"),
            std::string::npos);
}

TEST(TableBytes, ThatNoTableHasAreNamed) {
  for (const AxisTable* table : axis_table_table()) {
    SCOPED_TRACE(table->id);
    const auto why = [&](const std::string& text) {
      const auto read = read_table(*table, text, {});
      return read ? std::string() : read.error().to_string();
    };
    EXPECT_NE(why("\xEF\xBB\xBF"
                  "0 0 0\n")
                  .find("byte order (BOM)"),
              std::string::npos);
    EXPECT_NE(why("\xFF\xFE"
                  "0")
                  .find("UTF-16"),
              std::string::npos);
    EXPECT_NE(why(std::string("0 0 0\n1 1\0 1\n", 13)).find("line 2: found a NUL byte"), std::string::npos)
        << why(std::string("0 0 0\n1 1\0 1\n", 13));
    EXPECT_EQ(why(std::string(100, '\0')).find("UTF-16"), std::string::npos);
  }
}

TEST(TableNumbers, OnePositionIsNoEvenSpacing) {
  for (const AxisTable* table : axis_table_table()) {
    if (!table->limits.equidistant) continue;
    const auto text = write_table(*table, AxisCorrection::make(AxisKind::linear, {0.0}, {0.0}, {0.0}).value(), {});
    ASSERT_FALSE(text) << table->id;
    EXPECT_EQ(text.error().message, "found one position, expected at least two") << table->id;
  }
}

}  // namespace
}  // namespace axiometry::nc
