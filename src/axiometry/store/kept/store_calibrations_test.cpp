// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class StoreCalibrationsTest : public BothStores {
 protected:
  /// With machine 1, instrument 1 and the bytes "abc".
  void open() {
    address_ = new_address();
    store_ = must(Store::open(address_));
    must(store_->receive(content_of("abc"), std::vector{new_test("a")}, by_anna));
  }

  std::vector<Id> found(const CalibrationFilter& filter) const {
    std::vector<Id> ids;
    for (const CalibrationRow& row : must(store_->calibrations(filter)).rows) ids.push_back(row.calibration.id);
    return ids;
  }

  std::string address_;
  std::unique_ptr<Store> store_;
};
AXIOMETRY_ON_BOTH_STORES(StoreCalibrationsTest);

TEST_P(StoreCalibrationsTest, AreReadAsTheyWereKept) {
  open();
  const auto kept = must(store_->add(new_calibration("volume"), by_anna));
  const auto read = must(store_->get<CalibrationRecord>(kept.id));
  EXPECT_EQ(read.version, 1);
  EXPECT_EQ(read.change.reason, "because");
  const CalibrationRecord& c = read.value;
  EXPECT_EQ(c.kind, "volumetric");
  EXPECT_EQ(c.title, "volume");
  EXPECT_EQ(c.machine, 1);
  EXPECT_EQ(c.instrument, 1);
  EXPECT_EQ(c.instrument_version, 1);
  EXPECT_EQ(c.measured_on, "2014-05-16");
  EXPECT_EQ(c.notes, "after the crash");
  EXPECT_FALSE(c.withdrawn);
  ASSERT_EQ(c.files.size(), 2u);
  EXPECT_EQ(c.files[1].role, "machine");
  EXPECT_EQ(c.files[1].name, "machine.json");
  EXPECT_EQ(c.files[1].content, sha256("abc"));
  EXPECT_EQ(c.program, "axiometry 0.1.0");
  EXPECT_EQ(c.options, R"({"reversal":"none"})");
  EXPECT_EQ(c.result, sha256("abc"));
  EXPECT_EQ(c.verdict, "conforms");
  EXPECT_EQ(c.serious, 1);
  ASSERT_EQ(c.figures.size(), 2u);
  EXPECT_EQ(c.figures[0].of, "T1");
  EXPECT_EQ(c.figures[0].value, 0.1 + 0.2);
  EXPECT_FALSE(c.figures[0].u);
  EXPECT_EQ(c.figures[1].value, 1e-300);
  EXPECT_EQ(c.figures[1].u, 0.5);
  EXPECT_EQ(must(store_->counts()).calibrations, 1);
}

TEST_P(StoreCalibrationsTest, ChangeByVersionsThatStay) {
  open();
  CalibrationRecord c = new_calibration("volume");
  must(store_->add(c, by_anna));
  c.title = "volume, after the repair";
  must(store_->change(1, 1, c, {"Ben", "title"}));
  EXPECT_THAT(why(store_->change(1, 1, c, by_anna)), HasSubstr("found version 2 of this calibration, made by Ben"));
  const auto versions = must(store_->versions<CalibrationRecord>(1));
  ASSERT_EQ(versions.size(), 2u);
  EXPECT_EQ(versions[0].value.title, "volume");
  EXPECT_EQ(versions[1].change.actor, "Ben");
}

TEST_P(StoreCalibrationsTest, KeepTheFilesTheyWereEvaluatedFrom) {
  open();
  CalibrationRecord c = new_calibration("volume");
  must(store_->add(c, by_anna));
  must(store_->keep(content_of("other"), by_anna));
  c.files[0].content = sha256("other");
  EXPECT_THAT(why(store_->change(1, 1, c, by_anna)), HasSubstr("another kind or other files"));
  EXPECT_EQ(must(store_->versions<CalibrationRecord>(1)).size(), 1u);
}

TEST_P(StoreCalibrationsTest, AreWithdrawnAndReinstatedWithTheirReason) {
  open();
  CalibrationRecord c = new_calibration("volume");
  must(store_->add(c, by_anna));
  c.withdrawn = true;
  must(store_->change(1, 1, c, {"Ben", "wrong machine"}));
  EXPECT_THAT(found({}), IsEmpty());
  EXPECT_THAT(found({.text = "", .kind = "", .withdrawn = true}), ElementsAre(1));
  c.withdrawn = false;
  must(store_->change(1, 2, c, {"Ben", "it was the right one"}));
  EXPECT_THAT(found({}), ElementsAre(1));
  const auto entries = must(store_->audit("calibration 1", 0, 10));
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[0].action, "calibration.reinstated");
  EXPECT_EQ(entries[1].action, "calibration.withdrawn");
  EXPECT_EQ(entries[1].change.reason, "wrong machine");
  EXPECT_EQ(entries[2].action, "calibration.added");
}

