// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/workbench/kept_records.h"

#include <algorithm>
#include <utility>

#include "axiometry/app/files/given_members.h"
#include "axiometry/app/results/outputs.h"
#include "axiometry/base/text/text.h"
#include "axiometry/digest/sha256.h"

namespace axiometry::app {
namespace {

Result<json::Value> kept_result_in(std::string_view text) {
  auto value = json::parse(text);
  if (value) return *std::move(value);
  return fail(ErrorKind::damaged,
              fmt::format("found a result of the archive that cannot be read: {}", value.error().message));
}

}  // namespace

store::Content hashed_content(std::string name, std::string format, std::string bytes) {
  std::string hash = sha256(bytes);
  return {std::move(hash), std::move(name), std::move(format), std::move(bytes)};
}

Result<RevisionHead> revision_head(formats::JsonMembers& members) {
  AXIOMETRY_TRY(const json::Value* base, members.required("base_version"));
  RevisionHead head;
  AXIOMETRY_TRY(head.base_version, given_version("base_version", *base));
  std::optional<std::string> reason;
  AXIOMETRY_TRY_VOID(take_given(members, "reason", reason, &given_line));
  head.reason = reason.value_or("");
  return head;
}

Result<json::Value> result_of_record(const store::Transaction& archive, const std::string& hash) {
  AXIOMETRY_TRY(const store::Content result, archive.content(hash));
  return kept_result_in(result.bytes);
}

Result<json::Value> options_of_record(const std::string& text) {
  auto options = json::parse(text);
  if (options) return *std::move(options);
  return fail(ErrorKind::damaged, "found options of the archive that cannot be read");
}

const store::KeptFile* file_of(std::span<const store::KeptFile> files, std::string_view role) {
  const auto found = std::ranges::find(files, role, &store::KeptFile::role);
  return found == files.end() ? nullptr : &*found;
}

Result<Rendered> kept_file(const store::Store& archive, std::span<const store::KeptFile> files, const std::string& role,
                           std::string_view called) {
  const store::KeptFile* file = file_of(files, role);
  if (file == nullptr)
    return fail(ErrorKind::not_found, fmt::format("found no file {} of {}", text::quoted(role), called));
  AXIOMETRY_TRY(store::Content content, archive.content(file->content));
  return Rendered{std::move(content.bytes), std::string(octets), file->name};
}

Result<Rendered> begun_report(const store::Store& archive, std::string_view stem, int version,
                              const std::string& extension, const std::string& result_hash) {
  Rendered rendered{{},
                    std::string(media_type_of(extension)),
                    fmt::format("{}{}.{}", stem, version > 1 ? fmt::format("-v{}", version) : "", extension)};
  if (extension != "json") return rendered;
  AXIOMETRY_TRY(store::Content result, archive.content(result_hash));
  rendered.bytes = std::move(result.bytes);
  return rendered;
}

Result<Rendered> as_json_report(Rendered rendered, bool withdrawn) {
  if (!withdrawn) return rendered;
  AXIOMETRY_TRY(json::Value value, kept_result_in(rendered.bytes));
  value.add("withdrawn", true);
  rendered.bytes = json::dump(value, 0);
  return rendered;
}

}  // namespace axiometry::app
