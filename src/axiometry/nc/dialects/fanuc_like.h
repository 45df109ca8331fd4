// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "axiometry/nc/word_program.h"

namespace axiometry::nc {

/// What Fanuc's machining centres with custom macros have in common with those that follow them.
inline constexpr WordControl fanuc_like = {
    .limits = {.loops = 10'000,
               .m_codes = {{coolant, {24, 28}, {57, 57}, {150, 189}}},
               .frames = {.offsets = {{{"G{}", 54, 59}, {"G54.1 P{}", 1, 48}}}}},
    .number = WordControl::ProgramNumber{},
    .head = {"%", "O{number}"},
    .start_mm = {"G21", "G17 G40 G49 G80 G90 G94", "G61"},
    .start_inch = {"G20", "G17 G40 G49 G80 G90 G94", "G61"},
    .dwell = "G4 X{seconds}",
    .loop_begin = {"#1=1", "WHILE [#1 LE {times}] DO1"},
    .loop_end = {"#1=#1+1", "END1"},
    .end = {"G64", "M30"},
    .tail = {"%"},
};

}  // namespace axiometry::nc
