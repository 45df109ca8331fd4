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

using testing::HasSubstr;

class StoreBackupTest : public BothStores {};
AXIOMETRY_ON_BOTH_STORES(StoreBackupTest);

TEST_P(StoreBackupTest, GivesTheWholeArchiveBackAndGoesOnFromThere) {
  const auto store = must(Store::open(filled()));
  const std::string backup = file("copy.db");
  must(store->backup(backup));
  EXPECT_FALSE(std::filesystem::exists(backup + "-wal"));
  const std::string address = new_address();
  const Counts counts = must(Store::restore(backup, address)).counts;
  EXPECT_EQ(counts.tests, 2);
  EXPECT_EQ(counts.documents, 2);
  const auto restored = must(Store::open(address));
  const Verification verification = must(restored->verify());
  EXPECT_THAT(verification.problems, testing::IsEmpty());
  const auto before = must(store->audit("", 0, 100));
  const auto after = must(restored->audit("", 0, 100));
  ASSERT_EQ(after.size(), before.size() + 1);
  EXPECT_EQ(after[0].action, "store.restored");
  EXPECT_EQ(after[1].sha256, before[0].sha256);
  EXPECT_EQ(must(restored->test(1)).state.title, "a ä 'again'");
  const std::string no_text("bytes\0\xff", 7);
  EXPECT_EQ(must(restored->content(sha256(no_text))).bytes, no_text);
  EXPECT_EQ(must(restored->test(1)).state.evaluation.figures[0].value, 1e-300);
  EXPECT_EQ(must(restored->test(1, 1)).state.evaluation.figures[0].value, 0.1 + 0.2);
  EXPECT_EQ(must(restored->receive(content_of("next"), std::vector{new_test("c")}, by_anna)).at(0), 3);
  must(restored->revise(1, 2, new_test("third").state, by_anna));
  EXPECT_TRUE(must(restored->verify()).problems.empty());
}

TEST_P(StoreBackupTest, IsAStoreItselfAndIsVerifiedAsOne) {
  const std::string backup = file("copy.db");
  must(must(Store::open(filled()))->backup(backup));
  const auto store = must(Store::open(backup, {.create = false, .read_only = true}));
  EXPECT_EQ(must(store->verify()).tests, 2);
  EXPECT_TRUE(must(store->verify()).problems.empty());
}

TEST_P(StoreBackupTest, NeverReplacesAFile) {
  const auto store = must(Store::open(filled()));
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
  const auto store = must(Store::open(filled()));
  must(store->backup(file("copy.db")));
  const std::string address = new_address();
  MachineRecord machine;
  machine.name = "Mill";
  must(must(Store::open(address))->add(machine, by_anna));
  const auto refused = Store::restore(file("copy.db"), address);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::conflict);
  EXPECT_THAT(why(refused), HasSubstr("expected an empty one"));
  EXPECT_EQ(must(must(Store::open(address))->counts()).tests, 0);
}

TEST_P(StoreBackupTest, RestoresNothingFromADamagedBackup) {
  must(must(Store::open(filled()))->backup(file("copy.db")));
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

TEST_P(StoreBackupTest, IsMadeAndRestoredWithAnIndexAndAViewOfSomebodysOwn) {
  const std::string address = filled();
  must(raw(address)->script(
      "CREATE INDEX by_name ON machine_version (name); CREATE VIEW newest AS SELECT max(id) AS id FROM test"));
  const auto store = must(Store::open(address));
  const auto names_both = testing::UnorderedElementsAre(HasSubstr("index by_name"), HasSubstr("newest"));
  EXPECT_THAT(must(store->backup(file("copy.db"))).extras, names_both);
  if (store->info().kind == "postgresql")
    must(
        raw(file("copy.db"))->script("CREATE INDEX by_name ON machine_version (name); CREATE VIEW newest AS SELECT 1"));
  const std::string restored = new_address();
  EXPECT_THAT(must(Store::restore(file("copy.db"), restored)).left_behind, names_both);
  EXPECT_THAT(problems(restored), testing::IsEmpty());
  EXPECT_THAT(must(must(Store::open(restored))->verify()).extras, testing::IsEmpty());
}

TEST_P(StoreBackupTest, TellsWhatIsWrongWithTheTriggersThatItLeavesBehind) {
  if (sqlite()) GTEST_SKIP() << "a copy of a file has its triggers";
  const std::string address = filled();
  must(raw(address)->script(
      "ALTER TABLE figure DISABLE TRIGGER figure_unchanged; ALTER TABLE content ENABLE REPLICA TRIGGER "
      "content_unchanged; DROP INDEX audit_action; CREATE RULE quiet AS ON INSERT TO migration DO INSTEAD NOTHING"));
  const Verification made = must(must(Store::open(address))->backup(file("copy.db")));
  EXPECT_THAT(made.problems, testing::IsEmpty());
  EXPECT_THAT(made.notes,
              testing::UnorderedElementsAre(HasSubstr("in the archive, not in the backup: trigger figure_unchanged"),
                                            HasSubstr("in the archive, not in the backup: trigger content_unchanged"),
                                            HasSubstr("in the archive, not in the backup: rule quiet of migration")));
  EXPECT_THAT(problems(file("copy.db")), testing::IsEmpty());
}

TEST_P(StoreBackupTest, SaysThatWhatItLeavesBehindCouldNotBeCompared) {
  if (sqlite()) GTEST_SKIP() << "who reads a file may compare it";
  const std::string address = filled(), reader = fmt::format("reader_{}", ::getpid());
  const auto owner = raw(address);
  const std::string schema = must(owner->query("SELECT current_schema()::text"))[0].text(0);
  must(owner->script(fmt::format(
      "ALTER TABLE figure DISABLE TRIGGER figure_unchanged; CREATE ROLE {0} LOGIN; GRANT USAGE ON SCHEMA {1} TO {0}; "
      "GRANT SELECT ON ALL TABLES IN SCHEMA {1} TO {0}",
      reader, schema)));
  const auto made = [&] {
    const auto store = must(Store::open(address + "&user=" + reader, {.create = false, .read_only = true}));
    return must(store->backup(file("copy.db")));
  }();
  EXPECT_THAT(made.notes, testing::UnorderedElementsAre(HasSubstr("figure_unchanged of figure: found it switched off"),
                                                        HasSubstr("were not compared with those of schema")));
  must(owner->script(fmt::format("DROP OWNED BY {0}; DROP ROLE {0}", reader)));
}

TEST_P(StoreBackupTest, IsMadeAndRestoredWithoutAnIndexOfOurOwnAndTellsIt) {
  const std::string address = filled();
  must(raw(address)->script("DROP INDEX audit_action"));
  const auto store = must(Store::open(address));
  const auto lost = testing::ElementsAre(HasSubstr("index audit_action"));
  EXPECT_THAT(must(store->verify()).problems, lost);
  EXPECT_THAT(must(store->backup(file("copy.db"))).missing_indexes, lost);
  const std::string restored = new_address();
  EXPECT_EQ(must(Store::restore(file("copy.db"), restored)).counts.tests, 2);
  EXPECT_THAT(problems(restored), testing::IsEmpty());
}

TEST_P(StoreBackupTest, IsNotKeptWithoutAnIndexWhereMoreIsWrong) {
  const std::string address = filled();
  tamper(address, "figure", "UPDATE figure SET value = 7");
  must(raw(address)->script("DROP INDEX audit_action"));
  EXPECT_EQ(must(Store::open(address))->backup(file("copy.db")).error().kind, ErrorKind::damaged);
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
