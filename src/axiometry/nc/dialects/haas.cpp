// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/dialects/fanuc_like.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace haas {
namespace {

constexpr std::string_view manual = R"manual(# Haas

For mills (NGC and classic).

- Program: `%`, `O02302` or `--number N` (1 to 99999), `M30`, `%`
- Loops: macros, `WHILE [#1 LE 5] DO1` … `END1`, with the local variable #1. An option on older machines: use
  `--unrolled` without it
- Start: `G21` or `G20`, `G17 G40 G49 G80 G90 G94`, `G61` (exact stop)
- Dwell: `G4 P3.0`. With the decimal point P is in seconds, without it in milliseconds
- Trigger: M21 to M28 or, newer, M121 to M128, which wait for an answer; M51 to M58, switched off by M61 to M68 at the
  end of the dwell; M7 or M8 (coolant), by M9. Between two halves of the dwell
- Lines end with CR LF
- Work offset: the one that is active, or `--frame G54` to `G59`, `G154 P1` to `P99`. Coordinates of the machine are
  not offered: whether G53 drives at feed is not certain

- Lines in space: X, Y and Z in one G1 block. F is the speed along the path, G61 brings all of them to rest, G49
  cancels the tool length: positions are those of the axes. Rotation (G69), scaling (G50), mirroring (G100) and
  dynamic work offsets (G255) must be off: the program does not cancel them

Haas checks setting 9: a program in inches stops with an alarm on a machine in mm, and the other way round.
Setting 9 decides how many decimals are kept: 3 in mm, 4 in inches.

- `--rollover on`, for a rotary axis that counts to 360° only: all moves but the first are increments (`G91`),
  whose sign is the direction, whether the axis is set to the shortest way or not [inferred]. The first,
  absolute, goes to an angle within one turn the way that the control chooses. Decimals that the control drops
  would add up: a comment says how many it must keep. Do not begin in the middle of such a program

Try in single block first: the start blocks, the first target with its dwell, the first turn of the loop, and the
first move of a rotary axis beyond 0° and 360°.)manual";

constexpr WordControl control = [] {
  WordControl c = fanuc_like;
  c.number->highest = 99'999;
  c.limits.m_codes = {{coolant, {21, 28}, {51, 58, 61, 68}, {121, 128}}};
  c.limits.frames.offsets = {{{"G{}", 54, 59}, {"G154 P{}", 1, 99}}};
  c.crlf = true;
  c.head = {"%", "O{number:0>5}"};
  c.dwell = "G4 P{seconds}";
  return c;
}();

}  // namespace
}  // namespace haas

extern const Dialect haas_dialect;
const Dialect haas_dialect = {
    .id = "haas",
    .title = "Haas",
    .extension = ".nc",
    .manual = haas::manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans,
                const ProgramOptions& o) { return write_word_program(haas::control, plans, o); },
    .write_tour = [](const PointTour& tour,
                     const ProgramOptions& o) { return write_word_program(haas::control, tour, o); },
};

}  // namespace axiometry::nc
