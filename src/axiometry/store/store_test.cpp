// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/store.h"

#include <gmock/gmock.h>

#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class StoreTest : public BothStores {
 protected:
  std::unique_ptr<Store> new_store() { return must(Store::open(new_address())); }
};
AXIOMETRY_ON_BOTH_STORES(StoreTest);

TEST_P(StoreTest, IsEmptyWhenNewAndSaysWhatItIs) {
  const std::string address = new_address();
  const auto store = must(Store::open(address));
  EXPECT_EQ(store->info().kind, GetParam());
  EXPECT_EQ(store->info().schema, 4);
  EXPECT_TRUE(store->info().writable);
  const Counts counts = must(store->counts());
  EXPECT_EQ(counts.tests + counts.machines + counts.content_bytes, 0);
  EXPECT_TRUE(must(store->verify()).problems.empty());
  EXPECT_TRUE(Store::open(address)) << "a second time";
  EXPECT_EQ(Store::open(new_address(), {.create = false}).error().kind, ErrorKind::not_found);
}

TEST_P(StoreTest, GivesATestBackAsItCame) {
  const auto store = new_store();
  NewTest test = new_test("Umkehrspanne ± „µm“\n<b>&'\"", 0.1 + 0.2);
  test.name_in_file = "second";
  const Content content = content_of(std::string("a\0b\xff\r\n", 6), "größe <x>.csv");
  EXPECT_THAT(must(store->receive(content, std::vector{test}, by_anna)), ElementsAre(1));
  const TestRecord found = must(store->test(1));
  EXPECT_EQ(found.version, 1);
  EXPECT_EQ(found.sha256, content.sha256);
  EXPECT_EQ(found.file_name, content.file_name);
  EXPECT_EQ(found.format, "csv-long");
  EXPECT_EQ(found.name_in_file, "second");
  EXPECT_EQ(found.received.actor, "Anna");
  EXPECT_EQ(found.received.at.size(), std::string("2026-11-22T09:30:00.123Z").size());
  EXPECT_EQ(found.state.title, test.state.title);
  EXPECT_EQ(found.state.machine.serial_number, "4711");
  EXPECT_EQ(found.state.axis.limits.at(0).value, 10.0);
  EXPECT_EQ(found.state.instruments.at(0).inputs, test.state.instruments[0].inputs);
  EXPECT_EQ(found.state.changes, test.state.changes);
  const EvaluationRecord& evaluation = found.state.evaluation;
  EXPECT_EQ(evaluation.seed, test.state.evaluation.seed);
  EXPECT_EQ(evaluation.result, test.state.evaluation.result);
  EXPECT_EQ(evaluation.figures.at(0).value, 0.1 + 0.2);
  EXPECT_EQ(evaluation.figures.at(0).limit, 10.0);
  EXPECT_EQ(evaluation.figures.at(1).U, std::nullopt);
  EXPECT_EQ(must(store->content(content.sha256)).bytes, content.bytes);
  EXPECT_EQ(must(store->content_size(content.sha256)), std::ssize(content.bytes));
  EXPECT_EQ(store->content_size(sha256("of nothing")).error().kind, ErrorKind::not_found);
}

TEST_P(StoreTest, WarmsUpWithTestsAndWithout) {
  const auto store = new_store();
  EXPECT_TRUE(store->warm_up({}));
  must(store->receive(content_of("a", "a.csv"), std::vector{new_test("a", 1)}, by_anna));
  const auto warmed = store->warm_up({});
  EXPECT_TRUE(warmed) << why(warmed);
}

TEST_P(StoreTest, KeepsTheSameBytesOnce) {
  const auto store = new_store();
  must(store->receive(content_of("abc", "first.csv"), std::vector{new_test("a")}, by_anna));
  must(store->receive(content_of("abc", "second.csv"), std::vector{new_test("b")}, by_anna));
  EXPECT_EQ(must(store->counts()).content_bytes, 3);
  EXPECT_EQ(must(store->test(2)).file_name, "second.csv");
  TestFilter filter;
  filter.sha256 = sha256("abc");
  EXPECT_EQ(must(store->tests(filter)).total, 2);
}

