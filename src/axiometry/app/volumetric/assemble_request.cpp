// SPDX-License-Identifier: Apache-2.0
// What a request says of measurements of single errors.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "axiometry/app/files/request_members.h"
#include "axiometry/app/volumetric/volumetric_request.h"
#include "axiometry/base/text/text.h"
#include "axiometry/formats/text/json_members.h"
#include "axiometry/volumetric/machine/error_motion.h"

namespace axiometry::app {
namespace {

using formats::JsonMembers;

Result<void> put_item(const std::string& text, const AssembleFiles& files, AssembleRequest& request) {
  AXIOMETRY_TRY(SingleItem item, parse_single(text));
  if (!item.file.empty()) {
    const auto file = std::ranges::find(files.errors, item.file, &GivenFile::name);
    if (file == files.errors.end())
      return fail(
          fmt::format("found {} of {}, expected the name of a file that is sent", text::quoted(item.file), item.name));
    item.bytes = file->bytes;
  }
  request.items.push_back(std::move(item));
  return {};
}

/// Each once, and each of an error.
Result<void> check_files(const AssembleFiles& files, const AssembleRequest& request) {
  for (auto file = files.errors.begin(); file != files.errors.end(); ++file) {
    if (std::ranges::find(files.errors.begin(), file, file->name, &GivenFile::name) != file)
      return fail(fmt::format("found two files {}, expected each name once", text::quoted(file->name)));
    if (std::ranges::find(request.items, file->name, &SingleItem::file) == request.items.end())
      return fail(fmt::format("found the file {}, expected files of errors that are named", text::quoted(file->name)));
  }
  return {};
}

}  // namespace

Result<AssembleRequest> assemble_request_from(const json::Value& options, const AssembleFiles& files) {
  const std::size_t most = volumetric::error_names().size();
  AXIOMETRY_TRY(JsonMembers members, JsonMembers::of(options, "options"));
  AssembleRequest request;
  request.machine = files.machine.name;
  request.machine_bytes = files.machine.bytes;
  AXIOMETRY_TRY_VOID(
      take_texts(members, "errors", most, [&](const std::string& text) { return put_item(text, files, request); }));
  if (request.items.empty()) return fail("found no errors, expected one or more", options.at());
  AXIOMETRY_TRY_VOID(take_texts(members, "at", request.stands.size(),
                                [&](const std::string& text) { return put_stand(text, request); }));
  AXIOMETRY_TRY_VOID(
      take_texts(members, "instruments", most, [&](const std::string& text) { return put_instrument(text, request); }));
  AXIOMETRY_TRY_VOID(take_text(members, "reversal", [&](const std::string& word) -> Result<void> {
    AXIOMETRY_TRY(request.reversal, parse_single_reversal(word));
    return {};
  }));
  AXIOMETRY_TRY_VOID(members.finish());
  AXIOMETRY_TRY_VOID(check_files(files, request));
  return request;
}

}  // namespace axiometry::app
