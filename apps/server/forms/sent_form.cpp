// SPDX-License-Identifier: Apache-2.0
#include "server/forms/sent_form.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "axiometry/app/files/given_text.h"
#include "axiometry/base/text/text.h"
#include "server/forms/multipart.h"

namespace axiometry::server {
namespace {

constexpr std::size_t options_bytes_max = std::size_t{64} << 10;

bool is_file(PartContent content) { return content == PartContent::file || content == PartContent::files; }

/// What the route knows under the name of a part, else files under any name.
Result<KnownPart> known_part(const FormPart& part, const KnownForm& known) {
  auto row = std::ranges::find(known.parts, part.name, &KnownPart::name);
  if (row == known.parts.end() && part.is_file)
    row = std::ranges::find(known.parts, std::string_view(), &KnownPart::name);
  if (row == known.parts.end())
    return fail(
        fmt::format("found the part {} in the form, expected {}", text::quoted(part.name), known.expected_parts));
  if (part.is_file && !is_file(row->content))
    return fail(fmt::format("found the part {} as a file, expected a text", text::quoted(part.name)));
  if (!part.is_file && is_file(row->content))
    return fail(fmt::format("found the part {} as a text, expected a file", text::quoted(part.name)));
  return *row;
}

template <typename Parts>
bool has_part(const Parts& parts, std::string_view name) {
  return std::ranges::any_of(parts, [&](const auto& part) { return part.part == name; });
}

Result<void> take_form_file(SentForm& form, const FormPart& part, const KnownPart& known) {
  if (known.content == PartContent::file && has_part(form.files, part.name))
    return fail(fmt::format("found two files {}, expected one", part.name));
  AXIOMETRY_TRY(std::string name, app::given_file_name(part.file_name));
  // Blanks alone may be a document, and nothing that is read.
  if (part.bytes.empty() || (!known.name.empty() && text::trim(part.bytes).empty()))
    return fail(fmt::format("found the file {} empty, expected one with content", text::quoted(name)));
  form.files.push_back({part.name, {std::move(name), part.bytes}, part.content_type});
  return {};
}

Result<void> take_form_part(SentForm& form, const FormPart& part, const KnownPart& known) {
  if (part.is_file) return take_form_file(form, part, known);
  if (has_part(form.texts, part.name) || has_part(form.values, part.name))
    return fail(fmt::format("found the part {} twice in the form, expected it once", text::quoted(part.name)));
  if (known.content == PartContent::text) {
    form.texts.push_back({part.name, part.bytes});
    return {};
  }
  AXIOMETRY_TRY(json::Value value, parsed_options(part.bytes));
  form.values.push_back({part.name, std::move(value)});
  return {};
}

}  // namespace

Result<json::Value> parsed_options(std::string_view text) {
  if (text.size() > options_bytes_max)
    return fail(fmt::format("found options of {} bytes, expected at most {}", text.size(), options_bytes_max));
  auto value = json::parse(text);
  if (!value) value.error().file = "options";
  return value;
}

std::vector<app::GivenFile> SentForm::files_named(std::string_view part) const {
  std::vector<app::GivenFile> found;
  for (const File& file : files)
    if (file.part == part) found.push_back(file.given);
  return found;
}

std::optional<app::GivenFile> SentForm::file(std::string_view part) const {
  const auto found = std::ranges::find(files, part, &File::part);
  return found == files.end() ? std::nullopt : std::optional(found->given);
}

std::string_view SentForm::text(std::string_view part) const {
  const auto found = std::ranges::find(texts, part, &Text::part);
  return found == texts.end() ? std::string_view() : found->text;
}

std::optional<json::Value> SentForm::value(std::string_view part) const {
  const auto found = std::ranges::find(values, part, &Json::part);
  return found == values.end() ? std::nullopt : std::optional(found->value);
}

Result<SentForm> sent_form(const Request& request, const KnownForm& known) {
  const std::string_view type = request.header("content-type").value_or("");
  if (!is_form(type)) return fail(fmt::format("found no form, expected {}", known.expected));
  AXIOMETRY_TRY(const auto parts, form_parts(type, request.body));
  SentForm form;
  for (const FormPart& part : parts) {
    AXIOMETRY_TRY(const KnownPart row, known_part(part, known));
    AXIOMETRY_TRY_VOID(take_form_part(form, part, row));
  }
  return form;
}

}  // namespace axiometry::server