TEST_P(StoreTest, KeepsAllTestsOfAFileOrNone) {
  const auto store = new_store();
  NewTest wrong = new_test("wrong");
  wrong.state.evaluation.figures[0].value = std::numeric_limits<double>::quiet_NaN();
  const auto refused = store->receive(content_of("abc"), std::vector{new_test("right"), wrong}, by_anna);
  EXPECT_THAT(why(refused), HasSubstr("not finite"));
  const Counts counts = must(store->counts());
  EXPECT_EQ(counts.tests + counts.machines + counts.content_bytes, 0);
  EXPECT_TRUE(must(store->audit("", 0, 10)).empty());
  EXPECT_THAT(must(store->receive(content_of("abc"), std::vector{new_test("right")}, by_anna)), ElementsAre(1));
}

TEST_P(StoreTest, KeepsAllThatIsWrittenTogetherOrNothing) {
  const auto store = new_store();
  const auto receive_both = [&](const Content& second) {
    return store->write([&](Transaction& archive) -> Result<std::int64_t> {
      AXIOMETRY_TRY_VOID(archive.receive(content_of("abc"), std::vector{new_test("a"), new_test("b")}, by_anna));
      AXIOMETRY_TRY_VOID(archive.receive(second, std::vector{new_test("c")}, by_anna));
      AXIOMETRY_TRY(const Counts counts, archive.counts());
      return counts.tests;
    });
  };
  Content wrong = content_of("def");
  wrong.bytes = "other";
  EXPECT_THAT(why(receive_both(wrong)), HasSubstr("SHA-256"));
  const Counts counts = must(store->counts());
  EXPECT_EQ(counts.tests + counts.machines + counts.content_bytes, 0);
  EXPECT_EQ(must(receive_both(content_of("def"))), 3) << "what was written is seen by what is read after it";
  EXPECT_EQ(must(store->test(3)).sha256, sha256("def"));
  EXPECT_TRUE(must(store->verify()).problems.empty());
}

TEST_P(StoreTest, ReadsAsOfOneMomentWhileAnotherWrites) {
  const auto store = new_store();
  MachineRecord mill;
  mill.name = "Mill";
  must(store->add(mill, by_anna));
  const auto versions = store->read([&](const Transaction& archive) -> Result<std::size_t> {
    AXIOMETRY_TRY(const auto before, archive.get<MachineRecord>(1));
    must(store->change(1, before.version, mill, by_anna));
    AXIOMETRY_TRY(const auto all, archive.versions<MachineRecord>(1));
    return all.size();
  });
  EXPECT_EQ(must(versions), 1u);
  EXPECT_EQ(must(store->versions<MachineRecord>(1)).size(), 2u);
}

TEST_P(StoreTest, TellsOfEachMachineHowManyTestsItHasAndTheLatest) {
  const auto store = new_store();
  EXPECT_TRUE(must(store->machine_tests()).empty());
  std::vector<NewTest> tests;
  for (const char* day : {"2020-01-03", "2020-01-01", "2020-01-03", "", "2020-01-09", "2019-01-01"}) {
    tests.push_back(new_test(day));
    tests.back().state.measured_on = day;
  }
  tests[1].state.evaluation.verdict = "undecided";
  tests[5].state.machine.name = "Mill 2";
  tests[5].state.machine.serial_number = "4712";
  tests[5].state.evaluation.verdict = "";
  must(store->receive(content_of("abc"), tests, by_anna));
  must(store->withdraw(5, true, by_anna));
  const auto all = must(store->machine_tests());
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].machine, 1);
  EXPECT_EQ(all[0].total, 4);
  EXPECT_EQ(all[0].latest.test, 4) << "without a day the day counts on which it came, as for axes";
  EXPECT_EQ(all[0].latest.measured_on, "");
  EXPECT_FALSE(all[0].latest.received_at.empty());
  EXPECT_EQ(all[0].latest.verdict, "conforms");
  must(store->withdraw(4, true, by_anna));
  EXPECT_EQ(must(store->machine_tests(1))[0].latest.test, 3) << "of two on a day the one that came later";
  EXPECT_EQ(all[1].latest.test, 6);
  EXPECT_EQ(all[1].latest.verdict, "");
  const auto one = must(store->machine_tests(2));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].machine, 2);
  EXPECT_TRUE(must(store->machine_tests(3)).empty());
}

