// SPDX-License-Identifier: Apache-2.0
#include "cli/verbs/tracking/tracking.h"

#include "cli/flags/verb.h"

#include "cli/verbs/commands.h"

namespace axiometry::cli {

void add_tracking(const Verb& program, int& exit_code) {
  Verb verb = program.add_subcommand("tracking",
                                     "Tests with a tracking interferometer: its station, seven lines, multilateration");
  verb->require_subcommand(1, 1);
  add_tracking_locate(*verb, exit_code);
  add_tracking_evaluate(*verb, exit_code);
  add_tracking_length_difference(*verb, exit_code);
  add_tracking_plan(*verb, exit_code);
  add_tracking_simulate(*verb, exit_code);
  add_tracking_multilaterate(*verb, exit_code);
  add_tracking_polar(*verb, exit_code);
  add_tracking_compare_methods(*verb, exit_code);
  add_tracking_instruments(*verb, exit_code);
  verb->footer(R"(Examples:
  axiometry tracking plan --travel X=0:800,Y=0:600,Z=-500:0 --station 100,80,-600 --out lines.json
  axiometry tracking evaluate lengths.csv --plan lines.json --report lines.pdf
  axiometry tracking multilaterate ranges.csv --report points.pdf

'axiometry tracking VERB --help' explains each.)");
}

}  // namespace axiometry::cli
