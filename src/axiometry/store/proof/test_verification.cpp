// SPDX-License-Identifier: Apache-2.0
#include "axiometry/store/proof/test_verification.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "axiometry/base/counted.h"
#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/test_list.h"
#include "axiometry/store/kept/test_versions.h"
#include "axiometry/store/proof/fingerprint.h"
#include "axiometry/store/proof/id_walk.h"
#include "axiometry/store/proof/problems.h"

namespace axiometry::store {
namespace {

constexpr std::int64_t tests_verified_at_once = 100;

bool same(const Origin& origin, const TestHead& head) {
  return origin.sha256 == head.sha256 && origin.file_name == head.file_name &&
         origin.name_in_file == head.name_in_file && origin.received == head.received &&
         origin.format.value_or(head.format) == head.format;
}

/// An instrument in the lists, and whether of a withdrawn test.
using ListedInstrument = std::pair<Id, std::int64_t>;

class TestVerifier {
 public:
  TestVerifier(Connection& connection, const Attested& attested, std::vector<std::string>& problems)
      : connection_(connection), attested_(attested), problems_(problems) {}

  Result<VerifiedTests> run();

 private:
  Result<void> names();
  Result<void> some_tests(Id first, Id last);
  Result<void> places(std::string_view table);
  Result<void> figures_of_record();
  void check_versions(const TestHead& head, std::span<const TestVersion> versions);
  void check_head(const TestHead& head);
  void check_list(const TestHead& head, const TestVersion& latest, const Row* listed);
  void check_instruments(const TestHead& head, const TestVersion& latest);

