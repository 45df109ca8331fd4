// SPDX-License-Identifier: Apache-2.0
// What is kept costs the same however much of it there is already: counted in rows that are read, which no clock
// changes.
#include <gmock/gmock.h>

#include <limits>

#include "axiometry/store/database/migrations.h"
#include "axiometry/store/database/sqlite_connection.h"
#include "axiometry/store/kept/test_versions.h"
#include "axiometry/store/proof/copy.h"
#include "axiometry/store/proof/verification.h"
#include "axiometry/store/store.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

/// Another connection that counts what it is given.
class CountingConnection final : public Connection {
 public:
  explicit CountingConnection(std::unique_ptr<Connection> inner) : inner_(std::move(inner)) {}

  Result<void> script(const std::string& sql) override { return inner_->script(sql); }
  Result<void> begin_read() override { return inner_->begin_read(); }
  Result<void> begin_write() override { return inner_->begin_write(); }
  Result<void> commit() override { return inner_->commit(); }
  void rollback() override { inner_->rollback(); }
  bool alive() const override { return inner_->alive(); }
  bool is_sqlite() const override { return inner_->is_sqlite(); }

  /// What asks more often gets no answer any more.
  void answer_at_most(std::size_t queries) { queries_left_ = queries; }

  /// Rows that `function` reads in a transaction of its own.
  template <typename Function>
  std::size_t rows_of(Function function) {
    const std::size_t before = rows_;
    must(begin_write());
    must(function(*this));
    must(commit());
    return rows_ - before;
  }

 private:
  Result<Rows> execute(std::string_view sql, std::span<const Parameter> parameters) override {
    if (queries_left_ == 0) return fail("found one question more than expected");
    --queries_left_;
    auto rows = inner_->query(sql, parameters);
    if (rows) rows_ += rows->size();
    return rows;
  }

  std::unique_ptr<Connection> inner_;
  std::size_t rows_ = 0;
  std::size_t queries_left_ = std::numeric_limits<std::size_t>::max();
};

class StoreGrowthTest : public BothStores {
 protected:
  CountingConnection counting() {
    const std::string address = new_address();
    must(Store::open(address));
    return CountingConnection(raw(address));
  }
};
AXIOMETRY_ON_BOTH_STORES(StoreGrowthTest);

TEST_P(StoreGrowthTest, ReadsNoMoreForALaterEditOfATestThanForTheFirst) {
  CountingConnection connection = counting();
  const NewTest test = new_test("a");
  connection.rows_of([&](Connection& c) { return receive_tests(c, content_of("abc"), std::vector{test}, by_anna); });
  const auto revise = [&](int base) {
    return connection.rows_of([&](Connection& c) { return revise_test(c, 1, base, test.state, by_anna); });
  };
  const std::size_t first = revise(1);
  std::size_t last = 0;
  for (int base = 2; base <= 40; ++base) last = revise(base);
  EXPECT_EQ(last, first);
}

TEST_P(StoreGrowthTest, LooksOnceForWhatAllTestsOfAFileState) {
  CountingConnection connection = counting();
  NewTest test = new_test("a");
  for (int k = 0; k < 30; ++k) {
    InstrumentRecord& instrument = test.state.instruments.emplace_back(test.state.instruments[0]);
    instrument.serial_number = fmt::format("N-{}", k);
  }
  const auto receive = [&](const char* bytes, std::size_t count) {
    return connection.rows_of(
        [&](Connection& c) { return receive_tests(c, content_of(bytes), std::vector<NewTest>(count, test), by_anna); });
  };
  receive("a", 1);
  const std::size_t few = receive("b", 5);
  const std::size_t many = receive("c", 45);
  EXPECT_LE(many - few, 40 * 10u) << "each further test reads its number, its place in the trail and its names";
}

constexpr std::size_t more_than_are_there = 300;

struct FarNumber {
  const char* table;
  const char* sql;
  const char* said;
};

TEST_P(StoreGrowthTest, VerifiesAndCopiesInProportionToTheRowsHoweverFarApartTheirNumbersAre) {
  for (const FarNumber& c :
       {FarNumber{"content", "UPDATE content SET id = 2147483647 WHERE id = 2", "content 2: found"},
        FarNumber{"test", "UPDATE test SET id = 2147483647 WHERE id = 2", "test 2 to 2147483646: found none"},
        FarNumber{"test_version", "UPDATE test_version SET test = 2147483647 WHERE test = 2", ""},
        FarNumber{"document", "UPDATE document SET id = 2147483647 WHERE id = 2",
                  "document 2 to 2147483646: found none"},
        FarNumber{"content", "UPDATE content SET id = -2147483648 WHERE id = 1", "content 1: found"},
        FarNumber{"audit", "UPDATE audit SET id = -2147483648 WHERE id = 1", "audit trail: found"}}) {
    const std::string address = filled();
    tamper(address, c.table, c.sql);
    const Expectations expected{.schema = fail(ErrorKind::read_only, "not of interest")};
    CountingConnection connection(raw(address));
    connection.answer_at_most(more_than_are_there);
    must(connection.begin_read());
    const Verification found = must(verify_archive(connection, expected));
    EXPECT_THAT(found.problems, testing::Contains(testing::HasSubstr(c.said))) << c.sql;
    SqliteConnection copy(must(open_sqlite(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE)));
    must(make_tables(copy));
    connection.answer_at_most(more_than_are_there);
    EXPECT_TRUE(copy_rows(connection, copy)) << c.sql;
    connection.rollback();
  }
}

}  // namespace
}  // namespace axiometry::store
