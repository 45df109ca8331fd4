// SPDX-License-Identifier: Apache-2.0
#include "axiometry/formats/test/source_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>

#include "axiometry/base/text/text.h"
#include "axiometry/model/swapped_labels.h"

namespace axiometry::formats {

using json::Kind;
using json::Value;

namespace {

Result<const Value*> text_member(const Value& object, std::string_view name) {
  if (!object.is(Kind::object))
    return fail(
        fmt::format("found the kind {}, expected an object with a member \"{}\"", json::kind_name(object.kind()), name),
        object.at());
  const Value* value = object.find(name);
  if (value == nullptr) return fail(fmt::format("found no member \"{}\", expected a string", name), object.at());
  if (!value->is(Kind::text))
    return fail(
        fmt::format("found \"{}\" that is of the kind {}, expected a string", name, json::kind_name(value->kind())),
        value->at());
  return value;
}

}  // namespace

Result<std::vector<SourceRemark>> source_from(const Value& source) {
  if (source.is(Kind::null)) return std::vector<SourceRemark>{};
  std::string texts[3];
  constexpr std::string_view names[] = {"file", "sha256", "format"};
  for (std::size_t k = 0; k < 3; ++k) {
    AXIOMETRY_TRY(const Value* value, text_member(source, names[k]));
    texts[k] = value->text();
  }
  const Value* remarked = source.find("remarks");
  const Value* departures = source.find("departures");
  const Value* swapped = source.find("swapped_labels");
  const std::size_t most =
      3 + std::size_t{remarked != nullptr} + std::size_t{departures != nullptr} + std::size_t{swapped != nullptr};
  if (source.members().size() > most)
    return fail(fmt::format("found {} members of source, expected file, sha256, format, remarks, departures and "
                            "swapped_labels",
                            source.members().size()),
                source.at());
  if (swapped != nullptr && !swapped->is(Kind::boolean))
    return fail("found swapped_labels of source that is neither true nor false", swapped->at());
  if (texts[1].find_first_not_of("0123456789abcdef") != std::string::npos || texts[1].size() > 64)
    return fail(fmt::format("found source.sha256 {}, expected 64 hexadecimal digits", text::quoted(texts[1])),
                source.at());
  std::vector<SourceRemark> remarks{
      {false, fmt::format("taken from {}, read as {}{}{}", text::quoted(texts[0]), text::quoted(texts[2]),
                          texts[1].empty() ? "" : ", SHA-256 ", texts[1])}};
  for (const auto& [list, departs] : {std::pair{remarked, false}, std::pair{departures, true}}) {
    if (list == nullptr) continue;
    if (!list->is(Kind::array)) return fail("found remarks or departures of source that are no array", list->at());
    for (const Value& remark : list->items()) {
      if (!remark.is(Kind::text)) return fail("found one of source that is no string", remark.at());
      // Files from before there was a member of its own for it have its sentence.
      remarks.push_back({departs, remark.text(), remark.text() == swapped_labels});
    }
  }
  if (swapped != nullptr && swapped->boolean() && std::ranges::none_of(remarks, &SourceRemark::of_swapped_labels))
    remarks.push_back(swapped_labels_remark());
  return remarks;
}

Value source_to_json(const Provenance& source) {
  Value result = Value::object();
  result.add("file", source.file);
  result.add("sha256", source.sha256);
  result.add("format", source.format);
  std::vector<Value> remarks, departures;
  for (const SourceRemark& told : source.remarks)
    if (!told.of_swapped_labels) (told.departs ? departures : remarks).emplace_back(told.message);
  if (!remarks.empty()) result.add("remarks", Value::array(std::move(remarks)));
  if (!departures.empty()) result.add("departures", Value::array(std::move(departures)));
  if (std::ranges::any_of(source.remarks, &SourceRemark::of_swapped_labels)) result.add("swapped_labels", true);
  return result;
}

}  // namespace axiometry::formats