TEST_P(StoreCalibrationsTest, AreFoundByWordsKindMachineAndDate) {
  open();
  CalibrationRecord c = new_calibration("Größe before");
  must(store_->add(c, by_anna));
  c.title = "after";
  c.kind = "lines";
  c.machine.reset();
  c.measured_on = "2014-06-01T09:30";
  must(store_->add(c, by_anna));
  EXPECT_THAT(found({}), ElementsAre(2, 1));
  EXPECT_THAT(found({.text = "GRÖSSE", .kind = ""}), IsEmpty());
  EXPECT_THAT(found({.text = "GRÖßE mill", .kind = ""}), ElementsAre(1));
  EXPECT_THAT(found({.text = "lengths.csv", .kind = ""}), ElementsAre(2, 1));
  EXPECT_THAT(found({.text = "", .kind = "lines"}), ElementsAre(2));
  EXPECT_THAT(found({.text = "", .kind = "", .machine = 1}), ElementsAre(1));
  EXPECT_THAT(found({.text = "", .kind = "", .instrument = 1}), ElementsAre(2, 1));
  EXPECT_THAT(found({.text = "", .kind = "", .measured_from = "2014-06-01"}), ElementsAre(2));
  EXPECT_THAT(found({.text = "", .kind = "", .measured_to = "2014-06-01"}), ElementsAre(2, 1));
  EXPECT_THAT(found({.text = "", .kind = "", .order = CalibrationFilter::Order::title, .descending = false}),
              ElementsAre(2, 1));
  const auto page = must(store_->calibrations({.text = "", .kind = "", .offset = 1, .limit = 1}));
  EXPECT_EQ(page.total, 2);
  ASSERT_EQ(page.rows.size(), 1u);
  EXPECT_EQ(page.rows[0].machine_name, "Mill 1");
  EXPECT_FALSE(page.rows[0].received_at.empty());
}

TEST_P(StoreCalibrationsTest, AreRefusedWhereSomethingIsMissing) {
  open();
  const auto refused = [&](auto edit) {
    CalibrationRecord c = new_calibration("volume");
    edit(c);
    return why(store_->add(c, by_anna));
  };
  EXPECT_THAT(refused([](CalibrationRecord& c) { c.kind = "other"; }),
              HasSubstr("expected lines, volumetric, straightness, angles or squareness"));
  EXPECT_THAT(refused([](CalibrationRecord& c) { c.title = " "; }), HasSubstr("without a title"));
  EXPECT_THAT(refused([](CalibrationRecord& c) { c.machine = 9; }), HasSubstr("found no machine 9"));
  EXPECT_THAT(refused([](CalibrationRecord& c) { c.instrument = 9; }), HasSubstr("found no instrument 9"));
  EXPECT_THAT(refused([](CalibrationRecord& c) { c.instrument_version.reset(); }), HasSubstr("without its version"));
  EXPECT_THAT(refused([](CalibrationRecord& c) { c.files.clear(); }), HasSubstr("without files"));
  EXPECT_THAT(refused([](CalibrationRecord& c) { c.files[0].content = sha256("x"); }), HasSubstr("lengths.csv"));
  EXPECT_THAT(refused([](CalibrationRecord& c) { c.result = sha256("x"); }), HasSubstr("those of the result"));
  EXPECT_THAT(refused([](CalibrationRecord& c) { c.options = "[]"; }), HasSubstr("expected a JSON object"));
  EXPECT_EQ(must(store_->counts()).calibrations, 0);
}

TEST_P(StoreCalibrationsTest, AreInBackupsAndCannotBeChangedUnseen) {
  const std::string address = filled();
  const std::string copy = file("copy.db");
  must(must(Store::open(address))->backup(copy));
  EXPECT_EQ(must(must(Store::open(copy))->get<CalibrationRecord>(1)).value.title, "volume");
  EXPECT_FALSE(raw(address)->script("UPDATE calibration_version SET title = 'x'"));
  EXPECT_FALSE(raw(address)->script("DELETE FROM calibration"));
  tamper(address, "calibration_version", "UPDATE calibration_version SET figures = '[]' WHERE version = 1");
  EXPECT_THAT(problems(address), ElementsAre("calibration 1: found version 1 changed after it was kept"));
  tamper(address, "calibration_version", "UPDATE calibration_version SET figures = 'none' WHERE version = 2");
  EXPECT_THAT(why(must(Store::open(address))->get<CalibrationRecord>(1)), HasSubstr("figures cannot be read"));
}

}  // namespace
}  // namespace axiometry::store
