// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include <functional>

#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class StoreCompensationsTest : public BothStores {
 protected:
  /// With tests 1 and 2 of axis 1 and the bytes "abc".
  void open() {
    address_ = new_address();
    store_ = must(Store::open(address_));
    must(store_->receive(content_of("abc"), std::vector{new_test("a"), new_test("b")}, by_anna));
  }

  std::vector<Id> found(const CompensationFilter& filter) const {
    std::vector<Id> ids;
    for (const CompensationRow& row : must(store_->compensations(filter))) ids.push_back(row.compensation.id);
    return ids;
  }

  std::string address_;
  std::unique_ptr<Store> store_;
};
AXIOMETRY_ON_BOTH_STORES(StoreCompensationsTest);

TEST_P(StoreCompensationsTest, AreReadAsTheyWereKept) {
  open();
  const auto kept = must(store_->add(new_compensation(), by_anna));
  const auto read = must(store_->get<CompensationRecord>(kept.id));
  EXPECT_EQ(read.version, 1);
  const CompensationRecord& c = read.value;
  EXPECT_EQ(c.test, 1);
  EXPECT_EQ(c.test_version, 1);
  EXPECT_FALSE(c.retest);
  EXPECT_FALSE(c.retest_version);
  EXPECT_EQ(c.axis, 1);
  EXPECT_EQ(c.control, "linuxcnc");
  EXPECT_EQ(c.notes, "after the new screw");
  EXPECT_FALSE(c.withdrawn);
  ASSERT_EQ(c.files.size(), 2u);
  EXPECT_EQ(c.files[1].role, "existing");
  EXPECT_EQ(c.files[1].name, "old.comp");
  EXPECT_EQ(c.files[1].content, sha256("abc"));
  EXPECT_EQ(c.program, "axiometry 0.1.0");
  EXPECT_EQ(c.options, R"({"control":"linuxcnc"})");
  EXPECT_EQ(c.result, sha256("abc"));
  EXPECT_EQ(c.serious, 1);
  ASSERT_EQ(c.figures.size(), 2u);
  EXPECT_EQ(c.figures[0].of, "before");
  EXPECT_EQ(c.figures[0].value, 0.1 + 0.2);
  EXPECT_EQ(c.figures[1].value, 1e-300);
  EXPECT_EQ(must(store_->counts()).compensations, 1);
}

TEST_P(StoreCompensationsTest, GetTheirRetestAsAVersion) {
  open();
  CompensationRecord c = new_compensation();
  must(store_->add(c, by_anna));
  c.retest = 2;
  EXPECT_THAT(why(store_->change(1, 1, c, by_anna)), HasSubstr("a re-test without its version"));
  c.retest_version = 7;
  EXPECT_THAT(why(store_->change(1, 1, c, by_anna)), HasSubstr("found no test 2 in version 7"));
  c.retest_version = 1;
  must(store_->change(1, 1, c, {"Ben", "measured again"}));
  EXPECT_EQ(must(store_->get<CompensationRecord>(1)).value.retest, 2);
  EXPECT_FALSE(must(store_->get<CompensationRecord>(1, 1)).value.retest);
  c.retest = 1;
  EXPECT_THAT(why(store_->change(1, 2, c, by_anna)), HasSubstr("as its own re-test"));
}

TEST_P(StoreCompensationsTest, StayWhatIsInTheControl) {
  open();
  const CompensationRecord kept = new_compensation();
  must(store_->add(kept, by_anna));
  must(store_->keep(content_of("other"), by_anna));
  for (const auto& edit : std::vector<std::function<void(CompensationRecord&)>>{
           [](CompensationRecord& c) { c.files[0].content = sha256("other"); },
           [](CompensationRecord& c) { c.files.pop_back(); }, [](CompensationRecord& c) { c.test = 2; },
           [](CompensationRecord& c) { c.control = "fanuc"; },
           [](CompensationRecord& c) { c.options = R"({"control":"linuxcnc","smooth":true})"; },
           [](CompensationRecord& c) { c.axis.reset(); }}) {
    CompensationRecord other = kept;
    edit(other);
    EXPECT_THAT(why(store_->change(1, 1, other, by_anna)), HasSubstr("another test, control or other files"));
  }
  EXPECT_EQ(must(store_->versions<CompensationRecord>(1)).size(), 1u);
}

TEST_P(StoreCompensationsTest, AreRefusedWithoutATableAndOfWhatIsNotThere) {
  open();
  CompensationRecord c = new_compensation();
  c.files.erase(c.files.begin());
  EXPECT_THAT(why(store_->add(c, by_anna)), HasSubstr("without its table"));
  c = new_compensation();
  c.test = 3;
  EXPECT_THAT(why(store_->add(c, by_anna)), HasSubstr("found no test 3 in version 1"));
  c = new_compensation();
  c.axis = 9;
  EXPECT_THAT(why(store_->add(c, by_anna)), HasSubstr("found no axis 9"));
  c = new_compensation();
  c.result = sha256("nothing");
  EXPECT_THAT(why(store_->add(c, by_anna)), HasSubstr("those of the result"));
  EXPECT_EQ(must(store_->counts()).compensations, 0);
}

TEST_P(StoreCompensationsTest, AreFoundByTheirTestsAndTheirAxis) {
  open();
  CompensationRecord c = new_compensation();
  must(store_->add(c, by_anna));
  c.test = 2;
  c.axis.reset();
  must(store_->add(c, by_anna));
  c.retest = 1;
  c.retest_version = 1;
  must(store_->change(2, 1, c, by_anna));
  EXPECT_THAT(found({}), ElementsAre(2, 1));
  EXPECT_THAT(found({.test = 1}), ElementsAre(2, 1));
  EXPECT_THAT(found({.test = 2}), ElementsAre(2));
  EXPECT_THAT(found({.axis = 1}), ElementsAre(1));
  EXPECT_THAT(found({.axis = 5}), IsEmpty());
  c.withdrawn = true;
  must(store_->change(2, 2, c, {"Ben", "wrong control"}));
  EXPECT_THAT(found({}), ElementsAre(1));
  EXPECT_THAT(found({.withdrawn = true}), ElementsAre(2, 1));
  EXPECT_THAT(found({.withdrawn = true, .limit = 1}), ElementsAre(2));
  const auto entries = must(store_->audit("compensation 2", 0, 10));
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[0].action, "compensation.withdrawn");
  EXPECT_EQ(entries[2].action, "compensation.added");
}

TEST_P(StoreCompensationsTest, AreVerifiedAndCopied) {
  const std::string address = filled();
  EXPECT_THAT(problems(address), IsEmpty());
  must(must(Store::open(address))->backup(file("copy.db")));
  const auto copied = must(must(Store::open(file("copy.db")))->versions<CompensationRecord>(1));
  ASSERT_EQ(copied.size(), 2u);
  EXPECT_EQ(copied[1].value.retest, 2);
}

}  // namespace
}  // namespace axiometry::store
