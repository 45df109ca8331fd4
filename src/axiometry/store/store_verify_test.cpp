// SPDX-License-Identifier: Apache-2.0
// What a verification says of an archive whose rows are right, but which no longer keeps them so; and what it says of
// what it cannot see.
#include <gmock/gmock.h>

#include "axiometry/digest/ed25519.h"
#include "axiometry/store/audit_trail.h"
#include "axiometry/store/store.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using test::by_anna;
using test::content_of;
using test::must;
using test::new_test;
using test::why;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class StoreVerifyTest : public test::BothStores {
 protected:
  std::string filled() {
    const std::string address = new_address();
    const auto store = must(Store::open(address));
    must(store->receive(content_of("abc"), std::vector{new_test("a"), new_test("b")}, by_anna));
    return address;
  }

  static Verification verified(const std::string& address) {
    return must(must(Store::open(address, {.create = false, .read_only = true}))->verify());
  }
};
INSTANTIATE_TEST_SUITE_P(Both, StoreVerifyTest, testing::Values("sqlite", "postgresql"),
                         [](const auto& each) { return each.param; });

struct SchemaCase {
  const char* sql;
  const char* said;
};

constexpr SchemaCase sqlite_cases[] = {
    {"DROP TRIGGER audit_undeleted", "trigger audit_undeleted of audit: found none, expected the one of schema"},
    {"DROP TRIGGER figure_unchanged; CREATE TRIGGER figure_unchanged BEFORE UPDATE ON figure BEGIN SELECT 1; END",
     "trigger figure_unchanged of figure: found it altered, "},
    {"CREATE TRIGGER quiet AFTER INSERT ON audit BEGIN DELETE FROM test_search; END",
     "trigger quiet of audit: found one that schema"},
    {"DROP INDEX audit_subject", "index audit_subject of audit: found none"},
    {"ALTER TABLE machine_version ADD COLUMN colour text", "table machine_version: found it altered"},
    {"CREATE VIEW more AS SELECT 1", "view more of more: found one that schema"},
};

constexpr SchemaCase postgresql_cases[] = {
    {"DROP TRIGGER audit_unchanged ON audit",
     "trigger audit_unchanged of audit: found none, expected the one of schema"},
    {"ALTER TABLE figure DISABLE TRIGGER figure_unchanged", "trigger figure_unchanged of figure: found it altered, "},
    {"ALTER TABLE figure DISABLE TRIGGER ALL", "RI_FKey_check_ins of figure): found it altered"},
    {"CREATE OR REPLACE FUNCTION refuse_change() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN RETURN NEW; END $$",
     "function refuse_change(): found it altered"},
    {"CREATE FUNCTION quiet() RETURNS trigger LANGUAGE plpgsql AS $$ BEGIN RETURN NULL; END $$; CREATE TRIGGER quiet "
     "BEFORE INSERT ON audit FOR EACH ROW EXECUTE FUNCTION quiet()",
     "trigger quiet of audit: found one that schema"},
    {"DROP INDEX audit_subject", "index audit_subject of audit: found none"},
    {"ALTER TABLE machine_version ADD COLUMN colour text", "column colour of machine_version: found one that schema"},
    {"ALTER TABLE content DROP CONSTRAINT content_sha256_key CASCADE",
     "constraint content_sha256_key of content: found none"},
    {"CREATE RULE silent AS ON INSERT TO document DO INSTEAD NOTHING",
     "rule silent of document: found one that schema"},
};

TEST_P(StoreVerifyTest, FindsEachPartOfTheSchemaThatIsMissingAlteredOrExtra) {
  for (const SchemaCase& c : sqlite() ? std::span<const SchemaCase>(sqlite_cases) : postgresql_cases) {
    const std::string address = filled();
    const Verification before = verified(address);
    ASSERT_THAT(before.problems, IsEmpty());
    EXPECT_GT(before.parts, 100);
    must(raw(address)->script(c.sql));
    EXPECT_THAT(verified(address).problems, Contains(HasSubstr(c.said))) << c.sql;
  }
}

TEST_P(StoreVerifyTest, NamesEachOfTheTriggersWhenAllAreGone) {
  if (!sqlite()) GTEST_SKIP() << "the names are SQLite's";
  const std::string address = filled();
  {
    const auto connection = raw(address);
    const Rows guards = must(connection->query("SELECT name FROM sqlite_master WHERE type = 'trigger'"));
    for (const Row& guard : guards) must(connection->script("DROP TRIGGER " + guard.text(0)));
  }
  EXPECT_EQ(verified(address).problems.size(), 56u);
}

TEST_P(StoreVerifyTest, LeavesNothingOfItsOwnComparisonBehind) {
  if (sqlite()) GTEST_SKIP() << "SQLite's is in memory";
  const std::string address = filled();
  const auto count = [&] {
    return must(raw(address)->query("SELECT count(*) FROM pg_namespace WHERE nspname LIKE 'axiometry_comparison%'"))[0]
        .integer(0);
  };
  EXPECT_THAT(verified(address).problems, IsEmpty());
  EXPECT_EQ(count(), 0);
}

TEST_P(StoreVerifyTest, GivesTheHeadOfTheTrailAndSaysThatAMissingEndIsNotSeen) {
  const std::string address = filled();
  const Verification found = verified(address);
  const auto last = must(must(Store::open(address))->audit("", 0, 1));
  EXPECT_EQ(found.head.entries, last.at(0).id);
  EXPECT_EQ(found.head.sha256, last.at(0).sha256);
  EXPECT_EQ(found.head.at, last.at(0).change.at);
  EXPECT_THAT(found.unproved, Contains(HasSubstr("missing at the end")));
  EXPECT_THAT(found.proved, Contains(HasSubstr("tables, constraints, indexes and triggers")));
}

