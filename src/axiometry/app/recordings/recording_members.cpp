// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/recordings/recording_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "axiometry/app/files/given_text.h"
#include "axiometry/app/recordings/capture_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {

using json::Value;

bool is_of_lengths(std::string_view option) {
  constexpr std::string_view of_positions[] = {"part", "reverse", "datum", "zero"};
  return std::ranges::find(of_positions, option) == std::end(of_positions);
}

Result<void> take_recording(formats::JsonMembers& members, CaptureOptions& options) {
  const Value* given = members.optional("recording");
  if (given == nullptr) return {};
  if (!given->is(json::Kind::object))
    return fail(fmt::format("recording: found {}, expected an object", json::kind_name(given->kind())), given->at());
  RecordingTexts texts;
  for (const auto& [name, value] : given->members()) {
    if (!is_of_lengths(name))
      return fail(fmt::format("recording: found {}, which lengths do not have", text::quoted(name)), value.at());
    AXIOMETRY_TRY(const std::string raw, formats::text_in(value, name));
    AXIOMETRY_TRY(std::string text, given_line(name, raw));
    texts.emplace_back(name, std::move(text));
  }
  auto read = capture_options_from(texts);
  if (!read) return fail(read.error().message, given->at());
  options = *std::move(read);
  return {};
}

Result<void> check_no_recording_stated(const CaptureOptions& options) {
  if (options.stated.empty()) return {};
  return fail(fmt::format("found the option {} of continuous recordings and tables of lengths alone, expected none",
                          text::quoted(options.stated)));
}

Value recording_value(const RecordingTexts& texts) {
  Value object = Value::object();
  for (const auto& [name, text] : texts) object.add(name, text);
  return object;
}

}  // namespace axiometry::app
