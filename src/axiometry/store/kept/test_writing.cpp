// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"
#include "axiometry/store/database/clock.h"
#include "axiometry/store/kept/assets.h"
#include "axiometry/store/kept/test_list.h"
#include "axiometry/store/kept/test_versions.h"
#include "axiometry/store/proof/audit_trail.h"

namespace axiometry::store {
namespace {

std::string subject_of(Id test) { return fmt::format("test {}", test); }

json::Value detail_of(const TestVersion& version) {
  json::Value detail = json::Value::object();
  detail.add("version", version.version);
  detail.add("sha256", version.sha256);
  return detail;
}

Result<Id> receive_test(Connection& connection, const Content& content, const NewTest& test, const Change& change,
                        StatedAssets& stated) {
  AXIOMETRY_TRY(TestVersion version, version_of(connection, test.state, change, stated));
  AXIOMETRY_TRY(version.test, next_id(connection, "test"));
  TestHead head{.id = version.test,
                .sha256 = content.sha256,
                .file_name = content.file_name,
                .format = content.format,
                .name_in_file = test.name_in_file,
                .received = change};
  AXIOMETRY_TRY_VOID(connection.run(
      "INSERT INTO test (id, content, file_name, format, name_in_file, at, actor, reason, latest, withdrawn) "
      "VALUES ($1, $2, $3, $4, $5, $6, $7, $8, 1, 0)",
      {head.id, head.sha256, head.file_name, head.format, head.name_in_file, change.at, change.actor, change.reason}));
  AXIOMETRY_TRY_VOID(write_version(connection, version));
  AXIOMETRY_TRY_VOID(list_test(connection, head, version));
  json::Value detail = detail_of(version);
  detail.add("content", content.sha256);
  detail.add("file", content.file_name);
  detail.add("format", content.format);
  if (!test.name_in_file.empty()) detail.add("name_in_file", test.name_in_file);
  AXIOMETRY_TRY_VOID(record(connection, change, {"test.received", subject_of(head.id), detail}));
  return head.id;
}

}  // namespace

Result<void> keep_content(Connection& connection, const Content& content, const Change& change) {
  if (content.bytes.size() > content_bytes_max)
    return fail(fmt::format("found {} bytes, expected at most {}", content.bytes.size(), content_bytes_max));
  const std::string hash = sha256(content.bytes);
  if (hash != content.sha256)
    return fail(fmt::format("found bytes with the SHA-256 {}, expected {}", hash, text::quoted(content.sha256)));
  AXIOMETRY_TRY(const Rows known, connection.query("SELECT id FROM content WHERE sha256 = $1", {content.sha256}));
  if (!known.empty()) return {};
  AXIOMETRY_TRY(const Id id, next_id(connection, "content"));
  const auto size = static_cast<std::int64_t>(content.bytes.size());
  AXIOMETRY_TRY_VOID(
      connection.run("INSERT INTO content (id, sha256, file_name, format, size, at, actor, reason, bytes) "
                     "VALUES ($1, $2, $3, $4, $5, $6, $7, $8, $9)",
                     {id, content.sha256, content.file_name, content.format, size, change.at, change.actor,
                      change.reason, BytesView{content.bytes}}));
  json::Value detail = json::Value::object();
  detail.add("sha256", content.sha256);
  detail.add("size", static_cast<std::size_t>(size));
  detail.add("file", content.file_name);
  detail.add("format", content.format);
  return record(connection, change, {"content.kept", fmt::format("content {}", id), detail});
}

Result<std::vector<Id>> receive_tests(Connection& connection, const Content& content, std::span<const NewTest> tests,
                                      const By& by) {
  if (tests.empty()) return fail("found no test, expected at least one in the file");
  const Change change = change_now(by);
  AXIOMETRY_TRY_VOID(keep_content(connection, content, change));
  StatedAssets stated(connection, change);
  std::vector<Id> ids;
  for (const NewTest& test : tests) {
    AXIOMETRY_TRY(const Id id, receive_test(connection, content, test, change, stated));
    ids.push_back(id);
  }
  return ids;
}

Result<int> revise_test(Connection& connection, Id test, int base_version, const TestState& state, const By& by) {
  AXIOMETRY_TRY(TestHead head, read_head(connection, test));
  AXIOMETRY_TRY(const TestVersion latest, read_version(connection, test, head.latest));
  if (head.latest != base_version)
    return fail(ErrorKind::conflict,
                fmt::format("found version {} of this test, made by {} at {}, expected version {} to be the latest",
                            head.latest, latest.change.actor, latest.change.at, base_version));
  const Change change = change_now(by);
  StatedAssets stated(connection, change, latest.machine);
  AXIOMETRY_TRY(TestVersion version, version_of(connection, state, change, stated));
  version.test = test;
  version.version = ++head.latest;
  AXIOMETRY_TRY_VOID(connection.run("UPDATE test SET latest = $2 WHERE id = $1", {test, head.latest}));
  AXIOMETRY_TRY_VOID(write_version(connection, version));
  AXIOMETRY_TRY_VOID(relist_test(connection, head, version));
  AXIOMETRY_TRY_VOID(record(connection, change, {"test.revised", subject_of(test), detail_of(version)}));
  return version.version;
}

Result<void> withdraw_test(Connection& connection, Id test, bool withdrawn, const By& by) {
  AXIOMETRY_TRY(TestHead head, read_head(connection, test));
  if (head.withdrawn == withdrawn)
    return fail(ErrorKind::conflict, fmt::format("found test {} {}, expected it not to be", test,
                                                 withdrawn ? "withdrawn already" : "in the lists already"));
  head.withdrawn = withdrawn;
  AXIOMETRY_TRY_VOID(connection.run("UPDATE test SET withdrawn = $2 WHERE id = $1", {test, std::int64_t{withdrawn}}));
  AXIOMETRY_TRY(const TestVersion version, read_version(connection, test, head.latest));
  AXIOMETRY_TRY_VOID(relist_test(connection, head, version));
  return record(connection, change_now(by), {withdrawn ? "test.withdrawn" : "test.reinstated", subject_of(test)});
}

Result<TestRecord> read_test(Connection& connection, Id test, std::optional<int> wanted) {
  AXIOMETRY_TRY(TestHead head, read_head(connection, test));
  AXIOMETRY_TRY(TestVersion version, read_version(connection, test, wanted.value_or(head.latest)));
  TestRecord found{.id = test,
                   .version = version.version,
                   .latest = head.latest,
                   .sha256 = std::move(head.sha256),
                   .file_name = std::move(head.file_name),
                   .format = std::move(head.format),
                   .name_in_file = std::move(head.name_in_file),
                   .received = std::move(head.received),
                   .change = std::move(version.change),
                   .withdrawn = head.withdrawn,
                   .machine = version.machine,
                   .axis = version.axis,
                   .instruments = {},
                   .state = {}};
  TestState& state = found.state;
  state.title = std::move(version.title);
  if (version.machine) {
    AXIOMETRY_TRY(auto machine, get_asset<MachineRecord>(connection, *version.machine));
    state.machine = std::move(machine.value);
  }
  state.axis.name = version.axis_name;
  state.axis.kind = version.axis_kind;
  if (version.axis) {
    AXIOMETRY_TRY(auto axis, get_asset<AxisRecord>(connection, *version.axis));
    state.axis = std::move(axis.value);
  }
  for (const InstrumentUse& use : version.instruments) {
    found.instruments.push_back(use.instrument);
    AXIOMETRY_TRY(auto instrument, get_asset<InstrumentRecord>(connection, use.instrument, use.version));
    state.instruments.push_back(std::move(instrument.value));
  }
  state.plan = version.plan;
  state.measured_on = std::move(version.measured_on);
  state.changes = std::move(version.changes);
  state.evaluation = std::move(version.evaluation);
  return found;
}

}  // namespace axiometry::store
