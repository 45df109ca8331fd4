// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace {

constexpr std::string_view manual = R"manual(# Mazak, EIA/ISO programs

For Mazatrol controls of machining centres that run EIA/ISO programs (Fusion 640, Matrix, Smooth).

- Program: `%`, `O2302` or `--number N` (1 to 99999999), `M30`, `%`
- Loops: user macro, `WHILE [#1 LE 5] DO1` … `END1`, with the local variable #1; `--unrolled` without
- Start: `G21` or `G20`, `G17 G40 G49 G80 G90 G94`, `G61` (exact stop check)
- Dwell: `G4 X3.0`, seconds
- Trigger: an M code between two halves of the dwell

- Lines in space: X, Y and Z in one G1 block. F is the speed along the path, G61 brings all of them to rest, G49
  cancels the tool length: positions are those of the axes. Rotation, scaling, mirroring and tilted planes must be
  off: the program does not cancel them [inferred]

Try in single block first: the start blocks, the first target with its dwell, the first turn of the loop.

- Inch needs the inch option, and a parameter decides what is active at power on [inferred].
- High-speed modes (G5 P2, G61.1) must be off [inferred].
- Rotary axes: the shortest-way parameter must be off, or the axis does not come from the planned direction
  [inferred].)manual";

constexpr WordControl control = [] {
  WordControl c = fanuc_like;
  c.number->highest = 99'999'999;
  return c;
}();

}  // namespace

extern const Dialect mazak_eia_dialect;
const Dialect mazak_eia_dialect = {
    .id = "mazak-eia",
    .title = "Mazak (EIA/ISO)",
    .extension = ".eia",
    .manual = manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans, const ProgramOptions& o) { return write_word_program(control, plans, o); },
    .write_tour = [](const PointTour& tour, const ProgramOptions& o) { return write_word_program(control, tour, o); },
};

}  // namespace axiometry::nc