  Connection& connection_;
  const Attested& attested_;
  std::vector<std::string>& problems_;
  VerifiedTests found_;
  IdCount count_{"test"};
  std::map<Id, MachineRecord> machines_;
  std::map<Id, AxisRecord> axes_;
  std::map<Id, std::set<ListedInstrument>> listed_instruments_;  // of the tests that are looked at
};

Result<VerifiedTests> TestVerifier::run() {
  AXIOMETRY_TRY_VOID(names());
  AXIOMETRY_TRY_VOID(walk(connection_, {"test", "id", tests_verified_at_once},
                          [&](std::span<const Id> ids) { return some_tests(ids.front(), ids.back()); }));
  for (const std::string_view table : {"test_instrument", "figure"}) AXIOMETRY_TRY_VOID(places(table));
  AXIOMETRY_TRY_VOID(figures_of_record());
  AXIOMETRY_TRY(const Rows versions, connection_.query("SELECT count(*) FROM test_version"));
  if (attested_.count("test") != versions[0].integer(0))
    add_problem(problems_, "test: found {}, expected the {} of the audit trail",
                counted(static_cast<std::size_t>(versions[0].integer(0)), "version"), attested_.count("test"));
  return found_;
}

Result<void> TestVerifier::names() {
  AXIOMETRY_TRY(const auto machines, all_assets<MachineRecord>(connection_));
  for (const auto& machine : machines) machines_[machine.id] = machine.value;
  AXIOMETRY_TRY(const auto axes, all_assets<AxisRecord>(connection_));
  for (const auto& axis : axes) axes_[axis.id] = axis.value;
  return {};
}

Result<void> TestVerifier::some_tests(Id first, Id last) {
  AXIOMETRY_TRY(const std::vector<TestHead> heads, read_heads(connection_, first, last));
  AXIOMETRY_TRY(const std::vector<TestVersion> versions, read_versions(connection_, first, last));
  AXIOMETRY_TRY(const Rows lists, listed(connection_, first, last));
  AXIOMETRY_TRY(
      const Rows instruments,
      connection_.query("SELECT test, instrument, withdrawn FROM list_instrument WHERE test BETWEEN $1 AND $2",
                        {first, last}));
  listed_instruments_.clear();
  for (const Row& row : instruments) listed_instruments_[row.integer(0)].emplace(row.integer(1), row.integer(2));
  auto version = versions.begin();
  auto list = lists.begin();
  for (const TestHead& head : heads) {
    count_.next(head.id, problems_);
    while (version != versions.end() && version->test < head.id) ++version;  // of a test that is not there
    const auto begin = version;
    while (version != versions.end() && version->test == head.id) ++version;
    while (list != lists.end() && list->integer(0) < head.id) ++list;
    check_versions(head, {begin, version});
    check_head(head);
    if (begin != version) {
      const bool is_listed = list != lists.end() && list->integer(0) == head.id;
      check_list(head, *std::prev(version), is_listed ? &*list : nullptr);
      check_instruments(head, *std::prev(version));
    }
    ++found_.tests;
  }
  return {};
}

void TestVerifier::check_versions(const TestHead& head, std::span<const TestVersion> versions) {
  const std::string subject = fmt::format("test {}", head.id);
  int expected = 0;
  for (const TestVersion& version : versions) {
    if (version.version != ++expected)
      add_problem(problems_, "{}: found version {}, expected {}", subject, version.version, expected);
    const std::string hash = fingerprint(version);
    if (hash != version.sha256 || !attested_.knows(subject, version.version, hash))
      add_problem(problems_, "{}: found version {} changed after it was kept", subject, version.version);
  }
  if (expected != head.latest || versions.empty())
    add_problem(problems_, "{}: found {}, expected {}", subject, counted(static_cast<std::size_t>(expected), "version"),
                head.latest);
}

void TestVerifier::check_head(const TestHead& head) {
  const std::string subject = fmt::format("test {}", head.id);
  if (head.withdrawn != attested_.withdrawn(subject))
    add_problem(problems_, "{}: found it {}withdrawn, expected what the audit trail says", subject,
                head.withdrawn ? "" : "not ");
  const Origin* origin = attested_.origin(subject);
  if (origin == nullptr || !same(*origin, head))
    add_problem(problems_, "{}: found another file, receipt, format or name in the file than in the audit trail",
                subject);
  if (origin != nullptr && !origin->format) ++found_.without_format;
}

void TestVerifier::check_list(const TestHead& head, const TestVersion& latest, const Row* listed) {
  const std::string machine = latest.machine ? machines_[*latest.machine].name : "";
  const std::string axis = latest.axis ? axes_[*latest.axis].name : latest.axis_name;
  const std::string kind = latest.axis ? axes_[*latest.axis].kind : latest.axis_kind;
  Fingerprint is;
  Fingerprint shall;
  if (listed == nullptr ||
      is.add(listed->cells()).finish() != shall.add(list_cells(head, latest, machine, axis, kind)).finish())
    add_problem(problems_, "test {}: found another line in the lists than its latest version gives", head.id);
}

void TestVerifier::check_instruments(const TestHead& head, const TestVersion& latest) {
  std::set<ListedInstrument> expected;
  for (const InstrumentUse& use : latest.instruments) expected.emplace(use.instrument, head.withdrawn ? 1 : 0);
  if (listed_instruments_[head.id] != expected)
    add_problem(problems_, "test {}: found other instruments in the lists than its latest version gives", head.id);
}

/// What is hashed in the order of its places counts from 1.
Result<void> TestVerifier::places(std::string_view table) {
  AXIOMETRY_TRY(const Rows rows, connection_.query(fmt::format(
                                     "SELECT test, version FROM {} GROUP BY test, version HAVING min(place) <> 1 OR "
                                     "max(place) <> count(*) ORDER BY test, version LIMIT {}",
                                     table, most_problems)));
  for (const Row& row : rows)
    add_problem(problems_, "{}: found places of version {} of test {} that do not count from 1", table, row.integer(1),
                row.integer(0));
  return {};
}

/// Figures from before there was a method of record are hashed without what came with it.
Result<void> TestVerifier::figures_of_record() {
  AXIOMETRY_TRY(const Rows rows, connection_.query(fmt::format(
                                     "SELECT test, version FROM figure WHERE method = '' AND (low IS NOT NULL OR high "
                                     "IS NOT NULL) ORDER BY test, version LIMIT {}",
                                     most_problems)));
  for (const Row& row : rows)
    add_problem(problems_, "figure: found an interval in version {} of test {} that no method has stated",
                row.integer(1), row.integer(0));
  return {};
}

}  // namespace

Result<VerifiedTests> verify_tests(Connection& connection, const Attested& attested,
                                   std::vector<std::string>& problems) {
  return TestVerifier(connection, attested, problems).run();
}

}  // namespace axiometry::store
