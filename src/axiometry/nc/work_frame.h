// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "axiometry/base/result.h"

/// In which coordinates a program means its positions: where the operator left the control, in a work offset that the
/// program activates, or in those of the machine.
namespace axiometry::nc {

/// Work offsets whose names differ by a number; none when `last` is less than `first`.
struct WorkOffsets {
  std::string_view word;  ///< word with {} for the number: "G54.1 P{}"
  unsigned first = 1;
  unsigned last = 0;
};

/// What a control has. Where it has no word of the machine's coordinates, its G53 may drive at rapid.
struct FrameWords {
  std::array<WorkOffsets, 4> offsets = {};
  std::string_view machine_start = {};  ///< block by which positions are those of the machine from then on, or ""
  std::string_view machine_move = {};   ///< word by which those of one block are, in every move, or ""
};

/// The choice in a control's words.
struct WorkFrame {
  std::string start;    ///< block after the safe start, or ""
  std::string of_move;  ///< word of every move to a position, or ""
  std::string remark;   ///< what a comment says of it
};

/// "active" (nothing is written), "machine", or a work offset by its words; blanks and small letters do not matter:
/// "g54.1p3". Fails on anything else, naming what the control has.
Result<WorkFrame> work_frame(std::string_view asked, const FrameWords& words);

}  // namespace axiometry::nc
