// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace {

constexpr std::string_view manual = R"manual(# Fagor 8055, ISO language

For 8055 and 8055i, and relatives that read its ISO programs (8035, 8037, 8040).

- Program: `%002302,MX--,` or `--number N` (1 to 999998); `M30`
- Loops: `(RPT N9997,N9998) N4`: the blocks between the two labels once more, four times. The labels stand in
  blocks of their own with a harmless G90. No parameter is used
- Start: `G71` or `G70`, `G17 G40 G90 G94`, `G7` (square corner: the axis comes to rest at the end of every
  block)
- Dwell: `G4 K300`, in hundredths of a second: the dwell is rounded up to 0.01 s, 999.99 s at most
- Trigger: an M code between two halves of the dwell
- Comments: behind a semicolon
- Lines in space: X, Y and Z in one block. F is the speed along the path, G7 brings all of them to rest. The tool
  length is not cancelled: do that before (D0), or Z is that of the tool [inferred]
- Message: with `--stop-at-start`, `(MSG "…")` shows what to do, and `M0` waits

Try in single block first: the start blocks, the first target with its dwell, and the end of the first loop: it
must be driven as often as the comment before it says [inferred from the manual, not tried on a control].

The 8070 has another language for loops: use `--unrolled` there, and check the dwell (G4 in seconds) [inferred].
Rotary axes of the type "rollover" or "positioning only" go the short way or as the sign says: test them as
"normal" [inferred].)manual";

constexpr WordControl control = {
    .limits = {.dwell_step = Duration::s(0.01),
               .dwell_longest = Duration::s(999.99),
               .loops = 499,
               .m_codes = {{{0, 9999}}}},
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
    .block_number_highest = 8999,
};

}  // namespace

extern const Dialect fagor_dialect;
const Dialect fagor_dialect = {
    .id = "fagor",
    .title = "Fagor 8055 (ISO)",
    .extension = ".pim",
    .manual = manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = true,
    .write = [](std::span<const Plan> plans, const ProgramOptions& o) { return write_word_program(control, plans, o); },
    .write_tour = [](const PointTour& tour, const ProgramOptions& o) { return write_word_program(control, tour, o); },
};

}  // namespace axiometry::nc