TEST_P(StoreVerifyTest, NotesThatTheClockWentBack) {
  const std::string address = filled();
  EXPECT_THAT(verified(address).notes, IsEmpty());
  {
    const auto connection = raw(address);
    must(connection->begin_write());
    must(record(*connection, {"2001-02-03T04:05:06.007Z", "Anna", "set the clock"}, {"clock.set", "store"}));
    must(connection->commit());
  }
  const Verification found = verified(address);
  EXPECT_THAT(found.problems, IsEmpty());
  EXPECT_THAT(found.notes, ElementsAre(HasSubstr("the clock went back between the entries")));
}

/// As if the second test and its file had never come: nothing that is left knows of them.
void cut_the_tail(const std::string& address, const std::string& last_entry,
                  void (*tamper)(const std::string&, const std::string&, const std::string&)) {
  for (const char* table :
       {"list_instrument", "test_search", "test_list", "figure", "evaluation", "test_instrument", "test_version"})
    tamper(address, table, fmt::format("DELETE FROM {} WHERE test = 2", table));
  tamper(address, "test", "DELETE FROM test WHERE id = 2");
  tamper(address, "content", "DELETE FROM content WHERE id = 2");
  tamper(address, "audit", "DELETE FROM audit WHERE id > " + last_entry);
}

class StoreSealTest : public StoreVerifyTest {
 protected:
  /// Of one test, and later of a second one that came with a file of its own.
  std::string begun() {
    const std::string address = new_address();
    must(must(Store::open(address))->receive(content_of("abc"), std::vector{new_test("a")}, by_anna));
    return address;
  }
  static void go_on(const std::string& address) {
    must(must(Store::open(address))->receive(content_of("def"), std::vector{new_test("b")}, by_anna));
  }
  Seal seal(const std::string& address) const { return must(must(Store::open(address))->seal(key_)); }
  static Verification verified(const std::string& address, const Seal& seal) {
    return must(must(Store::open(address, {.create = false, .read_only = true}))->verify(std::span(&seal, 1)));
  }

  SigningKey key_ = SigningKey::make();
};
INSTANTIATE_TEST_SUITE_P(Both, StoreSealTest, testing::Values("sqlite", "postgresql"),
                         [](const auto& each) { return each.param; });

TEST_P(StoreSealTest, ShowsThatTheEndOfTheTrailIsMissingWhichNothingElseDoes) {
  const std::string address = begun();
  const Seal early = seal(address);
  go_on(address);
  const Seal late = seal(address);
  EXPECT_THAT(verified(address, late).problems, IsEmpty());
  cut_the_tail(address, fmt::format("{}", early.head.entries), &tamper);
  EXPECT_THAT(StoreVerifyTest::verified(address).problems, IsEmpty());
  EXPECT_THAT(verified(address, early).problems, IsEmpty());
  EXPECT_THAT(verified(address, late).problems, ElementsAre(HasSubstr("its end is missing")));
  const auto renewed = must(Store::open(address))->seal(key_, late);
  ASSERT_FALSE(renewed);
  EXPECT_EQ(renewed.error().kind, ErrorKind::damaged);
}

TEST_P(StoreSealTest, SaysByHowMuchTheTrailHasGrown) {
  const std::string address = begun();
  const Seal early = seal(address);
  go_on(address);
  const Verification found = verified(address, early);
  EXPECT_THAT(found.problems, IsEmpty());
  EXPECT_THAT(found.proved, Contains(HasSubstr(fmt::format("(entry {}), {} entries longer now", early.head.entries,
                                                           found.entries - early.head.entries))));
  EXPECT_THAT(found.unproved, Not(Contains(HasSubstr("missing at the end"))));
  const Seal next = must(must(Store::open(address))->seal(key_, early));
  EXPECT_EQ(next.head.entries, found.entries);
  EXPECT_EQ(next.public_key, early.public_key);
}

TEST_P(StoreSealTest, ShowsATrailThatWasWrittenAnewFromItsBeginning) {
  const std::string address = begun();
  const Seal early = seal(address);
  const std::string other = begun();  // at another time: no hash is the same
  EXPECT_THAT(verified(other, early).problems, ElementsAre(HasSubstr("as it was sealed at")));
}

TEST_P(StoreSealTest, IsNotMadeOfAnArchiveWithoutEntries) {
  EXPECT_FALSE(must(Store::open(new_address()))->seal(key_));
}

TEST(Seal, ReadsBackAsItWasWrittenAndNotWhenAnythingInItWasChanged) {
  const Seal made = sealed({7, sha256("x"), "2026-11-23T08:00:00.000Z"}, SigningKey::make());
  const std::string text = text_of(made);
  const Seal read = must(read_seal(text));
  EXPECT_EQ(read.head.entries, 7);
  EXPECT_EQ(read.head.sha256, made.head.sha256);
  EXPECT_EQ(read.head.at, made.head.at);
  EXPECT_EQ(read.at, made.at);
  EXPECT_EQ(read.public_key, made.public_key);
  for (const auto& [from, to] : {std::pair{": 7", ": 6"}, {"T08:00:00.000", "T09:00:00.000"}, {"seal-1", "seal-2"}}) {
    std::string changed = text;
    changed.replace(changed.find(from), std::string(from).size(), to);
    EXPECT_FALSE(read_seal(changed)) << changed;
  }
  for (const char* none : {"", "[]", "{}", R"({"format":"axiometry-seal-1","entries":0.5})"})
    EXPECT_FALSE(read_seal(none)) << none;
}

}  // namespace
}  // namespace axiometry::store
