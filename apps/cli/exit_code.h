// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::cli {

/// What the process returns to its caller.
enum ExitCode : int {
  exit_done = 0,
  exit_usage = 1,       ///< the command line is wrong
  exit_bad_input = 2,   ///< an input cannot be read or an output cannot be written
  exit_exceeded = 3,    ///< a parameter does not conform, a finding is serious, a case or a plan departs
  exit_undecided = 4,   ///< none is known not to conform, but the uncertainty leaves one undecided, or none was judged
  exit_incomplete = 5,  ///< a capture ended before every reading of its plan had come; what came is kept
  exit_interrupted = 130,  ///< stopped by Ctrl-C, as shells have it
};

}  // namespace axiometry::cli
