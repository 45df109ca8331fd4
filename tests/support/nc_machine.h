// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <charconv>
#include <cmath>
#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
  double dwell_before_m_code_s = 0.0;
  std::size_t dwells = 0;  ///< blocks
  std::vector<unsigned> m_codes = {};
  std::size_t stops = 0;  ///< M0
};

struct Trace {
  std::string axis;  ///< all that were named, in the order in which they came: "X", "XYZ"
  bool inch = false;
  bool ended = false;
  std::vector<Visit> visits;
};

inline double nc_number(std::string_view text) {
  double x = 0.0;
  const auto [end, fault] = std::from_chars(text.data() + text.starts_with('+'), text.data() + text.size(), x);
  if (fault != std::errc() || end != text.data() + text.size())
    throw std::runtime_error("no number: " + std::string(text));
  if (text.starts_with("-0") && x == 0.0) throw std::runtime_error("negative zero");
  return x;
}

/// Everything up to `end` from `text`, which loses it.
inline std::string_view take_until(std::string_view& text, std::string_view end) {
  const std::size_t at = text.find(end);
  if (at == std::string_view::npos) throw std::runtime_error("no " + std::string(end) + " in " + std::string(text));
  const std::string_view taken = text.substr(0, at);
  text.remove_prefix(at + end.size());
  return taken;
}

inline std::string_view trimmed(std::string_view s) {
  while (s.starts_with(' ')) s.remove_prefix(1);
  while (s.ends_with(' ')) s.remove_suffix(1);
  return s;
}

inline std::vector<std::string_view> lines_of(std::string_view program) {
  std::vector<std::string_view> lines;
  while (!program.empty()) lines.push_back(take_until(program, "\n"));
  return lines;
}

/// The axis and what it has done.
class NcMachine {
 public:
  /// Axes with their coordinates, which go there together.
  using Words = std::vector<std::pair<std::string, std::string_view>>;

  void move(const Words& words, double feed, bool inch, double feed_per_inch = 1.0) {
    check_running();
    if (words.empty()) throw std::runtime_error("a move of no axis");
    Visit visit;
    if (!trace_.visits.empty()) visit.at = trace_.visits.back().at;
    trace_.inch = inch;
    for (const auto& [axis, coordinate] : words) {
      if (coordinate.find('.') == std::string_view::npos) throw std::runtime_error("a coordinate without a point");
      if (visit.named.find(axis) != std::string::npos) throw std::runtime_error("an axis twice: " + axis);
      const bool scaled = inch && axis.find_first_of("ABC") == std::string::npos;
      const double unit = scaled ? 25.4 : 1.0;
      const auto decimals = static_cast<int>(coordinate.size() - coordinate.find('.') - 1);
      visit.at[axis] = nc_number(coordinate) * unit;
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
      at().dwell_before_m_code_s = at().dwell_s;
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

  Trace trace_;
};

}  // namespace axiometry::testing_support
