// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/script.h"

/// Part programs of blocks of words, a letter and a number each (ISO 6983-1 and its relatives). One writer for all of
/// them; what differs from control to control is a description.
namespace axiometry::nc {

/// At most four lines of text.
class Lines {
 public:
  constexpr Lines() = default;
  constexpr Lines(std::initializer_list<std::string_view> lines) : size_(lines.size()) {
    std::ranges::copy(lines, lines_.begin());
  }
  constexpr const std::string_view* begin() const { return lines_.data(); }
  constexpr const std::string_view* end() const { return lines_.data() + size_; }

 private:
  std::array<std::string_view, 4> lines_;
  std::size_t size_ = 0;
};

/// How a control writes things. The lines are templates for fmt; each knows the names in braces that stand beside it.
struct WordControl {
  ControlLimits limits;

  std::string_view comment_begin = "(";
  std::string_view comment_end = ")";
  std::string_view comment_characters = ".,+-/=[]";  ///< besides capitals, digits and blanks

  struct ProgramNumber {
    unsigned lowest = 1;
    unsigned highest = 9999;
    unsigned otherwise = 2302;  ///< when none is asked for
  };
  std::optional<ProgramNumber> number = {};  ///< absent: the file's name is the program's

  Lines head = {};                              ///< {number}; before the comments, never numbered
  Lines start_mm = {};                          ///< the safe start
  Lines start_inch = {};                        ///< lines that begin an inch program
  bool rotary_in_mm = false;                    ///< whether the program of a rotary axis has the metric start always
  std::string_view move = "G1 {axes} F{feed}";  ///< {axes}: "X1.0 Y2.0", "X1=1.0", "C=ACP(1.0)"
  bool feed_point = true;                       ///< whether a whole feed has a decimal point
  std::string_view dwell = {};                  ///< {seconds}, with a point, or {steps} of the control
  Lines stop = {"M0 ({message})"};              ///< {message}
  Lines declare = {};                           ///< lines before the start when there are loops, never numbered
  Lines loop_begin = {};       ///< {loop} = 1, 2, …, {times}, {more} = times − 1, {label}, {end_label}
  Lines loop_end = {};         ///< end of the loop, with the same words in braces
  unsigned label_highest = 0;  ///< labels of the loops are numbers below it
  Lines end = {};              ///< numbered
  Lines tail = {};             ///< lines after it, never numbered
  bool crlf = false;           ///< whether lines end with CR LF
  unsigned block_number_highest = 99'999;
  std::size_t line_length = 79;  ///< comments are wrapped to it
};

/// Fails as make_script() does, and on a program number where the control has none or that is beyond its range.
Result<std::string> write_word_program(const WordControl& control, std::span<const Plan> plans,
                                       const ProgramOptions& options);
Result<std::string> write_word_program(const WordControl& control, const PointTour& tour,
                                       const ProgramOptions& options);

}  // namespace axiometry::nc
