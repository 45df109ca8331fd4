// SPDX-License-Identifier: Apache-2.0
#include <gmock/gmock.h>

#include "axiometry/store/store.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using testing::HasSubstr;

class StoreAssetsTest : public BothStores {
 protected:
  std::unique_ptr<Store> store_;
  void SetUp() override {
    BothStores::SetUp();
    if (!IsSkipped() && !HasFatalFailure()) store_ = must(Store::open(new_address()));
  }

  template <typename... Stated>
  auto known(const Stated&... stated) {
    return must(store_->read([&](const Transaction& archive) { return archive.known(stated...); }));
  }

  MachineRecord machine(const std::string& name) {
    MachineRecord made;
    made.name = name;
    return made;
  }

  /// The machine that the archive takes a test's for.
  Id machine_of(const std::string& name, const std::string& serial_number) {
    NewTest test = new_test("t");
    test.state.machine.name = name;
    test.state.machine.serial_number = serial_number;
    const Id id = must(store_->receive(content_of("abc"), std::vector{test}, by_anna)).at(0);
    return must(store_->test(id)).machine.value_or(0);
  }
};
AXIOMETRY_ON_BOTH_STORES(StoreAssetsTest);

TEST_P(StoreAssetsTest, KeepsEveryVersionOfAMachine) {
  const auto added = must(store_->add(machine("Mill"), by_anna));
  EXPECT_EQ(added.id, 1);
  const auto changed = must(store_->change(1, 1, machine("Big mill"), {"Ben", "there are two"}));
  EXPECT_EQ(changed.version, 2);
  const auto late = store_->change(1, 1, machine("Old mill"), by_anna);
  ASSERT_FALSE(late);
  EXPECT_EQ(late.error().kind, ErrorKind::conflict);
  EXPECT_THAT(late.error().message, HasSubstr("made by Ben"));
  EXPECT_EQ(must(store_->get<MachineRecord>(1)).value.name, "Big mill");
  EXPECT_EQ(must(store_->get<MachineRecord>(1, 1)).value.name, "Mill");
  const auto versions = must(store_->versions<MachineRecord>(1));
  ASSERT_EQ(versions.size(), 2u);
  EXPECT_EQ(versions[1].change.reason, "there are two");
  EXPECT_EQ(store_->get<MachineRecord>(2).error().kind, ErrorKind::not_found);
  EXPECT_EQ(store_->versions<MachineRecord>(2).error().kind, ErrorKind::not_found);
  EXPECT_EQ(store_->change(2, 1, machine("x"), by_anna).error().kind, ErrorKind::not_found);
}

TEST_P(StoreAssetsTest, RefusesASecondOneThatNoTestCouldTellFromTheFirst) {
  must(store_->add(machine("Mill 5"), by_anna));
  EXPECT_THAT(why(store_->add(machine("mill 5 "), by_anna)), HasSubstr(R"(machine 1 called "Mill 5" too)"));
  MachineRecord numbered = machine("Mill 5");
  numbered.serial_number = "S-1";
  EXPECT_EQ(must(store_->add(numbered, by_anna)).id, 2);
  numbered.name = "Mill 6";
  numbered.serial_number = " s-1";
  EXPECT_THAT(why(store_->add(numbered, by_anna)), HasSubstr("machine 2 of the same serial number"));
  numbered.manufacturer = "Acme";  // the other's is not known
  EXPECT_FALSE(store_->add(numbered, by_anna));
  AxisRecord axis{.machine = 1, .name = "X", .kind = "linear", .limits = {}, .notes = {}};
  must(store_->add(axis, by_anna));
  axis.name = "x";
  EXPECT_THAT(why(store_->add(axis, by_anna)), HasSubstr(R"(axis 1 of this machine called "X" too)"));
  axis.kind = "rotary";
  EXPECT_EQ(must(store_->add(axis, by_anna)).id, 2);
  InstrumentRecord laser;
  laser.manufacturer = "Acme";
  laser.type = "Laser";
  must(store_->add(laser, by_anna));
  EXPECT_THAT(why(store_->add(laser, by_anna)), HasSubstr("instrument 1 of the same manufacturer and type"));
  laser.serial_number = "7";
  must(store_->add(laser, by_anna));
  EXPECT_FALSE(store_->add(laser, by_anna));
  // Nothing of what was refused was kept.
  EXPECT_EQ(must(store_->all<MachineRecord>()).size(), 2u);
  EXPECT_EQ(must(store_->all<AxisRecord>()).size(), 2u);
  EXPECT_EQ(must(store_->all<InstrumentRecord>()).size(), 2u);
}

