// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
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
- Trigger: an M code between two halves of the dwell
- Lines in space: X, Y and Z in one block, which must be the geometry axes of the channel. F is the speed along the
  path as long as they are the axes of FGROUP, as they are by default; G60 G601 brings all of them to rest
- Message: with `--stop-at-start`, `MSG("…")` shows what to do, and `M0` waits

Try in single block first: the start blocks, the first target with its dwell, the first turn of the loop.

- The frame that is active (G54 …, TRANS, ROT) and the tool's offset (D) shift positions: `G500` and `D0` before
  the program, or on purpose. No transformation (TRAORI, TRANSMIT) may be active.
- Rotary modulo axes: with G90 an axis goes to the absolute angle within its modulo range by the way that its
  machine data say, and 365° is refused or taken as 5°. Test over the range that it can be told, or as an axis
  without modulo [inferred].
- 802D and 808D know neither DEF nor FOR: use `--unrolled`.)manual";

constexpr WordControl control = {
    .limits = {.numbered_axes = true, .loops = 10'000},
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

extern const Dialect siemens_840d_dialect;
const Dialect siemens_840d_dialect = {
    .id = "siemens-840d",
    .title = "Siemens SINUMERIK 840D",
    .extension = ".mpf",
    .manual = manual,
    .axes = "X Y Z U V W A B C, with or without a number (X1)",
    .has_loops = true,
    .write = [](std::span<const Plan> plans, const ProgramOptions& o) { return write_word_program(control, plans, o); },
    .write_tour = [](const PointTour& tour, const ProgramOptions& o) { return write_word_program(control, tour, o); },
};

}  // namespace axiometry::nc
