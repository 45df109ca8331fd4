// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/store.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "axiometry/digest/sha256.h"

namespace axiometry::store {
namespace {

NewTest simple(const std::string& title) {
  NewTest test;
  test.state.title = title;
  test.state.machine.name = "Mill";
  test.state.machine.serial_number = "1";
  test.state.axis.name = "X";
  test.state.axis.kind = "linear";
  test.state.measured_on = "2014-01-01";
  test.state.changes = "{}";
  test.state.evaluation.options = "{}";
  test.state.evaluation.result = "{}";
  test.state.evaluation.unit = "um";
  test.state.evaluation.figures = {{"A", 1.5, 0.2, 3.0, "conforms"}};
  return test;
}

TEST(Store, KeepsTestsAndFindsThemInEveryOrder) {
  const std::string file = testing::TempDir() + "store_first.db";
  for (const char* rest : {"", "-wal", "-shm"}) std::remove((file + rest).c_str());
  auto store = Store::open(file);
  ASSERT_TRUE(store) << store.error().to_string();
  const Content content{sha256("abc"), "a.csv", "csv-long", "abc"};
  const auto ids = (*store)->receive(content, std::vector{simple("T1"), simple("T2")}, {"me", "x"});
  ASSERT_TRUE(ids) << ids.error().to_string();
  for (int order = 0; order < 8; ++order)
    for (const bool descending : {false, true})
      for (const char* text : {"", "mill x"}) {
        TestFilter filter;
        filter.text = text;
        filter.order = static_cast<TestFilter::Order>(order);
        filter.descending = descending;
        const auto page = (*store)->tests(filter);
        ASSERT_TRUE(page) << page.error().to_string();
        ASSERT_EQ(page->total, 2);
        EXPECT_EQ(page->rows[0].figures[0].value, 1.5);
        EXPECT_EQ(page->rows[0].id, descending ? 2 : 1);
      }
  const auto revised = (*store)->revise(1, 1, simple("T1 again").state, {"me", ""});
  ASSERT_TRUE(revised) << revised.error().to_string();
  EXPECT_EQ(*revised, 2);
  const auto trend = (*store)->trend(1, std::vector<std::string>{"A"}, 10);
  ASSERT_TRUE(trend) << trend.error().to_string();
  EXPECT_EQ(trend->size(), 2u);
}

}  // namespace
}  // namespace axiometry::store