TEST_P(StoreAssetsTest, RefusesAChangeThatMakesOneLikeAnother) {
  must(store_->add(machine("Mill 5"), by_anna));
  must(store_->add(machine("Mill 6"), by_anna));
  EXPECT_THAT(why(store_->change(2, 1, machine("MILL 5"), by_anna)), HasSubstr(R"(called "Mill 5" too)"));
  MachineRecord noted = machine("mill 6");
  noted.notes = "the new one";
  EXPECT_EQ(must(store_->change(2, 1, noted, by_anna)).version, 2);
}

TEST_P(StoreAssetsTest, ListsMachinesByNameWhateverTheCase) {
  for (const char* name : {"beta", "Alpha", "Öl", "alpha 2", "ölig"}) must(store_->add(machine(name), by_anna));
  std::string names;
  for (const auto& found : must(store_->all<MachineRecord>())) names += found.value.name + ",";
  EXPECT_EQ(names, "Alpha,alpha 2,beta,Öl,ölig,");
}

TEST_P(StoreAssetsTest, RefusesThingsThatCannotBe) {
  EXPECT_THAT(why(store_->add(machine(" "), by_anna)), HasSubstr("without a name"));
  AxisRecord axis;
  axis.machine = 1;
  axis.name = "X";
  axis.kind = "linear";
  EXPECT_EQ(store_->add(axis, by_anna).error().kind, ErrorKind::not_found);
  must(store_->add(machine("Mill"), by_anna));
  must(store_->add(axis, by_anna));
  axis.kind = "bent";
  EXPECT_THAT(why(store_->add(axis, by_anna)), HasSubstr("linear or rotary"));
  axis.kind = "rotary";
  axis.limits = {{"A", -1.0}};
  EXPECT_THAT(why(store_->add(axis, by_anna)), HasSubstr("above 0"));
  axis.limits = {{"A", 1.0}, {"A", 2.0}};
  EXPECT_THAT(why(store_->add(axis, by_anna)), HasSubstr("twice"));
  EXPECT_FALSE(store_->add(InstrumentRecord{}, by_anna));
  EXPECT_EQ(store_->add(PlanRecord{"Plan", {}, sha256("plan")}, by_anna).error().kind, ErrorKind::not_found);
  must(store_->keep(content_of("plan"), by_anna));
  EXPECT_EQ(must(store_->add(PlanRecord{"Plan", 1, sha256("plan")}, by_anna)).id, 1);
  EXPECT_EQ(store_->add(PlanRecord{"Plan", 2, sha256("plan")}, by_anna).error().kind, ErrorKind::not_found);
}

TEST_P(StoreAssetsTest, KeepsAnAxisAtItsMachine) {
  must(store_->add(machine("Mill"), by_anna));
  must(store_->add(machine("Lathe"), by_anna));
  AxisRecord axis;
  axis.machine = 1;
  axis.name = "X";
  axis.kind = "linear";
  must(store_->add(axis, by_anna));
  axis.machine = 2;
  EXPECT_THAT(why(store_->change(1, 1, axis, by_anna)), HasSubstr("expected it to stay"));
}

TEST_P(StoreAssetsTest, KnowsAMachineByItsSerialNumberOrItsName) {
  EXPECT_EQ(machine_of("Mill", "1"), 1);
  EXPECT_EQ(machine_of("Other name", "1"), 1);
  EXPECT_EQ(machine_of("MILL", ""), 1);
  EXPECT_EQ(machine_of("Mill", "2"), 2) << "another number is another machine";
  EXPECT_EQ(machine_of("Lathe", ""), 3);
  EXPECT_EQ(machine_of("lathe", "77"), 3) << "had no number yet";
  EXPECT_EQ(must(store_->get<MachineRecord>(3)).value.serial_number, "77");
  EXPECT_EQ(machine_of("", "9"), 4);
  EXPECT_EQ(must(store_->get<MachineRecord>(4)).value.name, "9");
  EXPECT_EQ(machine_of("", ""), 0);
  must(store_->change(3, 2, machine("Lathe in hall 2"), by_anna));
  EXPECT_EQ(machine_of("Lathe", ""), 3) << "as it was called before";
  EXPECT_EQ(must(store_->counts()).machines, 4);
}

