// SPDX-License-Identifier: Apache-2.0
// What a verification says of an archive whose rows are right, but which no longer keeps them so; and what it says of
// what it cannot see.
#include <gmock/gmock.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>

#include "axiometry/digest/ed25519.h"
#include "axiometry/store/proof/attested.h"
#include "axiometry/store/proof/audit_trail.h"
#include "axiometry/store/proof/id_walk.h"
#include "axiometry/store/proof/schema_parts.h"
#include "axiometry/store/store.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

class StoreVerifyTest : public BothStores {};
AXIOMETRY_ON_BOTH_STORES(StoreVerifyTest);

/// SQLite reads zeros for what was cut off, and passes over what was added.
TEST_P(StoreVerifyTest, FindsAFileWithoutTheBytesOfItsPages) {
  if (!sqlite()) return;
  const auto said = [&](auto change) {
    const std::string address = filled();
    change(address);
    return verified(address).problems;
  };
  const auto resized = [](std::intmax_t by) {
    return [by](const std::string& file) {
      std::filesystem::resize_file(file, static_cast<std::uintmax_t>(std::filesystem::file_size(file) + by));
    };
  };
  EXPECT_THAT(said([](const std::string&) {}), IsEmpty());
  EXPECT_THAT(said(resized(-1)), Contains(HasSubstr("pages of 4096 bytes")));
  EXPECT_THAT(said(resized(1)), Contains(HasSubstr("pages of 4096 bytes")));
  EXPECT_THAT(said(resized(4096)), Contains(HasSubstr("pages of 4096 bytes")));
}

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
    {"CREATE UNIQUE INDEX once ON audit (at, actor, subject, id)", "index once of audit: found one that schema"},
    {"CREATE INDEX computed ON audit (abs(id))", "index computed of audit: found one that schema"},
    {"CREATE INDEX partly ON audit (id) WHERE abs(id) > 1", "index partly of audit: found one that schema"},
};

