// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "axiometry/verification/clause3.h"
#include "axiometry/verification/exact.h"

namespace axiometry::verification {

/// Where what was printed is not what was found again.
struct Difference {
  std::string place;    ///< "E in the table of parameters"
  std::string printed;  ///< figure as it stands there
  std::string right;    ///< what was found again
};

/// What was compared, and what of it differs.
class Ledger {
 public:
  std::size_t figures = 0;   ///< recomputed and compared
  std::size_t verdicts = 0;  ///< decided again and compared
  /// Figures of GUM and Monte Carlo: held against each other wherever they are printed, but not computed again.
  std::size_t compared = 0;
  std::vector<Difference> differences;

  bool agrees() const { return differences.empty(); }

  /// A number in full precision, which may be `rounding` away from the exact value.
  template <std::invocable Place>
  void number(const Place& place, double printed, const Interval& right, const Interval& rounding) {
    ++figures;
    if (!is_number(printed) || !within(Interval::of(printed), right, rounding))
      differences.push_back({place(), exact_text(printed), shown(right, 15)});
  }

  /// The same of one that may not exist.
  template <std::invocable Place>
  void number(const Place& place, const std::optional<double>& printed, const Exact& right, const Interval& rounding) {
    if (printed && right) return number(place, *printed, *right, rounding);
    ++figures;
    if (printed || right)
      differences.push_back(
          {place(), printed ? exact_text(*printed) : "nothing", right ? shown(*right, 15) : "nothing"});
  }

  /// A number to its last place: half a unit of that place, and what rounding may do before. `coarse` zeros at the end
  /// of a number without decimals are no digits of it.
  template <std::invocable Place>
  void text(const Place& place, std::string_view printed, const Interval& right, const Interval& rounding,
            int coarse = 0) {
    ++figures;
    if (!rounds_to(printed, right, rounding, coarse))
      differences.push_back({place(), std::string(printed), shown(right, 8)});
  }

  /// A limit that is rounded to the side on which less is accepted, or rejected: by less than a unit of its last place.
  template <std::invocable Place>
  void inward(const Place& place, std::string_view printed, const Interval& right, const Interval& rounding,
              bool downward, int coarse) {
    ++figures;
    if (!rounds_inward(printed, right, rounding, downward, coarse))
      differences.push_back({place(), std::string(printed), shown(right, 8)});
  }

  /// Any two things that must be the same words.
  template <std::invocable Place>
  void words(const Place& place, std::string_view printed, std::string_view right) {
    if (printed != right) differences.push_back({place(), std::string(printed), std::string(right)});
  }

  void differ(std::string place, std::string printed, std::string right) {
    differences.push_back({std::move(place), std::move(printed), std::move(right)});
  }

 private:
  static bool is_number(double x);
  static std::string exact_text(double x);
  static bool rounds_to(std::string_view printed, const Interval& right, const Interval& rounding, int coarse);
  static bool rounds_inward(std::string_view printed, const Interval& right, const Interval& rounding, bool downward,
                            int coarse);
};

}  // namespace axiometry::verification
