// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <latch>
#include <thread>

#include "axiometry/store/store.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using test::by_anna;
using test::content_of;
using test::must;
using test::new_test;
using test::why;
using testing::HasSubstr;

class StoreBackupTest : public test::BothStores {
 protected:
  std::unique_ptr<Store> filled() {
    auto store = must(Store::open(new_address()));
    must(store->receive(content_of(std::string("abc\0\xff", 5)), std::vector{new_test("a", 0.1 + 0.2), new_test("b")},
                        by_anna));
    must(store->revise(1, 1, new_test("a ä 'again'", 1e-300).state, {"Ben", "reason"}));
    must(store->withdraw(2, true, by_anna));
    Document document;
    document.test = 1;
    document.name = "report.pdf";
    must(store->add_document(document, "bytes", by_anna));
    must(store->add(PlanRecord{"Plan", 1, sha256("bytes")}, by_anna));
    return store;
  }
};
INSTANTIATE_TEST_SUITE_P(Both, StoreBackupTest, testing::Values("sqlite", "postgresql"),
                         [](const auto& each) { return each.param; });

TEST_P(StoreBackupTest, GivesTheWholeArchiveBackAndGoesOnFromThere) {
  const auto store = filled();
  const std::string backup = file("copy.db");
  must(store->backup(backup));
  EXPECT_FALSE(std::filesystem::exists(backup + "-wal"));
  const std::string address = new_address();
  const Counts counts = must(Store::restore(backup, address));
  EXPECT_EQ(counts.tests, 2);
  EXPECT_EQ(counts.documents, 1);
  const auto restored = must(Store::open(address));
  const Verification verification = must(restored->verify());
  EXPECT_THAT(verification.problems, testing::IsEmpty());
  const auto before = must(store->audit("", 0, 100));
  const auto after = must(restored->audit("", 0, 100));
  ASSERT_EQ(after.size(), before.size() + 1);
  EXPECT_EQ(after[0].action, "store.restored");
  EXPECT_EQ(after[1].sha256, before[0].sha256);
  EXPECT_EQ(must(restored->test(1)).state.title, "a ä 'again'");
  EXPECT_EQ(must(restored->test(1)).state.evaluation.figures[0].value, 1e-300);
  EXPECT_EQ(must(restored->test(1, 1)).state.evaluation.figures[0].value, 0.1 + 0.2);
  EXPECT_EQ(must(restored->receive(content_of("next"), std::vector{new_test("c")}, by_anna)).at(0), 3);
  must(restored->revise(1, 2, new_test("third").state, by_anna));
  EXPECT_TRUE(must(restored->verify()).problems.empty());
}

TEST_P(StoreBackupTest, IsAStoreItselfAndIsVerifiedAsOne) {
  const std::string backup = file("copy.db");
  must(filled()->backup(backup));
  const auto store = must(Store::open(backup, {.create = false, .read_only = true}));
  EXPECT_EQ(must(store->verify()).tests, 2);
  EXPECT_TRUE(must(store->verify()).problems.empty());
}

TEST_P(StoreBackupTest, NeverReplacesAFile) {
  const auto store = filled();
  std::ofstream(file("there.db")) << "precious";
  const auto refused = store->backup(file("there.db"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::conflict);
  EXPECT_EQ(std::filesystem::file_size(file("there.db")), 8u);
  EXPECT_FALSE(store->backup(file("no/such/folder/copy.db")));
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(file(".")))
    files += entry.path().string().find(".part-") != std::string::npos;
  EXPECT_EQ(files, 0u) << "nothing half made stays";
}

TEST_P(StoreBackupTest, FillsNoStoreThatHoldsAnything) {
  const auto store = filled();
  must(store->backup(file("copy.db")));
  const std::string address = new_address();
  Machine machine;
  machine.name = "Mill";
  must(must(Store::open(address))->add(machine, by_anna));
  const auto refused = Store::restore(file("copy.db"), address);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::conflict);
  EXPECT_THAT(why(refused), HasSubstr("expected an empty one"));
  EXPECT_EQ(must(must(Store::open(address))->counts()).tests, 0);
}

TEST_P(StoreBackupTest, RestoresNothingFromADamagedBackup) {
  must(filled()->backup(file("copy.db")));
  {
    const auto connection = raw(file("copy.db"));
    must(connection->script("DROP TRIGGER figure_unchanged; UPDATE figure SET value = 7"));
  }
  const std::string address = new_address();
  const auto refused = Store::restore(file("copy.db"), address);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::damaged);
  EXPECT_EQ(Store::open(address, {.create = false}).error().kind, ErrorKind::not_found) << "not even begun";
  EXPECT_FALSE(Store::restore(file("none.db"), address));
}

TEST_P(StoreBackupTest, IsNotKeptWhereTheCopyIsNotWhole) {
  const std::string address = new_address();
  const auto store = must(Store::open(address));
  must(store->receive(content_of("abc"), std::vector{new_test("a")}, by_anna));
  tamper(address, "figure", "UPDATE figure SET value = 7");
  const auto refused = store->backup(file("copy.db"));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::damaged);
  EXPECT_THAT(why(refused), HasSubstr("test 1: found version 1 changed after it was kept"));
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(file(".")))
    files += entry.path().string().find("copy.db") != std::string::npos;
  EXPECT_EQ(files, 0u) << "nothing that is not whole stays";
}

TEST_P(StoreBackupTest, IsOfOneMomentWhileOthersWrite) {
  const std::string address = new_address();
  const auto store = must(Store::open(address));
  std::atomic<bool> done = false;
  std::latch written(1);
  std::thread writer([&] {
    const auto other = must(Store::open(address));
    for (int k = 0; !done; ++k) {
      must(other->receive(content_of(fmt::format("{}", k)), std::vector{new_test("t")}, by_anna));
      if (k == 0) written.count_down();
    }
  });
  written.wait();
  std::int64_t before = 0;
  for (int k = 0; k < 5; ++k) {
    const std::string backup = file(fmt::format("copy{}.db", k));
    const auto made = store->backup(backup);
    EXPECT_TRUE(made) << why(made);
    const Verification found = must(must(Store::open(backup, {.create = false, .read_only = true}))->verify());
    EXPECT_THAT(found.problems, testing::IsEmpty());
    EXPECT_GE(found.tests, before);
    before = found.tests;
  }
  done = true;
  writer.join();
  EXPECT_GT(before, 0);
}

}  // namespace
}  // namespace axiometry::store
