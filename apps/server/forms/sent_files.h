// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/base/result.h"
#include "axiometry/formats/table/import_profile.h"
#include "server/http/http.h"

/// Files that are the body of a request, or stand in a form under any name.
namespace axiometry::server {

/// A file in a request; the bytes are those of the request.
struct SentFile {
  std::string name;
  std::string media_type;
  std::string_view bytes;
  std::optional<formats::ImportProfile> profile{};  ///< profile by which the only file of a form is to be read
};

/// The only file of the body, named by X-File-Name (percent-encoded), Content-Disposition or ?name=; or the files of
/// multipart/form-data, where a part "profile" without a file name may stand beside a single one. Fails on a malformed
/// name, without a file, on an empty one, on what sent_form() refuses of a form, and on a profile of more than 64 KiB,
/// beside several files, or as read_profile() does.
Result<std::vector<SentFile>> files_of(const Request& request);
/// The same of a single one.
Result<SentFile> file_of(const Request& request);

}  // namespace axiometry::server
