// SPDX-License-Identifier: Apache-2.0
#include "axiometry/tracking/lengths/reading_order.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "axiometry/base/counted.h"
#include "axiometry/base/text/number_text.h"
#include "axiometry/base/text/text.h"
#include "axiometry/model/aligned.h"
#include "axiometry/numeric/median.h"
#include "axiometry/tracking/geometry/line_geometry.h"
#include "axiometry/tracking/lengths/reading_name.h"

namespace axiometry::tracking {
namespace {

constexpr std::ptrdiff_t shift_most = 5;  // most approaches by which the order may be shifted
constexpr double scale_most = 0.08;       // largest scale error of a machine; 1 % is a broken one
constexpr double change_least_mm = 0.5;   // no machine stands farther from where it should, but for its scale
constexpr double exact_mm = 0.1;          // a jump this near to an interval of targets is no break of the beam
constexpr double shown_many = 1.0 / 3.0;  // share of misfitting steps beyond which no order fits

/// A reading, or an approach that a reading may belong to.
struct ReadingPlace {
  std::size_t line = 0;
  double distance_mm = 0.0;
  double tolerance_mm = 0.0;  // tolerance of a change of length on this line
};

struct Lines {
  std::vector<LineGeometry> geometry;
  std::vector<double> tolerance_mm;
};

/// 0.4 of the smallest interval, so that neighbouring targets are never mistaken for one another.
double tolerance_of(const LineGeometry& geometry) {
  double smallest = 1e9;
  for (std::size_t i = 1; i < geometry.distances_mm.size(); ++i)
    smallest = std::min(smallest, std::abs(geometry.distances_mm[i] - geometry.distances_mm[i - 1]));
  return std::max(0.4 * smallest, 0.02);
}

Result<Lines> lines_of(const TrackingPlan& plan) {
  Lines lines;
  for (const TrackingLine& line : plan.lines) {
    AXIOMETRY_TRY(LineGeometry geometry, line_geometry(setup_along(plan.setup, line), line));
    lines.tolerance_mm.push_back(tolerance_of(geometry));
    lines.geometry.push_back(std::move(geometry));
  }
  return lines;
}

/// Lengths in an order, at places that they may have been taken at.
class Order {
 public:
  Order(std::vector<double> lengths, std::vector<ReadingPlace> places)
      : lengths_(std::move(lengths)), places_(std::move(places)) {}

  struct Steps {
    std::size_t compared = 0;
    std::size_t unfit = 0;
  };
  /// Steps from reading to reading when every reading stands at its own place.
  Steps as_given() const {
    Steps steps;
    for (std::size_t j = 0; j + 1 < lengths_.size(); ++j) count(j, j, j + 1, steps);
    return steps;
  }

  struct Loss {
    std::size_t from = 0;  // first reading that belongs to another approach
    std::ptrdiff_t shift = 0;
    std::size_t unfit = 0;  // steps that still do not fit
    double apart_mm = 0.0;  // misfit of the step across which the order is lost
  };
  /// The places that explain the steps best where the order may be lost several times: a change of the shift counts as
  /// much as a step that does not fit.
  struct Course {
    std::vector<Loss> changes;  // changes of the shift, each counted from the places as given
    std::size_t unfit = 0;      // steps that still do not fit
  };
  Course best_course() const {
    constexpr std::size_t never = std::numeric_limits<std::size_t>::max() / 2;
    constexpr std::size_t states = 2 * shift_most + 1, own = shift_most;
    const std::size_t n = lengths_.size();
    const auto shift = [](std::size_t s) { return static_cast<std::ptrdiff_t>(s) - shift_most; };
    std::array<std::size_t, states> cost;
    cost.fill(1);
    cost[own] = 0;
    std::vector<std::array<std::size_t, states>> from(n);
    for (std::size_t j = 0; j + 1 < n; ++j) {
      std::array<std::size_t, states> next;
      next.fill(never);
      for (std::size_t a = 0; a < states; ++a)
        for (std::size_t b = 0; b < states; ++b) {
          const auto here = at(j, shift(a)), there = at(j + 1, shift(b));
          if (!here || !there || cost[a] >= never) continue;
          Steps step;
          count(j, here, there, step);
          const std::size_t sum = cost[a] + (a == b ? 0 : 1) + step.unfit;
          if (sum > next[b] || (sum == next[b] && a != b)) continue;
          next[b] = sum;
          from[j + 1][b] = a;
        }
      cost = next;
    }
    std::size_t state = own;
    for (std::size_t s = 0; s < states; ++s)
      if (cost[s] < cost[state]) state = s;
    Course course{{}, cost[state]};
    for (std::size_t j = n - 1; j > 0; --j) {
      const std::size_t before = from[j][state];
      if (before != state) course.changes.insert(course.changes.begin(), Loss{j, shift(state), 0, 0.0});
      state = before;
    }
    if (state != own) course.changes.insert(course.changes.begin(), Loss{0, shift(state), 0, 0.0});
    course.unfit -= course.changes.size();
    return course;
  }

