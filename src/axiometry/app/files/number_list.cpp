// SPDX-License-Identifier: Apache-2.0
#include "axiometry/app/files/number_list.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <optional>

#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry::app {
namespace {

constexpr std::size_t most_distances = 100'000;

/// The numbers after `from` up to `to`, every `step`. Each is from + k·step, so that no error grows.
Result<void> go_on(std::vector<double>& list, double from, double to, double step, std::string_view text) {
  const double count = (to - from) / step;
  if (!(step > 0.0) || !(count >= 0.0) || std::abs(count - std::nearbyint(count)) > 1e-6)
    return fail(fmt::format("found {}, steps of {:g} from {:g}, expected ascending steps that end on {:g}",
                            text::quoted(text), step, from, to));
  if (count > static_cast<double>(most_distances))
    return fail(fmt::format("found {:.0f} distances, expected at most {}", count, most_distances));
  const auto last = static_cast<std::size_t>(std::nearbyint(count));
  for (std::size_t k = 1; k <= last; ++k) list.push_back(k == last ? to : from + static_cast<double>(k) * step);
  return {};
}

Result<double> number_in_list(std::string_view text, std::string_view whole) {
  if (const auto number = parse_number(text::trim(text))) return *number;
  return fail(fmt::format("found {} in {}, expected a number", text::quoted(text), text::quoted(whole)));
}

}  // namespace

Result<Vector3> parse_vector(std::string_view text) {
  const auto parts = text::split(text, ',');
  Vector3 vector;
  if (parts.size() == 3) {
    bool good = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto number = parse_number(text::trim(parts[k]));
      good = good && number;
      vector[k] = number.value_or(0.0);
    }
    if (good) return vector;
  }
  return fail(fmt::format("found {}, expected three numbers X,Y,Z separated by commas", text::quoted(text)));
}

Result<std::vector<double>> parse_distances(std::string_view text) {
  std::vector<double> list;
  bool going_on = false;
  for (const std::string_view part : text::split(text, ',')) {
    const std::string_view item = text::trim(part);
    if (item == "…" || item == "...") {
      if (list.size() < 2 || going_on)
        return fail(fmt::format("found {}, expected two numbers before each …", text::quoted(text)));
      going_on = true;
      continue;
    }
    const auto ends = text::split(item, ':');
    if (going_on) {
      AXIOMETRY_TRY(const double to, number_in_list(item, text));
      const double from = list.back();
      AXIOMETRY_TRY_VOID(go_on(list, from, to, from - list[list.size() - 2], text));
      going_on = false;
    } else if (ends.size() == 3) {
      AXIOMETRY_TRY(const double from, number_in_list(ends[0], text));
      AXIOMETRY_TRY(const double to, number_in_list(ends[1], text));
      AXIOMETRY_TRY(const double step, number_in_list(ends[2], text));
      list.push_back(from);
      AXIOMETRY_TRY_VOID(go_on(list, from, to, step, text));
    } else if (ends.size() == 1) {
      AXIOMETRY_TRY(const double number, number_in_list(item, text));
      list.push_back(number);
    } else {
      return fail(
          fmt::format("found {} in {}, expected a number or FROM:TO:STEP", text::quoted(item), text::quoted(text)));
    }
  }
  if (going_on) return fail(fmt::format("found {}, expected a number after …", text::quoted(text)));
  if (list.size() > most_distances)
    return fail(fmt::format("found {} distances, expected at most {}", list.size(), most_distances));
  for (std::size_t k = 0; k < list.size(); ++k) {
    if (!(list[k] >= 1e-6) || list[k] > 1e9)
      return fail(fmt::format("found a distance of {:g} mm, expected 1e-6 mm to 1e9 mm", list[k]));
    if (k > 0 && list[k] <= list[k - 1])
      return fail(fmt::format("found {:g} mm after {:g} mm, expected ascending distances", list[k], list[k - 1]));
  }
  return list;
}

}  // namespace axiometry::app
