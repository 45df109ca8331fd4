// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "axiometry/app/compensate/compensate.h"
#include "axiometry/app/results/named_findings_json.h"
#include "axiometry/app/workbench/workbench.h"
#include "axiometry/base/json/json.h"
#include "axiometry/store/store.h"

/// Tables of compensation in the archive: made from a test as a version of it is evaluated, kept with it, proved by a
/// test that was measured with the table active.
///
/// What was made is kept: nobody's control has another table because a newer program would make another one. A report
/// and a re-test need the table made again, and are refused (conflict) where this program would make one by which the
/// control does something else.
namespace axiometry::app {

struct NewCompensation {
  store::Id test = 0;
  std::optional<int> version{};          ///< version of the test; none: the latest
  json::Value options;                   ///< CompensationOptions of apps/server/openapi.json
  std::optional<NamedTable> existing{};  ///< the table that was active while the test was measured
  std::string notes{};
};

/// A table that is not kept.
struct MadeCompensation {
  json::Value result;  ///< docs/results.md
  std::string file_name;
  std::string table;
};

/// What is absent stays as it is.
struct CompensationRevision {
  int base_version = 0;
  std::string reason;
  std::optional<std::optional<store::Id>> retest{};  ///< re-test in its latest version
  std::optional<std::string> notes{};
};

/// A test as a compensation speaks of it, and what became of it since.
struct TestOfCompensation {
  store::Id id = 0;
  int version = 0;         ///< version that the compensation rests on
  int latest = 0;          ///< latest version that there is
  bool withdrawn = false;  ///< whether it is withdrawn now
  bool revised = false;    ///< the latest version differs from the one that was used in metadata, options or axis
  std::string title;       ///< title of the version that was used, as the rest
  std::string measured_on;
};

/// What a list says of a compensation.
struct ListedCompensation {
  store::Versioned<store::CompensationRecord> compensation;
  std::string made_at;  ///< time of its first version
  TestOfCompensation test;
  std::optional<TestOfCompensation> retest;
  std::optional<store::Versioned<store::AxisRecord>> axis;        ///< as they are called now
  std::optional<store::Versioned<store::MachineRecord>> machine;  ///< machine of the axis
  std::optional<NamedFinding> former{};                           ///< its table is in a form that is not read any more
  int serious = 0;  ///< findings after which the table should not be used as it is: those that count, and those since

  /// Whether what was found with a re-test is of record: there is one, neither withdrawn nor revised since.
  bool retest_counts() const { return retest && !retest->withdrawn && !retest->revised; }
};

struct KeptCompensation {
  ListedCompensation head;
  std::vector<store::Versioned<store::CompensationRecord>> versions;  ///< the first is version 1
  json::Value result;                                                 ///< exactly what was kept
  std::string table;
  std::vector<KeptFinding>
      findings;  ///< that are of record: those of the tests since, and those of the result that count
};

/// Nothing is kept. Fails as compensate() does, and on a test that is withdrawn.
Result<MadeCompensation> make_compensation(const Workbench& workbench, const NewCompensation& wanted);

/// Table, existing table and result are kept together, or nothing. Fails likewise.
Result<KeptCompensation> keep_compensation(const Workbench& workbench, const NewCompensation& wanted,
                                           const store::By& by);

Result<std::vector<ListedCompensation>> listed_compensations(const store::Store& archive,
                                                             const store::CompensationFilter& filter);

/// Without version: the latest.
Result<KeptCompensation> kept_compensation(const store::Store& archive, store::Id id, std::optional<int> version = {});

/// A new version. Fails with `conflict` when base_version is no longer the latest, when the compensation is withdrawn,
/// and where the table would be another one now; on a re-test that is withdrawn, of another axis, or the test itself.
Result<KeptCompensation> revise_compensation(const Workbench& workbench, store::Id id,
                                             const CompensationRevision& revision, const store::By& by);

/// A new version that says so. Fails with `conflict` when it is so already.
Result<KeptCompensation> withdraw_compensation(store::Store& archive, store::Id id, bool withdrawn,
                                               const store::By& by);

/// With its notes, and without a re-test that no longer counts. Fails on an extension that no writer has; "json" is the
/// result that was kept.
Result<Rendered> compensation_report(const Workbench& workbench, store::Id id, std::optional<int> version,
                                     const ReportRequest& request);

/// The table, or the one that was active before. Fails with not_found on a role that it has no file of.
Result<Rendered> compensation_file(const store::Store& archive, store::Id id, const std::string& role);

}  // namespace axiometry::app
