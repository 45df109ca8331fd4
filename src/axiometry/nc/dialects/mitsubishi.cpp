// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace {

constexpr std::string_view manual = R"manual(# Mitsubishi

For M60, M70, M80, M700 and M800, machining centre system (L system lathes: as the notes on lathes of `fanuc`).

- Program: `%`, `O2302` or `--number N` (1 to 99999999; some hide 9000 and above), `M30`, `%`
- Loops: user macro, `WHILE [#1 LE 5] DO1` … `END1`, with the local variable #1; `--unrolled` without
- Start: `G21` or `G20`, `G17 G40 G49 G80 G90 G94`, `G61` (exact stop check)
- Dwell: `G4 X3.0`, seconds
- Trigger: an M code between two halves of the dwell

- Lines in space: X, Y and Z in one G1 block. F is the speed along the path, G61 brings all of them to rest, G49
  cancels the tool length: positions are those of the axes. Rotation, scaling, mirroring and tilted planes must be
  off: the program does not cancel them [inferred]

Try in single block first: the start blocks, the first target with its dwell, the first turn of the loop.

- Whether G20/G21 may be commanded is a parameter (#1041 is the initial state) [inferred].
- Rotary axes: with #8213 (rotation axis type) set to the shortest way, the axis does not come from the planned
  direction [inferred]. Linear type is right for this test.)manual";

constexpr WordControl control = [] {
  WordControl c = fanuc_like;
  c.number->highest = 99'999'999;
  return c;
}();

}  // namespace

extern const Dialect mitsubishi_dialect;
const Dialect mitsubishi_dialect = {
    .id = "mitsubishi",
    .title = "Mitsubishi M70, M80, M700, M800",
    .extension = ".prg",
    .manual = manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans, const ProgramOptions& o) { return write_word_program(control, plans, o); },
    .write_tour = [](const PointTour& tour, const ProgramOptions& o) { return write_word_program(control, tour, o); },
};

}  // namespace axiometry::nc
