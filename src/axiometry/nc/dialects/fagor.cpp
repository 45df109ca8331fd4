// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/dialects/fanuc_like.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace fagor {
namespace {

constexpr std::string_view manual = R"manual(# Fagor 8055, ISO language

For 8055 and 8055i, and relatives that read its ISO programs (8035, 8037, 8040).

- Program: `%002302,MX--,` or `--number N` (1 to 999998); `M30`
- Loops: `(RPT N9997,N9998) N4`: the blocks between the two labels once more, four times. The labels stand in
  blocks of their own with a harmless G90. No parameter is used
- Start: `G71` or `G70`, `G17 G40 G90 G94`, `G7` (square corner: the axis comes to rest at the end of every
  block)
- Dwell: `G4 K300`, in hundredths of a second: the dwell is rounded up to 0.01 s, 999.99 s at most
- Trigger: M7 or M8 (coolant; M9 ends it with the dwell), M24 to M28, M57 or M150 to M189, between two halves of
  the dwell: numbers that neither RS-274-D nor the control gives to spindle, tool, axes or program. What the machine's
  builder made of one stands in the machine's list of M codes: look there first, also whether it ends by itself
- Lines end with CR LF [inferred]
- Work offset: the one that is active, or `--frame G54` to `G59`; with `--frame machine` G53 in every move
- Comments: behind a semicolon
- Lines in space: X, Y and Z in one block. F is the speed along the path, G7 brings all of them to rest. The tool
  length is not cancelled: do that before (D0), or Z is that of the tool [inferred]
- Message: with `--stop-at-start`, `(MSG "…")` shows what to do, and `M0` waits

Try in single block first: the start blocks, the first target with its dwell, and the end of the first loop: it
must be driven as often as the comment before it says [inferred from the manual, not tried on a control].

The 8070 has another language for loops: use `--unrolled` there, and check the dwell (G4 in seconds) [inferred].

Rotary axes of the type "rollover" or "positioning only" go the short way or as the sign says [inferred]: absolute
angles are for "normal" ones.

- `--rollover on`, for a rotary axis that counts to 360° only: all moves but the first are increments (`G91`),
  whose sign is the direction [inferred]. The first, absolute, goes to an angle within one turn the way that the
  control chooses. Decimals that the control drops would add up: a comment says how many it must keep. Do not
  begin in the middle of such a program)manual";

constexpr WordControl control = {
    .limits = {.dwell_step = Duration::s(0.01),
               .dwell_longest = Duration::s(999.99),
               .loops = 499,
               .m_codes = fanuc_like.limits.m_codes,
               .frames = {.offsets = {{{"G{}", 54, 59}}}, .machine_move = "G53"}},
    .comment_begin = "; ",
    .comment_end = "",
    .comment_characters = ".,+-/=",
    .number = WordControl::ProgramNumber{.lowest = 1, .highest = 999'998, .otherwise = 2302},
    .head = {"%{number:0>6},MX--,"},
    .start_mm = {"G71", "G17 G40 G90 G94", "G7"},
    .start_inch = {"G70", "G17 G40 G90 G94", "G7"},
    .feed_point = false,
    .dwell = "G4 K{steps}",
    .stop = {"(MSG \"{message}\")", "M0"},
    .loop_begin = {"N{label} G90"},
    .loop_end = {"N{end_label} G90", "(RPT N{label},N{end_label}) N{more}"},
    .label_highest = 9999,
    .end = {"M30"},
    .crlf = true,
    .block_number_highest = 8999,
};

}  // namespace
}  // namespace fagor

extern const Dialect fagor_dialect;
const Dialect fagor_dialect = {
    .id = "fagor",
    .title = "Fagor 8055 (ISO)",
    .extension = ".pim",
    .manual = fagor::manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans,
                const ProgramOptions& o) { return write_word_program(fagor::control, plans, o); },
    .write_tour = [](const PointTour& tour,
                     const ProgramOptions& o) { return write_word_program(fagor::control, tour, o); },
};

}  // namespace axiometry::nc
