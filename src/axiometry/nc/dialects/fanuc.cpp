// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/dialects/fanuc_like.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace fanuc {
namespace {

constexpr std::string_view manual = R"manual(# Fanuc

For series 0i, 16i, 18i, 21i, 30i to 35i and relatives, machining centres and other machines with G code system
B or C.

- Program: `%`, `O2302` or `--number N` (1 to 9999), `M30`, `%`
- Loops: custom macro B, `WHILE [#1 LE 5] DO1` … `END1`, with the local variable #1. An option on older
  controls, which stop with an alarm without it: use `--unrolled`
- Start: `G21` or `G20` in a block of its own, `G17 G40 G49 G80 G90 G94`, `G61` (exact stop, so that every
  target is reached)
- Dwell: `G4 X3.0`, seconds
- Trigger: M7 or M8 (coolant; M9 ends it with the dwell), M24 to M28, M57 or M150 to M189, between two halves of
  the dwell: numbers that neither RS-274-D nor the control gives to spindle, tool, axes or program. What the machine's
  builder made of one stands in the machine's list of M codes: look there first, also whether it ends by itself
- Comments: in round brackets, capitals

- Lines in space: X, Y and Z in one G1 block. F is the speed along the path, G61 brings all of them to rest, G49
  cancels the tool length: positions are those of the axes. Rotation (G69), scaling (G50), mirroring (G50.1) and
  tilted planes (G69.1) must be off: the program does not cancel them

Try in single block first: the start blocks, the first two targets, and the first turn of the loop (up to
`END1`).

- Lathes with G code system A know neither G90 nor G94: put G98 in their place, and use an axis name that is
  absolute there (X, Z, not U, W). Where X is programmed as a diameter the axis would move half as far as
  planned: switch to radius programming.
- With increment system IS-B the control has 3 decimals in mm (4 in inches) and drops more: targets of the plan
  should be multiples of 0.001 mm, and the program written with `--decimals 3`. IS-C has one more.
- Work offset: the one that is active, or `--frame G54` to `G59`, `G54.1 P1` to `P48` (an option). Coordinates of the
  machine cannot be had at feed: G53 drives at rapid.
- A rotary axis with rollover (parameter 1008, ROA = 1) goes to an absolute angle the short way round (RAB = 0) or as
  the sign says (RAB = 1), and would not come from the planned direction: `--rollover on`. All moves but the first
  are then increments (`G91`), which both settings turn by their sign, also through 0 and over several turns. The
  first, absolute, goes to an angle within one turn the way that the control chooses. Decimals that the control drops
  would add up: a comment says how many it must keep. Do not begin in the middle of such a program.
- Program numbers from 8000 are often protected.)manual";

constexpr const WordControl& control = fanuc_like;

}  // namespace
}  // namespace fanuc

extern const Dialect fanuc_dialect;
const Dialect fanuc_dialect = {
    .id = "fanuc",
    .title = "Fanuc (custom macro B)",
    .extension = ".nc",
    .manual = fanuc::manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans,
                const ProgramOptions& o) { return write_word_program(fanuc::control, plans, o); },
    .write_tour = [](const PointTour& tour,
                     const ProgramOptions& o) { return write_word_program(fanuc::control, tour, o); },
};

}  // namespace axiometry::nc