/// A machine is due when one of its axes is, whatever was measured of the others.
TEST_P(StoreTest, TellsOfEachAxisTheLatestTest) {
  const auto store = new_store();
  EXPECT_TRUE(must(store->axes_latest()).empty());
  std::vector<NewTest> tests;
  for (const auto& [axis, day] : {std::pair{"X", "2020-01-03"},
                                  {"Z", "2017-05-01"},
                                  {"X", "2020-01-03"},
                                  {"X", "2020-01-09"},
                                  {"Z", "2016-05-01"},
                                  {"Y", ""}}) {
    tests.push_back(new_test(day));
    tests.back().state.measured_on = day;
    tests.back().state.axis.name = axis;
  }
  tests[1].state.evaluation.verdict = "undecided";
  tests[5].state.machine.name = "Mill 2";
  tests[5].state.machine.serial_number = "4712";
  must(store->receive(content_of("abc"), tests, by_anna));
  must(store->withdraw(4, true, by_anna));
  const auto all = must(store->axes_latest());
  ASSERT_EQ(all.size(), 3u);
  EXPECT_EQ(all[0].machine, 1);
  EXPECT_EQ(all[0].latest.test, 3) << "of two on a day the one that came later, and none that is withdrawn";
  EXPECT_EQ(all[1].latest.test, 2);
  EXPECT_EQ(all[1].latest.day(), "2017-05-01");
  EXPECT_EQ(all[1].latest.verdict, "undecided");
  EXPECT_EQ(all[2].machine, 2);
  EXPECT_EQ(all[2].latest.measured_on, "");
  EXPECT_EQ(all[2].latest.day(), all[2].latest.received_at.substr(0, 10));
  const auto one = must(store->axes_latest(2));
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].latest.test, 6);
  // One without a day counts by the day on which it arrived, which is later than that of the others.
  std::vector<NewTest> undated{new_test("undated")};
  undated.back().state.measured_on = "";
  undated.back().state.axis.name = "Z";
  must(store->receive(content_of("abd"), undated, by_anna));
  EXPECT_EQ(must(store->axes_latest(1))[1].latest.test, 7);
}

TEST_P(StoreTest, RefusesWhatOneOfTheDatabasesCouldNotKeep) {
  const auto store = new_store();
  EXPECT_THAT(why(store->receive(content_of("a"), std::vector{new_test("\xff")}, by_anna)), HasSubstr("UTF-8"));
  EXPECT_THAT(why(store->receive(content_of("a"), std::vector{new_test(std::string("a\0b", 3))}, by_anna)),
              HasSubstr("NUL"));
  Content lying = content_of("a");
  lying.bytes = "b";
  EXPECT_THAT(why(store->receive(lying, std::vector{new_test("a")}, by_anna)), HasSubstr("SHA-256"));
  NewTest no_json = new_test("a");
  no_json.state.changes = "{";
  EXPECT_THAT(why(store->receive(content_of("a"), std::vector{no_json}, by_anna)), HasSubstr("JSON"));
  EXPECT_FALSE(store->receive(content_of("a"), {}, by_anna));
  EXPECT_EQ(must(store->counts()).tests, 0);
}

