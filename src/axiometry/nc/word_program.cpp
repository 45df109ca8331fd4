// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/word_program.h"

#include <fmt/format.h>

#include <variant>
#include <vector>

#include "axiometry/nc/numbers.h"
#include "axiometry/nc/safe_text.h"

namespace axiometry::nc {
namespace {

/// "C-4.0", "X1=5.0", "C=ACP(356.0)". "X1100" would be the axis X at 1100.
std::string axis_text(const AxisWord& word) {
  const auto way = [&](std::string_view rule) { return fmt::format("{}={}({})", word.axis, rule, word.coordinate); };
  switch (word.way) {
    case AxisWay::short_way: return way("DC");
    case AxisWay::upwards: return way("ACP");
    case AxisWay::downwards: return way("ACN");
    case AxisWay::position:
    case AxisWay::increment: break;
  }
  return fmt::format("{}{}{}", word.axis, word.axis.size() > 1 ? "=" : "", word.coordinate);
}

struct Block {
  std::string text;
  bool numbered = false;
};

class WordWriter {
 public:
  WordWriter(const WordControl& control, const WorkFrame& frame) : c_(control), frame_(frame) {}

  void lines(const Lines& templates, bool numbered, std::string_view number = "") {
    for (std::string_view line : templates)
      blocks_.push_back({fmt::format(fmt::runtime(line), fmt::arg("number", number)), numbered});
  }

  void operator()(const Remark& remark) {
    const std::size_t width = c_.line_length - c_.comment_begin.size() - c_.comment_end.size();
    for (const std::string& part : wrapped(safe(remark.text), width)) blocks_.push_back({comment(part), false});
  }

  void operator()(const Move& move) {
    std::string axes;
    bool increment = false;  // which no frame shifts
    for (const AxisWord& word : move.axes) {
      axes += (axes.empty() ? "" : " ") + axis_text(word);
      increment = increment || word.way == AxisWay::increment;
    }
    increments_ = increments_ || increment;
    const bool point = c_.feed_point && move.feed.find('.') == std::string::npos;
    std::string text = fmt::format(fmt::runtime(c_.move), fmt::arg("axes", axes),
                                   fmt::arg("feed", point ? move.feed + "." : move.feed));
    if (increment)
      text.insert(0, "G91 ");
    else if (!frame_.of_move.empty())
      text.insert(0, frame_.of_move + " ");
    if (!move.remark.empty()) {
      const std::string remark = comment(safe(move.remark));
      if (number_length + text.size() + 1 + remark.size() <= c_.line_length)
        text += " " + remark;
      else
        (*this)(Remark{move.remark});
    }
    blocks_.push_back({std::move(text), true});
  }

  void operator()(const Dwell& dwell) {
    std::string seconds = trimmed_number(static_cast<double>(dwell.steps) * c_.limits.dwell_step.in_s(), 3);
    if (seconds.find('.') == std::string::npos) seconds += ".0";
    blocks_.push_back(
        {fmt::format(fmt::runtime(c_.dwell), fmt::arg("seconds", seconds), fmt::arg("steps", dwell.steps)), true});
  }

  void operator()(const Trigger& trigger) { blocks_.push_back({fmt::format("M{}", trigger.m_code), true}); }

  void operator()(const OperatorStop& stop) {
    for (std::string_view line : c_.stop) {
      const bool is_comment = !c_.comment_begin.empty() && line.starts_with(c_.comment_begin);
      blocks_.push_back({fmt::format(fmt::runtime(line), fmt::arg("message", safe(stop.message))), !is_comment});
    }
  }

  void operator()(const LoopBegin& loop) { loop_lines(c_.loop_begin, loop.number, loop.times); }
  void operator()(const LoopEnd& loop) { loop_lines(c_.loop_end, loop.number, loop.times); }

  /// In words that say where, whatever the program had.
  void start_frame() {
    if (!frame_.start.empty()) blocks_.push_back({frame_.start, true});
  }
  void end_increments() {
    if (increments_) blocks_.push_back({"G90", true});
  }