TEST_P(StoreAssetsTest, GivesAMachineTheFirstNumberThatATestStatesAndNoOther) {
  EXPECT_EQ(machine_of("Mill 5", ""), 1);
  EXPECT_EQ(machine_of("Mill 5", "11"), 1);
  EXPECT_EQ(machine_of("Mill 5", "22"), 2);
  EXPECT_EQ(machine_of("Mill 5", "11"), 1);
  const auto versions = must(store_->versions<MachineRecord>(1));
  ASSERT_EQ(versions.size(), 2u);
  EXPECT_EQ(versions[0].value.serial_number, "");
  EXPECT_EQ(versions[1].value.serial_number, "11");
  EXPECT_THAT(versions[1].change.reason, HasSubstr("serial number stated by a test"));
  must(store_->change(1, 2, machine("Mill 5"), by_anna));  // undone
  EXPECT_EQ(machine_of("Mill 5", "33"), 3) << "two are called so";
  EXPECT_TRUE(must(store_->verify()).problems.empty());
}

TEST_P(StoreAssetsTest, GuessesNoMachineByANameThatSeveralHave) {
  EXPECT_EQ(machine_of("Mill 5", "11"), 1);
  EXPECT_EQ(machine_of("Mill 5", ""), 1) << "the only one";
  EXPECT_EQ(machine_of("Mill 5", "22"), 2);
  const auto meant = [&] {
    return must(store_->read([&](const Transaction& archive) { return archive.meant(machine("Mill 5")); }));
  };
  EXPECT_FALSE(meant().known);
  EXPECT_EQ(meant().others, 2u);
  EXPECT_EQ(machine_of("Mill 5", ""), 3) << "which of the two cannot be told";
  EXPECT_EQ(machine_of("Mill 5", ""), 3);
  EXPECT_EQ(meant().known.value().id, 3);
  EXPECT_EQ(meant().others, 2u);
  EXPECT_EQ(machine_of("Mill 5", "33"), 4) << "tests of 11 or 22 may be among those of the third";
}

TEST_P(StoreAssetsTest, LeavesATestThatIsRevisedWithItsMachine) {
  EXPECT_EQ(machine_of("Mill 5", "11"), 1);
  EXPECT_EQ(machine_of("Mill 5", ""), 1);
  EXPECT_EQ(machine_of("Mill 5", "22"), 2);
  TestState state = must(store_->test(2)).state;
  state.machine = machine("Mill 5");
  must(store_->revise(2, 1, state, by_anna));
  EXPECT_EQ(must(store_->test(2)).machine, 1);
  state.machine.serial_number = "22";
  must(store_->revise(2, 2, state, by_anna));
  EXPECT_EQ(must(store_->test(2)).machine, 2) << "stated to be another one";
}

TEST_P(StoreAssetsTest, TakesNoMachineWhoseNumberWasAddedLaterForOneOfAnotherNumber) {
  EXPECT_EQ(machine_of("Mill", ""), 1);
  MachineRecord numbered = machine("Mill");
  numbered.serial_number = "100";
  must(store_->change(1, 1, numbered, by_anna));
  EXPECT_EQ(machine_of("Mill", "100"), 1);
  EXPECT_EQ(machine_of("Mill", "200"), 2);
  numbered.name = "Mill in hall 2";
  must(store_->change(1, 2, numbered, by_anna));
  EXPECT_EQ(machine_of("Mill", "300"), 3);
}

TEST_P(StoreAssetsTest, KnowsAnInstrumentByItsSerialNumberOrItsOnlyOneOfAKind) {
  const auto used = [&](const std::string& serial_number) {
    NewTest test = new_test("t");
    test.state.instruments[0].serial_number = serial_number;
    const Id id = must(store_->receive(content_of("abc"), std::vector{test}, by_anna)).at(0);
    return must(store_->test(id)).instruments.at(0);
  };
  EXPECT_EQ(used("1"), 1);
  EXPECT_EQ(used(""), 1) << "the only one";
  EXPECT_EQ(used("2"), 2);
  EXPECT_EQ(used(""), 3) << "which of the two cannot be told";
  EXPECT_EQ(used(""), 3);
  EXPECT_EQ(used("1"), 1);
}