  /// The place from which on another place by `shift` explains the steps best.
  std::optional<Loss> best_loss(std::ptrdiff_t shift) const {
    const std::size_t n = lengths_.size();
    if (n < 3) return std::nullopt;
    std::vector<std::size_t> shifted_after(n, 0);  // unfit steps behind reading j, all places shifted
    for (std::size_t j = n - 1; j-- > 0;) {
      Steps step;
      count(j, at(j, shift), at(j + 1, shift), step);
      shifted_after[j] = shifted_after[j + 1] + step.unfit;
    }
    std::optional<Loss> best;
    std::size_t before = 0;  // unfit steps up to reading j, all as given
    for (std::size_t j = 0; j + 1 < n; ++j) {
      Steps across;
      count(j, j, at(j + 1, shift), across);
      const std::size_t unfit = before + across.unfit + shifted_after[j + 1];
      if (across.compared > 0 && (!best || unfit < best->unfit))
        best = Loss{j + 1, shift, unfit, *apart(j, j, at(j + 1, shift))};
      Steps step;
      count(j, j, j + 1, step);
      before += step.unfit;
    }
    return best;
  }

 private:
  std::optional<std::size_t> at(std::size_t j, std::ptrdiff_t shift) const {
    const std::ptrdiff_t place = static_cast<std::ptrdiff_t>(j) + shift;
    if (place < 0 || place >= static_cast<std::ptrdiff_t>(places_.size())) return std::nullopt;
    return static_cast<std::size_t>(place);
  }

  /// Change of length from reading j to the next, less that of the distances; nothing between different lines.
  std::optional<double> apart(std::size_t j, std::optional<std::size_t> a, std::optional<std::size_t> b) const {
    if (!a || !b || *a >= places_.size() || *b >= places_.size() || places_[*a].line != places_[*b].line)
      return std::nullopt;
    const double change = lengths_[j + 1] - lengths_[j];
    if (std::isnan(change)) return std::nullopt;
    return change - (places_[*b].distance_mm - places_[*a].distance_mm);
  }

  void count(std::size_t j, std::optional<std::size_t> a, std::optional<std::size_t> b, Steps& steps) const {
    const auto difference = apart(j, a, b);
    if (!difference) return;
    const double nominal = std::abs(places_[*b].distance_mm - places_[*a].distance_mm);
    const double allowed = std::min(std::max(change_least_mm, scale_most * nominal), places_[*a].tolerance_mm);
    ++steps.compared;
    if (std::abs(*difference) > allowed) ++steps.unfit;
  }

