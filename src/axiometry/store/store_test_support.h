// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <memory>
#include <string>

#include "axiometry/digest/sha256.h"
#include "axiometry/store/place.h"
#include "axiometry/store/store.h"
#include "tests/support/temporary_folder.h"

namespace axiometry::store {

inline const By by_anna{"Anna", "because"};

/// A test with everything that a test may have; `value` is its A.
inline NewTest new_test(const std::string& title, double value = 1.5) {
  NewTest test;
  TestState& state = test.state;
  state.title = title;
  state.machine.name = "Mill 1";
  state.machine.serial_number = "4711";
  state.axis.name = "X";
  state.axis.kind = "linear";
  state.axis.limits = {{"A", 10.0}};
  InstrumentRecord& laser = state.instruments.emplace_back();
  laser.role = "Laser interferometer";
  laser.manufacturer = "Maker";
  laser.type = "XL";
  laser.serial_number = "L-1";
  laser.inputs = {{"uncertainty.device", "0.5"}};
  state.measured_on = "2014-05-15";
  state.changes = R"({"machine.name":"Mill 1"})";
  state.evaluation.program = "axiometry 0.1.0";
  state.evaluation.standard = "ISO 230-2:2014";
  state.evaluation.options = R"({"methods":[]})";
  state.evaluation.seed = 18446744073709551615u;
  state.evaluation.result = R"({"parameters":{"A":1.5}})";
  state.evaluation.unit = "um";
  state.evaluation.conforming = true;
  state.evaluation.verdict = "conforms";
  state.evaluation.label = "";
  state.evaluation.figures = {{"A", value, 0.2, 10.0, "conforms"}, {"E", value / 3, {}, {}, ""}};
  return test;
}

inline Content content_of(const std::string& bytes, const std::string& name = "run.csv") {
  return {sha256(bytes), name, "csv-long", bytes};
}

/// With everything that one may have, of the bytes "abc" and instrument 1 of new_test().
inline CalibrationRecord new_calibration(const std::string& title) {
  return {.kind = "volumetric",
          .title = title,
          .machine = 1,
          .instrument = 1,
          .instrument_version = 1,
          .measured_on = "2014-05-16",
          .notes = "after the crash",
          .withdrawn = false,
          .files = {{"lengths", "lengths.csv", sha256("abc")}, {"machine", "machine.json", sha256("abc")}},
          .program = "axiometry 0.1.0",
          .options = R"({"reversal":"none"})",
          .result = sha256("abc"),
          .verdict = "conforms",
          .serious = 1,
          .figures = {{"volume_largest", "T1", 0.1 + 0.2, {}, "um"}, {"chi2_per_dof", "", 1e-300, 0.5, ""}}};
}

/// Of test 1, with everything that one may have but a re-test, of the bytes "abc".
inline CompensationRecord new_compensation() {
  return {.test = 1,
          .test_version = 1,
          .retest = {},
          .retest_version = {},
          .axis = 1,
          .control = "linuxcnc",
          .notes = "after the new screw",
          .withdrawn = false,
          .files = {{"table", "x.comp", sha256("abc")}, {"existing", "old.comp", sha256("abc")}},
          .program = "axiometry 0.1.0",
          .options = R"({"control":"linuxcnc"})",
          .result = sha256("abc"),
          .serious = 1,
          .figures = {{"E", "before", 0.1 + 0.2, {}, "um"}, {"E", "predicted", 1e-300, {}, "um"}}};
}

/// Value of a result; a failure of the test, and of the process, where there is none.
template <typename T>
T must(Result<T> result) {
  if (!result) {
    ADD_FAILURE() << result.error().to_string();
    std::abort();
  }
  if constexpr (!std::is_void_v<T>) return *std::move(result);
}

template <typename T>
std::string why(const Result<T>& result) {
  return result ? "" : result.error().to_string();
}

/// The same tests for both databases: a new place for each test. PostgreSQL's are schemas of the database in the
/// environment's AXIOMETRY_TEST_POSTGRESQL (tests/store/with_postgresql); without it they are skipped, or fail where
/// AXIOMETRY_REQUIRE_POSTGRESQL says so.
class BothStores : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override {
    if (GetParam() == "sqlite") return;
    if (std::getenv("AXIOMETRY_TEST_POSTGRESQL") != nullptr) return;
    if (std::getenv("AXIOMETRY_REQUIRE_POSTGRESQL") != nullptr) FAIL() << "no AXIOMETRY_TEST_POSTGRESQL";
    GTEST_SKIP() << "no AXIOMETRY_TEST_POSTGRESQL";
  }

