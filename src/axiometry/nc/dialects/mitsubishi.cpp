// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/dialects/fanuc_like.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace mitsubishi {
namespace {

constexpr std::string_view manual = R"manual(# Mitsubishi

For M60, M70, M80, M700 and M800, machining centre system (L system lathes: as the notes on lathes of `fanuc`).

- Program: `%`, `O2302` or `--number N` (1 to 99999999; some hide 9000 and above), `M30`, `%`
- Loops: user macro, `WHILE [#1 LE 5] DO1` … `END1`, with the local variable #1; `--unrolled` without
- Start: `G21` or `G20`, `G17 G40 G49 G80 G90 G94`, `G61` (exact stop check)
- Dwell: `G4 X3.0`, seconds
- Trigger: M7 or M8 (coolant; M9 ends it with the dwell), M24 to M28, M57 or M150 to M189, between two halves of
  the dwell: numbers that neither RS-274-D nor the control gives to spindle, tool, axes or program. What the machine's
  builder made of one stands in the machine's list of M codes: look there first, also whether it ends by itself
- Work offset: the one that is active, or `--frame G54` to `G59`, `G54.1 P1` to `P48`

- Lines in space: X, Y and Z in one G1 block. F is the speed along the path, G61 brings all of them to rest, G49
  cancels the tool length: positions are those of the axes. Rotation, scaling, mirroring and tilted planes must be
  off: the program does not cancel them [inferred]

Try in single block first: the start blocks, the first target with its dwell, the first turn of the loop.

- Whether G20/G21 may be commanded is a parameter (#1041 is the initial state) [inferred].
- Rotary axes: #8213 (rotation axis type) of linear type is right for absolute angles. With the shortest way an axis
  does not come from the planned direction [inferred]: `--rollover on`.
- `--rollover on`, for a rotary axis that counts to 360° only: all moves but the first are increments (`G91`),
  whose sign is the direction, whatever #8213 says [inferred]. The first, absolute, goes to an angle within one
  turn the way that the control chooses. Decimals that the control drops would add up: a comment says how many it
  must keep. Do not begin in the middle of such a program)manual";

constexpr WordControl control = [] {
  WordControl c = fanuc_like;
  c.number->highest = 99'999'999;
  return c;
}();

}  // namespace
}  // namespace mitsubishi

extern const Dialect mitsubishi_dialect;
const Dialect mitsubishi_dialect = {
    .id = "mitsubishi",
    .title = "Mitsubishi M70, M80, M700, M800",
    .extension = ".prg",
    .manual = mitsubishi::manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans,
                const ProgramOptions& o) { return write_word_program(mitsubishi::control, plans, o); },
    .write_tour = [](const PointTour& tour,
                     const ProgramOptions& o) { return write_word_program(mitsubishi::control, tour, o); },
};

}  // namespace axiometry::nc
