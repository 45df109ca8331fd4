// SPDX-License-Identifier: Apache-2.0
//
// Columns that may tell which of several axes a row is of.
#include <fmt/format.h>

#include <cmath>
#include <set>

#include "axiometry/formats/table/generic_draft.h"
#include "axiometry/formats/text/name_words.h"

namespace axiometry::formats::generic {
namespace {

// clang-format off
constexpr NameWord words_of_axes[] = {
    {"axis"}, {"axes"}, {"axe"}, {"asse"}, {"eje"}, {"eixo"}, {"achs", WordPlace::front}, {"achse", WordPlace::back},
    {"轴", WordPlace::anywhere}, {"軸", WordPlace::anywhere}};
// clang-format on

}  // namespace

bool may_number_axes(std::string_view name, const ColumnFacts& facts) {
  constexpr double highest = 99.0;
  constexpr std::size_t most_axes = 9;
  if (!has_any_word(name, words_of_axes) || !facts.numeric() || facts.words > 0 || !facts.whole) return false;
  if (facts.least < 0.0 || facts.largest > highest) return false;
  return facts.distinct >= 2 && facts.distinct <= most_axes && facts.distinct * 2 <= facts.numbers;
}

void ask_about_axes(Draft& draft, std::size_t c, const ColumnFacts& facts) {
  std::set<double> numbers;
  for (const double x : facts.values)
    if (!std::isnan(x)) numbers.insert(x);
  draft.give_role(c, ImportRole::ignore, 0.95, "its name, and whole numbers that come back");
  draft.ask("columns",
            fmt::format("found the numbers {} in {}; do they part axes?", fmt::join(numbers, ", "), draft.called(c)));
}

}  // namespace axiometry::formats::generic
