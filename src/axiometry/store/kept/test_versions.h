// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string>
#include <vector>

#include "axiometry/store/database/connection.h"
#include "axiometry/store/kept/stated_assets.h"
#include "axiometry/store/kept/test_records.h"

/// Tests and their versions in the tables, within a transaction.
namespace axiometry::store {

/// A test's row: what came, and which version is the latest.
struct TestHead {
  Id id = 0;
  std::string sha256;
  std::string file_name;
  std::string format;
  std::string name_in_file;
  Change received;
  int latest = 1;
  bool withdrawn = false;
};

/// A version as it is kept.
struct TestVersion {
  Id test = 0;
  int version = 1;
  Change change;
  std::string sha256;  ///< as kept
  std::string title;
  std::optional<Id> machine;
  std::optional<Id> axis;
  std::string axis_name;  ///< as stated; called so where no machine is known
  std::string axis_kind;
  std::optional<Id> plan;
  std::string measured_on;
  std::string changes;
  std::vector<InstrumentUse> instruments;
  EvaluationRecord evaluation;
};

/// The hash of all its fields but sha256.
std::string fingerprint(const TestVersion& version);

/// Finds out what is meant by machine, axis and instruments; adds what is not there.
Result<TestVersion> version_of(Connection& connection, const TestState& state, const Change& change,
                               StatedAssets& stated);

/// With its evaluation and figures; fills in sha256.
Result<void> write_version(Connection& connection, TestVersion& version);

Result<TestHead> read_head(Connection& connection, Id test);
Result<std::vector<TestHead>> read_heads(Connection& connection, Id first, Id last);  ///< heads in their order
Result<TestVersion> read_version(Connection& connection, Id test, int version);

/// Versions of the tests from `first` to `last`, in their order.
Result<std::vector<TestVersion>> read_versions(Connection& connection, Id first, Id last);

/// Keeps bytes that are not there yet. Fails when they do not have the hash they are called by.
Result<void> keep_content(Connection& connection, const Content& content, const Change& change);

/// As store.h's, within a transaction.
Result<std::vector<Id>> receive_tests(Connection& connection, const Content& content, std::span<const NewTest> tests,
                                      const By& by);
Result<int> revise_test(Connection& connection, Id test, int base_version, const TestState& state, const By& by);
Result<void> withdraw_test(Connection& connection, Id test, bool withdrawn, const By& by);
Result<TestRecord> read_test(Connection& connection, Id test, std::optional<int> version);

/// The cells of a figure behind test, version and place; and back, from a column on.
FigureRecord figure_of(const Row& row, std::size_t first);

}  // namespace axiometry::store
