// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <fmt/format.h>

#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/app/workbench/workbench_values.h"
#include "axiometry/base/json/json.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/store/store.h"

/// What calibrations and compensations of the archive have in common: files, options and a result that is kept with
/// every version, a report that is made again of them, withdrawal.
namespace axiometry::app {

/// Bytes under their hash.
store::Content hashed_content(std::string name, std::string format, std::string bytes);

/// What every revision says: the version that was looked at, which must be there, and why, which may be missing.
struct RevisionHead {
  int base_version = 0;
  std::string reason;
};
Result<RevisionHead> revision_head(formats::JsonMembers& members);

/// Of the content with that hash. Fails with `damaged` where it is no JSON.
Result<json::Value> result_of_record(const store::Transaction& archive, const std::string& hash);

/// Fails with `damaged` where they are none.
Result<json::Value> options_of_record(const std::string& text);

/// nullptr where there is none.
const store::KeptFile* file_of(std::span<const store::KeptFile> files, std::string_view role);

/// The bytes of a file as they came. Fails with not_found on a role that there is no file of; `called`: "calibration
/// 3".
Result<Rendered> kept_file(const store::Store& archive, std::span<const store::KeptFile> files, const std::string& role,
                           std::string_view called);

/// "x.pdf", of a later version "x-v2.pdf", without its bytes; with those of the result where JSON is asked for.
Result<Rendered> begun_report(const store::Store& archive, std::string_view stem, int version,
                              const std::string& extension, const std::string& result_hash);

/// The result of such a report, which says "withdrawn": true where the record is. Fails with `damaged` where it is no
/// JSON.
Result<Rendered> as_json_report(Rendered rendered, bool withdrawn);

/// The record and its contents, or nothing of both.
template <typename Record>
Result<store::Versioned<Record>> add_with(store::Store& archive, const Record& record,
                                          std::span<const store::Content> contents, const store::By& by) {
  return archive.write([&](store::Transaction& t) -> Result<store::Versioned<Record>> {
    for (const store::Content& content : contents) AXIOMETRY_TRY_VOID(t.keep(content, by));
    return t.add(record, by);
  });
}

/// A new version, with its result where that is a new one. Fails with `conflict` when base_version is not the latest.
template <typename Record>
Result<void> change_with(store::Store& archive, const store::Versioned<Record>& base, const Record& record,
                         const std::optional<store::Content>& result, const store::By& by) {
  const auto changed = archive.write([&](store::Transaction& t) -> Result<store::Versioned<Record>> {
    if (result) AXIOMETRY_TRY_VOID(t.keep(*result, by));
    return t.change(base.id, base.version, record, by);
  });
  if (!changed) return std::unexpected(changed.error());
  return {};
}

/// Fails with `conflict` on what is withdrawn: nothing is changed in it before it is reinstated. `called`:
/// "calibration".
template <typename Record>
Result<void> check_not_withdrawn(const store::Versioned<Record>& record, std::string_view called) {
  if (!record.value.withdrawn) return {};
  return fail(ErrorKind::conflict,
              fmt::format("found {} {} withdrawn, expected one that is not: reinstate it first", called, record.id));
}

/// A new version that says so. Fails with `conflict` when it is so already.
template <typename Record>
Result<void> set_withdrawn(store::Store& archive, store::Id id, bool withdrawn, const store::By& by,
                           std::string_view called) {
  const auto changed = archive.write([&](store::Transaction& t) -> Result<store::Versioned<Record>> {
    AXIOMETRY_TRY(auto latest, t.get<Record>(id));
    if (latest.value.withdrawn == withdrawn)
      return fail(ErrorKind::conflict, fmt::format("found {} {} {}, expected it not to be", called, id,
                                                   withdrawn ? "withdrawn already" : "in the lists already"));
    latest.value.withdrawn = withdrawn;
    return t.change(id, latest.version, latest.value, by);
  });
  if (!changed) return std::unexpected(changed.error());
  return {};
}

}  // namespace axiometry::app