TEST_P(StoreTest, KeepsEveryVersionOfATest) {
  const auto store = new_store();
  must(store->receive(content_of("abc"), std::vector{new_test("first", 1.0)}, by_anna));
  EXPECT_EQ(must(store->revise(1, 1, new_test("second", 2.0).state, {"Ben", "typing error"})), 2);
  EXPECT_EQ(must(store->test(1)).state.title, "second");
  EXPECT_EQ(must(store->test(1, 1)).state.title, "first");
  EXPECT_EQ(must(store->test(1, 1)).state.evaluation.figures[0].value, 1.0);
  EXPECT_EQ(must(store->test(1, 1)).latest, 2);
  EXPECT_EQ(store->test(1, 3).error().kind, ErrorKind::not_found);
  EXPECT_EQ(store->test(2).error().kind, ErrorKind::not_found);
  const auto versions = must(store->test_versions(1));
  ASSERT_EQ(versions.size(), 2u);
  EXPECT_EQ(versions[1].reason, "typing error");
}

TEST_P(StoreTest, TellsWhoWasFirstWhenTwoEditTheSameVersion) {
  const auto store = new_store();
  must(store->receive(content_of("abc"), std::vector{new_test("first")}, by_anna));
  must(store->revise(1, 1, new_test("Ben's").state, {"Ben", ""}));
  const auto late = store->revise(1, 1, new_test("Anna's").state, by_anna);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().kind, ErrorKind::conflict);
  EXPECT_THAT(late.error().message, HasSubstr("version 2 of this test, made by Ben at 20"));
  EXPECT_EQ(must(store->test(1)).state.title, "Ben's");
}

TEST_P(StoreTest, HidesWithdrawnTestsAndShowsThemWhenAsked) {
  const auto store = new_store();
  must(store->receive(content_of("abc"), std::vector{new_test("a"), new_test("b")}, by_anna));
  must(store->withdraw(1, true, {"Anna", "wrong axis"}));
  EXPECT_EQ(store->withdraw(1, true, by_anna).error().kind, ErrorKind::conflict);
  EXPECT_TRUE(must(store->test(1)).withdrawn);
  EXPECT_EQ(must(store->tests({})).total, 1);
  TestFilter all;
  all.withdrawn = true;
  for (const char* text : {"", "mill"}) {
    all.text = text;
    EXPECT_EQ(must(store->tests(all)).total, 2);
  }
  EXPECT_EQ(must(store->trend(1, std::vector<std::string>{"A"}, 10)).size(), 1u);
  EXPECT_TRUE(must(store->verify()).problems.empty());
  must(store->withdraw(1, false, by_anna));
  EXPECT_EQ(must(store->tests({})).total, 2);
  EXPECT_TRUE(must(store->verify()).problems.empty());
}

TEST_P(StoreTest, ShowsTheHistoryOfAnAxisByTheDateOfMeasurement) {
  const auto store = new_store();
  std::vector<NewTest> tests;
  for (const char* day : {"2020-01-03", "2020-01-01", "2020-01-02", "2020-01-02"}) {
    tests.push_back(new_test(day, static_cast<double>(tests.size() + 1)));
    tests.back().state.measured_on = day;
  }
  must(store->receive(content_of("abc"), tests, by_anna));
  const auto points = must(store->trend(1, std::vector<std::string>{"A", "B"}, 3));
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].test, 3);
  EXPECT_EQ(points[1].test, 4);
  EXPECT_EQ(points[2].test, 1);
  ASSERT_EQ(points[0].figures.size(), 1u);
  EXPECT_EQ(points[0].figures[0].value, 3.0);
  EXPECT_EQ(store->trend(2, {}, 3).error().kind, ErrorKind::not_found);
}

