// SPDX-License-Identifier: Apache-2.0
#include "server/forms/sent_files.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "axiometry/base/text/text.h"
#include "server/forms/multipart.h"
#include "server/forms/sent_form.h"
#include "server/http/target.h"

namespace axiometry::server {
namespace {

constexpr std::array file_parts = {KnownPart{"profile", PartContent::text}, KnownPart{"", PartContent::files}};
constexpr KnownForm file_form{"one with files", "files and profile", file_parts};

/// By the header of the page, by the one of downloads turned round, or in the query; empty when nobody tells.
Result<std::string> sent_name(const Request& request) {
  for (const char* header : {"x-file-name", "x-filename"})
    if (const auto name = request.header(header)) {
      auto decoded = percent_decoded(*name);
      if (!decoded)
        return fail(fmt::format("found the header X-File-Name {}, expected a name in percent-encoded UTF-8",
                                text::quoted(*name)));
      return decoded;
    }
  if (const auto disposition = request.header("content-disposition")) return header_parameter(*disposition, "filename");
  for (const char* name : {"name", "filename"})
    if (const auto given = request.parameter(name)) return std::string(*given);
  return std::string();
}

Result<formats::ImportProfile> profile_in(std::string_view bytes) {
  constexpr std::size_t limit = std::size_t{64} << 10;
  if (bytes.size() > limit)
    return fail(fmt::format("found an import profile of {} bytes, expected at most {}", bytes.size(), limit));
  auto profile = formats::read_profile(bytes);
  if (!profile) profile.error().file = "profile";
  return profile;
}

Result<SentFile> body_file(const Request& request) {
  AXIOMETRY_TRY(std::string name, sent_name(request));
  if (request.body.empty() && !name.empty())
    return fail(fmt::format("found the file {} empty, expected one with content", text::quoted(name)));
  if (request.body.empty()) return fail("found a request without a body, expected the bytes of a file");
  return SentFile{std::move(name), std::string(request.header("content-type").value_or("")), request.body};
}

}  // namespace

Result<std::vector<SentFile>> files_of(const Request& request) {
  std::vector<SentFile> files;
  if (!is_form(request.header("content-type").value_or(""))) {
    AXIOMETRY_TRY(SentFile file, body_file(request));
    files.push_back(std::move(file));
    return files;
  }
  AXIOMETRY_TRY(SentForm form, sent_form(request, file_form));
  if (form.files.empty()) return fail("found a form without a file, expected at least one part with a file name");
  for (SentForm::File& file : form.files)
    files.push_back({std::move(file.given.name), std::move(file.media_type), file.given.bytes});
  if (form.texts.empty()) return files;
  if (files.size() > 1)
    return fail(fmt::format("found an import profile beside {} files, expected one file", files.size()));
  AXIOMETRY_TRY(files.front().profile, profile_in(form.text("profile")));
  return files;
}

Result<SentFile> file_of(const Request& request) {
  AXIOMETRY_TRY(auto files, files_of(request));
  if (files.size() > 1) return fail(fmt::format("found {} files, expected one", files.size()));
  return std::move(files.front());
}

}  // namespace axiometry::server
