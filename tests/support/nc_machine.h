// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/nc_rollover.h"

/// What a part program makes a machine do, found by running its text. Shares nothing with the writers; knows just
/// enough of each language to run a positioning test, and throws on everything else.
namespace axiometry::testing_support {

/// A position the axes were sent to, in mm or degrees.
struct Visit {
  double position = 0.0;                  ///< of the first axis that was named
  std::string named = {};                 ///< the axes of this move, as they stand in the block: "XZ"
  std::map<std::string, double> at = {};  ///< where each axis stands that has been named so far
  double resolution = 0.0;                ///< one unit of its last decimal, mm or degrees
  double feed = 0.0;                      ///< mm/min or degrees/min
  double dwell_s = 0.0;                   ///< all there
  std::size_t dwells = 0;                 ///< blocks
  std::vector<unsigned> m_codes = {};
  std::vector<double> dwell_before_m_code_s = {};  ///< each of them
  std::size_t stops = 0;                           ///< M0
  std::string frame = {};  ///< word by which the position is that of the machine, or the work offset's; "" as it is
};

struct Trace {
  std::string axis;  ///< all that were named, in the order in which they came: "X", "XYZ"
  bool inch = false;
  bool ended = false;
  std::vector<Visit> visits;
  bool crlf = false;  ///< whether every line ended so
};

/// The axis and what it has done.
class NcMachine {
 public:
  /// Axes with their coordinates, which go there together.
  using Words = std::vector<std::pair<std::string, std::string_view>>;

  explicit NcMachine(NcSetup setup) : setup_(setup) {}

  /// The work offset, or the frame, of all moves from now on.
  void select_frame(std::string frame) { frame_ = std::move(frame); }

  /// By the words' numbers from where the axes stand.
  void move_by(const Words& words, double feed, bool inch, double feed_per_inch = 1.0) {
    incremental_ = true;
    move(words, feed, inch, feed_per_inch);
    incremental_ = false;
  }

  /// `frame` is that of this move alone.
  void move(const Words& words, double feed, bool inch, double feed_per_inch = 1.0,
            const std::optional<std::string>& frame = {}) {
    check_running();
    if (words.empty()) throw std::runtime_error("a move of no axis");
    Visit visit;
    visit.frame = frame.value_or(frame_);
    if (!trace_.visits.empty()) visit.at = trace_.visits.back().at;
    trace_.inch = inch;
    for (const auto& [axis, coordinate] : words) {
      if (coordinate.find('.') == std::string_view::npos) throw std::runtime_error("a coordinate without a point");
      if (visit.named.find(axis) != std::string::npos) throw std::runtime_error("an axis twice: " + axis);
      const bool scaled = inch && axis.find_first_of("ABC") == std::string::npos;
      const double unit = scaled ? 25.4 : 1.0;
      const auto decimals = static_cast<int>(coordinate.size() - coordinate.ends_with(')') - coordinate.find('.') - 1);
      if (axis.find_first_of("ABC") != std::string::npos) {
        const double at = visit.at.contains(axis) ? visit.at[axis] : setup_.start_deg;
        visit.at[axis] = incremental_ ? at + nc_number(coordinate) : turned_to(setup_.rotary, at, coordinate);
      } else {
        if (incremental_) throw std::runtime_error("a linear axis by increments");
        visit.at[axis] = nc_number(coordinate) * unit;
      }
      if (visit.named.empty()) visit.position = visit.at[axis];
      visit.named += axis;
      visit.resolution = std::pow(10.0, -decimals) * unit;
      visit.feed = scaled ? feed / feed_per_inch * unit : feed;
      if (trace_.axis.find(axis) == std::string::npos) trace_.axis += axis;
    }
    trace_.visits.push_back(std::move(visit));
  }

  void dwell(double seconds) {
    Visit& here = at();
    here.dwell_s += seconds;
    ++here.dwells;
  }

  void m_code(unsigned code) {
    check_running();
    if (code == 2 || code == 30) {
      trace_.ended = true;
    } else if (code == 0) {
      ++at().stops;
    } else {
      at().dwell_before_m_code_s.push_back(at().dwell_s);
      at().m_codes.push_back(code);
    }
  }

  Trace finish() && {
    if (!trace_.ended) throw std::runtime_error("the program does not end");
    return std::move(trace_);
  }

 private:
  void check_running() const {
    if (trace_.ended) throw std::runtime_error("a block after the end of the program");
  }
  Visit& at() {
    check_running();
    if (trace_.visits.empty()) throw std::runtime_error("something before the first move");
    return trace_.visits.back();
  }

  NcSetup setup_;
  std::string frame_;
  bool incremental_ = false;
  Trace trace_;
};

}  // namespace axiometry::testing_support
