// SPDX-License-Identifier: Apache-2.0
// Each column of each table, asked of the database itself: whoever adds one has it checked by verify, or named among
// what is not proved.
#include <gmock/gmock.h>

#include <set>

#include "axiometry/store/proof/verification.h"
#include "axiometry/store/store_test_support.h"

namespace axiometry::store {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

struct Column {
  std::string table;
  std::string name;
  std::string type;
  bool nullable = false;
};

/// An archive under the hands of somebody who may do everything, and takes it back each time.
class StoreColumnTest : public BothStores {
 protected:
  void open() {
    address_ = filled();
    connection_ = raw(address_);
    if (sqlite()) must(connection_->script("PRAGMA foreign_keys = OFF"));
    place_ = must(place_of(address_, {}));
    expected_.emplace(must(expectations(*place_)));
    must(connection_->begin_write());
  }

  std::vector<Column> columns() const {
    const Rows rows = must(connection_->query(
        sqlite()
            ? "SELECT m.name, c.name, c.type, c.\"notnull\" = 0 FROM sqlite_master m JOIN pragma_table_info(m.name) "
              "c WHERE m.type = 'table' AND substr(m.name, 1, 7) <> 'sqlite_' ORDER BY 1, c.cid"
            : "SELECT table_name::text, column_name::text, data_type::text, is_nullable = 'YES' FROM "
              "information_schema.columns WHERE table_schema = current_schema() ORDER BY 1, ordinal_position"));
    std::vector<Column> found;
    for (const Row& row : rows) found.push_back({row.text(0), row.text(1), row.text(2), row.integer(3) != 0});
    return found;
  }

  /// What stands in a column, row by row, and how each row is called.
  Rows cells(const Column& column) const {
    return must(connection_->query(fmt::format("SELECT {}, {} FROM {}", column.name,
                                               sqlite() ? "CAST(rowid AS text)" : "ctid::text", column.table)));
  }

  /// The same bytes, or digits, in a storage class that the column is not declared for.
  static std::string as_another_class(const Column& column, const Cell& cell) {
    return fmt::format("CAST({} AS {})", column.name, std::holds_alternative<Bytes>(cell) ? "text" : "blob");
  }

  /// Other values for a cell, as SQL.
  std::vector<std::string> others(const Column& column, const Cell& cell) const {
    std::vector<std::string> values;
    if (const auto* integer = std::get_if<std::int64_t>(&cell)) {
      values.push_back(column.name + " + 1000");
      if (*integer == 0 || *integer == 1) values.push_back("1 - " + column.name);
    } else if (std::holds_alternative<double>(cell)) {
      values.push_back(column.name + " * 2 + 1");
    } else if (const auto* text = std::get_if<std::string>(&cell)) {
      values.push_back(column.name + " || 'x'");
      if (!text->empty()) values.emplace_back("''");
    } else if (std::holds_alternative<Bytes>(cell)) {
      values.emplace_back(sqlite() ? "x'00'" : "'\\x00'");
    } else {
      values.emplace_back(column.type.starts_with("int") ? "1000" : column.type.starts_with("double") ? "1.5" : "'x'");
    }
    const bool there = !std::holds_alternative<std::monostate>(cell);
    if (column.nullable && there) values.emplace_back("NULL");
    if (sqlite() && there) values.push_back(as_another_class(column, cell));
    return values;
  }

  /// Past the guards, which stand as before afterwards; false where the database has no such rows.
  bool change(const Column& column, const std::string& value, const std::string& row) const {
    const std::string update = fmt::format("UPDATE {} SET {} = {} WHERE {}", column.table, column.name, value,
                                           sqlite() ? "rowid = " + row : "ctid = '" + row + "'");
    if (!sqlite()) {
      must(connection_->script(fmt::format("ALTER TABLE {} DISABLE TRIGGER ALL", column.table)));
      if (!connection_->script(update)) return false;
      must(connection_->script(fmt::format("ALTER TABLE {} ENABLE TRIGGER ALL", column.table)));
      return true;
    }
    const Rows guards = must(connection_->query(
        "SELECT name, sql FROM sqlite_master WHERE type = 'trigger' AND tbl_name = $1", {column.table}));
    for (const Row& guard : guards) must(connection_->script("DROP TRIGGER " + guard.text(0)));
    const bool changed = connection_->script(update).has_value();
    for (const Row& guard : guards) must(connection_->script(guard.text(1)));
    return changed;
  }

  Verification verification() const { return must(verify_archive(*connection_, *expected_)); }

  /// Of the archive with that value; nothing where it can have none such.
  std::optional<Verification> verification(const Column& column, const std::string& value,
                                           const std::string& row) const {
    must(connection_->script("SAVEPOINT trial"));
    std::optional<Verification> found;
    if (change(column, value, row)) found = verification();
    must(connection_->script("ROLLBACK TO trial; RELEASE trial"));
    return found;
  }

  std::string address_;
  std::unique_ptr<Connection> connection_;
  std::unique_ptr<Place> place_;
  std::optional<Expectations> expected_;
};
AXIOMETRY_ON_BOTH_STORES(StoreColumnTest);

TEST_P(StoreColumnTest, IsCheckedOrNamedAmongWhatIsNotProved) {
  open();
  const Verification before = verification();
  ASSERT_THAT(before.problems, IsEmpty());
  std::set<std::string> unseen;
  const std::vector<Column> all = columns();
  EXPECT_GT(all.size(), 150u);
  for (const Column& column : all) {
    const std::string name = fmt::format("{}.{}", column.table, column.name);
    int tried = 0;
    for (const Row& row : cells(column))
      for (const std::string& value : others(column, row.cells()[0])) {
        const auto found = verification(column, value, row.text(1));
        if (!found) continue;
        ++tried;
        if (!found->problems.empty()) continue;
        if (unseen.insert(name).second) RecordProperty(name, value);
        EXPECT_THAT(found->unproved, Contains(HasSubstr(name))) << value << " in the row " << row.text(1);
      }
    EXPECT_GT(tried, 0) << name;
  }
  EXPECT_THAT(unseen, ElementsAre("migration.at"));
}

}  // namespace
}  // namespace axiometry::store
