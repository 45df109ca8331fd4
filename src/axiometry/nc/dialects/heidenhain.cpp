// SPDX-License-Identifier: Apache-2.0
//
// Klartext (conversational) is no word-address language: each line is a numbered sentence.
#include <fmt/format.h>

#include <span>
#include <variant>

#include "axiometry/nc/dialect.h"
#include "axiometry/nc/numbers.h"
#include "axiometry/nc/safe_text.h"
#include "axiometry/nc/script.h"

namespace axiometry::nc {
namespace heidenhain {
namespace {

constexpr std::string_view manual = R"manual(# Heidenhain TNC, Klartext

For TNC 426, 430, iTNC 530, TNC 320, 620, 640 and TNC7.

- Program: `BEGIN PGM 2302 MM` or `INCH`, or `--number N` (1 to 99999999): the file must have that name,
  `2302.H`. Blocks are always numbered
- Loops: program section repeats, `LBL 1` … `CALL LBL 1 REP 4`: once and four times more. At most 254 labels, as
  the oldest of these controls have them; what comes after is written out
- Moves: `L X+100.0000 R0 F1000`. In inch programs F is in tenths of an inch per minute, of rotary axes in
  degrees per minute always
- Lines in space: `L X+100.0000 Y+50.0000 Z+20.0000 R0 F1000`; F is the speed along the path. The tool of the last
  TOOL CALL lengthens Z: call tool 0 (or one of length 0) before, so that positions are those of the axes. An axis
  comes to rest by the dwells; on overruns and ways between lines, corners may be rounded within the tolerance of
  cycle 32, which is harmless as long as there is room for it
- Dwell: cycle 9, `CYCL DEF 9.0 DWELL TIME` and `CYCL DEF 9.1 DWELL 3`, seconds, up to 3600. It also brings
  the axis to rest, and is written for 0 s too
- Trigger: M8 (coolant; M9 ends it with the dwell), M24 to M28 or M57, between two halves of the dwell; from M89
  on the numbers are the control's own functions. What the machine's builder made of one stands in the machine's
  manual: look there first, also whether it ends by itself
- Lines end with CR LF
- Stop: with `--stop-at-start`, a comment says what to do, and `STOP` waits

Try in single block first: the first target with its dwell (time it), and the first repeat.

- The names in cycle 9 are English; a control with another dialog language shows its own.
- Coordinates are taken with 4 decimals, with an option 5. In inches they mostly have 6: give the plan targets
  that are multiples of 0.0001 in, or test in mm [inferred].
- Positions are those of the active datum. With `--frame machine` every absolute move has M91: the machine's datum,
  and the tool's length is not added. Presets (cycle 247) are to be activated before.
- Datum shift, mirroring, rotation, scaling, tilted plane and M128 must be off: they are not reset by the
  program.
- Rotary axes: with absolute angles M126 (shortest way) must be off, and an axis with a display that is reduced below
  360° never passes 0: `--rollover on`. All moves but the first are then increments (`L IC+10.0000`), whose sign is the
  direction, through 0 and over several turns, and `M127` cancels M126 before them [inferred]. The first, absolute,
  goes to an angle within one turn. Decimals that the control drops would add up: a comment says how many it must
  keep. Do not begin in the middle of such a program.)manual";

constexpr ControlLimits limits = {
    .feed_per_inch = 10.0,
    .dwell_longest = Duration::s(3600.0),
    .dwell_stops = true,
    .loops = 254,
    .m_codes = {{{8, 8, 9, 9}, {24, 28}, {57, 57}}},
    .frames = {.machine_move = "M91"},
};

constexpr std::size_t line_length = 79;
constexpr std::size_t number_length = 8;  // "1234567 " at most

class Sentences {
 public:
  explicit Sentences(const WorkFrame& frame) : frame_(frame) {}

  void add(std::string sentence) { text_ += fmt::format("{} {}\r\n", number_++, sentence); }

  void operator()(const Remark& remark) {
    for (const std::string& part : wrapped(safe(remark.text), line_length - number_length - 2)) add("; " + part);
  }
  void operator()(const Move& move) {
    std::string sentence = "L";
    bool increment = false;  // which no frame shifts
    for (const auto& [axis, coordinate, way] : move.axes) {
      increment = increment || way == AxisWay::increment;
      sentence += fmt::format(" {}{}{}{}", way == AxisWay::increment ? "I" : "", axis,
                              coordinate.starts_with('-') ? "" : "+", coordinate);
    }
    sentence += fmt::format(" R0 F{}", move.feed);
    if (!increment && !frame_.of_move.empty()) sentence += " " + frame_.of_move;
    if (!move.remark.empty()) {
      const std::string remark = " ; " + safe(move.remark);
      if (number_length + sentence.size() + remark.size() <= line_length)
        sentence += remark;
      else
        (*this)(Remark{move.remark});
    }
    add(sentence);
  }
  void operator()(const Dwell& dwell) {
    add("CYCL DEF 9.0 DWELL TIME");
    const std::string seconds = trimmed_number(static_cast<double>(dwell.steps) * limits.dwell_step.in_s(), 3);
    add("CYCL DEF 9.1 DWELL " + seconds);
  }
  void operator()(const Trigger& trigger) { add(fmt::format("M{}", trigger.m_code)); }
  void operator()(const OperatorStop& stop) {
    add("; " + safe(stop.message));
    add("STOP");
  }
  void operator()(const LoopBegin& loop) { add(fmt::format("LBL {}", loop.number)); }
  void operator()(const LoopEnd& loop) { add(fmt::format("CALL LBL {} REP {}", loop.number, loop.times - 1)); }

  std::string finish() && { return std::move(text_); }

 private:
  static std::string safe(std::string_view text) { return safe_text(text, ".,+-/=():"); }

  const WorkFrame& frame_;
  std::size_t number_ = 0;
  std::string text_;
};

template <typename Walked>
Result<std::string> write_walked(const Walked& walked, const ProgramOptions& options) {
  const unsigned number = options.number.value_or(2302);
  if (number < 1 || number > 99'999'999)
    return fail(fmt::format("found program number {}, expected 1 to 99999999", number));
  if (!options.block_numbers)
    return fail("found blocks without numbers asked for, expected them numbered as Klartext always is");
  AXIOMETRY_TRY(const Script script, make_script(walked, options, limits));
  const std::string name = fmt::format("PGM {} {}", number, script.inch ? "INCH" : "MM");
  Sentences sentences(script.frame);
  sentences.add("BEGIN " + name);
  for (const std::string& line : script.heading) sentences(Remark{line});
  if (options.rollover) sentences.add("M127");  // the short way, where it is on, could turn an increment round
  for (const Instruction& instruction : script.instructions) std::visit(sentences, instruction);
  sentences.add("M30");
  sentences.add("END " + name);
  return std::move(sentences).finish();
}

Result<std::string> write(std::span<const Plan> plans, const ProgramOptions& options) {
  return write_walked(plans, options);
}

}  // namespace
}  // namespace heidenhain

extern const Dialect heidenhain_dialect;
const Dialect heidenhain_dialect = {
    .id = "heidenhain",
    .title = "Heidenhain TNC, Klartext",
    .extension = ".h",
    .manual = heidenhain::manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = heidenhain::write,
    .write_tour = [](const PointTour& tour, const ProgramOptions& o) { return heidenhain::write_walked(tour, o); },
};

}  // namespace axiometry::nc
