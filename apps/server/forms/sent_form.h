// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/app/files/given_file.h"
#include "axiometry/base/json/json.h"
#include "axiometry/base/result.h"
#include "server/http/http.h"

/// Files with what is asked about them, as a form sends them.
namespace axiometry::server {

/// JSON of a form or of the query. Fails, with line and column, on what is none and on more than 64 KiB.
Result<json::Value> parsed_options(std::string_view text);

/// What a part of a form holds.
enum class PartContent {
  file,   ///< one file
  files,  ///< as many files as stand in the form
  text,
  json,
};

struct KnownPart {
  std::string_view name;  ///< empty for files under any name
  PartContent content;
};

/// What a route takes in a form. Every sentence that follows is a phrase of its own in language/.
struct KnownForm {
  std::string_view expected;        ///< "one with options", said where there is no form
  std::string_view expected_parts;  ///< "kind, options and files", said of a part that is none of these
  std::span<const KnownPart> parts;
};

/// The parts of a form, checked; the bytes are those of the request.
struct SentForm {
  struct File {
    std::string part;
    app::GivenFile given;
    std::string media_type;  ///< as sent; empty where none was
  };
  struct Text {
    std::string part;
    std::string_view text;
  };
  struct Json {
    std::string part;
    json::Value value;
  };
  std::vector<File> files;  ///< in the order of the form
  std::vector<Text> texts;
  std::vector<Json> values;

  [[nodiscard]] std::vector<app::GivenFile> files_named(std::string_view part) const;
  [[nodiscard]] std::optional<app::GivenFile> file(std::string_view part) const;
  [[nodiscard]] std::string_view text(std::string_view part) const;  ///< empty where there is none
  [[nodiscard]] std::optional<json::Value> value(std::string_view part) const;
};

/// The one reader of forms for routes. Fails on no form, on what form_parts(), given_file_name() and parsed_options()
/// refuse, on a part that the route does not know, on a file where a text is expected and the reverse, on an empty
/// file, and on a part that stands there twice where one is expected.
Result<SentForm> sent_form(const Request& request, const KnownForm& known);

}  // namespace axiometry::server
