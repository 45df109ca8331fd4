// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace grbl {
namespace {

constexpr std::string_view manual = R"manual(# grbl 1.1 and grblHAL

- Program: the file's name names it; no `%`; `M2` ends it
- Loops: none: every run is written out. No line is longer than 79 characters
- Start: `G21` or `G20`, `G17 G40 G49 G80 G90 G94`, `G61`
- Axes: X, Y, Z; A, B and C with grblHAL. Rotary axes get the metric start always, so that no scaling by 25.4
  can reach their angles or feeds
- Dwell: `G4 P3.0`, seconds. It also empties the planner, which is what makes the axis stop; a dwell of 0 s is
  therefore written too
- Trigger: M7 (if it was compiled in) or M8: coolant outputs, which stay on until M9 ends them with the dwell. grbl
  has no pulse
- Stop: `M0`; cycle start goes on

- Lines in space: X, Y and Z in one block, F is the speed along the path. G49 cancels the tool length (G43.1)
- Work offset: the one that is active, or `--frame G54` to `G59`; with `--frame machine` G53 in every move, whatever
  G54 and G92 are
- Rotary axes count on through 0° and 360°; there is no rollover

Set the feed in the plan below the axis' `$110` to `$112` (or 113 and more): grbl lowers a feed above it without
a word. Soft limits (`$20`) should be on. Run all of it in check mode (`$C`) first, then try in single block,
which is sending line by line, up to the first dwell.)manual";

constexpr WordControl control = {
    .limits = {.linear_axes = "X Y Z",
               .dwell_stops = true,
               .frames = {.offsets = {{{"G{}", 54, 59}}}, .machine_move = "G53"},
               .rollover = RolloverWords::none},
    .comment_characters = ".,+-/=",
    .start_mm = {"G21", "G17 G40 G49 G80 G90 G94", "G61"},
    .start_inch = {"G20", "G17 G40 G49 G80 G90 G94", "G61"},
    .rotary_in_mm = true,
    .feed_point = false,
    .dwell = "G4 P{seconds}",
    .end = {"M2"},
    .block_number_highest = 9'999'999,
};

}  // namespace
}  // namespace grbl

extern const Dialect grbl_dialect;
const Dialect grbl_dialect = {
    .id = "grbl",
    .title = "grbl 1.1 and grblHAL",
    .extension = ".nc",
    .manual = grbl::manual,
    .axes = "X Y Z A B C",
    .has_loops = false,
    .write = [](std::span<const Plan> plans,
                const ProgramOptions& o) { return write_word_program(grbl::control, plans, o); },
    .write_tour = [](const PointTour& tour,
                     const ProgramOptions& o) { return write_word_program(grbl::control, tour, o); },
};

}  // namespace axiometry::nc
