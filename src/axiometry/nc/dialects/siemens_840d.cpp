// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace siemens_840d {
namespace {

constexpr std::string_view manual = R"manual(# Siemens SINUMERIK 840D

For 840D, 840D sl, 828D and SINUMERIK ONE in Siemens language (not in ISO dialect mode: there, use `fanuc`).

- Program: the file's name is the program's: `NAME.MPF`; `M30` ends it
- Loops: `FOR AXM_RUN = 1 TO 5` … `ENDFOR`, with a variable of the program (`DEF INT`); no R parameter is
  touched
- Start: `G710` or `G700` (unlike G71 and G70, they hold for the feed as well), `G17 G40 G90 G94`, `G60 G601`
  (exact stop, fine), `G1` at feed
- Axes: X, Y, Z, U, V, W, A, B, C, with a number where the machine has one: `X1=100.0`
- Dwell: `G4 F3.0`, seconds
- Trigger: M7 or M8 (coolant; M9 ends it with the dwell), M27, M28, M57 or M150 to M189, between two halves of
  the dwell: numbers that neither RS-274-D nor the control gives to spindle, gears, punching or program. What the
  machine's builder made of one stands in the machine's list of M codes: look there first, also whether it ends by
  itself
- Lines in space: X, Y and Z in one block, which must be the geometry axes of the channel. F is the speed along the
  path as long as they are the axes of FGROUP, as they are by default; G60 G601 brings all of them to rest
- Message: with `--stop-at-start`, `MSG("…")` shows what to do, and `M0` waits

Try in single block first: the start blocks, the first target with its dwell, the first turn of the loop.

- The frame that is active (G54 …, TRANS, ROT) and the tool's offset (D) shift positions. `--frame G54` to `G57`,
  `G505` to `G599` or `G500` (none of them) activates one; with `--frame machine` the program cancels the tool's offset
  (`D0`) and every move has `SUPA`, which suppresses all frames. No transformation (TRAORI, TRANSMIT) may be active.
- Rotary modulo axes (MD30310 ROT_IS_MODULO) refuse angles outside 0° to 359.999° (alarm 16830), and go within that
  range without passing 0: `--rollover on`. Every move then names angle and direction, `C=ACP(10.0)` upwards and
  `C=ACN(350.0)` downwards, also through 0; a way of a turn and more is driven in parts below half a turn; the first
  move goes the short way (`DC`). The modulo range must begin at 0 (MD30340). An axis without modulo refuses ACP.
- 802D and 808D know neither DEF nor FOR: use `--unrolled`.)manual";

constexpr WordControl control = {
    .limits = {.numbered_axes = true,
               .loops = 10'000,
               .m_codes = {{coolant, {27, 28}, {57, 57}, {150, 189}}},
               .frames = {.offsets = {{{"G{}", 54, 57}, {"G{}", 500, 500}, {"G{}", 505, 599}}},
                          .machine_start = "D0",
                          .machine_move = "SUPA"},
               .rollover = RolloverWords::directed},
    .comment_begin = "; ",
    .comment_end = "",
    .comment_characters = ".,+-/=[]():",
    .start_mm = {"G710", "G17 G40 G90 G94", "G60 G601"},
    .start_inch = {"G700", "G17 G40 G90 G94", "G60 G601"},
    .feed_point = false,
    .dwell = "G4 F{seconds}",
    .stop = {"MSG(\"{message}\")", "M0", "MSG()"},
    .declare = {"DEF INT AXM_RUN"},
    .loop_begin = {"FOR AXM_RUN = 1 TO {times}"},
    .loop_end = {"ENDFOR"},
    .end = {"G64", "M30"},
};

}  // namespace
}  // namespace siemens_840d

extern const Dialect siemens_840d_dialect;
const Dialect siemens_840d_dialect = {
    .id = "siemens-840d",
    .title = "Siemens SINUMERIK 840D",
    .extension = ".mpf",
    .manual = siemens_840d::manual,
    .axes = "X Y Z U V W A B C, with or without a number (X1)",
    .has_loops = true,
    .write = [](std::span<const Plan> plans,
                const ProgramOptions& o) { return write_word_program(siemens_840d::control, plans, o); },
    .write_tour = [](const PointTour& tour,
                     const ProgramOptions& o) { return write_word_program(siemens_840d::control, tour, o); },
};

}  // namespace axiometry::nc
