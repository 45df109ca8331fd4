// SPDX-License-Identifier: Apache-2.0
#include "axiometry/report/option_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

#include "axiometry/base/text/text.h"

namespace axiometry::report {
namespace {

using enum DisplayUnit;
constexpr std::array<std::pair<std::string_view, DisplayUnit>, 5> words_of_units = {
    {{"um", um}, {"mm", mm}, {"nm", nm}, {"deg", deg}, {"arcsec", arcsec}}};

}  // namespace

Result<char> decimal_mark_of(std::string_view word) {
  if (word == "point") return '.';
  if (word == "comma") return ',';
  return fail(fmt::format("found the decimal mark {}, expected point or comma", text::quoted(word)));
}

Result<DisplayUnit> unit_of(std::string_view word) {
  const auto row = std::ranges::find(words_of_units, word, &std::pair<std::string_view, DisplayUnit>::first);
  if (row != words_of_units.end()) return row->second;
  return fail(fmt::format("found the unit {}, expected um, mm, nm, deg or arcsec", text::quoted(word)));
}

}  // namespace axiometry::report
