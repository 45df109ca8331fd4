// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace CLI {
class App;
}

namespace axiometry::cli {

/// What the process returns to its caller.
enum ExitCode : int {
  exit_done = 0,
  exit_usage = 1,      ///< the command line is wrong
  exit_bad_input = 2,  ///< an input cannot be read or an output cannot be written
  exit_exceeded = 3,   ///< a parameter does not conform, or an expectation of a case is not met, or a plan departs
  exit_undecided = 4,  ///< none is known not to conform, but the uncertainty leaves one undecided, or none was judged
  exit_interrupted = 130,  ///< stopped by Ctrl-C, as shells have it
};

/// Each adds one verb to the program; when that verb is given, its callback sets `exit_code`.
void add_evaluate(CLI::App& program, int& exit_code);
void add_capture(CLI::App& program, int& exit_code);
void add_uncertainty(CLI::App& program, int& exit_code);
void add_convert(CLI::App& program, int& exit_code);
void add_plan(CLI::App& program, int& exit_code);
void add_air(CLI::App& program, int& exit_code);
void add_periodic(CLI::App& program, int& exit_code);
void add_formats(CLI::App& program, int& exit_code);
void add_licenses(CLI::App& program, int& exit_code);
void add_schema(CLI::App& program, int& exit_code);
void add_check(CLI::App& program, int& exit_code);
void add_nc(CLI::App& program, int& exit_code);
void add_simulate(CLI::App& program, int& exit_code);
void add_serve(CLI::App& program, int& exit_code);
void add_store(CLI::App& program, int& exit_code);
void add_bench(CLI::App& program, int& exit_code);
void add_completion(CLI::App& program, int& exit_code);
void add_manual(CLI::App& program, int& exit_code);
void add_tracking(CLI::App& program, int& exit_code);

}  // namespace axiometry::cli
