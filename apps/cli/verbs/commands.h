// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace axiometry::cli {

class Verb;

/// What the process returns to its caller.
enum ExitCode : int {
  exit_done = 0,
  exit_usage = 1,       ///< the command line is wrong
  exit_bad_input = 2,   ///< an input cannot be read or an output cannot be written
  exit_exceeded = 3,    ///< a parameter does not conform, a finding is serious (serious.h), a case or a plan departs
  exit_undecided = 4,   ///< none is known not to conform, but the uncertainty leaves one undecided, or none was judged
  exit_incomplete = 5,  ///< a capture ended before every reading of its plan had come; what came is kept
  exit_interrupted = 130,  ///< stopped by Ctrl-C, as shells have it
};

/// Each adds one verb to the program; when that verb is given, its callback sets `exit_code`.
void add_evaluate(const Verb& program, int& exit_code);
void add_capture(const Verb& program, int& exit_code);
void add_uncertainty(const Verb& program, int& exit_code);
void add_convert(const Verb& program, int& exit_code);
void add_plan(const Verb& program, int& exit_code);
void add_air(const Verb& program, int& exit_code);
void add_periodic(const Verb& program, int& exit_code);
void add_straightness(const Verb& program, int& exit_code);
void add_squareness(const Verb& program, int& exit_code);
void add_angles(const Verb& program, int& exit_code);
void add_compare_rules(const Verb& program, int& exit_code);
void add_formats(const Verb& program, int& exit_code);
void add_licenses(const Verb& program, int& exit_code);
void add_schema(const Verb& program, int& exit_code);
void add_check(const Verb& program, int& exit_code);
void add_nc(const Verb& program, int& exit_code);
void add_simulate(const Verb& program, int& exit_code);
void add_serve(const Verb& program, int& exit_code);
void add_store(const Verb& program, int& exit_code);
void add_bench(const Verb& program, int& exit_code);
void add_completion(const Verb& program, int& exit_code);
void add_manual(const Verb& program, int& exit_code);
void add_tracking(const Verb& program, int& exit_code);
void add_volumetric(const Verb& program, int& exit_code);
void add_compensate(const Verb& program, int& exit_code);

}  // namespace axiometry::cli