TEST_P(StoreAssetsTest, TellsWhatItWouldLinkATestWithBeforeItIsKept) {
  NewTest test = new_test("t");
  test.state.machine.name = "FRÄSE Öl-Æß";
  test.state.machine.serial_number = "Nr. Ü-1";
  test.state.axis.name = "Ё-Ω";
  test.state.instruments[0].manufacturer = "MÜLLER";
  test.state.instruments[0].serial_number = "É-7";
  EXPECT_FALSE(known(test.state.machine));
  EXPECT_FALSE(known(test.state.machine, test.state.axis));
  EXPECT_FALSE(known(test.state.instruments[0]));
  must(store_->receive(content_of("abc"), std::vector{test}, by_anna));
  TestState stated = test.state;
  stated.machine.name = " fräse öl-æß ";
  stated.machine.serial_number = "";
  stated.axis.name = "ё-ω";
  stated.instruments[0].manufacturer = "Müller";
  stated.instruments[0].serial_number = "é-7";
  EXPECT_EQ(known(stated.machine).value().id, 1);
  EXPECT_EQ(known(stated.machine, stated.axis).value().value.name, "Ё-Ω");
  EXPECT_EQ(known(stated.instruments[0]).value().value.inputs.size(), 1u);
  stated.machine = {};
  stated.machine.serial_number = "NR. ü-1";
  EXPECT_EQ(known(stated.machine, stated.axis).value().id, 1);
  stated.machine.name = "Fräse Öl-Æß";
  stated.machine.serial_number = "Nr. Ü-2";
  EXPECT_FALSE(known(stated.machine)) << "another number is another machine";
  EXPECT_FALSE(known(stated.machine, stated.axis));
  stated.axis.kind = "rotary";
  EXPECT_FALSE(known(test.state.machine, stated.axis));
  EXPECT_FALSE(known(MachineRecord()));
  EXPECT_FALSE(known(InstrumentRecord()));
}

TEST_P(StoreAssetsTest, KnowsAnInstrumentWhoseSerialNumberWasCorrected) {
  InstrumentRecord laser;
  laser.role = "laser";
  laser.serial_number = "L-O1";
  must(store_->add(laser, by_anna));
  laser.serial_number = "L-01";
  must(store_->change(1, 1, laser, by_anna));
  laser.serial_number = "l-o1";
  const auto found = known(laser);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->version, 2) << "what it is now";
}

TEST_P(StoreAssetsTest, TakesNoInstrumentWhoseMakerWasAddedLaterForOneOfAnotherMaker) {
  InstrumentRecord laser;
  laser.role = "laser";
  laser.serial_number = "1";
  must(store_->add(laser, by_anna));
  laser.manufacturer = "Renishaw";
  must(store_->change(1, 1, laser, by_anna));
  EXPECT_TRUE(known(laser));
  laser.manufacturer = "SIOS";
  EXPECT_FALSE(known(laser));
  must(store_->change(1, 2, laser, by_anna));
  laser.manufacturer = "Renishaw";
  EXPECT_TRUE(known(laser)) << "as it was called before";
}

TEST_P(StoreAssetsTest, TellsLongNamesApartByTheirEnds) {
  const std::string begin(500, 'x');
  EXPECT_EQ(machine_of(begin + "1", ""), 1);
  EXPECT_EQ(machine_of(begin + "2", ""), 2);
}

TEST_P(StoreAssetsTest, ShowsANewNameInEveryListAtOnce) {
  machine_of("Mill", "1");
  MachineRecord renamed = must(store_->get<MachineRecord>(1)).value;
  renamed.name = "Fräse";
  must(store_->change(1, 1, renamed, by_anna));
  AxisRecord axis = must(store_->get<AxisRecord>(1)).value;
  axis.name = "X1";
  must(store_->change(1, 1, axis, by_anna));
  TestFilter filter;
  filter.text = "FRÄSE x1";
  const TestPage page = must(store_->tests(filter));
  ASSERT_EQ(page.total, 1);
  EXPECT_EQ(page.rows[0].machine_name, "Fräse");
  EXPECT_EQ(page.rows[0].axis_name, "X1");
  EXPECT_EQ(must(store_->test(1)).state.machine.name, "Fräse");
  filter.text = "mill";
  EXPECT_EQ(must(store_->tests(filter)).total, 0);
  EXPECT_TRUE(must(store_->verify()).problems.empty());
}

TEST_P(StoreAssetsTest, RemembersWhatAnInstrumentWasWhenItMeasured) {
  must(store_->receive(content_of("abc"), std::vector{new_test("t")}, by_anna));
  InstrumentRecord laser = must(store_->get<InstrumentRecord>(1)).value;
  laser.calibrated_on = "2027-01-01";
  must(store_->change(1, 1, laser, by_anna));
  EXPECT_EQ(must(store_->test(1)).state.instruments.at(0).calibrated_on, "");
  must(store_->revise(1, 1, must(store_->test(1)).state, by_anna));
  EXPECT_EQ(must(store_->test(1)).state.instruments.at(0).calibrated_on, "2027-01-01");
}

}  // namespace
}  // namespace axiometry::store
