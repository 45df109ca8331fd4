// SPDX-License-Identifier: Apache-2.0
#include "axiometry/model/motion_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

#include "axiometry/base/counted.h"
#include "axiometry/base/reading_limits.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"

namespace axiometry {
namespace {

constexpr double shortest_travel = 1e-6;  // mm: what no axis resolves; a slope over less says nothing

auto order_of(const MotionReading& r) { return std::tuple(r.direction, r.run, r.position_mm); }

template <typename Of>
auto distinct(const std::vector<MotionReading>& readings, Of of) {
  std::vector<decltype(of(readings.front()))> list;
  list.reserve(readings.size());
  for (const MotionReading& r : readings) list.push_back(of(r));
  std::ranges::sort(list);
  list.erase(std::ranges::unique(list).begin(), list.end());
  return list;
}

std::string place_of(double position_mm, Direction direction, std::size_t run) {
  return fmt::format("position {} mm {} of run {}", format_exact(position_mm), arrow(direction), run);
}

Result<void> check_ranges(const std::vector<MotionReading>& readings) {
  for (const MotionReading& r : readings) {
    if (!(std::abs(r.value) <= largest_stated))
      return fail(fmt::format("found the reading {}, expected one up to 1e9", format_exact(r.value)), r.at);
    if (!(std::abs(r.position_mm) <= largest_stated))
      return fail(fmt::format("found the position {} mm, expected one up to 1e9 mm", format_exact(r.position_mm)),
                  r.at);
  }
  return {};
}

}  // namespace

std::string_view motion_unit_name(MotionUnit unit) {
  return unit == MotionUnit::um ? "um" : unit == MotionUnit::urad ? "urad" : "arcsec";
}

std::string_view motion_unit_symbol(MotionUnit unit) {
  return unit == MotionUnit::um ? "µm" : unit == MotionUnit::urad ? "µrad" : "″";
}

Result<MotionName> motion_name(std::string_view name) {
  const auto upper = [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; };
  if (name.size() == 3 && upper(name[0]) == 'E') {
    const MotionName found{upper(name[1]), upper(name[2])};
    const bool linear_axis = found.axis >= 'X' && found.axis <= 'Z';
    if (linear_axis && (found.rotation() || (found.coordinate >= 'X' && found.coordinate <= 'Z'))) return found;
  }
  return fail(fmt::format("found the error {}, expected E, X to Z or A to C, and the axis X, Y or Z, as in EYX or EAX",
                          text::quoted(name)));
}

Result<ReadingSense> reading_sense(std::string_view given) {
  constexpr std::string_view minus = "−";
  const bool is_minus = given.starts_with(minus);
  const std::string_view letter = given.substr(std::min(given.size(), is_minus ? minus.size() : std::size_t{1}));
  if (letter.size() == 1 && (is_minus || given[0] == '-' || given[0] == '+')) {
    const char upper = letter[0] >= 'a' ? static_cast<char>(letter[0] - 'a' + 'A') : letter[0];
    if ((upper >= 'A' && upper <= 'C') || (upper >= 'X' && upper <= 'Z')) return ReadingSense{upper, given[0] != '+'};
  }
  return fail(
      fmt::format("found {} as the way readings are positive, expected a sign and X, Y, Z, A, B or C, such as "
                  "+Y or -A",
                  text::quoted(given)));
}

Result<MotionSeries> MotionSeries::make(std::vector<MotionReading> readings, MotionUnit unit,
                                        std::size_t positions_least) {
  if (readings.empty()) return fail("found no readings, expected one on each line");
  AXIOMETRY_TRY_VOID(check_ranges(readings));
  for (MotionReading& r : readings) r.position_mm += 0.0;  // −0 is 0
  MotionSeries series;
  series.unit_ = unit;
  series.positions_mm_ = distinct(readings, [](const MotionReading& r) { return r.position_mm; });
  series.directions_ = distinct(readings, [](const MotionReading& r) { return r.direction; });
  const std::vector<std::size_t> runs = distinct(readings, [](const MotionReading& r) { return r.run; });
  series.runs_ = runs.size();
  if (series.positions_mm_.size() < positions_least)
    return fail(fmt::format("found {}, expected at least {}",
                            counted(series.positions_mm_.size(), "different position"), positions_least));
  if (!(series.travel_mm() >= shortest_travel))
    return fail(fmt::format("found all positions within {} mm, expected a travel of 1e-6 mm or more",
                            format_exact(series.travel_mm())));

  std::ranges::stable_sort(readings, {}, order_of);
  series.values_.reserve(readings.size());
  auto next = readings.begin();
  for (const Direction direction : series.directions_)
    for (const std::size_t run : runs)
      for (const double position_mm : series.positions_mm_) {
        const auto wanted = std::tuple(direction, run, position_mm);
        if (next != readings.begin() && next != readings.end() && order_of(*next) == order_of(*(next - 1)))
          return fail(fmt::format("found {} a second time, expected each reading once; the first is on line {}",
                                  place_of(next->position_mm, next->direction, next->run), (next - 1)->at.line),
                      next->at);
        if (next == readings.end() || order_of(*next) != wanted)
          return fail(
              fmt::format("found no reading at {}, expected every run in each direction to have the same "
                          "nominal positions",
                          place_of(position_mm, direction, run)));
        series.values_.push_back(next->value);
        ++next;
      }
  if (next != readings.end())
    return fail(fmt::format("found {} a second time, expected each reading once; the first is on line {}",
                            place_of(next->position_mm, next->direction, next->run), (next - 1)->at.line),
                next->at);
  return series;
}

}  // namespace axiometry