constexpr SchemaCase postgresql_cases[] = {
    {"DROP TRIGGER audit_unchanged ON audit",
     "trigger audit_unchanged of audit: found none, expected the one of schema"},
    {"ALTER TABLE figure DISABLE TRIGGER figure_unchanged", "trigger figure_unchanged of figure: found it altered, "},
    {"ALTER TABLE figure ENABLE REPLICA TRIGGER figure_unchanged",
     "trigger figure_unchanged of figure: found it altered, "},
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
    {"CREATE TABLE more () INHERITS (content)", "inheritance more of content: found one that schema"},
    {"CREATE UNIQUE INDEX once ON audit (at, actor, subject, id)", "index once of audit: found one that schema"},
    {"CREATE INDEX computed ON audit (abs(id))", "index computed of audit: found one that schema"},
    {"CREATE INDEX partly ON audit (id) WHERE abs(id) > 1", "index partly of audit: found one that schema"},
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

TEST_P(StoreVerifyTest, TellsWhichCellIsStoredInAnotherClass) {
  if (!sqlite()) GTEST_SKIP() << "PostgreSQL has no such cells";
  const std::string address = filled();
  must(raw(address)->script(
      "DROP TRIGGER audit_unchanged; UPDATE audit SET subject = CAST(subject AS blob) WHERE id = 2; DROP TRIGGER "
      "figure_unchanged; UPDATE figure SET tolerance = x'31' WHERE test = 1 AND version = 2 AND place = 1; DROP "
      "TRIGGER content_unchanged; UPDATE content SET bytes = CAST(bytes AS text) WHERE id = 1"));
  const std::vector<std::string> problems = verified(address).problems;
  for (const char* said :
       {"audit: found subject of id 2 stored as blob, expected text",
        "figure: found tolerance of test 1, version 2, place 1 stored as blob, expected real or null",
        "content: found bytes of id 1 stored as text, expected blob"})
    EXPECT_THAT(problems, Contains(said));
}

TEST_P(StoreVerifyTest, TellsWhatIsSomebodysOwnAndIsNoFaultOfTheArchive) {
  const std::string address = filled();
  must(raw(address)->script(
      "CREATE TABLE notes (text text); CREATE VIEW newest AS SELECT max(id) AS id FROM test; CREATE INDEX by_name ON "
      "machine_version (name)"));
  const Verification found = verified(address);
  EXPECT_THAT(found.problems, IsEmpty());
  for (const char* name : {"table notes", "newest", "index by_name of machine_version"})
    EXPECT_THAT(found.extras, Contains(HasSubstr(name)));
}

TEST_P(StoreVerifyTest, FindsNoFaultWithWhatInheritsFromATableOfSomebodysOwn) {
  if (sqlite()) GTEST_SKIP() << "SQLite knows no such tables";
  const std::string address = filled();
  must(raw(address)->script(
      "CREATE TABLE notes (id integer) PARTITION BY RANGE (id); CREATE TABLE some_notes PARTITION OF notes FOR VALUES "
      "FROM (0) TO (9); CREATE UNIQUE INDEX notes_once ON notes (id)"));
  EXPECT_THAT(verified(address).problems, IsEmpty());
}

TEST(SchemaParts, AreSwitchedOffByNameWhereverTheyDoNotFireForWhoWrites) {
  SchemaParts parts;
  for (const char* state : {"", ", on in replicas, too", ", on in replicas only, switched off", ", switched off"}) {
    parts[fmt::format("trigger t{} of audit", parts.size())] = fmt::format("CREATE TRIGGER t{}", state);
    parts[fmt::format("reference r{} (check of audit)", parts.size())] = fmt::format("trigger{}", state);
  }
  const auto off = [](const std::string& problem) {
    return problem.ends_with("found it switched off, expected it on");
  };
  const std::vector<std::string> problems = differences_by_name(parts, false).problems;
  EXPECT_EQ(std::ranges::count_if(problems, off), 4);
}

TEST(IdCount, CountsToTheLastNumberThatThereIs) {
  constexpr Id last = std::numeric_limits<Id>::max();
  std::vector<std::string> said;
  IdCount count("test");
  for (const Id id : {std::numeric_limits<Id>::min(), Id{1}, Id{3}, last - 1, last}) count.next(id, said);
  EXPECT_THAT(said, ElementsAre("test 2: found none, expected all without gaps",
                                fmt::format("test 4 to {}: found none, expected all without gaps", last - 2)));
}

TEST(Attested, TakesNoHashOfAnEntryWhoseVersionIsNoNumberOfOne) {
  const auto knows = [](const std::string& version, int asked) {
    Attested attested;
    attested.add({.id = 1,
                  .change = {},
                  .action = "test.revised",
                  .subject = "test 1",
                  .detail = fmt::format(R"({{"sha256":"abc"{}}})", version),
                  .sha256 = ""});
    return attested.knows("test 1", asked, "abc") && attested.count("test") == 1;
  };
  EXPECT_TRUE(knows("", 0));
  EXPECT_TRUE(knows(R"(,"version":1)", 1));
  EXPECT_TRUE(knows(R"(,"version":2147483647)", 2147483647));
  for (const char* none : {"1.5", "1e300", "-1e300", "-1", "2147483648", "\"1\"", "null"})
    for (const int asked : {0, 1, -1, std::numeric_limits<int>::max(), std::numeric_limits<int>::min()})
      EXPECT_FALSE(knows(fmt::format(R"(,"version":{})", none), asked)) << none;
}

TEST_P(StoreVerifyTest, NamesEachOfTheTriggersWhenAllAreGone) {
  if (!sqlite()) GTEST_SKIP() << "the names are SQLite's";
  const std::string address = filled();
  {
    const auto connection = raw(address);
    const Rows guards = must(connection->query("SELECT name FROM sqlite_master WHERE type = 'trigger'"));
    for (const Row& guard : guards) must(connection->script("DROP TRIGGER " + guard.text(0)));
  }
  EXPECT_EQ(verified(address).problems.size(), 70u);
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
  static Verification verified_with(const std::string& address, const Seal& seal) {
    return verified(address, std::span(&seal, 1));
  }

  SigningKey key_ = SigningKey::make();
};
AXIOMETRY_ON_BOTH_STORES(StoreSealTest);

TEST_P(StoreSealTest, ShowsThatTheEndOfTheTrailIsMissingWhichNothingElseDoes) {
  const std::string address = begun();
  const Seal early = seal(address);
  go_on(address);
  const Seal late = seal(address);
  EXPECT_THAT(verified_with(address, late).problems, IsEmpty());
  cut_the_tail(address, fmt::format("{}", early.head.entries), &tamper);
  EXPECT_THAT(verified(address).problems, IsEmpty());
  EXPECT_THAT(verified_with(address, early).problems, IsEmpty());
  EXPECT_THAT(verified_with(address, late).problems, ElementsAre(HasSubstr("its end is missing")));
  const auto renewed = must(Store::open(address))->seal(key_, {.earlier = late});
  ASSERT_FALSE(renewed);
  EXPECT_EQ(renewed.error().kind, ErrorKind::damaged);
}

TEST_P(StoreSealTest, SaysByHowMuchTheTrailHasGrown) {
  const std::string address = begun();
  const Seal early = seal(address);
  go_on(address);
  const Verification found = verified_with(address, early);
  EXPECT_THAT(found.problems, IsEmpty());
  EXPECT_THAT(found.proved, Contains(HasSubstr(fmt::format("(entry {}), {} entries longer now", early.head.entries,
                                                           found.entries - early.head.entries))));
  EXPECT_THAT(found.unproved, Not(Contains(HasSubstr("missing at the end"))));
  const Seal next = must(must(Store::open(address))->seal(key_, {.earlier = early}));
  EXPECT_EQ(next.head.entries, found.entries);
  EXPECT_EQ(next.public_key, early.public_key);
}

TEST_P(StoreSealTest, ShowsATrailThatWasWrittenAnewFromItsBeginning) {
  const std::string address = begun();
  const Seal early = seal(address);
  const std::string other = begun();  // at another time: no hash is the same
  EXPECT_THAT(verified_with(other, early).problems, ElementsAre(HasSubstr("as it was sealed at")));
}

TEST_P(StoreSealTest, ProvesNothingOfATrailThatIsBrokenBehindIt) {
  const std::string address = begun();
  const Seal early = seal(address);
  go_on(address);
  tamper(address, "audit", fmt::format("UPDATE audit SET actor = 'Ben' WHERE id = {}", early.head.entries + 2));
  const Verification found = verified_with(address, early);
  EXPECT_THAT(found.problems, Contains(HasSubstr(fmt::format("found entry {}", early.head.entries + 2))));
  EXPECT_THAT(found.proved, IsEmpty());
  EXPECT_THAT(found.unproved, Contains(HasSubstr("goes on from the seal")));
}

TEST_P(StoreSealTest, IsSaidNotToBeReachedWhereReadingStopsBeforeIt) {
  const std::string address = begun();
  const Seal early = seal(address);
  must(raw(address)->script("DROP TABLE test_search"));
  const auto store = must(Store::open(address, {.create = false, .read_only = true}));
  const Verification found = must(store->verify(std::span(&early, 1), std::span(&early.head, 1)));
  EXPECT_THAT(found.problems, Contains(HasSubstr("the rest was not looked at")));
  EXPECT_THAT(found.proved, IsEmpty());
  for (const std::string& known : {"seal of " + early.at, fmt::format("head {}:", early.head.entries)})
    EXPECT_THAT(found.unproved, Contains(testing::AllOf(HasSubstr("goes on from the " + known),
                                                        testing::EndsWith("it was not reached"))));
}

TEST_P(StoreSealTest, AHeadOnPaperShowsWhatASealShows) {
  const std::string address = begun();
  const Seal early = seal(address);
  go_on(address);
  const auto verified_with_head = [](const std::string& archive, const std::string& text) {
    const Head head = must(read_short_head(text));
    return must(must(Store::open(archive, {.create = false, .read_only = true}))->verify({}, std::span(&head, 1)));
  };
  const std::string paper = short_text(early.head);
  const std::string late = short_text(must(must(Store::open(address))->head()));
  const Verification found = verified_with_head(address, paper);
  EXPECT_THAT(found.problems, IsEmpty());
  EXPECT_THAT(found.proved, Contains(HasSubstr("goes on from the head " + paper)));
  EXPECT_THAT(found.unproved, Not(Contains(HasSubstr("missing at the end"))));
  EXPECT_THAT(verified_with_head(begun(), paper).problems, ElementsAre(HasSubstr("expected one that begins with")));
  tamper(address, "audit", fmt::format("UPDATE audit SET actor = 'Ben' WHERE id = {}", early.head.entries + 2));
  EXPECT_THAT(verified_with_head(address, paper).proved, IsEmpty());
  cut_the_tail(address, fmt::format("{}", early.head.entries), &tamper);
  EXPECT_THAT(verified_with_head(address, paper).problems, IsEmpty());
  EXPECT_THAT(verified_with_head(address, late).problems, ElementsAre(HasSubstr("its end is missing")));
}

TEST(ShortHead, ReadsBackAndNothingElse) {
  const Head head{17, sha256("x"), ""};
  const std::string text = short_text(head);
  EXPECT_EQ(text, "17:" + head.sha256.substr(0, 16));
  EXPECT_EQ(must(read_short_head(" " + text + "\n")).entries, 17);
  EXPECT_EQ(must(read_short_head("17:" + head.sha256)).sha256, head.sha256);
  for (const char* none : {"", "17", "17:", ":3f2a9c0b1d2e4f56", "17:3f2a", "0:3f2a9c0b1d2e4f56", "17:3f2a9c0b1d2e4f5g",
                           "17:3f2a9c0b1d2e4f56:1", "-1:3f2a9c0b1d2e4f56", "99999999999:3f2a9c0b1d2e4f56"})
    EXPECT_FALSE(read_short_head(none)) << none;
}

TEST_P(StoreSealTest, IsNotMadeOfABrokenTrail) {
  const std::string address = begun();
  tamper(address, "audit", "UPDATE audit SET actor = 'Ben' WHERE id = 2");
  const auto refused = must(Store::open(address))->seal(key_);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().kind, ErrorKind::damaged);
  EXPECT_THAT(why(refused), HasSubstr("entry 2"));
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