  /// With block numbers in tens while there are enough of them, else in ones, else with none.
  std::string finish(bool block_numbers) && {
    std::size_t numbered = 0;
    for (const Block& block : blocks_) numbered += block.numbered;
    const std::size_t step = !block_numbers                             ? 0
                             : 10 * numbered <= c_.block_number_highest ? 10
                             : numbered <= c_.block_number_highest      ? 1
                                                                        : 0;
    std::string program;
    std::size_t number = 0;
    for (const Block& block : blocks_) {
      if (block.numbered && step > 0) program += fmt::format("N{} ", number += step);
      program += block.text;
      program += c_.crlf ? "\r\n" : "\n";
    }
    return program;
  }

 private:
  std::string safe(std::string_view text) const { return safe_text(text, c_.comment_characters); }
  std::string comment(std::string_view text) const {
    return fmt::format("{}{}{}", c_.comment_begin, text, c_.comment_end);
  }

  void loop_lines(const Lines& templates, std::size_t number, std::size_t times) {
    const std::size_t label = c_.label_highest - 2 * number;
    for (std::string_view line : templates)
      blocks_.push_back(
          {fmt::format(fmt::runtime(line), fmt::arg("loop", number), fmt::arg("times", times),
                       fmt::arg("more", times - 1), fmt::arg("label", label), fmt::arg("end_label", label + 1)),
           false});
  }

  static constexpr std::size_t number_length = 9;  ///< "N1234567 " at most

  const WordControl& c_;
  const WorkFrame& frame_;
  std::vector<Block> blocks_;
  bool increments_ = false;
};

Result<std::string> program_number(const WordControl& control, std::optional<unsigned> asked) {
  if (!control.number) {
    if (!asked) return std::string();
    return fail(fmt::format("found program number {}, expected none: the file's name is the program's", *asked));
  }
  const unsigned number = asked.value_or(control.number->otherwise);
  if (number >= control.number->lowest && number <= control.number->highest) return fmt::format("{:04}", number);
  return fail(fmt::format("found program number {}, expected {} to {}", number, control.number->lowest,
                          control.number->highest));
}

/// What a script is made of in this control's words.
struct Wording {
  std::string number;
  bool inch = false;
  bool block_numbers = true;
};

std::string worded(const WordControl& control, const Script& script, const Wording& wording) {
  WordWriter writer(control, script.frame);
  writer.lines(control.head, false, wording.number);
  // The comments first, so that they are read before anything moves.
  for (const std::string& line : script.heading) writer(Remark{line});
  if (script.has_loops) writer.lines(control.declare, false);
  writer.lines(wording.inch ? control.start_inch : control.start_mm, true);
  writer.start_frame();
  for (const Instruction& instruction : script.instructions) std::visit(writer, instruction);
  writer.end_increments();
  writer.lines(control.end, true);
  writer.lines(control.tail, false);
  return std::move(writer).finish(wording.block_numbers);
}

}  // namespace

Result<std::string> write_word_program(const WordControl& control, std::span<const Plan> plans,
                                       const ProgramOptions& options) {
  AXIOMETRY_TRY(const std::string number, program_number(control, options.number));
  AXIOMETRY_TRY(const Script script, make_script(plans, options, control.limits));
  const bool inch = script.inch && !(control.rotary_in_mm && plans.front().axis.kind == AxisKind::rotary);
  return worded(control, script, {number, inch, options.block_numbers});
}

Result<std::string> write_word_program(const WordControl& control, const PointTour& tour,
                                       const ProgramOptions& options) {
  AXIOMETRY_TRY(const std::string number, program_number(control, options.number));
  AXIOMETRY_TRY(const Script script, make_script(tour, options, control.limits));
  return worded(control, script, {number, script.inch, options.block_numbers});
}

}  // namespace axiometry::nc