TEST_P(StoreTest, ShowsATestWithoutADateInTheHistoryOnTheDayItCame) {
  const auto store = new_store();
  std::vector<NewTest> tests;
  for (const char* day : {"", "2020-01-01", "2020-01-02"}) {
    tests.push_back(new_test("of this axis", static_cast<double>(tests.size() + 1)));
    tests.back().state.measured_on = day;
  }
  must(store->receive(content_of("abc"), tests, by_anna));
  const auto newest = [&](std::int64_t limit) {
    std::vector<Id> ids;
    for (const TrendPoint& point : must(store->trend(1, std::vector<std::string>{"A"}, limit)))
      ids.push_back(point.test);
    return ids;
  };
  EXPECT_EQ(newest(3), (std::vector<Id>{2, 3, 1}));
  EXPECT_EQ(newest(2), (std::vector<Id>{3, 1}));
}

TEST_P(StoreTest, CountsOneMeasurementOnceInTheHistoryOfItsAxis) {
  const auto store = new_store();
  const auto receive = [&](const char* name, const std::string& bytes, const std::vector<NewTest>& tests) {
    must(store->receive(content_of(bytes, name), tests, by_anna));
  };
  const auto course = [&](std::int64_t limit = 10) {
    std::string told;
    for (const TrendPoint& point : must(store->trend(1, std::vector<std::string>{"A"}, limit)))
      told += fmt::format("{}({}) ", point.test, fmt::join(point.same_bytes, ","));
    return told;
  };
  receive("one.csv", "abc", {new_test("a"), new_test("b")});
  EXPECT_EQ(course(), "1() 2() ") << "two tests of one file";
  receive("two.csv", "abc", {new_test("a"), new_test("b")});
  EXPECT_EQ(course(), "1(3) 2(4) ");
  receive("other.csv", "def", {new_test("a")});
  EXPECT_EQ(course(), "1(3) 2(4) 5() ");
  EXPECT_EQ(course(2), "2(4) 5() ") << "as many as were asked for";
  must(store->revise(4, 1, new_test("b, revised").state, by_anna));
  EXPECT_EQ(course(), "1(3) 4(2) 5() ") << "the one that somebody revised";
  must(store->withdraw(1, true, by_anna));
  EXPECT_EQ(course(), "3() 4(2) 5() ") << "and not the second of a file for the first of another";
}

TEST_P(StoreTest, KeepsIssuedReportsAndAttachments) {
  const auto store = new_store();
  must(store->receive(content_of("abc"), std::vector{new_test("a")}, by_anna));
  DocumentRecord report;
  report.test = 1;
  report.name = "report.pdf";
  report.media_type = "application/pdf";
  report.language = "de";
  const DocumentRecord kept = must(store->add_document(report, std::string_view("%PDF\0", 5), by_anna));
  EXPECT_EQ(kept.id, 1);
  EXPECT_EQ(kept.size, 5);
  EXPECT_EQ(must(store->content(must(store->document(1)).sha256)).bytes, std::string_view("%PDF\0", 5));
  EXPECT_EQ(must(store->documents(1)).size(), 1u);
  report.version = 2;
  EXPECT_EQ(store->add_document(report, "x", by_anna).error().kind, ErrorKind::not_found);
  EXPECT_EQ(store->document(2).error().kind, ErrorKind::not_found);
  EXPECT_EQ(store->documents(2).error().kind, ErrorKind::not_found);
}

TEST_P(StoreTest, WritesDownWhoDidWhat) {
  const auto store = new_store();
  must(store->receive(content_of("abc"), std::vector{new_test("a")}, by_anna));
  must(store->revise(1, 1, new_test("b").state, {"Ben", "typing error"}));
  const auto of_test = must(store->audit("test 1", 0, 10));
  ASSERT_EQ(of_test.size(), 2u);
  EXPECT_EQ(of_test[0].action, "test.revised");
  EXPECT_EQ(of_test[0].change.actor, "Ben");
  EXPECT_EQ(of_test[1].action, "test.received");
  const auto all = must(store->audit("", 0, 100));
  EXPECT_EQ(all.size(), 6u);  // bytes, machine, axis, instrument, and the two
  EXPECT_EQ(must(store->audit("", all[1].id, 1)).at(0).id, all[2].id);
}

}  // namespace
}  // namespace axiometry::store
