// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/dialects/fanuc_like.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace mazak_eia {
namespace {

constexpr std::string_view manual = R"manual(# Mazak, EIA/ISO programs

For Mazatrol controls of machining centres that run EIA/ISO programs (Fusion 640, Matrix, Smooth).

- Program: `%`, `O2302` or `--number N` (1 to 99999999), `M30`, `%`
- Loops: user macro, `WHILE [#1 LE 5] DO1` … `END1`, with the local variable #1; `--unrolled` without
- Start: `G21` or `G20`, `G17 G40 G49 G80 G90 G94`, `G61` (exact stop check)
- Dwell: `G4 X3.0`, seconds
- Trigger: M7 or M8 (coolant; M9 ends it with the dwell), M24 to M28, M57 or M150 to M189, between two halves of
  the dwell: numbers that neither RS-274-D nor the control gives to spindle, tool, axes or program. What the machine's
  builder made of one stands in the machine's list of M codes: look there first, also whether it ends by itself
- Lines end with CR LF [inferred]
- Work offset: the one that is active, or `--frame G54` to `G59`, `G54.1 P1` to `P48`

- Lines in space: X, Y and Z in one G1 block. F is the speed along the path, G61 brings all of them to rest, G49
  cancels the tool length: positions are those of the axes. Rotation, scaling, mirroring and tilted planes must be
  off: the program does not cancel them [inferred]

Try in single block first: the start blocks, the first target with its dwell, the first turn of the loop.

- Inch needs the inch option, and a parameter decides what is active at power on [inferred].
- High-speed modes (G5 P2, G61.1) must be off [inferred].
- `--rollover on`, for a rotary axis that counts to 360° only: all moves but the first are increments (`G91`),
  whose sign is the direction, whether the shortest-way parameter is on or not [inferred]. The first, absolute,
  goes to an angle within one turn the way that the control chooses. Decimals that the control drops would add
  up: a comment says how many it must keep. Do not begin in the middle of such a program)manual";

constexpr WordControl control = [] {
  WordControl c = fanuc_like;
  c.number->highest = 99'999'999;
  c.crlf = true;
  return c;
}();

}  // namespace
}  // namespace mazak_eia

extern const Dialect mazak_eia_dialect;
const Dialect mazak_eia_dialect = {
    .id = "mazak-eia",
    .title = "Mazak (EIA/ISO)",
    .extension = ".eia",
    .manual = mazak_eia::manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans,
                const ProgramOptions& o) { return write_word_program(mazak_eia::control, plans, o); },
    .write_tour = [](const PointTour& tour,
                     const ProgramOptions& o) { return write_word_program(mazak_eia::control, tour, o); },
};

}  // namespace axiometry::nc
