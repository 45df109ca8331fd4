// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/sensor_extremes.h"

#include <algorithm>
#include <functional>

#include "axiometry/base/text/text.h"

namespace axiometry {
namespace {

constexpr std::string_view words_of_extremes[] = {
    "max",      "maxi", "maximum", "maximal", "maximale", "min",    "mini",        "minimum",    "minimal",
    "minimale", "peak", "peaks",   "highest", "lowest",   "spitze", "spitzenwert", "höchstwert", "tiefstwert"};
/// What else is told of readings of one sensor within a while.
constexpr std::string_view words_of_means[] = {"mean",       "avg",     "average", "mittel",
                                               "mittelwert", "moyenne", "moy",     "actual"};

/// Small letters, parted by what is none.
void for_words(std::string_view name, const std::function<void(const std::string&)>& see) {
  constexpr std::string_view between = " _-.,:()[]/";
  while (!name.empty()) {
    const std::size_t end = std::min(name.find_first_of(between), name.size());
    if (end > 0) see(text::to_lower(name.substr(0, end)));
    name.remove_prefix(std::min(end + 1, name.size()));
  }
}

}  // namespace

bool names_extremes(std::string_view sensor) {
  bool found = false;
  for_words(sensor, [&](const std::string& word) { found = found || text::is_one_of(word, words_of_extremes); });
  return found;
}

std::string sensor_alone(std::string_view sensor) {
  std::string alone;
  for_words(sensor, [&](const std::string& word) {
    if (!text::is_one_of(word, words_of_extremes) && !text::is_one_of(word, words_of_means)) alone += word;
  });
  return alone;
}

}  // namespace axiometry
