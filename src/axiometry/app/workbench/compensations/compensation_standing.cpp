// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/compensations/compensation_standing.h"

#include <fmt/format.h>

#include <utility>

#include "axiometry/nc/axis_table.h"

namespace axiometry::app {
namespace {

/// Whether both versions must give the same readings of the same axis: a new title or plan changes neither.
bool is_read_alike(const store::TestRecord& a, const store::TestRecord& b) {
  return a.axis == b.axis && a.state.changes == b.state.changes &&
         a.state.evaluation.options == b.state.evaluation.options;
}

void add_of_test(const TestOfCompensation& test, std::vector<NamedFinding>& findings) {
  if (test.withdrawn)
    findings.push_back(
        {"test-withdrawn", true,
         fmt::format("test {}, of which the table was made, is withdrawn: the table should not be used", test.id)});
  if (test.revised)
    findings.push_back(
        {"test-revised", true,
         fmt::format(
             "the table was made of version {} of test {}, and its latest version {} differs in metadata, options or "
             "axis: make the table of that one",
             test.version, test.id, test.latest)});
}

void add_of_retest(const TestOfCompensation& retest, std::vector<NamedFinding>& findings) {
  if (retest.withdrawn)
    findings.push_back({"retest-withdrawn", true,
                        fmt::format("the re-test, test {}, is withdrawn: what was found with it does not count, and "
                                    "the table is not proved",
                                    retest.id)});
  if (retest.revised)
    findings.push_back(
        {"retest-revised", true,
         fmt::format("the re-test was linked in version {} of test {}, and its latest version {} differs in metadata, "
                     "options or axis: what was found with it does not count until it is linked again",
                     retest.version, retest.id, retest.latest)});
}

}  // namespace

Result<TestOfCompensation> test_of_compensation(const store::Transaction& archive, store::Id id, int version) {
  AXIOMETRY_TRY(const store::TestRecord used, archive.test(id, version));
  TestOfCompensation test{id, version, used.latest, used.withdrawn, false, used.state.title, used.state.measured_on};
  if (used.latest == version) return test;
  AXIOMETRY_TRY(const store::TestRecord latest, archive.test(id));
  test.revised = !is_read_alike(used, latest);
  return test;
}

std::vector<NamedFinding> findings_since(const TestOfCompensation& test,
                                         const std::optional<TestOfCompensation>& retest) {
  std::vector<NamedFinding> findings;
  add_of_test(test, findings);
  if (retest) add_of_retest(*retest, findings);
  return findings;
}

std::optional<NamedFinding> former_form(std::string_view control, std::string_view table) {
  const auto kind = nc::axis_table_named(control);
  if (!kind || (*kind)->former == nullptr) return std::nullopt;
  const std::string_view why = (*kind)->former(table);
  return why.empty() ? std::nullopt : std::optional(NamedFinding{"compensation-former-form", true, std::string(why)});
}

std::vector<KeptFinding> counting_findings(const json::Value& result, bool retest_counts) {
  std::vector<KeptFinding> findings = kept_findings(result);
  // Every finding of a re-test is called so: compensation/suspicions.cpp, compensate.cpp and
  // measured_state.cpp of app/compensate.
  if (!retest_counts) std::erase_if(findings, [](const KeptFinding& f) { return f.id.starts_with("retest-"); });
  return findings;
}

}  // namespace axiometry::app
