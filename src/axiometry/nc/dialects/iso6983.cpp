// SPDX-License-Identifier: Apache-2.0
#include "axiometry/nc/dialect.h"
#include "axiometry/nc/dialects/fanuc_like.h"
#include "axiometry/nc/word_program.h"

namespace axiometry::nc {
namespace iso6983 {
namespace {

constexpr std::string_view manual = R"manual(# ISO 6983, as most controls that resemble Fanuc's read it

For a control that is not in the list. No variables and no loops: every run is written out, so that nothing but
words of ISO 6983-1 is needed.

- Program: `%`, `O2302` or `--number N` (1 to 9999), `M30`, `%`
- Start: `G21` or `G20` in a block of its own (the common choice; the standard's own G71 and G70 are understood
  less often), `G17 G40 G80 G90 G94`
- Dwell: `G4 X3.0`, seconds. A control that wants another word stops with an alarm, rather than wait a thousand
  times too long as with P
- Exact stop: `G9` in every block: it needs no cancelling
- Trigger: M7 or M8 (coolant; M9 ends it with the dwell), M24 to M28, M57 or M150 to M189, between two halves of
  the dwell: numbers that neither RS-274-D nor the control gives to spindle, tool, axes or program. What the machine's
  builder made of one stands in the machine's list of M codes: look there first, also whether it ends by itself
- Work offset: the one that is active, or `--frame G54` to `G59`

- Lines in space: X, Y and Z in one block; F is the speed along the path [inferred for a control that is not known]
- `--rollover on`, for a rotary axis that counts to 360° only: all moves but the first are increments (`G91`),
  whose sign is the direction on controls that resemble Fanuc's [inferred]. The first, absolute, goes to an angle
  within one turn the way that the control chooses. Decimals that the control drops would add up: a comment says
  how many it must keep. Do not begin in the middle of such a program

Try in single block first: the start blocks, one target, the dwell with a watch. Tool length offsets, scaling,
rotation and mirroring must be off; coordinates refer to the work offset that is active.)manual";

constexpr WordControl control = {
    .limits = {.m_codes = fanuc_like.limits.m_codes, .frames = {.offsets = {{{"G{}", 54, 59}}}}},
    .comment_characters = ".,+-/=",
    .number = WordControl::ProgramNumber{},
    .head = {"%", "O{number}"},
    .start_mm = {"G21", "G17 G40 G80 G90 G94"},
    .start_inch = {"G20", "G17 G40 G80 G90 G94"},
    .move = "G9 G1 {axes} F{feed}",
    .dwell = "G4 X{seconds}",
    .end = {"M30"},
    .tail = {"%"},
};

}  // namespace
}  // namespace iso6983

extern const Dialect iso6983_dialect;
const Dialect iso6983_dialect = {
    .id = "iso6983",
    .title = "ISO 6983 (Fanuc-compatible, without macros)",
    .extension = ".nc",
    .manual = iso6983::manual,
    .axes = "X Y Z U V W A B C",
    .has_loops = false,
    .write = [](std::span<const Plan> plans,
                const ProgramOptions& o) { return write_word_program(iso6983::control, plans, o); },
    .write_tour = [](const PointTour& tour,
                     const ProgramOptions& o) { return write_word_program(iso6983::control, tour, o); },
};

}  // namespace axiometry::nc
