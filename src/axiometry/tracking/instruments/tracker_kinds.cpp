// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/instruments/tracker_kinds.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "axiometry/base/text/text.h"

namespace axiometry::tracking {
namespace {

// Where the table prints "±10 µm ± 0.5 µm/m" it is taken as the sum of both; "within ±0.5 µm/m" as ±0.5 µm/m.
constexpr TrackerKind kinds[] = {
    {.id = "leica-at960",
     .title = "Leica AT960",
     .range_m = "40/160",
     .across = StatedAccuracy{15, 6},
     .interferometer = StatedAccuracy{0, 0.5}},
    {.id = "leica-at930", .title = "Leica AT930", .range_m = "160", .across = StatedAccuracy{15, 6}},
    {.id = "leica-at901",
     .title = "Leica AT901",
     .range_m = "50/160",
     .across = StatedAccuracy{15, 6},
     .absolute = StatedAccuracy{10, 0},
     .interferometer = StatedAccuracy{0.4, 0.3}},
    {.id = "leica-at402",
     .title = "Leica AT402",
     .range_m = "320",
     .across = StatedAccuracy{15, 6},
     .absolute = StatedAccuracy{10, 0}},
    {.id = "leica-at401",
     .title = "Leica AT401",
     .range_m = "320",
     .across = StatedAccuracy{15, 6},
     .absolute = StatedAccuracy{10, 0}},
    {.id = "leica-ltd600",
     .title = "Leica LTD600",
     .range_m = "40",
     .across = StatedAccuracy{25, 0},
     .absolute = StatedAccuracy{25, 0},
     .interferometer = StatedAccuracy{10, 0.5}},
    {.id = "api-tracker3",
     .title = "API Tracker3",
     .range_m = "30/80/>120",
     .across = StatedAccuracy{0, 3.5},
     .absolute = StatedAccuracy{15, 0},
     .interferometer = StatedAccuracy{0, 0.5}},
    {.id = "api-radian",
     .title = "API Radian",
     .range_m = "40/100/>160",
     .across = StatedAccuracy{0, 3.5},
     .absolute = StatedAccuracy{10, 0},
     .interferometer = StatedAccuracy{0, 0.5}},
    {.id = "api-omnitrac2",
     .title = "API Omnitrac2",
     .range_m = "160/200",
     .across = StatedAccuracy{0, 3.5},
     .absolute = StatedAccuracy{15, 0}},
    {.id = "faro-ion",
     .title = "FARO ION",
     .range_m = "30/40/55",
     .across = StatedAccuracy{20, 5},
     .absolute = StatedAccuracy{16, 0.8},
     .interferometer = StatedAccuracy{4, 0.8}},
    {.id = "faro-vantage",
     .title = "FARO Vantage",
     .range_m = "30/60/80",
     .across = StatedAccuracy{20, 5},
     .absolute = StatedAccuracy{16, 0.8}},
    {.id = "etalon-lasertracer",
     .title = "Etalon LaserTRACER",
     .range_m = "0.2–20",
     .interferometer = StatedAccuracy{0.2, 0.3, true}},
};

}  // namespace

RangingUncertainty StatedAccuracy::expanded_uncertainty() const {
  const double factor = expanded ? 1.0 : 2.0 / std::numbers::sqrt3;
  return {Length::um(factor * constant_um), RelativeLength::um_per_m(factor * um_per_m)};
}

std::span<const TrackerKind> tracker_kinds() { return kinds; }

Result<std::optional<ChosenTracker>> find_tracker(std::string_view name, LengthMode mode) {
  const std::size_t colon = name.find(':');
  const std::string id = text::to_lower(name.substr(0, colon));
  const auto kind = std::ranges::find(kinds, id, &TrackerKind::id);
  if (kind == std::end(kinds)) return std::nullopt;
  if (colon == std::string_view::npos) {
    const auto& first = mode == LengthMode::absolute ? kind->absolute : kind->interferometer;
    return ChosenTracker{kind, first ? first : mode == LengthMode::absolute ? kind->interferometer : kind->absolute};
  }
  const std::string which = text::to_lower(name.substr(colon + 1));
  if (which != "adm" && which != "ifm")
    return fail(fmt::format("found {} behind {}, expected adm or ifm", text::quoted(which), id));
  const auto& length = which == "adm" ? kind->absolute : kind->interferometer;
  if (!length) return fail(fmt::format("found {}, of which Table 1 has no {} lengths", id, which));
  return ChosenTracker{kind, length};
}

}  // namespace axiometry::tracking
