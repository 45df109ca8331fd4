// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace linuxcnc {
namespace {

constexpr std::string_view manual = R"manual(# LinuxCNC

For version 2.4 and later. Programs of this dialect are run through LinuxCNC's own interpreter in the tests.

- Program: the file's name names it; `M2` ends it
- Loops: O-words, `o101 repeat [5]` … `o101 endrepeat`; no variables are used
- Start: `G21` or `G20`, `G17 G40 G49 G80 G90 G94`, `G61.1` (exact stop; `G61` alone only keeps the path)
- Dwell: `G4 P3.0`, seconds
- Trigger: M7 or M8 (coolant; M9 ends it with the dwell), or M100 to M199: a program of that name in the M code
  folder, which can pulse an output. The interpreter refuses one that does not exist
- Message: with `--stop-at-start`, `(MSG, …)` shows what to do, and `M0` waits

- Lines in space: X, Y and Z in one block. With G94 F is the speed along the path; G61.1 brings all of them to rest;
  G49 cancels the tool length, so that positions are those of the axes. A machine whose kinematics are not trivial
  (five axes, hexapod) must be in the mode in which X, Y and Z are those of the plan

Rotary axes A, B, C are in degrees and degrees per minute whatever the unit. An axis that is configured as wrapped
(`WRAPPED_ROTARY`) takes the sign of an absolute angle as the direction and refuses 360° and more: `--rollover on`.
All moves but the first are then increments (`G91`), whose sign is the direction, through 0° and over several turns,
whether the axis is wrapped or not; the first goes to an angle within one turn (wrapped: upwards). Do not begin in
the middle of such a program. Both are run through the interpreter in the tests.

Work offset: the one that is active, and G92, shift all positions. `--frame G54` to `G59.3` activates one; with
`--frame machine` every absolute move has G53, which neither offsets nor G92 nor tool length shift.

Try in single block first: the start blocks and the first target with its dwell.)manual";

constexpr WordControl control = {
    .limits = {.loops = 10'000,
               .m_codes = {{coolant, {100, 199}}},
               .frames = {.offsets = {{{"G{}", 54, 59}, {"G59.{}", 1, 3}}}, .machine_move = "G53"}},
    .comment_characters = ".,+-/=[]:",
    .start_mm = {"G21", "G17 G40 G49 G80 G90 G94", "G61.1"},
    .start_inch = {"G20", "G17 G40 G49 G80 G90 G94", "G61.1"},
    .feed_point = false,
    .dwell = "G4 P{seconds}",
    .stop = {"(MSG, {message})", "M0"},
    .loop_begin = {"o{loop} repeat [{times}]"},
    .loop_end = {"o{loop} endrepeat"},
    .end = {"G64", "M2"},
};

}  // namespace
}  // namespace linuxcnc

extern const Dialect linuxcnc_dialect;
const Dialect linuxcnc_dialect = {
    .id = "linuxcnc",
    .title = "LinuxCNC",
    .extension = ".ngc",
    .manual = linuxcnc::manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans,
                const ProgramOptions& o) { return write_word_program(linuxcnc::control, plans, o); },
    .write_tour = [](const PointTour& tour,
                     const ProgramOptions& o) { return write_word_program(linuxcnc::control, tour, o); },
};

}  // namespace axiometry::nc
