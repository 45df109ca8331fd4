// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
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
- Trigger: an M code between two halves of the dwell
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
- A rotary axis with rollover (parameter 1008) goes to an absolute position the short way round, or as the sign
  says. Switch rollover off for the test, or stay within half a turn, or it will not come from the planned
  direction [inferred].
- Program numbers from 8000 are often protected.)manual";

constexpr const WordControl& control = fanuc_like;

}  // namespace

extern const Dialect fanuc_dialect;
const Dialect fanuc_dialect = {
    .id = "fanuc",
    .title = "Fanuc (custom macro B)",
    .extension = ".nc",
    .manual = manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans, const ProgramOptions& o) { return write_word_program(control, plans, o); },
    .write_tour = [](const PointTour& tour, const ProgramOptions& o) { return write_word_program(control, tour, o); },
};

}  // namespace axiometry::nc