  bool sqlite() const { return GetParam() == "sqlite"; }

  /// A file of that name in this test's folder.
  std::string file(const std::string& name) const { return folder_.file(name); }

  /// Where no store is yet.
  std::string new_address() {
    static int count = 0;
    ++count;
    if (sqlite()) return file(fmt::format("{}.db", count));
    const std::string uri = std::getenv("AXIOMETRY_TEST_POSTGRESQL");
    return fmt::format("{}{}options=-csearch_path%3Dtest_{}_{}", uri, uri.find('?') == std::string::npos ? '?' : '&',
                       ::getpid(), count);
  }

  /// The address of an archive with everything that one may hold: bytes that are no text, numbers that are hard to
  /// print, a test that was revised and one that was withdrawn.
  std::string filled() {
    const std::string address = new_address();
    const auto store = must(Store::open(address));
    must(store->receive(content_of("abc"), std::vector{new_test("a", 0.1 + 0.2), new_test("b")}, by_anna));
    must(store->revise(1, 1, new_test("a ä 'again'", 1e-300).state, {"Ben", "reason"}));
    must(store->withdraw(2, true, by_anna));
    DocumentRecord document;
    document.test = 1;
    document.name = "photo.png";
    document.kind = DocumentRecord::Kind::attachment;
    must(store->add_document(document, std::string_view("bytes\0\xff", 7), by_anna));
    document.name = "report.pdf";
    document.kind = DocumentRecord::Kind::report;
    must(store->add_document(document, "report", by_anna));
    must(store->add(PlanRecord{"Plan", 1, sha256("abc")}, by_anna));
    CalibrationRecord calibration = new_calibration("volume");
    must(store->add(calibration, by_anna));
    calibration.withdrawn = true;
    must(store->change(1, 1, calibration, {"Ben", "wrong machine"}));
    CompensationRecord compensation = new_compensation();
    must(store->add(compensation, by_anna));
    compensation.retest = 2;
    compensation.retest_version = 1;
    must(store->change(1, 1, compensation, {"Ben", "measured again"}));
    return address;
  }

  static Verification verified(const std::string& address, std::span<const Seal> seals = {}) {
    return must(must(Store::open(address, {.create = false, .read_only = true, .damaged_log = true}))->verify(seals));
  }
  static std::vector<std::string> problems(const std::string& address) { return verified(address).problems; }

  /// To do what the store never does.
  static std::unique_ptr<Connection> raw(const std::string& address) {
    return must(must(place_of(address, {}))->connect());
  }

  /// Past the guards, which stand as before afterwards: as somebody could who knows a database's own tools.
  static void tamper(const std::string& address, const std::string& table, const std::string& sql) {
    const auto connection = raw(address);
    if (!connection->is_sqlite()) {
      must(connection->script(fmt::format("ALTER TABLE {} DISABLE TRIGGER ALL", table)));
      must(connection->script(sql));
      must(connection->script(fmt::format("ALTER TABLE {} ENABLE TRIGGER ALL", table)));
      return;
    }
    const Rows guards = must(
        connection->query("SELECT name, sql FROM sqlite_master WHERE type = 'trigger' AND tbl_name = $1", {table}));
    for (const Row& guard : guards) must(connection->script("DROP TRIGGER " + guard.text(0)));
    must(connection->script("PRAGMA foreign_keys = OFF"));
    must(connection->script(sql));
    for (const Row& guard : guards) must(connection->script(guard.text(1)));
  }

 private:
  testing_support::TemporaryFolder folder_;
};

#define AXIOMETRY_ON_BOTH_STORES(Fixture)                                          \
  INSTANTIATE_TEST_SUITE_P(Both, Fixture, testing::Values("sqlite", "postgresql"), \
                           [](const auto& each) { return each.param; })

}  // namespace axiometry::store