  std::vector<double> lengths_;
  std::vector<ReadingPlace> places_;
};

std::vector<ReadingPlace> places_of(const Lines& lines, std::span<const LengthReading> readings,
                                    const std::map<std::string, std::size_t>& numbers) {
  std::vector<ReadingPlace> places;
  for (const LengthReading& r : readings) {
    const std::size_t line = numbers.at(r.line);
    places.push_back({line, lines.geometry[line].distances_mm[r.approach.target], lines.tolerance_mm[line]});
  }
  return places;
}

std::map<std::string, std::size_t> line_numbers(const TrackingPlan& plan) {
  std::map<std::string, std::size_t> numbers;
  for (std::size_t k = 0; k < plan.lines.size(); ++k) numbers.emplace(plan.lines[k].id, k);
  return numbers;
}

std::string_view one_or_more(std::ptrdiff_t count, std::string_view one, std::string_view more) {
  return count == 1 ? one : more;
}

/// "…: from reading 57 on (target 3↑ run 2 of line xy) they fit the approaches 1 later, as if 1 reading were missing"
std::string told(const Order::Loss& loss, const LengthReading& at) {
  const std::ptrdiff_t count = std::abs(loss.shift);
  return fmt::format("from reading {} on ({}) the lengths fit the approaches {} {}, as if {} {} {} before it",
                     loss.from + 1, reading_name_with_line(at), count, loss.shift > 0 ? "later" : "earlier", count,
                     one_or_more(count, "reading", "readings"),
                     loss.shift > 0 ? one_or_more(count, "was missing", "were missing")
                                    : one_or_more(count, "had been taken too many", "had been taken too many"));
}

/// What a factor between lengths and distances is likely to come from.
std::string_view reason_for(double factor) {
  struct Known {
    double factor;
    std::string_view reason;
  };
  constexpr Known known[] = {{1000.0, "lengths in µm read as mm, or in mm read as m"},
                             {0.001, "lengths in m read as mm, or in mm read as µm"},
                             {1e6, "lengths in nm read as mm"},
                             {1.0 / 25.4, "lengths in inches read as mm"},
                             {25.4, "lengths in mm read as inches"},
                             {2.0, "the way of the light there and back"},
                             {0.5, "half the way"}};
  for (const Known& k : known)
    if (std::abs(std::abs(factor) / k.factor - 1.0) < scale_most) return k.reason;
  return "another plan";
}

Result<void> check_scale(const std::string& line, std::vector<double> ratios) {
  if (ratios.empty()) return {};
  const double factor = numeric::upper_median(std::move(ratios));
  if (std::abs(factor - 1.0) <= scale_most) return {};
  if (std::abs(factor + 1.0) <= scale_most)
    return fail(
        fmt::format("found lengths of line {} that fall where the reflector recedes from the station, expected them to "
                    "grow: the instrument counts the other way, or these are the lengths of another plan",
                    line));
  return fail(
      fmt::format("found lengths of line {} that change by {} times the distances of the plan, expected 1 times: {}",
                  line, format_exact(std::round(factor * 1e6) / 1e6), reason_for(factor)));
}

/// Factors of the changes of length over those of the distances.
Result<void> check_scales(const TrackingPlan& plan, std::span<const LengthReading> readings,
                          const std::vector<ReadingPlace>& places) {
  std::vector<std::vector<double>> ratios(plan.lines.size());
  for (std::size_t j = 0; j + 1 < readings.size(); ++j) {
    if (places[j].line != places[j + 1].line) continue;
    const double nominal = places[j + 1].distance_mm - places[j].distance_mm;
    if (std::abs(nominal) < places[j].tolerance_mm) continue;
    ratios[places[j].line].push_back((readings[j + 1].length_difference_mm - readings[j].length_difference_mm) /
                                     nominal);
  }
  for (std::size_t k = 0; k < plan.lines.size(); ++k)
    AXIOMETRY_TRY_VOID(check_scale(plan.lines[k].id, std::move(ratios[k])));
  return {};
}

}  // namespace

std::vector<LengthReading> approaches_of(const TrackingPlan& plan) {
  std::vector<LengthReading> all;
  for (const TrackingLine& line : plan.lines)
    for (const Approach& approach : approaches(line.plan)) all.push_back({line.id, approach, 0.0, 0});
  return all;
}

Result<std::vector<LengthReading>> assign_in_order(const TrackingPlan& plan, std::span<const OrderedLength> lengths) {
  std::vector<LengthReading> all = approaches_of(plan);
  if (lengths.size() != all.size()) {
    std::string message =
        fmt::format("found {}, expected {}, one for each approach of the plan's {}", counted(lengths.size(), "length"),
                    all.size(), counted(plan.lines.size(), "line"));
    const auto shift = static_cast<std::ptrdiff_t>(all.size()) - static_cast<std::ptrdiff_t>(lengths.size());
    if (std::abs(shift) <= shift_most && !lengths.empty()) {
      AXIOMETRY_TRY(const Lines lines, lines_of(plan));
      std::vector<double> values;
      for (const OrderedLength& l : lengths) values.push_back(l.missing ? std::nan("") : l.length_difference_mm);
      const Order order(std::move(values), places_of(lines, all, line_numbers(plan)));
      if (const auto loss = order.best_loss(shift); loss && loss->unfit == 0 && loss->from < all.size())
        message += "; " + told(*loss, all[loss->from]);
    }
    return fail(std::move(message));
  }
  std::vector<LengthReading> readings;
  for (std::size_t j = 0; j < all.size(); ++j) {
    if (lengths[j].missing) continue;
    readings.push_back(std::move(all[j]));
    readings.back().length_difference_mm = lengths[j].length_difference_mm;
    readings.back().segment = lengths[j].segment;
  }
  return readings;
}

Result<void> check_order(const TrackingPlan& plan, std::span<const LengthReading> readings, bool in_program_order) {
  AXIOMETRY_TRY(const Lines lines, lines_of(plan));
  const std::vector<ReadingPlace> places = places_of(lines, readings, line_numbers(plan));
  AXIOMETRY_TRY_VOID(check_scales(plan, readings, places));
  std::vector<double> lengths;
  for (const LengthReading& r : readings) lengths.push_back(r.length_difference_mm);
  const Order order(std::move(lengths), places);
  const Order::Steps given = order.as_given();
  if (given.unfit == 0) return {};
  std::optional<Order::Loss> best;
  for (std::ptrdiff_t size = 1; size <= shift_most; ++size)
    for (const std::ptrdiff_t shift : {size, -size})
      if (const auto loss = order.best_loss(shift); loss && (!best || loss->unfit < best->unfit)) best = loss;
  const bool most_explained = best && given.unfit >= 3 && 3 * best->unfit <= given.unfit;
  const bool single = best && in_program_order && best->unfit == 0 && std::abs(best->apart_mm) <= exact_mm;
  if (most_explained || single)
    return fail(fmt::format("found lengths that do not fit the order of the plan, expected one for each approach: {}",
                            told(*best, readings[best->from])));
  if (const Order::Course course = order.best_course();
      course.changes.size() > 1 && given.unfit >= 3 && 3 * (course.unfit + course.changes.size() - 1) <= given.unfit)
    return fail(fmt::format(
        "found lengths that do not fit the order of the plan, expected one for each approach: {}, and others again "
        "from reading {} on ({})",
        told(course.changes[0], readings[course.changes[0].from]), course.changes[1].from + 1,
        reading_name_with_line(readings[course.changes[1].from])));
  if (static_cast<double>(given.unfit) > std::max(2.0, shown_many * static_cast<double>(given.compared)))
    return fail(fmt::format(
        "found {} of {} changes of length from reading to reading that do not fit the targets, expected nearly all to: "
        "the lengths belong to another plan or stand in another order",
        given.unfit, given.compared));
  return {};
}

}  // namespace axiometry::tracking
