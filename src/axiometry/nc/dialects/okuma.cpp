// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace okuma {
namespace {

constexpr std::string_view manual = R"manual(# Okuma OSP

For OSP controls of machining centres (OSP-E100M, P200M, P300M and relatives).

- Program: `O2302` or `--number N` (1 to 9999), `M2`
- Loops: user task: the common variable VC1 counts, `IF [VC1 LT 5] NR1` jumps back to the block of the name NR1.
  VC1 is overwritten: see that nothing else on the machine keeps a value there. `--unrolled` uses no variable
- Start: `G21` or `G20` (they only confirm the unit: the control stops with an alarm when it is set to the other
  one [inferred]), `G17 G40 G80 G90 G94`, `G61` (exact stop)
- Dwell: `G4 F3.0`, seconds
- Trigger: M7 or M8 (coolant; M9 ends it with the dwell), between two halves of the dwell. Which other numbers of a
  machine are free is not known
- Lines end with CR LF [inferred]

- Lines in space: X, Y and Z in one block. F is the speed along the path, G61 brings all of them to rest. The tool
  length offset is not cancelled: do that before (G53), or Z is that of the tool [inferred]

Try in single block first: the start blocks, the first target with its dwell (time it: the unit of F in G4
follows the control's unit setting), and the jump at the end of the first loop [inferred].

- Work offset: the one that is active, or `--frame G15H1` to `G15H200` (as many as the control has); with
  `--frame machine` G15 H0 [inferred]. Tool length offset is as it is active: choose it before.
- Rotary axes: a parameter decides whether an absolute angle is reached the short way [inferred]; for absolute angles
  it must not.
- `--rollover on`, for a rotary axis that counts to 360° only: all moves but the first are increments (`G91`),
  whose sign is the direction [inferred]. The first, absolute, goes to an angle within one turn the way that the
  control chooses. Decimals that the control drops would add up: a comment says how many it must keep. Do not
  begin in the middle of such a program)manual";

constexpr WordControl control = {
    .limits = {.loops = 999, .frames = {.offsets = {{{"G15 H{}", 1, 200}}}, .machine_start = "G15 H0"}},
    .number = WordControl::ProgramNumber{},
    .head = {"O{number}"},
    .start_mm = {"G21", "G17 G40 G80 G90 G94", "G61"},
    .start_inch = {"G20", "G17 G40 G80 G90 G94", "G61"},
    .dwell = "G4 F{seconds}",
    .loop_begin = {"VC1=0", "NR{loop} VC1=VC1+1"},
    .loop_end = {"IF [VC1 LT {times}] NR{loop}"},
    .end = {"G64", "M2"},
    .crlf = true,
    .block_number_highest = 9999,
};

}  // namespace
}  // namespace okuma

extern const Dialect okuma_dialect;
const Dialect okuma_dialect = {
    .id = "okuma",
    .title = "Okuma OSP",
    .extension = ".min",
    .manual = okuma::manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans,
                const ProgramOptions& o) { return write_word_program(okuma::control, plans, o); },
    .write_tour = [](const PointTour& tour,
                     const ProgramOptions& o) { return write_word_program(okuma::control, tour, o); },
};

}  // namespace axiometry::nc
